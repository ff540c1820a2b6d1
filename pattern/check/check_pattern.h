// Checks a pattern before any of it is meshed.
#pragma once

#include <vector>

#include "pattern/pattern.h"

namespace toile {

/// Checks each panel's outline and each stitch.
///
/// Adds to `remarks` seams whose sides differ in length and are not declared gathered. Seams that
/// meet end to end share one remark. Adds gathers whose drawn fullness is not the declared one.
///
/// Throws Error, naming panel and edge, for an edge that ends where it starts. Throws it for an
/// edge in two stitches that are not layered, or one that is sewn to itself. Throws it for an
/// outline that crosses or touches itself, as outline_polygon() draws it.
void check_pattern(const Pattern& pattern, std::vector<Remark>& remarks);

/// Adds a warning for each panel whose outline check_pattern() would refuse. It is for programs
/// that read or write patterns and don't mesh them. What the garment is sewn without is not looked
/// at.
void warn_of_outlines(const Pattern& pattern, std::vector<Remark>& remarks);

}  // namespace toile
