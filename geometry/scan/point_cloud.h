// Points of a scanned surface: plain data.
#pragma once

#include <vector>

#include "geometry/types.h"

namespace toile {

/// Unorganised points, in the file's unit.
struct PointCloud {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;  ///< empty, or one a point; of unit length, or zero where not known
};

}  // namespace toile
