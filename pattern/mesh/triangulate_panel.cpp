#include "pattern/mesh/triangulate_panel.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "geometry/angles.h"
#include "geometry/error.h"
#include "geometry/polygon.h"
#include "geometry/triangulate.h"
#include "pattern/constants.h"
#include "pattern/mesh/outline_polygon.h"

namespace toile {

namespace {

/// Radians that the edge of a hole turns within one step of the coarsest level: a circle gets six.
constexpr double max_turn_per_cut_step = to_radians(60);

class PanelMesher {
 public:
  PanelMesher(const PatternPanel& panel, const PanelMeshing& how) : panel_(panel), how_(how) {}

  PanelTriangulation mesh() {
    const std::vector<Vec2> outline = coarse_outline();
    if (outline.size() < 3) throw Unmeshable{quoted(panel_), "has too few border points"};
    if (first_crossing(outline)) {
      throw Unmeshable{quoted(panel_), "has an outline that crosses itself"};
    }
    triangulation_.coarse_outline = static_cast<int>(outline.size());
    try {
      triangulation_.mesh = mesh_polygon(outline, how_.coarse_length, how_.split_corners,
                                         coarse_cut_outs(triangulation_.coarse_outline));
    } catch (const Error&) {
      throw Unmeshable{quoted(panel_), "can't be triangulated"};
    }
    for (int level = 0; level < how_.subdivisions; ++level) subdivide();
    if (smallest_angle(triangulation_.mesh.points, triangulation_.mesh.triangles) < needle_angle) {
      const SharpPlace place = sharpest_place();
      const std::string edge = place.edge < 0 ? "" : ", edge " + std::to_string(place.edge);
      throw Unmeshable{quoted(panel_) + edge, "gets triangles like needles", place.long_steps};
    }
    DrawnMarks drawn;
    for (const std::vector<Vec2>& line : panel_.internal_lines) drawn.lines.push_back(flat(line));
    drawn.holes = flat(panel_.drill_holes);
    drawn.outline = flat(outline_polygon(panel_).points);
    triangulation_.marks =
        put_marks_on_mesh(triangulation_.mesh, is_border(), drawn,
                          how_.coarse_length / static_cast<double>(1 << how_.subdivisions));
    return std::move(triangulation_);
  }

 private:
  /// The edges of the panel at the sharpest triangle.
  struct SharpPlace {
    int edge = -1;                ///< that most of its corners lie on; -1: it is at none
    std::vector<int> long_steps;  ///< edges that it touches, of steps no shorter than half of it
  };

