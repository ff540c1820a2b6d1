// Drawings of half a garment, whose makers left it to the reader.
#pragma once

#include "pattern/import/imported_pattern.h"

namespace toile {

/// What makes a whole garment of a drawing that shows half of one, and does not say so. Empty: it
/// says of some piece how it is cut, or shows a whole garment.
///
/// A body is symmetric, and so are its garments. So a piece that looks folded is half of one, see
/// likely_fold(). Another piece that is not its own mirror image is one of a pair. Pieces in
/// `given.singles` stay as they are. Where `given` asks for a half or a pair, nothing is guessed.
/// Quadratic in the outlines' points.
ImportOptions whole_garment(const ImportedPattern& drawn, const ImportOptions& given);

}  // namespace toile
