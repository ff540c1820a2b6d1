// The hanging cloth of Fig. 9: 17 × 17 nodes, two corners held, let go from the horizontal
// [Zhong & Xu 2009, Fig. 9; Provot 1995].
#pragma once

#include <optional>
#include <vector>

#include "cloth/springs/strain_control.h"
#include "tests/support/jacobi_strain.h"
#include "tests/support/spring_grid.h"

namespace toile::figures {

/// One metre square, of 0.15 kg/m²; its springs are some fifty times softer than a woven's, which
/// is what makes it "super-elastic" without control.
struct HangingClothOptions {
  StrainScheme scheme = StrainScheme::none;
  StrainControlOptions control;  ///< of either scheme
  /// Velocities are adjusted by this sum, to compare with; none: by StrainControl.
  std::optional<test::JacobiSum> jacobi = {};
  int nodes_across = 17;
  double dt = 0.001;         ///< s
  double stiffness = 20;     ///< N/m, of structural and shear springs
  double bending = 2;        ///< N/m, of the springs between second neighbours
  double damping = 0.001;    ///< N·s/m, of every spring
  double drag_rate = 5;      ///< 1/s, of the air
  double seconds_max = 6;    ///< simulated
  double rest_speed = 5e-3;  ///< m/s: at rest when no node has been faster for a tenth of a second
};

/// |length/rest - 1| of structural and shear springs.
struct ClothStrain {
  double corners = 0;  ///< largest of the springs that meet a held corner
  double max = 0;
  double p99 = 0;
};

struct HangingClothMoment {
  double seconds;
  double corners;
  double max;
};

struct HangingCloth {
  test::SpringGrid grid;  ///< as it started
  std::vector<Vec3> x;    ///< as it hangs
  ClothStrain strain;
  /// Largest strain of the whole way.
  double max_during = 0;
  std::vector<HangingClothMoment> curve;  ///< the largest of each fiftieth of a second
  bool at_rest = false;
  bool blew_up = false;     ///< the run ended where a strain was not finite, or above 100
  double fastest = 0;       ///< m/s, of the last step
  double seconds = 0;       ///< simulated
  double wall_seconds = 0;  ///< of the computer
  double passes = 0;        ///< of the strain control, mean of the steps
  int steps = 0;
};

/// Steps by symplectic Euler until at rest.
HangingCloth hang_cloth(const HangingClothOptions& options);

/// Longest stable step of the uncontrolled cloth, s.
double hanging_cloth_step(const HangingClothOptions& options);

}  // namespace toile::figures
