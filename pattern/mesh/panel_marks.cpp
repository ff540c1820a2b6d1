#include "pattern/mesh/panel_marks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <queue>
#include <set>

#include "geometry/angles.h"
#include "geometry/bucket_grid.h"
#include "geometry/polygon.h"
#include "geometry/triangulate.h"
#include "pattern/constants.h"

namespace toile {

namespace {

using Line = std::vector<Vec2>;

/// Of an edge length: how far a point is moved onto a mark. Of 420 marks drawn at random in a
/// square, 17 are lost. With half of it 134 are, with double 16.
constexpr double reach = 0.9;

/// Of an edge length: how far points between the fixed ones are moved onto a line. Beside another
/// line, as at the tip of a dart, the next free ones are a row farther.
constexpr double line_reach = 1.6;

/// Of an edge length: corners and crossings that are nearer to each other on a line are one.
constexpr double least_spacing = 0.6;

/// Radians that a line turns from one place that is fixed to a point to the next, at most.
constexpr double most_turn = to_radians(60);

/// Of an edge length: a line that ends nearer to the border ends on it.
constexpr double border_reach = 0.5;

/// Radians that a line turns at a corner.
constexpr double corner_turn = to_radians(20);

/// Radians: a line that turns less at a point makes a flat triangle of it and its two neighbours.
constexpr double sharp_turn = to_radians(45);

/// Radians: marks that leave a smaller angle beside them are lost.
constexpr double least_angle = to_radians(5);

/// Rounds in which points on a line spread over it. With none, edges on lines have 0.4 to 1.4 of
/// the edge length; with 5 and with 10, 0.7 to 1.2.
constexpr int spreading_rounds = 5;

/// Metres: places that are nearer are one.
constexpr double same_place = 1e-6;

/// Where two segments cross, as shares of both; nothing for parallel ones.
std::optional<std::array<double, 2>> crossing(const Vec2& p, const Vec2& q, const Vec2& r,
                                              const Vec2& s) {
  const Vec2 u = q - p;
  const Vec2 v = s - r;
  const double area = u.x() * v.y() - u.y() * v.x();
  if (std::abs(area) < 1e-12 * u.norm() * v.norm()) return std::nullopt;
  const Vec2 w = r - p;
  const double at = (w.x() * v.y() - w.y() * v.x()) / area;
  const double other = (w.x() * u.y() - w.y() * u.x()) / area;
  if (at < 0 || at > 1 || other < 0 || other > 1) return std::nullopt;
  return std::array{at, other};
}

/// The parts of a line that lie inside the outline.
std::vector<Line> inside_parts(const Line& line, const Line& outline) {
  std::vector<Line> parts;
  bool goes_on = false;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    std::vector<double> cuts = {0, 1};
    for (std::size_t j = 0; j < outline.size(); ++j) {
      const auto at = crossing(line[i], line[i + 1], outline[j], outline[(j + 1) % outline.size()]);
      if (at) cuts.push_back((*at)[0]);
    }
    std::sort(cuts.begin(), cuts.end());
    const auto place = [&](double share) -> Vec2 {
      return line[i] + share * (line[i + 1] - line[i]);
    };
    for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
      const Vec2 from = place(cuts[c]);
      const Vec2 to = place(cuts[c + 1]);
      if ((to - from).norm() < same_place) continue;
      const bool is_inside = inside(outline, (from + to) / 2);
      if (is_inside && !goes_on) parts.push_back({from});
      if (is_inside) parts.back().push_back(to);
      goes_on = is_inside;
    }
  }
  return parts;
}

