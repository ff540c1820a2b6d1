#include "tools/report.h"

#include <nlohmann/json.hpp>

#include "cloth/judge/verdict.h"
#include "io/text.h"

namespace toile {

std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

nlohmann::ordered_json warnings_json(const std::vector<Warning>& warnings) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Warning& warning : warnings) {
    json.push_back({{"code", warning.code},
                    {"place", valid_utf8(warning.place)},
                    {"text", valid_utf8(warning.text)}});
  }
  return json;
}

std::vector<Warning> read_warnings(const JsonValue& report) {
  std::vector<Warning> warnings;
  const JsonValue all = report.get("warnings");
  for (std::size_t i = 0; i < all.size(); ++i) {
    const JsonValue one = all.item(i);
    warnings.push_back({one.get("code").text(), one.get("place").text(), one.get("text").text()});
  }
  return warnings;
}

std::vector<Warning> warnings_of(const std::string& code, const std::vector<std::string>& texts) {
  std::vector<Warning> warnings;
  warnings.reserve(texts.size());
  for (const std::string& text : texts) warnings.push_back({code, "", text});
  return warnings;
}

nlohmann::ordered_json names_json(const std::vector<int>& panels,
                                  const std::vector<std::string>& names) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const int panel : panels) json.push_back(valid_utf8(names[static_cast<std::size_t>(panel)]));
  return json;
}

nlohmann::ordered_json fit_json(const Fit& fit, const std::string& verdict,
                                const std::vector<std::string>& panels) {
  nlohmann::ordered_json json = {{"verdict", verdict}, {"levels", nlohmann::ordered_json::array()}};
  for (const FitLevel& level : fit.levels) {
    nlohmann::ordered_json row = {{"name", level.level},
                                  {"missing_cm", 100 * level.missing()},
                                  {"plus_minus_missing_cm", 100 * level.error},
                                  {"as_cut_cm", 100 * level.as_cut},
                                  {"body_cm", 100 * level.body}};
    if (level.drafted) {
      row["drafted_height_cm"] = 100 * *level.drafted;
      row["risen_cm"] = 100 * level.risen;
    }
    row["panels"] = names_json(level.panels, panels);
    json["levels"].push_back(std::move(row));
  }
  return json;
}

std::string verdict_line(const std::string& verdict, const std::string& fit) {
  return verdict == to_string(Verdict::intersecting) ? "fit: " + fit + "; verdict: " + verdict
                                                     : "verdict: " + verdict + "; fit: " + fit;
}

std::string report_text(const CommonSettings& common, const nlohmann::ordered_json& report) {
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - common.start;
  nlohmann::ordered_json whole = {
      {"program", common.program}, {"version", toile_version()}, {"seconds", seconds.count()}};
  whole.update(report);
  return json_text(whole);
}

void write_report(OutputFiles& files, const CommonSettings& common,
                  const nlohmann::ordered_json& report) {
  if (common.report) write_file(files.at(*common.report), report_text(common, report));
}

}  // namespace toile
