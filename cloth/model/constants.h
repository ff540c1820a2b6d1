// Constants of the garment model.
// docs/constants.md shows what half and double of many of them do.
#pragma once

namespace toile {

/// Share of the fabric's stiffness that the row of triangles beside a gathered seam keeps in shear
/// and, off the seam, along it. With all of its stiffness (1) the row pushes the seam into zigzags,
/// 3.8 % longer than its shorter side; so, 1.4 % [measured, weightless, 2 : 1 at 10 mm edges].
inline constexpr double gathered_stiffness = 0.02;

/// The smallest eigenvalue of the Gram matrix of a triangle's three jumps, each scaled to length 1.
/// Below it the jumps determine the curvature badly, and count as less stiff. At 0 they do not
/// determine it: the triangle's corners and the three across its edges lie on one conic. Usual
/// triangles of a mesh have 0.1 and more.
inline constexpr double min_distinct_jumps = 0.02;

/// Share of the larger bending rigidity that the smaller one has at least.
inline constexpr double min_rigidity_ratio = 1e-4;

}  // namespace toile
