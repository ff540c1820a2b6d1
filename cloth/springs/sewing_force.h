// The adaptive sewing force, which brings the two points of a seam together.
#pragma once

#include "geometry/types.h"

namespace toile {

/// Coefficients of the sewing force; the defaults are the paper's [Zhong & Xu 2009, table 1].
///
/// As printed, the force depends on the units that it is computed in. Read as a force, it also
/// depends on the node's mass. With table 1 a centimetre of cloth (2e-5 kg) would move 50,000 times
/// faster than a kilogram.
/// So it is read as an acceleration, which also keeps the momentum of a pair of unequal masses. Its
/// units are `unit_time` and `unit_length`: 1 s and 1 m are the printed law on masses of 1 kg.
struct SewingForce {
  double epsilon = 1.0;       ///< of the distance
  double tau = 0.2;           ///< air resistance
  double c = 0.8;             ///< of the constant force below delta
  double lambda_f = 0.66;     ///< acceleration correction: of distance and normal velocity
  double damp_normal = 0.17;  ///< the same
  double damp_tangent = 0.83;
  double atten_normal = 0.03;  ///< of the relative acceleration
  double atten_tangent = 0.0001;
  double delta = 0.001;    ///< metres; the paper gives none
  double unit_time = 1;    ///< seconds
  double unit_length = 1;  ///< metres, of the constant force
  /// N, on a pair: no hand pulls harder; what does not close with it is not sewable.
  double most = 1e300;
  double fastest = 1e300;  ///< m/s at which a pair is drawn together
};

/// The two points of a seam, before they are one.
struct SewnPair {
  Vec3 x_a, x_b;          ///< metres
  Vec3 v_a, v_b;          ///< m/s
  double mass_a, mass_b;  ///< kg
};

/// Changes the velocities of the pair by the force over a step of `dt` seconds [Zhong & Xu 2009,
/// eq. of f_sew and of ΔA_ab].
///
/// The motion of one point toward the other is taken implicitly, with the acceleration terms in the
/// mass. Taken from the previous step, as they could be read, they would grow by λ_atten/m each
/// step.
/// Below `delta` the constant force is a soft threshold on the distance at the end of the step. It
/// has the damping of the law above `delta`, and a test of the whole step. So the two points land
/// on each other instead of swinging around each other, however long the step.
void sew_step(const SewingForce& force, double dt, SewnPair& pair);

}  // namespace toile
