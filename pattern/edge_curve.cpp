#include "pattern/edge_curve.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace toile {

namespace {

/// Nodes and weights of the 8-point Gauss-Legendre rule on [-1, 1] (its positive half).
constexpr std::array<double, 4> gauss_nodes = {0.1834346424956498, 0.5255324099163290,
                                               0.7966664774136267, 0.9602898564975363};
constexpr std::array<double, 4> gauss_weights = {0.3626837833783620, 0.3137066458778873,
                                                 0.2223810344533745, 0.1012285362903763};

/// Halvings of the parameter range at most. 40 close in on a cusp to 1e-12.
constexpr int deepest = 40;

}  // namespace

EdgeCurve EdgeCurve::line(const Vec2& start, const Vec2& end) {
  EdgeCurve curve;
  curve.points_ = {start, start, end, end};
  curve.length_ = (end - start).norm();
  return curve;
}

EdgeCurve EdgeCurve::quadratic(const Vec2& start, const Vec2& control, const Vec2& end) {
  return cubic(start, start + 2.0 / 3 * (control - start), end + 2.0 / 3 * (control - end), end);
}

EdgeCurve EdgeCurve::cubic(const Vec2& start, const Vec2& control1, const Vec2& control2,
                           const Vec2& end) {
  EdgeCurve curve;
  curve.kind_ = Kind::bezier;
  curve.points_ = {start, control1, control2, end};
  curve.marks_.push_back({0, 0});
  constexpr int pieces = 8;
  for (int i = 0; i < pieces; ++i) {
    const double from = static_cast<double>(i) / pieces;
    const double to = static_cast<double>(i + 1) / pieces;
    curve.measure(from, to, curve.bezier_length(from, to), 0);
  }
  curve.length_ = curve.marks_.back().length;
  return curve;
}

EdgeCurve EdgeCurve::arc(const Vec2& start, const Vec2& end, double radius, bool large,
                         bool right) {
  EdgeCurve curve;
  curve.kind_ = Kind::arc;
  curve.points_ = {start, start, end, end};
  const Vec2 chord = end - start;
  const double half = chord.norm() / 2;
  if (half == 0) return curve;
  curve.radius_ = std::max(radius, half);
  const double height = std::sqrt(std::max(0.0, (curve.radius_ - half) * (curve.radius_ + half)));
  const Vec2 left = Vec2(-chord.y(), chord.x()) / (2 * half);
  curve.centre_ = (start + end) / 2 + (right != large ? height : -height) * left;
  const Vec2 arm = start - curve.centre_;
  curve.from_angle_ = std::atan2(arm.y(), arm.x());
  const double small_angle = 2 * std::asin(std::min(1.0, half / curve.radius_));
  curve.sweep_ = large ? 2 * std::numbers::pi - small_angle : small_angle;
  curve.length_ = curve.radius_ * curve.sweep_;
  if (!right) curve.sweep_ = -curve.sweep_;
  return curve;
}

EdgeCurve EdgeCurve::chain(std::vector<EdgeCurve> parts) {
  if (parts.size() == 1) return parts.front();
  EdgeCurve curve;
  curve.kind_ = Kind::chain;
  curve.points_ = {parts.front().start(), parts.front().start(), parts.back().end(),
                   parts.back().end()};
  curve.marks_.push_back({0, 0});
  for (const EdgeCurve& part : parts) {
    curve.length_ += part.length();
    curve.marks_.push_back({curve.marks_.back().t + 1, curve.length_});
  }
  curve.parts_ = std::make_shared<const std::vector<EdgeCurve>>(std::move(parts));
  return curve;
}

EdgeCurve EdgeCurve::reversed() const {
  if (kind_ == Kind::line) return line(end(), start());
  if (kind_ == Kind::bezier) return cubic(points_[3], points_[2], points_[1], points_[0]);
  if (kind_ == Kind::straightened) {
    return drawn_->reversed().straightened(1 - kept_to_, 1 - kept_from_);
  }
  if (kind_ == Kind::chain) {
    std::vector<EdgeCurve> parts;
    for (auto part = parts_->rbegin(); part != parts_->rend(); ++part) {
      parts.push_back(part->reversed());
    }
    return chain(std::move(parts));
  }
  EdgeCurve arc = *this;
  arc.points_ = {end(), end(), start(), start()};
  arc.from_angle_ += sweep_;
  arc.sweep_ = -sweep_;
  return arc;
}

