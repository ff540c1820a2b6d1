#include "pattern/import/pair_pieces.h"

#include <algorithm>
#include <vector>

#include "pattern/classify/panel_name.h"
#include "pattern/import/half_pieces.h"
#include "pattern/import/join_paths.h"
#include "pattern/import/piece_shape.h"

namespace toile {

namespace {

/// Whether a piece is its own mirror image, along the grain or the drawing, or across.
bool is_own_mirror_image(const Piece& piece, double chord_error) {
  if (piece.fold) return true;
  std::vector<Vec2> directions = {Vec2::UnitX(), Vec2::UnitY()};
  if (piece.grain && (piece.grain->to - piece.grain->from).norm() > 0) {
    const Vec2 warp = (piece.grain->to - piece.grain->from).normalized();
    directions.insert(directions.end(), {warp, Vec2(-warp.y(), warp.x())});
  }
  const std::vector<Vec2> outline = loop_points(piece.outline, chord_error);
  return outline.size() > 2 &&
         std::any_of(directions.begin(), directions.end(),
                     [&](const Vec2& across) { return is_mirror_image(outline, across); });
}

}  // namespace

CutAs cut_as(const Piece& piece, double chord_error) {
  if (piece.is_panel) return CutAs::one;
  bool pair = piece.pair;
  if (!pair && piece.quantity % 2 == 0 && read_panel_name(piece.name).side == 0) {
    pair = !piece.none_mirrored || is_own_mirror_image(piece, chord_error);
  }
  if (!pair) return CutAs::one;
  const bool middle = lies_across_the_middle(piece.name) || lies_across_the_middle(piece.category);
  return middle && is_own_mirror_image(piece, chord_error) ? CutAs::layers : CutAs::pair;
}

}  // namespace toile
