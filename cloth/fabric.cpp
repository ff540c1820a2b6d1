#include "cloth/fabric.h"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "geometry/error.h"
#include "io/output_file.h"

namespace toile {

Fabric find_fabric(const std::string& name_or_file) {
  Fabric fabric;
  if (name_or_file == fabric.name) return fabric;
  if (!std::filesystem::exists(name_or_file)) {
    throw Error("--fabric", "'" + name_or_file + "' is neither a fabric of Toile's nor a file",
                "use 'default' or a JSON file");
  }
  struct Field {
    double* value;
    bool may_be_zero;
  };
  const std::map<std::string, Field> fields = {
      {"areal_density_kg_per_m2", {&fabric.areal_density, false}},
      {"stretch_warp_N_per_m", {&fabric.stretch_warp, false}},
      {"stretch_weft_N_per_m", {&fabric.stretch_weft, false}},
      {"shear_N_per_m", {&fabric.shear, true}},
      {"bending_N_m", {&fabric.bending, true}},
      {"friction", {&fabric.friction, true}},
      {"damping_s", {&fabric.damping, true}}};
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
      *field->second.value = number;
    }
  } catch (const nlohmann::json::exception& wrong) {
    throw Error(name_or_file, wrong.what(), "mend the JSON");
  }
  return fabric;
}

}  // namespace toile
