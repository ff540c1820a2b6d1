// A fabric: measured quantities with units.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace toile {

class JsonValue;

/// A fabric. The defaults are the design's: a light woven, not measured. Stretch and shear are
/// moduli at small strain. The warp runs along the grain; for a knit, warp stands for the wales.
struct Fabric {
  std::string name = "default";
  std::string source;           ///< where the values are from; empty: not stated
  double areal_density = 0.15;  ///< kg/m²
  double thickness = 0.0003;    ///< metres
  double stretch_warp = 1000;   ///< N/m, force per width and strain
  double stretch_weft = 1000;   ///< N/m
  double shear = 200;           ///< N/m, force per width and angle (radians)
  /// N/m: the largest of stretch and shear as the file states it, if that is above `max_modulus`;
  /// else 0.
  double stiffness_given = 0;
  double bending_warp = 1e-5;   ///< N·m, per width: resists bending of the warp threads
  double bending_weft = 1e-5;   ///< N·m, per width: resists bending of the weft threads
  double friction_skin = 0.4;   ///< Coulomb, against the body
  double friction_cloth = 0.4;  ///< Coulomb, against cloth
  /// Seconds: damping of a spring over its stiffness, for the paper's method only. Real cloth is
  /// damped more, but an explicit step has to stay below mass / (stiffness × damping).
  double damping = 2e-5;
};

/// Reads the keys of such a file from a JSON object; `place` names it in errors. Throws as
/// find_fabric() does.
Fabric fabric_from(const JsonValue& object, const std::string& place);

/// The quantities of a fabric, as such a file has them.
nlohmann::ordered_json fabric_json(const Fabric& fabric);

/// N/m: Young's modulus in the direction at `angle` radians to the weft, of a sheet without
/// contraction across [Jones 1999, Mechanics of Composite Materials, 2.6]. Shear counts as at least
/// `min_shear_share` of the weft's.
double modulus_at(const Fabric& fabric, double angle);

/// Names of the fabrics that find_fabric() knows, "default" first.
std::vector<std::string> fabric_names();

/// Finds a fabric of fabric_names(), or reads a JSON file as docs/fabric.schema.json states it. The
/// file's keys are the fields above with their units; missing keys keep their defaults. Stretch and
/// shear are cut to `max_modulus`.
///
/// Throws Error for an unknown name or key. Throws it for values that are not finite and positive,
/// or are beyond any fabric's. Bending, shear, friction and damping may be 0.
Fabric find_fabric(const std::string& name_or_file);

}  // namespace toile
