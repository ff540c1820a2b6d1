// Drawings that show half of a garment or of a pair, and leave it to the reader.
#pragma once

#include "pattern/import/imported_pattern.h"

namespace toile {

/// What makes a whole garment of a drawing that shows less, and does not say so. A body is
/// symmetric, and so are its garments.
///
/// - It says of no piece how it is cut, and shows no whole front or back. Then a piece that looks
///   folded is half of one, see likely_fold(). Another one that is not its own mirror image is one
///   of a pair.
/// - It says so of some pieces. One alone is neither symmetric nor has a mirror image in the
///   drawing: that is one of a pair, too.
///
/// Pieces in `given.singles` stay as they are. Where `given` asks for a half or a pair, nothing is
/// guessed. Quadratic in the outlines' points.
ImportOptions whole_garment(const ImportedPattern& drawn, const ImportOptions& given);

}  // namespace toile
