#include "tools/make_mannequin/by_measures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "geometry/body/body_proportions.h"
#include "geometry/body/mannequin/fit_mannequin.h"
#include "geometry/body/measure_checks.h"
#include "geometry/body/measures.h"
#include "geometry/error.h"
#include "io/json_words.h"
#include "io/measure_names.h"
#include "io/measures_file.h"
#include "io/text.h"
#include "tools/remarks.h"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

/// Metres: what counts as met, of a girth and of a length.
constexpr double girth_bound = 0.002;
constexpr double length_bound = 0.003;

struct Asked {
  MeasureValues measures;
  std::string gender;
  std::map<std::string, std::string> taken_as;
  std::vector<std::string> left_out;
};

Asked asked_measures(const MeasureSettings& settings) {
  constexpr double centimetre = 0.01;
  MeasureSet typed;
  for (const std::string& text : settings.measures) {
    add_measure(text, settings.unit.value_or(centimetre), typed);
  }
  // The command line wins over the files, and each file over those after it.
  Asked asked;
  asked.measures = without_sides(typed.values);
  asked.taken_as = typed.taken_as;
  for (const std::filesystem::path& file : settings.files) {
    const MeasureSet set = read_measures(file, settings.unit);
    asked.measures.merge(without_sides(set.values));
    if (asked.gender.empty()) asked.gender = set.gender;
    asked.taken_as.insert(set.taken_as.begin(), set.taken_as.end());
    asked.left_out.insert(asked.left_out.end(), set.left_out.begin(), set.left_out.end());
  }
  return asked;
}

FigureType figure_of(const MeasureSettings& settings, const Asked& asked) {
  if (settings.figure == "woman") return FigureType::woman;
  if (settings.figure == "man") return FigureType::man;
  if (settings.figure == "child") return FigureType::child;
  // Metres: adults of less are rare, and they can say so.
  constexpr double grown = 1.45;
  const auto height = asked.measures.find("height");
  if (height != asked.measures.end() && height->second < grown) return FigureType::child;
  return asked.gender == "male" ? FigureType::man : FigureType::woman;
}

const char* name_of(FigureType figure) {
  return figure == FigureType::woman ? "woman" : figure == FigureType::man ? "man" : "child";
}

bool is_girth(const std::string& name) {
  for (const char* girth :
       {"bust", "underbust", "waist", "abdomen", "hip", "neck", "head", "upper_thigh", "mid_thigh",
        "knee", "calf", "ankle", "upper_arm", "elbow", "wrist"}) {
    if (name == girth) return true;
  }
  return false;
}

/// Each measure on a line of its own, and in the report.
Json table(const FittedMannequin& fitted, const CommonSettings& common,
           std::vector<Remark>& remarks) {
  Json measures = Json::object();
  std::vector<const FittedMeasure*> missed;
  std::vector<std::string> unread;
  std::vector<std::string> uncontrolled;
  common.say("measure                 body      given, filled  off");
  for (const FittedMeasure& measure : fitted.measures) {
    const bool is_read = std::isfinite(measure.measured);
    const MeasureName* entry = find_measure_name(measure.name);
    const bool is_angle = entry != nullptr && entry->unit == MeasureUnit::degrees;
    if (measure.is_given && !measure.is_fitted) uncontrolled.push_back(measure.name);
    if (measure.is_given && measure.is_fitted && !is_read) unread.push_back(measure.name);
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
    if (measure.is_given && measure.is_fitted && std::abs(off) > bound) {
      missed.push_back(&measure);
    }
  }
  if (!uncontrolled.empty()) {
    remarks.push_back(
        {false, "not fitted, for nothing of a mannequin moves it alone: " + listed(uncontrolled)});
  }
  if (!unread.empty()) {
    remarks.push_back({true, "not met, for it can't be measured on this body: " + listed(unread)});
  }
  if (missed.empty()) return measures;
  // Measures that contradict each other are those that are missed the most.
  std::ranges::stable_sort(missed, std::ranges::greater(), [](const FittedMeasure* measure) {
    return std::abs(measure->measured - measure->wanted);
  });
  std::vector<std::string> by_size;
  by_size.reserve(missed.size());
  for (const FittedMeasure* measure : missed) {
    by_size.push_back(measure->name + " by " +
                      fixed_number(1000 * (measure->measured - measure->wanted), 1) + " mm");
  }
  remarks.push_back({true, "the mannequin misses " + listed(by_size) + "; measure " +
                               missed.front()->name + " again, and look at its unit"});
  return measures;
}

}  // namespace

Mannequin mannequin_by_measures(const MeasureSettings& settings, MannequinOptions options,
                                const CommonSettings& common, Json& report) {
  Asked asked = asked_measures(settings);
  const FigureType figure = figure_of(settings, asked);
  if (!settings.cup.empty()) {
    if (figure != FigureType::woman || asked.measures.contains("underbust")) {
      throw UsageError("--cup", "is for a woman whose underbust is not given", "leave one out");
    }
    if (asked.measures.contains("bust")) {
      asked.measures["underbust"] = underbust_of_cup(asked.measures.at("bust"), settings.cup);
    }
  }
  MeasureValues filled = filled_measures(asked.measures, figure);
  // Heights that others tell are checked, too: one in the wrong unit would make a giant.
  MeasureValues derived;
  for (const char* name : {"height", "cervicale_height", "waist_height", "crotch_height"}) {
    if (filled.contains(name)) derived.emplace(name, filled.at(name));
  }
  if (const std::vector<std::string> wrong = contradictions(asked.measures, derived);
      !wrong.empty()) {
    std::string all;
    for (const std::string& line : wrong) all += (all.empty() ? "" : "; ") + line;
    throw Error("measures", all, "measure these again, and look at the unit");
  }
  std::vector<Remark> remarks;
  MeasureValues all = asked.measures;
  all.insert(filled.begin(), filled.end());
  if (settings.scales_edges) {
    // The same number of triangles for a child.
    constexpr double sample = 1.70;  // metres tall
    options.edge_length = std::clamp(options.edge_length * all.at("height") / sample, 0.004, 0.015);
  }
  FittedMannequin fitted =
      fit_mannequin(asked.measures, filled, figure, options, settings.pose_is_given);
  remarks.push_back({false, std::string("made as a ") + name_of(figure)});
  const double arms = fitted.pose.left.shoulder_abduction;
  if (arms != standing_pose().left.shoulder_abduction) {
    remarks.push_back({false, "measured with its arms " + number_text(arms) +
                                  " degrees away from the trunk: lower, they lie at the bust"});
  }
  report["figure"] = name_of(figure);
  report["measures"] = table(fitted, common, remarks);
  std::vector<std::string> names;
  for (const auto& [name, value] : filled) names.push_back(name);
  if (!names.empty()) remarks.push_back({false, "filled from proportions: " + listed(names)});
  std::vector<std::string> words;
  for (const auto& [word, name] : asked.taken_as) words.push_back(shown_text(word) + " is " + name);
  if (!words.empty()) remarks.push_back({false, "taken as: " + listed(words)});
  if (!asked.left_out.empty()) {
    constexpr std::size_t most = 12;  // files of other programs hold hundreds
    const std::size_t count = asked.left_out.size();
    for (std::string& name : asked.left_out) name = shown_text(name);
    asked.left_out.resize(std::min(count, most));
    remarks.push_back(
        {false, "left out, without number or not known here: " + listed(asked.left_out) +
                    (count > most ? " and " + std::to_string(count - most) + " more" : "")});
  }
  say_remarks(remarks, common);
  add_remarks(remarks, report);
  return std::move(fitted.mannequin);
}

}  // namespace toile
