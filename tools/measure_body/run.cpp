#include "tools/measure_body/run.h"

#include <algorithm>
#include <boost/algorithm/string/predicate.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "cloth/scene/closed_body.h"
#include "geometry/body/measure_errors.h"
#include "geometry/body/measures.h"
#include "geometry/error.h"
#include "io/json_words.h"
#include "io/line_scanner.h"
#include "io/measures_file.h"
#include "io/output_file.h"
#include "io/text.h"
#include "tools/measure_body/files.h"
#include "tools/measure_body/freehand.h"
#include "tools/measure_body/page.h"
#include "tools/remarks.h"
#include "tools/report.h"

namespace toile {

namespace {

void take_all_freehand(const BodyShape& shape, const MeasureBodySettings& settings,
                       MeasuredBody& all) {
  std::set<std::string> names;
  const auto take = [&](const std::string& expression, const std::string& place) {
    Measure measure = take_freehand(shape, expression, place);
    if (find_measure(all.measures, measure.name) != nullptr || !names.insert(measure.name).second) {
      throw Error(place, in_quotes(measure.name) + " is there twice", "give name=ANOTHER");
    }
    all.freehand.push_back(std::move(measure));
  };
  for (const std::string& expression : settings.freehand) take(expression, "--at");
  if (!settings.freehand_file) return;
  const std::string file = settings.freehand_file->string();
  const std::string text = read_file(*settings.freehand_file);
  LineScanner lines(text, file);
  while (lines.next_line('#')) {
    take(std::string(lines.rest()), lines.place());
  }
}

std::vector<MeasureDifference> differences_to(const std::filesystem::path& file, MeasuredBody& all,
                                              const CommonSettings& common) {
  std::vector<MeasureDifference> differences;
  const MeasureSet set = read_measures(file);
  for (const auto& [name, before] : set.values) {
    bool is_known = false;
    // A name without a side stands for both.
    for (const std::string side : {"", "left_", "right_"}) {
      const Measure* now = find_measure(all.measures, side + name);
      if (now == nullptr) continue;
      is_known = true;
      if (!now->value) {
        all.remarks.push_back({false, shown_text(side + name) + " of " + file.string() +
                                          " is not taken: " + now->reason});
        continue;
      }
      const double unit = now->is_angle ? 1 : metres_in(all.unit);
      differences.push_back({side + name, before / unit, all.shown(*now)});
      const MeasureDifference& last = differences.back();
      common.say(shown_text(last.name) + ": " + fixed_number(last.before, 2) + " before, " +
                 fixed_number(last.now, 2) + " now, difference " +
                 fixed_number(last.now - last.before, 2) + " " +
                 (now->is_angle ? "degrees" : all.unit));
    }
    if (!is_known) {
      all.remarks.push_back({false, shown_text(name) + " of " + file.string() + " is not taken"});
    }
  }
  for (const std::string& name : set.left_out) {
    all.remarks.push_back({false, shown_text(name) + " of " + file.string() + " is not known"});
  }
  return differences;
}

bool has_nothing(const MeasuredBody& all) {
  return std::none_of(all.measures.begin(), all.measures.end(),
                      [](const Measure& measure) { return measure.value; });
}

void say_summary(const MeasuredBody& all, const CommonSettings& common) {
  const auto is_taken = [](const Measure& measure) { return measure.value.has_value(); };
  const auto taken =
      std::ranges::count_if(all.measures, is_taken) + std::ranges::count_if(all.freehand, is_taken);
  for (const char* name : {"height", "bust", "underbust", "waist", "hip", "inside_leg"}) {
    const Measure* measure = find_measure(all.measures, name);
    if (measure == nullptr || !measure->value) continue;
    common.say(std::string(name) + " " + fixed_number(all.shown(*measure), 1) + " ± " +
               fixed_number(all.shown_error(*measure), 1) + " " + all.unit);
  }
  for (const Measure& measure : all.freehand) {
    common.say(shown_text(measure.name) + ": " +
               (measure.value ? fixed_number(all.shown(measure), 2) +
                                    (measure.is_angle ? " degrees" : " " + all.unit)
                              : measure.reason));
  }
  common.say(std::to_string(taken) + " of " +
             std::to_string(all.measures.size() + all.freehand.size()) + " measures taken");
}

}  // namespace

MeasuredBody take_measures(const TriangleMesh& body, const std::string& name,
                           const MeasureBodySettings& settings) {
  const BodyShape shape = find_landmarks(body, name);
  MeasuredBody all;
  all.body_name = name;
  all.unit = settings.unit;
  all.measures = measure_body(shape);
  estimate_errors(body, name, all.measures);
  all.landmarks = given_landmarks(shape);
  all.no_joints = shape.frame.no_skeleton;
  take_all_freehand(shape, settings, all);
  if (!all.no_joints.empty()) all.remarks.push_back({true, all.no_joints});
  for (const auto& [part, why] : shape.frame.missing) {
    std::string words = part;
    std::ranges::replace(words, '_', ' ');
    all.remarks.push_back({true, std::string(all.body_name)
                                     .append(": nothing is measured of the ")
                                     .append(words)
                                     .append(": ")
                                     .append(why)});
  }
  if (has_nothing(all)) {
    all.remarks.push_back({true, all.body_name + ": nothing can be measured on it"});
  }
  return all;
}

int run_measure_body(const MeasureBodySettings& settings, const CommonSettings& common) {
  const TriangleMesh body = read_closed_body(settings.body);
  // Its file alone: what is written does not depend on where the body lies.
  MeasuredBody all = take_measures(body, settings.body.filename().string(), settings);
  std::vector<MeasureDifference> differences;
  if (settings.against) differences = differences_to(*settings.against, all, common);
  OutputFiles files;
  for (const auto& [program, path] : settings.others) {
    ForeignGaps gaps;
    write_file(files.at(path), foreign_file(all, program, gaps));
    if (!gaps.filled.empty()) {
      all.remarks.push_back({true, path.string() + ": filled in by proportion, as the body does " +
                                       "not show them: " + listed(gaps.filled)});
    }
    if (gaps.missing.empty()) continue;
    all.remarks.push_back({false, path.string() + " lacks " + std::to_string(gaps.missing.size()) +
                                      ": " + listed(gaps.missing)});
  }
  const bool is_csv = boost::algorithm::iequals(common.output.extension().string(), ".csv");
  write_file(files.at(common.output),
             is_csv ? measures_csv(all) : json_text(measures_json(all, differences)));
  write_report(files, common, measures_json(all, differences));
  if (settings.html) write_file(files.at(*settings.html), measures_page(body, all));
  if (settings.png) write_file(files.at(*settings.png), measures_picture(body, all));
  files.commit();
  say_remarks(all.remarks, common);
  say_summary(all, common);
  common.say("wrote " + common.output.string());
  return has_nothing(all) ? exit_negative : exit_done;
}

}  // namespace toile
