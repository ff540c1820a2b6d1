#include "cloth/model/compile.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "cloth/model/bending_matrix.h"
#include "cloth/model/constants.h"
#include "cloth/model/gathers.h"
#include "geometry/disjoint_sets.h"
#include "geometry/error.h"

namespace toile {

namespace {

/// Per material point, its node: sewn points share one. Nodes are numbered in the order of their
/// first points.
std::vector<int> weld(const PanelMesh& garment, int& nodes) {
  DisjointSets sewn(garment.flat.size());
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      if (is_sewn(garment, seam.a[i])) sewn.join(seam.a[i], seam.b[i]);
    }
  }
  std::vector<int> node(garment.flat.size(), -1);
  nodes = 0;
  for (std::size_t p = 0; p < node.size(); ++p) {
    const int r = sewn.of(static_cast<int>(p));
    node[p] = r == static_cast<int>(p) ? nodes++ : node[r];
  }
  return node;
}

StretchTriangle stretch_of(const std::array<Vec2, 3>& corners, double grain) {
  const auto [weft, warp] = yarn_directions(grain);
  const Vec2 e1 = corners[1] - corners[0];
  const Vec2 e2 = corners[2] - corners[0];
  const double twice_area = e1.x() * e2.y() - e1.y() * e2.x();
  // Gradients of the barycentric coordinates.
  const Vec2 g1 = Vec2(e2.y(), -e2.x()) / twice_area;
  const Vec2 g2 = Vec2(-e1.y(), e1.x()) / twice_area;
  StretchTriangle s;
  s.weft = {-(g1 + g2).dot(weft), g1.dot(weft), g2.dot(weft)};
  s.warp = {-(g1 + g2).dot(warp), g1.dot(warp), g2.dot(warp)};
  s.area = 0.5 * twice_area;
  return s;
}

class Compiler {
 public:
  Compiler(const PanelMesh& garment, const Scene& scene, double body_offset)
      : garment_(garment), gathered_(gathered_edges(garment)) {
    GatheredEdges free = elastic_edges(garment);
    for (const auto& [edge, share] : free) gathered_.erase(edge);
    free.insert(gathered_.begin(), gathered_.end());
    rows_ = gathered_rows(garment, free);
    model_.scene = scene;
    model_.body_offset = body_offset;
    model_.triangles = garment.triangles;
    model_.subdivisions = garment.subdivisions;
    model_.node_of_point = weld(garment, model_.nodes);
  }

  GarmentModel run(const std::vector<Vec3>& placed) {
    place(placed);
    lay_out_stretch();
    lay_out_elastics();
    model_.attachments = attached_points(garment_, model_.scene, placed, model_.body_offset);
    model_.self_gap = self_gap_of(model_.scene, garment_);
    if (bends()) lay_out_bending(garment_, model_);
    return std::move(model_);
  }

 private:
  void place(const std::vector<Vec3>& placed) {
    model_.start.assign(model_.nodes, Vec3::Zero());
    std::vector<int> copies(model_.nodes, 0);
    for (std::size_t p = 0; p < placed.size(); ++p) {
      model_.start[model_.node_of_point[p]] += placed[p];
      ++copies[model_.node_of_point[p]];
    }
    for (int n = 0; n < model_.nodes; ++n) model_.start[n] /= copies[n];
    if (garment_.seams.empty()) return;
    model_.offsets.resize(placed.size());
    for (std::size_t p = 0; p < placed.size(); ++p) {
      model_.offsets[p] = placed[p] - model_.start[model_.node_of_point[p]];
    }
  }

  bool bends() const {
    return std::any_of(garment_.panels.begin(), garment_.panels.end(), [&](const auto& panel) {
      const Fabric& fabric = fabric_of(model_.scene, panel);
      return fabric.bending_warp > 0 || fabric.bending_weft > 0;
    });
  }