EdgeCurve EdgeCurve::moved_to(const Vec2& start, const Vec2& end) const {
  if (kind_ == Kind::line) return line(start, end);
  const Vec2 from = points_[3] - points_[0];
  const Vec2 to = end - start;
  const double turn = std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
  const double scale = to.norm() / from.norm();
  const Vec2 along = scale * Vec2(std::cos(turn), std::sin(turn));
  const auto moved = [&](const Vec2& point) -> Vec2 {
    const Vec2 arm = point - points_[0];
    return start + Vec2(along.x() * arm.x() - along.y() * arm.y(),
                        along.y() * arm.x() + along.x() * arm.y());
  };
  if (kind_ == Kind::straightened) {
    return drawn_->moved_to(start, end).straightened(kept_from_, kept_to_);
  }
  if (kind_ == Kind::bezier) return cubic(start, moved(points_[1]), moved(points_[2]), end);
  if (kind_ == Kind::chain) {
    std::vector<EdgeCurve> parts;
    for (const EdgeCurve& part : *parts_) {
      const bool last = &part == &parts_->back();
      const Vec2 from_point = parts.empty() ? start : parts.back().end();
      parts.push_back(part.moved_to(from_point, last ? end : moved(part.end())));
    }
    return chain(std::move(parts));
  }
  EdgeCurve arc = *this;
  arc.points_ = {start, start, end, end};
  arc.centre_ = moved(centre_);
  arc.radius_ *= scale;
  arc.from_angle_ += turn;
  arc.length_ *= scale;
  return arc;
}

EdgeCurve EdgeCurve::straight_at_start(double length) const {
  if (kind_ == Kind::line) return *this;
  return straightened(std::min(1.0, length / length_), 1);
}

EdgeCurve EdgeCurve::straight_at_end(double length) const {
  if (kind_ == Kind::line) return *this;
  return straightened(0, std::max(0.0, 1 - length / length_));
}

EdgeCurve EdgeCurve::straightened(double kept_from, double kept_to) const {
  EdgeCurve curve;
  curve.kind_ = Kind::straightened;
  curve.points_ = {start(), start(), end(), end()};
  curve.drawn_ = std::make_shared<const EdgeCurve>(*this);
  curve.kept_from_ = kept_from;
  curve.kept_to_ = kept_to;
  curve.length_ = (at(kept_from) - start()).norm() + (kept_to - kept_from) * length_ +
                  (end() - at(kept_to)).norm();
  return curve;
}

double EdgeCurve::bezier_speed(double t) const {
  const double s = 1 - t;
  return 3 * (s * s * (points_[1] - points_[0]) + 2 * s * t * (points_[2] - points_[1]) +
              t * t * (points_[3] - points_[2]))
                 .norm();
}

Vec2 EdgeCurve::bezier_point(double t) const {
  const double s = 1 - t;
  return s * s * s * points_[0] + 3 * s * s * t * points_[1] + 3 * s * t * t * points_[2] +
         t * t * t * points_[3];
}

double EdgeCurve::bezier_length(double from, double to) const {
  const double middle = (from + to) / 2;
  const double half = (to - from) / 2;
  double sum = 0;
  for (std::size_t i = 0; i < gauss_nodes.size(); ++i) {
    sum += gauss_weights[i] * (bezier_speed(middle - half * gauss_nodes[i]) +
                               bezier_speed(middle + half * gauss_nodes[i]));
  }
  return half * sum;
}

void EdgeCurve::measure(double from, double to, double whole, int depth) {
  const double middle = (from + to) / 2;
  const double first = bezier_length(from, middle);
  const double second = bezier_length(middle, to);
  const double scale = (points_[1] - points_[0]).norm() + (points_[2] - points_[1]).norm() +
                       (points_[3] - points_[2]).norm();
  if (depth < deepest && std::abs(first + second - whole) > 1e-14 * scale) {
    measure(from, middle, first, depth + 1);
    measure(middle, to, second, depth + 1);
    return;
  }
  marks_.push_back({to, marks_.back().length + first + second});
}

double EdgeCurve::turning(double from, double to) const {
  if (kind_ == Kind::line) return 0;
  if (kind_ == Kind::arc) return std::abs(sweep_) * (to - from);
  const int chords = kind_ == Kind::chain ? 32 * static_cast<int>(parts_->size()) : 32;
  double sum = 0;
  Vec2 previous = Vec2::Zero();
  Vec2 point = at(from);
  for (int i = 1; i <= chords; ++i) {
    const Vec2 next = at(from + (to - from) * i / chords);
    const Vec2 chord = next - point;
    point = next;
    if (chord.squaredNorm() == 0) continue;
    if (previous.squaredNorm() > 0) {
      sum += std::abs(
          std::atan2(previous.x() * chord.y() - previous.y() * chord.x(), previous.dot(chord)));
    }
    previous = chord;
  }
  return sum;
}

Vec2 EdgeCurve::at(double fraction) const {
  if (fraction <= 0) return start();
  if (fraction >= 1) return end();
  if (kind_ == Kind::line) return start() + fraction * (end() - start());
  if (kind_ == Kind::arc) {
    const double angle = from_angle_ + fraction * sweep_;
    return centre_ + radius_ * Vec2(std::cos(angle), std::sin(angle));
  }
  const double target = fraction * length_;
  if (kind_ == Kind::straightened) {
    const Vec2 first = drawn_->at(kept_from_);
    const Vec2 last = drawn_->at(kept_to_);
    const double lead = (first - start()).norm();
    const double tail = (end() - last).norm();
    if (target < lead) return start() + target / lead * (first - start());
    if (target > length_ - tail) return end() - (length_ - target) / tail * (end() - last);
    return drawn_->at(kept_from_ + (target - lead) / drawn_->length());
  }
  auto after = std::upper_bound(marks_.begin(), marks_.end(), target,
                                [](double value, const Mark& mark) { return value < mark.length; });
  if (after == marks_.begin()) ++after;
  if (after == marks_.end()) --after;
  const Mark before = *(after - 1);
  if (kind_ == Kind::chain) {
    const EdgeCurve& part = (*parts_)[static_cast<std::size_t>(before.t)];
    return part.length() > 0 ? part.at((target - before.length) / part.length()) : part.start();
  }
  return bezier_point(bezier_parameter(before, *after, target));
}

