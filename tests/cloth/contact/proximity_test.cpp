#include "cloth/contact/proximity.h"

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "geometry/intersections.h"
#include "tests/cloth/panels.h"

namespace toile {
namespace proximity_test {

using Key = std::array<int, 5>;

Key key_of(const ContactPair& pair) {
  auto v = pair.vertices;
  if (pair.edges) {
    if (v[0] > v[1]) std::swap(v[0], v[1]);
    if (v[2] > v[3]) std::swap(v[2], v[3]);
    if (std::pair(v[0], v[1]) > std::pair(v[2], v[3])) v = {v[2], v[3], v[0], v[1]};
  } else {
    std::sort(v.begin() + 1, v.end());
  }
  return {pair.edges ? 1 : 0, v[0], v[1], v[2], v[3]};
}

/// A surface to search. Its shortest edge at rest is the same at all vertices.
struct Surface {
  std::vector<Triangle> triangles;
  std::vector<Vec3> x;
  std::vector<int> node;
  double shortest_edge = 0.01;

  ProximitySearch search() const {
    return {triangles, node, std::vector<double>(x.size(), shortest_edge)};
  }

  bool apart(const std::vector<int>& a, const std::vector<int>& b) const {
    for (const int p : a) {
      for (const int q : b) {
        if (node[p] == node[q]) return false;
      }
    }
    return true;
  }

  /// All pairs nearer than `radius` metres, and their distances. O(n²).
  std::map<Key, double> all_pairs(double radius) const {
    std::map<Key, double> pairs;
    std::set<std::pair<int, int>> edges;
    for (const Triangle& t : triangles) {
      for (int i = 0; i < 3; ++i) edges.insert(std::minmax(t[i], t[(i + 1) % 3]));
      for (int v = 0; v < static_cast<int>(x.size()); ++v) {
        if (apart({v}, {t[0], t[1], t[2]})) add({{v, t[0], t[1], t[2]}, false, 0}, radius, pairs);
      }
    }
    for (auto e = edges.begin(); e != edges.end(); ++e) {
      for (auto f = std::next(e); f != edges.end(); ++f) {
        if (!apart({e->first, e->second}, {f->first, f->second})) continue;
        add({{e->first, e->second, f->first, f->second}, true, 0}, radius, pairs);
      }
    }
    return pairs;
  }

 private:
  void add(const ContactPair& pair, double radius, std::map<Key, double>& pairs) const {
    const double distance = nearest_points(pair, x).apart.norm();
    if (distance < radius) pairs[key_of(pair)] = distance;
  }
};

Surface with_own_nodes(Surface surface) {
  surface.node.resize(surface.x.size());
  std::iota(surface.node.begin(), surface.node.end(), 0);
  return surface;
}

/// Loose triangles of 1 cm in a box of 8 cm.
Surface soup(int triangles, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] { return Vec3(unit(random), unit(random), unit(random)); };
  Surface surface;
  for (int t = 0; t < triangles; ++t) {
    const Vec3 middle = 0.04 * vector();
    for (int i = 0; i < 3; ++i) surface.x.push_back(middle + 0.01 * vector());
    surface.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return with_own_nodes(surface);
}

/// A rough sheet of 1 cm squares, folded twice like a letter. Its layers are `gap` metres apart.
Surface folded(double gap, double roughness, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  const int columns = 24;
  const PlanarMesh mesh = test::grid(0.24, 0.08, columns, 8);
  Surface surface;
  surface.triangles = mesh.triangles;
  for (const Vec2& p : mesh.points) {
    const int layer = std::min(static_cast<int>(p.x() / 0.0801), 2);
    const double along = p.x() - 0.08 * layer;
    const double x = layer == 1 ? 0.08 - along : along;
    surface.x.emplace_back(x + roughness * unit(random), p.y() + roughness * unit(random),
                           gap * layer + 0.3 * gap * unit(random));
  }
  return with_own_nodes(surface);
}

TEST(DistanceBounds, HoldTheDistanceOfAPairThatMoves) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<Vec3> x(4);
    for (Vec3& p : x) p = Vec3(1.5, 1, 1) + 0.01 * Vec3(unit(random), unit(random), unit(random));
    ContactPair pair = {{0, 1, 2, 3}, trial % 2 == 0, 0};
    const DistanceBounds unknown = distance_bounds(pair, {x[0], x[1], x[2], x[3]});
    EXPECT_EQ(unknown.least, 0);
    EXPECT_TRUE(std::isinf(unknown.most));
    const NearestPoints nearest = nearest_points(pair, x);
    keep_nearest(nearest, pair);
    // The planes across the shortest way part both sides: without motion the bounds are exact.
    const DistanceBounds exact = distance_bounds(pair, {x[0], x[1], x[2], x[3]});
    EXPECT_NEAR(exact.least, nearest.apart.norm(), last_nearest_slack);
    EXPECT_NEAR(exact.most, nearest.apart.norm(), last_nearest_slack);
    for (int step = 0; step < 10; ++step) {
      const double distance = nearest_points(pair, x).apart.norm();
      const DistanceBounds bounds = distance_bounds(pair, {x[0], x[1], x[2], x[3]});
      EXPECT_LE(bounds.least, distance + last_nearest_slack);
      EXPECT_GE(bounds.most, distance - last_nearest_slack);
      for (const double share : {0.5, 0.99, 1.01, 2.0}) {
        ContactPair asked = pair;
        EXPECT_EQ(is_nearer(asked, x, share * distance), distance < share * distance);
      }
      for (Vec3& p : x) p += 2e-4 * Vec3(unit(random), unit(random), unit(random));
    }
  }
}

