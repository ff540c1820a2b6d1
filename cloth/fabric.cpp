#include "cloth/fabric.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "geometry/error.h"
#include "io/output_file.h"
#include "io/text.h"

namespace toile {

namespace {

struct Preset {
  const char* name;
  const char* json;
};

/// The files of the folder fabrics, in the order of their names.
constexpr Preset presets[] = {
#include "fabric_presets.inc"
};

/// What a key of a fabric's file sets.
struct Quantity {
  std::vector<double*> values;
  bool may_be_zero;
  double most;  ///< that anything worn has, and far more; in the key's unit
  double unit = 1;
  double counts = std::numeric_limits<double>::infinity();  ///< at most
};

double number_of(const nlohmann::json& value, const std::string& key, const Quantity& quantity,
                 const std::string& place) {
  const double number = value.get<double>();
  if (!std::isfinite(number) || number < 0 || (number == 0 && !quantity.may_be_zero)) {
    throw Error(place, "'" + key + "' is " + value.dump(),
                "give a positive number in the unit of the key");
  }
  if (number > quantity.most) {
    throw Error(place, "'" + key + "' is " + value.dump() + ", more than any fabric has",
                "give it in the unit of the key");
  }
  return number;
}

Fabric read_fabric(const std::string& text, const std::string& place) {
  Fabric fabric;
  const std::map<std::string, Quantity> quantities = {
      {"areal_density_kg_per_m2", {{&fabric.areal_density}, false, 100}},
      {"thickness_mm", {{&fabric.thickness}, false, 30, 1e-3}},
      {"stretch_warp_N_per_m", {{&fabric.stretch_warp}, false, 1e9, 1, stiffest}},
      {"stretch_weft_N_per_m", {{&fabric.stretch_weft}, false, 1e9, 1, stiffest}},
      {"shear_N_per_m", {{&fabric.shear}, true, 1e9, 1, stiffest}},
      {"bending_N_m", {{&fabric.bending_warp, &fabric.bending_weft}, true, 10}},
      {"bending_warp_N_m", {{&fabric.bending_warp}, true, 10}},
      {"bending_weft_N_m", {{&fabric.bending_weft}, true, 10}},
      {"friction", {{&fabric.friction_skin, &fabric.friction_cloth}, true, 100}},
      {"friction_skin", {{&fabric.friction_skin}, true, 100}},
      {"friction_cloth", {{&fabric.friction_cloth}, true, 100}},
      {"damping_s", {{&fabric.damping}, true, 1}}};
  try {
    // Sorted by key: what says "both" is read before what says one of them.
    const auto json = nlohmann::json::parse(text);
    if (!json.is_object()) throw Error(place, "is no JSON object", "see the README");
    for (const auto& [key, value] : json.items()) {
      if (key == "name") {
        fabric.name = value.get<std::string>();
      } else if (key == "source") {
        fabric.source = value.get<std::string>();
      } else if (key == "estimated") {
        for (const auto& of : value.get<std::vector<std::string>>()) {
          if (quantities.count(of) == 0) {
            throw Error(place,
                        std::string("'estimated' names '") + valid_utf8(of) + "', no quantity",
                        "name keys of the file");
          }
        }
      } else if (const auto found = quantities.find(key); found != quantities.end()) {
        const Quantity& quantity = found->second;
        const double number = number_of(value, key, quantity, place);
        for (double* of : quantity.values) *of = std::min(quantity.unit * number, quantity.counts);
        if (number > quantity.counts) {
          fabric.stiffness_given = std::max(fabric.stiffness_given, number);
        }
      } else {
        throw Error(place, std::string("'") + valid_utf8(key) + "' is no quantity of a fabric",
                    "see the README for the keys");
      }
    }
  } catch (const nlohmann::json::exception& wrong) {
    throw Error(place, wrong.what(), "mend the JSON");
  }
  return fabric;
}

}  // namespace

std::vector<std::string> fabric_names() {
  std::vector<std::string> names = {Fabric().name};
  for (const Preset& preset : presets) names.emplace_back(preset.name);
  return names;
}

Fabric find_fabric(const std::string& name_or_file) {
  if (name_or_file == Fabric().name) return {};
  for (const Preset& preset : presets) {
    if (name_or_file == preset.name) return read_fabric(preset.json, name_or_file);
  }
  std::error_code unreachable;
  if (std::filesystem::is_regular_file(name_or_file, unreachable)) {
    return read_fabric(read_file(name_or_file), name_or_file);
  }
  std::string known;
  for (const std::string& name : fabric_names()) {
    if (!known.empty()) known += ", ";
    known += name;
  }
  throw Error("fabric",
              std::string("'") + valid_utf8(name_or_file) + "' is neither known nor a file",
              "known are " + known + "; or give a JSON file");
}

double modulus_at(const Fabric& fabric, double angle) {
  const double weft = std::pow(std::cos(angle), 2);
  const double warp = 1 - weft;
  const double shear = std::max(fabric.shear, 1e-3 * fabric.stretch_weft);
  return 1 / (weft * weft / fabric.stretch_weft + warp * warp / fabric.stretch_warp +
              weft * warp / shear);
}

}  // namespace toile
