#include "cloth/ease/girth_ease.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/body/torso_section.h"
#include "geometry/body/trunk_levels.h"
#include "geometry/slice.h"

namespace toile {

GirthEases measure_girth_ease(const DressedGarment& garment, const TriangleMesh& body,
                              const Skeleton& skeleton, const std::vector<double>& grains,
                              double step) {
  GirthEases result;
  std::vector<NamedLevel> levels = girth_levels(body, skeleton);
  for (const char* name : {"bust", "waist", "hip"}) {
    if (std::ranges::find(levels, name, &NamedLevel::name) == levels.end()) {
      result.left_out.push_back({name, "the body has none"});
    }
  }
  const double crotch = skeleton.joint("pelvis").y();
  const double armpit = skeleton.joint("chest").y();
  for (double y = std::ceil(crotch / step) * step; step > 0 && y < armpit; y += step) {
    levels.push_back({"", y});
  }
  std::ranges::stable_sort(levels, std::ranges::greater{}, &NamedLevel::height);

  const TriangleMesh cloth{garment.points, garment.triangles};
  for (const NamedLevel& level : levels) {
    const auto leave_out = [&](const char* why, bool is_open = false) {
      if (!level.name.empty()) result.left_out.push_back({level.name, why, is_open, level.height});
    };
    const std::optional<Section> torso = torso_section(body, level.height);
    if (!torso) {
      leave_out("the body's surface is open there");
      continue;
    }
    const std::vector<Section> sections = slice(cloth, {0, level.height, 0}, Vec3::UnitY());
    // Where layers lie over each other, the outermost counts. It has the largest area and comes
    // first.
    const auto around = std::ranges::find_if(sections, [&](const Section& section) {
      return contains(section, torso->centroid, Vec3::UnitY());
    });
    if (around == sections.end()) {
      leave_out(sections.empty() ? "the garment does not reach it"
                                 : "the garment is not closed around the body there",
                !sections.empty());
      continue;
    }
    GirthEase girth;
    girth.level = level.name;
    girth.height = level.height;
    girth.body = torso->girth;
    girth.garment = around->length;
    girth.ease = girth.garment - girth.body;
    girth.panels =
        panel_widths(garment, around->triangles, {{0, level.height, 0}, Vec3::UnitY()}, grains);
    for (const PanelWidth& panel : girth.panels) girth.as_cut += panel.width;
    girth.triangles = around->triangles;
    result.levels.push_back(std::move(girth));
  }
  return result;
}

}  // namespace toile
