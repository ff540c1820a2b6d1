// How a point of measure is taken on the flat panels, as a line of text.
#pragma once

#include <string>
#include <vector>

#include "pattern/measure/sewn_panels.h"

namespace toile {

/// "front.3"; a panel's name with blanks or quotes in it stands in double quotes.
std::string rule_text(const Pattern& pattern, const EdgeRef& edge);
/// "front.3:start", "front.3:end" or "front.3:0.25".
std::string rule_text(const Pattern& pattern, const EdgePoint& point);
/// "along front.3 back.1"
std::string rule_along(const Pattern& pattern, const std::vector<EdgeRef>& edges);

/// Metres, by a rule:
///
/// - `along EDGE…`: the edges' lengths, added up;
/// - `between POINT POINT`: straight, of two points of one panel;
/// - `drop POINT POINT`: how much lower the second point of a panel lies than the first;
/// - `level POINT POINT`: how far apart two points of a panel lie square to that;
/// - `down POINT`: straight down to the end of the cloth, over seams;
/// - `around POINT`: level, until the line closes or the cloth ends. A length may follow, as in
///   `around front.2:end 2.5cm below`: the point lies that much lower then.
///
/// `half` before a rule halves it, as for a garment that lies flat, and `twice` doubles it.
/// Throws Error, whose place is the rule, for a text that is none. The same goes for a panel or an
/// edge that the pattern does not have.
double measure_by_rule(const SewnPanels& panels, const std::string& rule);

}  // namespace toile
