// Self-rolling: a flat panel bent into a tube or a part of one, no length on it changed.
#pragma once

#include "geometry/types.h"

namespace toile {

/// Radius of the cylinder that a panel covers a share `around` (in (0, 1]) of:
/// r = (x_max - x_min)/2π + ζ for a whole tube [Zhong & Xu 2009]. `zeta` (metres) leaves a gap
/// between the sides that seam_gap tells; where several panels make up one tube, `width` is the sum
/// of theirs.
double rolling_radius(double width, double around, double zeta);

/// Metres that are missing between the two sides of a panel of that width on its share of the
/// cylinder: 2πζ for a whole tube. Negative: they overlap.
double seam_gap(double width, double around, double radius);

/// A flat point on the cylinder around the y axis: the line x = `middle` comes to lie at +z, x goes
/// on toward +x, y stays. θ = (x - middle)/r, so that r dθ = dx: every length on the panel is kept;
/// a straight edge of a triangle becomes a chord, shorter by (h/r)²/24.
///
/// The paper prints θ = sqrt((x - O_x)² + (z - z_min)²)/r with the sign of x - O_x put back after
/// the sine. That is this form for a panel flat at z = z_min; anything else it crushes about O_x.
/// And it defines the axis' height as "O_y = z_min - r" where it uses O_z.
Vec3 roll(const Vec2& flat, double middle, double radius);

}  // namespace toile
