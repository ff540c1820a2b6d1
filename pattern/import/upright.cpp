#include "pattern/import/upright.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <optional>

#include "geometry/angles.h"
#include "geometry/polygon.h"

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

}  // namespace

UprightTurns upright_turns(const std::vector<PieceShape>& shapes) {
  UprightTurns upright;
  const auto axis = drawing_axis(shapes);
  upright.has_grain = axis.has_value();
  upright.drawing = axis ? -*axis : 0;
  double area = 0;
  double turning_above = 0;
  double area_below = 0;
  for (const PieceShape& shape : shapes) {
    const auto grain = grain_of(shape);
    const double off = grain ? line_angle(*grain - axis.value_or(0)) : 0;
    const bool on_purpose = are_near(off, std::numbers::pi / 4) ||
                            are_near(off, -std::numbers::pi / 4) ||
                            are_near(off, std::numbers::pi / 2);
    upright.off_grain.push_back(on_purpose);
    upright.turns.push_back(upright.drawing - (on_purpose ? 0 : off));
    const double own = signed_area(shape.outline);
    area += own;
    const Heights heights = heights_of(shape.outline, upright.turns.back());
    turning_above += own * heights.turning;
    area_below -= own * heights.area;
  }
  const double least = telling_height * area;
  const bool upside_down = turning_above < -least && area_below < -least;
  upright.end_by_shape = upside_down || (turning_above > least && area_below > least);
  if (upside_down) {
    upright.drawing += std::numbers::pi;
    for (double& turn : upright.turns) turn += std::numbers::pi;
  }
  return upright;
}

}  // namespace toile
