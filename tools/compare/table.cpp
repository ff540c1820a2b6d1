#include "tools/compare/table.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/csv.h"
#include "io/text.h"
#include "tools/address.h"

namespace toile {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* comparison_head = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Sizes compared</title>
<style>
body { font: 15px/1.45 system-ui, sans-serif; margin: 1.5em; color: #26272b; background: #fbfbfa; }
h1 { font-size: 1.35rem; font-weight: 600; margin: 0 0 .6rem; }
p { max-width: 52rem; color: #6c6e76; }
table { border-collapse: collapse; margin-top: 1rem; }
th { font-weight: 500; color: #6c6e76; text-align: left; vertical-align: bottom; padding: .3rem .7rem; }
thead th { border-bottom: 1px solid #26272b; }
tbody th { color: #26272b; vertical-align: top; max-width: 14rem; overflow-wrap: break-word; }
tbody tr { border-bottom: 1px solid #dcdcd8; }
td { vertical-align: top; padding: .3rem .7rem; max-width: 17rem; overflow-wrap: break-word; }
td div { border-left: 4px solid #b5541c; padding: .1rem 0 .1rem .55rem; margin-bottom: .3rem; }
td div.well { border-color: #3a7d44; }
td div.too_small, td div.too_tight { border-color: #c9a227; }
td div.error { border-color: #8a1c1c; }
td div.best { background: #e4f0e6; border-left-width: 8px; }
small { display: block; color: #6c6e76; }
b { font-weight: 600; }
</style>
</head>
<body>
)";

std::string or_dash(const std::string& text) { return text.empty() ? "\xE2\x80\x93" : text; }

std::string in_cm(double metres) { return fixed_number(100 * metres, 1); }

/// The verdict, and what of fit speaks against it.
std::string verdict_words(const ComparedRun& run) {
  std::string words = run.verdict.empty() ? "no verdict" : run.verdict;
  if (run.fit == "too_small" || run.fit == "too_wide") words += ", " + run.fit;
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string kind_of_cell(const ComparedRun& run, bool is_best) {
  if (is_best) return "well best";
  if (run.verdict == "sewn")
    return run.fit == "too_small" ? run.fit : run.why.empty() ? "well" : "";
  return run.verdict;
}

void add_run(std::ostream& page, const ComparedRun& run, bool is_best, const fs::path& folder) {
  page << "<div class=\"" << html_escaped(kind_of_cell(run, is_best)) << "\">";
  const std::string words = "<b>" + html_escaped(verdict_words(run)) + "</b>";
  if (run.page.empty()) {
    page << words;
  } else {
    const fs::path file = fs::absolute(run.page).lexically_normal();
    const fs::path from = file.lexically_relative(fs::absolute(folder).lexically_normal());
    page << "<a href=\"" << page_address(from.empty() ? file : from) << "\">" << words << "</a>";
  }
  if (is_best) page << " \xE2\x80\x93 best";
  if (const LevelEase* tightest = run.tightest()) {
    page << "<br>" << html_escaped(text_of(*tightest));
  }
  if (const TargetFinding* off = run.farthest_off()) {
    page << "<small>" << html_escaped(run.target) << ": " << html_escaped(text_of(*off))
         << "</small>";
  }
  if (!run.why.empty()) page << "<small>" << html_escaped(run.why) << "</small>";
  page << "</div>";
}

std::string name_of_row(const ComparedRow& row) {
  std::string name = row.garment.empty() ? "garment" : row.garment;
  if (!row.body.empty()) name += " on " + row.body;
  if (!row.fabric.empty()) name += " in " + row.fabric;
  return name;
}

std::string size_of_best(const Comparison& comparison, const ComparedRow& row) {
  if (!row.best) return "none";
  const ComparedRun& run = comparison.runs[*row.best];
  return run.size.empty() ? "not stated (" + run.report.filename().string() + ")" : run.size;
}

}  // namespace

std::string comparison_page(const Comparison& comparison, const fs::path& page_file) {
  const fs::path folder = page_file.parent_path().empty() ? "." : page_file.parent_path();
  std::ostringstream page;
  page << comparison_head << "<h1>Sizes compared: " << comparison.runs.size()
       << (comparison.runs.size() == 1 ? " run" : " runs") << "</h1>\n<p>" << best_size_rule
       << "</p>\n<p>Each cell has the verdict, the worst ease as cut with its error, and its level."
          " The verdict leads to the ease map.</p>\n<table>\n<thead><tr><th>garment</th>"
          "<th>body</th><th>fabric</th>";
  for (const std::string& size : comparison.sizes) {
    page << "<th>" << html_escaped(size.empty() ? "no size stated" : "size " + size) << "</th>";
  }
  page << "<th>best size</th></tr></thead>\n<tbody>\n";
  for (const ComparedRow& row : comparison.rows) {
    page << "<tr><th>" << html_escaped(or_dash(row.garment)) << "</th><th>"
         << html_escaped(or_dash(row.body)) << "</th><th>" << html_escaped(or_dash(row.fabric))
         << "</th>";
    for (const std::string& size : comparison.sizes) {
      page << "<td>";
      for (const std::size_t i : row.runs) {
        if (comparison.runs[i].size == size) {
          add_run(page, comparison.runs[i], row.best == i, folder);
        }
      }
      page << "</td>";
    }
    page << "<td><b>" << html_escaped(size_of_best(comparison, row)) << "</b><small>"
         << html_escaped(row.why) << "</small></td></tr>\n";
  }
  page << "</tbody>\n</table>\n</body>\n</html>\n";
  return page.str();
}

std::string comparison_csv(const Comparison& comparison) {
  std::string table = csv_line({"garment", "body", "fabric", "size", "verdict", "fit",
                                "worst_level", "worst_ease_cm", "plus_minus_ease_cm", "target",
                                "off_level", "off_cm", "best", "why", "page", "report"});
  for (const ComparedRow& row : comparison.rows) {
    for (const std::size_t i : row.runs) {
      const ComparedRun& run = comparison.runs[i];
      const LevelEase* tightest = run.tightest();
      const TargetFinding* off = run.farthest_off();
      std::vector<std::string> fields = {row.garment, row.body,    row.fabric,
                                         run.size,    run.verdict, run.fit};
      if (tightest == nullptr) {
        fields.insert(fields.end(), 3, "");
      } else {
        fields.insert(fields.end(),
                      {tightest->level, in_cm(tightest->ease), in_cm(tightest->error)});
      }
      if (off == nullptr) {
        fields.insert(fields.end(), 3, "");
      } else {
        fields.insert(fields.end(), {run.target, off->level, in_cm(off->off())});
      }
      fields.insert(fields.end(),
                    {row.best == i ? "yes" : "", run.why, run.page.string(), run.report.string()});
      for (std::string& field : fields) field = valid_utf8(field);
      table += csv_line(fields);
    }
  }
  return table;
}

nlohmann::ordered_json comparison_json(const Comparison& comparison) {
  Json json = {{"rule", best_size_rule}, {"runs", Json::array()}, {"best", Json::array()}};
  const auto told = [](const std::string& text, const char* key, Json& object) {
    if (!text.empty()) object[key] = valid_utf8(text);
  };
  for (const ComparedRow& row : comparison.rows) {
    for (const std::size_t i : row.runs) {
      const ComparedRun& run = comparison.runs[i];
      Json one = {{"report", valid_utf8(run.report.string())}};
      told(run.page.string(), "page", one);
      told(run.garment, "garment", one);
      told(run.size, "size", one);
      told(run.body, "body", one);
      told(run.fabric, "fabric", one);
      told(run.verdict, "verdict", one);
      told(run.fit, "fit", one);
      told(run.why, "why", one);
      if (const LevelEase* tightest = run.tightest()) {
        one["worst"] = {{"level", tightest->level},
                        {"ease_cm", 100 * tightest->ease},
                        {"plus_minus_ease_cm", 100 * tightest->error}};
      }
      if (const TargetFinding* off = run.farthest_off()) {
        one["target"] = {{"name", valid_utf8(run.target)},
                         {"level", off->level},
                         {"off_cm", 100 * off->off()},
                         {"plus_minus_ease_cm", 100 * off->error}};
      }
      one["is_best"] = row.best == i;
      json["runs"].push_back(std::move(one));
    }
    Json best = {{"why", row.why}};
    told(row.garment, "garment", best);
    told(row.body, "body", best);
    told(row.fabric, "fabric", best);
    if (row.best) {
      told(comparison.runs[*row.best].size, "size", best);
      told(comparison.runs[*row.best].report.string(), "report", best);
    }
    json["best"].push_back(std::move(best));
  }
  return json;
}

std::vector<std::string> comparison_lines(const Comparison& comparison) {
  std::vector<std::string> lines;
  lines.reserve(comparison.rows.size());
  for (const ComparedRow& row : comparison.rows) {
    lines.push_back(valid_utf8(name_of_row(row)) + ": best size " +
                    valid_utf8(size_of_best(comparison, row)) + ", " + row.why);
  }
  return lines;
}

}  // namespace toile
