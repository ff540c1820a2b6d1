#include "cloth/program.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "cloth/gathers.h"
#include "cloth/hinge_rigidity.h"
#include "geometry/error.h"

namespace toile {

namespace {

/// Sewn points joined; nodes numbered in the order of their first points.
std::vector<int> weld(const PanelMesh& garment, int& nodes) {
  std::vector<int> parent(garment.flat.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int p) {
    while (parent[p] != p) p = parent[p] = parent[parent[p]];
    return p;
  };
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      const int a = root(seam.a[i]);
      const int b = root(seam.b[i]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  std::vector<int> node(garment.flat.size(), -1);
  nodes = 0;
  for (std::size_t p = 0; p < node.size(); ++p) {
    const int r = root(static_cast<int>(p));
    node[p] = r == static_cast<int>(p) ? nodes++ : node[r];
  }
  return node;
}

StretchTriangle stretch_of(const std::array<Vec2, 3>& corners, double grain) {
  // Weft and warp directions: +x and +y of the flat panel, turned by the grain.
  const Vec2 weft(std::cos(grain), std::sin(grain));
  const Vec2 warp(-std::sin(grain), std::cos(grain));
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

/// Cotangent of the angle at `at`.
double cotangent(const Vec2& at, const Vec2& a, const Vec2& b) {
  const Vec2 u = a - at;
  const Vec2 v = b - at;
  return u.dot(v) / std::abs(u.x() * v.y() - u.y() * v.x());
}

class Compiler {
 public:
  Compiler(const PanelMesh& garment, const Scene& scene)
      : garment_(garment), gathered_(gathered_edges(garment)) {
    GatheredEdges free = elastic_edges(garment);
    for (const auto& [edge, share] : free) gathered_.erase(edge);
    free.insert(gathered_.begin(), gathered_.end());
    rows_ = gathered_rows(garment, free);
    program_.scene = scene;
    program_.triangles = garment.triangles;
    program_.subdivisions = garment.subdivisions;
    program_.node_of_point = weld(garment, program_.nodes);
  }

  Program run(const std::vector<Vec3>& placed) {
    place(placed);
    lay_out_stretch();
    lay_out_bands();
    program_.self_gap = self_gap_of(program_.scene, garment_);
    if (bends()) lay_out_bend();
    return std::move(program_);
  }

 private:
  void place(const std::vector<Vec3>& placed) {
    program_.start.assign(program_.nodes, Vec3::Zero());
    std::vector<int> copies(program_.nodes, 0);
    for (std::size_t p = 0; p < placed.size(); ++p) {
      program_.start[program_.node_of_point[p]] += placed[p];
      ++copies[program_.node_of_point[p]];
    }
    for (int n = 0; n < program_.nodes; ++n) program_.start[n] /= copies[n];
    if (garment_.seams.empty()) return;
    program_.offsets.resize(placed.size());
    for (std::size_t p = 0; p < placed.size(); ++p) {
      program_.offsets[p] = placed[p] - program_.start[program_.node_of_point[p]];
    }
  }

  bool bends() const {
    return std::any_of(garment_.panels.begin(), garment_.panels.end(), [&](const auto& panel) {
      const Fabric& fabric = fabric_of(program_.scene, panel);
      return fabric.bending_warp > 0 || fabric.bending_weft > 0;
    });
  }

  void lay_out_stretch() {
    program_.friction_skin.assign(program_.nodes, 0);
    program_.friction_cloth.assign(program_.nodes, 0);
    program_.mass.assign(program_.nodes, 0);
    program_.stretch_diagonal.assign(program_.nodes, 0);
    program_.shortest_edge.assign(program_.nodes, 1e9);
    for (const MeshedPanel& panel : garment_.panels) {
      const Fabric& fabric = fabric_of(program_.scene, panel);
      for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
        const Triangle& points = garment_.triangles[t];
        Triangle nodes;
        for (int i = 0; i < 3; ++i) nodes[i] = program_.node_of_point[points[i]];
        if (nodes[0] == nodes[1] || nodes[1] == nodes[2] || nodes[2] == nodes[0]) {
          throw Error("panel '" + panel.name + "'",
                      "is so narrow between two seams that a triangle is sewn to itself",
                      "mesh the pattern with a shorter --edge-length");
        }
        program_.node_triangles.push_back(nodes);
        const std::array<Vec2, 3> flat = {garment_.flat[points[0]], garment_.flat[points[1]],
                                          garment_.flat[points[2]]};
        const StretchTriangle s = stretch(t, flat, panel, fabric);
        const double area = stretch_of(flat, panel.grain).area;
        if (!(area > 0)) {
          throw Error("panel '" + panel.name + "'", "has a triangle without area",
                      "mesh the pattern again");
        }
        program_.stretch.push_back(s);
        panel_of_triangle_.push_back(static_cast<int>(&panel - garment_.panels.data()));
        for (int i = 0; i < 3; ++i) {
          const double mass = area * fabric.areal_density / 3;
          program_.mass[nodes[i]] += mass;
          program_.friction_skin[nodes[i]] += mass * fabric.friction_skin;
          program_.friction_cloth[nodes[i]] += mass * fabric.friction_cloth;
          double row = 0;
          for (int j = 0; j < 3; ++j) {
            const double uu = std::abs(s.weft[i] * s.weft[j]);
            const double vv = std::abs(s.warp[i] * s.warp[j]);
            const double uv =
                0.5 * (std::abs(s.weft[i] * s.warp[j]) + std::abs(s.warp[i] * s.weft[j]));
            row += s.weft_stiffness * uu + s.warp_stiffness * vv +
                   s.shear_stiffness * (0.5 * (uu + vv) + uv);
          }
          program_.stretch_diagonal[nodes[i]] += row;
          const double edge =
              std::min((flat[i] - flat[(i + 1) % 3]).norm(), (flat[i] - flat[(i + 2) % 3]).norm());
          program_.shortest_edge[nodes[i]] = std::min(program_.shortest_edge[nodes[i]], edge);
        }
      }
    }
    for (int n = 0; n < program_.nodes; ++n) {
      if (!(program_.mass[n] > 0)) continue;
      program_.friction_skin[n] /= program_.mass[n];
      program_.friction_cloth[n] /= program_.mass[n];
    }
    const double total = std::accumulate(program_.mass.begin(), program_.mass.end(), 0.0);
    program_.mean_weight =
        total * std::max(program_.scene.gravity.norm(), 1e-9) / std::max(program_.nodes, 1);
  }

  /// In a gathered row, weft and warp stand for the directions along the seam and across it.
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
    s.held = false;
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

  void lay_out_bands() {
    program_.bands = band_segments(garment_, program_.scene, program_.node_of_point);
    for (const BandSegment& band : program_.bands) {
      const double stiffness = 2 * (band.stiffness / band.rest + band.cloth / band.flat);
      for (const int p : band.points) {
        program_.stretch_diagonal[program_.node_of_point[p]] += stiffness;
      }
    }
  }

  void lay_out_bend() {
    program_.bend_diagonal.assign(program_.nodes, 0);
    // Triangles by their node edge: also finds the hinge across a sewn seam.
    struct Side {
      int triangle;
      int corner;  // opposite to the edge
    };
    hinges_.assign(program_.triangles.size(), {-1, -1, -1});
    responses_.assign(program_.triangles.size(), {});
    std::map<std::pair<int, int>, std::vector<Side>> sides;
    for (std::size_t t = 0; t < program_.node_triangles.size(); ++t) {
      for (int i = 0; i < 3; ++i) {
        const int a = program_.node_triangles[t][(i + 1) % 3];
        const int b = program_.node_triangles[t][(i + 2) % 3];
        sides[std::minmax(a, b)].push_back({static_cast<int>(t), i});
      }
    }
    for (const auto& [edge, faces] : sides) {
      if (faces.size() != 2) continue;  // a border, or three panels in one seam
      add_hinge(faces[0].triangle, faces[0].corner, faces[1].triangle, faces[1].corner);
    }
    stiffen_hinges();
  }

  /// What the hinge opposite to corner `at` of triangle `t` feels, in that triangle's flat panel.
  HingeResponse response(int t, int at, int other, int other_at) const {
    const auto point = [&](int triangle, int i) { return program_.triangles[triangle][i % 3]; };
    const auto& flat = garment_.flat;
    const Vec2 a = flat[point(t, at + 1)];
    int other_a = point(other, other_at + 2);
    int other_b = point(other, other_at + 1);
    if (program_.node_of_point[other_a] != program_.node_of_point[point(t, at + 1)]) {
      std::swap(other_a, other_b);
    }
    const Vec2 along = (flat[other_b] - flat[other_a]).normalized();
    const Vec2 to = flat[point(other, other_at)] - flat[other_a];
    const Vec2 away(along.dot(to), std::abs(along.x() * to.y() - along.y() * to.x()));
    const MeshedPanel& panel = garment_.panels[panel_of_triangle_[t]];
    return hinge_response(a, flat[point(t, at + 2)], flat[point(t, at)], away, panel.grain);
  }

  /// A hinge has half its rigidity from either side, which may be another fabric or turned.
  void stiffen_hinges() {
    for (std::size_t t = 0; t < hinges_.size(); ++t) {
      const Fabric& fabric = fabric_of(program_.scene, garment_.panels[panel_of_triangle_[t]]);
      const auto rigidity = hinge_rigidities(fabric, responses_[t]);
      for (int i = 0; i < 3; ++i) {
        if (hinges_[t][i] >= 0) program_.bend[hinges_[t][i]].stiffness += 0.5 * rigidity[i];
      }
    }
    std::vector<double> area(program_.bend.size(), 0);
    for (std::size_t t = 0; t < hinges_.size(); ++t) {
      for (const int hinge : hinges_[t]) {
        if (hinge >= 0) area[hinge] += program_.stretch[t].area;
      }
    }
    for (std::size_t h = 0; h < program_.bend.size(); ++h) {
      BendHinge& hinge = program_.bend[h];
      hinge.stiffness /= area[h];
      double sum = 0;
      for (const double w : hinge.weights) sum += std::abs(w);
      for (int i = 0; i < 4; ++i) {
        program_.bend_diagonal[program_.node_of_point[hinge.points[i]]] +=
            hinge.stiffness * std::abs(hinge.weights[i]) * sum;
      }
    }
  }

  void add_hinge(int t0, int corner0, int t1, int corner1) {
    const auto& p0 = program_.triangles[t0];
    const auto& p1 = program_.triangles[t1];
    const int a0 = p0[(corner0 + 1) % 3];
    const int b0 = p0[(corner0 + 2) % 3];
    int a1 = p1[(corner1 + 1) % 3];
    int b1 = p1[(corner1 + 2) % 3];
    if (program_.node_of_point[a1] != program_.node_of_point[a0]) std::swap(a1, b1);
    const int c = p0[corner0];
    const int d = p1[corner1];
    const auto& flat = garment_.flat;
    const double at_a0 = cotangent(flat[a0], flat[b0], flat[c]);
    const double at_b0 = cotangent(flat[b0], flat[a0], flat[c]);
    const double at_a1 = cotangent(flat[a1], flat[b1], flat[d]);
    const double at_b1 = cotangent(flat[b1], flat[a1], flat[d]);
    BendHinge hinge;
    hinge.points = {a0, b0, c, d};
    hinge.weights = {at_b0 + at_b1, at_a0 + at_a1, -at_a0 - at_b0, -at_a1 - at_b1};
    hinge.across_seam = a0 != a1 || b0 != b1;
    hinges_[t0][corner0] = hinges_[t1][corner1] = static_cast<int>(program_.bend.size());
    responses_[t0][corner0] = response(t0, corner0, t1, corner1);
    responses_[t1][corner1] = response(t1, corner1, t0, corner0);
    program_.bend.push_back(hinge);
  }

  const PanelMesh& garment_;
  GatheredEdges gathered_;
  std::map<int, Vec2> rows_;  // along gathered edges and elastics
  std::vector<int> panel_of_triangle_;
  std::vector<std::array<int, 3>> hinges_;               // opposite to each corner; -1: none
  std::vector<std::array<HingeResponse, 3>> responses_;  // of the same
  Program program_;
};

}  // namespace

Program compile(const PanelMesh& garment, const Scene& scene, const std::vector<Vec3>& placed) {
  return Compiler(garment, scene).run(placed);
}

std::vector<std::pair<std::string, int>> term_counts(const Program& program) {
  const auto count = [](auto n) { return static_cast<int>(n); };
  const Scene& scene = program.scene;
  const int triangles = count(program.triangles.size());
  int sewn = 0;
  std::vector<char> seen(program.nodes, 0);
  for (const int node : program.node_of_point) sewn += seen[node]++ == 1;
  const auto rough = [&](const std::vector<double>& frictions) {
    return count(std::count_if(frictions.begin(), frictions.end(),
                               [](double friction) { return friction > 0; }));
  };
  const int held = count(std::count_if(program.stretch.begin(), program.stretch.end(),
                                       [](const StretchTriangle& s) { return s.held; }));
  return {{"stretch", triangles},
          {"bend", count(program.bend.size())},
          {"elastic", count(program.bands.size())},
          {"seam", program.offsets.empty() ? 0 : sewn},
          {"body_contact", scene.body != nullptr ? program.nodes : 0},
          {"friction", scene.body != nullptr ? rough(program.friction_skin) : 0},
          {"self_contact", scene.self_contact ? triangles : 0},
          {"cloth_friction", scene.self_contact ? rough(program.friction_cloth) : 0},
          {"layer_contact", scene.layers != nullptr ? count(scene.layers->triangles.size()) : 0},
          {"strain_limit", scene.strain_limit ? held : 0},
          {"shear_limit", scene.shear_limit ? held : 0}};
}

}  // namespace toile
