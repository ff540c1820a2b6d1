#include "pattern/import/dxf_loose_pieces.h"

#include <algorithm>
#include <cmath>

#include "geometry/error.h"
#include "geometry/polygon.h"
#include "pattern/import/dxf_layers.h"
#include "pattern/import/join_paths.h"
#include "pattern/import/piece_shape.h"

namespace toile {

namespace {

/// Metres: chords that are good enough to tell what lies within what.
constexpr double rough_chords = 1e-4;

/// Outlines in model space at most: what lies where takes time with their number.
constexpr std::size_t max_loose_pieces = 2'000;

}  // namespace

std::vector<DrawnPiece> loose_pieces(const DxfDrawing& drawing, bool layered, double unit,
                                     const std::string& source, PieceDrawing& result) {
  // Which entities each closed outline is made of is found again by where they lie.
  std::vector<PiecePath> paths;
  const auto is_boundary = [&](const DxfEntity& entity) {
    return is_outline(entity, layered) && (!layered || layer_number(entity) == boundary_layer);
  };
  for (const DxfEntity& entity : drawing.entities) {
    if (is_boundary(entity)) paths.push_back(dxf_path(entity, unit));
  }
  if (paths.empty()) return {};
  const JoinedPaths joined = join_paths(paths);
  std::vector<std::vector<Vec2>> outlines;
  for (const PiecePath& path : joined.closed) {
    std::vector<Vec2> points = loop_points(path, rough_chords);
    if (points.size() >= 3 && std::abs(signed_area(points)) > 1e-6) {
      outlines.push_back(std::move(points));
    }
  }
  double longest_loop = 0;
  for (const PiecePath& path : joined.closed)
    longest_loop = std::max(longest_loop, path_length(path));
  for (std::size_t i = 0; i < joined.open.size() && i < joined.gaps.size(); ++i) {
    if (path_length(joined.open[i]) < longest_loop / 4) continue;
    const Error error(source + ": model space",
                      "an outline is open: a gap of " + number_text(joined.gaps[i].size * 1000) +
                          " mm at " + millimetres_text(joined.gaps[i].at),
                      "close it in the CAD program; gaps up to 0.5 mm are closed here");
    result.left_out.push_back({"open outline", "", error});
  }
  std::sort(outlines.begin(), outlines.end(), [](const auto& a, const auto& b) {
    return std::abs(signed_area(a)) > std::abs(signed_area(b));
  });
  std::vector<std::vector<Vec2>> outer;
  for (auto& outline : outlines) {
    const bool within = std::any_of(outer.begin(), outer.end(), [&](const auto& other) {
      return inside(other, outline.front());
    });
    if (!within) outer.push_back(std::move(outline));
    if (outer.size() > max_loose_pieces) {
      throw Error(source, "has more than 2,000 outlines in model space", "is it really a pattern?");
    }
  }
  std::vector<DrawnPiece> pieces(outer.size());
  for (const DxfEntity& entity : drawing.entities) {
    if (entity.kind == DxfEntity::Kind::insert) continue;
    // The middle of the first curve: its ends may be shared with a neighbour.
    Vec2 point = entity.at;
    if (!entity.curves.empty()) {
      const auto& p = entity.curves.front().points;
      point = (p[0] + 3 * p[1] + 3 * p[2] + p[3]) / 8;
    }
    point *= unit;
    std::size_t owner = outer.size();
    double least = 2e-3;  // metres: notches stand on the outline, or a little outside
    for (std::size_t i = 0; i < outer.size(); ++i) {
      if (inside(outer[i], point)) {
        owner = i;
        break;
      }
      const double distance = nearest_place(outer[i], point).distance;
      if (distance < least) {
        least = distance;
        owner = i;
      }
    }
    if (owner < outer.size()) {
      pieces[owner].entities.push_back(entity);
    } else if (entity.kind != DxfEntity::Kind::text) {
      ++result.ignored[entity.type + " outside of all pieces"];
    }
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) pieces[i].name = "piece" + std::to_string(i + 1);
  return pieces;
}

}  // namespace toile
