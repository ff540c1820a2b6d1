#include "tools/compare/compared_run.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "cloth/ease/figure_errors.h"
#include "cloth/judge/verdict.h"
#include "geometry/error.h"
#include "io/csv.h"
#include "io/json_value.h"
#include "io/output_file.h"
#include "io/text.h"
#include "tools/batch/files.h"
#include "tools/batch/outcome.h"
#include "tools/fit/chain.h"
#include "tools/report.h"

namespace toile {

namespace {

namespace fs = std::filesystem;

constexpr const char* not_ours = "give the folder of a toile fit, try or batch, or its ease.json";

JsonDocument document_of(const fs::path& file) { return {read_file(file), file.string()}; }

bool is_file(const fs::path& file) {
  std::error_code unreachable;
  return fs::is_regular_file(file, unreachable);
}

std::string text_at(const JsonValue& value, const char* key) {
  const auto found = value.find(key);
  return found ? found->text() : "";
}

std::string name_in(const std::string& path) { return fs::path(path).stem().string(); }

double metres_at(const JsonValue& value, const char* key) { return value.get(key).number() / 100; }

/// A skirt's girth around both legs has the name of a limb without its side.
bool is_of_both_legs(const std::string& level) {
  return level.find("thigh") != std::string::npos || level == "knee" || level == "calf" ||
                 level == "ankle"
             ? !level.starts_with("left ") && !level.starts_with("right ")
             : false;
}

/// As GarmentLevel::compared(): a top edge counts where it lacks the least.
std::optional<LevelEase> edge_ease(const JsonValue& edge) {
  LevelEase ease{edge.get("name").text()};
  ease.tells_size = ease.level != "neckline";
  const auto drafted = edge.find("drafted_ease_cm");
  const auto at_rest = edge.find("as_cut_ease_cm");
  if (!drafted && !at_rest) return std::nullopt;
  const bool rests_easier =
      ease.level == "top edge" && drafted && at_rest && at_rest->number() > drafted->number();
  if (drafted && !rests_easier) {
    ease.ease = drafted->number() / 100;
    ease.error = metres_at(edge, "plus_minus_drafted_ease_cm");
  } else {
    ease.ease = at_rest->number() / 100;
    ease.error = edge_as_cut_error;
  }
  return ease;
}

void read_eases(const JsonValue& report, ComparedRun& run) {
  if (const auto girths = report.find("girths")) {
    for (std::size_t i = 0; i < girths->size(); ++i) {
      const JsonValue girth = girths->item(i);
      const std::string level = text_at(girth, "level");
      if (level.empty() || girth.find("no_girth")) continue;
      run.levels.push_back({level, metres_at(girth, "as_cut_ease_cm"),
                            metres_at(girth, "plus_minus_as_cut_cm"), !is_of_both_legs(level)});
    }
  }
  if (const auto edges = report.find("garment_levels")) {
    for (std::size_t i = 0; i < edges->size(); ++i) {
      if (const auto ease = edge_ease(edges->item(i))) run.levels.push_back(*ease);
    }
  }
  const auto target = report.find("target");
  if (!target) return;
  run.target = target->get("name").text();
  const JsonValue levels = target->get("levels");
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const JsonValue level = levels.item(i);
    const std::string name = level.get("level").text();
    run.targets.push_back({name,
                           metres_at(level, "ease_cm"),
                           metres_at(level, "plus_minus_ease_cm"),
                           {name, metres_at(level, "least_cm"), metres_at(level, "most_cm")}});
  }
}

/// The names of the fabrics that panels are cut from.
std::string fabrics_in(const JsonValue& scene) {
  const auto fabrics = scene.find("fabrics");
  if (!fabrics) return text_at(scene, "fabric");
  std::set<std::string> seen;
  std::string names;
  for (std::size_t i = 0; i < fabrics->size(); ++i) {
    const std::string name = fabrics->item(i).get("quantities").get("name").text();
    if (seen.insert(name).second) names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

void add_reason(const std::string& reason, ComparedRun& run) {
  if (!reason.empty()) run.why += (run.why.empty() ? "" : "; ") + reason;
}

void read_dressing(const fs::path& file, ComparedRun& run) {
  const std::string text = read_file(file);
  const JsonDocument document(text, file.string());
  const JsonValue report = document.root();
  run.verdict = report.get("verdict").text();
  run.fit = report.get("fit").get("verdict").text();
  if (const auto scene = report.find("scene")) run.fabric = fabrics_in(*scene);
  if (const auto inputs = report.find("inputs")) {
    run.body = name_in(text_at(*inputs, "body"));
    run.garment = name_in(text_at(*inputs, "garment"));
  }
  if (run.verdict != to_string(Verdict::sewn)) {
    const std::string cause = JsonValue(outcome_of(text, file.string()), "").get("cause").text();
    add_reason(cause.empty() ? run.verdict : cause, run);
  }
  for (const Warning& warning : read_warnings(report)) {
    if (warning.code == "out_of_spec") add_reason(warning.text, run);
  }
}

/// The ease map; it repeats verdict and fit, which with a target may be too_wide.
void read_ease(const fs::path& file, ComparedRun& run) {
  const JsonDocument report = document_of(file);
  read_eases(report.root(), run);
  if (const auto fit = report.root().find("fit")) run.fit = fit->get("verdict").text();
  if (run.verdict.empty()) {
    run.verdict = text_at(report.root(), "verdict");
    if (!run.verdict.empty() && run.verdict != to_string(Verdict::sewn)) {
      add_reason(run.verdict, run);
    }
  }
  if (run.body.empty()) run.body = name_in(text_at(report.root(), "body"));
  if (run.garment.empty()) run.garment = name_in(text_at(report.root(), "garment"));
}

/// What was given to the steps of a toile fit or try, as their reports name it.
void read_inputs(const FitFiles& files, ComparedRun& run) {
  if (is_file(files.body_report)) {
    const JsonDocument report = document_of(files.body_report);
    run.body = name_in(text_at(report.root().get("read"), "file"));
    const auto body = report.root().find("body");
    if (body && body->find("usable") && !body->get("usable").flag()) {
      add_reason("the body can't be relied on", run);
    }
  }
  if (is_file(files.mesh_report)) {
    run.garment = name_in(text_at(document_of(files.mesh_report).root(), "pattern"));
  }
  for (const fs::path& file : {files.folder / "import.json", files.points_report}) {
    if (!is_file(file)) continue;
    const JsonDocument report = document_of(file);
    const std::string size = text_at(report.root(), "size");
    if (run.size.empty()) run.size = size;
    const std::string drawing = text_at(report.root(), "drawing");
    if (!drawing.empty()) run.garment = name_in(drawing);
  }
  const fs::path tried = files.folder / "report.json";
  if (!is_file(tried)) return;
  const JsonDocument report = document_of(tried);
  run.body = name_in(text_at(report.root(), "body"));
  const JsonValue reasons = report.root().get("reason");
  for (std::size_t i = 0; i < reasons.size(); ++i) {
    std::string reason = reasons.item(i).text();
    if (reason == "verdict" || reason == "unreliable_body") continue;  // said already
    std::ranges::replace(reason, '_', ' ');
    add_reason(reason, run);
  }
  // Where panels were laid aside, the rest may be sewn. The garment is not.
  const std::string verdict = report.root().get("verdict").text();
  if (run.verdict == to_string(Verdict::sewn)) run.verdict = verdict;
}

/// Which step a run without a drape ended in.
std::string missing_step(const FitFiles& files) {
  if (is_file(files.mesh_report)) return "it ended while it was dressed";
  if (is_file(files.body_report)) return "it ended before the pattern was meshed";
  return "it ended before the body was cleaned";
}

/// Nothing: the folder holds no file that a toile fit or try writes.
std::optional<ComparedRun> read_fit(const fs::path& folder) {
  const FitFiles files(folder);
  std::vector<fs::path> any = files.all();
  any.push_back(folder / "import.json");
  if (std::ranges::none_of(any, is_file)) return std::nullopt;
  ComparedRun run;
  run.report = folder;
  if (is_file(files.report)) {
    read_dressing(files.report, run);
  } else if (!is_file(files.ease_report)) {
    run.verdict = error_verdict;
    add_reason(missing_step(files), run);
  }
  if (is_file(files.ease_report)) {
    read_ease(files.ease_report, run);
  } else if (run.verdict != error_verdict) {
    add_reason("there is no ease map", run);
  }
  read_inputs(files, run);
  if (is_file(files.ease)) run.page = files.ease;
  return run;
}

ComparedRun read_garment_of_batch(const fs::path& folder, const std::string& size) {
  const GarmentFiles files(folder);
  ComparedRun run;
  run.report = folder;
  run.size = size;
  const JsonDocument report = document_of(files.report);
  const JsonValue root = report.root();
  const bool is_error = root.get("verdict").text() == error_verdict;
  if (!is_error && is_file(files.dress_report)) read_dressing(files.dress_report, run);
  if (!is_error && is_file(files.ease_report)) read_ease(files.ease_report, run);
  run.verdict = root.get("verdict").text();
  if (is_error) add_reason(root.get("detail").text(), run);
  if (!is_error && !root.get("body_usable").flag()) add_reason("the body can't be relied on", run);
  run.garment = name_in(root.get("inputs").get("pattern").get("file").text());
  run.body = name_in(root.get("inputs").get("body").get("file").text());
  if (run.fabric.empty()) run.fabric = root.get("fabric").text();
  if (is_file(files.ease)) run.page = files.ease;
  return run;
}

/// A line of the table for each; a column `size` of the manifest is copied there.
std::vector<ComparedRun> read_batch(const fs::path& folder, const fs::path& table) {
  const std::vector<CsvRow> rows = parse_csv(read_file(table), table.string());
  if (rows.empty()) throw Error(table.string(), "is empty", "run toile batch again");
  const auto column = [&](const char* name) {
    return std::ranges::find(rows[0].fields, name) - rows[0].fields.begin();
  };
  const auto name = static_cast<std::size_t>(column("name"));
  const auto size = static_cast<std::size_t>(column("size"));
  std::vector<ComparedRun> runs;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::vector<std::string>& fields = rows[i].fields;
    if (name >= fields.size()) {
      throw Error(table.string(), "has no column 'name'", "run toile batch again");
    }
    runs.push_back(
        read_garment_of_batch(folder / fields[name], size < fields.size() ? fields[size] : ""));
  }
  return runs;
}

ComparedRun read_one_report(const fs::path& file) {
  const std::string program = text_at(document_of(file).root(), "program");
  ComparedRun run;
  run.report = file;
  const fs::path folder = file.parent_path();
  if (program == "dress") {
    read_dressing(file, run);
    if (is_file(folder / "ease.json")) read_ease(folder / "ease.json", run);
  } else if (program == "ease-map") {
    read_ease(file, run);
  } else {
    throw Error(file.string(), "is no report of dress or ease-map", not_ours);
  }
  // Those that lie in the folder of a toile fit are of its body and its pattern.
  const FitFiles files(folder.empty() ? "." : folder);
  if (same_file(file, files.report) || same_file(file, files.ease_report)) {
    if (program == "ease-map" && is_file(files.report)) {
      ComparedRun dressed;
      read_dressing(files.report, dressed);
      run.fabric = dressed.fabric;
    }
    read_inputs(files, run);
  }
  for (const fs::path& page : {fs::path(file).replace_extension("html"), files.ease}) {
    if (run.page.empty() && is_file(page)) run.page = page;
  }
  return run;
}

/// "38", "38W", "S", "XL", "2XL": a word that is a size.
bool is_size(const std::string& word) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t digits = 0;
  while (digits < word.size() && is_digit(word[digits])) ++digits;
  std::string letters = word.substr(digits);
  for (char& c : letters) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  if (digits > 3) return false;
  if (digits > 0 && letters.size() <= 1) return true;
  if (letters.empty() || letters.find_first_not_of('X') < letters.size() - 1) return false;
  return letters.back() == 'S' || letters.back() == 'L' || letters == "M";
}

/// "shirt_38" is size 38 of the shirt.
void split_size(ComparedRun& run) {
  const std::size_t cut = run.garment.find_last_of("_- .");
  const std::string last = cut == std::string::npos ? run.garment : run.garment.substr(cut + 1);
  if (run.size.empty() ? !is_size(last) : last != run.size) return;
  run.size = last;
  run.garment = cut == std::string::npos ? "" : run.garment.substr(0, cut);
}

}  // namespace

