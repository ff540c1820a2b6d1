#include "pattern/import/svg_pieces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/error.h"
#include "geometry/polygon.h"
#include "io/json_words.h"
#include "io/svg.h"
#include "pattern/constants.h"
#include "pattern/import/drawing_unit.h"
#include "pattern/import/join_paths.h"
#include "pattern/import/piece_text.h"
#include "pattern/import/svg_outlines.h"
#include "pattern/import/svg_roles.h"

namespace toile {

namespace {

/// Square metres: a smaller closed path inside of a piece is a mark, such as the head of an arrow.
constexpr double smallest_inner_path = 1e-4;

/// Metres: a circle inside of a piece that is no wider is a drill hole.
constexpr double max_drill_width = 0.0101;

/// Metres from an outline within which a notch, a grain or a fold belongs to it.
constexpr double max_mark_distance = 0.02;

bool is_small_circle(const SvgOutline& outline) {
  const Vec2 size = outline.box.sizes();
  const double round = size.x() * size.y() * 0.785;
  return size.maxCoeff() <= max_drill_width && size.minCoeff() > 0.9 * size.maxCoeff() &&
         std::abs(outline.area - round) < 0.03 * round;
}

class PieceFinder {
 public:
  explicit PieceFinder(SvgSheet sheet)
      : sheet_(std::move(sheet)),
        outlines_(find_outlines(sheet_)),
        said_(outlines_.chosen.size()) {}

  PieceDrawing find() {
    for (const SvgOutlines::Chosen& one : outlines_.chosen) {
      Piece piece;
      const SvgOutline& outline = outlines_.all[static_cast<std::size_t>(one.outline)];
      piece.outline = outline.path;
      piece.is_cut_line = one.is_cut_line;
      piece.material = outline.meaning.material;
      pieces().push_back(std::move(piece));
    }
    inner_paths();
    marks();
    texts();
    names();
    warn_of_folds();
    check_sizes();
    return std::move(sheet_.pieces);
  }

 private:
  /// What texts say of a piece.
  struct Said {
    PieceTexts texts;
    std::string first_text;
    bool cutting = false;         ///< how often it is cut
    bool cutting_of_own = false;  ///< that text names the piece's own material
    bool on_fold = false;         ///< that text says that it is cut on the fold
  };

  std::vector<Piece>& pieces() { return sheet_.pieces.pieces; }

  const SvgOutline& outline_of(std::size_t piece) const {
    return outlines_.all[static_cast<std::size_t>(outlines_.chosen[piece].outline)];
  }

  /// What lies in the pieces, and what lies nowhere.
  void inner_paths() {
    for (std::size_t i = 0; i < outlines_.all.size(); ++i) {
      const SvgOutline& one = outlines_.all[i];
      if (one.of_piece || one.meaning.role == SvgRole::allowance) continue;
      const int at = piece_around(spread_points(one.polygon, 40, true), one.part);
      if (at < 0) {
        if (is_small_circle(one) || one.area < smallest_piece) {
          sheet_.ignore("small closed path outside of the pieces");
        } else {
          sheet_.ignore("closed path without a material");
        }
        continue;
      }
      Piece& piece = pieces()[static_cast<std::size_t>(at)];
      const bool same_shape = outline_of(static_cast<std::size_t>(at)).shape == one.shape;
      if (is_small_circle(one)) {
        piece.drill_holes.push_back(one.box.center());
      } else if (same_shape || one.meaning.role == SvgRole::cut_out) {
        piece.cut_outs.push_back(one.path);
      } else if (one.area < smallest_inner_path) {
        sheet_.ignore("small closed path");
      } else if (one.area > 0.995 * outline_of(static_cast<std::size_t>(at)).area) {
        sheet_.ignore("outline drawn twice");
      } else {
        piece.internal_lines.push_back(one.path);
      }
    }
    for (const SvgLine& open : outlines_.open) {
      const SvgShape& shape = sheet_.drawing.shapes[static_cast<std::size_t>(open.shape)];
      const SvgMeaning& meaning = sheet_.meanings[static_cast<std::size_t>(open.shape)];
      if (meaning.role == SvgRole::allowance) continue;  // on the fold it is drawn open
      const int part = sheet_.part_of(shape.group);
      const std::vector<Vec2> points = path_points(open.path, place_tolerance);
      const int at = piece_around(spread_points(points, 60, false), part);
      if (at >= 0) {
        pieces()[static_cast<std::size_t>(at)].internal_lines.push_back(open.path);
        continue;
      }
      refuse_gap(open, meaning);
      sheet_.ignore("line outside of the pieces");
    }
  }

