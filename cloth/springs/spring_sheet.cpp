#include "cloth/springs/spring_sheet.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "cloth/model/gathers.h"
#include "cloth/model/plate_bending.h"
#include "cloth/springs/constants.h"
#include "geometry/adjacency.h"
#include "geometry/statistics.h"

namespace toile {

namespace {

using Edge = std::pair<int, int>;

Edge edge_of(int a, int b) { return std::minmax(a, b); }

/// The corner `c` of a triangle as seen from its edge a-b: how far along, how far off.
Vec2 from_edge(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 along = (b - a).normalized();
  const Vec2 to = c - a;
  return {to.dot(along), std::abs(to.x() * along.y() - to.y() * along.x())};
}

double area_of(const PanelMesh& garment, int t) {
  const auto& [a, b, c] = garment.triangles[t];
  const Vec2 u = garment.flat[b] - garment.flat[a];
  const Vec2 v = garment.flat[c] - garment.flat[a];
  return 0.5 * (u.x() * v.y() - u.y() * v.x());
}

}  // namespace

SpringSheet::SpringSheet(const PanelMesh& garment, const GarmentModel& model)
    : garment_(garment), model_(model), merged_(garment.flat.size()) {
  lay_out_edges();
  soften_small_elements();
  lay_out_bends();
  refresh();
}

/// Softens the springs of small elements: one needle of a triangle would set the step of the whole
/// garment. A node that is lighter for its stiffness than most then gives way more than the fabric
/// would. The strain control holds its springs all the same.
void SpringSheet::soften_small_elements() {
  std::vector<double> stiffness(point_mass_.size(), 0);
  for (const Spring& spring : point_edges_) {
    stiffness[spring.a] += spring.stiffness;
    stiffness[spring.b] += spring.stiffness;
  }
  std::vector<double> rates;  // of a node's fastest motion, squared, about
  for (std::size_t p = 0; p < stiffness.size(); ++p) {
    if (point_mass_[p] > 0) rates.push_back(stiffness[p] / point_mass_[p]);
  }
  if (rates.empty()) return;
  rate_ = median(std::move(rates));
  const double most = max_over_median * rate_;
  for (Spring& spring : point_edges_) {
    double share = 1;
    for (const int end : {spring.a, spring.b}) {
      share = std::min(share, most * point_mass_[end] / stiffness[end]);
    }
    spring.stiffness *= share;
    spring.damping *= share;
    softened_ += share < 1;
  }
}

void SpringSheet::lay_out_edges() {
  const GatheredEdges gathered = gathered_edges(garment_);
  point_mass_.assign(garment_.flat.size(), 0);
  for (const MeshedPanel& panel : garment_.panels) {
    const Fabric& fabric = fabric_of(model_.scene, panel);
    std::map<Edge, double> area_at;
    for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
      const double area = area_of(garment_, t);
      for (int i = 0; i < 3; ++i) {
        const int a = garment_.triangles[t][i];
        point_mass_[a] += area * fabric.areal_density / 3;
        area_at[edge_of(a, garment_.triangles[t][(i + 1) % 3])] += area;
      }
    }
    for (const auto& [edge, area] : area_at) {
      const Vec2 along = garment_.flat[edge.second] - garment_.flat[edge.first];
      Spring spring{edge.first, edge.second, along.norm()};
      const double angle = std::atan2(along.y(), along.x()) - panel.grain;
      spring.stiffness = modulus_at(fabric, angle) * area / along.squaredNorm();
      spring.damping = fabric.damping * spring.stiffness;
      const auto share = gathered.find(edge);
      if (share != gathered.end()) spring.rest *= share->second;
      point_edges_.push_back(spring);
    }
  }
}

