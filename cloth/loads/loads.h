// Strain and tension of worn cloth, and how it presses on the body.
#pragma once

#include <optional>
#include <vector>

#include "cloth/model/garment_model.h"
#include "geometry/surface_distance.h"

namespace toile {

/// Of a triangle. Strains are fractions, of the inner face where the cloth touches the skin (see
/// InnerFace), negative where it is slack. Tensions are N per metre of width as worn, negative
/// where the cloth is pushed together. Along gathered seams and elastics, strains and tensions of
/// the yarns are 0: they lie in folds that the mesh does not have.
struct TriangleLoad {
  double strain_warp = 0;
  double strain_weft = 0;
  double strain_bias = 0;   ///< of the diagonal between the yarns that is strained more
  double tension_warp = 0;  ///< along the warp
  double tension_weft = 0;  ///< along the weft
  double tension_most = 0;  ///< the larger principal tension
  double tension_least = 0;
  Vec3 direction{0, 0, 0};  ///< unit length, in space: of the larger principal tension
  Vec3 warp{0, 0, 0};       ///< unit length, in space: of the warp; zero in a gathered row
  Eigen::Matrix3d tension;  ///< N/m: e · tension e is the pull along a unit vector e of the plane
  double area = 0;          ///< m² as worn, of the inner face

  /// Degrees from 0 to 90: the warp as worn against the vertical (y).
  double grain_from_plumb() const;
};

/// Of a node: what the body does to the cloth there.
struct NodeLoad {
  bool touches = false;  ///< it or the middle of one of its edges is near enough to the skin
  Vec3 force{0, 0, 0};   ///< N, of the skin on the cloth; 0 where it does not touch
  double pressure = 0;   ///< Pa, square to the skin; never negative
  double friction = 0;   ///< Pa, along the skin
  double area = 0;       ///< m² of inner face
};

/// The loads of a garment.
struct Loads {
  std::vector<TriangleLoad> triangles;  ///< in the order of GarmentModel::node_triangles
  std::vector<NodeLoad> nodes;
  double weight = 0;      ///< N, of the garment
  Vec3 of_skin{0, 0, 0};  ///< N, the sum of what the skin does to the cloth
  /// N, the sum of the sizes of forces at nodes that do not touch the skin. Other garments, the
  /// floor, friction of cloth on cloth and what is not at rest make them.
  double unexplained = 0;
};

/// Finds strain and tension from the shape of the cloth, and contact from what its forces lack to
/// be at rest.
///
/// The drape is at rest with the strain of its middle, so that gives forces and friction. Pressure
/// is what the strain of the inner face makes.
///
/// Stretch, bending, elastics, weight and the push of cloth on cloth act on each node. At rest the
/// skin balances their sum. So contact does not depend on how the drape was computed. `nodes`:
/// metres, one a node of `model`. The scene of the model needs no body. `touching`: metres off the
/// skin up to which cloth touches. It is that of InnerFace. O(n log n).
///
/// Limits of strain or shear, other garments and attachments are not among the forces.
Loads measure_loads(const GarmentModel& model, const std::vector<Vec3>& nodes,
                    const SurfaceDistance& skin, double touching);

}  // namespace toile
