#include "cloth/model/bending_matrix.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "cloth/model/plate_bending.h"
#include "geometry/adjacency.h"
#include "geometry/half_edges.h"

namespace toile {

namespace {

/// An edge of a triangle, with the corner opposite to it in the frame of the edge.
struct EdgeFrame {
  int a;          ///< material point at one end
  int b;          ///< material point at the other end
  int c;          ///< material point of the opposite corner
  double length;  ///< metres
  Vec2 corner;    ///< metres along the edge from a, and away from it
};

/// An entry of the stiffness matrix.
struct MatrixEntry {
  int row;
  int column;
  double stiffness;  ///< N/m
};

class HingeLayout {
 public:
  HingeLayout(const PanelMesh& garment, GarmentModel& model)
      : garment_(garment),
        model_(model),
        panel_of_(panel_of_triangles(garment)),
        hinges_(model.triangles.size(), {-1, -1, -1}),
        jumps_(model.triangles.size(), {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}) {}

  void run() {
    lay_out_hinges();
    for (const MeshedPanel& panel : garment_.panels) stiffen(panel);
    bound();
  }

 private:
  /// Edges are those of nodes, so sewn seams have hinges too.
  void lay_out_hinges() {
    const std::vector<HalfEdge> sides =
        half_edges(model_.node_triangles, static_cast<std::size_t>(model_.nodes));
    for (std::size_t i = 0; i < sides.size();) {
      std::size_t end = i + 1;
      while (end < sides.size() && sides[end].same_edge(sides[i])) ++end;
      // Any other number is a border, or three panels in one seam.
      if (end - i == 2) add_hinge(sides[i], sides[i + 1]);
      i = end;
    }
  }

  /// The edge of `side`, from the end at node `from_node` on.
  EdgeFrame frame_of(const HalfEdge& side, int from_node) const {
    const Triangle& points = model_.triangles[side.triangle];
    EdgeFrame frame;
    frame.a = points[(side.opposite + 1) % 3];
    frame.b = points[(side.opposite + 2) % 3];
    frame.c = points[side.opposite];
    if (model_.node_of_point[frame.a] != from_node) std::swap(frame.a, frame.b);
    const Vec2 edge = garment_.flat[frame.b] - garment_.flat[frame.a];
    const Vec2 to = garment_.flat[frame.c] - garment_.flat[frame.a];
    frame.length = edge.norm();
    frame.corner = {edge.dot(to) / frame.length,
                    std::abs(edge.x() * to.y() - edge.y() * to.x()) / frame.length};
    return frame;
  }

  void add_hinge(const HalfEdge& one, const HalfEdge& other) {
    const int from = model_.node_triangles[one.triangle][(one.opposite + 1) % 3];
    const EdgeFrame here = frame_of(one, from);
    const EdgeFrame there = frame_of(other, from);
    BendHinge hinge;
    hinge.points = {here.a, here.b, here.c, there.c};
    hinge.weights = {0, 0, 1 / here.corner.y(), 1 / there.corner.y()};
    for (const EdgeFrame& frame : {here, there}) {
      const double share = frame.corner.x() / frame.length;
      hinge.weights[0] -= (1 - share) / frame.corner.y();
      hinge.weights[1] -= share / frame.corner.y();
    }
    hinge.across_seam = here.a != there.a || here.b != there.b;
    hinges_[one.triangle][one.opposite] = hinges_[other.triangle][other.opposite] =
        static_cast<int>(model_.bend.size());
    model_.bend.push_back(hinge);
    for (const auto& [side, across] : {std::pair(one, other), {other, one}}) {
      store_jump(side, across);
    }
  }

  /// Stores the jump across the edge of `side`, in the flat panel of that side. The panel of
  /// `across` is scaled to the same length of the edge.
  void store_jump(const HalfEdge& side, const HalfEdge& across) {
    const Triangle& points = model_.triangles[side.triangle];
    const int a = points[(side.opposite + 1) % 3];
    const int b = points[(side.opposite + 2) % 3];
    const auto& flat = garment_.flat;
    const EdgeFrame other = frame_of(across, model_.node_of_point[a]);
    const Vec2 away((flat[b] - flat[a]).norm() / other.length * other.corner.x(), other.corner.y());
    jumps_[side.triangle][side.opposite] =
        jump_by_curvature(flat[a], flat[b], flat[points[side.opposite]], away,
                          garment_.panels[panel_of_[side.triangle]].grain);
  }

  void stiffen(const MeshedPanel& panel) {
    const Fabric& fabric = fabric_of(model_.scene, panel);
    for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
      BendTriangle triangle;
      triangle.hinges = hinges_[t];
      std::array<bool, 3> there;
      for (int i = 0; i < 3; ++i) there[i] = hinges_[t][i] >= 0;
      const auto corner = [&](int i) { return garment_.flat[model_.triangles[t][i % 3]]; };
      const Vec2 first = corner(1) - corner(0);
      const Vec2 second = corner(2) - corner(0);
      const double area = 0.5 * (first.x() * second.y() - first.y() * second.x());
      triangle.stiffness = plate_stiffness(fabric, area, jumps_[t], there);
      if (triangle.stiffness.trace() > 0) model_.bend_triangles.push_back(triangle);
    }
  }