void SpringSheet::lay_out_bends() {
  if (model_.bend.empty()) return;
  const std::vector<int> panel_of = panel_of_triangles(garment_);
  std::map<Edge, std::vector<TriangleCorner>> sides;  // corners opposite to each edge
  for (std::size_t t = 0; t < model_.node_triangles.size(); ++t) {
    const Triangle& nodes = model_.node_triangles[t];
    for (int i = 0; i < 3; ++i) {
      sides[edge_of(nodes[(i + 1) % 3], nodes[(i + 2) % 3])].push_back({static_cast<int>(t), i});
    }
  }
  for (const auto& [edge, faces] : sides) {
    if (faces.size() != 2) continue;
    Bend bend;
    std::array<Vec2, 2> opposite;  // corners, as from_edge() gives them
    double length = 0;
    double area = 0;
    double rigidity = 0;  // N·m, the mean of both sides
    double damping = 0;
    for (int side = 0; side < 2; ++side) {
      const auto& [triangle, corner] = faces[side];
      const Triangle& points = garment_.triangles[triangle];
      int a = points[(corner + 1) % 3];
      int b = points[(corner + 2) % 3];
      const MeshedPanel& panel = garment_.panels[panel_of[triangle]];
      const Fabric& fabric = fabric_of(model_.scene, panel);
      const Vec2 along = garment_.flat[b] - garment_.flat[a];
      rigidity += 0.5 * bending_along(fabric, std::atan2(along.x(), -along.y()) - panel.grain);
      length += 0.5 * along.norm();
      if (model_.node_of_point[a] != edge.first) std::swap(a, b);
      bend.hinge[2 * side] = a;
      bend.hinge[2 * side + 1] = b;
      bend.corners[side] = points[corner];
      opposite[side] = from_edge(garment_.flat[a], garment_.flat[b], garment_.flat[points[corner]]);
      const double half = area_of(garment_, triangle);
      area += half;
      damping += half * fabric.damping;
    }
    const double heights = opposite[0].y() + opposite[1].y();
    bend.rest = Vec2(opposite[0].x() - opposite[1].x(), heights).norm();
    // The spring shortens by `shorter` at the fold where the energies are to agree.
    const double fold = fold_angle_share * heights / matched_radius;
    const double shorter = opposite[0].y() * opposite[1].y() * fold * fold / (2 * bend.rest);
    // N·m: E = ½ stiffness fold², if the hinge bent alone and were rolled square to its edge.
    const double stiffness = rigidity * (length * length / area);
    const double energy = 0.5 * stiffness * fold * fold;
    bend.stiffness = 2 * energy / (shorter * shorter);
    bend.damping = damping / area;
    point_bends_.push_back(bend);
  }
}

void SpringSheet::refresh() {
  node_of_point_.resize(point_mass_.size());
  mass_.assign(point_mass_.size(), 0);
  for (std::size_t p = 0; p < point_mass_.size(); ++p) {
    node_of_point_[p] = merged_.of(static_cast<int>(p));
    mass_[node_of_point_[p]] += point_mass_[p];
  }
  inverse_mass_.resize(mass_.size());
  for (std::size_t p = 0; p < mass_.size(); ++p) {
    inverse_mass_[p] = mass_[p] > 0 ? 1 / mass_[p] : 0;
  }
  edges_ = point_edges_;
  for (Spring& spring : edges_) {
    spring.a = node_of_point_[spring.a];
    spring.b = node_of_point_[spring.b];
  }
  bending_.clear();
  for (const Bend& bend : point_bends_) {
    const auto& h = bend.hinge;
    if (node(h[0]) != node(h[2]) || node(h[1]) != node(h[3])) continue;
    const double lightest = std::min(point_mass_[bend.corners[0]], point_mass_[bend.corners[1]]);
    const double stiffness =
        std::min(bending_factor_ * bend.stiffness, bending_spring_share * rate_ * lightest);
    bending_.push_back({node(bend.corners[0]), node(bend.corners[1]), bend.rest, stiffness,
                        bend.damping * stiffness});
  }
  triangles_ = garment_.triangles;
  for (Triangle& t : triangles_) {
    for (int& corner : t) corner = node_of_point_[corner];
  }
}

}  // namespace toile
