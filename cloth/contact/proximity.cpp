#include "cloth/contact/proximity.h"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "cloth/contact/sphere_grid.h"
#include "geometry/closest_points.h"
#include "geometry/half_edges.h"

namespace toile {

namespace {

/// Share of the distance to the nearest thing that a vertex may move: both sides move, so just
/// under a half.
constexpr double bound_share = 0.45;
/// Share of its bound that a vertex has used up when an update looks at it anew.
constexpr double used_share = 0.4;
/// Where more vertices than this have, all are looked at.
constexpr double max_updated = 0.25;
/// Share of the shortest edge at rest that neighbours in the mesh may come near each other.
constexpr double neighbour_share = 0.25;
/// N/m, per pair.
constexpr double push_stiffness = 200;
/// Metres; below it, forces grow no more.
constexpr double min_distance = 1e-9;
/// Vertices or edges that one task looks up; fixed, so that results don't depend on the threads.
constexpr std::size_t chunk = 128;

SphereGrid::Sphere sphere_around(const std::array<int, 2>& edge, const std::vector<Vec3>& x) {
  const Vec3 centre = 0.5 * (x[edge[0]] + x[edge[1]]);
  return {centre, (x[edge[0]] - centre).norm()};
}

/// Not the least one, but a triangle lies within.
SphereGrid::Sphere sphere_around(const Triangle& t, const std::vector<Vec3>& x) {
  const Vec3 centre = (x[t[0]] + x[t[1]] + x[t[2]]) / 3;
  return {centre,
          std::sqrt(std::max({(x[t[0]] - centre).squaredNorm(), (x[t[1]] - centre).squaredNorm(),
                              (x[t[2]] - centre).squaredNorm()}))};
}

template <typename Shape>
std::vector<SphereGrid::Sphere> spheres_around(const std::vector<Shape>& shapes,
                                               const std::vector<Vec3>& x) {
  std::vector<SphereGrid::Sphere> spheres;
  spheres.reserve(shapes.size());
  for (const Shape& shape : shapes) spheres.push_back(sphere_around(shape, x));
  return spheres;
}

/// Runs `search(item, found)` for every item, in chunks side by side, and joins what they found.
template <typename NearPairs, typename Search>
NearPairs search_in_chunks(std::size_t items, const Search& search) {
  std::vector<NearPairs> found((items + chunk - 1) / chunk);
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t c) {
    const std::size_t end = std::min((c + 1) * chunk, items);
    for (std::size_t item = c * chunk; item < end; ++item) search(item, found[c]);
  });
  NearPairs all;
  for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// Whether boxes tell already that the two sides of a pair are `reach` apart or more.
bool boxes_apart(const ContactPair& pair, const std::vector<Vec3>& x, double reach) {
  const auto& [a, b, c, d] = pair.vertices;
  const Vec3 first_low = pair.edges ? x[a].cwiseMin(x[b]) : x[a];
  const Vec3 first_high = pair.edges ? x[a].cwiseMax(x[b]) : x[a];
  Vec3 second_low = x[c].cwiseMin(x[d]);
  Vec3 second_high = x[c].cwiseMax(x[d]);
  if (!pair.edges) {
    second_low = second_low.cwiseMin(x[b]);
    second_high = second_high.cwiseMax(x[b]);
  }
  return ((first_low - second_high).array() >= reach).any() ||
         ((second_low - first_high).array() >= reach).any();
}

template <std::size_t N>
bool any_of(const std::vector<char>& wanted, const std::array<int, N>& corners) {
  return std::any_of(corners.begin(), corners.end(), [&](int v) { return wanted[v] != 0; });
}

}  // namespace

NearestPoints nearest_points(bool edges, const std::array<Vec3, 4>& at) {
  NearestPoints nearest;
  if (edges) {
    const auto [s, t] = closest_on_segments(at[0], at[1], at[2], at[3]);
    nearest.weights = {1 - s, s, t - 1, -t};
  } else {
    const Vec3 w = closest_on_triangle(at[0], at[1], at[2], at[3]);
    nearest.weights = {1, -w[0], -w[1], -w[2]};
  }
  nearest.apart = nearest.weights[0] * at[0] + nearest.weights[1] * at[1] +
                  nearest.weights[2] * at[2] + nearest.weights[3] * at[3];
  return nearest;
}

