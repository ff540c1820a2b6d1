// Pieces that are drawn as halves without a mark of their fold, and what the user says of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pattern/import/outline_edges.h"
#include "pattern/import/piece_shape.h"

namespace toile {

/// Whether the closed outline is its own mirror image, within 2 mm, about a line across `across`.
/// `across` is a unit vector.
bool is_mirror_image(const std::vector<Vec2>& outline, const Vec2& across);

/// Whether a piece of this name may lie across the middle of the body: a collar, its stand, a
/// yoke, the middle of a hood. Names are read as words_of() does.
bool lies_across_the_middle(const std::string& name);

/// The edge at which a piece looks folded: the longest one that is straight along the grain, with
/// all of the piece on one side. Nothing: there is none of 2 cm, or the piece is its own mirror
/// image and so whole. `outline` is what edges_of() makes of `shape`. O(n^2) of its points.
std::optional<int> likely_fold(const PieceShape& shape, const EdgedOutline& outline);

/// The line along one edge of an outline, to unfold the piece about.
///
/// Throws Error with the place `place` for an edge that is not there, and for a curved one.
PieceLine fold_along(const EdgedOutline& outline, int edge, const std::string& place);

/// A piece that the user names, and maybe one of its edges.
struct NamedPiece {
  std::size_t piece = 0;
  int edge = -1;  ///< -1: none is named
};

/// What "PIECE" or "PIECE:EDGE" names. `names` are the pieces' names, each one's own. A piece may
/// have a colon in its name.
///
/// Throws Error with the place `place` for a name that no piece has.
NamedPiece named_piece(const std::string& text, const std::vector<std::string>& names,
                       const std::string& place);

/// A word as a shell takes it: in quotes where it has to be.
std::string shell_word(const std::string& word);

}  // namespace toile
