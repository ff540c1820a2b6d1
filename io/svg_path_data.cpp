#include "io/svg_path_data.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>

#include "geometry/angles.h"
#include "io/svg_scanner.h"

namespace toile {

namespace {

constexpr double pi = std::numbers::pi;

/// Radians: a cubic follows an arc of this angle to 4.2e-6 of its radius. One of 90 degrees does to
/// 2.7e-4 only, a quarter of a millimetre on a full skirt.
constexpr double max_arc_piece = pi / 4;

/// An arc of an ellipse, as SVG 1.1 describes it by its centre (appendix F.6).
struct Arc {
  Vec2 centre;
  Vec2 radii;
  double tilt;   ///< radians of the first axis
  double from;   ///< radians on the unit circle
  double sweep;  ///< radians, either way

  Vec2 map(const Vec2& unit) const {
    const Vec2 point = radii.cwiseProduct(unit);
    const double c = std::cos(tilt);
    const double s = std::sin(tilt);
    return centre + Vec2(c * point.x() - s * point.y(), s * point.x() + c * point.y());
  }
};

void append_arc(DrawnPath& path, const Arc& arc, const Vec2& end) {
  const int pieces =
      std::max(1, static_cast<int>(std::ceil(std::abs(arc.sweep) / max_arc_piece - 1e-9)));
  const double step = arc.sweep / pieces;
  const double reach = 4.0 / 3 * std::tan(step / 4);
  for (int i = 0; i < pieces; ++i) {
    const double a = arc.from + i * step;
    const double b = a + step;
    const Vec2 first(std::cos(a) - reach * std::sin(a), std::sin(a) + reach * std::cos(a));
    const Vec2 second(std::cos(b) + reach * std::sin(b), std::sin(b) - reach * std::cos(b));
    const Vec2 to = i + 1 == pieces ? end : arc.map({std::cos(b), std::sin(b)});
    path.segments.push_back(DrawnSegment::cubic(arc.map(first), arc.map(second), to));
  }
}

/// An arc between two points, with radii as the path states them.
void append_arc_to(DrawnPath& path, const Vec2& from, const Vec2& to, Vec2 radii, double tilt,
                   bool large, bool positive) {
  if (from == to) return;
  radii = radii.cwiseAbs();
  if (radii.x() == 0 || radii.y() == 0) {
    path.segments.push_back(DrawnSegment::line(to));
    return;
  }
  const double c = std::cos(tilt);
  const double s = std::sin(tilt);
  const Vec2 half = (from - to) / 2;
  const Vec2 unit =
      Vec2(c * half.x() + s * half.y(), -s * half.x() + c * half.y()).cwiseQuotient(radii);
  const double reach = unit.squaredNorm();
  // Radii too short to reach are lengthened until they do.
  if (reach > 1) radii *= std::sqrt(reach);
  const Vec2 chord = reach > 1 ? Vec2(unit / std::sqrt(reach)) : unit;
  // Of so large a circle, the arc is as good as straight.
  if (!(chord.norm() > 1e-9)) {
    path.segments.push_back(DrawnSegment::line(to));
    return;
  }
  const double left = std::max(0.0, 1 / chord.squaredNorm() - 1);
  Vec2 middle = std::sqrt(left) * Vec2(chord.y(), -chord.x());
  if (large == positive) middle = -middle;
  Arc arc{Vec2::Zero(), radii, tilt, 0, 0};
  arc.centre = (from + to) / 2 + arc.map(middle);
  const Vec2 first = chord - middle;
  const Vec2 last = -chord - middle;
  arc.from = std::atan2(first.y(), first.x());
  arc.sweep = std::atan2(last.y(), last.x()) - arc.from;
  if (positive && arc.sweep <= 0) arc.sweep += 2 * pi;
  if (!positive && arc.sweep >= 0) arc.sweep -= 2 * pi;
  append_arc(path, arc, to);
}

class PathReader {
 public:
  PathReader(std::string_view text, const std::string& place) : scanner_(text, place) {}

  std::vector<DrawnPath> read() {
    char command = 0;
    while (!scanner_.at_end()) {
      if (!scanner_.at_number()) {
        command = scanner_.letter();
        if (command == 'Z' || command == 'z') {
          close();
          command = 0;
          continue;
        }
      } else if (command == 0) {
        scanner_.fail("a number stands where a command should");
      }
      if (paths_.empty() && !open_ && command != 'M' && command != 'm') {
        scanner_.fail("the path does not begin with M");
      }
      draw(command);
      // What follows a move without a command of its own are lines.
      if (command == 'M') command = 'L';
      if (command == 'm') command = 'l';
    }
    end_path();
    return std::move(paths_);
  }

 private:
  Vec2 point(bool relative) {
    const double x = scanner_.number();
    const double y = scanner_.number();
    return relative ? Vec2(at_ + Vec2(x, y)) : Vec2(x, y);
  }