/// Where the curve is `length` metres long, between two marks.
double EdgeCurve::bezier_parameter(const Mark& before, const Mark& after, double length) const {
  double low = before.t;
  double high = after.t;
  const double piece = after.length - before.length;
  double t = piece > 0 ? low + (high - low) * (length - before.length) / piece : low;
  // Newton's method, safeguarded by bisection.
  for (int i = 0; i < 60; ++i) {
    const double excess = before.length + bezier_length(before.t, t) - length;
    if (std::abs(excess) <= 1e-15 * length_) break;
    (excess > 0 ? high : low) = t;
    const double speed = bezier_speed(t);
    const double newton = speed > 0 ? t - excess / speed : low;
    t = newton > low && newton < high ? newton : (low + high) / 2;
  }
  return t;
}

std::vector<std::array<Vec2, 4>> EdgeCurve::cubics() const {
  std::vector<std::array<Vec2, 4>> pieces;
  const auto add_chord = [&](const Vec2& from, const Vec2& to) {
    pieces.push_back({from, from + (to - from) / 3, to - (to - from) / 3, to});
  };
  switch (kind_) {
    case Kind::line:
      add_chord(start(), end());
      break;
    case Kind::bezier:
      pieces.push_back(points_);
      break;
    case Kind::arc: {
      const int count =
          std::max(1, static_cast<int>(std::ceil(std::abs(sweep_) * 4 / std::numbers::pi)));
      const double step = sweep_ / count;
      const double reach = 4.0 / 3 * std::tan(step / 4) * radius_;
      for (int i = 0; i < count; ++i) {
        const double a = from_angle_ + i * step;
        const double b = a + step;
        const Vec2 from = at(static_cast<double>(i) / count);
        const Vec2 to = at(static_cast<double>(i + 1) / count);
        pieces.push_back({from, from + reach * Vec2(-std::sin(a), std::cos(a)),
                          to - reach * Vec2(-std::sin(b), std::cos(b)), to});
      }
      break;
    }
    case Kind::chain:
      for (const EdgeCurve& part : *parts_) {
        for (const auto& piece : part.cubics()) pieces.push_back(piece);
      }
      break;
    case Kind::straightened: {
      const std::vector<Vec2> points = sample(64);
      for (std::size_t i = 0; i + 1 < points.size(); ++i) add_chord(points[i], points[i + 1]);
      break;
    }
  }
  return pieces;
}

std::array<EdgeCurve, 2> EdgeCurve::cut_at(double fraction) const {
  if (straight()) {
    const Vec2 middle = at(fraction);
    return {line(start(), middle), line(middle, end())};
  }
  std::array<std::vector<EdgeCurve>, 2> sides;
  double left = fraction * length();
  for (const auto& c : cubics()) {
    const EdgeCurve whole = cubic(c[0], c[1], c[2], c[3]);
    constexpr double nothing = 1e-9;  // of a part's length
    if (left >= whole.length() * (1 - nothing)) {
      sides[0].push_back(whole);
    } else if (left <= whole.length() * nothing) {
      sides[1].push_back(whole);
    } else {
      const double t = whole.bezier_parameter(whole.marks_.front(), whole.marks_.back(), left);
      const auto between = [t](const Vec2& a, const Vec2& b) -> Vec2 { return a + t * (b - a); };
      const Vec2 ab = between(c[0], c[1]);
      const Vec2 bc = between(c[1], c[2]);
      const Vec2 cd = between(c[2], c[3]);
      const Vec2 abc = between(ab, bc);
      const Vec2 bcd = between(bc, cd);
      const Vec2 middle = between(abc, bcd);
      sides[0].push_back(cubic(c[0], ab, abc, middle));
      sides[1].push_back(cubic(middle, bcd, cd, c[3]));
    }
    left -= whole.length();
  }
  const auto joined = [](std::vector<EdgeCurve>& parts) {
    return parts.size() == 1 ? parts.front() : chain(std::move(parts));
  };
  return {joined(sides[0]), joined(sides[1])};
}

std::vector<Vec2> EdgeCurve::sample(int segments) const {
  std::vector<Vec2> points;
  points.reserve(static_cast<std::size_t>(segments) + 1);
  for (int i = 0; i <= segments; ++i) {
    points.push_back(at(static_cast<double>(i) / segments));
  }
  return points;
}

}  // namespace toile
