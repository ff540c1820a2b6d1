// Which rigidity each hinge of a mesh needs for the sheet to bend by its fabric's.
#pragma once

#include <array>

#include "cloth/fabric.h"
#include "geometry/types.h"

namespace toile {

/// Rigidity against being rolled along a direction at `angle` (radians) to the weft, N·m:
/// (√weft cos² + √warp sin²)², an orthotropic plate's with the twisting rigidity √(warp·weft)
/// [Huber 1923; Timoshenko & Woinowsky-Krieger 1959, Theory of Plates and Shells, art. 86].
/// Fabrics' own twisting rigidity is not among what is measured.
double bending_along(const Fabric& fabric, double angle);

/// What a hinge feels of a sheet's curvature. Its slope jumps across the edge by normal·κ_nn +
/// edge·κ_tt + twist·κ_nt, with n square to the edge and t along it: not by what is bent across it
/// alone.
struct HingeResponse {
  Vec2 along = Vec2::Zero();  ///< unit vector of the edge, in weft and warp coordinates
  double normal = 0;          ///< metres
  double edge = 0;            ///< metres
  double twist = 0;           ///< metres
  double weight = 0;          ///< of the jump's square in the energy; 0: there is no hinge
};

/// Of the edge from `a` to `b` between the corners `c` and `d`, flat, each with its own flat edge:
/// (a, b, c) counter-clockwise in one panel and `away` the corner d's place along the edge from a
/// and its distance from it, in metres, in its own. The panel's warp is at `grain` to +y.
HingeResponse hinge_response(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& away,
                             double grain);

/// N·m, for the three hinges around a triangle: such that it has bending_along()'s energy for each
/// of the ways it may be rolled - along the weft and the warp as nearly as rigidities above 0
/// can, on the bias as nearly as is left. Where warp and weft are alike, that is their rigidity.
/// Beyond a ratio of about 9 there is none for some directions of the edges.
std::array<double, 3> hinge_rigidities(const Fabric& fabric,
                                       const std::array<HingeResponse, 3>& hinges);

}  // namespace toile