/// A line walked by length.
class Walk {
 public:
  explicit Walk(const Line& line) : line_(line), lengths_{0} {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      lengths_.push_back(lengths_.back() + (line[i + 1] - line[i]).norm());
    }
  }
  double length() const { return lengths_.back(); }
  double length_at(std::size_t point) const { return lengths_[point]; }
  Vec2 at(double length) const {
    const auto after = std::upper_bound(lengths_.begin(), lengths_.end(), length);
    if (after == lengths_.end()) return line_.back();
    const auto i = static_cast<std::size_t>(after - lengths_.begin());
    const double share = (length - lengths_[i - 1]) / (lengths_[i] - lengths_[i - 1]);
    return line_[i - 1] + share * (line_[i] - line_[i - 1]);
  }
  /// The length between `from` and `to` at which the line is nearest to `p`.
  double nearest(const Vec2& p, double from, double to) const {
    double least = std::numeric_limits<double>::infinity();
    double best = from;
    for (std::size_t i = 0; i + 1 < line_.size(); ++i) {
      if (lengths_[i + 1] <= from || lengths_[i] >= to) continue;
      const Vec2 run = line_[i + 1] - line_[i];
      const double share = std::clamp((p - line_[i]).dot(run) / run.squaredNorm(), 0.0, 1.0);
      const double distance = (line_[i] + share * run - p).norm();
      if (distance >= least) continue;
      least = distance;
      best = lengths_[i] + share * (lengths_[i + 1] - lengths_[i]);
    }
    return std::clamp(best, from, to);
  }
  /// Radians that the line turns at a length, between chords of `spread` metres.
  double turn_at(double length, double spread) const {
    const Vec2 in = at(length) - at(std::max(0.0, length - spread));
    const Vec2 out = at(std::min(this->length(), length + spread)) - at(length);
    return std::abs(std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out)));
  }
  /// The line between two lengths.
  Line part(double from, double to) const {
    Line part = {at(from)};
    for (std::size_t i = 0; i < line_.size(); ++i) {
      if (lengths_[i] > from && lengths_[i] < to) part.push_back(line_[i]);
    }
    part.push_back(at(to));
    return part;
  }

 private:
  const Line& line_;
  std::vector<double> lengths_;
};

double distance_to(const Line& line, const Vec2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    least = std::min(least, distance_to_segment(p, line[i], line[i + 1]));
  }
  return least;
}

/// A part of a line, and the lengths at which points are fixed to it.
struct Piece {
  int index = 0;  ///< of the line
  Line line;
  std::vector<double> stops;
};

/// Lengths of corners and crossings, and of others where a curve turns. None are nearer to each
/// other than triangles allow; both ends stay.
std::vector<double> stops_of(const Line& line, std::vector<double> crossings, double edge_length) {
  const Walk walk(line);
  std::vector<double> wanted = std::move(crossings);
  double turned = 0;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const Vec2 in = line[i] - line[i - 1];
    const Vec2 out = line[i + 1] - line[i];
    const double turn = std::abs(std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out)));
    turned += turn;
    if (turn <= corner_turn && turned <= most_turn) continue;
    wanted.push_back(walk.length_at(i));
    turned = 0;
  }
  wanted.push_back(walk.length());
  std::sort(wanted.begin(), wanted.end());
  std::vector<double> stops = {0};
  const double least = least_spacing * edge_length;
  for (const double stop : wanted) {
    const bool is_end = stop == walk.length();
    while (is_end && stops.size() > 1 && stop - stops.back() < least) stops.pop_back();
    if (is_end || stop - stops.back() >= least) stops.push_back(stop);
  }
  return stops;
}