  void draw(char command) {
    const bool relative = std::islower(static_cast<unsigned char>(command)) != 0;
    Vec2 cubic_control = at_;
    Vec2 quadratic_control = at_;
    switch (std::toupper(static_cast<unsigned char>(command))) {
      case 'M': {
        const Vec2 to = point(relative);
        end_path();
        begin(to);
        return;
      }
      case 'L':
        line(point(relative));
        break;
      case 'H':
        line({(relative ? at_.x() : 0) + scanner_.number(), at_.y()});
        break;
      case 'V':
        line({at_.x(), (relative ? at_.y() : 0) + scanner_.number()});
        break;
      case 'C': {
        const Vec2 first = point(relative);
        cubic_control = point(relative);
        cubic(first, cubic_control, point(relative));
        break;
      }
      case 'S': {
        const Vec2 first = 2 * at_ - cubic_control_;
        cubic_control = point(relative);
        cubic(first, cubic_control, point(relative));
        break;
      }
      case 'Q': {
        quadratic_control = point(relative);
        quadratic(quadratic_control, point(relative));
        break;
      }
      case 'T': {
        quadratic_control = 2 * at_ - quadratic_control_;
        quadratic(quadratic_control, point(relative));
        break;
      }
      case 'A': {
        const double rx = scanner_.number();
        const double ry = scanner_.number();
        const double tilt = to_radians(scanner_.number());
        const bool large = scanner_.flag();
        const bool positive = scanner_.flag();
        const Vec2 to = point(relative);
        resume();
        append_arc_to(path_, at_, to, {rx, ry}, tilt, large, positive);
        at_ = to;
        break;
      }
      default:
        scanner_.fail("an unknown command");
    }
    if (path_.segments.size() > max_svg_segments) scanner_.fail("the path has too many segments");
    // Smooth commands go on from a curve of their own kind only.
    const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(command)));
    cubic_control_ = kind == 'C' || kind == 'S' ? cubic_control : at_;
    quadratic_control_ = kind == 'Q' || kind == 'T' ? quadratic_control : at_;
  }

  void begin(const Vec2& at) {
    path_ = DrawnPath{};
    path_.start = at_ = cubic_control_ = quadratic_control_ = at;
    open_ = true;
  }
  /// What follows a closed path without a move starts where that one did.
  void resume() {
    if (!open_) begin(at_);
  }
  void line(const Vec2& to) {
    resume();
    path_.segments.push_back(DrawnSegment::line(to));
    at_ = to;
  }
  void cubic(const Vec2& first, const Vec2& second, const Vec2& to) {
    resume();
    path_.segments.push_back(DrawnSegment::cubic(first, second, to));
    at_ = to;
  }
  void quadratic(const Vec2& control, const Vec2& to) {
    const Vec2 from = at_;
    cubic(from + 2.0 / 3 * (control - from), to + 2.0 / 3 * (control - to), to);
  }

  void close() {
    if (!open_) {
      if (paths_.empty()) scanner_.fail("the path does not begin with M");
      return;
    }
    if (!path_.segments.empty()) {
      if (at_ != path_.start) path_.segments.push_back(DrawnSegment::line(path_.start));
      path_.closed = true;
    }
    const Vec2 start = path_.start;
    end_path();
    at_ = cubic_control_ = quadratic_control_ = start;
  }
  void end_path() {
    if (open_ && !path_.segments.empty()) paths_.push_back(std::move(path_));
    open_ = false;
  }

  SvgScanner scanner_;
  std::vector<DrawnPath> paths_;
  DrawnPath path_;
  bool open_ = false;
  Vec2 at_ = Vec2::Zero();
  Vec2 cubic_control_ = Vec2::Zero();
  Vec2 quadratic_control_ = Vec2::Zero();
};

}  // namespace

std::vector<DrawnPath> svg_path_data(std::string_view text, const std::string& place) {
  return PathReader(text, place).read();
}

std::vector<DrawnPath> svg_polygon(std::string_view text, bool closed, const std::string& place) {
  SvgScanner scanner(text, place);
  DrawnPath path;
  bool first = true;
  while (!scanner.at_end()) {
    const double x = scanner.number();
    const Vec2 point(x, scanner.number());
    if (first) {
      path.start = point;
    } else {
      path.segments.push_back(DrawnSegment::line(point));
    }
    first = false;
    if (path.segments.size() > max_svg_segments) scanner.fail("there are too many points");
  }
  if (path.segments.empty()) return {};
  if (closed) {
    if (end_of(path) != path.start) path.segments.push_back(DrawnSegment::line(path.start));
    path.closed = true;
  }
  return {std::move(path)};
}

DrawnPath svg_rectangle(const Vec2& corner, const Vec2& size, const Vec2& radii) {
  const bool round = radii.x() > 0 && radii.y() > 0;
  const Vec2 r = round ? Vec2(radii.cwiseMin(size / 2)) : Vec2(0, 0);
  const Vec2 far = corner + size;
  DrawnPath path;
  path.closed = true;
  path.start = {corner.x() + r.x(), corner.y()};
  const auto line = [&](double x, double y) {
    if (end_of(path) != Vec2(x, y)) path.segments.push_back(DrawnSegment::line({x, y}));
  };
  const auto turn = [&](double centre_x, double centre_y, double from, double x, double y) {
    if (round) append_arc(path, {{centre_x, centre_y}, r, 0, from, pi / 2}, {x, y});
  };
  line(far.x() - r.x(), corner.y());
  turn(far.x() - r.x(), corner.y() + r.y(), -pi / 2, far.x(), corner.y() + r.y());
  line(far.x(), far.y() - r.y());
  turn(far.x() - r.x(), far.y() - r.y(), 0, far.x() - r.x(), far.y());
  line(corner.x() + r.x(), far.y());
  turn(corner.x() + r.x(), far.y() - r.y(), pi / 2, corner.x(), far.y() - r.y());
  line(corner.x(), corner.y() + r.y());
  turn(corner.x() + r.x(), corner.y() + r.y(), pi, path.start.x(), path.start.y());
  line(path.start.x(), path.start.y());
  return path;
}

DrawnPath svg_ellipse(const Vec2& centre, const Vec2& radii) {
  DrawnPath path;
  path.closed = true;
  path.start = centre + Vec2(radii.x(), 0);
  append_arc(path, {centre, radii, 0, 0, 2 * pi}, path.start);
  return path;
}

}  // namespace toile
