#include "cloth/dressing/carry_drape.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "cloth/dressing/constants.h"
#include "geometry/border_loops.h"
#include "geometry/closest_points.h"
#include "geometry/polygon.h"
#include "geometry/triangle_tree.h"
#include "io/text.h"

namespace toile {

namespace {

/// One panel of an earlier drape, flat and as worn.
class EarlierPanel {
 public:
  EarlierPanel(const DressedGarment& earlier, int panel) {
    for (const Vec2& p : earlier.flat) flat_.points.emplace_back(p.x(), p.y(), 0);
    for (std::size_t t = 0; t < earlier.triangles.size(); ++t) {
      if (earlier.panel_of_triangle[t] != panel) continue;
      // No point lies in a triangle without area, and none goes on from it.
      if (!(std::abs(doubled_area(earlier.flat_triangles[t])) > 0)) continue;
      flat_.triangles.push_back(earlier.flat_triangles[t]);
      Corners corners;
      for (int i = 0; i < 3; ++i) corners[i] = earlier.points[earlier.triangles[t][i]];
      worn_.push_back(corners);
    }
  }
  EarlierPanel(const EarlierPanel&) = delete;
  EarlierPanel& operator=(const EarlierPanel&) = delete;

  bool is_empty() const { return worn_.empty(); }

  /// Builds what the others need; once, for a panel that is not empty.
  void index() {
    tree_.emplace(flat_);
    for (const std::vector<int>& loop : border_loops(flat_.triangles, flat_.points.size())) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        outline_.push_back(
            {flat_.points[loop[i]].head<2>(), flat_.points[loop[(i + 1) % loop.size()]].head<2>()});
      }
    }
  }

  /// Index of the triangle that is nearest to the flat point.
  int nearest(const Vec2& p, int hint) const {
    return tree_->closest_triangle(Vec3(p.x(), p.y(), 0), hint);
  }

  /// The point in the plane of the triangle as worn, metres; it may be outside the triangle.
  Vec3 worn_point(int triangle, const Vec2& p) const {
    const std::array<double, 3> weights = weights_of(triangle, p);
    const Corners& corners = worn_[triangle];
    return weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
  }

  /// The point of the panel's outline that is nearest to the flat point. O(n) of the outline.
  Vec2 on_outline(const Vec2& p) const {
    Vec2 nearest = p;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [from, to] : outline_) {
      const Vec2 at = from + closest_on_segment(p, from, to) * (to - from);
      if ((p - at).norm() < least) {
        least = (p - at).norm();
        nearest = at;
      }
    }
    return nearest;
  }

  /// Metres from the flat point to the triangle, 0 inside.
  double distance(int triangle, const Vec2& p) const {
    const auto weights = weights_of(triangle, p);
    if (std::ranges::min(weights) >= 0) return 0;
    const Triangle& t = flat_.triangles[triangle];
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
      least = std::min(least, distance_to_segment(p, flat_.points[t[i]].head<2>(),
                                                  flat_.points[t[(i + 1) % 3]].head<2>()));
    }
    return least;
  }

 private:
  using Corners = std::array<Vec3, 3>;

  /// Square metres, twice the flat triangle's area.
  double doubled_area(const Triangle& t) const {
    const Vec3 b = flat_.points[t[1]] - flat_.points[t[0]];
    const Vec3 c = flat_.points[t[2]] - flat_.points[t[0]];
    return b.x() * c.y() - b.y() * c.x();
  }

  std::array<double, 3> weights_of(int triangle, const Vec2& p) const {
    const Triangle& t = flat_.triangles[triangle];
    const Vec2 a = flat_.points[t[0]].head<2>();
    const Vec2 b = Vec2(flat_.points[t[1]].head<2>()) - a;
    const Vec2 c = Vec2(flat_.points[t[2]].head<2>()) - a;
    const double area = doubled_area(t);
    const Vec2 to = p - a;
    const double of_b = (to.x() * c.y() - to.y() * c.x()) / area;
    const double of_c = (b.x() * to.y() - b.y() * to.x()) / area;
    return {1 - of_b - of_c, of_b, of_c};
  }

  TriangleMesh flat_;                         // at height 0
  std::vector<std::array<Vec2, 2>> outline_;  // segments
  std::vector<Corners> worn_;
  std::optional<TriangleTree> tree_;
};