  /// A line that all but closes is an outline with a gap, which must not go missing.
  void refuse_gap(const SvgLine& open, const SvgMeaning& meaning) {
    const Vec2& from = open.path.front().start();
    const Vec2& to = open.path.back().end();
    const double gap = (to - from).norm();
    const double length = path_length(open.path);
    const std::vector<Vec2> points = path_points(open.path, place_tolerance);
    if (points.size() < 3 || std::abs(signed_area(points)) < smallest_piece) return;
    // Where classes tell the outlines, a line without one is a mark, such as those of measures.
    if (meaning.role != SvgRole::outline && (outlines_.classed || gap > 0.2 * length)) return;
    const SvgShape& shape = sheet_.drawing.shapes[static_cast<std::size_t>(open.shape)];
    const Error error(sheet_.pieces.source + ":" + std::to_string(shape.line) + ": " +
                          shape.element + (shape.id.empty() ? "" : " " + in_quotes(shape.id)),
                      "the outline has a gap of " + number_text(gap * 1000) + " mm at " +
                          sheet_.where((from + to) / 2),
                      "close it; gaps under 0.5 mm are closed by themselves");
    sheet_.pieces.left_out.push_back({shape.id, "", error});
  }

  /// The smallest piece that the points lie in; -1: none.
  int piece_around(const std::vector<Vec2>& points, int part) {
    int best = -1;
    for (std::size_t p = 0; p < pieces().size(); ++p) {
      const SvgOutline& one = outline_of(p);
      if (one.part != part || !holds(one, points)) continue;
      if (best < 0 || one.area < outline_of(static_cast<std::size_t>(best)).area) {
        best = static_cast<int>(p);
      }
    }
    return best;
  }

  /// Pieces that a mark at a point belongs to: those it lies in, or near.
  std::vector<int> pieces_at(const Vec2& point, int part, bool near_outline) {
    std::vector<int> found;
    for (std::size_t p = 0; p < pieces().size(); ++p) {
      const SvgOutline& one = outline_of(p);
      if (one.part != part || one.box.exteriorDistance(point) > max_mark_distance) continue;
      if ((!near_outline && inside(one.polygon, point)) ||
          distance_to_polygon(one.polygon, point) <= max_mark_distance) {
        found.push_back(static_cast<int>(p));
      }
    }
    return found;
  }

  void marks() {
    for (const int s : outlines_.marked_lines) {
      const SvgShape& shape = sheet_.drawing.shapes[static_cast<std::size_t>(s)];
      const PieceLine line{sheet_.metres(shape.paths.front().start),
                           sheet_.metres(end_of(shape.paths.back()))};
      const bool fold = sheet_.meanings[static_cast<std::size_t>(s)].role == SvgRole::fold;
      const auto found = pieces_at((line.from + line.to) / 2, sheet_.part_of(shape.group), false);
      if ((line.to - line.from).norm() < max_outline_gap) {
        sheet_.ignore(fold ? "fold mark without a length" : "grain line without a length");
        continue;
      }
      if (found.empty()) {
        sheet_.ignore(fold ? "fold mark outside of the pieces"
                           : "grain line outside of the pieces");
      }
      for (const int p : found) {
        Piece& piece = pieces()[static_cast<std::size_t>(p)];
        std::optional<PieceLine>& kept = fold ? piece.fold : piece.grain;
        if (!kept) kept = line;
      }
    }
    // Where nothing else says it, cloth that is folded is folded along the grain.
    for (Piece& piece : pieces()) {
      if (piece.fold && !piece.grain) piece.grain = piece.fold;
    }
    std::vector<bool> drawn(sheet_.drawing.uses.size(), false);
    for (const int s : outlines_.marked_points) {
      const SvgShape& shape = sheet_.drawing.shapes[static_cast<std::size_t>(s)];
      if (shape.use >= 0) {
        // Each shape of a notch comes by the same `use`.
        if (drawn[static_cast<std::size_t>(shape.use)]) continue;
        drawn[static_cast<std::size_t>(shape.use)] = true;
      }
      mark(shape, sheet_.meanings[static_cast<std::size_t>(s)].role);
    }
  }

