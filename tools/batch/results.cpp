#include "tools/batch/results.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cloth/judge/verdict.h"
#include "io/csv.h"
#include "io/text.h"
#include "tools/batch/outcome.h"
#include "tools/program.h"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

/// A value as a field: nothing for what is absent.
std::string field_of(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return valid_utf8(value.get<std::string>());
  if (value.is_number_float()) {
    std::string text;
    append_number(text, value.get<double>());
    return text;
  }
  return value.dump();
}

Json value_of(const Json& object, const std::string& key) {
  const auto found = object.find(key);
  return found == object.end() ? Json() : *found;
}

std::string field_of(const BatchRow& row, const Json& report, const std::string& column) {
  if (column == "pattern") return valid_utf8(row.pattern_text);
  if (column == "body") return valid_utf8(row.body_text);
  if (column == "pattern_sha256") return field_of(report["inputs"]["pattern"]["sha256"]);
  if (column == "body_sha256") return field_of(report["inputs"]["body"]["sha256"]);
  if (column == "dressed_sha256")
    return field_of(value_of(value_of(report, "outputs"), "dressed.obj"));
  if (column == "warnings") {
    std::string text;
    for (const Json& warning : report["warnings"]) {
      text += (text.empty() ? "" : " | ") + field_of(warning["text"]);
    }
    return text;
  }
  const Json figure = value_of(report["figures"], column);
  return field_of(figure.is_null() ? value_of(report, column) : figure);
}

std::string share(std::size_t count, std::size_t all) {
  return fixed_number(100 * static_cast<double>(count) / static_cast<double>(all), 1) + " %";
}

/// Text in a cell of a table in Markdown.
std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : valid_utf8(text)) {
    if (c == '|' || c == '\\' || c == '<' || c == '*' || c == '_' || c == '`') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

/// Of sorted values, the smallest that the share of all does not exceed.
double quantile(const std::vector<double>& sorted, double of_all) {
  const double rank = std::ceil(of_all * static_cast<double>(sorted.size()));
  return sorted[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

void add_times(std::ostream& text, const char* what, std::vector<double> seconds) {
  if (seconds.empty()) return;
  std::ranges::sort(seconds);
  text << "| " << what << " | " << fixed_number(quantile(seconds, 0.5), 1) << " | "
       << fixed_number(quantile(seconds, 0.9), 1) << " | "
       << fixed_number(quantile(seconds, 0.99), 1) << " | " << fixed_number(seconds.back(), 1)
       << " |\n";
}

}  // namespace

std::string results_csv(const Batch& batch, const RowReports& reports) {
  std::vector<std::string> header = result_columns();
  header.insert(header.end(), batch.other_columns.begin(), batch.other_columns.end());
  std::string table = csv_line(header);
  for (std::size_t i = 0; i < batch.rows.size(); ++i) {
    if (reports[i].is_null()) continue;
    const BatchRow& row = batch.rows[i];
    std::vector<std::string> fields;
    for (const std::string& column : result_columns()) {
      fields.push_back(field_of(row, reports[i], column));
    }
    fields.insert(fields.end(), row.others.begin(), row.others.end());
    table += csv_line(fields);
  }
  return table;
}

std::string summary_of(const RowReports& reports) {
  std::map<std::string, std::size_t> counts;
  std::map<std::pair<std::string, std::string>, std::size_t> causes;
  std::vector<double> dressing, whole;
  std::size_t first_attempts = 0, dressed = 0, sewn = 0, too_small = 0;
  for (const Json& report : reports) {
    const auto verdict = report["verdict"].get<std::string>();
    ++counts[verdict];
    if (verdict != to_string(Verdict::sewn)) {
      ++causes[{verdict, report["cause"].get<std::string>()}];
    }
    whole.push_back(report["seconds"].get<double>());
    if (const Json attempts = value_of(report["figures"], "attempts"); !attempts.is_null()) {
      ++dressed;
      if (verdict == to_string(Verdict::sewn)) {
        ++sewn;
        too_small += report["figures"]["fit"] == "too_small" ? 1 : 0;
      }
      first_attempts += attempts.get<int>() <= 1 ? 1 : 0;
      dressing.push_back(report["mesh_seconds"].get<double>() +
                         report["dress_seconds"].get<double>());
    }
  }
  std::ostringstream text;
  text << "| verdict | garments | share |\n|---|---|---|\n";
  for (const std::string& verdict : verdicts_in_order()) {
    if (counts[verdict] == 0 && verdict != to_string(Verdict::sewn)) continue;
    text << "| `" << verdict << "` | " << counts[verdict] << " | "
         << share(counts[verdict], reports.size()) << " |\n";
  }
  text << "| all | " << reports.size() << " | |\n";
  if (!causes.empty()) {
    std::vector<std::pair<std::pair<std::string, std::string>, std::size_t>> sorted(causes.begin(),
                                                                                    causes.end());
    std::ranges::stable_sort(sorted, std::greater<>(),
                             [](const auto& cause) { return cause.second; });
    text << "\n| not sewn | cause | garments | share |\n|---|---|---|---|\n";
    for (const auto& [cause, count] : sorted) {
      text << "| `" << cause.first << "` | " << cell(cause.second) << " | " << count << " | "
           << share(count, reports.size()) << " |\n";
    }
  }
  text << "\n| seconds | median | 90 % | 99 % | largest |\n|---|---|---|---|---|\n";
  add_times(text, "to mesh and dress, where that ended", dressing);
  add_times(text, "of all, with tables and pictures, or until the error", whole);
  if (too_small > 0) {
    text << "\nOf " << sewn << " sewn, " << too_small
         << " are cut smaller than the body at a level, and stretched.\n";
  }
  if (dressed > 0) {
    text << "\nDressed at the first attempt in every stage: " << first_attempts << " of " << dressed
         << " (" << share(first_attempts, dressed) << ").\n";
  }
  return text.str();
}

int exit_code_of(const RowReports& reports) {
  int code = exit_done;
  for (const Json& report : reports) {
    if (report["verdict"] == error_verdict) return exit_error;
    if (report["verdict"] != to_string(Verdict::sewn) || !report["body_usable"].get<bool>()) {
      code = exit_negative;
    }
  }
  return code;
}

}  // namespace toile
