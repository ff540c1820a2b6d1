// A piece in straight chords: unfolded, mirrored, without its seam allowance.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pattern/import/piece.h"

namespace toile {

/// What a piece looks like. Metres, y up.
struct PieceShape {
  std::vector<Vec2> outline;     ///< a simple polygon, counter-clockwise
  std::vector<Vec2> corners;     ///< declared ones, near the outline
  bool has_all_corners = false;  ///< as Piece has it
  std::vector<PieceNotch> notches;
  std::vector<std::vector<Vec2>> internal_lines;
  std::vector<std::vector<Vec2>> cut_outs;  ///< closed, the first point not repeated
  std::vector<Vec2> drill_holes;
  std::optional<PieceLine> grain;
  std::optional<PieceLine> fold;  ///< where it is a half
};

/// The shape of a piece. Its chords leave the piece's curves by at most `tolerance` metres.
///
/// What plain_outline() takes off is a notch, a cut-out or an internal line, with a remark.
///
/// Throws Error with the place `place` for an outline without area, and for one that crosses itself
/// nevertheless.
PieceShape shape_of(const Piece& piece, const std::string& place, double tolerance,
                    std::vector<Remark>& remarks);

/// The shape turned about the origin by `angle` radians, counter-clockwise. An angle of 0 changes
/// nothing.
PieceShape turned_shape(const PieceShape& shape, double angle);

/// The shape as seen from behind: mirrored left to right.
PieceShape mirrored_shape(const PieceShape& shape);

/// The whole of a half piece that lies on one side of the line `fold`, one part of its outline on
/// it. Nothing, and a warning, where the piece lies on both sides: it is whole already. Ends of
/// the fold are no longer declared corners.
///
/// Throws Error with the place `place` when the outline does not run along the fold, or meets it in
/// two places.
std::optional<PieceShape> unfolded_shape(const PieceShape& half, const PieceLine& fold,
                                         const std::string& place, std::vector<Remark>& remarks);

/// The shape with `allowance` metres taken off all around. Corners stay corners, declared ones
/// where they were declared; notches stay on the cut line. Throws Error with the place `place` when
/// nothing or more than one piece is left.
PieceShape without_allowance(const PieceShape& shape, double allowance, const std::string& place);

/// The point of a closed outline that is nearest to `point`: on segment `segment`, from its start
/// to the next point. `distance` is metres.
struct OutlinePlace {
  std::size_t segment = 0;
  Vec2 at = Vec2::Zero();
  double distance = 0;
};
OutlinePlace nearest_place(const std::vector<Vec2>& outline, const Vec2& point);

/// The points of the outline at which corners are declared, by their index. A declaration farther
/// than 1 mm from all of them is one of another line.
std::vector<std::size_t> declared_points(const PieceShape& shape);

}  // namespace toile
