#include "cloth/fabric.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "geometry/error.h"
#include "io/output_file.h"

namespace toile {

double bending_across(const Fabric& fabric, double angle) {
  const double mean = 0.5 * (fabric.bending_weft + fabric.bending_warp);
  const double half = 0.5 * (fabric.bending_weft - fabric.bending_warp);
  if (half == 0) return mean;
  // p² + 2/3 q² = mean and 4/3 p q = half: integrated over all directions of hinges.
  const double p =
      std::sqrt(0.5 * (mean + std::sqrt(std::max(mean * mean - 1.5 * half * half, 0.0))));
  const double q = 0.75 * half / p;
  return std::pow(p + q * std::cos(2 * angle), 2);
}

Fabric find_fabric(const std::string& name_or_file) {
  Fabric fabric;
  if (name_or_file == fabric.name) return fabric;
  if (!std::filesystem::exists(name_or_file)) {
    throw Error("--fabric", "'" + name_or_file + "' is neither a fabric of Toile's nor a file",
                "use 'default' or a JSON file");
  }
  struct Field {
    std::vector<double*> values;
    bool may_be_zero;
    double unit = 1;
  };
  const std::map<std::string, Field> fields = {
      {"areal_density_kg_per_m2", {{&fabric.areal_density}, false}},
      {"thickness_mm", {{&fabric.thickness}, false, 1e-3}},
      {"stretch_warp_N_per_m", {{&fabric.stretch_warp}, false}},
      {"stretch_weft_N_per_m", {{&fabric.stretch_weft}, false}},
      {"shear_N_per_m", {{&fabric.shear}, true}},
      {"bending_N_m", {{&fabric.bending_warp, &fabric.bending_weft}, true}},
      {"bending_warp_N_m", {{&fabric.bending_warp}, true}},
      {"bending_weft_N_m", {{&fabric.bending_weft}, true}},
      {"friction", {{&fabric.friction_skin, &fabric.friction_cloth}, true}},
      {"friction_skin", {{&fabric.friction_skin}, true}},
      {"friction_cloth", {{&fabric.friction_cloth}, true}},
      {"damping_s", {{&fabric.damping}, true}}};
  try {
    const auto json = nlohmann::json::parse(read_file(name_or_file));
    if (!json.is_object()) throw Error(name_or_file, "is no JSON object", "see the README");
    for (const auto& [key, value] : json.items()) {
      if (key == "name") {
        fabric.name = value.get<std::string>();
        continue;
      }
      const auto field = fields.find(key);
      if (field == fields.end()) {
        throw Error(name_or_file, "'" + key + "' is no quantity of a fabric",
                    "see the README for the keys");
      }
      const double number = value.get<double>();
      if (!std::isfinite(number) || number < 0 || (number == 0 && !field->second.may_be_zero)) {
        throw Error(name_or_file, "'" + key + "' is " + value.dump(),
                    "give a positive number in the unit of the key");
      }
      for (double* quantity : field->second.values) *quantity = field->second.unit * number;
    }
  } catch (const nlohmann::json::exception& wrong) {
    throw Error(name_or_file, wrong.what(), "mend the JSON");
  }
  return fabric;
}

}  // namespace toile
