#include "pattern/import/dxf_pieces.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "geometry/error.h"
#include "geometry/polygon.h"
#include "io/json_words.h"
#include "io/text.h"
#include "pattern/import/drawing_unit.h"
#include "pattern/import/dxf_blocks.h"
#include "pattern/import/dxf_layers.h"
#include "pattern/import/dxf_loose_pieces.h"
#include "pattern/import/join_paths.h"
#include "pattern/import/piece_shape.h"
#include "pattern/import/piece_text.h"
#include "pattern/import/sew_line.h"

namespace toile {

namespace {

/// Metres: chords that are good enough to compare outlines.
constexpr double outline_chords = 1e-4;

/// Closed lines on one layer of a piece at most: they are compared with each other.
constexpr std::size_t max_loops = 500;

/// Makes pieces of what was drawn.
class PieceBuilder {
 public:
  PieceBuilder(const std::string& source, double unit, bool layered, bool cut_line,
               PieceDrawing& result)
      : source_(source), unit_(unit), layered_(layered), cut_line_(cut_line), result_(result) {}

  void add(const DrawnPiece& drawn) {
    Piece piece;
    PieceTexts texts;
    sort(drawn, piece, texts);
    piece.name = texts.value("piece name");
    if (piece.name.empty()) piece.name = texts.spelling_of(drawn.name);
    if (piece.name.empty()) piece.name = drawn.name;
    piece.category = texts.value("category");
    piece.is_panel = drawn_panel_fact == "Panel: " + texts.value("panel");
    piece.has_all_corners = piece.is_panel;
    piece.side_unknown = texts.value("side") == "unknown";
    piece.left_out = texts.value("left out");
    piece.size = texts.value("size");
    piece.material = texts.material();
    if (const auto quantity = texts.quantity()) {
      piece.quantity = quantity->count;
      piece.pair = quantity->pair;
      piece.none_mirrored = quantity->none_mirrored;
    } else if (drawn.mirrored_twin) {
      piece.quantity = 2;
    }
    piece.pair = piece.pair || (drawn.mirrored_twin && piece.quantity > 1);
    if (texts.others() > 0) result_.ignored["texts without a known key"] += texts.others();
    place_ = source_ + ": piece " + in_quotes(piece.name.empty() ? drawn.name : piece.name);
    try {
      outline(piece);
    } catch (const Error& error) {
      result_.left_out.push_back({piece.name, piece.size, error});
      return;
    }
    result_.pieces.push_back(std::move(piece));
  }

 private:
  void ignore(const std::string& what) { ++result_.ignored[what]; }

  void sort(const DrawnPiece& drawn, Piece& piece, PieceTexts& texts) {
    boundary_.clear();
    sew_.clear();
    internal_.clear();
    cut_outs_.clear();
    for (const DxfEntity& entity : drawn.entities) {
      const int layer = layered_ ? layer_number(entity) : any_layer;
      if (entity.kind == DxfEntity::Kind::text) {
        if (const auto seam = read_seam_text(entity.text)) {
          piece.seams.push_back({*seam, entity.at * unit_, entity.angle});
        } else {
          texts.add(entity.text);
        }
      } else if (entity.kind == DxfEntity::Kind::point) {
        point(entity, layer, piece);
      } else {
        curve(entity, layer, piece);
      }
    }
  }

  void point(const DxfEntity& entity, int layer, Piece& piece) {
    const Vec2 at = entity.at * unit_;
    if (layer == turn_layer) {
      piece.corners.push_back(at);
    } else if (is_notch_layer(layer)) {
      PieceNotch notch{at, std::nullopt};
      if (entity.has_angle) notch.angle = entity.angle;
      piece.notches.push_back(notch);
    } else if (layer == drill_layer) {
      piece.drill_holes.push_back(at);
    } else {
      ignore_layer(entity, layer);
    }
  }

  void ignore_layer(const DxfEntity& entity, int layer) {
    const std::string known = unused_layer(layer);
    ignore(known.empty() ? entity.type + " on layer " + in_quotes(entity.layer) : known);
  }