  void lay_out_stretch() {
    model_.friction_skin.assign(model_.nodes, 0);
    model_.friction_cloth.assign(model_.nodes, 0);
    model_.mass.assign(model_.nodes, 0);
    model_.stretch_diagonal.assign(model_.nodes, 0);
    model_.shortest_edge.assign(model_.nodes, 1e9);
    for (const MeshedPanel& panel : garment_.panels) {
      const Fabric& fabric = fabric_of(model_.scene, panel);
      for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
        const Triangle& points = garment_.triangles[t];
        Triangle nodes;
        for (int i = 0; i < 3; ++i) nodes[i] = model_.node_of_point[points[i]];
        if (nodes[0] == nodes[1] || nodes[1] == nodes[2] || nodes[2] == nodes[0]) {
          throw Error("panel '" + panel.name + "'",
                      "is so narrow between two seams that a triangle is sewn to itself",
                      "mesh the pattern with a shorter --edge-length");
        }
        model_.node_triangles.push_back(nodes);
        const std::array<Vec2, 3> flat = {garment_.flat[points[0]], garment_.flat[points[1]],
                                          garment_.flat[points[2]]};
        const StretchTriangle s = stretch(t, flat, panel, fabric);
        const double area = stretch_of(flat, panel.grain).area;
        if (!(area > 0)) {
          throw Error("panel '" + panel.name + "'", "has a triangle without area",
                      "mesh the pattern again");
        }
        model_.stretch.push_back(s);
        for (int i = 0; i < 3; ++i) {
          const double mass = area * fabric.areal_density / 3;
          model_.mass[nodes[i]] += mass;
          model_.friction_skin[nodes[i]] += mass * fabric.friction_skin;
          model_.friction_cloth[nodes[i]] += mass * fabric.friction_cloth;
          double row = 0;
          for (int j = 0; j < 3; ++j) {
            const double uu = std::abs(s.weft[i] * s.weft[j]);
            const double vv = std::abs(s.warp[i] * s.warp[j]);
            const double uv =
                0.5 * (std::abs(s.weft[i] * s.warp[j]) + std::abs(s.warp[i] * s.weft[j]));
            row += s.weft_stiffness * uu + s.warp_stiffness * vv +
                   s.shear_stiffness * (0.5 * (uu + vv) + uv);
          }
          model_.stretch_diagonal[nodes[i]] += row;
          const double edge =
              std::min((flat[i] - flat[(i + 1) % 3]).norm(), (flat[i] - flat[(i + 2) % 3]).norm());
          model_.shortest_edge[nodes[i]] = std::min(model_.shortest_edge[nodes[i]], edge);
        }
      }
    }
    for (int n = 0; n < model_.nodes; ++n) {
      if (!(model_.mass[n] > 0)) continue;
      model_.friction_skin[n] /= model_.mass[n];
      model_.friction_cloth[n] /= model_.mass[n];
    }
    const double total = std::accumulate(model_.mass.begin(), model_.mass.end(), 0.0);
    model_.mean_weight =
        total * std::max(model_.scene.gravity.norm(), 1e-9) / std::max(model_.nodes, 1);
  }

  /// The stretch term of triangle t. In a gathered row, weft stands for the direction along the
  /// seam and warp for the one across it.
  StretchTriangle stretch(int t, const std::array<Vec2, 3>& flat, const MeshedPanel& panel,
                          const Fabric& fabric) const {
    const auto row = rows_.find(t);
    if (row == rows_.end()) {
      StretchTriangle s = stretch_of(flat, panel.grain);
      s.weft_stiffness = s.area * fabric.stretch_weft;
      s.warp_stiffness = s.area * fabric.stretch_warp;
      s.shear_stiffness = s.area * fabric.shear;
      return s;
    }
    const double along = std::atan2(row->second.y(), row->second.x());
    const double area = stretch_of(flat, along).area;
    const std::array<Vec2, 3> rest = drawn_up(garment_.triangles[t], flat);
    const double share = rest == flat ? gathered_stiffness : 1;
    StretchTriangle s = stretch_of(rest, along);
    s.weft_stiffness = area * share * modulus_at(fabric, along - panel.grain);
    s.warp_stiffness = area * modulus_at(fabric, along - panel.grain + std::numbers::pi / 2);
    s.shear_stiffness = area * gathered_stiffness * fabric.shear;
    s.limited = false;
    return s;
  }

  /// The rest shape of a triangle on a gathered seam: its flat one, drawn together along it.
  std::array<Vec2, 3> drawn_up(const Triangle& points, std::array<Vec2, 3> flat) const {
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const auto found = gathered_.find(std::minmax(points[i], points[j]));
      if (found == gathered_.end()) continue;
      const Vec2 along = (flat[j] - flat[i]).normalized();
      const Vec2 fixed = flat[i];
      for (Vec2& corner : flat) {
        corner -= (1 - found->second) * along.dot(corner - fixed) * along;
      }
    }
    return flat;
  }

  void lay_out_elastics() {
    model_.elastics = elastic_segments(garment_, model_.scene, model_.node_of_point);
    for (const ElasticSegment& segment : model_.elastics) {
      for (const int p : segment.points) {
        model_.stretch_diagonal[model_.node_of_point[p]] += stiffness_bound(segment);
      }
    }
  }

  const PanelMesh& garment_;
  GatheredEdges gathered_;
  std::map<int, Vec2>
      rows_;  // triangles along gathered edges and elastics, with the direction of the edge
  GarmentModel model_;
};

}  // namespace

GarmentModel compile(const PanelMesh& garment, const Scene& scene,
                     const std::vector<Vec3>& placed) {
  return compile(garment, scene, placed, body_offset_of(scene, garment));
}

GarmentModel compile(const PanelMesh& garment, const Scene& scene, const std::vector<Vec3>& placed,
                     double body_offset) {
  return Compiler(garment, scene, body_offset).run(placed);
}

}  // namespace toile
