#include "pattern/import/graded_pieces.h"

#include <algorithm>
#include <limits>

#include "io/json_words.h"

namespace toile {

namespace {

/// Points of a curve that a mark is compared with.
constexpr int curve_samples = 32;

/// A mark's place on an outline.
struct MarkPlace {
  std::size_t curve = 0;
  double fraction = 0;
  Vec2 off = Vec2::Zero();  ///< metres from the outline to the mark
};

MarkPlace place_of_mark(const PiecePath& outline, const Vec2& mark) {
  MarkPlace best;
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const EdgeCurve& curve = outline[i];
    const int steps = curve.straight() ? 1 : curve_samples;
    Vec2 from = curve.start();
    for (int k = 1; k <= steps; ++k) {
      const Vec2 to = k == steps ? curve.end() : curve.at(static_cast<double>(k) / steps);
      const Vec2 run = to - from;
      const double square = run.squaredNorm();
      const double share = square > 0 ? std::clamp((mark - from).dot(run) / square, 0., 1.) : 0;
      const Vec2 at = from + share * run;
      if ((mark - at).norm() < nearest) {
        nearest = (mark - at).norm();
        best = {i, (k - 1 + share) / steps, mark - at};
      }
      from = to;
    }
  }
  return best;
}

/// Where the mark of one outline lies by another one of as many lines.
Vec2 moved_mark(const PiecePath& from, const PiecePath& to, const Vec2& mark) {
  const MarkPlace place = place_of_mark(from, mark);
  return to[place.curve].at(place.fraction) + place.off;
}

/// Ends of the edges of a piece that are no notches; its declared corners, if it has no edges.
std::vector<Vec2> corners_of_edges(const Piece& piece, const EdgeOptions& options) {
  try {
    std::vector<Remark> said_of_the_base;
    const PieceShape shape = shape_of(piece, piece.name, options.chord_error, said_of_the_base);
    const EdgedOutline edged = edges_of(shape, options, piece.name);
    std::vector<Vec2> corners;
    for (std::size_t i = 0; i < edged.vertices.size(); ++i) {
      const bool notch = std::ranges::any_of(edged.notches, [&](const OutlineNotch& one) {
        return one.vertex == static_cast<int>(i);
      });
      if (!notch) corners.push_back(edged.vertices[i]);
    }
    return corners;
  } catch (const Error&) {
    return piece.corners;
  }
}

void take_over(const Piece& base, const std::vector<Vec2>& corners, Piece& piece) {
  piece.has_all_corners = true;
  for (const Vec2& corner : corners) {
    piece.corners.push_back(moved_mark(base.outline, piece.outline, corner));
  }
  for (const PieceNotch& notch : base.notches) {
    piece.notches.push_back({moved_mark(base.outline, piece.outline, notch.at), notch.angle});
  }
}

}  // namespace

void complete_size(PieceDrawing& drawing, const std::string& size, const EdgeOptions& options) {
  if (drawing.base_size.empty() || size == drawing.base_size) return;
  std::string others;
  for (const Piece& base : drawing.pieces) {
    if (base.size != drawing.base_size) continue;
    const std::vector<Vec2> corners = corners_of_edges(base, options);
    for (Piece& piece : drawing.pieces) {
      if (piece.name != base.name || piece.size != size) continue;
      if (piece.quantity == 1 && !piece.pair && piece.category.empty() && piece.material.empty()) {
        piece.quantity = base.quantity;
        piece.pair = base.pair;
        piece.none_mirrored = base.none_mirrored;
        piece.category = base.category;
        piece.material = base.material;
      }
      if (!piece.corners.empty() || !piece.notches.empty()) continue;
      if (base.corners.empty() && base.notches.empty()) continue;
      if (piece.outline.size() == base.outline.size() && piece.is_cut_line == base.is_cut_line) {
        take_over(base, corners, piece);
      } else {
        others += (others.empty() ? " " : ", ") + in_quotes(piece.name);
      }
    }
  }
  if (others.empty()) return;
  drawing.remarks.push_back({false, drawing.source +
                                        ": outlines of other lines than in the base size have none "
                                        "of its corners and notches:" +
                                        others});
}

}  // namespace toile