const LevelEase* ComparedRun::tightest() const {
  const LevelEase* least = nullptr;
  for (const LevelEase& level : levels) {
    if (level.tells_size && (least == nullptr || level.ease < least->ease)) least = &level;
  }
  return least;
}

const TargetFinding* ComparedRun::farthest_off() const {
  const auto most = std::ranges::max_element(
      targets, {}, [](const TargetFinding& finding) { return std::abs(finding.off()); });
  return most == targets.end() ? nullptr : &*most;
}

void set_target(const EaseTargets& targets, ComparedRun& run) {
  run.target = targets.name;
  run.targets.clear();
  for (const LevelEase& level : run.levels) {
    const EaseTarget* target = target_of(targets, level.level);
    if (target != nullptr) run.targets.push_back({level.level, level.ease, level.error, *target});
  }
}

std::vector<ComparedRun> read_runs(const fs::path& folder_or_file) {
  std::vector<ComparedRun> runs;
  std::error_code unreachable;
  if (!fs::exists(folder_or_file, unreachable)) {
    throw Error(folder_or_file.string(), "is not there", not_ours);
  }
  if (!fs::is_directory(folder_or_file, unreachable)) {
    runs.push_back(read_one_report(folder_or_file));
  } else if (const fs::path table = BatchFiles(folder_or_file).results; is_file(table)) {
    runs = read_batch(folder_or_file, table);
  } else if (auto fit = read_fit(folder_or_file)) {
    runs.push_back(*std::move(fit));
  } else {
    throw Error(folder_or_file.string(), "holds no report of a run", not_ours);
  }
  for (ComparedRun& run : runs) split_size(run);
  return runs;
}

}  // namespace toile
