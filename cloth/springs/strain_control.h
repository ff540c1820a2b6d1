// Keeps springs from stretching, and being crushed, beyond a limit: by changing velocities before
// the positions move, or positions after they moved.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "cloth/springs/spring.h"
#include "geometry/adjacency.h"
#include "geometry/types.h"

namespace toile {

enum class StrainScheme { none, velocity, position };

/// How the corrections of one pass add up where springs share a node. A spring beyond the limit
/// asks for a correction of its ends that alone would bring it to the limit. The ends share it by
/// their inverse masses. Both sweeps conserve momentum.
enum class StrainSweep {
  shared,    ///< Jacobi: a correction is divided by the springs beyond the limit at its busier end
  in_order,  ///< Gauss–Seidel: each spring sees the corrections before it; one thread
};

struct StrainControlOptions {
  double limit = 0.01;  ///< |length/rest - 1|, at least 0
  bool compression = true;
  int passes = 3;  ///< at most
  StrainSweep sweep = StrainSweep::shared;
  /// The result is the mean of what was reached after each pass: "the average of the three
  /// iterations of velocity adjustments" [Zhong & Xu 2009, Strain Control and Size Stability].
  bool mean_of_passes = true;
  /// Strain over the limit at which in_order stops before its passes are used up. It sweeps once
  /// in any case: corrections put off until the tolerance is reached come as knocks.
  double tolerance = 0;
  bool measure_after = true;  ///< fill StrainReport::after; costs one pass over the springs
};

/// Provot's adjustment: one sweep over the springs in order, elongation only, limit 10 %
/// [Provot 1995, Deformation Constraints in a Mass-Spring Model to Describe Rigid Cloth Behavior].
StrainControlOptions provot_options();

struct StrainReport {
  double before = 0;  ///< largest |length/rest - 1|; without compression, of the elongated
  double after = 0;   ///< the same once adjusted; -1 where it was not measured
  int over = 0;       ///< springs beyond the limit before
  int passes = 0;     ///< that found a spring beyond the limit
};

/// Limits the springs given to it. In a garment these are the structural and shear springs: cloth
/// that can't shorten across a fold can't fold. It keeps scratch memory, so one object serves one
/// caller at a time. The same bits for any number of threads. A call in which no spring is beyond
/// the limit reads each spring once and changes nothing.
class StrainControl {
 public:
  /// Copies the springs' ends and rest lengths; their stiffness plays no part. Throws as
  /// check_springs().
  StrainControl(std::span<const Spring> springs, int nodes);

  /// Changes the velocities `v` (m/s) so that the lengths predicted at x + dt·v come within the
  /// limit, as far as the passes go. Corrections act along the predicted direction, so a single
  /// spring is exact after one pass. `inverse_mass` in 1/kg, 0 where held; springs between two held
  /// nodes, or with both ends predicted on one place, are left.
  StrainReport adjust_velocities(std::span<const Vec3> x, std::span<const double> inverse_mass,
                                 double dt, const StrainControlOptions& options, std::span<Vec3> v);

  /// The same on positions that have moved already; velocities stay as they are.
  StrainReport adjust_positions(std::span<const double> inverse_mass,
                                const StrainControlOptions& options, std::span<Vec3> x);

 private:
  struct Limited {
    int a;
    int b;
    double rest;
    double inverse_square;  ///< of rest
  };
  struct End {
    int spring;
    bool is_b;  ///< its end b, not a
  };
  /// Of all springs, or of a chunk of them.
  struct Survey {
    double largest = 0;  ///< strain
    int over = 0;        ///< springs beyond the limit
  };

  StrainReport adjust(std::span<const double> inverse_mass, const StrainControlOptions& options,
                      double scale, std::span<Vec3> out);
  template <typename Visit>
  Survey survey(const StrainControlOptions& options, const Visit& visit);
  Survey measure(const StrainControlOptions& options);
  Survey find_pulls(std::span<const double> inverse_mass, const StrainControlOptions& options);
  void count_requests();
  void apply_pulls(std::span<const double> inverse_mass, double scale, std::span<Vec3> out);
  void sweep_in_order(std::span<const double> inverse_mass, const StrainControlOptions& options,
                      double scale, std::span<Vec3> out);
  static std::optional<Vec3> pull_of(const Limited& spring, const Vec3& d, double square,
                                     std::span<const double> inverse_mass,
                                     const StrainControlOptions& options);

  std::vector<Limited> springs_;
  Adjacency<End> ends_;                 ///< at each node, in the order of the springs
  std::vector<Vec3> reached_;           ///< per node: predicted, and adjusted so far
  std::vector<Vec3> pulls_;             ///< per spring, see pull_of()
  std::vector<unsigned char> pulling_;  ///< per spring: its pull counts in this pass
  std::vector<unsigned char> touched_;  ///< per node: a spring pulls at it in this pass
  std::vector<int> requests_;           ///< per touched node: the springs that pull at it
  std::vector<Survey> surveys_;         ///< per chunk
};

}  // namespace toile