/// Per point of the panel, how far it is from its place in the earlier flat panel, metres. A seam
/// stays where it was: its points go to the earlier outline. The panel between follows, as even as
/// it can [Laplace's equation; edges of the outline weigh half]. Hems do not hold it. Empty:
/// nothing moves.
std::vector<Vec2> shift_to_seams(const PanelMesh& garment, const MeshedPanel& panel,
                                 const EarlierPanel& before) {
  std::vector<char> is_sewn(panel.points, 0);
  Eigen::MatrixX2d shift = Eigen::MatrixX2d::Zero(panel.points, 2);
  for (const MeshedSeam& seam : garment.seams) {
    for (const std::vector<int>* side : {&seam.a, &seam.b}) {
      for (std::size_t i = 0; i < side->size(); ++i) {
        const int own = (*side)[i] - panel.first_point;
        if (own < 0 || own >= panel.points) continue;
        const Vec2& p = garment.flat[(*side)[i]];
        const Vec2 along = garment.flat[(*side)[std::min(i + 1, side->size() - 1)]] -
                           garment.flat[(*side)[i > 0 ? i - 1 : 0]];
        // Along itself a seam only became longer.
        const Vec2 across = Vec2(-along.y(), along.x()).normalized();
        is_sewn[own] = 1;
        shift.row(own) = across.dot(before.on_outline(p) - p) * across;
      }
    }
  }
  if (shift.cwiseAbs().maxCoeff() < min_carried_shift) return {};
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(panel.points, 2);
  for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
    for (int i = 0; i < 3; ++i) {
      const int a = garment.triangles[t][i] - panel.first_point;
      const int b = garment.triangles[t][(i + 1) % 3] - panel.first_point;
      for (const auto& [row, column] : {std::array{a, b}, std::array{b, a}}) {
        if (is_sewn[row]) continue;
        entries.emplace_back(row, row, 1);
        if (is_sewn[column]) {
          right.row(row) += shift.row(column);
        } else {
          entries.emplace_back(row, column, -1);
        }
      }
    }
  }
  for (int p = 0; p < panel.points; ++p) {
    if (!is_sewn[p]) continue;
    entries.emplace_back(p, p, 1);
    right.row(p) = shift.row(p);
  }
  Eigen::SparseMatrix<double> matrix(panel.points, panel.points);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  if (solver.info() != Eigen::Success) return {};
  const Eigen::MatrixX2d solved = solver.solve(right);
  std::vector<Vec2> shifts;
  for (int p = 0; p < panel.points; ++p) shifts.emplace_back(solved.row(p));
  return shifts;
}

/// The first panel that only one of the two has, in words; empty: there is none.
std::string other_panel(const DressedGarment& earlier, const PanelMesh& garment) {
  for (const MeshedPanel& panel : garment.panels) {
    if (std::ranges::find(earlier.panels, panel.name) == earlier.panels.end()) {
      return "panel '" + panel.name + "' is new";
    }
  }
  for (const std::string& name : earlier.panels) {
    if (std::ranges::find(garment.panels, name, &MeshedPanel::name) == garment.panels.end()) {
      return "panel '" + name + "' is gone";
    }
  }
  return {};
}

/// The first seam whose sides do not meet, in words; empty: there is none.
std::string open_seam(const PanelMesh& garment, const std::vector<Vec3>& points) {
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      const double gap = (points[seam.a[i]] - points[seam.b[i]]).norm();
      if (!(gap <= max_carried_gap)) {
        return "the sides of seam " + seam.name + " are " + centimetres(gap, 1) + " apart";
      }
    }
  }
  return {};
}

}  // namespace

CarriedDrape carry_drape(const DressedGarment& earlier, const PanelMesh& garment) {
  CarriedDrape carried;
  carried.refusal = other_panel(earlier, garment);
  if (!carried.refusal.empty()) return carried;
  std::vector<Vec3> points(garment.flat.size());
  for (const MeshedPanel& panel : garment.panels) {
    const auto named = std::ranges::find(earlier.panels, panel.name);
    EarlierPanel before(earlier, static_cast<int>(named - earlier.panels.begin()));
    if (before.is_empty()) {
      carried.refusal = "panel '" + panel.name + "' has no triangles in the earlier drape";
      return carried;
    }
    before.index();
    const std::vector<Vec2> shifts = shift_to_seams(garment, panel, before);
    int nearest = -1;
    for (int own = 0; own < panel.points; ++own) {
      Vec2 flat = garment.flat[panel.first_point + own];
      nearest = before.nearest(flat, nearest);
      carried.outside = std::max(carried.outside, before.distance(nearest, flat));
      if (!shifts.empty()) {
        carried.shifted = std::max(carried.shifted, shifts[own].norm());
        flat += shifts[own];
        nearest = before.nearest(flat, nearest);
      }
      points[panel.first_point + own] = before.worn_point(nearest, flat);
    }
    if (!(carried.outside <= max_carried_outside)) {
      carried.refusal = "panel '" + panel.name + "' reaches " + centimetres(carried.outside, 1) +
                        " beyond what it was";
      return carried;
    }
  }
  carried.refusal = open_seam(garment, points);
  if (carried.refusal.empty()) carried.points = std::move(points);
  return carried;
}

}  // namespace toile
