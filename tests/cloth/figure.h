// A garment of two half tubes around the torso of a standing figure.
#pragma once

#include <cmath>
#include <numbers>

#include "tests/cloth/panels.h"
#include "tests/support/standing_figure.h"

namespace toile::test {

inline constexpr double pi = std::numbers::pi;

inline constexpr double tube_radius = 0.2;
inline constexpr int tube_columns = 30, tube_rows = 20;

/// Half of a tube around the y axis, from y = 0.8 to 1.4.
inline MeshedPanel& add_half(PanelMesh& garment, const std::string& name, double start) {
  MeshedPanel& panel = add_panel(
      garment, name, grid(pi * tube_radius, 0.6, tube_columns, tube_rows), [&](const Vec2& p) {
        const double angle = start + p.x() / tube_radius;
        return Vec3(tube_radius * std::sin(angle), 0.8 + p.y(), tube_radius * std::cos(angle));
      });
  panel.is = classify({name, BodyPart::torso});
  return panel;
}

inline PanelMesh tube() {
  PanelMesh garment;
  add_half(garment, "front", -pi / 2);
  add_half(garment, "back", pi / 2);
  const auto side_of = [&](int panel, bool right) {
    return side(garment.panels[panel], tube_columns, tube_rows, right);
  };
  garment.seams = {seam("left", side_of(0, true), side_of(1, false)),
                   seam("right", side_of(1, true), side_of(0, false))};
  return garment;
}

}  // namespace toile::test
