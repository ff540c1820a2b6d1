#include "pattern/import/shape_axis.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/angles.h"
#include "geometry/polygon.h"
#include "pattern/import/half_pieces.h"

namespace toile {

namespace {

/// Radians: an outline that turns by more from one chord to the next has a corner there. Chords of
/// curves turn by less. Half and double of it change the turn of none of 14 drawings.
constexpr double side_ends = to_radians(6);

/// Radians by which the corner of a fold may differ from a right one. Half and double of it change
/// the turn of none of 14 drawings.
constexpr double right_within = to_radians(2);

/// Metres: how straight a side is, and how far the piece may reach across it.
constexpr double side_straightness = 1e-3;

double cross_of(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

Vec2 unit_at(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Sides between corners, as indices of points, in the order of the outline.
std::vector<std::size_t> side_corners(const std::vector<Vec2>& outline) {
  std::vector<std::size_t> corners;
  const std::size_t count = outline.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 in = outline[i] - outline[(i + count - 1) % count];
    const Vec2 out = outline[(i + 1) % count] - outline[i];
    if (std::abs(std::atan2(cross_of(in, out), in.dot(out))) > side_ends) corners.push_back(i);
  }
  return corners;
}

/// Whether the outline turns by a right angle at a point, to the left.
bool is_square_corner(const std::vector<Vec2>& outline, std::size_t corner) {
  const std::size_t count = outline.size();
  const Vec2 in = outline[corner] - outline[(corner + count - 1) % count];
  const Vec2 out = outline[(corner + 1) % count] - outline[corner];
  return std::abs(std::atan2(cross_of(in, out), in.dot(out)) - std::numbers::pi / 2) < right_within;
}

/// The longest straight side with all of the piece beside it and a right angle at an end.
std::optional<Vec2> longest_square_side(const std::vector<Vec2>& outline) {
  std::optional<Vec2> best;
  const std::vector<std::size_t> corners = side_corners(outline);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::size_t from = corners[k];
    const std::size_t to = corners[(k + 1) % corners.size()];
    const Vec2 side = outline[to] - outline[from];
    if (best && side.norm() <= best->norm() * (1 + 1e-9)) continue;
    if (!(side.norm() > side_straightness)) continue;
    if (!is_square_corner(outline, from) && !is_square_corner(outline, to)) continue;
    bool straight = true;
    for (std::size_t i = from; i != to && straight; i = (i + 1) % outline.size()) {
      straight = distance_to_segment(outline[i], outline[from], outline[to]) <= side_straightness;
    }
    // The outline is counter-clockwise: all of the piece lies to the left.
    const bool beside =
        straight && std::all_of(outline.begin(), outline.end(), [&](const Vec2& point) {
          return cross_of(side, point - outline[from]) > -side_straightness * side.norm();
        });
    if (beside) best = side;
  }
  return best;
}

}  // namespace

double longest_direction(const std::vector<Vec2>& outline) {
  double area = 0;
  Vec2 first = Vec2::Zero();
  const Vec2 origin = outline.front();  // far from which products lose digits
  const std::size_t count = outline.size();
  const auto each_triangle = [&](const auto& visit) {
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2 a = outline[i] - origin;
      const Vec2 b = outline[(i + 1) % count] - origin;
      visit(a, b, cross_of(a, b) / 2);
    }
  };
  each_triangle([&](const Vec2& a, const Vec2& b, double triangle) {
    area += triangle;
    first += triangle * (a + b) / 3;
  });
  const Vec2 middle = first / area;
  double xx_yy = 0;
  double xy = 0;
  each_triangle([&](const Vec2& a, const Vec2& b, double triangle) {
    xx_yy += triangle *
             (a.x() * a.x() + a.x() * b.x() + b.x() * b.x() - a.y() * a.y() - a.y() * b.y() -
              b.y() * b.y()) /
             6;
    xy += triangle * (2 * a.x() * a.y() + a.x() * b.y() + b.x() * a.y() + 2 * b.x() * b.y()) / 12;
  });
  xx_yy -= area * (middle.x() * middle.x() - middle.y() * middle.y());
  xy -= area * middle.x() * middle.y();
  return std::atan2(2 * xy, xx_yy) / 2;
}

std::optional<ShapeAxis> shape_axis(const std::vector<Vec2>& outline) {
  // Mirror images have their line along or across the longest direction.
  const double longest = longest_direction(outline);
  const bool mirrored_along = is_mirror_image(outline, unit_at(longest + std::numbers::pi / 2));
  const bool mirrored_across = is_mirror_image(outline, unit_at(longest));
  if (mirrored_along && mirrored_across) return std::nullopt;
  if (mirrored_along || mirrored_across) return ShapeAxis{longest, true};
  const auto side = longest_square_side(outline);
  if (!side) return std::nullopt;
  return ShapeAxis{std::atan2(side->y(), side->x()), false};
}

}  // namespace toile
