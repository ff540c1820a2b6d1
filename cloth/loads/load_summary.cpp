#include "cloth/loads/load_summary.h"

#include <algorithm>
#include <cmath>

#include "geometry/adjacency.h"
#include "geometry/parallel.h"

namespace toile {

namespace {

/// Nodes whose patches one task finds. Each task marks what it has seen in a list as long as the
/// garment.
constexpr std::size_t patch_chunk = 4096;

/// Means over patches around nodes.
class Patches {
 public:
  Patches(const DressedGarment& garment, const Loads& loads)
      : loads_(loads), beside_(loads.nodes.size(), [&](const auto& add) {
          for (const Triangle& t : garment.triangles) {
            for (int i = 0; i < 3; ++i) {
              add(t[i], t[(i + 1) % 3]);
              add(t[i], t[(i + 2) % 3]);
            }
          }
        }) {}

  /// Of each of the fields, per node: the mean over the nearest `load_patch` of cloth around it.
  std::vector<std::vector<double>> means(
      const std::vector<const std::vector<double>*>& fields) const {
    const std::size_t nodes = loads_.nodes.size();
    std::vector<std::vector<double>> means(fields.size(), std::vector<double>(nodes, 0));
    parallel_for_ranges(nodes, patch_chunk, [&](std::size_t begin, std::size_t end) {
      std::vector<std::size_t> seen_for(nodes, nodes);
      std::vector<std::pair<int, double>> patch;
      for (std::size_t n = begin; n < end; ++n) {
        const double area = find_patch(static_cast<int>(n), seen_for, patch);
        if (!(area > 0)) continue;
        for (std::size_t f = 0; f < fields.size(); ++f) {
          for (const auto& [node, share] : patch) means[f][n] += share / area * (*fields[f])[node];
        }
      }
    });
    return means;
  }

 private:
  /// Rings of neighbours, of which the last one counts in part. Returns their area, m².
  double find_patch(int middle, std::vector<std::size_t>& seen_for,
                    std::vector<std::pair<int, double>>& patch) const {
    patch.clear();
    std::vector<int> ring = {middle};
    seen_for[middle] = middle;
    double area = 0;
    while (!ring.empty() && area < load_patch) {
      double of_ring = 0;
      for (const int n : ring) of_ring += loads_.nodes[n].area;
      const double share = of_ring > 0 ? std::min(1.0, (load_patch - area) / of_ring) : 0;
      for (const int n : ring) patch.emplace_back(n, share * loads_.nodes[n].area);
      area += share * of_ring;
      std::vector<int> next;
      for (const int n : ring) {
        for (const int other : beside_[n]) {
          if (seen_for[other] == static_cast<std::size_t>(middle)) continue;
          seen_for[other] = middle;
          next.push_back(other);
        }
      }
      ring = std::move(next);
    }
    return area;
  }

  const Loads& loads_;
  Adjacency<int> beside_;
};

/// The loads that have rows, at the nodes, and their means over patches.
class Fields {
 public:
  Fields(const DressedGarment& garment, const Loads& loads)
      : garment_(garment), loads_(loads), at_(loads_at_nodes(garment, loads)) {
    for (const NodeLoad& load : loads.nodes) pressure_.push_back(load.pressure);
    means_ = Patches(garment, loads)
                 .means({&at_.strain_warp, &at_.strain_weft, &at_.strain_bias, &at_.tension_most,
                         &pressure_});
  }

