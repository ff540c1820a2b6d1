// The unit of length of a body's file, told from its height.
#pragma once

#include <string>
#include <utility>

#include "geometry/error.h"

namespace toile {

/// Metres in the unit in which a body of `height` units is 1.00 to 2.30 m tall: m, dm, cm, mm or
/// inches. At most one fits. Small children and forms without limbs may be 0.40 to 1.00 m tall, if
/// none fits, or if the body is stout; not in dm. `depth` is the lesser of its level extents in the
/// same unit. It is 0.15 to 0.25 of a person's height, and 0.35 to 0.5 of a form's. Throws Error,
/// with the place `name`, where no unit fits.
inline double inferred_unit(double height, double depth, const std::string& name) {
  constexpr double stout = 0.3;
  constexpr std::pair<double, double> whole = {1.0, 2.3};
  constexpr std::pair<double, double> small = {0.4, 1.0};
  const bool is_stout = depth > stout * height;
  for (const auto& [least, most] : {is_stout ? small : whole, is_stout ? whole : small}) {
    for (const double unit : {1.0, 0.1, 0.01, 0.001, 0.0254}) {
      if (least == small.first && unit == 0.1) continue;  // 5.6 may be feet
      if (height * unit >= least && height * unit <= most) return unit;
    }
  }
  throw Error(name,
              "a body " + number_text(height) +
                  " units tall is between 0.40 and 2.30 m in none of m, dm, cm, mm, in",
              "give --unit, or how tall the body is: --height 168cm");
}

/// Metres in the unit of a body: as `options` state it or the body's height, else inferred_unit().
template <class Options>
double body_unit(const Options& options, double height, double depth, const std::string& name) {
  if (options.metres_per_unit) return *options.metres_per_unit;
  if (options.height && height > 0) return *options.height / height;
  return inferred_unit(height, depth, name);
}

}  // namespace toile
