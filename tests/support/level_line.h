// Lines across a dressed panel, as a tape is laid along it.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "pattern/panel_mesh.h"

namespace toile::test {

/// The line in which a dressed panel meets y = `height` of its drawing. Metres.
struct LevelLine {
  double flat = 0;           ///< length in the drawing
  double now = 0;            ///< length as dressed
  std::vector<Vec3> points;  ///< in space, in the order of the drawing from left to right
};

inline LevelLine level_line(const DressedGarment& garment, const std::string& panel,
                            double height) {
  struct Crossing {
    double x;
    Vec3 at;
  };
  LevelLine line;
  std::vector<Crossing> middles;
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    if (garment.panels[garment.panel_of_triangle[t]] != panel) continue;
    std::vector<Crossing> cuts;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const Vec2& a = garment.flat[garment.flat_triangles[t][i]];
      const Vec2& b = garment.flat[garment.flat_triangles[t][j]];
      if ((a.y() < height) == (b.y() < height)) continue;
      const double s = (height - a.y()) / (b.y() - a.y());
      cuts.push_back(
          {(1 - s) * a.x() + s * b.x(), (1 - s) * garment.points[garment.triangles[t][i]] +
                                            s * garment.points[garment.triangles[t][j]]});
    }
    if (cuts.size() != 2) continue;
    line.flat += std::abs(cuts[0].x - cuts[1].x);
    line.now += (cuts[0].at - cuts[1].at).norm();
    middles.push_back({0.5 * (cuts[0].x + cuts[1].x), 0.5 * (cuts[0].at + cuts[1].at)});
  }
  std::sort(middles.begin(), middles.end(),
            [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
  for (const Crossing& cut : middles) line.points.push_back(cut.at);
  return line;
}

/// How often the line goes out from the y axis and in again by more than `depth` metres.
inline int folds(const LevelLine& line, double depth) {
  int found = 0;
  bool out = true;
  double extreme = 0;
  for (const Vec3& p : line.points) {
    const double r = std::hypot(p.x(), p.z());
    extreme = out ? std::max(extreme, r) : std::min(extreme, r);
    if (out ? r < extreme - depth : r > extreme + depth) {
      found += out;
      out = !out;
      extreme = r;
    }
  }
  return found;
}

}  // namespace toile::test
