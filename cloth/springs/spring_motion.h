// One time step of the mass-spring garment, and the state that it moves.
#pragma once

#include <optional>
#include <vector>

#include "cloth/model/garment_model.h"
#include "cloth/springs/self_collisions.h"
#include "cloth/springs/sewing_force.h"
#include "cloth/springs/spring_forces.h"
#include "cloth/springs/spring_sheet.h"
#include "cloth/springs/strain_control.h"
#include "cloth/springs/subject_collisions.h"
#include "geometry/types.h"

namespace toile {

/// The choices that the paper leaves open, or compares.
struct SpringOptions {
  double time_step = 0;  ///< seconds; 0: `step_share` of the largest that is stable
  double step_share = 0.9;
  StrainScheme strain_scheme = StrainScheme::velocity;
  StrainControlOptions strain = {.measure_after = false};
  /// While draping, Gauss-Seidel sweeps until the limit holds, in place of the mean of three
  /// passes. The mean holds it only as far as the step is short [reference case 13].
  bool converged_strain = false;
  SewingForce sewing = {.unit_time = 0.1, .unit_length = 0.001};
  double tolerance = 0.002;  ///< metres kept from the subject surface (ξ)
  double restitution = 0;    ///< λ
  double drag = 5;           ///< 1/s: air resistance of every node over its mass
};

/// What acts during a stage.
struct SpringStage {
  double gravity = 0;     ///< factor on the scene's
  double attraction = 0;  ///< toward the nearest facet, in weights of the cloth 5 cm off the skin
  bool friction = false;
  SewingForce sewing;
  /// Share of their first gap above which the points of a seam are pulled together. It falls from 1
  /// to 0 and closes all seams in step: a waist that closes first drags the shoulders down.
  double open = 0;
};

/// What happened in the steps so far.
struct SpringCounts {
  long steps = 0;
  long merged = 0;  ///< pairs of seam points
};

/// A garment of masses and springs in motion, by symplectic Euler. The forces are of springs,
/// gravity, attraction and air. Then velocities change by the sewing force, the strain control, and
/// collisions with itself and with the subject. What must hold most comes last [Zhong & Xu 2009,
/// Implementation].
/// The cost of a step is linear in the triangles. The same bits for any number of threads.
class SpringMotion {
 public:
  /// `model` is `garment` compiled for a scene that has a subject. The motion starts with the
  /// material points at `placed`. All arguments have to outlive it. Throws Error for a time step
  /// beyond twice stable_step().
  SpringMotion(const PanelMesh& garment, const GarmentModel& model, const SpringOptions& options,
               const std::vector<Vec3>& placed);

  void step(const SpringStage& stage);

  double time_step() const { return time_step_; }
  const std::vector<Vec3>& points() const { return x_; }  ///< per material point, metres
  /// Per node of the sheet, m/s. Points merged away have none.
  const std::vector<Vec3>& velocities() const { return v_; }
  const SpringSheet& sheet() const { return sheet_; }
  const SpringCounts& counts() const { return counts_; }

  /// Pairs of seam points that are not merged yet.
  int open_pairs() const { return static_cast<int>(open_.size()); }
  /// The gap that this share of the open pairs is below, metres; 0 when all are merged.
  double open_gap(double share) const;
  /// From now on neighbours in the mesh may not pass through each other either.
  void close_bounds();
  /// Strain is controlled by sweeps until the limit holds, from now on.
  void converge_strain();
  /// Factor on the bending stiffness from now on, as far as the step bears it.
  void stiffen_bending(double factor);

 private:
  void reconnect();
  void choose_limited_springs();
  std::vector<Spring> all_springs() const;
  void choose_time_step();
  void accelerate(const SpringStage& stage);
  void sew(const SpringStage& stage, double within);
  void merge_closed_pairs();

  const GarmentModel& model_;
  const SpringOptions& options_;
  SpringSheet sheet_;
  StrainControlOptions strain_options_;
  double time_step_ = 0;
  std::vector<Vec3> x_;
  std::vector<Vec3> v_;
  std::vector<Vec3> force_;
  struct OpenPair {
    int a;  // material points
    int b;
    double first_gap;
  };
  std::vector<OpenPair> open_;
  std::optional<SpringForces> springs_;
  std::optional<StrainControl> strain_;
  std::optional<SubjectCollisions> subject_;
  std::optional<SelfCollisions> self_;
  std::vector<int> node_;  // of each material point
  SpringCounts counts_;
};

}  // namespace toile
