#include "cloth/self_contact.h"

#include <oneapi/tbb/parallel_for.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/nearest.h"

namespace toile {

namespace {

/// Share of the distance to the nearest thing that a vertex may move: both sides move, so just
/// under a half.
constexpr double bound_share = 0.45;
/// Share of the shortest edge at rest that neighbours in the mesh may come near each other.
constexpr double neighbour_share = 0.25;
/// N/m, per pair.
constexpr double push_stiffness = 200;
/// Metres; below it, forces grow no more.
constexpr double least_distance = 1e-9;
/// Vertices or edges that one task looks up; fixed, so that results don't depend on the threads.
constexpr int chunk = 512;

struct Box {
  Vec3 low;
  Vec3 high;

  bool meets(const Box& other, double reach) const {
    return ((low - other.high).array() < reach).all() && ((other.low - high).array() < reach).all();
  }
};

template <std::size_t N>
Box box_of(const std::array<int, N>& corners, const std::vector<Vec3>& x) {
  Box box{x[corners[0]], x[corners[0]]};
  for (std::size_t i = 1; i < N; ++i) {
    box.low = box.low.cwiseMin(x[corners[i]]);
    box.high = box.high.cwiseMax(x[corners[i]]);
  }
  return box;
}

/// Boxes sorted into the cells of a regular grid.
class CellGrid {
 public:
  CellGrid(const std::vector<Box>& boxes, double reach) {
    origin_ = Vec3::Constant(std::numeric_limits<double>::max());
    Vec3 high = -origin_;
    double extent = 0;
    for (const Box& box : boxes) {
      origin_ = origin_.cwiseMin(box.low);
      high = high.cwiseMax(box.high);
      extent += (box.high - box.low).maxCoeff();
    }
    origin_ -= Vec3::Constant(reach);
    high += Vec3::Constant(reach);
    cell_ = std::max(extent / std::max<std::size_t>(boxes.size(), 1) + reach, 1e-6);
    // A runaway vertex must not ask for more cells than memory holds.
    constexpr double most_cells = 4e6;
    while (((high - origin_) / cell_ + Vec3::Ones()).prod() > most_cells) cell_ *= 1.5;
    for (int axis = 0; axis < 3; ++axis) {
      size_[axis] = static_cast<int>((high[axis] - origin_[axis]) / cell_) + 1;
    }
    first_.assign(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2] + 1, 0);
    for (const Box& box : boxes) {
      each_cell(box, reach, [&](std::size_t c) { ++first_[c + 1]; });
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    items_.resize(first_.back());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for (std::size_t b = 0; b < boxes.size(); ++b) {
      each_cell(boxes[b], reach, [&](std::size_t c) { items_[next[c]++] = static_cast<int>(b); });
    }
  }

  std::array<int, 3> cell_at(const Vec3& p) const {
    std::array<int, 3> cell;
    for (int axis = 0; axis < 3; ++axis) {
      cell[axis] =
          std::clamp(static_cast<int>((p[axis] - origin_[axis]) / cell_), 0, size_[axis] - 1);
    }
    return cell;
  }

  template <typename Visit>
  void each_cell(const Box& box, double reach, const Visit& visit) const {
    const auto low = cell_at(box.low - Vec3::Constant(reach));
    const auto high = cell_at(box.high + Vec3::Constant(reach));
    for (int k = low[2]; k <= high[2]; ++k) {
      for (int j = low[1]; j <= high[1]; ++j) {
        for (int i = low[0]; i <= high[0]; ++i) visit(index({i, j, k}));
      }
    }
  }

  std::size_t index(const std::array<int, 3>& cell) const {
    return (static_cast<std::size_t>(cell[2]) * size_[1] + cell[1]) * size_[0] + cell[0];
  }

  template <typename Visit>
  void each_item(std::size_t cell, const Visit& visit) const {
    for (int i = first_[cell]; i < first_[cell + 1]; ++i) visit(items_[i]);
  }