  void curve(const DxfEntity& entity, int layer, Piece& piece) {
    const bool line_layer = layer == mirror_layer || layer == grain_layer;
    if (layer == boundary_layer || layer == any_layer) {
      if (layered_ && layer == any_layer) {
        ignore_layer(entity, layer);
        return;
      }
      boundary_.push_back(dxf_path(entity, unit_));
    } else if (layer == sew_layer) {
      sew_.push_back(dxf_path(entity, unit_));
    } else if (layer == internal_layer) {
      internal_.push_back(dxf_path(entity, unit_));
    } else if (layer == cut_out_layer) {
      cut_outs_.push_back(dxf_path(entity, unit_));
    } else if (layer == drill_layer && entity.type == "CIRCLE") {
      piece.drill_holes.push_back(entity.at * unit_);
    } else if (line_layer) {
      auto& line = layer == mirror_layer ? piece.fold : piece.grain;
      const PieceLine longest = longest_line(entity);
      // An arrow is drawn of several lines.
      if (!line || (longest.to - longest.from).norm() > (line->to - line->from).norm()) {
        line = longest;
      }
    } else if (is_notch_layer(layer)) {
      const PieceLine mark = longest_line(entity);
      const Vec2 along = mark.to - mark.from;
      piece.notches.push_back({mark.from, std::atan2(along.y(), along.x())});
    } else {
      ignore_layer(entity, layer);
    }
  }

  PieceLine longest_line(const DxfEntity& entity) const {
    PieceLine longest;
    for (const DxfCurve& curve : entity.curves) {
      const PieceLine line{curve.points[0] * unit_, curve.points[3] * unit_};
      if ((line.to - line.from).norm() > (longest.to - longest.from).norm()) longest = line;
    }
    return longest;
  }

