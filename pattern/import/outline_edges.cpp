#include "pattern/import/outline_edges.h"

#include <algorithm>
#include <cmath>

#include "geometry/angles.h"
#include "geometry/error.h"
#include "pattern/constants.h"

namespace toile {

namespace {

/// Metres: how far a direction is looked at, so that short chords do not make corners.
constexpr double direction_reach = 5e-4;

/// Metres: of several corners within this length of the outline, the sharpest counts.
constexpr double same_corner = 1e-3;

/// Radians: a point that the file declares to be a corner is one if the outline turns there by
/// more. Programs declare the ends of internal lines and points of curves, too. Of the
/// 832 edges of nine drawings it joins 305 to others; half of it joins 260, double 323.
constexpr double declared_turn = to_radians(10);

/// Metres: a notch that is nearer to a corner is at the corner.
constexpr double notch_at_corner = 3e-3;

/// Metres: a notch on the cut line is nearer to the sew line.
constexpr double notch_reach = 0.06;

/// Radians: sharper points are corners, however their neighbours turn.
constexpr double sharp_turn = to_radians(50);

/// Radians: sharper points are corners, even if the file declares others.
constexpr double undeclared_turn = to_radians(60);

/// Metres: chords of a rounding are shorter.
constexpr double rounding_chord = 0.02;

/// A closed outline with the length to each of its points.
class Ring {
 public:
  explicit Ring(const std::vector<Vec2>& points) : points_(points), lengths_(1, 0) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      lengths_.push_back(lengths_.back() + (points[(i + 1) % points.size()] - points[i]).norm());
    }
  }
  std::size_t count() const { return points_.size(); }
  double length() const { return lengths_.back(); }
  double to(std::size_t i) const { return lengths_[i]; }
  const Vec2& at(std::size_t i) const { return points_[i % points_.size()]; }
  double side(std::size_t i) const { return lengths_[i % count() + 1] - lengths_[i % count()]; }
  /// Metres along the outline between two lengths, the shorter way round.
  double between(double a, double b) const {
    const double apart = std::abs(a - b);
    return std::min(apart, length() - apart);
  }

  /// Radians by which the outline turns at a point, positive to the left.
  double turn(std::size_t i) const {
    std::size_t before = i + count() - 1;
    while (before + count() / 3 > i + count() && (at(i) - at(before)).norm() < direction_reach)
      --before;
    std::size_t after = i + 1;
    while (after < i + count() / 3 && (at(after) - at(i)).norm() < direction_reach) ++after;
    const Vec2 in = at(i) - at(before);
    const Vec2 out = at(after) - at(i);
    return std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
  }

 private:
  const std::vector<Vec2>& points_;
  std::vector<double> lengths_;  ///< to point i; the last is the whole
};

/// Where an outline is cut.
struct Cut {
  double at = 0;  ///< metres along the outline
  Vec2 point = Vec2::Zero();
};

std::vector<double> turns_of(const Ring& ring) {
  std::vector<double> turns;
  for (std::size_t i = 0; i < ring.count(); ++i) turns.push_back(ring.turn(i));
  return turns;
}

/// Whether a point belongs to a rounding in coarse chords.
bool in_rounding(const Ring& ring, const std::vector<double>& turns, std::size_t i) {
  const std::size_t count = ring.count();
  const auto alike = [&](std::size_t other, double side) {
    return side < rounding_chord && turns[other] * turns[i] > 0 &&
           std::abs(turns[other]) > 0.6 * std::abs(turns[i]);
  };
  return alike((i + count - 1) % count, ring.side(i + count - 1)) ||
         alike((i + 1) % count, ring.side(i));
}

void add_cut(std::vector<Cut>& cuts, const Ring& ring, const Cut& cut, double reach) {
  const bool there = std::any_of(cuts.begin(), cuts.end(), [&](const Cut& other) {
    return ring.between(other.at, cut.at) < reach;
  });
  if (!there) cuts.push_back(cut);
}

void refuse_more(std::size_t count, const std::string& place) {
  if (count <= static_cast<std::size_t>(max_panel_edges)) return;
  throw Error(place, "has more than " + std::to_string(max_panel_edges) + " corners and notches",
              "is it really a piece? a larger --corner-angle finds less corners");
}

std::vector<Cut> corners_of(const PieceShape& shape, const Ring& ring, double corner_angle,
                            const std::string& place_name) {
  std::vector<Cut> cuts;
  const std::vector<double> turns = turns_of(ring);
  refuse_more(shape.corners.size() + shape.notches.size(), place_name);
  std::vector<Cut> declared;
  for (const std::size_t i : declared_points(shape)) {
    if (shape.has_all_corners || std::abs(turns[i]) >= declared_turn)
      declared.push_back({ring.to(i), ring.at(i)});
  }
  const double angle =
      declared.size() >= 2 ? std::max(corner_angle, undeclared_turn) : corner_angle;
  std::vector<std::size_t> turned;
  for (std::size_t i = 0; i < ring.count(); ++i) {
    if (std::abs(turns[i]) < angle) continue;
    if (std::abs(turns[i]) < sharp_turn && in_rounding(ring, turns, i)) continue;
    turned.push_back(i);
  }
  refuse_more(turned.size() + shape.corners.size() + shape.notches.size(), place_name);
  std::stable_sort(turned.begin(), turned.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(turns[a]) > std::abs(turns[b]) + 1e-9;
  });
  // A declared corner near one that was found is that one. Of all corners, each is where it is.
  if (shape.has_all_corners) cuts = declared;
  for (const std::size_t i : turned) add_cut(cuts, ring, {ring.to(i), ring.at(i)}, same_corner);
  for (const Cut& cut : declared) add_cut(cuts, ring, cut, 2 * same_corner);
  return cuts;
}