NearestPoints nearest_points(const ContactPair& pair, const std::vector<Vec3>& x) {
  const auto& v = pair.vertices;
  return nearest_points(pair.edges, {x[v[0]], x[v[1]], x[v[2]], x[v[3]]});
}

ContactPush contact_push(double distance, double gap, bool barrier, double early) {
  if (distance >= gap + early) return {};
  if (distance >= gap) return {0, push_stiffness, 0};
  const double half = 0.5 * gap;
  if (distance >= half || !barrier) {
    const double depth = gap - distance;
    return {push_stiffness * depth, push_stiffness, 0.5 * push_stiffness * depth * depth};
  }
  const double d = std::max(distance, min_distance);
  const double scale = push_stiffness * half * half;
  return {scale / d, scale / (d * d), scale * (0.5 + std::log(half / d))};
}

ProximitySearch::ProximitySearch(const std::vector<Triangle>& triangles,
                                 const std::vector<int>& node,
                                 const std::vector<double>& shortest_edge)
    : triangles_(triangles),
      edges_(unique_edges(triangles)),
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
  for (const auto& [a, b] : unique_edges(triangles)) edges_.push_back({a + first, b + first});
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

double ProximitySearch::gap_to_keep(const NearPair& found, double gap) const {
  if (of_layer(found.pair)) {
    return (1 - bound_share) * found.distance < layer_gap_ ? layer_gap_ : -1;
  }
  if (!neighbours(found.pair)) return gap;
  // Neighbours that can't touch before the next search need no force.
  const double kept = std::min(gap, neighbour_gap(found.pair));
  return found.distance < 3 * kept ? kept : -1;
}

void ProximitySearch::consider(const ContactPair& pair, const Query& query,
                               NearPairs& found) const {
  if (boxes_apart(pair, query.x, query.radius)) return;
  const double distance = nearest_points(pair, query.x).apart.norm();
  if (distance < query.radius) found.push_back({pair, distance});
}

void ProximitySearch::point_and_triangle(int v, int t, const Query& query, NearPairs& found) const {
  if (of_layer(v) && t >= moving_triangles_) return;
  const Triangle& c = triangles_[t];
  if (same_node(c[0], v) || same_node(c[1], v) || same_node(c[2], v)) return;
  consider({{v, c[0], c[1], c[2]}, false, 0}, query, found);
}

void ProximitySearch::two_edges(int e, int f, const Query& query, NearPairs& found) const {
  // A layer's edges come after the surface's own.
  if (e >= moving_edges_) return;
  const auto& a = edges_[e];
  const auto& b = edges_[f];
  if (same_node(a[0], b[0]) || same_node(a[0], b[1]) || same_node(a[1], b[0]) ||
      same_node(a[1], b[1])) {
    return;
  }
  consider({{a[0], a[1], b[0], b[1]}, true, 0}, query, found);
}

ProximitySearch::NearPairs ProximitySearch::triangles_near_vertices(const Query& query) const {
  const SphereGrid grid(spheres_around(triangles_, query.x), query.radius);
  return search_in_chunks<NearPairs>(query.x.size(), [&](std::size_t v, NearPairs& found) {
    if (!query.wants(v)) return;
    grid.near(query.x[v], 0,
              [&](int t) { point_and_triangle(static_cast<int>(v), t, query, found); });
  });
}

ProximitySearch::NearPairs ProximitySearch::others_near_wanted_triangles(const Query& query) const {
  std::vector<SphereGrid::Sphere> points;
  points.reserve(query.x.size());
  for (const Vec3& p : query.x) points.push_back({p, 0});
  const SphereGrid grid(points, query.radius);
  return search_in_chunks<NearPairs>(triangles_.size(), [&](std::size_t t, NearPairs& found) {
    if (!any_of(query.wanted, triangles_[t])) return;
    const SphereGrid::Sphere around = sphere_around(triangles_[t], query.x);
    grid.near(around.centre, around.radius, [&](int v) {
      if (!query.wants(v)) point_and_triangle(v, static_cast<int>(t), query, found);
    });
  });
}

