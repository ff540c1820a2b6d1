#include "cloth/start/widening.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cloth/start/constants.h"
#include "cloth/start/panel_parts.h"
#include "geometry/body/bones.h"

namespace toile {

namespace {

/// A panel, along and across the bones of its part.
struct PanelFrame {
  BodyPart part = BodyPart::none;
  Vec3 along = Vec3::Zero();
  Vec3 across = Vec3::Zero();  ///< zero: the panel goes around nothing
  Vec3 middle = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
  double half_width = 0;

  double side(const Vec3& p) const { return across.dot(p - middle); }
};

Vec3 normal_of(const PanelMesh& garment, const MeshedPanel& panel,
               const std::vector<Vec3>& placed) {
  Vec3 sum = Vec3::Zero();
  for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
    const auto& [a, b, c] = garment.triangles[t];
    sum += (placed[b] - placed[a]).cross(placed[c] - placed[a]);
  }
  return sum;
}

PanelFrame frame_of(const PanelMesh& garment, const MeshedPanel& panel, BodyPart part,
                    const std::vector<Vec3>& placed, const Skeleton& skeleton) {
  PanelFrame frame;
  frame.part = part;
  const Bones bones(skeleton, part);
  if (bones.joints.empty() || panel.placement.around > 0) return frame;
  double low = bones.foot(placed[panel.first_point]);
  double high = low;
  for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
    low = std::min(low, bones.foot(placed[p]));
    high = std::max(high, bones.foot(placed[p]));
  }
  if (high <= low) return frame;
  frame.along = bones.average(low, high).second;
  frame.normal = normal_of(garment, panel, placed).normalized();
  const Vec3 across = frame.normal.cross(frame.along);
  if (across.norm() < 0.1) return frame;
  frame.across = across.normalized();
  const Vec3& first = placed[panel.first_point];
  double left = 0;
  double right = 0;
  for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
    left = std::min(left, frame.across.dot(placed[p] - first));
    right = std::max(right, frame.across.dot(placed[p] - first));
  }
  frame.middle = first + 0.5 * (left + right) * frame.across;
  frame.half_width = 0.5 * (right - left);
  return frame;
}

}  // namespace

bool widen(const PanelMesh& garment, const std::vector<Vec3>& placed, const Skeleton& skeleton,
           const std::vector<char>& held, double factor, std::vector<WidePanel>& panels) {
  const std::vector<BodyPart> parts = panel_parts(garment, skeleton);
  const std::vector<int> panel_of = panel_of_points(garment);
  std::vector<PanelFrame> frames;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    frames.push_back(frame_of(garment, garment.panels[p], parts[p], placed, skeleton));
  }
  std::vector<bool> is_held(frames.size(), false);
  panels.resize(frames.size());
  for (const MeshedSeam& seam : garment.seams) {
    const int a = panel_of[seam.a.front()];
    const int b = panel_of[seam.b.front()];
    // Before and behind the same bones.
    if (std::abs(frames[a].along.dot(frames[b].along)) < same_way) continue;
    if (frames[a].normal.dot(frames[b].normal) > same_facing) continue;
    const auto is_held_at = [&](int point) { return held[point] != 0; };
    if (std::ranges::none_of(seam.a, is_held_at) && std::ranges::none_of(seam.b, is_held_at)) {
      continue;
    }
    for (const auto& [p, points] : {std::pair(a, &seam.a), std::pair(b, &seam.b)}) {
      const PanelFrame& frame = frames[p];
      const Vec3& from = placed[points->front()];
      const Vec3& to = placed[points->back()];
      if (frame.half_width == 0) continue;
      if (std::abs((to - from).dot(frame.along)) < seam_along_cosine * (to - from).norm()) continue;
      is_held[p] = true;
      double side = frame.side(0.5 * (from + to));
      // Inward, the panels of one leg would come into those of the other.
      if (is_limb(frame.part) && !is_arm(frame.part)) side = side_of(frame.part) * frame.across.x();
      panels[p].held[side < 0 ? 0 : 1] = true;
    }
  }
  bool any = false;
  for (std::size_t p = 0; p < frames.size(); ++p) {
    if (!is_held[p]) continue;
    any = true;
    WidePanel& panel = panels[p];
    panel.factor *= factor;
    panel.across = frames[p].across;
    // What is held on one side only stays on the other.
    const double shift = panel.held[0] == panel.held[1] ? 0 : panel.held[0] ? 1 : -1;
    panel.middle = frames[p].middle + shift * frames[p].half_width * panel.across;
  }
  return any;
}

}  // namespace toile
