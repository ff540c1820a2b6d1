#include "cloth/judge/drafted_girths.h"

#include <cstddef>
#include <optional>

#include "geometry/body/torso_section.h"

namespace toile {

void set_drafted_girths(const PanelMesh& pattern, const DressedGarment& dressed,
                        const TriangleMesh& body, const Skeleton& skeleton,
                        std::vector<GirthEase>& girths, std::vector<GarmentLevel>& levels) {
  // Per node, metres above the floor: the mean of the panels' sides where they are sewn.
  std::vector<double> drafted(dressed.points.size(), 0);
  std::vector<int> corners(dressed.points.size(), 0);
  for (std::size_t t = 0; t < dressed.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const int node = dressed.triangles[t][i];
      const double height = pattern.placed[pattern.triangles[t][i]].y();
      drafted[node] += (height - drafted[node]) / ++corners[node];
    }
  }
  const auto girth_at = [&](const std::vector<int>& nodes) -> std::optional<double> {
    double height = 0;
    for (const int node : nodes) height += drafted[node] / static_cast<double>(nodes.size());
    if (height <= skeleton.joint("pelvis").y() || height >= skeleton.joint("chest").y()) return {};
    const std::optional<Section> torso = torso_section(body, height);
    return torso ? std::optional<double>(torso->girth) : std::nullopt;
  };
  for (GirthEase& girth : girths) {
    std::vector<int> nodes;
    nodes.reserve(3 * girth.triangles.size());
    for (const int t : girth.triangles) {
      nodes.insert(nodes.end(), dressed.triangles[t].begin(), dressed.triangles[t].end());
    }
    girth.drafted_body = girth_at(nodes);
  }
  for (GarmentLevel& level : levels) level.drafted_body = girth_at(level.nodes);
}

}  // namespace toile