class Marker {
 public:
  Marker(PlanarMesh& mesh, const std::vector<bool>& border, double edge_length)
      : mesh_(mesh),
        border_(border),
        edge_length_(edge_length),
        drawn_(mesh.points),
        around_(mesh.points.size()),
        beside_(mesh.points.size()) {
    Vec2 low = drawn_.front();
    Vec2 high = low;
    for (const Vec2& p : drawn_) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    grid_.emplace(low, high, edge_length);
    for (std::size_t i = 0; i < drawn_.size(); ++i) grid_->add(drawn_[i], static_cast<int>(i));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        const int corner = mesh.triangles[t][k];
        around_[corner].push_back(static_cast<int>(t));
        for (const int other : {mesh.triangles[t][(k + 1) % 3], mesh.triangles[t][(k + 2) % 3]}) {
          beside_[corner].push_back(other);
        }
      }
    }
    for (std::vector<int>& others : beside_) {
      std::sort(others.begin(), others.end());
      others.erase(std::unique(others.begin(), others.end()), others.end());
    }
  }

  PointedMarks run(const DrawnMarks& drawn) {
    const std::vector<Piece> pieces = pieces_of(drawn, edge_length_);
    std::vector<char> is_hole_lost(drawn.holes.size(), 0);
    std::vector<char> is_piece_lost(pieces.size(), 0);
    // Each round loses a mark at least.
    for (;;) {
      PointedMarks found = point(drawn, pieces, is_hole_lost, is_piece_lost);
      if (found.marks.empty()) {
        mesh_.points = drawn_;
      } else {
        raise_angles(mesh_, fixed(), acceptable_angle);
      }
      bool any = false;
      std::size_t piece = 0;
      for (std::size_t m = 0; m < found.marks.size(); ++m) {
        const PointedMark& mark = found.marks[m];
        const bool is_sharp =
            std::ranges::any_of(mark.points, [&](int p) { return worst_at(p) < least_angle; });
        if (mark.is_line) {
          while (is_piece_lost[piece]) ++piece;
          is_piece_lost[piece++] = is_sharp;
        } else {
          is_hole_lost[mark.index] = is_sharp;
        }
        any = any || is_sharp;
      }
      if (!any) {
        report_lost(drawn.lines.size(), pieces, is_hole_lost, is_piece_lost, found);
        return found;
      }
      mesh_.points = drawn_;
    }
  }

 private:
  static std::vector<Piece> pieces_of(const DrawnMarks& drawn, double edge_length) {
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < drawn.lines.size(); ++i) {
      for (Line& part : inside_parts(drawn.lines[i], drawn.outline)) {
        pieces.push_back({static_cast<int>(i), std::move(part), {}});
      }
    }
    std::vector<std::vector<double>> crossings = crossings_of(pieces, edge_length);
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      pieces[p].stops = stops_of(pieces[p].line, std::move(crossings[p]), edge_length);
    }
    return pieces;
  }

  /// Per piece, the lengths at which it crosses others.
  static std::vector<std::vector<double>> crossings_of(const std::vector<Piece>& pieces,
                                                       double edge_length) {
    struct Segment {
      std::size_t piece;
      Vec2 from;
      Vec2 to;
      double start;  // length of the piece up to it
    };
    std::vector<Segment> segments;
    Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
    Vec2 high = -low;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      const Walk walk(pieces[p].line);
      for (std::size_t i = 0; i + 1 < pieces[p].line.size(); ++i) {
        segments.push_back({p, pieces[p].line[i], pieces[p].line[i + 1], walk.length_at(i)});
        low = low.cwiseMin(pieces[p].line[i].cwiseMin(pieces[p].line[i + 1]));
        high = high.cwiseMax(pieces[p].line[i].cwiseMax(pieces[p].line[i + 1]));
      }
    }
    std::vector<std::vector<double>> crossings(pieces.size());
    if (segments.empty()) return crossings;
    BucketGrid grid(low, high, edge_length);
    for (std::size_t s = 0; s < segments.size(); ++s) {
      grid.add(segments[s].from, segments[s].to, static_cast<int>(s));
    }
    for (const Segment& mine : segments) {
      const double length = (mine.to - mine.from).norm();
      grid.near((mine.from + mine.to) / 2, length / 2, [&](int s) {
        const Segment& other = segments[s];
        if (other.piece == mine.piece) return;
        const auto at = crossing(mine.from, mine.to, other.from, other.to);
        if (at) crossings[mine.piece].push_back(mine.start + (*at)[0] * length);
      });
    }
    return crossings;
  }

  /// Moves points onto all marks that are not lost. Marks that find no points become lost.
  PointedMarks point(const DrawnMarks& drawn, const std::vector<Piece>& pieces,
                     std::vector<char>& is_hole_lost, std::vector<char>& is_piece_lost) {
    taken_.clear();
    PointedMarks found;
    for (std::size_t h = 0; h < drawn.holes.size(); ++h) {
      if (is_hole_lost[h]) continue;
      if (const auto p = take(drawn.holes[h], false)) {
        found.marks.push_back({false, static_cast<int>(h), {*p}});
      } else {
        is_hole_lost[h] = 1;
      }
    }
    std::vector<std::vector<int>> fixed_points(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (is_piece_lost[i]) continue;
      const Walk walk(pieces[i].line);
      for (const double stop : pieces[i].stops) {
        const bool is_end = stop == 0 || stop == walk.length();
        const auto p = take(walk.at(stop), is_end);
        if (!p) {
          is_piece_lost[i] = 1;
          break;
        }
        fixed_points[i].push_back(*p);
      }
    }
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (is_piece_lost[i]) continue;
      if (auto points = connect(pieces[i], fixed_points[i])) {
        found.marks.push_back({true, pieces[i].index, std::move(*points)});
      } else {
        is_piece_lost[i] = 1;
      }
    }
    return found;
  }

  /// The point that stands for `at`: one that is there, or the nearest one that is free, moved.
  std::optional<int> take(const Vec2& at, bool may_be_border) {
    int nearest = -1;
    int there = -1;
    double least = reach * edge_length_;
    double border_distance = std::numeric_limits<double>::infinity();
    int border_point = -1;
    grid_->near(at, edge_length_, [&](int p) {
      const double distance = (drawn_[p] - at).norm();
      if (taken_.contains(p) && (mesh_.points[p] - at).norm() < same_place) there = p;
      if (border_[p] && distance < border_distance) {
        border_distance = distance;
        border_point = p;
      }
      if (border_[p] || taken_.contains(p)) return;
      if (distance > least || (distance == least && p > nearest)) return;
      least = distance;
      nearest = p;
    });
    if (there >= 0) return there;
    if (may_be_border && border_point >= 0 && reaches_border(at, border_point)) {
      return border_point;
    }
    if (nearest < 0) return std::nullopt;
    taken_.insert(nearest);
    mesh_.points[nearest] = at;
    return nearest;
  }

  /// Whether `at` lies on the border's edges at a border point, or nearly.
  bool reaches_border(const Vec2& at, int border_point) const {
    double least = (drawn_[border_point] - at).norm();
    for (const int other : beside_[border_point]) {
      if (!border_[other]) continue;
      least = std::min(least, distance_to_segment(at, drawn_[border_point], drawn_[other]));
    }
    return least < border_reach * edge_length_;
  }

  /// Joins the points fixed to a piece by edges, and moves the points between them onto it.
  std::optional<std::vector<int>> connect(const Piece& piece, const std::vector<int>& stops) {
    const Walk walk(piece.line);
    std::vector<int> all = {stops.front()};
    for (std::size_t s = 0; s + 1 < stops.size(); ++s) {
      const double from = piece.stops[s];
      const double to = piece.stops[s + 1];
      const bool turns = s > 0 && walk.turn_at(from, least_spacing * edge_length_) > sharp_turn;
      const int before = all.size() > 1 && !turns ? all[all.size() - 2] : -1;
      const auto path = path_along(walk.part(from, to), stops[s], stops[s + 1], before);
      if (!path) return std::nullopt;
      const std::vector<double> lengths = spread(walk, from, to, *path);
      for (std::size_t k = 1; k + 1 < path->size(); ++k) {
        mesh_.points[(*path)[k]] = walk.at(lengths[k]);
        taken_.insert((*path)[k]);
      }
      all.insert(all.end(), path->begin() + 1, path->end());
    }
    return all;
  }

  /// Lengths of the walk for the points of a path: near to where they are, in order, and evened
  /// out.
  std::vector<double> spread(const Walk& walk, double from, double to,
                             const std::vector<int>& path) const {
    std::vector<double> lengths = {from};
    for (std::size_t k = 1; k + 1 < path.size(); ++k) {
      lengths.push_back(std::max(lengths.back(), walk.nearest(drawn_[path[k]], from, to)));
    }
    lengths.push_back(to);
    for (int round = 0; round < spreading_rounds; ++round) {
      for (std::size_t k = 1; k + 1 < lengths.size(); ++k) {
        lengths[k] = (lengths[k - 1] + lengths[k + 1]) / 2;
      }
    }
    return lengths;
  }

  /// The shortest way from point to point over free points beside the line. It does not begin with
  /// a point beside `before`, the last one on the line up to `from`: all three would be one flat
  /// triangle.
  std::optional<std::vector<int>> path_along(const Line& line, int from, int to, int before) const {
    if (from == to) return std::nullopt;
    std::map<int, std::pair<double, int>> best;  // per point, the cost of the way, and its last one
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
    front.emplace(0, from);
    best[from] = {0, -1};
    while (!front.empty()) {
      const auto [cost, at] = front.top();
      front.pop();
      if (cost > best[at].first) continue;
      if (at == to) break;
      for (const int next : beside_[at]) {
        if (at == from && before >= 0 && std::ranges::binary_search(beside_[before], next))
          continue;
        double off = 0;
        if (next != to) {
          if (border_[next] || taken_.contains(next)) continue;
          off = distance_to(line, drawn_[next]) / edge_length_;
          if (off > line_reach) continue;
        }
        const double length = (drawn_[next] - drawn_[at]).norm();
        const double whole = cost + length * (1 + 4 * off * off);
        const auto found = best.find(next);
        if (found != best.end() && found->second.first <= whole) continue;
        best[next] = {whole, at};
        front.emplace(whole, next);
      }
    }
    if (!best.contains(to)) return std::nullopt;
    std::vector<int> path;
    for (int p = to; p >= 0; p = best[p].second) path.push_back(p);
    std::reverse(path.begin(), path.end());
    return path;
  }

  double worst_at(int p) const {
    double worst = std::numbers::pi;
    for (const int t : around_[p]) {
      const auto& [a, b, c] = mesh_.triangles[t];
      worst = std::min(worst, smallest_angle(mesh_.points[a], mesh_.points[b], mesh_.points[c]));
    }
    return worst;
  }

  std::vector<bool> fixed() const {
    std::vector<bool> fixed = border_;
    for (const int p : taken_) fixed[p] = true;
    return fixed;
  }

  static void report_lost(std::size_t lines, const std::vector<Piece>& pieces,
                          const std::vector<char>& is_hole_lost,
                          const std::vector<char>& is_piece_lost, PointedMarks& found) {
    for (std::size_t h = 0; h < is_hole_lost.size(); ++h) {
      if (is_hole_lost[h]) found.lost_holes.push_back(static_cast<int>(h));
    }
    std::vector<char> is_shown(lines, 0);
    for (const Piece& piece : pieces) is_shown[piece.index] = 1;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (is_piece_lost[i]) is_shown[pieces[i].index] = 0;
    }
    for (std::size_t l = 0; l < lines; ++l) {
      if (!is_shown[l]) found.lost_lines.push_back(static_cast<int>(l));
    }
  }

  PlanarMesh& mesh_;
  const std::vector<bool>& border_;
  double edge_length_;
  std::vector<Vec2> drawn_;               ///< points before any was moved
  std::vector<std::vector<int>> around_;  ///< triangles at each point
  std::vector<std::vector<int>> beside_;  ///< points that share an edge with each, in order
  std::optional<BucketGrid> grid_;        ///< of all points
  std::set<int> taken_;                   ///< points on marks
};

}  // namespace

PointedMarks put_marks_on_mesh(PlanarMesh& mesh, const std::vector<bool>& border,
                               const DrawnMarks& drawn, double edge_length) {
  if (drawn.lines.empty() && drawn.holes.empty()) return {};
  return Marker(mesh, border, edge_length).run(drawn);
}

}  // namespace toile
