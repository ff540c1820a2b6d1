#include "tools/ease_map/findings.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "cloth/ease/figure_errors.h"
#include "cloth/judge/drafted.h"
#include "io/text.h"
#include "pattern/classify/classify.h"

namespace toile {

namespace {

/// Lines at most; a fitter's eye takes in no more at once.
constexpr std::size_t most_lines = 8;

/// Metres off the skin: an upper edge that stands farther off gapes. Those of 8 samples and most of
/// 23 random garments lie within 2.6 cm, and 13 edges beyond 2.9. Half names edges of six samples,
/// double half of the 13.
constexpr double gape = 0.03;

std::string with_error(double value, double error) {
  return fixed_number(100 * std::abs(value), 1) + " \xC2\xB1 " + centimetres(error, 1);
}

void add_moved_edges(const EaseReport& report, const std::vector<FitLevel>& too_small,
                     std::vector<Finding>& findings) {
  for (const GarmentLevel& level : report.figures.levels) {
    // What is too small tells where it went itself.
    if (!left_its_place(level, level.height_error) ||
        std::ranges::find(too_small, level.name, &FitLevel::level) != too_small.end()) {
      continue;
    }
    const bool is_up = *level.risen() > 0;
    findings.push_back({std::abs(*level.risen()),
                        "the " + level.name + (is_up ? " rides up by " : " slid down by ") +
                            with_error(*level.risen(), level.height_error) +
                            " from where it was drafted to lie",
                        level.name});
  }
}

/// Whether an edge is meant to lie on the body. A hood's or a collar's is not.
bool lies_on_body(const EaseReport& report, const GarmentLevel& level) {
  if (level.name != "neckline") {
    return level.name == "top edge" || level.name.ends_with(" armhole");
  }
  return std::ranges::none_of(level.panels, [&](int panel) {
    return classify({report.garment.panels[static_cast<std::size_t>(panel)]}).is_headwear();
  });
}

void add_gaping_edges(const EaseReport& report, std::vector<Finding>& findings) {
  for (const GarmentLevel& level : report.figures.levels) {
    if (!lies_on_body(report, level)) continue;
    const int node = farthest_node(report.map, level.nodes);
    const double gap = report.map.node_gaps[node];
    if (gap < gape) continue;
    findings.push_back({gap,
                        "the " + level.name + " gapes: it stands " + centimetres(gap, 1) +
                            " off the skin at a height of " +
                            centimetres(report.garment.points[node].y(), 0),
                        level.name});
  }
}

/// A figure of one side that the other side has as well. Metres.
struct SidedFigure {
  std::string name;  ///< "left cuff"
  double value = 0;
  double error = 0;
  const char* verb = "";  ///< "is cut"
  const char* more = "";  ///< "longer": what the side is with the larger value
  const char* less = "";
};

/// The figures of girths, edges and lengths, those of one row behind each other.
std::vector<SidedFigure> sided_figures(const EaseReport& report) {
  std::vector<SidedFigure> figures;
  const auto cut = [&](const std::string& name, double as_cut) {
    figures.push_back({name, as_cut, edge_as_cut_error, "is cut", "longer", "shorter"});
  };
  for (const Girth& girth : report.figures.girths.rows) {
    if (!girth.is_girth()) continue;
    figures.push_back({girth.name, girth.ease(), girth.error, "has", "more ease", "less ease"});
  }
  for (const GarmentLevel& level : report.figures.levels) cut(level.name, level.as_cut);
  for (const GarmentLength& length : report.figures.lengths) {
    if (length.as_cut) cut(length.name, *length.as_cut);
    if (length.ends.empty()) continue;
    const EndsBeyond& end = length.ends.front();
    const bool is_height = end.place == "floor";
    figures.push_back({length.name, end.by, end.error, "ends", is_height ? "higher" : "farther out",
                       is_height ? "lower" : "farther in"});
  }
  return figures;
}

/// What left and right differ by, if that is more than its error: of a row the figure that is
/// farthest beyond it.
void add_sides(const EaseReport& report, std::vector<Finding>& findings) {
  const std::vector<SidedFigure> figures = sided_figures(report);
  std::string row;
  double most_beyond = 0;
  for (const SidedFigure& left : figures) {
    if (!left.name.starts_with("left ")) continue;
    const std::string part = left.name.substr(5);
    const auto right = std::ranges::find_if(figures, [&](const SidedFigure& figure) {
      return figure.name == "right " + part && std::string(figure.verb) == left.verb;
    });
    if (right == figures.end()) continue;
    const double differs = left.value - right->value;
    const double error = left.error + right->error;
    const bool is_told = left.name == row;
    if (!is_told) most_beyond = 0;
    if (std::abs(differs) - error <= most_beyond) continue;
    if (is_told) findings.pop_back();
    row = left.name;
    most_beyond = std::abs(differs) - error;
    findings.push_back({std::abs(differs),
                        "the left " + part + " " + left.verb + " " + with_error(differs, error) +
                            " " + (differs > 0 ? left.more : left.less) + " than the right"});
  }
}

/// Where it presses hardest, if that is hard.
std::optional<std::string> hard_place(const EaseReport& report) {
  const auto harder = [](const LoadRow& a, const LoadRow& b) {
    return a.pressure.largest < b.pressure.largest;
  };
  const auto panel = std::ranges::max_element(report.load_rows.panels, harder);
  if (panel == report.load_rows.panels.end() || panel->pressure.largest <= hard_pressure) return {};
  std::string text =
      valid_utf8(panel->name) + " presses with " + fixed_number(panel->pressure.largest / 1000, 1) +
      " \xC2\xB1 " + fixed_number(largest_pressure_error(panel->pressure.largest) / 1000, 1) +
      " kPa on " + fixed_number(1e4 * load_patch, 0) + " cm\xC2\xB2 at a height of " +
      centimetres(report.garment.points[panel->pressure.node].y(), 0);
  const auto level = std::ranges::find_if(report.load_rows.levels, [&](const LoadRow& row) {
    return !row.name.empty() && row.pressure.node == panel->pressure.node;
  });
  if (level != report.load_rows.levels.end()) text += ", the " + level->name;
  return text + ": more than " + fixed_number(hard_pressure / 1000, 1) + " kPa";
}

}  // namespace

std::vector<Finding> findings_of(const EaseReport& report) {
  std::vector<Finding> findings;
  const std::vector<FitLevel> too_small =
      fit_of(report.figures.girths.rows, report.figures.levels).levels;
  findings.reserve(too_small.size());
  for (const FitLevel& level : too_small) {
    findings.push_back({level.missing(), text_of(level), level.level});
  }
  add_moved_edges(report, too_small, findings);
  for (const TargetFinding& target : report.targets) {
    const auto is_told = [&](const FitLevel& level) { return level.level == target.level; };
    if (std::abs(target.off()) > target.error && std::ranges::none_of(too_small, is_told)) {
      findings.push_back({std::abs(target.off()), text_of(target), target.level});
    }
  }
  add_gaping_edges(report, findings);
  add_sides(report, findings);
  std::ranges::stable_sort(findings, std::ranges::greater{}, &Finding::size);
  // It has no centimetres to be ordered by.
  if (std::optional<std::string> hard = hard_place(report)) {
    if (findings.size() >= most_lines) findings.resize(most_lines - 1);
    findings.push_back({0, std::move(*hard)});
  }
  if (findings.size() > most_lines) findings.resize(most_lines);
  return findings;
}

std::vector<std::string> finding_texts(const EaseReport& report) {
  std::vector<std::string> texts;
  for (Finding& finding : findings_of(report)) texts.push_back(std::move(finding.text));
  return texts;
}

}  // namespace toile
