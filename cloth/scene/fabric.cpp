#include "cloth/scene/fabric.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "cloth/scene/constants.h"
#include "geometry/error.h"
#include "io/json_value.h"
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

/// The quantities that a key of a fabric's file sets, and the range of its value.
struct Quantity {
  std::vector<double*> values;
  bool may_be_zero;
  double max;       ///< in the key's unit; far more than anything worn has
  double unit = 1;  ///< the key's unit over the field's
  double cut_to = std::numeric_limits<double>::infinity();  ///< in the field's unit
};

double number_of(const JsonValue& value, const std::string& key, const Quantity& quantity,
                 const std::string& place) {
  const double number = value.number();
  const auto said = [&] {
    std::ostringstream text;
    text << "'" << key << "' is " << number;
    return text.str();
  };
  if (number < 0 || (number == 0 && !quantity.may_be_zero)) {
    throw Error(place, said(), "give a positive number in the unit of the key");
  }
  if (number > quantity.max) {
    throw Error(place, said() + ", more than any fabric has", "give it in the unit of the key");
  }
  return number;
}

Fabric read_fabric(const std::string& text, const std::string& place) {
  return fabric_from(JsonDocument(text, place).root(), place);
}

}  // namespace

Fabric fabric_from(const JsonValue& root, const std::string& place) {
  Fabric fabric;
  const std::map<std::string, Quantity> quantities = {
      {"areal_density_kg_per_m2", {{&fabric.areal_density}, false, 100}},
      {"thickness_mm", {{&fabric.thickness}, false, 30, 1e-3}},
      {"stretch_warp_N_per_m", {{&fabric.stretch_warp}, false, 1e9, 1, max_modulus}},
      {"stretch_weft_N_per_m", {{&fabric.stretch_weft}, false, 1e9, 1, max_modulus}},
      {"shear_N_per_m", {{&fabric.shear}, true, 1e9, 1, max_modulus}},
      {"bending_N_m", {{&fabric.bending_warp, &fabric.bending_weft}, true, 10}},
      {"bending_warp_N_m", {{&fabric.bending_warp}, true, 10}},
      {"bending_weft_N_m", {{&fabric.bending_weft}, true, 10}},
      {"friction", {{&fabric.friction_skin, &fabric.friction_cloth}, true, 100}},
      {"friction_skin", {{&fabric.friction_skin}, true, 100}},
      {"friction_cloth", {{&fabric.friction_cloth}, true, 100}},
      {"damping_s", {{&fabric.damping}, true, 1}}};
  if (!root.is_object()) throw Error(place, "is no JSON object", "docs/fabrics.md states the keys");
  // Sorted: a key for both warp and weft is read before the keys for one of them.
  std::vector<std::string> keys = root.keys();
  std::ranges::sort(keys);
  for (const std::string& key : keys) {
    const std::string where = place + ": '" + valid_utf8(key) + "'";
    const std::optional<JsonValue> found = root.find(key);
    if (!found) throw Error(where, "is null", "leave the key out");
    const JsonValue value = found->called(where);
    const auto quantity = quantities.find(key);
    if (key == "name") {
      fabric.name = value.text();
    } else if (key == "source") {
      fabric.source = value.text();
    } else if (key == "estimated") {
      for (std::size_t i = 0; i < value.size(); ++i) {
        const std::string of = value.item(i).text();
        if (quantities.count(of) != 0) continue;
        throw Error(where, "names '" + valid_utf8(of) + "', no quantity", "name keys of the file");
      }
    } else if (quantity != quantities.end()) {
      const Quantity& sets = quantity->second;
      const double number = number_of(value, key, sets, place);
      for (double* of : sets.values) *of = std::min(sets.unit * number, sets.cut_to);
      if (number > sets.cut_to) fabric.stiffness_given = std::max(fabric.stiffness_given, number);
    } else {
      throw Error(where, "is no quantity of a fabric", "docs/fabrics.md states the keys");
    }
  }
  return fabric;
}

nlohmann::ordered_json fabric_json(const Fabric& fabric) {
  return {{"name", fabric.name},
          {"areal_density_kg_per_m2", fabric.areal_density},
          {"thickness_mm", 1000 * fabric.thickness},
          {"stretch_warp_N_per_m", fabric.stretch_warp},
          {"stretch_weft_N_per_m", fabric.stretch_weft},
          {"shear_N_per_m", fabric.shear},
          {"bending_warp_N_m", fabric.bending_warp},
          {"bending_weft_N_m", fabric.bending_weft},
          {"friction_skin", fabric.friction_skin},
          {"friction_cloth", fabric.friction_cloth}};
}

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
  const double shear = std::max(fabric.shear, min_shear_share * fabric.stretch_weft);
  return 1 / (weft * weft / fabric.stretch_weft + warp * warp / fabric.stretch_warp +
              weft * warp / shear);
}

}  // namespace toile
