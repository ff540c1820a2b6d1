// The curves of DXF as cubic Bezier curves.
#pragma once

#include <string>
#include <vector>

#include "io/dxf.h"

namespace toile {

/// In radians: DXF states most angles in degrees.

/// A straight line.
DxfCurve dxf_line(const Vec2& start, const Vec2& end);

/// Appends the arc of an ellipse: centre + cos(t) * first + sin(t) * second, t from `from` to `to`
/// in radians. No curve spans more than 22.5 degrees.
void append_dxf_arc(std::vector<DxfCurve>& curves, const Vec2& centre, const Vec2& first,
                    const Vec2& second, double from, double to);

/// Appends the side of a polyline. `bulge` is the tangent of a quarter of its angle, positive for
/// arcs that turn to the left.
void append_dxf_bulge(std::vector<DxfCurve>& curves, const Vec2& start, const Vec2& end,
                      double bulge);

/// A B-spline as DXF states it.
struct DxfSpline {
  int degree = 3;
  std::vector<double> knots;
  std::vector<Vec2> control_points;
  std::vector<double> weights;  ///< one for each control point, or none
  std::vector<Vec2> fit_points;
};

/// What is wrong with a spline; empty: nothing. `fit_points` alone are enough.
std::string spline_problem(const DxfSpline& spline);

/// The curves of a spline without a problem. They are exact up to degree 3 without weights.
/// Otherwise each span becomes 16 curves with the spline's points and tangents. Without control
/// points, a natural cubic spline runs through the fit points, by the lengths of their chords.
std::vector<DxfCurve> spline_curves(const DxfSpline& given);

}  // namespace toile