TEST(NearestPoints, NoSampledPointIsNearer) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Vec3> x(4);
    for (Vec3& p : x) p = Vec3(unit(random), unit(random), unit(random));
    for (const bool edges : {false, true}) {
      const NearestPoints nearest = nearest_points({{0, 1, 2, 3}, edges, 0}, x);
      const auto& w = nearest.weights;
      Vec3 sum = Vec3::Zero();
      for (int i = 0; i < 4; ++i) sum += w[i] * x[i];
      EXPECT_LT((sum - nearest.apart).norm(), 1e-14);
      // The weights of a side have one sign, and their magnitudes add up to 1.
      const int first = edges ? 2 : 1;
      double one = 0, other = 0;
      for (int i = 0; i < 4; ++i) {
        (i < first ? one : other) += w[i];
        EXPECT_GE(i < first ? w[i] : -w[i], -1e-14);
      }
      EXPECT_NEAR(one, 1, 1e-14);
      EXPECT_NEAR(other, -1, 1e-14);
      double sampled = 1e9;
      for (int i = 0; i <= 40; ++i) {
        for (int j = 0; j <= 40; ++j) {
          const double s = i / 40.0, t = j / 40.0;
          Vec3 gap;
          if (edges) {
            gap = (1 - s) * x[0] + s * x[1] - (1 - t) * x[2] - t * x[3];
          } else if (i + j <= 40) {
            gap = x[0] - s * x[1] - t * x[2] - (1 - s - t) * x[3];
          } else {
            continue;
          }
          sampled = std::min(sampled, gap.norm());
        }
      }
      EXPECT_LE(nearest.apart.norm(), sampled + 1e-12);
      EXPECT_GT(nearest.apart.norm(), sampled - 0.1);
    }
  }
}

TEST(ProximitySearch, FindsInASoupWhatAllPairsFind) {
  for (const double radius : {0.0005, 0.003, 0.01}) {
    const Surface surface = soup(150, 11);
    std::vector<ContactPair> pairs;
    std::vector<double> bound;
    surface.search().find(surface.x, radius, 0.001, pairs, bound, false);
    const std::map<Key, double> expected = surface.all_pairs(radius);
    std::set<Key> found;
    for (const ContactPair& pair : pairs) {
      EXPECT_TRUE(found.insert(key_of(pair)).second) << "twice";
      EXPECT_TRUE(expected.contains(key_of(pair)));
      EXPECT_EQ(pair.gap, 0.001);
    }
    EXPECT_EQ(found.size(), expected.size());
    EXPECT_GT(expected.size(), 30U);
  }
}

