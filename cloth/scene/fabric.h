// What a fabric is to the simulation: measured quantities with units.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace toile {

/// N/m of stretch and shear that count at most. What is stiffer moves too little in a step to come
/// to rest in any time, for little: a hand's pull of 300 N/m stretches this by 0.3 %.
inline constexpr double stiffest = 1e5;

/// The defaults are those of the design: a light woven, not measured. Stretch and shear are moduli
/// at small strain. The warp runs along the grain; of a knit, warp stands for the wales.
struct Fabric {
  std::string name = "default";
  std::string source;           ///< where the values are from; empty: not said
  double areal_density = 0.15;  ///< kg/m²
  double thickness = 0.0003;    ///< metres
  double stretch_warp = 1000;   ///< N/m, force per width and strain
  double stretch_weft = 1000;   ///< N/m
  double shear = 200;           ///< N/m, force per width and angle (radians)
  /// N/m, the largest of these three as the file has it, if that is beyond `stiffest`; else 0.
  double stiffness_given = 0;
  double bending_warp = 1e-5;   ///< N·m, per width: what resists bending of the warp threads
  double bending_weft = 1e-5;   ///< N·m, the same of the weft threads
  double friction_skin = 0.4;   ///< Coulomb, against the body
  double friction_cloth = 0.4;  ///< Coulomb, against cloth
  /// Seconds: damping of a spring over its stiffness; of the paper's method only. Cloth's own is
  /// higher, but an explicit step has to stay below m/(k damping).
  double damping = 2e-5;
};

/// Young's modulus, N/m, in the direction at `angle` (radians) to the weft, of a sheet without
/// contraction across [Jones 1999, Mechanics of Composite Materials, 2.6]. Shear counts as no less
/// than a thousandth of the weft's.
double modulus_at(const Fabric& fabric, double angle);

/// Names of the fabrics that find_fabric() knows, "default" first.
std::vector<std::string> fabric_names();

/// A fabric of fabric_names(), or a JSON file as docs/fabric.schema.json says, whose keys are the
/// fields above with their units; missing ones keep their defaults. Throws Error for an unknown
/// name or key, and for values that are not finite and positive (bending, shear, friction and
/// damping may be 0) or are beyond any fabric's. Stretch and shear are cut to `stiffest`.
Fabric find_fabric(const std::string& name_or_file);

}  // namespace toile
