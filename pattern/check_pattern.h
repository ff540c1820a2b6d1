// What can be wrong with a pattern before any of it is meshed.
#pragma once

#include <vector>

#include "pattern/pattern.h"

namespace toile {

/// A seam whose sides differ by more than this share of the shorter one is worth a note...
inline constexpr double seam_note_ratio = 0.02;
/// ...and by more than this a warning: it is gathered, or a mistake.
inline constexpr double seam_warning_ratio = 0.20;
/// A gather's declared fullness may be off the drawn one by this share.
inline constexpr double fullness_tolerance = 0.05;
/// An edge shorter than this (metres) is a drawing error, not cloth.
inline constexpr double shortest_edge = 1e-4;

/// Checks each panel's outline and each stitch. Remarks, one for each run of seams that meet end to
/// end, on seams whose sides differ in length and that aren't declared gathered, and on gathers
/// that are drawn otherwise than declared.
/// Throws Error, naming panel and edge, for an edge of zero length, an outline that crosses or
/// touches itself (curves followed to within a sixteenth of their turning), an edge in two stitches
/// or sewn to itself.
void check_pattern(const Pattern& pattern, std::vector<Remark>& remarks);

}  // namespace toile
