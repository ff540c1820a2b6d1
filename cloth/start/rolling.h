// Self-rolling: a flat panel bent into a tube or a part of one, no length on it changed.
#pragma once

#include "geometry/types.h"

namespace toile {

/// Radius of the cylinder of which a panel covers the share `around`, in (0, 1]. For a whole tube
/// it is r = (x_max - x_min)/2π + ζ [Zhong & Xu 2009]. `zeta` (metres) leaves a gap between the
/// sides, see seam_gap(). Where several panels make up one tube, `width` is the sum of theirs.
double rolling_radius(double width, double around, double zeta);

/// Metres that are missing between the two sides of a panel of that width on its share of the
/// cylinder: 2πζ for a whole tube. Negative: they overlap.
double seam_gap(double width, double around, double radius);

/// The place of a flat point on the cylinder around the y axis. The line x = `middle` comes to lie
/// at +z, x goes on toward +x, and y stays.
/// θ = (x - middle)/r, so that r dθ = dx: every length on the panel is kept. A straight edge of a
/// triangle becomes a chord, shorter by (h/r)²/24.
///
/// The paper prints θ = sqrt((x - O_x)² + (z - z_min)²)/r, and puts the sign of x - O_x back after
/// the sine. That is this form for a panel flat at z = z_min. Anything else it crushes about O_x.
/// It also defines the axis' height as "O_y = z_min - r" where it uses O_z.
Vec3 roll(const Vec2& flat, double middle, double radius);

}  // namespace toile
