#include "geometry/body/torso_section.h"

#include <utility>
#include <vector>

namespace toile {

std::optional<Section> torso_section(const TriangleMesh& body, double height) {
  std::vector<Section> sections = slice(body, {0, height, 0}, Vec3::UnitY());
  if (sections.empty() || !sections.front().closed) return std::nullopt;
  return std::move(sections.front());
}

std::optional<Section> head_section(const TriangleMesh& body, double neck, double crown) {
  std::optional<Section> widest;
  for (double y = neck + 0.55 * (crown - neck); y < crown; y += 0.003 * crown) {
    std::vector<Section> sections = slice(body, {0, y, 0}, Vec3::UnitY());
    if (sections.empty() || (widest && sections.front().girth <= widest->girth)) continue;
    widest = std::move(sections.front());
  }
  return widest;
}

}  // namespace toile