ProximitySearch::NearPairs ProximitySearch::edges_near_edges(const Query& query) const {
  const std::vector<SphereGrid::Sphere> edges = spheres_around(edges_, query.x);
  const SphereGrid grid(edges, query.radius);
  if (query.wanted.empty()) {
    return search_in_chunks<NearPairs>(grid.parts(), [&](std::size_t part, NearPairs& found) {
      grid.pairs(part, [&](int e, int f) { two_edges(e, f, query, found); });
    });
  }
  return search_in_chunks<NearPairs>(edges_.size(), [&](std::size_t i, NearPairs& found) {
    const int e = static_cast<int>(i);
    if (!any_of(query.wanted, edges_[e])) return;
    grid.near(edges[e].centre, edges[e].radius, [&](int f) {
      if (f == e || (f < e && any_of(query.wanted, edges_[f]))) return;
      two_edges(std::min(e, f), std::max(e, f), query, found);
    });
  });
}

ProximitySearch::NearPairs ProximitySearch::near_pairs(const Query& query) const {
  NearPairs all;
  NearPairs of_others;
  NearPairs of_edges;
  tbb::parallel_invoke([&] { all = triangles_near_vertices(query); },
                       [&] {
                         if (!query.wanted.empty()) of_others = others_near_wanted_triangles(query);
                       },
                       [&] { of_edges = edges_near_edges(query); });
  all.insert(all.end(), of_others.begin(), of_others.end());
  all.insert(all.end(), of_edges.begin(), of_edges.end());
  return all;
}

void ProximitySearch::find(const std::vector<Vec3>& x, double radius, double gap,
                           std::vector<ContactPair>& pairs, std::vector<double>& bound,
                           bool skip_neighbours) const {
  pairs.clear();
  bound.assign(x.size(), bound_share * radius);
  for (NearPair& found : near_pairs({x, radius, {}})) {
    if (skip_neighbours && !of_layer(found.pair) && neighbours(found.pair)) continue;
    for (const int v : found.pair.vertices) {
      bound[v] = std::min(bound[v], bound_share * found.distance);
    }
    found.pair.gap = gap_to_keep(found, gap);
    if (found.pair.gap > 0) pairs.push_back(found.pair);
  }
}

void ProximitySearch::update(const std::vector<Vec3>& x, double radius, double gap,
                             std::vector<ContactPair>& pairs, std::vector<double>& bound,
                             std::vector<Vec3>& at, bool skip_neighbours) const {
  std::vector<char> moved(x.size(), 0);
  std::size_t count = 0;
  for (int v = 0; v < moving_vertices_; ++v) {
    moved[v] = (x[v] - at[v]).norm() >= used_share * bound[v];
    count += moved[v];
  }
  if (count > max_updated * moving_vertices_) {
    find(x, radius, gap, pairs, bound, skip_neighbours);
    at = x;
    return;
  }
  std::erase_if(pairs, [&](const ContactPair& pair) { return any_of(moved, pair.vertices); });
  for (std::size_t v = 0; v < x.size(); ++v) {
    if (moved[v] == 0) continue;
    at[v] = x[v];
    bound[v] = bound_share * radius;
  }
  // One that keeps its bound may still go as far as its whole width from where it is now.
  const double search_radius = bound_share * (2 + used_share) * 1.02 * radius;
  for (NearPair& found : near_pairs({x, search_radius, moved})) {
    if (skip_neighbours && !of_layer(found.pair) && neighbours(found.pair)) continue;
    const double limit = bound_share * found.distance;
    for (const int v : found.pair.vertices) {
      if (moved[v] == 0 && !of_layer(v)) {
        const double used = (x[v] - at[v]).norm();
        // The other side keeps to `limit`.
        if (bound[v] + used <= found.distance - limit) continue;
        bound[v] = std::max(bound[v] - used, 0.0);
        at[v] = x[v];
      }
      bound[v] = std::min(bound[v], limit);
    }
    if (found.distance >= radius) continue;
    found.pair.gap = gap_to_keep(found, gap);
    if (found.pair.gap > 0) pairs.push_back(found.pair);
  }
}

}  // namespace toile