 private:
  Vec3 origin_;
  double cell_;
  std::array<int, 3> size_;
  std::vector<int> first_;
  std::vector<int> items_;
};

std::vector<std::array<int, 2>> edges_of(const std::vector<Triangle>& triangles) {
  std::vector<std::array<int, 2>> edges;
  for (const Triangle& t : triangles) {
    for (int i = 0; i < 3; ++i) {
      const int a = t[i];
      const int b = t[(i + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

struct Found {
  ContactPair pair;
  double distance;
};

/// Runs `search(item, found)` for every item, in chunks side by side, and joins what they found.
template <typename Search>
void search_in_chunks(int items, std::vector<Found>& all, const Search& search) {
  std::vector<std::vector<Found>> found((items + chunk - 1) / chunk);
  tbb::parallel_for(0, static_cast<int>(found.size()), [&](int c) {
    const int end = std::min((c + 1) * chunk, items);
    for (int item = c * chunk; item < end; ++item) search(item, found[c]);
  });
  for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
}

}  // namespace

NearestPoints nearest_points(const ContactPair& pair, const std::vector<Vec3>& x) {
  const auto& v = pair.vertices;
  NearestPoints nearest;
  if (pair.edges) {
    const auto [s, t] = nearest_on_segments(x[v[0]], x[v[1]], x[v[2]], x[v[3]]);
    nearest.weights = {1 - s, s, t - 1, -t};
  } else {
    const Vec3 w = nearest_on_triangle(x[v[0]], x[v[1]], x[v[2]], x[v[3]]);
    nearest.weights = {1, -w[0], -w[1], -w[2]};
  }
  nearest.apart = nearest.weights[0] * x[v[0]] + nearest.weights[1] * x[v[1]] +
                  nearest.weights[2] * x[v[2]] + nearest.weights[3] * x[v[3]];
  return nearest;
}

ContactPush contact_push(double distance, double gap, bool barrier) {
  if (distance >= gap) return {};
  const double half = 0.5 * gap;
  if (distance >= half || !barrier) return {push_stiffness * (gap - distance), push_stiffness};
  const double d = std::max(distance, least_distance);
  return {push_stiffness * half * half / d, push_stiffness * half * half / (d * d)};
}

ProximitySearch::ProximitySearch(const std::vector<Triangle>& triangles,
                                 const std::vector<int>& node,
                                 const std::vector<double>& shortest_edge)
    : triangles_(triangles),
      edges_(edges_of(triangles)),
      moving_vertices_(static_cast<int>(node.size())),
      moving_triangles_(static_cast<int>(triangles.size())),
      moving_edges_(static_cast<int>(edges_.size())),
      node_(node),
      shortest_edge_(shortest_edge) {
  std::vector<std::array<int, 2>> links;  // between nodes, both ways
  for (const auto& [a, b] : edges_) {
    links.push_back({node[a], node[b]});
    links.push_back({node[b], node[a]});
  }
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  const int nodes = node.empty() ? 0 : *std::max_element(node.begin(), node.end()) + 1;
  ring_first_.assign(nodes + 1, 0);
  for (const auto& link : links) {
    ++ring_first_[link[0] + 1];
    ring_.push_back(link[1]);
  }
  std::partial_sum(ring_first_.begin(), ring_first_.end(), ring_first_.begin());
}

void ProximitySearch::add_layer(const std::vector<Triangle>& triangles, int vertices, double gap) {
  const int first = static_cast<int>(node_.size());
  layer_gap_ = gap;
  for (const Triangle& t : triangles) {
    triangles_.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  for (const auto& [a, b] : edges_of(triangles)) edges_.push_back({a + first, b + first});
  // Nodes of their own, that are nobody's neighbours.
  int node = static_cast<int>(ring_first_.size()) - 1;
  for (int v = 0; v < vertices; ++v) node_.push_back(node++);
  ring_first_.resize(ring_first_.size() + vertices, ring_first_.back());
  shortest_edge_.resize(node_.size(), 0);
}

bool ProximitySearch::neighbours(int a, int b) const {
  const int n = node_[a];
  return std::binary_search(ring_.begin() + ring_first_[n], ring_.begin() + ring_first_[n + 1],
                            node_[b]);
}

bool ProximitySearch::neighbours(const ContactPair& pair) const {
  const auto& v = pair.vertices;
  return pair.edges ? neighbours(v[0], v[2]) || neighbours(v[0], v[3]) || neighbours(v[1], v[2]) ||
                          neighbours(v[1], v[3])
                    : neighbours(v[0], v[1]) || neighbours(v[0], v[2]) || neighbours(v[0], v[3]);
}

double ProximitySearch::neighbour_gap(const ContactPair& pair) const {
  double shortest = shortest_edge_[pair.vertices[0]];
  for (const int v : pair.vertices) shortest = std::min(shortest, shortest_edge_[v]);
  return neighbour_share * shortest;
}

void ProximitySearch::find(const std::vector<Vec3>& x, double radius, double gap,
                           std::vector<ContactPair>& pairs, std::vector<double>& bound,
                           bool skip_neighbours) const {
  std::vector<Found> all;
  const auto consider = [&](const ContactPair& pair, std::vector<Found>& found) {
    const double distance = nearest_points(pair, x).apart.norm();
    if (distance < radius) found.push_back({pair, distance});
  };

  std::vector<Box> boxes(triangles_.size());
  for (std::size_t t = 0; t < boxes.size(); ++t) boxes[t] = box_of(triangles_[t], x);
  {
    const CellGrid grid(boxes, radius);
    search_in_chunks(static_cast<int>(x.size()), all, [&](int v, std::vector<Found>& found) {
      const Box here{x[v], x[v]};
      grid.each_item(grid.index(grid.cell_at(x[v])), [&](int t) {
        if (of_layer(v) && t >= moving_triangles_) return;
        const Triangle& c = triangles_[t];
        if (!boxes[t].meets(here, radius)) return;
        if (same_node(c[0], v) || same_node(c[1], v) || same_node(c[2], v)) return;
        consider({{v, c[0], c[1], c[2]}, false, 0}, found);
      });
    });
  }

  boxes.resize(edges_.size());
  for (std::size_t e = 0; e < boxes.size(); ++e) boxes[e] = box_of(edges_[e], x);
  const CellGrid grid(boxes, 0.5 * radius);
  // A layer's edges come after the surface's own, and are found from there.
  search_in_chunks(moving_edges_, all, [&](int e, std::vector<Found>& found) {
    grid.each_cell(boxes[e], 0.5 * radius, [&](std::size_t cell) {
      grid.each_item(cell, [&](int f) {
        if (f <= e) return;
        const auto& a = edges_[e];
        const auto& b = edges_[f];
        if (!boxes[e].meets(boxes[f], radius)) return;
        if (same_node(a[0], b[0]) || same_node(a[0], b[1]) || same_node(a[1], b[0]) ||
            same_node(a[1], b[1])) {
          return;
        }
        // Both lie in several cells: the one at the low corner of their overlap reports them.
        const Vec3 corner = boxes[e].low.cwiseMax(boxes[f].low) - Vec3::Constant(0.5 * radius);
        if (grid.index(grid.cell_at(corner)) != cell) return;
        consider({{a[0], a[1], b[0], b[1]}, true, 0}, found);
      });
    });
  });

  pairs.clear();
  bound.assign(x.size(), bound_share * radius);
  for (Found& f : all) {
    if (of_layer(f.pair)) {
      for (const int v : f.pair.vertices) {
        bound[v] = std::min(bound[v], bound_share * f.distance);
      }
      f.pair.gap = layer_gap_;
      if ((1 - bound_share) * f.distance < layer_gap_) pairs.push_back(f.pair);
      continue;
    }
    const bool near_in_mesh = neighbours(f.pair);
    if (near_in_mesh && skip_neighbours) continue;
    for (const int v : f.pair.vertices) {
      bound[v] = std::min(bound[v], bound_share * f.distance);
    }
    f.pair.gap = near_in_mesh ? std::min(gap, neighbour_gap(f.pair)) : gap;
    // Neighbours that can't touch before the next search need no force.
    if (!near_in_mesh || f.distance < 3 * f.pair.gap) pairs.push_back(f.pair);
  }
}

}  // namespace toile
