#include "tools/measure_body/files.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <pugixml.hpp>
#include <sstream>

#include "geometry/body/mannequin/mannequin_measures.h"
#include "io/csv.h"
#include "io/landmarks_json.h"
#include "io/text.h"
#include "tools/remarks.h"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

/// Hundredths of the unit: more digits mean nothing.
double rounded(double value) { return std::round(100 * value) / 100; }

Json measure_json(const MeasuredBody& all, const Measure& measure) {
  Json json;
  json["value"] = measure.value ? Json(rounded(all.shown(measure))) : Json(nullptr);
  if (measure.plus_minus > 0) json["plus_minus"] = rounded(all.shown_error(measure));
  if (measure.is_angle) json["unit"] = "degrees";
  json["definition"] = valid_utf8(measure.definition);
  if (!measure.iso.empty()) json["iso"] = measure.iso;
  json["confidence"] = measure.confidence;
  if (!measure.value) json["reason"] = valid_utf8(measure.reason);
  return json;
}

struct Foreign {
  std::string name;
  double value;  // metres or degrees
  bool is_angle;
};

std::vector<Foreign> foreign_values(const MeasuredBody& all, DraftingProgram program,
                                    ForeignGaps& gaps) {
  const MeasureValues measured = without_sides(values_of(all.measures));
  std::optional<MeasureValues> by_proportion;
  std::vector<Foreign> values;
  for (const ForeignMeasure& foreign : foreign_measures(program)) {
    const std::string name(foreign.name);
    double sum = 0;
    bool is_angle = false;
    bool is_filled = false;
    bool is_missing = false;
    for (const MeasureTerm& term : foreign.terms) {
      const std::string of(term.name);
      is_filled = is_filled || !measured.contains(of);
      if (is_filled && !by_proportion) {
        by_proportion = all.no_joints.empty() ? measures_by_proportion(measured) : MeasureValues();
      }
      const MeasureValues& from = measured.contains(of) ? measured : *by_proportion;
      is_missing = is_missing || !from.contains(of);
      if (is_missing) break;
      sum += term.factor * from.at(of);
      const MeasureName* known = find_measure_name(of);
      is_angle = known != nullptr && known->unit == MeasureUnit::degrees;
    }
    if (is_filled) (is_missing ? gaps.missing : gaps.filled).push_back(name);
    if (!is_missing) values.push_back({name, sum, is_angle});
  }
  return values;
}

std::string vit_file(const MeasuredBody& all, const std::vector<Foreign>& values) {
  pugi::xml_document document;
  pugi::xml_node vit = document.append_child("vit");
  const auto text = [](pugi::xml_node parent, const char* name, const char* content) {
    parent.append_child(name).text().set(content);
  };
  text(vit, "version", "0.3.3");
  text(vit, "read-only", "false");
  vit.append_child("notes").text().set(valid_utf8("measured on " + all.body_name).c_str());
  text(vit, "unit", all.unit == "inch" ? "inch" : "cm");
  text(vit, "pm_system", "998");
  pugi::xml_node personal = vit.append_child("personal");
  text(personal, "family-name", "");
  text(personal, "given-name", "");
  text(personal, "birth-date", "1800-01-01");
  text(personal, "gender", "unknown");
  text(personal, "email", "");
  pugi::xml_node list = vit.append_child("body-measurements");
  for (const Foreign& foreign : values) {
    pugi::xml_node m = list.append_child("m");
    m.append_attribute("name").set_value(foreign.name.c_str());
    const double value = foreign.is_angle ? foreign.value : foreign.value / metres_in(all.unit);
    m.append_attribute("value").set_value(fixed_number(value, 2).c_str());
  }
  std::ostringstream stream;
  document.save(stream, "  ", pugi::format_default, pugi::encoding_utf8);
  return stream.str();
}

}  // namespace

double MeasuredBody::shown(const Measure& measure) const {
  return measure.is_angle ? *measure.value : *measure.value / metres_in(unit);
}

double MeasuredBody::shown_error(const Measure& measure) const {
  return measure.is_angle ? measure.plus_minus : measure.plus_minus / metres_in(unit);
}

double metres_in(const std::string& unit) { return unit == "inch" ? 0.0254 : 0.01; }

Json measures_json(const MeasuredBody& all, const std::vector<MeasureDifference>& differences) {
  Json json = {{"format", "toile-measures"},
               {"format_version", 1},
               {"body", valid_utf8(all.body_name)},
               {"unit", all.unit}};
  json["measures"] = Json::object();
  for (const Measure& measure : all.measures) {
    json["measures"][measure.name] = measure_json(all, measure);
  }
  json["freehand"] = Json::object();
  for (const Measure& measure : all.freehand) {
    json["freehand"][valid_utf8(measure.name)] = measure_json(all, measure);
  }
  json["landmarks"] = landmarks_json(all.landmarks);
  if (!differences.empty()) {
    json["against"] = Json::object();
    for (const MeasureDifference& difference : differences) {
      json["against"][valid_utf8(difference.name)] = {
          {"before", rounded(difference.before)},
          {"now", rounded(difference.now)},
          {"difference", rounded(difference.now - difference.before)}};
    }
  }
  if (!all.no_joints.empty()) json["no_joints"] = valid_utf8(all.no_joints);
  add_remarks(all.remarks, json);
  return json;
}

std::string measures_csv(const MeasuredBody& all) {
  std::string csv = csv_line(
      {"name", "value", "unit", "plus_minus", "confidence", "iso", "definition", "reason"});
  for (const std::vector<Measure>* list : {&all.measures, &all.freehand}) {
    for (const Measure& measure : *list) {
      csv += csv_line({valid_utf8(measure.name),
                       measure.value ? fixed_number(all.shown(measure), 2) : "",
                       measure.is_angle ? "degrees" : all.unit,
                       measure.plus_minus > 0 ? fixed_number(all.shown_error(measure), 2) : "",
                       fixed_number(measure.confidence, 2), measure.iso,
                       valid_utf8(measure.definition), valid_utf8(measure.reason)});
    }
  }
  return csv;
}

std::string foreign_file(const MeasuredBody& all, DraftingProgram program, ForeignGaps& gaps) {
  const std::vector<Foreign> values = foreign_values(all, program, gaps);
  if (program == DraftingProgram::valentina) return vit_file(all, values);
  if (program == DraftingProgram::freesewing) {
    Json json = {{"name", valid_utf8(all.body_name)}, {"units", "metric"}};
    json["measurements"] = Json::object();
    for (const Foreign& foreign : values) {
      json["measurements"][foreign.name] =
          rounded(foreign.is_angle ? foreign.value : 1000 * foreign.value);
    }
    return json.dump(1) + "\n";
  }
  std::string yaml = "body:\n";
  for (const Foreign& foreign : values) {
    yaml += "  " + foreign.name + ": " +
            fixed_number(foreign.is_angle ? foreign.value : 100 * foreign.value, 4) + "\n";
  }
  return yaml;
}

}  // namespace toile
