#include "geometry/body/torso_section.h"

#include <utility>

namespace toile {

std::optional<Section> torso_section(const TriangleMesh& body, double height) {
  std::vector<Section> sections = slice(body, {0, height, 0}, Vec3::UnitY());
  if (sections.empty() || !sections.front().closed) return std::nullopt;
  return std::move(sections.front());
}

}  // namespace toile
