// The curves that bound a panel: straight lines, Bezier curves, circular arcs and chains of them,
// walked by length.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// A curve from one corner of a panel to the next, in metres. Points are found by the fraction of
/// the curve's length, so equal fractions are equal steps along the cloth.
///
/// Arcs are exact. Lengths of Bezier curves are integrated to about 1e-12 of the length, by
/// Gauss-Legendre quadrature on adaptively halved pieces. Points at a fraction lie within about
/// 1e-12 of the length. Degenerate curves, with all control points in one place, have length 0.
class EdgeCurve {
 public:
  static EdgeCurve line(const Vec2& start, const Vec2& end);
  static EdgeCurve quadratic(const Vec2& start, const Vec2& control, const Vec2& end);
  static EdgeCurve cubic(const Vec2& start, const Vec2& control1, const Vec2& control2,
                         const Vec2& end);
  /// A circular arc as SVG defines it, with y up. `large` takes the longer of the two arcs. `right`
  /// bulges to the right of the direction from start to end. A radius shorter than half the chord
  /// is taken as half the chord.
  static EdgeCurve arc(const Vec2& start, const Vec2& end, double radius, bool large, bool right);

  /// Curves that follow each other as one: each starts where the one before it ends. At least one.
  static EdgeCurve chain(std::vector<EdgeCurve> parts);

  /// The same curve run from its end to its start.
  EdgeCurve reversed() const;

  /// The curve turned and scaled as a whole, so that it runs from `start` to `end`. Its own ends
  /// must differ.
  EdgeCurve moved_to(const Vec2& start, const Vec2& end) const;

  /// The same curve, but straight over the first or the last `length` metres of it.
  EdgeCurve straight_at_start(double length) const;
  EdgeCurve straight_at_end(double length) const;

  /// The parts before and behind `fraction` in (0, 1) of the length. Those of a line are lines,
  /// those of other curves are Bezier curves, as exact as cubics().
  std::array<EdgeCurve, 2> cut_at(double fraction) const;

  const Vec2& start() const { return points_[0]; }
  const Vec2& end() const { return points_[3]; }
  double length() const { return length_; }
  bool straight() const { return kind_ == Kind::line; }

  /// Radians by which the tangent turns between two fractions of the length, left and right turns
  /// added up. Exact for arcs; Bezier curves are measured on 32 chords.
  double turning(double from = 0, double to = 1) const;

  /// The point at `fraction` in [0, 1] of the length; the end points exactly.
  Vec2 at(double fraction) const;

  /// The curve as cubic Bezier curves, each of four points, that follow each other. Bezier curves
  /// are exact, arcs are within 4.2e-6 of their radius. Others have up to 64 chords instead.
  std::vector<std::array<Vec2, 4>> cubics() const;

  /// `segments` + 1 points at equal steps of length, both end points included.
  std::vector<Vec2> sample(int segments) const;

 private:
  enum class Kind { line, bezier, arc, straightened, chain };
  /// The length of the curve from its start to parameter `t`. Of a chain, t is the number of parts.
  struct Mark {
    double t = 0;
    double length = 0;
  };

  EdgeCurve straightened(double kept_from, double kept_to) const;
  void measure(double from, double to, double whole, int depth);
  double bezier_parameter(const Mark& before, const Mark& after, double length) const;
  double bezier_speed(double t) const;
  double bezier_length(double from, double to) const;
  Vec2 bezier_point(double t) const;

  Kind kind_ = Kind::line;
  std::array<Vec2, 4> points_;  ///< Bezier control points; lines and arcs use the first and last
  Vec2 centre_ = Vec2::Zero();
  double radius_ = 0;
  double from_angle_ = 0;
  double sweep_ = 0;  ///< angle from start to end, positive counter-clockwise
  double length_ = 0;
  std::vector<Mark> marks_;
  std::shared_ptr<const EdgeCurve> drawn_;               ///< of a straightened curve
  std::shared_ptr<const std::vector<EdgeCurve>> parts_;  ///< of a chain
  double kept_from_ = 0;  ///< fractions of drawn_ between which it is kept
  double kept_to_ = 1;
};

}  // namespace toile
