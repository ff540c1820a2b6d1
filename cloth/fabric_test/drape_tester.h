// Cusick's drape tester [ISO 9073-9]: a round sheet between two plates, and the shadow of what
// hangs over their edge.
#pragma once

#include <vector>

#include "cloth/model/garment_model.h"
#include "geometry/mesh_polygon.h"

namespace toile {

/// Sizes in metres. The defaults are those of a sheet of 30 cm on plates of 18 cm.
struct DrapeTesterSizes {
  double plate = 0.09;     ///< radius
  double sheet = 0.15;     ///< radius, larger than the plate's
  double spacing = 0.005;  ///< of the rings of points, about; at most half of what hangs over
};

/// A sheet at rest on the tester.
struct TestDrape {
  TriangleMesh mesh;  ///< metres, y up, the plate at height 0
  bool at_rest = false;
  double coefficient = 0;  ///< share in [0, 1] of the free ring that the shadow covers
  int nodes = 0;           ///< count of the folds around the rim
  double drop = 0;         ///< metres from the plate down to the rim, mean
};

/// Rings of points from the middle out. The plate's edge is halfway between two rings. Both are
/// held, for that is where a clamped sheet of triangles has its clamp.
class DrapeTester {
 public:
  explicit DrapeTester(const DrapeTesterSizes& sizes = {});

  /// Lets a sheet of the fabric come to rest. It starts flat, but for a ripple of at most a few
  /// millimetres that differs by `start`. The same start gives the same bits.
  TestDrape drape(const Fabric& fabric, int start, double compression = 1) const;

  /// The compiled sheet, with what the plates hold.
  GarmentModel model(const Fabric& fabric, int start) const;
  /// Share of the free ring that the shadow covers with the points at `x` (metres). It is counted
  /// in cells of a quarter of a millimetre.
  double coefficient(const std::vector<Vec3>& x) const;
  /// How often the rim goes out and in again by more than 4 mm.
  int nodes(const std::vector<Vec3>& x) const;

  double spacing() const { return spacing_; }          ///< metres, of the rings
  std::size_t rim() const { return outline_.size(); }  ///< the first points are the rim's

 private:
  std::vector<Vec3> flat() const;
  double shadow(const std::vector<Vec3>& x) const;

  DrapeTesterSizes sizes_;
  double spacing_;
  std::vector<Vec2> outline_;
  std::vector<Vec2> interior_;
  PlanarMesh mesh_;
};

}  // namespace toile