  [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const {
    throw Error(place_, problem, remedy);
  }

  /// The closed paths of a line of the piece, the largest first, each once.
  std::vector<PiecePath> loops(const std::vector<PiecePath>& paths, const std::string& what) {
    const JoinedPaths joined = join_paths(paths);
    std::vector<PiecePath> closed;
    std::vector<double> areas;
    if (joined.closed.size() > max_loops) {
      fail("has more than " + std::to_string(max_loops) + " closed lines on the layer of its " +
               what,
           "is it really a piece?");
    }
    for (const PiecePath& path : joined.closed) {
      const std::vector<Vec2> points = loop_points(path, outline_chords);
      if (is_line(points)) continue;
      const double area = std::abs(signed_area(points));
      const bool twin = std::any_of(closed.begin(), closed.end(), [&](const PiecePath& other) {
        const std::vector<Vec2> others = loop_points(other, outline_chords);
        return std::abs(std::abs(signed_area(others)) - area) <= 1e-6 * area &&
               nearest_place(others, points.front()).distance < max_outline_gap &&
               nearest_place(points, others.front()).distance < max_outline_gap;
      });
      if (twin) {
        ignore("outlines that are drawn twice");
        continue;
      }
      const auto after = std::upper_bound(areas.begin(), areas.end(), area, std::greater<>());
      closed.insert(closed.begin() + (after - areas.begin()), path);
      areas.insert(after, area);
    }
    double longest_open = 0;
    std::size_t open = 0;
    for (std::size_t i = 0; i < joined.open.size(); ++i) {
      const double length = path_length(joined.open[i]);
      if (length > longest_open) {
        longest_open = length;
        open = i;
      }
    }
    if (longest_open > 0 && (closed.empty() || longest_open > path_length(closed.front()))) {
      const PathGap gap = joined.gaps[std::min(open, joined.gaps.size() - 1)];
      fail("its " + what + " is open: a gap of " + number_text(gap.size * 1000) + " mm at " +
               millimetres_text(gap.at),
           "close it in the CAD program; gaps up to 0.5 mm are closed here");
    }
    for (std::size_t i = 0; i < joined.open.size(); ++i)
      ignore("open lines on the layer of a " + what);
    if (joined.widest_closed_gap > 1e-5) {
      result_.remarks.push_back({false, place_ + ": a gap of " +
                                            number_text(joined.widest_closed_gap * 1000, 2) +
                                            " mm in its " + what + " is closed"});
    }
    return closed;
  }

  /// The closed sew lines. Open ones that end on the boundary are closed along it.
  std::vector<PiecePath> sew_lines(const std::vector<PiecePath>& boundaries) {
    if (boundaries.empty()) return loops(sew_, "sew line");
    if (cut_line_) return {};
    const JoinedPaths joined = join_paths(sew_);
    if (joined.closed.empty() && !joined.open.empty()) {
      const std::vector<Vec2> boundary = loop_points(boundaries.front(), outline_chords);
      if (auto closed = closed_along(boundary, joined.open)) {
        ++sew_lines_closed_;
        if (sew_lines_closed_ == 1) {
          result_.remarks.push_back(
              {false, place_ +
                          ": its sew line ends on its boundary, and is closed along it, where it "
                          "has no allowance; so it is with other pieces"});
        }
        return {*closed};
      }
    }
    return loops(sew_, "sew line");
  }

  void outline(Piece& piece) {
    std::vector<PiecePath> boundaries = loops(boundary_, "boundary");
    std::vector<PiecePath> sewn = sew_lines(boundaries);
    const JoinedPaths internal = join_paths(internal_);
    std::vector<PiecePath> inner_lines = internal.open;
    inner_lines.insert(inner_lines.end(), internal.closed.begin(), internal.closed.end());
    if (boundaries.empty() && sewn.empty()) {
      fail("has no closed outline", "draw its boundary on layer 1");
    }
    std::vector<Vec2> boundary;
    if (!boundaries.empty()) {
      boundary = loop_points(boundaries.front(), outline_chords);
      piece.outline = boundaries.front();
      piece.is_cut_line = true;
    }
    for (std::size_t i = 1; i < boundaries.size(); ++i) {
      const std::vector<Vec2> points = loop_points(boundaries[i], outline_chords);
      if (!inside(boundary, points.front())) {
        fail(
            "has two outlines beside each other, the second at " + millimetres_text(points.front()),
            "give each piece a block of its own");
      }
      if (!layered_) {
        inner_lines.push_back(boundaries[i]);
      } else if (sewn.empty() && runs_along(boundary, boundaries[i])) {
        sewn.push_back(boundaries[i]);
      } else {
        result_.remarks.push_back({true, place_ + ": an outline within its boundary, at " +
                                             millimetres_text(points.front()) +
                                             ", is taken as a cut-out"});
        piece.cut_outs.push_back(boundaries[i]);
      }
    }
    if (sewn.size() > 1) {
      fail("has two closed sew lines", "give each piece a block of its own");
    }
    if (!sewn.empty() && !boundary.empty() && !can_be_sew_line(boundary, sewn.front())) {
      // A sew line that cuts across its piece would make a sound panel of the wrong size.
      if (!cut_line_) {
        result_.remarks.push_back(
            {true,
             place_ +
                 ": its line on layer 14 does not run along inside of its boundary, and is no sew "
                 "line; the boundary is taken, which --seam-allowance makes smaller"});
      }
      sewn.clear();
    }
    if (sewn.empty() && !boundary.empty()) find_sew_line(boundary, inner_lines, sewn);
    if (!sewn.empty() && !(cut_line_ && !boundaries.empty())) {
      piece.outline = sewn.front();
      piece.is_cut_line = false;
    }
    piece.internal_lines = std::move(inner_lines);
    for (PiecePath& path : loops(cut_outs_, "cut-out")) piece.cut_outs.push_back(std::move(path));
  }

  /// Takes the sew line from among the internal lines, if it is there.
  void find_sew_line(const std::vector<Vec2>& boundary, std::vector<PiecePath>& lines,
                     std::vector<PiecePath>& sewn) {
    const auto found = std::find_if(lines.begin(), lines.end(), [&](const PiecePath& path) {
      return (path.front().start() - path.back().end()).norm() <= max_outline_gap &&
             runs_along(boundary, path);
    });
    if (found == lines.end()) return;
    sewn.push_back(*found);
    lines.erase(found);
    ++sew_lines_found_;
    if (sew_lines_found_ == 1) {
      result_.remarks.push_back(
          {false, place_ +
                      ": the internal line that runs along its boundary is its sew line; so it "
                      "is with other pieces"});
    }
  }

  const std::string& source_;
  double unit_;
  bool layered_;
  bool cut_line_;
  PieceDrawing& result_;
  std::string place_;
  std::vector<PiecePath> boundary_;
  std::vector<PiecePath> sew_;
  std::vector<PiecePath> internal_;
  std::vector<PiecePath> cut_outs_;
  int sew_lines_found_ = 0;
  int sew_lines_closed_ = 0;
};

}  // namespace

PieceDrawing dxf_pieces(const DxfDrawing& drawing, const std::string& source,
                        const DrawingOptions& options) {
  PieceDrawing result;
  result.source = source;
  result.ignored = drawing.ignored;
  const bool layered = has_layers(drawing);
  std::vector<DrawnPiece> pieces = pieces_in_blocks(drawing, layered, source, result.remarks);

  PieceTexts style;
  for (const DxfEntity& entity : drawing.entities) {
    if (entity.kind == DxfEntity::Kind::text) style.add(entity.text);
  }
  result.base_size =
      style.value("sample size").empty() ? style.value("base size") : style.value("sample size");

  UnitEvidence evidence;
  evidence.asked = options.unit;
  for (const DrawnPiece& drawn : pieces) {
    evidence.largest = std::max(evidence.largest, outline_size(drawn.entities, layered));
  }
  if (pieces.empty()) evidence.largest = outline_size(drawing.entities, layered);
  if (!(evidence.largest > 0)) {
    throw Error(source, "holds no outline of a piece",
                "export the pieces as AAMA or ASTM DXF: outlines on layer 1, a block for each");
  }
  std::string units = style.value("units");
  for (const DrawnPiece& drawn : pieces) {
    PieceTexts texts;
    for (const DxfEntity& entity : drawn.entities) {
      if (entity.kind == DxfEntity::Kind::text) texts.add(entity.text);
    }
    if (units.empty()) units = texts.value("units");
    if (result.base_size.empty()) result.base_size = texts.value("sample size");
  }
  for (char& c : units) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto says = [&](const char* word) { return units.find(word) != std::string::npos; };
  if (says("english") || says("inch") || says("imperial")) {
    evidence.stated = 0.0254;
  } else if (says("centim") || units == "cm") {
    evidence.stated = 1e-2;
  } else if (says("metric") || says("millim") || units == "mm") {
    evidence.stated = 1e-3;
    evidence.metric = says("metric") && !says("millim") && !says("mm");
  }
  if (evidence.stated) {
    evidence.stated_by = "'Units: " + shown_text(units) + "'";
  }
  if (drawing.unit_metres > 0) {
    (evidence.stated ? evidence.other : evidence.stated) = drawing.unit_metres;
    (evidence.stated_by.empty() ? evidence.stated_by : evidence.other_by) = "$INSUNITS";
  }
  evidence.english = drawing.measurement == DxfMeasurement::english;
  const double unit = drawing_unit(evidence, source, result.remarks);
  result.unit = unit_with_source(evidence, unit);

  for (DrawnPiece& drawn : loose_pieces(drawing, layered, unit, source, result)) {
    pieces.push_back(std::move(drawn));
  }
  PieceBuilder builder(source, unit, layered, options.cut_line, result);
  for (const DrawnPiece& drawn : pieces) builder.add(drawn);
  if (result.pieces.empty() && !result.left_out.empty()) throw Error(result.left_out.front().error);
  return result;
}

}  // namespace toile
