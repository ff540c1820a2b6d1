// A body as the rest of Toile wants it: closed, in metres, upright, on the floor.
#pragma once

#include <optional>
#include <string>

#include "geometry/repair.h"

namespace toile {

struct CleanOptions {
  /// Metres in one unit of the file. None: told from the height, since no two of m, dm, cm, mm and
  /// inches make the same number a body between 1.00 and 2.30 m tall.
  std::optional<double> metres_per_unit;
  RepairOptions repair;
};

struct CleanReport {
  RepairReport repair;
  double metres_per_unit = 1;
  bool unit_inferred = false;
  std::string turned;  ///< how the body was turned to stand facing +z; empty: it was not
  double lifted = 0;   ///< metres added to y to put the feet on the floor
  double height = 0;   ///< metres
};

struct CleanBody {
  TriangleMesh mesh;  ///< closed, 2-manifold, outward; metres, y up, lowest point at y = 0
  CleanReport report;
};

/// Repairs, scales, turns and lifts a body. x and z are left where they are. Throws Error as
/// repair() does, and when the unit can't be told or the body is no body's size.
CleanBody clean_body(const PolygonSoup& soup, const std::string& name,
                     const CleanOptions& options = {});

}  // namespace toile
