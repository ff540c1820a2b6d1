#include "pattern/seam_orientation.h"

#include <cmath>

#include "geometry/polygon.h"
#include "pattern/constants.h"

namespace toile {

namespace {

/// A panel as orientation needs it.
struct PanelFace {
  double area = 0;              ///< m², as drawn; positive when counter-clockwise
  Vec3 centre = Vec3::Zero();   ///< metres, of its outline as placed
  Vec3 normal = Vec3::UnitZ();  ///< of the drawing's front as placed
  std::vector<bool> forward;    ///< per edge: whether the outline runs along it
};

PanelFace face_of(const PatternPanel& panel) {
  PanelFace face;
  face.forward.resize(panel.edges.size());
  std::vector<Vec2> outline;
  for (const OutlineStep& step : panel.outline) {
    const EdgeCurve& curve = panel.edges[step.edge].curve;
    face.forward[step.edge] = step.forward;
    constexpr int segments = 8;
    for (int i = 0; i < segments; ++i) {
      const double fraction = static_cast<double>(i) / segments;
      outline.push_back(curve.at(step.forward ? fraction : 1 - fraction));
      face.centre += panel.place(outline.back());
    }
  }
  face.centre /= static_cast<double>(outline.size());
  face.area = signed_area(outline);
  face.normal = panel.rotation.col(2);
  return face;
}

bool runs_reversed(const Pattern& pattern, const Stitch& stitch) {
  if (stitch.direction != StitchDirection::by_position) {
    return stitch.direction == StitchDirection::end_to_start;
  }
  const PatternPanel& a = pattern.panels[stitch.a.panel];
  const PatternPanel& b = pattern.panels[stitch.b.panel];
  const EdgeCurve& edge_a = a.edges[stitch.a.edge].curve;
  const EdgeCurve& edge_b = b.edges[stitch.b.edge].curve;
  const Vec3 a_start = a.place(edge_a.start());
  const Vec3 a_end = a.place(edge_a.end());
  const Vec3 b_start = b.place(edge_b.start());
  const Vec3 b_end = b.place(edge_b.end());
  const double same = (a_start - b_start).norm() + (a_end - b_end).norm();
  const double opposite = (a_start - b_end).norm() + (a_end - b_start).norm();
  return opposite <= same + undecided_seam_direction * (same + opposite);
}

}  // namespace

Orientation orient(const Pattern& pattern, std::vector<Remark>& remarks) {
  Orientation result;
  std::vector<PanelFace> faces;
  for (const PatternPanel& panel : pattern.panels) faces.push_back(face_of(panel));
  for (const Stitch& stitch : pattern.stitches) {
    result.reversed.push_back(runs_reversed(pattern, stitch));
  }

  // A seam joins right to right when its edges run against each other around their panels, both
  // seen from the right side. So each seam tells whether its panels show the same face.
  struct SeamNeighbour {
    int panel = 0;
    bool same = false;
    std::size_t stitch = 0;
  };
  std::vector<std::vector<SeamNeighbour>> neighbours(pattern.panels.size());
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    const Stitch& stitch = pattern.stitches[s];
    const auto counter_clockwise = [&](const EdgeRef& ref) {
      const PanelFace& face = faces[ref.panel];
      return face.forward[ref.edge] == (face.area > 0);
    };
    const bool along = counter_clockwise(stitch.a) == counter_clockwise(stitch.b);
    const bool same = along == result.reversed[s];
    neighbours[stitch.a.panel].push_back({stitch.b.panel, same, s});
    neighbours[stitch.b.panel].push_back({stitch.a.panel, same, s});
  }

  result.mirrored.assign(pattern.panels.size(), false);
  std::vector<bool> seen(pattern.panels.size(), false);
  for (std::size_t first = 0; first < pattern.panels.size(); ++first) {
    if (seen[first]) continue;
    std::vector<int> group = {static_cast<int>(first)};
    seen[first] = true;
    bool twisted = false;
    for (std::size_t i = 0; i < group.size(); ++i) {
      for (const SeamNeighbour& neighbour : neighbours[group[i]]) {
        const bool mirrored = result.mirrored[group[i]] == neighbour.same;
        if (!seen[neighbour.panel]) {
          seen[neighbour.panel] = true;
          result.mirrored[neighbour.panel] = mirrored;
          group.push_back(neighbour.panel);
        } else if (result.mirrored[neighbour.panel] != mirrored && !twisted) {
          twisted = true;
          const Stitch& stitch = pattern.stitches[neighbour.stitch];
          remarks.push_back({true, pattern.source + ": " + edge_name(pattern, stitch.a) + " and " +
                                       edge_name(pattern, stitch.b) +
                                       " join a right side to a wrong side; state the stitch's "
                                       "'reversed', or check where the panels are placed"});
        }
      }
    }
    double outward = 0;
    double drawn = 0;
    double scale = 0;
    Vec3 centre = Vec3::Zero();
    double area = 0;
    for (const int p : group) {
      centre += std::abs(faces[p].area) * faces[p].centre;
      area += std::abs(faces[p].area);
    }
    centre /= area;
    for (const int p : group) {
      const PanelFace& face = faces[p];
      const double sign = result.mirrored[p] ? -1 : 1;
      outward += sign * std::abs(face.area) * face.normal.dot(face.centre - centre);
      scale += std::abs(face.area) * (face.centre - centre).norm();
      drawn += sign * face.area;
    }
    const bool flip = std::abs(outward) > undecided_right_side * scale ? outward < 0 : drawn < 0;
    for (const int p : group) {
      if (twisted) {
        result.mirrored[p] = faces[p].area < 0;
      } else if (flip) {
        result.mirrored[p] = !result.mirrored[p];
      }
    }
  }
  return result;
}

}  // namespace toile
