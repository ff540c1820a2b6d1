#include "cloth/ease/ease_targets.h"

#include <algorithm>
#include <cmath>

#include "cloth/ease/figure_errors.h"
#include "geometry/error.h"
#include "io/json_value.h"
#include "io/output_file.h"
#include "io/text.h"

namespace toile {

namespace {

constexpr double inch = 0.0254;

/// Metres: a larger ease than this is a slip of the unit.
constexpr double most_ease = 3;

std::vector<EaseTargets> tables() {
  const auto table = [](const char* name, double bust_from, double bust_to, double hip_from,
                        double hip_to) {
    return EaseTargets{name,
                       {{"bust", bust_from * inch, bust_to * inch},
                        {"hip", hip_from * inch, hip_to * inch},
                        {"top edge", 0, inch}}};
  };
  return {table("close", 0, 2.875, 0, 1.875), table("fitted", 3, 4, 2, 3),
          table("semi-fitted", 4.125, 5, 3.125, 4), table("loose", 5.125, 8, 4.125, 6)};
}

/// The name without "left " or "right ".
std::string without_side(const std::string& name) {
  for (const std::string side : {"left ", "right "}) {
    if (name.starts_with(side)) return name.substr(side.size());
  }
  return name;
}

EaseTargets read_file_of_targets(const std::string& file) {
  const JsonDocument document(read_file(file), file);
  const JsonValue root = document.root();
  EaseTargets targets;
  targets.name = root.get("name").text();
  const JsonValue levels = root.get("ease_cm");
  for (const std::string& level : levels.keys()) {
    const JsonValue range = levels.get(level.c_str());
    if (!range.is_array() || range.size() != 2) {
      throw Error(file, "'" + level + "' is no range", "write [least, most] in centimetres");
    }
    const EaseTarget target{level, range.item(0).number() / 100, range.item(1).number() / 100};
    if (!(target.least <= target.most) || std::abs(target.least) > most_ease ||
        std::abs(target.most) > most_ease) {
      throw Error(file, "'" + level + "' is no range of an ease",
                  "write [least, most] in centimetres, from less to more");
    }
    targets.levels.push_back(target);
  }
  return targets;
}

}  // namespace

std::vector<std::string> ease_target_names() {
  std::vector<std::string> names;
  for (const EaseTargets& table : tables()) names.push_back(table.name);
  return names;
}

EaseTargets read_ease_targets(const std::string& name_or_file) {
  for (EaseTargets& table : tables()) {
    if (table.name == name_or_file) return std::move(table);
  }
  if (!std::filesystem::exists(name_or_file)) {
    throw Error("--target", "'" + name_or_file + "' is neither a file nor a table",
                "give a JSON file, or one of close, fitted, semi-fitted, loose");
  }
  return read_file_of_targets(name_or_file);
}

const EaseTarget* target_of(const EaseTargets& targets, const std::string& level) {
  const auto found = std::ranges::find(targets.levels, without_side(level), &EaseTarget::level);
  return found == targets.levels.end() ? nullptr : &*found;
}

double TargetFinding::off() const {
  return std::min(0.0, ease - target.least) + std::max(0.0, ease - target.most);
}

std::string TargetFinding::word() const {
  if (off() == 0) return "as intended";
  if (off() < 0) return off() < -error ? "too tight" : "close";
  return off() > error ? "too wide" : "loose";
}

bool is_too_wide(const std::vector<TargetFinding>& findings) {
  const auto is = [&](const char* word) {
    return std::ranges::any_of(findings, [&](const auto& found) { return found.word() == word; });
  };
  return is("too wide") && !is("too tight");
}

std::vector<TargetFinding> compare_with_targets(const EaseTargets& targets,
                                                const std::vector<Girth>& girths,
                                                const std::vector<GarmentLevel>& levels) {
  std::vector<TargetFinding> findings;
  const auto compare = [&](const std::string& level, double ease, double error,
                           const std::vector<int>& panels) {
    const EaseTarget* target = target_of(targets, level);
    if (target != nullptr) findings.push_back({level, ease, error, *target, panels});
  };
  for (const Girth& girth : girths) {
    if (!girth.name.empty() && girth.is_girth()) {
      compare(girth.name, girth.ease_as_cut(), as_cut_error(girth.as_cut, girth.on_the_line),
              panels_of(girth));
    }
  }
  for (const GarmentLevel& level : levels) {
    if (const auto with = level.compared()) {
      compare(level.name, level.as_cut - with->body, with->error, level.panels);
    }
  }
  return findings;
}

std::string text_of(const TargetFinding& finding) {
  const auto cm = [](double metres) { return fixed_number(100 * metres, 1); };
  std::string text = finding.word();
  if (finding.off() != 0) {
    text += " by " + cm(std::abs(finding.off())) + " \xC2\xB1 " + cm(finding.error) + " cm";
  }
  return text + " at the " + finding.level + ": ease " + cm(finding.ease) + " cm, meant " +
         cm(finding.target.least) + " to " + cm(finding.target.most) + " cm";
}

}  // namespace toile
