#include "tools/batch/row_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "geometry/error.h"
#include "io/checksum.h"
#include "io/json_value.h"
#include "io/output_file.h"
#include "io/skeleton_file.h"
#include "io/text.h"
#include "tools/batch/outcome.h"
#include "tools/program.h"
#include "tools/report.h"

namespace toile {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Nothing where the file can't be read: the program that reads it says why.
std::optional<std::string> checksum_of(const fs::path& file) {
  try {
    return sha256_of_file(file);
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// A file and its checksum: null where it can't be read.
Json input_json(const fs::path& file, const std::optional<std::string>& checksum) {
  return {{"file", valid_utf8(file.string())}, {"sha256", checksum ? Json(*checksum) : Json()}};
}

Json limits_json(const RowLimits& limits) {
  return {{"timeout_s", limits.seconds ? Json(*limits.seconds) : Json()},
          {"memory_bytes", limits.memory ? Json(*limits.memory) : Json()}};
}

void check_flag(const JsonValue& value) {
  if (!value.is_flag()) value.fail("is neither true nor false");
}

/// Throws Error where an outcome lacks what results and pictures tell of it, or has it in another
/// type.
void check_outcome(const JsonValue& outcome) {
  for (const char* told : {"cause", "detail"}) outcome.get(told).text();
  for (const char* told : {"seconds", "peak_MiB"}) outcome.get(told).number();
  check_flag(outcome.get("body_usable"));
  read_warnings(outcome);
  const JsonValue figures = outcome.get("figures");
  const JsonValue verdict = outcome.get("verdict");
  const std::vector<std::string> known = verdicts_in_order();
  if (std::ranges::find(known, verdict.text()) == known.end()) verdict.fail("is unknown");
  if (verdict.text() == error_verdict) {
    if (!figures.keys().empty()) figures.fail("a row that failed has figures");
    for (const char* told : {"mesh_seconds", "dress_seconds"}) {
      if (const auto given = outcome.find(told)) given->number();
    }
    return;
  }
  for (const char* told : {"mesh_seconds", "dress_seconds"}) outcome.get(told).number();
  figures.get("fit").text();
  for (const char* told : {"strain_p99", "strain_max", "max_gap_mm"}) figures.get(told).number();
  for (const char* told :
       {"seams_open", "intersections_body", "intersections_self", "attempts", "nodes"}) {
    figures.get(told).index();
  }
  check_flag(figures.get("converged"));
  for (const char* ease : {"bust_ease_cm", "waist_ease_cm", "hip_ease_cm"}) {
    if (const auto given = figures.find(ease)) given->number();
  }
}

}  // namespace

RowKeys::RowKeys(const RowLimits& limits)
    : limits_(limits), executable_(sha256_of_file("/proc/self/exe")) {}

Json RowKeys::input_of(const fs::path& file) {
  auto known = checksums_.find(file);
  if (known == checksums_.end()) known = checksums_.emplace(file, checksum_of(file)).first;
  return input_json(file, known->second);
}

Json RowKeys::key_of(const BatchRow& row) {
  Json key;
  key["program"] = "toile batch";
  key["version"] = toile_version();
  key["executable_sha256"] = executable_;
  key["name"] = row.name;
  key["inputs"]["pattern"] = input_json(row.pattern, checksum_of(row.pattern));
  key["inputs"]["body"] = input_of(row.body);
  const Json joints = input_of(skeleton_beside(row.body));
  if (!joints["sha256"].is_null()) key["inputs"]["joints"] = joints;
  for (const fs::path& file : row.fabric_files) {
    key["inputs"]["fabrics"].push_back(input_of(file));
  }
  key["edge_length"] = row.edge_length;
  key["fabric"] = row.fabric_text.empty() ? "default" : valid_utf8(row.fabric_text);
  key["options"] = valid_utf8(row.options_text);
  key["limits"] = limits_json(limits_);
  return key;
}

std::optional<Json> kept_report(const GarmentFiles& files, const Json& key, bool pictures) {
  std::error_code unreachable;
  if (!fs::is_regular_file(files.report, unreachable)) return std::nullopt;
  try {
    Json report = parse_json(read_file(files.report), files.report.string());
    check_outcome(JsonValue(report, files.report.string()));
    const bool is_error = report.at("verdict") == error_verdict;
    for (const auto& [name, value] : key.items()) {
      if (name == "limits" && !is_error) continue;
      if (report.at(name) != value) return std::nullopt;
    }
    if (is_error) return report;
    const Json& checksums = report.at("outputs");
    for (const fs::path& file : files.made(pictures)) {
      if (checksums.at(file.filename().string()) != sha256_of_file(file)) return std::nullopt;
    }
    return report;
  } catch (const Json::exception&) {
    return std::nullopt;  // not ours
  } catch (const Error&) {
    return std::nullopt;
  }
}

Json write_report(const GarmentFiles& files, const Json& key, const Json& outcome) {
  Json report = key;
  report.update(outcome);
  write_file(files.report, report.dump(1) + "\n");
  return report;
}

}  // namespace toile
