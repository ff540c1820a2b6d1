// How the pieces of a drawing are turned, so that their warp stands upright.
#pragma once

#include <vector>

#include "pattern/import/piece_shape.h"

namespace toile {

/// How far each piece is turned, and why. Radians, counter-clockwise, about the drawing's origin.
struct UprightTurns {
  std::vector<double> turns;    ///< of each piece
  double drawing = 0;           ///< what a piece without a grain line is turned by
  std::vector<bool> off_grain;  ///< pieces cut on the bias or across: turned as the drawing is
  bool has_grain = false;       ///< whether any piece has a grain line
  bool by_shape = false;        ///< none has, but shapes tell which way it runs
  bool nested = false;          ///< of these, pieces lie askew: each is turned by its own shape
  bool end_by_shape = false;    ///< whether shapes told the upper end; else it is as drawn
};

/// Turns for pieces of these shapes.
///
/// - The drawing's axis is the grain that most of the area has. It is turned upright, and all
///   pieces with it.
/// - A piece is then turned on, by the lesser angle, until its own grain is upright. One whose
///   grain lies at 45 degrees to the axis, or across, stays: it is cut so on purpose.
/// - If the grain lies at 45 degrees to the straight edges of all pieces together, all are cut on
///   the bias. Then their edges are turned upright, the longer way.
/// - Without any grain line, shape_axis() tells by most of the area along or across which line the
///   drawing is cut. It is the way along which both ends of the pieces differ more, and the longer
///   way where that does not tell. Bands alone stay as drawn. Where shapes lie askew to each other,
///   as in a nested sheet, each piece is turned by its own.
/// - A grain line has no upper end. Outlines turn more at theirs: necklines, armholes, caps and
///   crotches are there, and hems are plain. More of the cloth lies below, where clothes are wider.
///   Where both agree, all pieces together have that end up. Otherwise they keep the one nearer to
///   up as drawn.
///
/// A drawing that is turned or mirrored as a whole gives the same pieces, turned or mirrored, where
/// shapes tell the end. O(n) of the outlines' points, without grain lines O(n^2); O(n^2) of the
/// pieces.
UprightTurns upright_turns(const std::vector<PieceShape>& shapes);

}  // namespace toile