  /// Bounds the row sums. Rows of open seams count with all of their stiffness, and do not cancel
  /// that of other rows.
  void bound() {
    model_.bend_diagonal.assign(model_.nodes, 0);
    const BendMatrix matrix = bend_matrix(model_, model_.node_of_point, model_.nodes, true);
    for (const BendRows* rows : {&matrix.inside, &matrix.seams}) {
      for (int n = 0; n + 1 < static_cast<int>(rows->first.size()); ++n) {
        double diagonal = 0, others = 0;
        for (int i = rows->first[n]; i < rows->first[n + 1]; ++i) {
          diagonal += rows->stiffness[i];
          others += std::abs(rows->stiffness[i]);
        }
        model_.bend_diagonal[n] += std::abs(diagonal) + others;
      }
    }
  }

  const PanelMesh& garment_;
  GarmentModel& model_;
  std::vector<int> panel_of_;               // per triangle
  std::vector<std::array<int, 3>> hinges_;  // per triangle, opposite to each corner; -1: none
  std::vector<std::array<Vec3, 3>> jumps_;  // per triangle, the jump there by curvature, metres
};

/// Sorts entries into rows. Entries of the same place are added up in their order, so the sum does
/// not depend on the sorting.
BendRows rows_of(const std::vector<MatrixEntry>& entries, std::size_t vertices) {
  const Adjacency<MatrixEntry> entries_of(vertices, [&](const auto& add) {
    for (const MatrixEntry& entry : entries) add(entry.row, entry);
  });
  std::vector<MatrixEntry> sorted;
  BendRows rows;
  rows.first.push_back(0);
  for (std::size_t v = 0; v < vertices; ++v) {
    sorted.assign(entries_of[v].begin(), entries_of[v].end());
    std::stable_sort(sorted.begin(), sorted.end(), [](const MatrixEntry& a, const MatrixEntry& b) {
      return a.column < b.column;
    });
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      if (i > 0 && sorted[i].column == sorted[i - 1].column) {
        rows.stiffness.back() += sorted[i].stiffness;
      } else {
        rows.vertex.push_back(sorted[i].column);
        rows.stiffness.push_back(sorted[i].stiffness);
      }
    }
    rows.first.push_back(static_cast<int>(rows.vertex.size()));
  }
  return rows;
}

/// The jumps across a triangle's edges, as weights of the vertices.
class Jumps {
 public:
  Jumps(const GarmentModel& model, const BendTriangle& triangle, const std::vector<int>& vertex) {
    for (int i = 0; i < 3; ++i) {
      if (triangle.hinges[i] < 0) continue;
      const BendHinge& hinge = model.bend[triangle.hinges[i]];
      for (int k = 0; k < 4; ++k) weights_(i, column(vertex[hinge.points[k]])) += hinge.weights[k];
    }
  }

  /// Adds what the energy ½ Jᵀ stiffness J contributes to the matrix, without the diagonal. The
  /// weights of a jump add up to 0, so off-diagonal entries suffice, and a moved sheet feels no
  /// force.
  void add_entries(const Eigen::Matrix3d& stiffness, std::vector<MatrixEntry>& entries) const {
    for (int a = 0; a < vertices_; ++a) {
      const Vec3 pull = stiffness * weights_.col(a);
      for (int b = 0; b < vertices_; ++b) {
        if (a != b) entries.push_back({vertex_[a], vertex_[b], -pull.dot(weights_.col(b))});
      }
    }
  }

 private:
  int column(int vertex) {
    const auto end = vertex_.begin() + vertices_;
    const auto found = std::find(vertex_.begin(), end, vertex);
    if (found == end) vertex_[vertices_++] = vertex;
    return static_cast<int>(found - vertex_.begin());
  }

  std::array<int, 12> vertex_;
  int vertices_ = 0;
  Eigen::Matrix<double, 3, 12> weights_ = Eigen::Matrix<double, 3, 12>::Zero();
};

}  // namespace

void lay_out_bending(const PanelMesh& garment, GarmentModel& model) {
  HingeLayout(garment, model).run();
}

BendMatrix bend_matrix(const GarmentModel& model, const std::vector<int>& vertex,
                       std::size_t vertices, bool seams_apart) {
  std::vector<MatrixEntry> inside;
  std::vector<MatrixEntry> seams;
  for (const BendTriangle& triangle : model.bend_triangles) {
    const Jumps jumps(model, triangle, vertex);
    Eigen::Matrix3d of_seams = Eigen::Matrix3d::Zero();
    for (int i = 0; i < 3 && seams_apart; ++i) {
      if (triangle.hinges[i] < 0 || !model.bend[triangle.hinges[i]].across_seam) continue;
      of_seams.row(i) = triangle.stiffness.row(i);
      of_seams.col(i) = triangle.stiffness.col(i);
    }
    jumps.add_entries(triangle.stiffness - of_seams, inside);
    if (!of_seams.isZero(0)) jumps.add_entries(of_seams, seams);
  }
  BendMatrix matrix{rows_of(inside, vertices), {}};
  if (!seams.empty()) matrix.seams = rows_of(seams, vertices);
  return matrix;
}

}  // namespace toile