  SharpPlace sharpest_place() const {
    const PlanarMesh& mesh = triangulation_.mesh;
    const auto angle = [&](const Triangle& t) {
      return smallest_angle(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
    };
    const Triangle sharpest = *std::min_element(
        mesh.triangles.begin(), mesh.triangles.end(),
        [&](const Triangle& s, const Triangle& t) { return angle(s) < angle(t); });
    const auto length = [&](int a, int b) { return (mesh.points[a] - mesh.points[b]).norm(); };
    const double longest =
        std::max({length(sharpest[0], sharpest[1]), length(sharpest[1], sharpest[2]),
                  length(sharpest[2], sharpest[0])});
    SharpPlace place;
    std::size_t most = 0;
    for (std::size_t e = 0; e < triangulation_.along.size(); ++e) {
      const std::vector<int>& along = triangulation_.along[e];
      std::vector<int> corners;
      for (const int p : along) {
        if (std::ranges::find(sharpest, p) != sharpest.end()) corners.push_back(p);
      }
      if (corners.size() > most) {
        most = corners.size();
        place.edge = static_cast<int>(e);
      }
      if (corners.empty()) continue;
      double whole = 0;
      for (std::size_t i = 0; i + 1 < along.size(); ++i) whole += length(along[i], along[i + 1]);
      const double step = whole / static_cast<double>(along.size() - 1);
      if (step >= 0.5 * longest) place.long_steps.push_back(static_cast<int>(e));
    }
    return place;
  }

  Vec2 flat(const Vec2& drawn) const { return {how_.mirrored ? -drawn.x() : drawn.x(), drawn.y()}; }

  std::vector<Vec2> flat(const std::vector<Vec2>& drawn) const {
    std::vector<Vec2> points;
    points.reserve(drawn.size());
    for (const Vec2& point : drawn) points.push_back(flat(point));
    return points;
  }

  /// Per point, whether it lies on the outline or at a cut-out.
  std::vector<bool> is_border() const {
    std::vector<bool> border(triangulation_.mesh.points.size(), false);
    for (const auto* runs : {&triangulation_.along, &triangulation_.cut_along}) {
      for (const std::vector<int>& along : *runs) {
        for (const int point : along) border[point] = true;
      }
    }
    return border;
  }

  /// The outline's walk, turned so that it runs counter-clockwise in flat coordinates.
  std::vector<OutlineStep> walk() const {
    std::vector<Vec2> points;
    for (const OutlineStep& step : panel_.outline) {
      std::vector<Vec2> sample = panel_.edges[step.edge].curve.sample(8 * how_.steps[step.edge]);
      if (!step.forward) std::reverse(sample.begin(), sample.end());
      for (const Vec2& point : sample) points.push_back(flat(point));
    }
    std::vector<OutlineStep> steps = panel_.outline;
    if (signed_area(points) < 0) {
      std::reverse(steps.begin(), steps.end());
      for (OutlineStep& step : steps) step.forward = !step.forward;
    }
    return steps;
  }

  std::vector<Vec2> coarse_outline() {
    std::vector<Vec2> outline;
    triangulation_.along.assign(panel_.edges.size(), {});
    const std::vector<OutlineStep> steps = walk();
    for (const OutlineStep& step : steps) {
      const int count = how_.steps[step.edge];
      std::vector<Vec2> sample = panel_.edges[step.edge].curve.sample(count);
      if (!step.forward) std::reverse(sample.begin(), sample.end());
      for (int i = 0; i < count; ++i) {
        triangulation_.along[step.edge].push_back(static_cast<int>(outline.size()));
        outline.push_back(flat(sample[i]));
      }
    }
    for (std::size_t s = 0; s < steps.size(); ++s) {
      std::vector<int>& along = triangulation_.along[steps[s].edge];
      along.push_back(triangulation_.along[steps[(s + 1) % steps.size()].edge].front());
    }
    for (const OutlineStep& step : steps) {
      std::vector<int>& along = triangulation_.along[step.edge];
      if (!step.forward) std::reverse(along.begin(), along.end());
    }
    return outline;
  }

  /// The cut-outs as polygons. Their points are counted from `first`, and their runs begun.
  std::vector<std::vector<Vec2>> coarse_cut_outs(int first) {
    std::vector<std::vector<Vec2>> loops;
    for (const CutOut& cut_out : how_.cut_outs) {
      std::vector<int> steps;
      for (const EdgeCurve& curve : cut_out.curves) {
        const double by_length = curve.length() / how_.coarse_length - outline_step_tolerance;
        const double by_turning = curve.turning() / max_turn_per_cut_step;
        steps.push_back(std::max(1, static_cast<int>(std::ceil(std::max(by_length, by_turning)))));
      }
      while (std::accumulate(steps.begin(), steps.end(), 0) < 3) ++steps.front();
      std::vector<Vec2>& loop = loops.emplace_back();
      const int start = first;
      for (std::size_t c = 0; c < cut_out.curves.size(); ++c) {
        std::vector<int>& run = triangulation_.cut_along.emplace_back();
        const std::vector<Vec2> sample = cut_out.curves[c].sample(steps[c]);
        for (int i = 0; i < steps[c]; ++i) {
          loop.push_back(flat(sample[i]));
          run.push_back(first++);
        }
        run.push_back(c + 1 < cut_out.curves.size() ? first : start);
      }
    }
    return loops;
  }

  /// Splits every triangle in four, in the order that PanelMesh states.
  void subdivide() {
    std::map<std::array<int, 2>, int> middles;
    std::vector<Vec2>& points = triangulation_.mesh.points;
    const auto key = [](int a, int b) { return std::array{std::min(a, b), std::max(a, b)}; };
    const auto refine = [&](const EdgeCurve& curve, std::vector<int>& along) {
      if (along.empty()) return;  // merged with another edge
      std::vector<int> fine;
      const double spans = 2.0 * static_cast<double>(along.size() - 1);
      for (std::size_t i = 0; i + 1 < along.size(); ++i) {
        const int middle = static_cast<int>(points.size());
        middles[key(along[i], along[i + 1])] = middle;
        points.push_back(flat(curve.at((2.0 * static_cast<double>(i) + 1) / spans)));
        fine.push_back(along[i]);
        fine.push_back(middle);
      }
      fine.push_back(along.back());
      along = std::move(fine);
    };
    for (std::size_t e = 0; e < triangulation_.along.size(); ++e) {
      refine(panel_.edges[e].curve, triangulation_.along[e]);
    }
    std::size_t run = 0;
    for (const CutOut& cut_out : how_.cut_outs) {
      for (const EdgeCurve& curve : cut_out.curves) refine(curve, triangulation_.cut_along[run++]);
    }
    const auto middle_of = [&](int a, int b) {
      const auto [found, added] = middles.try_emplace(key(a, b), static_cast<int>(points.size()));
      if (added) {
        const Vec2 middle = (points[a] + points[b]) / 2;
        points.push_back(middle);
      }
      return found->second;
    };
    std::vector<Triangle> fine;
    fine.reserve(4 * triangulation_.mesh.triangles.size());
    for (const auto& [c0, c1, c2] : triangulation_.mesh.triangles) {
      const int m01 = middle_of(c0, c1);
      const int m12 = middle_of(c1, c2);
      const int m20 = middle_of(c2, c0);
      fine.push_back({c0, m01, m20});
      fine.push_back({m01, c1, m12});
      fine.push_back({m20, m12, c2});
      fine.push_back({m01, m12, m20});
    }
    triangulation_.mesh.triangles = std::move(fine);
    // Where a curve bulges inward, its new points come too close to the middles opposite.
    raise_angles(triangulation_.mesh, is_border(), acceptable_angle);
  }

  const PatternPanel& panel_;
  const PanelMeshing& how_;
  PanelTriangulation triangulation_;
};

}  // namespace

std::string quoted(const PatternPanel& panel) { return "panel '" + panel.name + "'"; }

PanelTriangulation triangulate_panel(const PatternPanel& panel, const PanelMeshing& how) {
  return PanelMesher(panel, how).mesh();
}

}  // namespace toile
