// A pattern as a sheet to cut from: its panels at scale, with names, grain, notches and seams.
#pragma once

#include <vector>

#include "io/sheet.h"
#include "pattern/pattern.h"

namespace toile {

struct PatternSheetOptions {
  double seam_allowance = 0;  ///< metres around each panel; 0: none is drawn
};

/// Lays the panels out in rows of 1.5 m, the width of cloth, 20 mm apart, upright as drawn.
///
/// Each panel has its seam line, in SVG of the class `fabric` or its material's, in DXF on
/// layer 14. It has its grain arrow (7), notches (4), internal lines (8), cut-outs (11), drill
/// holes (13) and texts (15). Layer 1 is the line to cut along: it is the seam line where no
/// allowance is drawn. Points of layer 2 are the ends of edges.
///
/// Both sides of a seam bear its number, counted from 1 as the file lists the stitches. The name of
/// the panel that is sewn there follows where the edge is long enough for it. Panels that are left
/// out are drawn, too, and say so.
Sheet pattern_sheet(const Pattern& pattern, const PatternSheetOptions& options);

}  // namespace toile