  LoadRow row(const std::string& name, const std::vector<int>& triangles) const {
    LoadRow row;
    row.name = name;
    std::vector<int> nodes;
    double area = 0;
    for (const int t : triangles) {
      for (const int n : garment_.triangles[t]) nodes.push_back(n);
      area += loads_.triangles[t].area;
    }
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    double touching = 0;
    double of_nodes = 0;
    for (const int n : nodes) {
      of_nodes += loads_.nodes[n].area;
      if (loads_.nodes[n].touches) touching += loads_.nodes[n].area;
    }
    row.touching = of_nodes > 0 ? touching / of_nodes : 0;
    const auto of_triangles = [&](double TriangleLoad::*load) {
      double sum = 0;
      for (const int t : triangles) sum += loads_.triangles[t].area * (loads_.triangles[t].*load);
      return area > 0 ? sum / area : 0;
    };
    row.strain_warp = {of_triangles(&TriangleLoad::strain_warp)};
    row.strain_weft = {of_triangles(&TriangleLoad::strain_weft)};
    row.strain_bias = {of_triangles(&TriangleLoad::strain_bias)};
    row.tension = {of_triangles(&TriangleLoad::tension_most)};
    for (const int n : nodes) row.pressure.mean += loads_.nodes[n].area * pressure_[n];
    if (touching > 0) row.pressure.mean /= touching;
    LoadFigure* const figures[] = {&row.strain_warp, &row.strain_weft, &row.strain_bias,
                                   &row.tension, &row.pressure};
    for (std::size_t f = 0; f < means_.size(); ++f) {
      for (const int n : nodes) {
        if (figures[f]->node >= 0 && means_[f][n] <= figures[f]->largest) continue;
        figures[f]->largest = means_[f][n];
        figures[f]->node = n;
      }
    }
    return row;
  }

 private:
  const DressedGarment& garment_;
  const Loads& loads_;
  NodeLoads at_;
  std::vector<double> pressure_;
  std::vector<std::vector<double>> means_;
};

/// N/m: the pull along the line in which a plane cuts the triangles, the mean by their area.
double tension_along(const Girth& girth, const DressedGarment& garment, const Loads& loads) {
  double sum = 0;
  double area = 0;
  for (const int t : girth.triangles) {
    const Triangle& n = garment.triangles[t];
    const Vec3 normal = (garment.points[n[1]] - garment.points[n[0]])
                            .cross(garment.points[n[2]] - garment.points[n[0]]);
    const Vec3 along = normal.cross(girth.plane.normal);
    if (!(along.squaredNorm() > 0)) continue;
    const Vec3 unit = along.normalized();
    sum += loads.triangles[t].area * unit.dot(loads.triangles[t].tension * unit);
    area += loads.triangles[t].area;
  }
  return area > 0 ? sum / area : 0;
}

}  // namespace

NodeLoads loads_at_nodes(const DressedGarment& garment, const Loads& loads) {
  NodeLoads at;
  const std::pair<std::vector<double> NodeLoads::*, double TriangleLoad::*> fields[] = {
      {&NodeLoads::strain_warp, &TriangleLoad::strain_warp},
      {&NodeLoads::strain_weft, &TriangleLoad::strain_weft},
      {&NodeLoads::strain_bias, &TriangleLoad::strain_bias},
      {&NodeLoads::tension_warp, &TriangleLoad::tension_warp},
      {&NodeLoads::tension_weft, &TriangleLoad::tension_weft},
      {&NodeLoads::tension_most, &TriangleLoad::tension_most}};
  for (const auto& [to, from] : fields) {
    std::vector<double>& values = at.*to;
    values.assign(loads.nodes.size(), 0);
    for (std::size_t t = 0; t < loads.triangles.size(); ++t) {
      const TriangleLoad& load = loads.triangles[t];
      for (const int n : garment.triangles[t]) values[n] += load.area / 3 * (load.*from);
    }
    for (std::size_t n = 0; n < values.size(); ++n) {
      if (loads.nodes[n].area > 0) values[n] /= loads.nodes[n].area;
    }
  }
  return at;
}

LoadRows load_rows(const DressedGarment& garment, const Loads& loads, const Girths& girths) {
  std::vector<std::vector<int>> triangles(garment.panels.size());
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    triangles[garment.panel_of_triangle[t]].push_back(static_cast<int>(t));
  }
  const Fields fields(garment, loads);
  LoadRows rows;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    rows.panels.push_back(fields.row(garment.panels[p], triangles[p]));
  }
  for (const Girth& girth : girths.rows) {
    rows.levels.push_back(fields.row(girth.name, girth.triangles));
    rows.levels.back().tension.mean = tension_along(girth, garment, loads);
  }
  return rows;
}

}  // namespace toile