TEST(ProximitySearch, FindsInFoldsWhatAllPairsFind) {
  const Surface surface = folded(0.003, 0.001, 4);
  const double gap = 0.002;
  const auto share_triangle = [&](int a, int b) {  // neighbours in the mesh
    for (const Triangle& t : surface.triangles) {
      if (std::count(t.begin(), t.end(), a) && std::count(t.begin(), t.end(), b)) return true;
    }
    return false;
  };
  const auto near_in_mesh = [&](const Key& key) {
    const int first = key[0] == 1 ? 2 : 1;
    for (int i = 1; i <= first; ++i) {
      for (int j = first + 1; j < 5; ++j) {
        if (share_triangle(key[i], key[j])) return true;
      }
    }
    return false;
  };
  for (const double radius : {0.001, 0.004, 0.008}) {
    std::vector<ContactPair> pairs;
    std::vector<double> bound;
    surface.search().find(surface.x, radius, gap, pairs, bound, false);
    std::map<Key, double> missing = surface.all_pairs(radius);
    std::vector<double> nearest(surface.x.size(), radius);
    for (const auto& [key, distance] : missing) {
      for (int i = 1; i < 5; ++i) nearest[key[i]] = std::min(nearest[key[i]], distance);
    }
    int neighbours = 0;
    for (const ContactPair& pair : pairs) {
      EXPECT_EQ(missing.erase(key_of(pair)), 1U);
      if (!near_in_mesh(key_of(pair))) {
        EXPECT_EQ(pair.gap, gap);
        continue;
      }
      // Neighbours keep at most the distance that the flat mesh leaves them, half an edge.
      ++neighbours;
      EXPECT_LE(pair.gap, 0.5 * surface.shortest_edge);
      EXPECT_GT(pair.gap, 0);
    }
    // All pairs left out are neighbours in the mesh, and too far apart to touch soon.
    for (const auto& [key, distance] : missing) {
      EXPECT_TRUE(near_in_mesh(key));
      EXPECT_GT(distance, gap);
    }
    // Bounds heed all pairs, also those left out, and are not much smaller than needed.
    for (std::size_t v = 0; v < bound.size(); ++v) {
      EXPECT_LT(bound[v], 0.5 * nearest[v]);
      EXPECT_GT(bound[v], 0.4 * nearest[v]);
    }
    if (radius > 0.005) {
      EXPECT_GT(neighbours, 0);
    }

    std::vector<ContactPair> strangers;
    surface.search().find(surface.x, radius, gap, strangers, bound, true);
    EXPECT_EQ(strangers.size(), pairs.size() - neighbours);
    for (const ContactPair& pair : strangers) EXPECT_EQ(pair.gap, gap);
  }
}

TEST(ProximitySearch, FindsALayerAsAllPairsFindIt) {
  const Surface cloth = soup(100, 5);
  const Surface layer = soup(120, 6);
  Surface both = cloth;
  const int first = static_cast<int>(cloth.x.size());
  both.x.insert(both.x.end(), layer.x.begin(), layer.x.end());
  for (const Triangle& t : layer.triangles) {
    both.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  both = with_own_nodes(both);
  const double radius = 0.006, gap = 0.001, layer_gap = 0.002;
  std::map<Key, double> own, with_layer;
  std::vector<double> nearest(first, radius);
  for (const auto& [key, distance] : both.all_pairs(radius)) {
    const bool one = key[1] >= first;
    const bool other = key[4] >= first;
    if (one && other) continue;
    (one || other ? with_layer : own)[key] = distance;
    for (int i = 1; i < 5; ++i) {
      if (key[i] < first) nearest[key[i]] = std::min(nearest[key[i]], distance);
    }
  }
  std::vector<ContactPair> pairs;
  std::vector<double> bound;
  ProximitySearch search = cloth.search();
  search.add_layer(layer.triangles, static_cast<int>(layer.x.size()), layer_gap);
  search.find(both.x, radius, gap, pairs, bound, false);
  int of_layer = 0;
  for (const ContactPair& pair : pairs) {
    const bool is_own = own.erase(key_of(pair)) == 1;
    if (!is_own) {
      EXPECT_EQ(with_layer.erase(key_of(pair)), 1U);
      ++of_layer;
    }
    EXPECT_EQ(pair.gap, is_own ? gap : layer_gap);
  }
  EXPECT_GT(of_layer, 100);
  EXPECT_TRUE(own.empty());
  // Pairs with the layer are left out if they cannot come near before the bounds are used up.
  for (const auto& [key, distance] : with_layer) EXPECT_GT(0.55 * distance, 0.999 * layer_gap);
  for (int v = 0; v < first; ++v) {
    EXPECT_LT(bound[v], 0.5 * nearest[v] + 1e-15);
    EXPECT_GT(bound[v], 0.4 * nearest[v] - 1e-15);
  }
}

TEST(ProximitySearch, WhatIsOneNodeNeverPairs) {
  // Two triangles lie one over the other, sewn at one corner, where no pair may be.
  Surface surface;
  surface.triangles = {{0, 1, 2}, {3, 4, 5}};
  surface.x = {{0, 0, 0},     {0.01, 0, 0},     {0, 0.01, 0},
               {0, 0, 0.001}, {0.01, 0, 0.001}, {0, 0.01, 0.001}};
  surface.node = {0, 1, 2, 0, 3, 4};
  std::vector<ContactPair> pairs;
  std::vector<double> bound;
  surface.search().find(surface.x, 0.002, 0.001, pairs, bound, false);
  for (const ContactPair& pair : pairs) {
    const int first = pair.edges ? 2 : 1;
    for (int i = 0; i < first; ++i) {
      for (int j = first; j < 4; ++j) {
        EXPECT_NE(surface.node[pair.vertices[i]], surface.node[pair.vertices[j]]);
      }
    }
  }
  // Four pairs are a free corner with the other triangle. Five pairs are a far edge with one of the
  // three edges of the other triangle; both far edges together are one of these.
  EXPECT_EQ(pairs.size(), 4U + 5U);
}

TEST(ProximitySearch, ARunawayVertexIsNoTrouble) {
  Surface surface = folded(0.003, 0.001, 4);
  surface.x[7] = Vec3(1e4, -1e4, 1e4);
  std::vector<ContactPair> pairs;
  std::vector<double> bound;
  surface.search().find(surface.x, 0.004, 0.002, pairs, bound, false);
  EXPECT_GT(pairs.size(), 100U);
}

TEST(ProximitySearch, TheSameOrderForAnyNumberOfThreads) {
  const Surface surface = soup(1500, 2);
  std::vector<ContactPair> one, two;
  std::vector<double> bound_one, bound_two;
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    surface.search().find(surface.x, 0.002, 0.001, one, bound_one, false);
  }
  surface.search().find(surface.x, 0.002, 0.001, two, bound_two, false);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].vertices, two[i].vertices);
  EXPECT_EQ(bound_one, bound_two);
}

