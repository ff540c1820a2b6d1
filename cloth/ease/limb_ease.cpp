#include "cloth/ease/limb_ease.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/body/centreline.h"

namespace toile {

namespace {

/// Metres between planes. A cuff is 3 cm wide at least; half of this costs twice the slices.
constexpr double plane_step = 0.01;

struct LimbBone {
  const char* name;
  const char* from;
  const char* to;
  double first;  ///< share of the bone at which it is clear of armpit or crotch
};

constexpr LimbBone limb_bones[] = {{"upper arm", "shoulder", "elbow", 0.4},
                                   {"forearm", "elbow", "wrist", 0},
                                   {"thigh", "hip", "knee", 0.3},
                                   {"lower leg", "knee", "ankle", 0}};

/// The ease in one plane. None: the garment is not closed around the limb there.
std::optional<LimbEase> ease_in(const CuttingPlane& plane, const DressedGarment& garment,
                                const TriangleMesh& cloth, const TriangleMesh& body,
                                const std::vector<double>& grains) {
  const std::vector<Section> sections = slice(cloth, plane.origin, plane.normal);
  const auto around = std::ranges::find_if(sections, [&](const Section& section) {
    return contains(section, plane.origin, plane.normal);
  });
  if (around == sections.end()) return std::nullopt;
  const auto limb =
      section_at(slice(body, plane.origin, plane.normal), plane.origin, plane.normal, 0, 0);
  // Where a limb touches the trunk, its section goes around both, and the cloth's does not.
  if (!limb || limb->area > std::abs(around->area)) return std::nullopt;
  LimbEase ease;
  ease.at = plane.origin;
  ease.body = limb->girth;
  ease.garment = around->length;
  for (const PanelWidth& panel : panel_widths(garment, around->triangles, plane, grains)) {
    ease.as_cut += panel.width;
  }
  return ease;
}

}  // namespace

std::vector<LimbEase> measure_limb_ease(const DressedGarment& garment, const TriangleMesh& body,
                                        const Skeleton& skeleton,
                                        const std::vector<double>& grains) {
  std::vector<LimbEase> limbs;
  const TriangleMesh cloth{garment.points, garment.triangles};
  for (const std::string side : {"left", "right"}) {
    for (const LimbBone& bone : limb_bones) {
      const auto from = skeleton.joints.find(side + "_" + bone.from);
      const auto to = skeleton.joints.find(side + "_" + bone.to);
      if (from == skeleton.joints.end() || to == skeleton.joints.end()) continue;
      const Vec3 way = to->second - from->second;
      const double step = plane_step / way.norm();
      std::optional<LimbEase> least;
      for (double share = bone.first; share <= 1; share += step) {
        std::optional<LimbEase> ease =
            ease_in({from->second + share * way, way.normalized()}, garment, cloth, body, grains);
        if (!ease || (least && least->as_cut - least->body <= ease->as_cut - ease->body)) continue;
        ease->limb = side + " " + bone.name;
        ease->share = share;
        least = std::move(ease);
      }
      if (least) limbs.push_back(std::move(*least));
    }
  }
  return limbs;
}

}  // namespace toile
