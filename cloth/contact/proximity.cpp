#include "cloth/contact/proximity.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "cloth/contact/box_grid.h"
#include "cloth/contact/constants.h"
#include "geometry/closest_points.h"
#include "geometry/half_edges.h"
#include "geometry/parallel.h"

namespace toile {

namespace {

/// Metres below which forces do not grow any more.
constexpr double min_distance = 1e-9;
/// Metres that bounds leave between two sides, far above what rounding does to coordinates. Under a
/// hard pull each search leaves a tenth of a distance. Where that is as small as rounding errors,
/// the sides pass each other.
constexpr double last_distance = 1e-12;
/// Metres from which on last_distance is a share of a distance that is worth taking off.
constexpr double narrow_distance = 100 * last_distance;
/// Metres that sides nearer than last_distance may move, so that they get free again.
constexpr double freeing_distance = 1e-15;
/// Vertices or edges that one task searches around. It is fixed, so that results don't depend on
/// the threads.
constexpr std::size_t chunk = 128;

BoxGrid::Shape shape_of(const std::array<int, 2>& edge, const std::vector<Vec3>& x) {
  const Vec3& a = x[edge[0]];
  const Vec3& b = x[edge[1]];
  const Vec3 centre = 0.5 * (a + b);
  return {centre, (a - centre).norm(), {a.cwiseMin(b), a.cwiseMax(b)}};
}

BoxGrid::Box box_of(const Triangle& t, const std::vector<Vec3>& x) {
  return {x[t[0]].cwiseMin(x[t[1]]).cwiseMin(x[t[2]]), x[t[0]].cwiseMax(x[t[1]]).cwiseMax(x[t[2]])};
}

/// Its sphere is not the smallest one.
BoxGrid::Shape shape_of(const Triangle& t, const std::vector<Vec3>& x) {
  const Vec3 centre = (x[t[0]] + x[t[1]] + x[t[2]]) / 3;
  return {centre,
          std::sqrt(std::max({(x[t[0]] - centre).squaredNorm(), (x[t[1]] - centre).squaredNorm(),
                              (x[t[2]] - centre).squaredNorm()})),
          box_of(t, x)};
}

template <typename Item>
std::vector<BoxGrid::Shape> shapes_of(const std::vector<Item>& items, const std::vector<Vec3>& x) {
  std::vector<BoxGrid::Shape> shapes;
  shapes.reserve(items.size());
  for (const Item& item : items) shapes.push_back(shape_of(item, x));
  return shapes;
}

/// Calls `search(item, scratch, found)` for each item, in parallel, and joins what the chunks
/// found. Work is uneven, so threads take chunks from each other.
template <typename NearPairs, typename Search>
NearPairs search_in_chunks(std::size_t items, const Search& search) {
  std::vector<NearPairs> found(chunks_of(items, chunk));
  parallel_for_ranges(items, chunk, [&](std::size_t begin, std::size_t end) {
    BoxGrid::Scratch scratch;
    for (std::size_t item = begin; item < end; ++item) search(item, scratch, found[begin / chunk]);
  });
  NearPairs all;
  for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// Whether the boxes around the two sides of a pair are `reach` metres apart or more.
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

/// Metres that the vertices of a pair may move, whose two sides are `distance` metres apart.
double bound_of(double distance) {
  if (distance < narrow_distance) distance = std::max(distance - last_distance, freeing_distance);
  return proximity_bound_share * distance;
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

DistanceBounds distance_bounds(const ContactPair& pair, const std::array<Vec3, 4>& at) {
  const auto& w = pair.nearest;
  // One is positive: a vertex has 1, of two ends of an edge the weights add up to 1.
  if (w[0] <= 0 && w[1] <= 0) return {};
  // The weights of all four add up to 0, so the first vertex may be the origin.
  const Vec3 b = at[1] - at[0];
  const Vec3 c = at[2] - at[0];
  const Vec3 d = at[3] - at[0];
  const Vec3 apart = w[1] * b + w[2] * c + w[3] * d;
  const double length = apart.norm();
  if (length <= 0) return {};
  // The points that were nearest still lie on the two sides. Planes across what lies between them
  // may still part the sides.
  const double on_b = apart.dot(b);
  const double others = std::max(apart.dot(c), apart.dot(d));
  const double parted = pair.edges ? std::min(0.0, on_b) - others : -std::max(on_b, others);
  return {parted / length, length};
}

bool is_nearer(ContactPair& pair, const std::vector<Vec3>& x, double reach) {
  const auto& v = pair.vertices;
  const std::array<Vec3, 4> at = {x[v[0]], x[v[1]], x[v[2]], x[v[3]]};
  const DistanceBounds bounds = distance_bounds(pair, at);
  if (bounds.most < reach - last_nearest_slack) return true;
  if (bounds.least > reach + last_nearest_slack) return false;
  const NearestPoints found = nearest_points(pair.edges, at);
  keep_nearest(found, pair);
  return found.apart.squaredNorm() < reach * reach;
}

ContactPush contact_push(double distance, double gap, bool barrier, double early) {
  if (distance >= gap + early) return {};
  if (distance >= gap) return {0, pair_push_stiffness, 0};
  const double half = 0.5 * gap;
  if (distance >= half || !barrier) {
    const double depth = gap - distance;
    return {pair_push_stiffness * depth, pair_push_stiffness,
            0.5 * pair_push_stiffness * depth * depth};
  }
  const double d = std::max(distance, min_distance);
  const double scale = pair_push_stiffness * half * half;
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
  nodes_ = node.empty() ? 0 : *std::max_element(node.begin(), node.end()) + 1;
  std::vector<std::array<int, 2>> pairs;  // of nodes, in both orders
  for (const auto& [a, b] : edges_) {
    pairs.push_back({node[a], node[b]});
    pairs.push_back({node[b], node[a]});
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  neighbours_.assign(nodes_, [&](const auto& add) {
    for (const auto& [a, b] : pairs) add(a, b);
  });
}

void ProximitySearch::add_layer(const std::vector<Triangle>& triangles, int vertices, double gap) {
  const int first = static_cast<int>(node_.size());
  layer_gap_ = gap;
  for (const Triangle& t : triangles) {
    triangles_.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  for (const auto& [a, b] : unique_edges(triangles)) edges_.push_back({a + first, b + first});
  // Each vertex of a layer is a node without neighbours.
  for (int v = 0; v < vertices; ++v) node_.push_back(nodes_++);
  shortest_edge_.resize(node_.size(), 0);
}

bool ProximitySearch::neighbours(int a, int b) const {
  const auto n = static_cast<std::size_t>(node_[a]);
  return n < neighbours_.size() && std::ranges::binary_search(neighbours_[n], node_[b]);
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
  return neighbour_gap_share * shortest;
}

double ProximitySearch::gap_to_keep(const NearPair& found, double gap) const {
  if (of_layer(found.pair)) {
    return (1 - proximity_bound_share) * found.distance < layer_gap_ ? layer_gap_ : -1;
  }
  if (!neighbours(found.pair)) return gap;
  // Neighbours that cannot touch before the next search need no force.
  const double kept = std::min(gap, neighbour_gap(found.pair));
  return found.distance < neighbour_force_range * kept ? kept : -1;
}

void ProximitySearch::consider(const ContactPair& pair, const Query& query,
                               NearPairs& found) const {
  if (boxes_apart(pair, query.x, query.radius)) return;
  const NearestPoints nearest = nearest_points(pair, query.x);
  const double distance = nearest.apart.norm();
  if (distance >= query.radius) return;
  found.push_back({pair, distance});
  keep_nearest(nearest, found.back().pair);
}

void ProximitySearch::point_and_triangle(int v, int t, const Query& query, NearPairs& found) const {
  if (of_layer(v) && t >= moving_triangles_) return;
  const Triangle& c = triangles_[t];
  if (same_node(c[0], v) || same_node(c[1], v) || same_node(c[2], v)) return;
  consider({{v, c[0], c[1], c[2]}, false, 0}, query, found);
}

void ProximitySearch::two_edges(int e, int f, const Query& query, NearPairs& found) const {
  // Edges of layers come after those of the surface.
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
  const BoxGrid grid(shapes_of(triangles_, query.x), query.radius);
  return search_in_chunks<NearPairs>(
      query.x.size(), [&](std::size_t v, BoxGrid::Scratch& scratch, NearPairs& found) {
        if (!query.wants(v)) return;
        grid.near({query.x[v], query.x[v]}, scratch,
                  [&](int t) { point_and_triangle(static_cast<int>(v), t, query, found); });
      });
}

ProximitySearch::NearPairs ProximitySearch::others_near_wanted_triangles(const Query& query) const {
  std::vector<BoxGrid::Shape> points;
  points.reserve(query.x.size());
  for (const Vec3& p : query.x) points.push_back({p, 0, {p, p}});
  const BoxGrid grid(points, query.radius);
  return search_in_chunks<NearPairs>(
      triangles_.size(), [&](std::size_t t, BoxGrid::Scratch& scratch, NearPairs& found) {
        if (!any_of(query.wanted, triangles_[t])) return;
        grid.near(box_of(triangles_[t], query.x), scratch, [&](int v) {
          if (!query.wants(v)) point_and_triangle(v, static_cast<int>(t), query, found);
        });
      });
}

ProximitySearch::NearPairs ProximitySearch::edges_near_edges(const Query& query) const {
  const std::vector<BoxGrid::Shape> edges = shapes_of(edges_, query.x);
  const BoxGrid grid(edges, query.radius);
  if (query.wanted.empty()) {
    return search_in_chunks<NearPairs>(
        grid.parts(), [&](std::size_t part, BoxGrid::Scratch& scratch, NearPairs& found) {
          grid.pairs(part, scratch, [&](int e, int f) { two_edges(e, f, query, found); });
        });
  }
  std::vector<char> wanted(edges_.size());
  for (std::size_t e = 0; e < edges_.size(); ++e) wanted[e] = any_of(query.wanted, edges_[e]);
  return search_in_chunks<NearPairs>(
      edges_.size(), [&](std::size_t i, BoxGrid::Scratch& scratch, NearPairs& found) {
        const int e = static_cast<int>(i);
        if (wanted[e] == 0) return;
        grid.near(edges[e].box, scratch, [&](int f) {
          if (f == e || (f < e && wanted[f] != 0)) return;
          two_edges(std::min(e, f), std::max(e, f), query, found);
        });
      });
}

ProximitySearch::NearPairs ProximitySearch::near_pairs(const Query& query) const {
  NearPairs all;
  NearPairs of_others;
  NearPairs of_edges;
  parallel_invoke([&] { all = triangles_near_vertices(query); },
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
  bound.assign(x.size(), proximity_bound_share * radius);
  for (NearPair& found : near_pairs({x, radius, {}})) {
    if (skip_neighbours && !of_layer(found.pair) && neighbours(found.pair)) continue;
    for (const int v : found.pair.vertices) {
      bound[v] = std::min(bound[v], bound_of(found.distance));
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
    moved[v] = (x[v] - at[v]).norm() >= stale_bound_share * bound[v];
    count += moved[v];
  }
  if (count > max_partial_update * moving_vertices_) {
    find(x, radius, gap, pairs, bound, skip_neighbours);
    at = x;
    return;
  }
  std::erase_if(pairs, [&](const ContactPair& pair) { return any_of(moved, pair.vertices); });
  for (std::size_t v = 0; v < x.size(); ++v) {
    if (moved[v] == 0) continue;
    at[v] = x[v];
    bound[v] = proximity_bound_share * radius;
  }
  // On both sides a vertex may have kept its bound, and still move by the whole width of it. The
  // factor is above what rounding can do.
  constexpr double search_slack = 1.02;
  const double search_radius =
      proximity_bound_share * 2 * (1 + stale_bound_share) * search_slack * radius;
  for (NearPair& found : near_pairs({x, search_radius, moved})) {
    if (skip_neighbours && !of_layer(found.pair) && neighbours(found.pair)) continue;
    const double limit = bound_of(found.distance);
    // How far each side may still go, by its vertex that may go farthest.
    std::array<double, 2> reach = {limit, limit};
    for (std::size_t i = 0; i < 4; ++i) {
      const int v = found.pair.vertices[i];
      if (moved[v] != 0 || of_layer(v)) continue;
      double& of_side = reach[i < (found.pair.edges ? 2u : 1u) ? 0 : 1];
      of_side = std::max(of_side, bound[v] + (x[v] - at[v]).norm());
    }
    const bool stay_apart = reach[0] + reach[1] <= found.distance;
    for (const int v : found.pair.vertices) {
      if (moved[v] == 0 && !of_layer(v)) {
        const double used = (x[v] - at[v]).norm();
        if (stay_apart || bound[v] + used <= limit) continue;
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