/// Cuts an outline that has less than two corners.
void cut_round_outline(std::vector<Cut>& cuts, const Ring& ring) {
  if (cuts.empty()) {
    std::size_t lowest = 0;
    for (std::size_t i = 1; i < ring.count(); ++i) {
      if (ring.at(i).y() < ring.at(lowest).y()) lowest = i;
    }
    cuts.push_back({ring.to(lowest), ring.at(lowest)});
  }
  if (cuts.size() > 1) return;
  std::size_t far_point = 0;
  for (std::size_t i = 1; i < ring.count(); ++i) {
    const auto off = [&](std::size_t k) { return (ring.at(k) - cuts[0].point).norm(); };
    if (off(i) > off(far_point)) far_point = i;
  }
  cuts.push_back({ring.to(far_point), ring.at(far_point)});
}

/// The points of the outline from one cut to the next.
std::vector<Vec2> points_between(const Ring& ring, const Cut& from, const Cut& to) {
  constexpr double same = 1e-9;  // metres
  std::vector<Vec2> points = {from.point};
  const double end = to.at > from.at ? to.at : to.at + ring.length();
  for (std::size_t i = 0; i < 2 * ring.count(); ++i) {
    const double at = i < ring.count() ? ring.to(i) : ring.to(i - ring.count()) + ring.length();
    if (at > from.at + same && at < end - same) points.push_back(ring.at(i));
  }
  points.push_back(to.point);
  return points;
}

}  // namespace

EdgedOutline edges_of(const PieceShape& shape, const EdgeOptions& options,
                      const std::string& place) {
  const Ring ring(shape.outline);
  std::vector<Cut> cuts = corners_of(shape, ring, options.corner_angle, place);
  cut_round_outline(cuts, ring);
  EdgedOutline result;
  std::vector<std::pair<double, std::optional<double>>> notches;  // place, angle
  for (const PieceNotch& notch : shape.notches) {
    const OutlinePlace nearest_point = nearest_place(shape.outline, notch.at);
    if (nearest_point.distance > notch_reach) {
      ++result.far_notches;
      continue;
    }
    const std::size_t segment = nearest_point.segment;
    const Cut cut{ring.to(segment) + (nearest_point.at - ring.at(segment)).norm(),
                  nearest_point.at};
    add_cut(cuts, ring, cut, notch_at_corner);
    const auto nearest =
        std::min_element(cuts.begin(), cuts.end(), [&](const Cut& a, const Cut& b) {
          return ring.between(a.at, cut.at) < ring.between(b.at, cut.at);
        });
    notches.emplace_back(nearest->at, notch.angle);
  }
  std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.at < b.at; });
  const auto count = static_cast<int>(cuts.size());
  for (int i = 0; i < count; ++i) {
    const Cut& from = cuts[static_cast<std::size_t>(i)];
    const Cut& to = cuts[static_cast<std::size_t>((i + 1) % count)];
    result.vertices.push_back(from.point);
    result.edges.push_back({i, (i + 1) % count,
                            fit_curves(points_between(ring, from, to), 0.9 * options.chord_error)});
  }
  for (const auto& [at, angle] : notches) {
    const auto vertex = std::find_if(cuts.begin(), cuts.end(),
                                     [&, where = at](const Cut& cut) { return cut.at == where; });
    const auto index = static_cast<int>(vertex - cuts.begin());
    const bool twice =
        std::any_of(result.notches.begin(), result.notches.end(),
                    [&](const OutlineNotch& other) { return other.vertex == index; });
    if (!twice) result.notches.push_back({index, angle});
  }
  return result;
}

void number_alike(EdgedOutline& outline, const EdgedOutline& like) {
  const std::size_t count = outline.edges.size();
  if (count == 0 || count != like.edges.size()) return;
  const auto shares = [](const EdgedOutline& one) {
    std::vector<double> chords;
    double all = 0;
    for (const OutlineEdge& edge : one.edges) {
      const Vec2& from = one.vertices[static_cast<std::size_t>(edge.from)];
      chords.push_back((one.vertices[static_cast<std::size_t>(edge.to)] - from).norm());
      all += chords.back();
    }
    for (double& chord : chords) chord /= all;
    return chords;
  };
  const std::vector<double> own = shares(outline);
  const std::vector<double> wanted = shares(like);
  const auto off = [&](std::size_t shift) {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = i + shift < count ? i + shift : i + shift - count;
      sum += std::abs(own[at] - wanted[i]);
    }
    return sum;
  };
  std::size_t best = 0;
  for (std::size_t shift = 1; shift < count; ++shift) {
    if (off(shift) < off(best)) best = shift;
  }
  if (off(best) > off(0) / 2) return;
  const auto steps = static_cast<std::ptrdiff_t>(best);
  std::rotate(outline.vertices.begin(), outline.vertices.begin() + steps, outline.vertices.end());
  std::rotate(outline.edges.begin(), outline.edges.begin() + steps, outline.edges.end());
  for (std::size_t i = 0; i < count; ++i) {
    outline.edges[i].from = static_cast<int>(i);
    outline.edges[i].to = static_cast<int>((i + 1) % count);
  }
  for (OutlineNotch& notch : outline.notches) {
    notch.vertex =
        static_cast<int>((static_cast<std::size_t>(notch.vertex) + count - best) % count);
  }
}

}  // namespace toile
