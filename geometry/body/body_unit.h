// The unit of length of a body's file, told from its height.
#pragma once

#include <string>

#include "geometry/error.h"

namespace toile {

/// Metres in the unit in which a body of `height` units is 1.00 to 2.30 m tall: m, dm, cm, mm or
/// inches. At most one fits. Throws Error, with the place `name`, where none does.
inline double inferred_unit(double height, const std::string& name) {
  for (const double unit : {1.0, 0.1, 0.01, 0.001, 0.0254}) {
    if (height * unit >= 1.0 && height * unit <= 2.3) return unit;
  }
  throw Error(name,
              "a body " + number_text(height) +
                  " units tall is between 1.00 and 2.30 m in none of m, dm, cm, mm, in",
              "give --unit");
}

}  // namespace toile
