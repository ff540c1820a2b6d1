#include "pattern/import/upright.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <optional>

#include "geometry/angles.h"
#include "geometry/polygon.h"
#include "pattern/import/shape_axis.h"

namespace toile {

namespace {

/// Radians: grains that differ by less are one. A grain as near to 45 or 90 degrees of the
/// drawing's is cut so on purpose. Half and double of it change nothing in 58 drawings: their
/// grains differ by 0 or 90 degrees.
constexpr double same_grain = to_radians(5);

/// Share of the outlines' length that has to agree on two directions at right angles, before the
/// grain is said to cross them. Half and double of it change none of 58 drawings.
constexpr double square_share = 0.4;

/// Heights of a piece by which the middle of its turning lies above that of its box, and the middle
/// of its area below. From here on both together tell the upper end. Of 91 drawings and patterns
/// that are drawn upright, 47 tell it and none wrongly. With half of it 52 do, and one is wrong;
/// with double of it 38.
constexpr double telling_height = 0.01;

/// Share of the telling area whose lines have to agree, before a drawing without grain lines is
/// turned as a whole. In all but the nested one of 14 they agree, and in that half. Half of it
/// turns that as a whole; with double of it pieces of all are turned one by one.
constexpr double lying_alike = 0.75;

/// The angle of a line without direction, from -90 degrees to 90, not included. So the right end of
/// what is drawn sideways is up, if nothing else tells. It is in all of 12 files of the industry
/// whose shapes tell it.
double line_angle(double angle) {
  angle = std::remainder(angle, std::numbers::pi);
  return angle >= std::numbers::pi / 2 - 1e-9 ? angle - std::numbers::pi : angle;
}

/// Radians from +y to the grain line.
std::optional<double> grain_of(const PieceShape& shape) {
  if (!shape.grain) return std::nullopt;
  const Vec2 warp = shape.grain->to - shape.grain->from;
  if (!(warp.norm() > 0)) return std::nullopt;
  return line_angle(std::atan2(warp.y(), warp.x()) - std::numbers::pi / 2);
}

bool are_near(double a, double b) { return std::abs(line_angle(a - b)) <= same_grain; }

/// How an outline lies when it is turned. Its height is metres. The middles of its turning and of
/// its area are counted from that of its box, in heights.
struct Heights {
  double height = 0;
  double turning = 0;
  double area = 0;
};

Heights heights_of(const std::vector<Vec2>& outline, double turned) {
  const Vec2 up(std::sin(turned), std::cos(turned));
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  double turning = 0;
  double turning_height = 0;
  double area = 0;
  double area_height = 0;
  const Vec2& origin = outline.front();  // far from which products lose digits
  const std::size_t count = outline.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 at = outline[i] - origin;
    const Vec2 in = outline[i] - outline[(i + count - 1) % count];
    const Vec2 out = outline[(i + 1) % count] - outline[i];
    const double turn = std::abs(std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out)));
    const double height = at.dot(up);
    low = std::min(low, height);
    high = std::max(high, height);
    turning += turn;
    turning_height += turn * height;
    const double triangle = at.x() * out.y() - at.y() * out.x();
    area += triangle;
    area_height += triangle * (2 * height + out.dot(up)) / 3;
  }
  const double middle = (low + high) / 2;
  return {high - low, (turning_height / turning - middle) / (high - low),
          (area_height / area - middle) / (high - low)};
}

/// 1: the upper end is up; -1: it is below; 0: they don't tell. `all` is what heights count for.
int upper_end(const Heights& heights, double all) {
  const double least = telling_height * all;
  if (heights.turning > least && heights.area < -least) return 1;
  return heights.turning < -least && heights.area > least ? -1 : 0;
}

/// Whether straight edges lie at 45 degrees to the axis, all pieces taken together.
bool is_all_bias(const std::vector<PieceShape>& shapes, double axis) {
  std::complex<double> sum = 0;
  double length = 0;
  for (const PieceShape& shape : shapes) {
    for (std::size_t i = 0; i < shape.outline.size(); ++i) {
      const Vec2 run = shape.outline[(i + 1) % shape.outline.size()] - shape.outline[i];
      // Four times the angle: directions at right angles to each other are one.
      sum += std::polar(run.norm(), 4 * (std::atan2(run.y(), run.x()) - axis));
      length += run.norm();
    }
  }
  return std::abs(sum) > square_share * length && std::abs(std::arg(-sum)) <= 4 * same_grain;
}

/// The grain that most of the area has.
std::optional<double> drawing_axis(const std::vector<PieceShape>& shapes) {
  std::optional<double> axis;
  double most = 0;
  double largest = 0;
  for (const PieceShape& shape : shapes) {
    const auto grain = grain_of(shape);
    if (!grain) continue;
    double area = 0;
    for (const PieceShape& other : shapes) {
      const auto others = grain_of(other);
      if (others && are_near(*others, *grain)) area += signed_area(other.outline);
    }
    const double own = signed_area(shape.outline);
    const bool as_much = area > most * (1 - 1e-9);
    if (area <= most * (1 + 1e-9) && !(as_much && own > largest * (1 + 1e-9))) continue;
    most = area;
    largest = own;
    axis = grain;
  }
  if (!axis || !is_all_bias(shapes, *axis)) return axis;
  const auto height = [&](double turned) {
    double sum = 0;
    for (const PieceShape& shape : shapes) sum += heights_of(shape.outline, turned).height;
    return sum;
  };
  constexpr double eighth = std::numbers::pi / 4;
  return line_angle(height(-*axis - eighth) > height(-*axis + eighth) * (1 + 1e-9)
                        ? *axis + eighth
                        : *axis - eighth);
}

