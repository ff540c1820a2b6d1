#include "geometry/mesh_polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "geometry/angles.h"
#include "geometry/bucket_grid.h"
#include "geometry/polygon.h"
#include "geometry/triangulate.h"

namespace toile {

namespace {

/// Metres that an edge may be longer for each metre of distance from a short border segment.
constexpr double growth = 0.6;
/// Spacing of the first lattice in wanted edge lengths. Below 1, as the rows at the border end up
/// wider.
constexpr double lattice_spacing = 0.96;
/// Maximum number of lattices, each half as wide as the one before.
constexpr int max_lattices = 5;
/// Wanted edge lengths: minimum distance of a new point from interior points.
constexpr double first_spacing = 0.8;
/// Wanted edge lengths: minimum distance of a new point from border points.
constexpr double border_point_spacing = 0.7;
/// Wanted edge lengths: minimum distance of a new point from border segments.
constexpr double border_spacing = 0.55;
/// Wanted edge lengths: minimum distance from the border that smoothing keeps.
constexpr double border_clearance = 0.35;
/// Rounds of smoothing. The points hardly move after 30.
constexpr int smoothing_rounds = 40;
/// Sweeps of the last pass, which raises angles.
constexpr int raising_sweeps = 12;
/// Radians. A point whose angles are all larger stays where smoothing put it.
constexpr double well_shaped = to_radians(40);
/// Radians. An edge from border to border is flipped if both new triangles have no smaller angle.
constexpr double crossing_angle = to_radians(20);

double angle_of(const PlanarMesh& mesh, const Triangle& t) {
  return smallest_angle(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
}

double angle_of(const PlanarMesh& mesh, int triangle) {
  return angle_of(mesh, mesh.triangles[triangle]);
}

struct Box {
  explicit Box(const std::vector<Vec2>& points) : low(points[0]), high(points[0]) {
    for (const Vec2& point : points) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
  }
  Vec2 low;
  Vec2 high;
};

class Filler {
 public:
  Filler(const std::vector<Vec2>& outline, const std::vector<std::vector<Vec2>>& holes,
         double edge_length)
      : outline_(outline),
        holes_(holes),
        edge_length_(edge_length),
        box_(outline),
        segments_(box_.low, box_.high, edge_length),
        points_(box_.low, box_.high, edge_length) {
    add_polygon(outline);
    for (const std::vector<Vec2>& hole : holes) add_polygon(hole);
    border_ = static_cast<int>(border_points_.size());
    for (int i = 0; i < border_; ++i) {
      const Vec2& a = border_points_[i];
      const Vec2& b = border_points_[next_[i]];
      middles_.push_back((a + b) / 2);
      lengths_.push_back((b - a).norm());
      segments_.add(a, b, i);
      points_.add(a, i);
    }
  }

  PlanarMesh fill(const std::vector<int>& split_corners) {
    for (const int corner : split_corners) split(corner);
    kept_ = interior_.size();
    seed();
    for (int round = 0; round < smoothing_rounds && !interior_.empty(); ++round) smooth();
    connect();
    std::vector<bool> fixed(mesh_.points.size(), false);
    std::fill_n(fixed.begin(), border_, true);
    for (int round = 0; round < 2; ++round) {
      while (uncross()) continue;
      raise_angles(mesh_, fixed, well_shaped);
    }
    return std::move(mesh_);
  }

 private:
  void add_polygon(const std::vector<Vec2>& polygon) {
    const int first = static_cast<int>(border_points_.size());
    const int last = first + static_cast<int>(polygon.size()) - 1;
    border_points_.insert(border_points_.end(), polygon.begin(), polygon.end());
    for (int i = first; i <= last; ++i) next_.push_back(i < last ? i + 1 : first);
  }

  bool is_within(const Vec2& point) const {
    return inside(outline_, point) &&
           std::ranges::none_of(holes_, [&](const auto& hole) { return inside(hole, point); });
  }

  /// The wanted edge length at `point`, metres.
  double size(const Vec2& point) const {
    double wanted = edge_length_;
    // A short segment shortens edges only up to the distance at which they reach full length.
    segments_.near(point, edge_length_ / growth, [&](int i) {
      if (lengths_[i] >= wanted) return;
      wanted = std::min(wanted, lengths_[i] + growth * (point - middles_[i]).norm());
    });
    return wanted;
  }

  /// Metres to the border; some larger number where that is more than edge_length.
  double border_distance(const Vec2& point) const {
    double distance = std::numeric_limits<double>::max();
    segments_.near(point, edge_length_, [&](int i) {
      distance = std::min(distance,
                          distance_to_segment(point, border_points_[i], border_points_[next_[i]]));
    });
    return distance;
  }

  /// Adds a point in the triangle of an outline point and its neighbours, toward the far side.
  void split(int corner) {
    const int count = static_cast<int>(outline_.size());
    const Vec2& before = outline_[(corner + count - 1) % count];
    const Vec2& after = outline_[(corner + 1) % count];
    const Vec2 point = 0.25 * outline_[corner] + 0.375 * (before + after);
    points_.add(point, border_ + static_cast<int>(interior_.size()));
    interior_.push_back(point);
  }

  /// Whether `point` is far enough from the border and from other points. It has to lie inside.
  bool fits(const Vec2& point) const {
    const double wanted = size(point);
    bool free = true;
    points_.near(point, wanted, [&](int i) {
      const bool border = i < border_;
      const Vec2& other = border ? border_points_[i] : interior_[i - border_];
      const double spacing = border ? border_point_spacing : first_spacing;
      if ((other - point).norm() < spacing * wanted) free = false;
    });
    return free && border_distance(point) >= border_spacing * wanted;
  }

  /// The x at which the horizontal line at `y` enters and leaves the polygon, in rising order.
  std::vector<double> crossings(double y) const {
    std::vector<double> xs;
    for (int i = 0; i < border_; ++i) {
      const Vec2& a = border_points_[i];
      const Vec2& b = border_points_[next_[i]];
      if ((a.y() > y) == (b.y() > y)) continue;
      xs.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
    std::sort(xs.begin(), xs.end());
    return xs;
  }

  /// Adds points of hexagonal lattices, the coarsest first. Finer lattices fill the places where
  /// the border wants shorter edges.
  void seed() {
    const double shortest = *std::min_element(lengths_.begin(), lengths_.end());
    double step = lattice_spacing * edge_length_;
    for (int lattice = 0; lattice < max_lattices; ++lattice, step /= 2) {
      const double row_height = step * std::sqrt(3.0) / 2;
      const Vec2 middle = (box_.low + box_.high) / 2;
      const int rows = static_cast<int>((box_.high.y() - box_.low.y()) / row_height / 2) + 1;
      for (int row = -rows; row <= rows; ++row) {
        const double y = middle.y() + row * row_height;
        const double offset = middle.x() + (row % 2 == 0 ? 0.0 : 0.5) * step;
        const std::vector<double> xs = crossings(y);
        for (std::size_t k = 0; k + 1 < xs.size(); k += 2) {
          const double last = std::floor((xs[k + 1] - offset) / step);
          for (double column = std::ceil((xs[k] - offset) / step); column <= last; ++column) {
            const Vec2 point(offset + column * step, y);
            // A coarser lattice already has the right density here.
            if (lattice > 0 && size(point) > 1.5 * step) continue;
            if (!fits(point)) continue;
            points_.add(point, border_ + static_cast<int>(interior_.size()));
            interior_.push_back(point);
          }
        }
      }
      if (shortest > 0.75 * step) break;
    }
  }

  void connect() {
    mesh_.points = border_points_;
    mesh_.points.insert(mesh_.points.end(), interior_.begin(), interior_.end());
    mesh_.triangles = triangulate(outline_, interior_, holes_);
  }

  /// Moves each interior point to the weighted centre of the triangles around it.
  void smooth() {
    connect();
    std::vector<Vec2> sum(interior_.size(), Vec2::Zero());
    std::vector<double> weight(interior_.size(), 0);
    for (const Triangle& triangle : mesh_.triangles) {
      const Vec2& a = mesh_.points[triangle[0]];
      const Vec2& b = mesh_.points[triangle[1]];
      const Vec2& c = mesh_.points[triangle[2]];
      const Vec2 centre = (a + b + c) / 3;
      const Vec2 u = b - a;
      const Vec2 v = c - a;
      const double wanted = size(centre) / edge_length_;
      const double mass = (u.x() * v.y() - u.y() * v.x()) / (wanted * wanted * wanted * wanted);
      for (const int corner : triangle) {
        if (corner < border_) continue;
        sum[corner - border_] += mass * centre;
        weight[corner - border_] += mass;
      }
    }
    for (std::size_t i = kept_; i < interior_.size(); ++i) {
      if (!(weight[i] > 0)) continue;
      const Vec2 moved = sum[i] / weight[i];
      // A point that moves by less than its distance from the border can't leave the polygon.
      const double room = std::min(border_distance(interior_[i]), edge_length_);
      if ((moved - interior_[i]).norm() >= room && !is_within(moved)) continue;
      if (border_distance(moved) >= border_clearance * size(moved)) interior_[i] = moved;
    }
  }

  /// Flips edges that run from border to border where the new triangles are not sharp. It returns
  /// whether it flipped any. A triangle changes once a pass, so `sides` stays right for the others.
  bool uncross() {
    std::map<std::array<int, 2>, std::array<int, 2>> sides;  // edge to (triangle, corner across)
    std::vector<bool> changed(mesh_.triangles.size(), false);
    bool any = false;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (int k = 0; k < 3 && !changed[t]; ++k) {
        const int a = mesh_.triangles[t][(k + 1) % 3];
        const int b = mesh_.triangles[t][(k + 2) % 3];
        if (a >= border_ || b >= border_) continue;
        const auto [found, added] =
            sides.try_emplace({std::min(a, b), std::max(a, b)}, std::array{static_cast<int>(t), k});
        const auto [other, corner] = found->second;
        if (added || changed[other] || !flip(other, corner, static_cast<int>(t), k)) continue;
        changed[t] = changed[other] = any = true;
      }
    }
    return any;
  }

  /// Replaces the edge across from corner `k` of triangle `first` and corner `l` of `second` by the
  /// edge between those corners. It does so if an end of the new edge is interior and no new angle
  /// is sharp.
  bool flip(int first, int k, int second, int l) {
    const Triangle one = mesh_.triangles[first];
    const Triangle two = mesh_.triangles[second];
    const int c = one[k];
    const int d = two[l];
    if (c < border_ && d < border_) return false;
    const Triangle left = {c, one[(k + 1) % 3], d};
    const Triangle right = {d, one[(k + 2) % 3], c};
    if (std::min(angle_of(mesh_, left), angle_of(mesh_, right)) < crossing_angle) return false;
    mesh_.triangles[first] = left;
    mesh_.triangles[second] = right;
    return true;
  }

  const std::vector<Vec2>& outline_;
  const std::vector<std::vector<Vec2>>& holes_;
  double edge_length_;
  std::vector<Vec2> border_points_;  ///< of the outline, then of the holes
  std::vector<int> next_;            ///< per border point, the next one of its polygon
  int border_ = 0;                   ///< number of border points
  Box box_;
  BucketGrid segments_;  ///< border segments
  BucketGrid points_;    ///< border points, and interior points as they are placed
  std::vector<Vec2> middles_;
  std::vector<double> lengths_;
  std::vector<Vec2> interior_;
  std::size_t kept_ = 0;  ///< number of first interior points that smoothing does not move
  PlanarMesh mesh_;
};

}  // namespace

void raise_angles(PlanarMesh& mesh, const std::vector<bool>& fixed, double good) {
  std::vector<std::vector<int>> around(mesh.points.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const int corner : mesh.triangles[t]) around[corner].push_back(static_cast<int>(t));
  }
  const auto worst_at = [&](std::size_t point) {
    double worst = std::numbers::pi;
    for (const int t : around[point]) worst = std::min(worst, angle_of(mesh, t));
    return worst;
  };
  std::vector<std::size_t> poor;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (!fixed[i] && worst_at(i) < good) poor.push_back(i);
  }
  double step = 0.2;
  for (int sweep = 0; sweep < raising_sweeps; ++sweep, step *= 0.8) {
    for (const std::size_t i : poor) {
      double best = worst_at(i);
      if (best > good) continue;
      const Vec2 from = mesh.points[i];
      double reach = std::numeric_limits<double>::max();
      for (const int t : around[i]) {
        for (const int corner : mesh.triangles[t]) {
          if (static_cast<std::size_t>(corner) == i) continue;
          reach = std::min(reach, step * (mesh.points[corner] - from).norm());
        }
      }
      Vec2 best_point = from;
      for (int k = 0; k < 8; ++k) {
        const double turn = k * std::numbers::pi / 4;
        mesh.points[i] = from + reach * Vec2(std::cos(turn), std::sin(turn));
        const double worst = worst_at(i);
        if (worst > best + 1e-6) {
          best = worst;
          best_point = mesh.points[i];
        }
      }
      mesh.points[i] = best_point;
    }
  }
}

PlanarMesh mesh_polygon(const std::vector<Vec2>& outline, double edge_length,
                        const std::vector<int>& split_corners,
                        const std::vector<std::vector<Vec2>>& holes) {
  return Filler(outline, holes, edge_length).fill(split_corners);
}

}  // namespace toile
