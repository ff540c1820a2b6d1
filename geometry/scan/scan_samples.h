// Averaged points of a scanned body with outward normals: what its surface is fitted to.
#pragma once

#include <vector>

#include "geometry/axis_direction.h"
#include "geometry/scan/point_cloud.h"

namespace toile {

/// One sample for each cell of a grid that holds points. Metres.
struct ScanSamples {
  double spacing = 0;            ///< of the scan's points
  double noise = 0;              ///< standard deviation of the points about the surface
  double cell = 0;               ///< edge of the grid's cells
  std::vector<Vec3> points;      ///< mean of the cell's points
  std::vector<Vec3> normals;     ///< outward, of unit length
  std::vector<double> areas;     ///< square metres of surface that the cell's points stand for
  std::vector<double> flatness;  ///< 0 to 1: how far a plane fits around; weight of the normal
  std::vector<int> sample_of;    ///< per point of the scan
  bool normals_given = false;    ///< the scan's own normals are used
};

/// Averages the points of a body, in metres, and finds their normals. The noise is that of the
/// points about planes through their neighbours.
///
/// A normal is the least axis of the neighbours' spread [Hoppe et al. 1992]. The scan's own normals
/// are used where it has them. Which way is out is voted on by rays through the occupied cells to
/// both sides: more of them leave the body on its outside. Neighbours then agree by majority. A
/// spanning tree [Hoppe et al. 1992] turns a whole hand inside out where it takes one wrong step
/// between fingers; a vote has no such step. O(n log n).
ScanSamples sample_scan(const PointCloud& body, const AxisDirection& up, double spacing);

}  // namespace toile
