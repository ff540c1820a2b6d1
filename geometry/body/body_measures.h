// The measures of a standing body that garments are compared with: plain data.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// A girth, and the plane in which it is taken. Metres, in the body's frame.
struct BodyGirth {
  std::string name;  ///< of the Measure
  Vec3 origin;       ///< the middle of the tape
  Vec3 normal;       ///< unit length; not below level
  double girth = 0;
};

/// Those of a body that stands; empty: it does not, or nobody measured it.
struct BodyMeasures {
  std::vector<BodyGirth> girths;                ///< in the order of measure_body()
  std::map<std::string, double> lengths;        ///< metres, by the Measure's name, girths too
  std::map<std::string, Vec3> shoulder_points;  ///< metres, by "left" and "right"

  bool empty() const { return girths.empty() && lengths.empty(); }
};

}  // namespace toile
