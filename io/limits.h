// Bounds on what mesh files may hold. Beyond them no body stands and no garment hangs, and products
// of coordinates lose their digits or overflow.
#pragma once

#include <cmath>
#include <string>

#include "geometry/error.h"

namespace toile {

/// Units of a mesh whose unit is not known yet: 1 km in millimetres, the smallest unit.
inline constexpr double max_coordinate = 1e6;

/// Metres, in files that are in metres: 1 km.
inline constexpr double max_metres = 1e3;

/// Corners of one face. The time to cut a face into triangles grows with the cube of them.
inline constexpr int max_face_corners = 1000;

/// What is wrong with a coordinate, for an Error, or empty. `max` is max_coordinate or max_metres.
inline std::string coordinate_problem(double value, double max = max_coordinate) {
  if (std::isfinite(value) && std::abs(value) <= max) return "";
  if (!std::isfinite(value)) return "a coordinate is not a finite number";
  return "a coordinate is " + number_text(value) + ", beyond " +
         (max == max_metres ? "1,000 m" : "1,000,000 units");
}

/// What the user can do about it.
inline constexpr const char* coordinate_remedy = "correct the point or remove it";

}  // namespace toile
