#include "tools/make_mannequin/by_measures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "geometry/body/body_proportions.h"
#include "geometry/body/mannequin/fit_mannequin.h"
#include "geometry/body/measure_checks.h"
#include "geometry/error.h"
#include "io/measure_names.h"
#include "io/measures_file.h"
#include "io/text.h"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

/// Metres: what counts as met, of a girth and of a length.
constexpr double girth_bound = 0.002;
constexpr double length_bound = 0.003;

struct Asked {
  BodyMeasures measures;
  std::string gender;
  std::vector<std::string> left_out;
};

/// Left and right as one: a mannequin has two sides alike.
BodyMeasures without_sides(const std::map<std::string, double>& values) {
  BodyMeasures whole;
  for (const auto& [name, value] : values) {
    if (!name.starts_with("left_") && !name.starts_with("right_")) {
      whole[name] = value;
      continue;
    }
    const std::string bare = name.substr(name.find('_') + 1);
    if (values.contains(bare)) continue;
    const auto left = values.find("left_" + bare);
    const auto right = values.find("right_" + bare);
    if (left == values.end() || right == values.end()) {
      whole[bare] = value;
    } else {
      whole[bare] = (left->second + right->second) / 2;
    }
  }
  return whole;
}

Asked asked_measures(const MeasureSettings& settings) {
  constexpr double centimetre = 0.01;
  MeasureSet all;
  for (const std::string& text : settings.measures) {
    add_measure(text, settings.unit.value_or(centimetre), all);
  }
  Asked asked;
  for (const std::filesystem::path& file : settings.files) {
    MeasureSet set = read_measures(file, settings.unit);
    all.values.merge(set.values);
    if (!set.gender.empty()) asked.gender = set.gender;
    asked.left_out.insert(asked.left_out.end(), set.left_out.begin(), set.left_out.end());
  }
  asked.measures = without_sides(all.values);
  return asked;
}

Figure figure_of(const MeasureSettings& settings, const Asked& asked) {
  if (settings.figure == "woman") return Figure::woman;
  if (settings.figure == "man") return Figure::man;
  if (settings.figure == "child") return Figure::child;
  if (!settings.figure.empty()) {
    throw Error("--figure", "'" + settings.figure + "' is no figure", "give woman, man or child");
  }
  // Metres: adults of less are rare, and they can say so.
  constexpr double grown = 1.45;
  const auto height = asked.measures.find("height");
  if (height != asked.measures.end() && height->second < grown) return Figure::child;
  return asked.gender == "male" ? Figure::man : Figure::woman;
}

const char* name_of(Figure figure) {
  return figure == Figure::woman ? "woman" : figure == Figure::man ? "man" : "child";
}

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

bool is_girth(const std::string& name) {
  for (const char* girth :
       {"bust", "underbust", "waist", "abdomen", "hip", "neck", "head", "upper_thigh", "mid_thigh",
        "knee", "calf", "ankle", "upper_arm", "elbow", "wrist"}) {
    if (name == girth) return true;
  }
  return false;
}

/// What is said and reported besides the table.
struct Remarks {
  Json notes = Json::array();
  Json warnings = Json::array();
  const CommonSettings& common;

  void note(const std::string& line) {
    common.say("note: " + line);
    notes.push_back(line);
  }
  void warn(const std::string& line) {
    CommonSettings::warn(line);
    warnings.push_back(line);
  }
};

/// Each measure on a line of its own, and in the report.
Json table(const FittedMannequin& fitted, const CommonSettings& common, Remarks& remarks) {
  Json measures = Json::object();
  std::vector<std::string> missed;
  std::vector<std::string> unread;
  for (const FittedMeasure& measure : fitted.measures) {
    const bool is_read = std::isfinite(measure.measured);
    const MeasureName* entry = find_measure_name(measure.name);
    const bool is_angle = entry != nullptr && entry->unit == MeasureUnit::degrees;
    if (!is_read) unread.push_back(measure.name);
    if (is_angle) continue;
    const double off = measure.measured - measure.wanted;
    Json row = {{"wanted_cm", 100 * measure.wanted}};
    row["measured_cm"] = is_read ? Json(100 * measure.measured) : Json(nullptr);
    row["difference_mm"] = is_read ? Json(1000 * off) : Json(nullptr);
    row["source"] = measure.is_given ? "given" : "filled";
    measures[measure.name] = row;
    if (!is_read) continue;
    char line[120];
    std::snprintf(line, sizeof line, "%-20s %6.1f cm  %s %6.1f cm  %+5.1f mm", measure.name.c_str(),
                  100 * measure.measured, measure.is_given ? "given " : "filled",
                  100 * measure.wanted, 1000 * off);
    common.say(line);
    const double bound = is_girth(measure.name) ? girth_bound : length_bound;
    if (measure.is_given && std::abs(off) > bound) {
      missed.push_back(measure.name + " by " + fixed_number(1000 * off, 1) + " mm");
    }
  }
  if (!unread.empty()) {
    remarks.note("not fitted, for a mannequin has no control for it: " + joined(unread, ", "));
  }
  if (!missed.empty()) remarks.warn("the mannequin misses " + joined(missed, ", "));
  return measures;
}

}  // namespace

Mannequin mannequin_by_measures(const MeasureSettings& settings, MannequinOptions options,
                                const CommonSettings& common, Json& report) {
  Asked asked = asked_measures(settings);
  const Figure figure = figure_of(settings, asked);
  if (!settings.cup.empty()) {
    if (figure != Figure::woman || asked.measures.contains("underbust")) {
      throw Error("--cup", "is for a woman whose underbust is not given", "leave one out");
    }
    if (asked.measures.contains("bust")) {
      asked.measures["underbust"] = underbust_of_cup(asked.measures.at("bust"), settings.cup);
    }
  }
  const std::vector<std::string> wrong = contradictions(asked.measures);
  if (!wrong.empty()) {
    throw Error("measures", joined(wrong, "; "), "measure these again, and look at the unit");
  }
  Remarks remarks{.common = common};
  BodyMeasures filled = filled_measures(asked.measures, figure);
  BodyMeasures all = asked.measures;
  all.insert(filled.begin(), filled.end());
  if (settings.scales_edges) {
    // The same number of triangles for a child.
    constexpr double sample = 1.70;  // metres tall
    options.edge_length = std::clamp(options.edge_length * all.at("height") / sample, 0.004, 0.015);
  }
  FittedMannequin fitted = fit_mannequin(asked.measures, filled, figure, options);
  remarks.note(std::string("made as a ") + name_of(figure));
  report["figure"] = name_of(figure);
  report["measures"] = table(fitted, common, remarks);
  std::vector<std::string> names;
  for (const auto& [name, value] : filled) names.push_back(name);
  if (!names.empty()) remarks.note("filled from proportions: " + joined(names, ", "));
  if (!asked.left_out.empty()) {
    remarks.note("left out, without number or not known here: " + joined(asked.left_out, ", "));
  }
  report["notes"] = remarks.notes;
  report["warnings"] = remarks.warnings;
  return std::move(fitted.mannequin);
}

}  // namespace toile
