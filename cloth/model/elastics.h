// Elastics that are sewn along edges and draw the cloth up.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "cloth/scene/scene.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// A piece of elastic along a mesh edge. It pulls when it is longer than at rest, and never pushes.
/// The cloth on it lies in folds until it is pulled out to its flat length. From there on it pulls
/// as well. The energy is
/// E = ½ rest stiffness max(0, length/rest - 1)² + ½ flat cloth max(0, length/flat - 1)².
struct ElasticSegment {
  std::array<int, 2> points;  ///< material points
  double rest;                ///< metres, of the elastic
  double flat;                ///< metres, of the mesh edge in the flat panel
  double stiffness;           ///< N per strain, of the elastic
  double cloth;               ///< N per strain, of the rows of triangles beside it
};

/// N: the tension of a segment of `length` metres, the derivative of its energy.
inline double elastic_tension(const ElasticSegment& s, double length) {
  return s.stiffness * std::max(length / s.rest - 1, 0.0) +
         s.cloth * std::max(length / s.flat - 1, 0.0);
}

/// N/m: a bound of the stiffness that a segment adds to each of its points.
inline double stiffness_bound(const ElasticSegment& s) {
  return 2 * (s.stiffness / s.rest + s.cloth / s.flat);
}

/// All segments, in the order of the garment's elastics. `node_of_point` holds the node of each
/// material point. O(n log n) in the triangles; nothing without elastics.
std::vector<ElasticSegment> elastic_segments(const PanelMesh& garment, const Scene& scene,
                                             const std::vector<int>& node_of_point);

/// An elastic as worn.
struct ElasticMeasurement {
  std::string name;
  double flat = 0;     ///< metres, of the edge in the pattern
  double rest = 0;     ///< metres, of the elastic
  double now = 0;      ///< metres, as worn
  double tension = 0;  ///< N, of the elastic: the mean along it
};

/// Measures each of the garment's elastics, with its material points at `points` (metres).
std::vector<ElasticMeasurement> measure_elastics(const PanelMesh& garment,
                                                 const std::vector<Vec3>& points);

}  // namespace toile
