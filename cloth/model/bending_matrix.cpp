#include "cloth/model/bending_matrix.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "cloth/model/plate_bending.h"
#include "geometry/adjacency.h"

namespace toile {

namespace {

/// A triangle at an edge, and its corner opposite to that.
struct Side {
  int triangle;
  int corner;
};

/// An edge as a side sees it, from its point `a` to `b`, and its opposite corner in that frame.
struct Reach {
  int a;
  int b;
  int c;
  double length;
  Vec2 corner;  // along the edge from a, and away from it
};

struct Link {
  int from;
  int to;
  double stiffness;
};

class HingeLayout {
 public:
  HingeLayout(const PanelMesh& garment, GarmentModel& model)
      : garment_(garment),
        model_(model),
        hinges_(model.triangles.size(), {-1, -1, -1}),
        jumps_(model.triangles.size(), {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}) {}

  void run() {
    lay_out_hinges();
    for (const MeshedPanel& panel : garment_.panels) stiffen(panel);
    for (std::size_t h = 0; h < model_.bend.size(); ++h) {
      model_.bend[h].stiffness *= length_[h] * length_[h] / area_[h];
    }
    bound();
  }

 private:
  /// Sides by their node edge: also finds the hinge across a sewn seam.
  void lay_out_hinges() {
    std::map<std::pair<int, int>, std::vector<Side>> sides;
    for (std::size_t t = 0; t < model_.node_triangles.size(); ++t) {
      for (int i = 0; i < 3; ++i) {
        const int a = model_.node_triangles[t][(i + 1) % 3];
        const int b = model_.node_triangles[t][(i + 2) % 3];
        sides[std::minmax(a, b)].push_back({static_cast<int>(t), i});
      }
    }
    for (const auto& [edge, faces] : sides) {
      if (faces.size() != 2) continue;  // a border, or three panels in one seam
      add_hinge(faces[0], faces[1]);
    }
  }

  Reach reach(const Side& side, int from_node) const {
    const Triangle& points = model_.triangles[side.triangle];
    Reach reach;
    reach.a = points[(side.corner + 1) % 3];
    reach.b = points[(side.corner + 2) % 3];
    reach.c = points[side.corner];
    if (model_.node_of_point[reach.a] != from_node) std::swap(reach.a, reach.b);
    const Vec2 edge = garment_.flat[reach.b] - garment_.flat[reach.a];
    const Vec2 to = garment_.flat[reach.c] - garment_.flat[reach.a];
    reach.length = edge.norm();
    reach.corner = {edge.dot(to) / reach.length,
                    std::abs(edge.x() * to.y() - edge.y() * to.x()) / reach.length};
    return reach;
  }

  void add_hinge(const Side& one, const Side& other) {
    const int from = model_.node_triangles[one.triangle][(one.corner + 1) % 3];
    const Reach here = reach(one, from);
    const Reach there = reach(other, from);
    BendHinge hinge;
    hinge.points = {here.a, here.b, here.c, there.c};
    hinge.weights = {0, 0, 1 / here.corner.y(), 1 / there.corner.y()};
    for (const Reach& side : {here, there}) {
      const double share = side.corner.x() / side.length;
      hinge.weights[0] -= (1 - share) / side.corner.y();
      hinge.weights[1] -= share / side.corner.y();
    }
    hinge.across_seam = here.a != there.a || here.b != there.b;
    hinges_[one.triangle][one.corner] = hinges_[other.triangle][other.corner] =
        static_cast<int>(model_.bend.size());
    model_.bend.push_back(hinge);
    length_.push_back(0.5 * (here.length + there.length));
    area_.push_back(0);
    for (const auto& [side, across] : {std::pair(one, other), {other, one}}) {
      feel(side, across);
    }
  }

  /// In the flat panel of the side; the other is drawn up to its length.
  void feel(const Side& side, const Side& across) {
    const Triangle& points = model_.triangles[side.triangle];
    const int a = points[(side.corner + 1) % 3];
    const int b = points[(side.corner + 2) % 3];
    const auto& flat = garment_.flat;
    const Reach other = reach(across, model_.node_of_point[a]);
    const Vec2 away((flat[b] - flat[a]).norm() / other.length * other.corner.x(), other.corner.y());
    jumps_[side.triangle][side.corner] = jump_by_curvature(
        flat[a], flat[b], flat[points[side.corner]], away, panel_of(side.triangle).grain);
  }

