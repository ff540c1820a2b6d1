// What a fabric is to the simulation: measured quantities with units.
#pragma once

#include <filesystem>
#include <string>

namespace toile {

/// The defaults are those of the design: a light woven, until fabrics are calibrated.
struct Fabric {
  std::string name = "default";
  double areal_density = 0.15;  ///< kg/m²
  double stretch_warp = 1000;   ///< N/m, force per width and strain
  double stretch_weft = 1000;   ///< N/m
  double shear = 200;           ///< N/m
  double bending = 1e-5;        ///< N·m, per width
  double friction = 0.4;        ///< Coulomb, against the body
  /// Seconds: damping of a spring over its stiffness; of the paper's method only. Cloth's own is
  /// higher, but an explicit step has to stay below m/(k damping).
  double damping = 2e-5;
};

/// A preset's name or a JSON file with the fields above as keys ("stretch_warp_N_per_m",
/// "stretch_weft_N_per_m", "shear_N_per_m", "bending_N_m", "areal_density_kg_per_m2",
/// "friction", "damping_s", "name"); missing keys keep their defaults. Throws Error for an unknown name, an
/// unknown key, and values that are not finite and positive (bending, shear, friction and damping may be 0).
Fabric find_fabric(const std::string& name_or_file);

}  // namespace toile
