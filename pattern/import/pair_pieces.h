// Which pieces are cut as a left and a right one.
#pragma once

#include "pattern/import/piece.h"

namespace toile {

enum class CutAs {
  one,    ///< as drawn, maybe several times
  pair,   ///< as drawn and mirrored
  layers  ///< as one that lies across the middle in two layers
};

/// How a piece is cut. The drawing says how often; whether half of them are mirrored, AAMA has no
/// words for, and ASTM and labels do not always say. So shapes tell it:
///
/// - What the drawing says to be mirrored is a pair.
/// - A piece that is cut 2, 4, ... times is a pair, as bodies are. It is none where the drawing
///   says that none is mirrored, unless it is its own mirror image: then mirrored or not is one.
///   One whose name has a side is none.
/// - A pair that is its own mirror image is two layers if it is a collar, a yoke or a hood. Its
///   name or its category says so. Sleeves and cuffs are one for each arm.
///
/// Curves are taken in chords within `chord_error` metres. O(n^2) of them.
CutAs cut_as(const Piece& piece, double chord_error);

}  // namespace toile