  void mark(const SvgShape& shape, SvgRole role) {
    Eigen::AlignedBox2d box;
    for (const DrawnPath& path : shape.paths) {
      box.extend(sheet_.metres(path.start));
      for (const DrawnSegment& segment : path.segments) box.extend(sheet_.metres(segment.end));
    }
    PieceNotch notch{box.center(), std::nullopt};
    if (shape.use >= 0) {
      const SvgUse& use = sheet_.drawing.uses[static_cast<std::size_t>(shape.use)];
      notch.at = sheet_.metres(use.at);
      // A sign that is not turned says nothing about a direction.
      if (std::abs(use.right.y()) > 1e-9 || use.right.x() < 0) {
        notch.angle = std::atan2(-use.right.y(), use.right.x());
      }
    } else if (shape.element == "line") {
      const Vec2 run = sheet_.metres(end_of(shape.paths[0])) - sheet_.metres(shape.paths[0].start);
      notch.angle = std::atan2(run.y(), run.x());
    }
    const bool is_notch = role == SvgRole::notch;
    const auto found = pieces_at(notch.at, sheet_.part_of(shape.group), is_notch);
    if (found.empty())
      sheet_.ignore(is_notch ? "notch away from the pieces" : "drill hole outside of the pieces");
    for (const int p : found) {
      Piece& piece = pieces()[static_cast<std::size_t>(p)];
      if (is_notch) {
        piece.notches.push_back(notch);
      } else {
        piece.drill_holes.push_back(notch.at);
      }
    }
  }

  /// A part may say how often its fabric, its lining and its canvas are cut. What has the piece's
  /// own material counts, else what comes first.
  void take_cutting(const CuttingText& cutting, std::size_t index, bool several_pieces) {
    Piece& piece = pieces()[index];
    const std::string& own = outline_of(index).meaning.material;
    const bool of_own = !own.empty() && cutting.material == own;
    Said& said = said_[index];
    if (said.cutting && (!of_own || said.cutting_of_own)) return;
    if (several_pieces && !piece.material.empty() && !cutting.material.empty() &&
        cutting.material != piece.material) {
      return;
    }
    said.cutting = true;
    said.cutting_of_own = of_own;
    said.on_fold = cutting.on_fold;
    piece.quantity = cutting.quantity.count;
    piece.pair = cutting.quantity.pair;
    piece.none_mirrored = cutting.quantity.none_mirrored;
    const bool other = piece.material.empty() || piece.material == "fabric";
    if (of_own || (other && !cutting.material.empty())) piece.material = cutting.material;
  }

  /// Texts say names, numbers and materials.
  void texts() {
    for (const SvgText& text : sheet_.drawing.texts) {
      if (!text.on_path.empty()) continue;  // it says what a line is
      const int part = sheet_.part_of(text.group);
      const Vec2 at = sheet_.metres(text.at);
      std::vector<int> found;
      for (std::size_t p = 0; p < pieces().size(); ++p) {
        const SvgOutline& one = outline_of(p);
        if (one.part == part && (part >= 0 || inside(one.polygon, at))) {
          found.push_back(static_cast<int>(p));
        }
      }
      if (found.empty()) sheet_.ignore("text outside of the pieces");
      const std::vector<CuttingText> cuttings = read_cuttings(text.text);
      for (const int p : found) {
        const auto index = static_cast<std::size_t>(p);
        said_[index].texts.add(text.text);
        const bool has_letter =
            std::any_of(text.text.begin(), text.text.end(),
                        [](unsigned char c) { return std::isalpha(c) != 0 || c >= 0x80; });
        if (has_letter && said_[index].first_text.empty()) said_[index].first_text = text.text;
        for (const CuttingText& cutting : cuttings) take_cutting(cutting, index, found.size() > 1);
      }
    }
    for (std::size_t p = 0; p < pieces().size(); ++p) {
      Piece& piece = pieces()[p];
      const auto quantity = said_[p].texts.quantity();
      if (quantity && !said_[p].cutting) {
        piece.quantity = quantity->count;
        piece.pair = quantity->pair;
        piece.none_mirrored = quantity->none_mirrored;
      }
      if (piece.material.empty()) piece.material = said_[p].texts.material();
      piece.size = said_[p].texts.value("size");
    }
  }