/// Moves every vertex by `share` of its bound along `direction(vertex)`.
template <typename Direction>
std::vector<Vec3> moved(const Surface& surface, const std::vector<double>& bound, double share,
                        const Direction& direction) {
  std::vector<Vec3> x = surface.x;
  for (std::size_t v = 0; v < x.size(); ++v) x[v] += share * bound[v] * direction(v).normalized();
  return x;
}

TEST(Bounds, NothingThatIsApartComesToIntersect) {
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  const auto anyhow = [&] { return Vec3(normal(random), normal(random), normal(random)); };
  std::vector<ContactPair> pairs;
  std::vector<double> bound;
  for (const double gap : {0.0002, 0.001, 0.004}) {
    int tried = 0;
    for (unsigned seed = 0; seed < 40 && tried < 8; ++seed) {
      Surface surface = folded(gap, 0.0015, seed);
      if (!self_intersections({surface.x, surface.triangles}).empty()) continue;
      ++tried;
      const ProximitySearch search = surface.search();
      // Each state is searched, moved to the end of its bounds, and tested. When layers press on
      // each other, a move may use nine tenths of the distance between them.
      for (int step = 0; step < 8; ++step) {
        search.find(surface.x, 0.005, 0.002, pairs, bound, false);
        const double press = step % 2 ? 5 : 0;
        surface.x = moved(surface, bound, 1, [&](std::size_t v) {
          return Vec3(anyhow() + Vec3(0, 0, surface.x[v].z() < gap ? press : -press));
        });
        ASSERT_TRUE(self_intersections({surface.x, surface.triangles}).empty())
            << gap << " " << seed << " " << step;
      }
    }
    EXPECT_EQ(tried, 8) << gap;
  }
}

// Two edges that cross each other are pressed together, at every search by all that they may move.
TEST(Bounds, HoldWhereAPressTakesTwoSidesToRoundingErrors) {
  const Surface surface{{{0, 1, 2}, {3, 4, 5}},
                        {{-0.1, 0.78, 0.3},
                         {0.1, 0.77, 0.31},
                         {0, 0.9, 0.301},
                         {0.01, 0.7, 0.31},
                         {-0.01, 0.85, 0.312},
                         {0.3, 0.8, 0.319}},
                        {0, 1, 2, 3, 4, 5}};
  std::vector<Vec3> x = surface.x;
  std::vector<ContactPair> pairs;
  std::vector<double> bound;
  const auto side = [&] {  // of the second edge, seen from the first
    return (x[1] - x[0]).cross(x[4] - x[3]).dot(x[3] - x[0]) > 0;
  };
  const bool at_first = side();
  const Vec3 press = (at_first ? 1 : -1) * (x[1] - x[0]).cross(x[4] - x[3]).normalized();
  for (int step = 0; step < 200; ++step) {
    surface.search().find(x, 0.05, 0.002, pairs, bound, false);
    for (const int v : {0, 1, 3, 4}) x[v] += (v < 3 ? 1 : -1) * bound[v] * press;
    ASSERT_EQ(side(), at_first) << step;
  }
  // It comes as near as that, and the two sides get free again.
  EXPECT_LT(nearest_points(true, {x[0], x[1], x[3], x[4]}).apart.norm(), 1e-10);
  for (int step = 0; step < 200; ++step) {
    surface.search().find(x, 0.05, 0.002, pairs, bound, false);
    for (const int v : {0, 1, 3, 4}) x[v] -= (v < 3 ? 1 : -1) * bound[v] * press;
  }
  EXPECT_GT(nearest_points(true, {x[0], x[1], x[3], x[4]}).apart.norm(), 1e-6);
}