/// Of a direction and the one across it, the one along which both ends of the pieces differ more.
/// Hems lie at one end, necklines at the other, see upper_end(). Of 41 drawings it finds the grain
/// of all. What differs alike is cut along its longer way, and so it is where `ends_tell` is false:
/// a single half differs both ways. Radians from +y.
double square_axis(const std::vector<PieceShape>& shapes, double direction, bool ends_tell) {
  constexpr double quarter = std::numbers::pi / 2;
  double area = 0;
  double along = 0;
  double across = 0;
  double longer = 0;
  for (const PieceShape& shape : shapes) {
    const double own = signed_area(shape.outline);
    const Heights upright = heights_of(shape.outline, quarter - direction);
    const Heights lying = heights_of(shape.outline, -direction);
    area += own;
    along += own * (upright.turning - upright.area);
    across += own * (lying.turning - lying.area);
    longer += upright.height - lying.height;
  }
  const double more = std::abs(along) - std::abs(across);
  const bool alike = !ends_tell || std::abs(more) <= telling_height * area;
  return line_angle((alike ? longer : more) < 0 ? direction : direction - quarter);
}

/// What is turned in a drawing without grain lines.
struct ShapeTurns {
  std::vector<double> axes;  ///< of each piece, radians from +y
  bool nested = false;       ///< pieces lie askew to each other
};

/// Tells the warp of pieces without grain lines by their shapes. Nothing: no shape tells it.
std::optional<ShapeTurns> turns_by_shape(const std::vector<PieceShape>& shapes) {
  constexpr double quarter = std::numbers::pi / 2;
  std::vector<std::optional<ShapeAxis>> told;
  told.reserve(shapes.size());
  for (const PieceShape& shape : shapes) told.push_back(shape_axis(shape.outline));
  const auto is_square_to = [&](double a, double b) {
    return are_near(a, b) || are_near(a + quarter, b);
  };
  double all = 0;
  double most = 0;
  std::optional<double> axis;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (!told[i]) continue;
    all += signed_area(shapes[i].outline);
    double area = 0;
    for (std::size_t k = 0; k < shapes.size(); ++k) {
      if (told[k] && is_square_to(told[k]->angle, told[i]->angle)) {
        area += signed_area(shapes[k].outline);
      }
    }
    if (area <= most * (1 + 1e-9)) continue;
    most = area;
    axis = told[i]->angle;
  }
  if (!axis) return std::nullopt;
  ShapeTurns turns;
  turns.nested = most < lying_alike * all;
  if (!turns.nested) {
    const bool ends_tell = shapes.size() > 1 || told.front()->mirrored;
    turns.axes.assign(shapes.size(), square_axis(shapes, *axis, ends_tell));
    return turns;
  }
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const double angle = told[i] ? told[i]->angle : longest_direction(shapes[i].outline);
    const bool ends_tell = told[i] && told[i]->mirrored;
    turns.axes.push_back(square_axis({shapes[i]}, angle, ends_tell));
  }
  return turns;
}

}  // namespace

UprightTurns upright_turns(const std::vector<PieceShape>& shapes) {
  UprightTurns upright;
  const auto axis = drawing_axis(shapes);
  upright.has_grain = axis.has_value();
  const auto by_shape = axis ? std::nullopt : turns_by_shape(shapes);
  upright.by_shape = by_shape.has_value();
  upright.nested = by_shape && by_shape->nested;
  upright.drawing = axis ? -*axis : by_shape && !upright.nested ? -by_shape->axes.front() : 0;
  double area = 0;
  Heights sum;  // of pieces' areas by their heights
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const auto grain = grain_of(shapes[i]);
    const double off = grain ? line_angle(*grain - axis.value_or(0)) : 0;
    const bool on_purpose = are_near(off, std::numbers::pi / 4) ||
                            are_near(off, -std::numbers::pi / 4) ||
                            are_near(off, std::numbers::pi / 2);
    upright.off_grain.push_back(on_purpose);
    upright.turns.push_back(upright.nested ? -by_shape->axes[i]
                                           : upright.drawing - (on_purpose ? 0 : off));
    const double own = signed_area(shapes[i].outline);
    const Heights heights = heights_of(shapes[i].outline, upright.turns.back());
    if (upright.nested && upper_end(heights, 1) < 0) upright.turns.back() += std::numbers::pi;
    area += own;
    sum.turning += own * heights.turning;
    sum.area += own * heights.area;
  }
  if (upright.nested) return upright;
  const int upper = upper_end(sum, area);
  upright.end_by_shape = upper != 0;
  if (upper < 0) {
    upright.drawing += std::numbers::pi;
    for (double& turn : upright.turns) turn += std::numbers::pi;
  }
  return upright;
}

}  // namespace toile