  const MeshedPanel& panel_of(int triangle) const {
    return *std::find_if(garment_.panels.begin(), garment_.panels.end(), [&](const auto& panel) {
      return triangle < panel.first_triangle + panel.triangles;
    });
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
      for (int i = 0; i < 3; ++i) {
        if (!there[i]) continue;
        const Vec2 edge = corner(i + 2) - corner(i + 1);
        const double across = std::atan2(edge.x(), -edge.y()) - panel.grain;
        model_.bend[hinges_[t][i]].stiffness += 0.5 * bending_along(fabric, across);
        area_[hinges_[t][i]] += area;
      }
    }
  }

  /// Rows of open seams count as much as they may, and don't make up for others.
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
  std::vector<std::array<int, 3>> hinges_;  // opposite to each corner; -1: none
  std::vector<std::array<Vec3, 3>> jumps_;  // of the same, by curvature
  std::vector<double> length_;              // of each hinge's edge, the mean of both sides'
  std::vector<double> area_;                // of each hinge's triangles
};

/// Entries of the same place are added up in their order, so bits don't depend on the sorting.
BendRows rows_of(const std::vector<Link>& links, std::size_t vertices) {
  const Adjacency<Link> links_of(vertices, [&](const auto& add) {
    for (const Link& link : links) add(link.from, link);
  });
  std::vector<Link> sorted;
  BendRows rows;
  rows.first.push_back(0);
  for (std::size_t v = 0; v < vertices; ++v) {
    sorted.assign(links_of[v].begin(), links_of[v].end());
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Link& a, const Link& b) { return a.to < b.to; });
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      if (i > 0 && sorted[i].to == sorted[i - 1].to) {
        rows.stiffness.back() += sorted[i].stiffness;
      } else {
        rows.vertex.push_back(sorted[i].to);
        rows.stiffness.push_back(sorted[i].stiffness);
      }
    }
    rows.first.push_back(static_cast<int>(rows.vertex.size()));
  }
  return rows;
}

/// The jumps across a triangle's edges, by the vertices that they are of.
class Jumps {
 public:
  Jumps(const GarmentModel& model, const BendTriangle& triangle, const std::vector<int>& vertex) {
    for (int i = 0; i < 3; ++i) {
      if (triangle.hinges[i] < 0) continue;
      const BendHinge& hinge = model.bend[triangle.hinges[i]];
      for (int k = 0; k < 4; ++k) weights_(i, column(vertex[hinge.points[k]])) += hinge.weights[k];
    }
  }

  /// What the energy ½ Jᵀ stiffness J adds to the matrix. The weights of a jump add up to 0, so
  /// differences say it all, and a moved sheet feels nothing.
  void add_links(const Eigen::Matrix3d& stiffness, std::vector<Link>& links) const {
    for (int a = 0; a < vertices_; ++a) {
      const Vec3 pull = stiffness * weights_.col(a);
      for (int b = 0; b < vertices_; ++b) {
        if (a != b) links.push_back({vertex_[a], vertex_[b], -pull.dot(weights_.col(b))});
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
  std::vector<Link> inside;
  std::vector<Link> seams;
  for (const BendTriangle& triangle : model.bend_triangles) {
    const Jumps jumps(model, triangle, vertex);
    Eigen::Matrix3d of_seams = Eigen::Matrix3d::Zero();
    for (int i = 0; i < 3 && seams_apart; ++i) {
      if (triangle.hinges[i] < 0 || !model.bend[triangle.hinges[i]].across_seam) continue;
      of_seams.row(i) = triangle.stiffness.row(i);
      of_seams.col(i) = triangle.stiffness.col(i);
    }
    jumps.add_links(triangle.stiffness - of_seams, inside);
    if (!of_seams.isZero(0)) jumps.add_links(of_seams, seams);
  }
  BendMatrix matrix{rows_of(inside, vertices), {}};
  if (!seams.empty()) matrix.seams = rows_of(seams, vertices);
  return matrix;
}

}  // namespace toile
