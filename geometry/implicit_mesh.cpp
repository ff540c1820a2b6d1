#include "geometry/implicit_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/error.h"
#include "geometry/parallel.h"

namespace toile {

namespace {

using Quad = std::array<int, 4>;
using Node = std::array<int, 3>;

struct Grid {
  Vec3 origin;
  double spacing = 0;
  std::array<int, 3> nodes{};
  std::vector<double> values;

  std::size_t index(const Node& node) const {
    return (static_cast<std::size_t>(node[2]) * nodes[1] + node[1]) * nodes[0] + node[0];
  }
  bool inside(const Node& node) const { return values[index(node)] < 0; }
  Vec3 point(const Node& node) const { return origin + spacing * Vec3(node[0], node[1], node[2]); }
  /// The point where the surface crosses the edge from `node` along `axis`.
  Vec3 crossing(const Node& node, int axis) const {
    Node next = node;
    ++next[axis];
    const double a = values[index(node)];
    const double b = values[index(next)];
    return point(node) + a / (a - b) * spacing * Vec3::Unit(axis);
  }
};

Grid sample(const ImplicitFunction& shape, const ImplicitMeshOptions& options) {
  Grid grid;
  grid.spacing = options.spacing;
  // The grid has whole cells to both sides of the box's middle, so that a symmetric shape gets a
  // symmetric mesh.
  const Vec3 middle = (options.low + options.high) / 2;
  for (int i = 0; i < 3; ++i) {
    const double half = (options.high[i] - options.low[i]) / 2;
    const int cells = 2 * (static_cast<int>(std::ceil(half / grid.spacing)) + 1);
    grid.nodes[i] = cells + 1;
    grid.origin[i] = middle[i] - grid.spacing * cells / 2;
  }
  grid.values.resize(static_cast<std::size_t>(grid.nodes[0]) * grid.nodes[1] * grid.nodes[2]);
  parallel_for_items(grid.nodes[2], [&](int z) {
    for (int y = 0; y < grid.nodes[1]; ++y) {
      for (int x = 0; x < grid.nodes[0]; ++x) {
        grid.values[grid.index({x, y, z})] = shape(grid.point({x, y, z}));
      }
    }
  });
  return grid;
}

Node moved(Node node, int axis, int by) {
  node[axis] += by;
  return node;
}

/// The number of one of a cell's twelve edges: 4 axis + a + 2 b. `a` and `b` are 0 or 1, the side
/// of the cell on which the edge lies along the next axis and the one after.
int edge_number(int axis, int a, int b) { return 4 * axis + a + 2 * b; }

Node start_of_edge(const Node& cell, int edge) {
  const int axis = edge / 4;
  return moved(moved(cell, (axis + 1) % 3, edge & 1), (axis + 2) % 3, edge >> 1 & 1);
}

/// Per edge of the cell, the piece of surface in the cell that crosses it; -1: none does. Pieces
/// are joined across faces. A face with only two diagonal corners inside could be joined in two
/// ways. Both cells that share such a face keep its inside corners apart. So the net stays a
/// manifold [Schaefer, Ju & Warren 2007].
std::array<int, 12> pieces(const Grid& grid, const Node& cell) {
  std::array<int, 12> piece;
  for (int edge = 0; edge < 12; ++edge) {
    const Node from = start_of_edge(cell, edge);
    piece[edge] = grid.inside(from) != grid.inside(moved(from, edge / 4, 1)) ? edge : -1;
  }
  const auto join = [&piece](int first, int second) {
    const int from = piece[second];
    const int to = piece[first];
    std::replace(piece.begin(), piece.end(), std::max(from, to), std::min(from, to));
  };
  for (int normal = 0; normal < 3; ++normal) {
    const int p = (normal + 1) % 3;
    const int q = (normal + 2) % 3;
    for (int side = 0; side < 2; ++side) {
      const std::array<int, 4> edges = {edge_number(p, 0, side), edge_number(p, 1, side),
                                        edge_number(q, side, 0), edge_number(q, side, 1)};
      std::vector<int> crossed;
      for (int edge : edges) {
        if (piece[edge] >= 0) crossed.push_back(edge);
      }
      if (crossed.size() == 2) join(crossed[0], crossed[1]);
      if (crossed.size() < 4) continue;
      for (int i = 0; i < 4; ++i) {
        const Node corner = moved(moved(moved(cell, normal, side), p, i & 1), q, i >> 1);
        if (grid.inside(corner)) join(edges[i >> 1], edges[2 + (i & 1)]);
      }
    }
  }
  return piece;
}

/// Makes a point for each piece of surface in each cell, and a quad for each crossed grid edge.
/// `inside_ends` gets that edge's end within the surface, one a quad.
void build_net(const Grid& grid, std::vector<Vec3>& points, std::vector<Quad>& quads,
               std::vector<std::size_t>& inside_ends) {
  const auto [nx, ny, nz] = grid.nodes;
  std::vector<int> crossed_cell(grid.values.size(), -1);
  std::vector<std::array<int, 12>> point_of_edge;  // per crossed cell
  for (int z = 0; z + 1 < nz; ++z) {
    for (int y = 0; y + 1 < ny; ++y) {
      for (int x = 0; x + 1 < nx; ++x) {
        int inside = 0;
        for (int c = 0; c < 8; ++c) {
          inside += grid.inside({x + (c & 1), y + (c >> 1 & 1), z + (c >> 2)}) ? 1 : 0;
        }
        if (inside == 0 || inside == 8) continue;
        const Node cell = {x, y, z};
        std::array<int, 12> piece = pieces(grid, cell);
        for (int first = 0; first < 12; ++first) {
          if (piece[first] != first) continue;
          Vec3 sum = Vec3::Zero();
          int crossings = 0;
          for (int edge = first; edge < 12; ++edge) {
            if (piece[edge] != first) continue;
            sum += grid.crossing(start_of_edge(cell, edge), edge / 4);
            ++crossings;
          }
          // The piece's edges now hold 12 + the point's index, which no edge number reaches.
          std::replace(piece.begin(), piece.end(), first, 12 + static_cast<int>(points.size()));
          points.push_back(sum / crossings);
        }
        for (int& point : piece) point -= 12;
        crossed_cell[grid.index(cell)] = static_cast<int>(point_of_edge.size());
        point_of_edge.push_back(piece);
      }
    }
  }
  for (int z = 1; z + 1 < nz; ++z) {
    for (int y = 1; y + 1 < ny; ++y) {
      for (int x = 1; x + 1 < nx; ++x) {
        const Node from = {x, y, z};
        for (int axis = 0; axis < 3; ++axis) {
          const bool inside = grid.inside(from);
          if (inside == grid.inside(moved(from, axis, 1))) continue;
          // The cells run counter-clockwise around the edge. It lies on side 1 of a cell before it.
          constexpr std::array<std::array<int, 2>, 4> around = {{{1, 1}, {0, 1}, {0, 0}, {1, 0}}};
          Quad quad;
          for (int i = 0; i < 4; ++i) {
            const auto [a, b] = around[i];
            const Node cell = moved(moved(from, (axis + 1) % 3, -a), (axis + 2) % 3, -b);
            quad[i] = point_of_edge[crossed_cell[grid.index(cell)]][edge_number(axis, a, b)];
          }
          if (!inside) std::swap(quad[1], quad[3]);
          quads.push_back(quad);
          inside_ends.push_back(grid.index(inside ? from : moved(from, axis, 1)));
        }
      }
    }
  }
}

Vec3 gradient(const ImplicitFunction& shape, const Vec3& point) {
  constexpr double step = 1e-6;
  Vec3 result;
  for (int i = 0; i < 3; ++i) {
    Vec3 ahead = point;
    Vec3 behind = point;
    ahead[i] += step;
    behind[i] -= step;
    result[i] = (shape(ahead) - shape(behind)) / (2 * step);
  }
  return result;
}

Vec3 onto_surface(const ImplicitFunction& shape, Vec3 point, double tolerance) {
  constexpr int steps = 20;
  for (int i = 0; i < steps; ++i) {
    const double value = shape(point);
    if (std::abs(value) < tolerance) break;
    const Vec3 slope = gradient(shape, point);
    point -= value / std::max(slope.squaredNorm(), 0.01) * slope;
  }
  return point;
}

/// Moves each point toward the middle of its neighbours and back onto the surface. The grid's
/// pattern spreads out; the surface stays.
void even_out(const ImplicitFunction& shape, const std::vector<Quad>& quads, int rounds,
              bool keeps_clefts, double tolerance, std::vector<Vec3>& points) {
  const int count = static_cast<int>(points.size());
  std::vector<Vec3> next(points.size());
  for (int round = 0; round <= rounds; ++round) {
    const bool last = round == rounds;
    std::vector<Vec3> sum(points.size(), Vec3::Zero());
    std::vector<int> neighbours(points.size(), 0);
    std::vector<Vec3> normals(points.size(), Vec3::Zero());
    for (const Quad& q : quads) {
      const Vec3 area = (points[q[2]] - points[q[0]]).cross(points[q[3]] - points[q[1]]);
      for (int i = 0; i < 4; ++i) {
        normals[q[i]] += area;
        sum[q[i]] += points[q[(i + 1) % 4]] + points[q[(i + 3) % 4]];
        neighbours[q[i]] += 2;
      }
    }
    parallel_for_items(count, [&](int i) {
      Vec3 target = last ? points[i] : Vec3((points[i] + sum[i] / neighbours[i]) / 2);
      if (keeps_clefts) {
        const Vec3 normal = normals[i].normalized();
        target -= std::max(0.0, normal.dot(target - points[i])) * normal;
      }
      next[i] = onto_surface(shape, target, last ? 1e-9 : tolerance);
    });
    points.swap(next);
  }
}

/// A number that grows with the smallest angle of triangle abc: minus that angle's cosine.
double worst_corner(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = (b - a).normalized();
  const Vec3 bc = (c - b).normalized();
  const Vec3 ca = (a - c).normalized();
  return -std::max({-ab.dot(ca), -ab.dot(bc), -bc.dot(ca)});
}

using Edge = std::array<int, 2>;

Edge undirected(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// The edges that four quads share: two sheets of the surface pass through one face of the grid.
std::vector<Edge> pinched_edges(const std::vector<Quad>& quads) {
  std::vector<Edge> edges;
  edges.reserve(4 * quads.size());
  for (const Quad& q : quads) {
    for (int i = 0; i < 4; ++i) edges.push_back(undirected(q[i], q[(i + 1) % 4]));
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> pinched;
  for (std::size_t i = 2; i < edges.size(); ++i) {
    if (edges[i] == edges[i - 2] && (pinched.empty() || pinched.back() != edges[i])) {
      pinched.push_back(edges[i]);
    }
  }
  return pinched;
}

/// A point of one of the sheets on a pinched edge. A sheet has the inside corner that both of its
/// quads have.
struct SheetPoint {
  Edge edge;
  std::size_t inside = 0;
  int point = 0;

  bool is_before(const Edge& other, std::size_t corner) const {
    return edge != other ? edge < other : inside < corner;
  }
};

/// Gives each sheet on a pinched edge a point of its own, moved from the edge's middle toward the
/// sheet's quads. Results are sorted.
std::vector<SheetPoint> part_sheets(const std::vector<Quad>& quads,
                                    const std::vector<std::size_t>& inside_ends,
                                    std::vector<Vec3>& points) {
  const std::vector<Edge> pinched = pinched_edges(quads);
  if (pinched.empty()) return {};
  struct Use {
    Edge edge;
    std::size_t inside;
    Vec3 middle;  // of the quad
  };
  std::vector<Use> uses;
  for (std::size_t k = 0; k < quads.size(); ++k) {
    const Quad& q = quads[k];
    for (int i = 0; i < 4; ++i) {
      const Edge edge = undirected(q[i], q[(i + 1) % 4]);
      if (!std::binary_search(pinched.begin(), pinched.end(), edge)) continue;
      const Vec3 middle = (points[q[0]] + points[q[1]] + points[q[2]] + points[q[3]]) / 4;
      uses.push_back({edge, inside_ends[k], middle});
    }
  }
  std::stable_sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.inside < b.inside;
  });
  std::vector<SheetPoint> sheets;
  for (std::size_t i = 0; i + 1 < uses.size(); i += 2) {
    const Vec3 on_edge = (points[uses[i].edge[0]] + points[uses[i].edge[1]]) / 2;
    const Vec3 on_sheet = (uses[i].middle + uses[i + 1].middle) / 2;
    sheets.push_back({uses[i].edge, uses[i].inside, static_cast<int>(points.size())});
    points.push_back(0.7 * on_edge + 0.3 * on_sheet);
  }
  return sheets;
}

/// Cuts each quad along the diagonal that leaves the larger smallest angle. A quad on a pinched
/// edge becomes a fan around the point of its sheet there.
std::vector<Triangle> cut_quads(const std::vector<Quad>& quads,
                                const std::vector<std::size_t>& inside_ends,
                                const std::vector<SheetPoint>& sheets,
                                const std::vector<Vec3>& points) {
  std::vector<Triangle> triangles;
  triangles.reserve(2 * quads.size());
  const auto point_on = [&](const Edge& edge, std::size_t inside) {
    const auto found = std::lower_bound(
        sheets.begin(), sheets.end(), edge,
        [&](const SheetPoint& s, const Edge& e) { return s.is_before(e, inside); });
    const bool is_there = found != sheets.end() && found->edge == edge && found->inside == inside;
    return is_there ? found->point : -1;
  };
  for (std::size_t k = 0; k < quads.size(); ++k) {
    const Quad& q = quads[k];
    std::vector<int> outline;
    std::size_t fan = 0;
    for (int i = 0; i < 4 && !sheets.empty(); ++i) {
      outline.push_back(q[i]);
      const int point = point_on(undirected(q[i], q[(i + 1) % 4]), inside_ends[k]);
      if (point < 0) continue;
      fan = outline.size();
      outline.push_back(point);
    }
    if (outline.size() > 4) {
      const std::size_t n = outline.size();
      for (std::size_t i = 1; i + 1 < n; ++i) {
        triangles.push_back({outline[fan], outline[(fan + i) % n], outline[(fan + i + 1) % n]});
      }
      continue;
    }
    const Vec3& a = points[q[0]];
    const Vec3& b = points[q[1]];
    const Vec3& c = points[q[2]];
    const Vec3& d = points[q[3]];
    const double along_ac = std::min(worst_corner(a, b, c), worst_corner(a, c, d));
    const double along_bd = std::min(worst_corner(a, b, d), worst_corner(b, c, d));
    if (along_ac >= along_bd) {
      triangles.push_back({q[0], q[1], q[2]});
      triangles.push_back({q[0], q[2], q[3]});
    } else {
      triangles.push_back({q[0], q[1], q[3]});
      triangles.push_back({q[1], q[2], q[3]});
    }
  }
  return triangles;
}

/// Whether every directed edge occurs once and its opposite occurs, too.
bool is_closed(const std::vector<Triangle>& triangles) {
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (const Triangle& t : triangles) {
    for (int i = 0; i < 3; ++i) edges.push_back({t[i], t[(i + 1) % 3]});
  }
  std::sort(edges.begin(), edges.end());
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end()) return false;
  return !edges.empty() && std::all_of(edges.begin(), edges.end(), [&](const Edge& edge) {
    return std::binary_search(edges.begin(), edges.end(), Edge{edge[1], edge[0]});
  });
}

}  // namespace

TriangleMesh mesh_implicit(const ImplicitFunction& shape, const ImplicitMeshOptions& options) {
  const Grid grid = sample(shape, options);
  std::vector<Quad> quads;
  std::vector<std::size_t> inside_ends;
  TriangleMesh mesh;
  build_net(grid, mesh.points, quads, inside_ends);
  even_out(shape, quads, options.smoothing, options.keeps_clefts, options.spacing / 50,
           mesh.points);
  const std::vector<SheetPoint> sheets = part_sheets(quads, inside_ends, mesh.points);
  mesh.triangles = cut_quads(quads, inside_ends, sheets, mesh.points);
  if (!is_closed(mesh.triangles)) {
    throw Error("implicit surface", "its mesh is not closed and manifold at this spacing",
                "use a finer one");
  }
  return mesh;
}

}  // namespace toile
