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
  double bending_warp = 1e-5;   ///< N·m, per width: what resists bending of the warp threads
  double bending_weft = 1e-5;   ///< N·m; never more than `most_bending_ratio` apart
  double thickness = 0.0003;    ///< metres
  double friction_skin = 0.4;   ///< Coulomb, against the body
  double friction_cloth = 0.4;  ///< Coulomb, against cloth
  /// Seconds: damping of a spring over its stiffness; of the paper's method only. Cloth's own is
  /// higher, but an explicit step has to stay below m/(k damping).
  double damping = 2e-5;
};

/// How far the bending rigidities of warp and weft may be apart: what bending_across() can hold.
inline constexpr double most_bending_ratio = 9.5;

/// Rigidity, N·m, of a hinge whose normal in the cloth's plane lies at `angle` (radians) to the
/// weft: (p + q cos 2·angle)², with p and q such that an unstructured mesh rolled along the weft
/// has the energy ½ bending_weft/R² per area, along the warp ½ bending_warp/R², and at 45° q²/3
/// less than the mean of both. A hinge does not feel the curvature across it alone: the one that a
/// sheet of equilateral triangles with curvatures κ across and λ along it feels is κ - λ/3.
double bending_across(const Fabric& fabric, double angle);

/// A preset's name or a JSON file with the fields above as keys ("stretch_warp_N_per_m",
/// "stretch_weft_N_per_m", "shear_N_per_m", "bending_N_m", "areal_density_kg_per_m2",
/// "friction", "damping_s", "name"); missing keys keep their defaults. Throws Error for an unknown
/// name, an unknown key, and values that are not finite and positive (bending, shear, friction and
/// damping may be 0).
Fabric find_fabric(const std::string& name_or_file);

}  // namespace toile