  void names() {
    std::map<int, int> pieces_in_group;
    for (std::size_t p = 0; p < pieces().size(); ++p) {
      for (int group = shape_of(p).group; group >= 0;
           group = sheet_.drawing.groups[static_cast<std::size_t>(group)].parent) {
        ++pieces_in_group[group];
      }
    }
    std::map<int, std::vector<std::size_t>> of_part;
    for (std::size_t p = 0; p < pieces().size(); ++p) {
      pieces()[p].name = name_of(p, pieces_in_group);
      if (outline_of(p).part >= 0) of_part[outline_of(p).part].push_back(p);
    }
    // What a part has besides its fabric is named after its material.
    for (const auto& [part, of_one] : of_part) {
      for (const std::size_t p : of_one) {
        Piece& piece = pieces()[p];
        if (of_one.size() > 1 && piece.material != "fabric" && !piece.material.empty()) {
          piece.name += "_" + piece.material;
        }
      }
    }
  }

  /// Names what is a half by its text only: where it is folded, a person has to say.
  void warn_of_folds() {
    for (std::size_t p = 0; p < pieces().size(); ++p) {
      const Piece& piece = pieces()[p];
      if (!said_[p].on_fold || piece.fold) continue;
      sheet_.note("piece " + in_quotes(piece.name) +
                      " is said to be cut on the fold, but has no fold line: it is taken as whole; "
                      "--unfold or --pair makes more of it",
                  true);
    }
  }

  const SvgShape& shape_of(std::size_t piece) {
    return sheet_.drawing.shapes[static_cast<std::size_t>(outline_of(piece).shape)];
  }

  std::string name_of(std::size_t p, const std::map<int, int>& pieces_in_group) {
    const int part = outline_of(p).part;
    if (part >= 0) {
      std::string name =
          freesewing_part_name(sheet_.drawing.groups[static_cast<std::size_t>(part)]);
      // Its sleeves are drawn with the front on the right side: seen from outside, the right one.
      pieces()[p].is_right_one = name.find("sleeve") != std::string::npos;
      return name;
    }
    if (std::string named = said_[p].texts.value("piece name"); !named.empty()) return named;
    const SvgShape& shape = shape_of(p);
    if (!shape.label.empty()) return shape.label;
    if (!shape.title.empty()) return shape.title;
    if (!is_automatic_id(shape.id)) return shape.id;
    int group = shape.group;
    for (; group >= 0; group = sheet_.drawing.groups[static_cast<std::size_t>(group)].parent) {
      if (pieces_in_group.at(group) > 1) break;
      const SvgGroup& one = sheet_.drawing.groups[static_cast<std::size_t>(group)];
      if (!one.title.empty()) return one.title;
      if (!one.label.empty() && !is_automatic_id(one.label)) return one.label;
      if (!is_automatic_id(one.id)) return one.id;
    }
    if (!said_[p].first_text.empty()) return said_[p].first_text;
    return shape.id;
  }

  void check_sizes() {
    double largest = 0;
    for (std::size_t p = 0; p < pieces().size(); ++p) {
      largest = std::max(largest, outline_of(p).box.sizes().maxCoeff());
    }
    UnitEvidence evidence;
    const double unit = sheet_.options.unit.value_or(sheet_.scale.x());
    (sheet_.options.unit ? evidence.asked : evidence.stated) = unit;
    evidence.stated_by = sheet_.drawing.physical ? "its width and viewBox" : "96 units an inch";
    evidence.largest = largest / unit;
    drawing_unit(evidence, sheet_.pieces.source, sheet_.pieces.remarks);
    sheet_.pieces.unit = unit_with_source(evidence, unit);
  }

  SvgSheet sheet_;
  SvgOutlines outlines_;
  std::vector<Said> said_;  ///< of each piece
};

}  // namespace

PieceDrawing svg_pieces(std::string_view text, const std::string& source,
                        const DrawingOptions& options) {
  SvgSheet sheet;
  sheet.drawing = parse_svg(text, source);
  sheet.options = options;
  sheet.pieces.source = source;
  sheet.pieces.ignored = sheet.drawing.ignored;
  sheet.scale = sheet.drawing.metres_per_unit;
  if (options.unit) {
    sheet.scale.setConstant(*options.unit);
  } else if (!sheet.drawing.physical) {
    sheet.note("states no unit of length; 96 of its units are taken as an inch");
  }
  return PieceFinder(std::move(sheet)).find();
}

}  // namespace toile
