// What hurts, in a fitter's words: the lines at the head of terminal, report and page.
#pragma once

#include <string>
#include <vector>

#include "tools/ease_map/report.h"

namespace toile {

/// Pa: a larger pressure over load_patch is told. It is the most that is cited for daily wear. Of
/// four garments that are too small, all press harder than half of it. Two press harder than it,
/// and none harder than double.
inline constexpr double hard_pressure = 2000;

/// A line of what hurts.
struct Finding {
  double size = 0;      ///< metres
  std::string text;     ///< without capital and full stop
  std::string level{};  ///< the girth or edge that it is about; empty: none, or one of each side
};

/// At most eight lines, the most centimetres first. Each has its number and that number's error;
/// what is within its error has no line.
/// - Levels that are cut too small, and levels off their target.
/// - Edges that left the place where they were drafted to lie.
/// - Necklines, armholes and top edges that stand off the skin.
/// - Left and right, where girths, edges or lengths differ.
std::vector<Finding> findings_of(const EaseReport& report);

/// Their texts.
std::vector<std::string> finding_texts(const EaseReport& report);

}  // namespace toile