/// Metres that the corners of a pair's sides may still go, at most: of the first and the second.
std::array<double, 2> reach_of(const Key& key, const std::vector<double>& left) {
  const bool edges = key[0] == 1;
  std::array<double, 2> reach = {0, 0};
  for (std::size_t i = 0; i < 4; ++i) {
    double& of_side = reach[i < (edges ? 2u : 1u) ? 0 : 1];
    of_side = std::max(of_side, left[key[i + 1]]);
  }
  return reach;
}

// Both sides of a pair may have a vertex that got a new bound, and one that keeps its old one.
TEST(Bounds, AfterAnUpdateNoPairCanMeet) {
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<ContactPair> pairs;
  std::vector<double> bound;
  int checked = 0;
  for (unsigned seed = 0; seed < 3; ++seed) {
    Surface surface = soup(60, seed);
    const ProximitySearch search = surface.search();
    search.find(surface.x, 0.004, 0.002, pairs, bound, false);
    std::vector<Vec3> at = surface.x;
    for (int step = 0; step < 20; ++step) {
      // One vertex of ten goes to the end of its bound, the others a little.
      std::vector<char> is_new(surface.x.size());
      for (std::size_t v = 0; v < surface.x.size(); ++v) {
        const Vec3 way = Vec3(normal(random), normal(random), normal(random)).normalized();
        is_new[v] = unit(random) < 0.1;
        surface.x[v] = at[v] + (is_new[v] != 0 ? 1 : 0.3) * bound[v] * way;
      }
      search.update(surface.x, 0.004, 0.002, pairs, bound, at, false);
      std::vector<double> left = bound;
      for (std::size_t v = 0; v < at.size(); ++v) left[v] += (surface.x[v] - at[v]).norm();
      for (const auto& [key, distance] : surface.all_pairs(0.01)) {
        // Of others, the older bounds hold.
        if (std::none_of(key.begin() + 1, key.end(), [&](int v) { return is_new[v] != 0; })) {
          continue;
        }
        ++checked;
        const auto [first, second] = reach_of(key, left);
        ASSERT_LE(first + second, distance * (1 + 1e-12)) << seed << " " << step;
      }
    }
  }
  EXPECT_GT(checked, 1000);
}

TEST(Bounds, FartherMovesWouldIntersect) {
  // Moves of four bounds intersect, so the test above can fail.
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  const Surface surface = folded(0.001, 0.0015, 21);
  std::vector<ContactPair> pairs;
  std::vector<double> bound;
  surface.search().find(surface.x, 0.005, 0.002, pairs, bound, false);
  const std::vector<Vec3> x = moved(surface, bound, 4, [&](std::size_t) {
    return Vec3(normal(random), normal(random), normal(random));
  });
  EXPECT_FALSE(self_intersections({x, surface.triangles}).empty());
}

// A step that ignores the stiffness of a touch to come is thrown back again and again.
TEST(SelfContact, AnEarlyTouchIsStiffAndDoesNotPush) {
  constexpr double gap = 0.002, early = 1e-4;
  for (const bool barrier : {false, true}) {
    const ContactPush near = contact_push(gap + 0.5 * early, gap, barrier, early);
    EXPECT_EQ(near.force, 0);
    EXPECT_EQ(near.energy, 0);
    EXPECT_EQ(near.stiffness, contact_push(0.9 * gap, gap, barrier, early).stiffness);
    EXPECT_GT(near.stiffness, 0);
    EXPECT_EQ(contact_push(gap + 0.5 * early, gap, barrier).stiffness, 0);
    EXPECT_EQ(contact_push(gap + 1.5 * early, gap, barrier, early).stiffness, 0);
  }
}

}  // namespace proximity_test
}  // namespace toile
