// Checks a pattern before any of it is meshed.
#pragma once

#include <vector>

#include "pattern/pattern.h"

namespace toile {

/// A seam whose sides differ by more than this share of the shorter one is worth a note...
inline constexpr double seam_note_ratio = 0.02;
/// ...and by more than this a warning: it is gathered, or a mistake.
inline constexpr double seam_warning_ratio = 0.20;
/// A declared fullness may differ from the drawn one by this share.
inline constexpr double fullness_tolerance = 0.05;
/// Metres: a shorter edge is a drawing error, not cloth.
inline constexpr double shortest_edge = 1e-4;

/// Checks each panel's outline and each stitch.
///
/// Adds to `remarks` seams whose sides differ in length and are not declared gathered. Seams that
/// meet end to end share one remark. Adds gathers whose drawn fullness is not the declared one.
///
/// Throws Error, naming panel and edge, for an edge of zero length, an edge in two stitches, or one
/// that is sewn to itself. Throws it for an outline that crosses or touches itself. Curves are
/// followed by 16 chords and more, one for each 6 degrees of turning.
void check_pattern(const Pattern& pattern, std::vector<Remark>& remarks);

}  // namespace toile
