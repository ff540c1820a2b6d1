// A standing figure's bones, and a garment of two half tubes around its torso.
#pragma once

#include <cmath>
#include <numbers>

#include "geometry/body/skeleton.h"
#include "tests/cloth/panels.h"

namespace toile::test {

inline constexpr double pi = std::numbers::pi;

/// A standing figure, arms held out level.
inline Skeleton figure() {
  Skeleton s;
  s.joints = {{"pelvis", {0, 0.8, 0}},
              {"waist", {0, 1.0, 0}},
              {"chest", {0, 1.2, 0}},
              {"neck", {0, 1.4, 0}},
              {"head", {0, 1.7, 0}},
              {"left_shoulder", {0.15, 1.3, 0}},
              {"left_elbow", {0.45, 1.3, 0}},
              {"left_wrist", {0.70, 1.3, 0}},
              {"right_shoulder", {-0.15, 1.3, 0}},
              {"right_elbow", {-0.45, 1.3, 0}},
              {"right_wrist", {-0.70, 1.3, 0}},
              {"left_hip", {0.1, 0.85, 0}},
              {"left_knee", {0.1, 0.45, 0}},
              {"left_ankle", {0.1, 0.05, 0}},
              {"right_hip", {-0.1, 0.85, 0}},
              {"right_knee", {-0.1, 0.45, 0}},
              {"right_ankle", {-0.1, 0.05, 0}}};
  s.segments = {{"torso", "pelvis", "waist"},
                {"torso", "waist", "chest"},
                {"torso", "chest", "neck"},
                {"head", "neck", "head"}};
  for (const std::string side : {"left_", "right_"}) {
    s.segments.push_back({side + "arm", side + "shoulder", side + "elbow"});
    s.segments.push_back({side + "arm", side + "elbow", side + "wrist"});
    s.segments.push_back({side + "leg", side + "hip", side + "knee"});
    s.segments.push_back({side + "leg", side + "knee", side + "ankle"});
  }
  return s;
}

inline constexpr double tube_radius = 0.2;
inline constexpr int tube_columns = 30, tube_rows = 20;

/// Half of a tube around the y axis, from y = 0.8 to 1.4.
inline MeshedPanel& add_half(PanelMesh& garment, const std::string& name, double start) {
  MeshedPanel& panel = add_panel(
      garment, name, grid(pi * tube_radius, 0.6, tube_columns, tube_rows), [&](const Vec2& p) {
        const double angle = start + p.x() / tube_radius;
        return Vec3(tube_radius * std::sin(angle), 0.8 + p.y(), tube_radius * std::cos(angle));
      });
  panel.part = "torso";
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
