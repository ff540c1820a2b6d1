#include "pattern/import/svg_pieces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "geometry/error.h"
#include "geometry/polygon.h"
#include "io/json_words.h"
#include "io/limits.h"
#include "io/svg.h"
#include "pattern/constants.h"
#include "pattern/import/drawing_unit.h"
#include "pattern/import/join_paths.h"
#include "pattern/import/sew_line.h"
#include "pattern/import/svg_roles.h"

namespace toile {

namespace {

/// Metres that chords leave curves by, where only the place of a path is asked for.
constexpr double place_tolerance = 1e-4;

/// Square metres: no piece of a garment is smaller than 2 cm by 2 cm.
constexpr double smallest_piece = 4e-4;
/// Square metres: a smaller closed path inside of a piece is a mark, such as the head of an arrow.
constexpr double smallest_inner_path = 1e-4;

/// Share of its cut line's area that a seam line bounds at least: a narrow band's has a sixth.
constexpr double least_seam_share = 0.1;

/// Metres: a circle inside of a piece that is no wider is a drill hole.
constexpr double max_drill_width = 0.0101;

/// Metres from an outline within which a notch, a grain or a fold belongs to it.
constexpr double max_mark_distance = 0.02;

/// Closed paths of a drawing at most: they are compared with each other.
constexpr std::size_t max_closed_paths = 20'000;

/// A closed path of the drawing.
struct Outline {
  PiecePath path;
  std::vector<Vec2> polygon;
  Eigen::AlignedBox2d box;
  double area = 0;
  int shape = 0;  ///< index into SvgDrawing::shapes of its first curve
  SvgMeaning meaning;
  int part = -1;          ///< FreeSewing's part
  int around = -1;        ///< index of the smallest outline that it lies in; -1: none
  bool of_piece = false;  ///< the seam line of a piece, or its cut line
};

double distance_to_polygon(const std::vector<Vec2>& polygon, const Vec2& point) {
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    least =
        std::min(least, distance_to_segment(point, polygon[i], polygon[(i + 1) % polygon.size()]));
  }
  return least;
}

/// `count` points at equal steps along chords, a closed path's with the one back to its start.
std::vector<Vec2> spread_points(std::vector<Vec2> chords, int count, bool closed) {
  if (closed) chords.push_back(chords.front());
  double length = 0;
  for (std::size_t i = 1; i < chords.size(); ++i) length += (chords[i] - chords[i - 1]).norm();
  const double step = length / count;
  std::vector<Vec2> points = {chords.front()};
  double next = step;
  for (std::size_t i = 1; i < chords.size() && step > 0; ++i) {
    const double chord = (chords[i] - chords[i - 1]).norm();
    for (; next <= chord; next += step) {
      points.push_back(chords[i - 1] + next / chord * (chords[i] - chords[i - 1]));
    }
    next -= chord;
  }
  points.push_back(chords.back());
  return points;
}

/// Whether all of a path lies inside of the outline or, within the gap that is closed, on it.
bool holds(const Outline& outline, const std::vector<Vec2>& points) {
  return std::all_of(points.begin(), points.end(), [&](const Vec2& point) {
    return outline.box.exteriorDistance(point) <= max_outline_gap &&
           (inside(outline.polygon, point) ||
            distance_to_polygon(outline.polygon, point) <= max_outline_gap);
  });
}

bool is_small_circle(const Outline& outline) {
  const Vec2 size = outline.box.sizes();
  const double round = size.x() * size.y() * 0.785;
  return size.maxCoeff() <= max_drill_width && size.minCoeff() > 0.9 * size.maxCoeff() &&
         std::abs(outline.area - round) < 0.03 * round;
}

class Finder {
 public:
  Finder(std::string_view text, const std::string& source, const DrawingOptions& options)
      : drawing_(parse_svg(text, source)), options_(options) {
    pieces_.source = source;
    pieces_.ignored = drawing_.ignored;
    scale_ = drawing_.metres_per_unit;
    if (options.unit) {
      scale_.setConstant(*options.unit);
    } else if (!drawing_.physical) {
      note("states no unit of length; 96 of its units are taken as an inch");
    }
  }

  PieceDrawing find() {
    collect();
    nest();
    choose();
    inner_paths();
    marks();
    texts();
    names();
    warn_of_folds();
    check_sizes();
    return std::move(pieces_);
  }

 private:
  void note(const std::string& text, bool warning = false) {
    pieces_.remarks.push_back({warning, pieces_.source + ": " + text});
  }
  void ignore(const std::string& what) { ++pieces_.ignored[what]; }

  Vec2 metres(const Vec2& point) const { return {point.x() * scale_.x(), -point.y() * scale_.y()}; }

  PiecePath to_metres(const DrawnPath& path) const {
    PiecePath curves;
    Vec2 from = metres(path.start);
    for (const DrawnSegment& segment : path.segments) {
      const Vec2 to = metres(segment.end);
      for (const double value : {to.x(), to.y()}) {
        const std::string problem = coordinate_problem(value, max_metres);
        if (!problem.empty()) throw Error(pieces_.source, problem, coordinate_remedy);
      }
      if (!segment.curved) {
        if (from != to) curves.push_back(EdgeCurve::line(from, to));
      } else {
        curves.push_back(
            EdgeCurve::cubic(from, metres(segment.control1), metres(segment.control2), to));
      }
      from = to;
    }
    return curves;
  }

  std::string where(const Vec2& point) const {
    return "(" + number_text(point.x() / scale_.x()) + ", " + number_text(-point.y() / scale_.y()) +
           ")";
  }

  /// Sorts all shapes by what they are. Loose lines are joined.
  void collect() {
    for (std::size_t s = 0; s < drawing_.shapes.size(); ++s) {
      SvgMeaning meaning = meaning_of(drawing_, drawing_.shapes[s]);
      classed_ = classed_ || meaning.role == SvgRole::outline ||
                 (meaning.role == SvgRole::allowance && !meaning.material.empty());
      meanings_.push_back(std::move(meaning));
    }
    leave_out_unreadable();
    // What is loose is joined with what has the same meaning, in the same group.
    using Key = std::tuple<int, SvgRole, std::string>;
    std::map<Key, std::vector<int>> loose;
    for (std::size_t s = 0; s < drawing_.shapes.size(); ++s) {
      const SvgShape& shape = drawing_.shapes[s];
      const SvgMeaning& meaning = meanings_[s];
      switch (meaning.role) {
        case SvgRole::unseen:
          continue;
        case SvgRole::remark:
          ignore(meaning.what);
          continue;
        case SvgRole::grain:
        case SvgRole::fold:
          lines_.push_back(static_cast<int>(s));
          continue;
        case SvgRole::notch:
        case SvgRole::drill_hole:
          if (is_mark(shape)) {
            points_.push_back(static_cast<int>(s));
            continue;
          }
          meanings_[s] = {};  // a piece that is named after its notches
          break;
        default:
          break;
      }
      bool any_loose = false;
      for (const DrawnPath& path : shape.paths) {
        if (path.closed) {
          add_closed(to_metres(path), static_cast<int>(s));
        } else {
          any_loose = true;
        }
      }
      if (any_loose) {
        loose[{shape.group, meanings_[s].role, meanings_[s].material}].push_back(
            static_cast<int>(s));
      }
    }
    for (const auto& [key, shapes] : loose) join(shapes);
    if (outlines_.size() > max_closed_paths) {
      throw Error(pieces_.source,
                  "has " + std::to_string(outlines_.size()) + " closed paths, more than 20,000",
                  "is it really a pattern?");
    }
  }

  /// Refuses outlines and folds that can't be read. Other lines are counted, and the first is
  /// named.
  void leave_out_unreadable() {
    for (std::size_t s = 0; s < drawing_.shapes.size(); ++s) {
      const SvgShape& shape = drawing_.shapes[s];
      if (!shape.unreadable) continue;
      const SvgRole role = meanings_[s].role;
      const bool can_be_outline =
          role == SvgRole::unknown && !(is_freesewing(drawing_) && is_freesewing_mark(shape));
      if (can_be_outline || role == SvgRole::outline || role == SvgRole::allowance ||
          role == SvgRole::cut_out || role == SvgRole::fold) {
        throw Error(*shape.unreadable);
      }
      const std::string what = "line that can't be read";
      if (pieces_.ignored.count(what) == 0) {
        pieces_.remarks.push_back(
            {false, std::string(shape.unreadable->what()) + "; it is no outline, and left out"});
      }
      ignore(what);
      meanings_[s].role = SvgRole::unseen;
    }
  }

  bool is_mark(const SvgShape& shape) const {
    if (shape.use >= 0) return true;
    Eigen::AlignedBox2d box;
    for (const DrawnPath& path : shape.paths) {
      box.extend(metres(path.start));
      for (const DrawnSegment& segment : path.segments) box.extend(metres(segment.end));
    }
    return box.sizes().prod() < smallest_piece;
  }

  void add_closed(PiecePath path, int shape) {
    Outline outline;
    outline.polygon = loop_points(path, place_tolerance);
    if (outline.polygon.size() < 3) return;
    outline.path = std::move(path);
    for (const Vec2& point : outline.polygon) outline.box.extend(point);
    outline.area = std::abs(signed_area(outline.polygon));
    outline.shape = shape;
    outline.meaning = meanings_[static_cast<std::size_t>(shape)];
    outline.part = part_of(drawing_.shapes[static_cast<std::size_t>(shape)].group);
    outlines_.push_back(std::move(outline));
  }

  int part_of(int group) const {
    return is_freesewing(drawing_) ? freesewing_part(drawing_, group) : -1;
  }

  /// Joins the loose paths of some shapes to outlines and lines.
  void join(const std::vector<int>& shapes) {
    std::vector<PiecePath> paths;
    std::map<std::pair<double, double>, int> shape_at;
    for (const int s : shapes) {
      for (const DrawnPath& path : drawing_.shapes[static_cast<std::size_t>(s)].paths) {
        if (path.closed) continue;
        PiecePath curves = to_metres(path);
        if (curves.empty()) continue;
        for (const EdgeCurve& curve : curves) {
          shape_at.try_emplace({curve.start().x(), curve.start().y()}, s);
          shape_at.try_emplace({curve.end().x(), curve.end().y()}, s);
        }
        paths.push_back(std::move(curves));
      }
    }
    const auto shape_of = [&](const PiecePath& path) {
      const auto found = shape_at.find({path.front().start().x(), path.front().start().y()});
      return found == shape_at.end() ? shapes.front() : found->second;
    };
    JoinedPaths joined = join_paths(paths);
    if (joined.widest_closed_gap > 1e-6) {
      note("gaps of up to " + number_text(joined.widest_closed_gap * 1000, 2) +
           " mm in outlines are closed");
    }
    for (PiecePath& path : joined.closed) add_closed(path, shape_of(path));
    for (PiecePath& path : joined.open) {
      const int shape = shape_of(path);
      open_.push_back({std::move(path), shape});
    }
  }

  /// Which outline lies in which.
  void nest() {
    std::vector<int> by_area(outlines_.size());
    for (std::size_t i = 0; i < by_area.size(); ++i) by_area[i] = static_cast<int>(i);
    std::stable_sort(by_area.begin(), by_area.end(),
                     [&](int a, int b) { return outline(a).area > outline(b).area; });
    for (std::size_t i = 0; i < by_area.size(); ++i) {
      Outline& one = outline(by_area[i]);
      const std::vector<Vec2> points = spread_points(one.polygon, 40, true);
      for (std::size_t k = i; k-- > 0 && one.around < 0;) {
        const Outline& other = outline(by_area[k]);
        // Parts of FreeSewing may lie on each other.
        if (other.part != one.part || !other.box.contains(one.box.center())) continue;
        // Doubled paths are no piece in a piece.
        if (holds(other, points)) one.around = by_area[k];
      }
    }
    order_ = std::move(by_area);
  }

  Outline& outline(int index) { return outlines_[static_cast<std::size_t>(index)]; }

  /// Which outlines are pieces. The larger ones come first, so what is around one is decided.
  void choose() {
    for (const int index : order_) {
      Outline& one = outline(index);
      if (one.area < smallest_piece) continue;
      switch (one.meaning.role) {
        case SvgRole::outline:
          // What lies in a piece of another material is a piece of its own.
          if (!lies_in_piece(one, true)) choose_outline(index, false);
          break;
        case SvgRole::allowance:
          if (!lies_in_piece(one, false)) choose_allowance(index);
          break;
        default:
          if (!classed_ && !lies_in_piece(one, false)) choose_plain(index);
      }
    }
    choose_of_parts();
    make_pieces();
    if (!pieces_.pieces.empty()) return;
    std::string remedy = "join the ends of its lines, or close the path";
    PathGap gap = widest_open();
    throw Error(pieces_.source,
                gap.size > 0 ? "holds no closed outline; the longest line is open by " +
                                   number_text(gap.size * 1000) + " mm at " + where(gap.at)
                             : "holds no closed outline",
                remedy);
  }

  /// FreeSewing's parts whose seam lines have no class of a material, such as ribbing: each one's
  /// largest outline without a class is a piece.
  void choose_of_parts() {
    if (!classed_) return;
    std::set<int> with_piece;
    for (const Outline& one : outlines_) {
      if (one.of_piece) with_piece.insert(one.part);
    }
    for (const int index : order_) {
      const Outline& one = outline(index);
      if (one.area < smallest_piece) break;
      if (one.part < 0 || one.meaning.role != SvgRole::unknown) continue;
      if (with_piece.insert(one.part).second) choose_outline(index, false);
    }
  }

  /// A cut line is a piece where no seam line lies in it, or the user asks for it.
  void choose_allowance(int index) {
    if (!options_.cut_line) {
      if (has_seam_line(index)) return;
      // FreeSewing's trousers draw some seam lines without a class, where they have allowances.
      const int seam = unclassed_seam_line(index);
      if (seam >= 0) {
        outline(seam).meaning.material = outline(index).meaning.material;
        choose_outline(seam, false);
        return;
      }
    }
    choose_outline(index, true);
  }

  /// An outline without a class: with a line all along inside of it, it is the line to cut along.
  void choose_plain(int index) {
    const int seam = options_.cut_line ? -1 : seam_line_within(index);
    if (seam < 0) {
      choose_outline(index, false);
      return;
    }
    note("the paths at " + where(outline(index).polygon[0]) +
         " run along each other: the inner one is taken as the seam line");
    choose_outline(seam, false);
    outline(index).of_piece = true;
  }

  /// Makes the pieces, in the order of the file.
  void make_pieces() {
    std::stable_sort(chosen_.begin(), chosen_.end(), [&](const Chosen& a, const Chosen& b) {
      return outline(a.outline).shape < outline(b.outline).shape;
    });
    for (const Chosen& one : chosen_) {
      Piece piece;
      piece.outline = outline(one.outline).path;
      piece.is_cut_line = one.is_cut_line;
      piece.material = outline(one.outline).meaning.material;
      pieces_.pieces.push_back(std::move(piece));
    }
  }

  /// The opening of the longest open path.
  PathGap widest_open() const {
    PathGap gap;
    double longest = 0;
    for (const OpenPath& open : open_) {
      const double length = path_length(open.path);
      if (length <= longest) continue;
      longest = length;
      const Vec2& from = open.path.front().start();
      const Vec2& to = open.path.back().end();
      gap = {(to - from).norm(), (from + to) / 2};
    }
    return gap;
  }

  bool lies_in_piece(const Outline& one, bool of_same_material) {
    for (int at = one.around; at >= 0; at = outline(at).around) {
      if (outline(at).of_piece &&
          (!of_same_material || outline(at).meaning.material == one.meaning.material)) {
        return true;
      }
    }
    return false;
  }

  /// Whether a seam line lies in the cut line: one of its material, or one that it runs along.
  bool has_seam_line(int index) {
    const Outline& cut = outline(index);
    return std::any_of(outlines_.begin(), outlines_.end(), [&](const Outline& other) {
      if (&other == &cut || other.meaning.role == SvgRole::allowance || other.part != cut.part ||
          other.area < smallest_piece) {
        return false;
      }
      if (classed_ && other.meaning.material != cut.meaning.material) {
        // The class of an allowance may lack the material, or say that of another part.
        return other.meaning.role == SvgRole::outline && runs_along(cut.polygon, other.path);
      }
      // A pocket that is drawn in a part is none, though its class is that of the allowance.
      return other.area >= least_seam_share * cut.area && (cut.part >= 0 || other.around == index);
    });
  }

  /// In a drawing with classes, the outline without one that the cut line runs along; -1: none.
  int unclassed_seam_line(int index) {
    const Outline& cut = outline(index);
    const auto found = std::find_if(order_.begin(), order_.end(), [&](int i) {
      const Outline& other = outline(i);
      return classed_ && other.part == cut.part && other.meaning.role == SvgRole::unknown &&
             other.area >= smallest_piece && runs_along(cut.polygon, other.path);
    });
    return found == order_.end() ? -1 : *found;
  }

  /// The outline that runs along the inside of another one; -1: none.
  int seam_line_within(int index) {
    const Outline& cut = outline(index);
    const auto found = std::find_if(order_.begin(), order_.end(), [&](int i) {
      const Outline& inner = outline(i);
      return inner.around == index && inner.shape != cut.shape &&
             runs_along(cut.polygon, inner.path);
    });
    return found == order_.end() ? -1 : *found;
  }

  void choose_outline(int index, bool is_cut_line) {
    if (chosen_.size() >= static_cast<std::size_t>(max_panels)) {
      throw Error(pieces_.source,
                  "has more than " + std::to_string(max_panels) + " closed outlines",
                  "is it really a pattern?");
    }
    chosen_.push_back({index, is_cut_line});
    outline(index).of_piece = true;
  }

  const Outline& outline_of(std::size_t piece) { return outline(chosen_[piece].outline); }

  /// What lies in the pieces, and what lies nowhere.
  void inner_paths() {
    for (std::size_t i = 0; i < outlines_.size(); ++i) {
      Outline& one = outlines_[i];
      if (one.of_piece || one.meaning.role == SvgRole::allowance) continue;
      const int at = piece_around(spread_points(one.polygon, 40, true), one.part);
      if (at < 0) {
        if (is_small_circle(one) || one.area < smallest_piece) {
          ignore("small closed path outside of the pieces");
        } else {
          ignore("closed path without a material");
        }
        continue;
      }
      Piece& piece = pieces_.pieces[static_cast<std::size_t>(at)];
      const bool same_shape = outline_of(static_cast<std::size_t>(at)).shape == one.shape;
      if (is_small_circle(one)) {
        piece.drill_holes.push_back(one.box.center());
      } else if (same_shape || one.meaning.role == SvgRole::cut_out) {
        piece.cut_outs.push_back(one.path);
      } else if (one.area < smallest_inner_path) {
        ignore("small closed path");
      } else if (one.area > 0.995 * outline_of(static_cast<std::size_t>(at)).area) {
        ignore("outline drawn twice");
      } else {
        piece.internal_lines.push_back(one.path);
      }
    }
    for (const OpenPath& open : open_) {
      const SvgShape& shape = drawing_.shapes[static_cast<std::size_t>(open.shape)];
      const SvgMeaning& meaning = meanings_[static_cast<std::size_t>(open.shape)];
      if (meaning.role == SvgRole::allowance) continue;  // on the fold it is drawn open
      const int part = part_of(shape.group);
      const std::vector<Vec2> points = path_points(open.path, place_tolerance);
      const int at = piece_around(spread_points(points, 60, false), part);
      if (at >= 0) {
        pieces_.pieces[static_cast<std::size_t>(at)].internal_lines.push_back(open.path);
        continue;
      }
      refuse_gap(open, meaning);
      ignore("line outside of the pieces");
    }
  }

  /// A line that all but closes is an outline with a gap, which must not go missing.
  void refuse_gap(const auto& open, const SvgMeaning& meaning) const {
    const Vec2& from = open.path.front().start();
    const Vec2& to = open.path.back().end();
    const double gap = (to - from).norm();
    const double length = path_length(open.path);
    const std::vector<Vec2> points = path_points(open.path, place_tolerance);
    if (points.size() < 3 || std::abs(signed_area(points)) < smallest_piece) return;
    // Where classes tell the outlines, a line without one is a mark, such as those of measures.
    if (meaning.role != SvgRole::outline && (classed_ || gap > 0.2 * length)) return;
    const SvgShape& shape = drawing_.shapes[static_cast<std::size_t>(open.shape)];
    throw Error(
        pieces_.source + ":" + std::to_string(shape.line) + ": " + shape.element +
            (shape.id.empty() ? "" : " " + in_quotes(shape.id)),
        "the outline has a gap of " + number_text(gap * 1000) + " mm at " + where((from + to) / 2),
        "close it; gaps under 0.5 mm are closed by themselves");
  }

  /// The smallest piece that the points lie in; -1: none.
  int piece_around(const std::vector<Vec2>& points, int part) {
    int best = -1;
    for (std::size_t p = 0; p < pieces_.pieces.size(); ++p) {
      const Outline& one = outline_of(p);
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
    for (std::size_t p = 0; p < pieces_.pieces.size(); ++p) {
      const Outline& one = outline_of(p);
      if (one.part != part || one.box.exteriorDistance(point) > max_mark_distance) continue;
      if ((!near_outline && inside(one.polygon, point)) ||
          distance_to_polygon(one.polygon, point) <= max_mark_distance) {
        found.push_back(static_cast<int>(p));
      }
    }
    return found;
  }

  void marks() {
    for (const int s : lines_) {
      const SvgShape& shape = drawing_.shapes[static_cast<std::size_t>(s)];
      const PieceLine line{metres(shape.paths.front().start), metres(end_of(shape.paths.back()))};
      const bool fold = meanings_[static_cast<std::size_t>(s)].role == SvgRole::fold;
      const auto found = pieces_at((line.from + line.to) / 2, part_of(shape.group), false);
      if ((line.to - line.from).norm() < max_outline_gap) {
        ignore(fold ? "fold mark without a length" : "grain line without a length");
        continue;
      }
      if (found.empty()) {
        ignore(fold ? "fold mark outside of the pieces" : "grain line outside of the pieces");
      }
      for (const int p : found) {
        Piece& piece = pieces_.pieces[static_cast<std::size_t>(p)];
        std::optional<PieceLine>& kept = fold ? piece.fold : piece.grain;
        if (!kept) kept = line;
      }
    }
    // Where nothing else says it, cloth that is folded is folded along the grain.
    for (Piece& piece : pieces_.pieces) {
      if (piece.fold && !piece.grain) piece.grain = piece.fold;
    }
    std::vector<bool> drawn(drawing_.uses.size(), false);
    for (const int s : points_) {
      const SvgShape& shape = drawing_.shapes[static_cast<std::size_t>(s)];
      if (shape.use >= 0) {
        // Each shape of a notch comes by the same `use`.
        if (drawn[static_cast<std::size_t>(shape.use)]) continue;
        drawn[static_cast<std::size_t>(shape.use)] = true;
      }
      mark(shape, meanings_[static_cast<std::size_t>(s)].role);
    }
  }

  void mark(const SvgShape& shape, SvgRole role) {
    Eigen::AlignedBox2d box;
    for (const DrawnPath& path : shape.paths) {
      box.extend(metres(path.start));
      for (const DrawnSegment& segment : path.segments) box.extend(metres(segment.end));
    }
    PieceNotch notch{box.center(), std::nullopt};
    if (shape.use >= 0) {
      const SvgUse& use = drawing_.uses[static_cast<std::size_t>(shape.use)];
      notch.at = metres(use.at);
      // A sign that is not turned says nothing about a direction.
      if (std::abs(use.right.y()) > 1e-9 || use.right.x() < 0) {
        notch.angle = std::atan2(-use.right.y(), use.right.x());
      }
    } else if (shape.element == "line") {
      const Vec2 run = metres(end_of(shape.paths[0])) - metres(shape.paths[0].start);
      notch.angle = std::atan2(run.y(), run.x());
    }
    const bool is_notch = role == SvgRole::notch;
    const auto found = pieces_at(notch.at, part_of(shape.group), is_notch);
    if (found.empty())
      ignore(is_notch ? "notch away from the pieces" : "drill hole outside of the pieces");
    for (const int p : found) {
      Piece& piece = pieces_.pieces[static_cast<std::size_t>(p)];
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
    Piece& piece = pieces_.pieces[index];
    const std::string& own = outline_of(index).meaning.material;
    const bool of_own = !own.empty() && cutting.material == own;
    if (said_[index] && (!of_own || said_of_own_[index])) return;
    if (several_pieces && !piece.material.empty() && !cutting.material.empty() &&
        cutting.material != piece.material) {
      return;
    }
    said_[index] = true;
    said_of_own_[index] = of_own;
    piece.quantity = cutting.quantity.count;
    piece.pair = cutting.quantity.pair;
    const bool other = piece.material.empty() || piece.material == "fabric";
    if (of_own || (other && !cutting.material.empty())) piece.material = cutting.material;
    said_on_fold_[index] = cutting.on_fold;
  }

  /// Texts say names, numbers and materials.
  void texts() {
    texts_.resize(pieces_.pieces.size());
    first_text_.resize(pieces_.pieces.size());
    said_.resize(pieces_.pieces.size(), false);
    said_of_own_.resize(pieces_.pieces.size(), false);
    said_on_fold_.resize(pieces_.pieces.size(), false);
    for (const SvgText& text : drawing_.texts) {
      if (!text.on_path.empty()) continue;  // it says what a line is
      const int part = part_of(text.group);
      const Vec2 at = metres(text.at);
      std::vector<int> found;
      for (std::size_t p = 0; p < pieces_.pieces.size(); ++p) {
        const Outline& one = outline_of(p);
        if (one.part == part && (part >= 0 || inside(one.polygon, at))) {
          found.push_back(static_cast<int>(p));
        }
      }
      if (found.empty()) ignore("text outside of the pieces");
      const std::vector<CuttingText> cuttings = read_cuttings(text.text);
      for (const int p : found) {
        const auto index = static_cast<std::size_t>(p);
        texts_[index].add(text.text);
        const bool has_letter =
            std::any_of(text.text.begin(), text.text.end(),
                        [](unsigned char c) { return std::isalpha(c) != 0 || c >= 0x80; });
        if (has_letter && first_text_[index].empty()) first_text_[index] = text.text;
        for (const CuttingText& cutting : cuttings) take_cutting(cutting, index, found.size() > 1);
      }
    }
    for (std::size_t p = 0; p < pieces_.pieces.size(); ++p) {
      Piece& piece = pieces_.pieces[p];
      const auto quantity = texts_[p].quantity();
      if (quantity && !said_[p]) {
        piece.quantity = quantity->count;
        piece.pair = quantity->pair;
      }
      if (piece.material.empty()) piece.material = texts_[p].material();
      piece.size = texts_[p].value("size");
    }
  }

  void names() {
    std::map<int, int> pieces_in_group;
    for (std::size_t p = 0; p < pieces_.pieces.size(); ++p) {
      for (int group = shape_of(p).group; group >= 0;
           group = drawing_.groups[static_cast<std::size_t>(group)].parent) {
        ++pieces_in_group[group];
      }
    }
    std::map<int, std::vector<std::size_t>> of_part;
    for (std::size_t p = 0; p < pieces_.pieces.size(); ++p) {
      pieces_.pieces[p].name = name_of(p, pieces_in_group);
      if (outline_of(p).part >= 0) of_part[outline_of(p).part].push_back(p);
    }
    // What a part has besides its fabric is named after its material.
    for (const auto& [part, pieces] : of_part) {
      for (const std::size_t p : pieces) {
        Piece& piece = pieces_.pieces[p];
        if (pieces.size() > 1 && piece.material != "fabric" && !piece.material.empty()) {
          piece.name += "_" + piece.material;
        }
      }
    }
  }

  /// Names what is a half by its text only: where it is folded, a person has to say.
  void warn_of_folds() {
    for (std::size_t p = 0; p < pieces_.pieces.size(); ++p) {
      const Piece& piece = pieces_.pieces[p];
      if (!said_on_fold_[p] || piece.fold) continue;
      note("piece " + in_quotes(piece.name) +
               " is said to be cut on the fold, but has no fold line: it is taken as whole; "
               "--unfold or --pair makes more of it",
           true);
    }
  }

  const SvgShape& shape_of(std::size_t piece) {
    return drawing_.shapes[static_cast<std::size_t>(outline_of(piece).shape)];
  }

  std::string name_of(std::size_t p, const std::map<int, int>& pieces_in_group) {
    const int part = outline_of(p).part;
    if (part >= 0) {
      std::string name = freesewing_part_name(drawing_.groups[static_cast<std::size_t>(part)]);
      // Its sleeves are drawn with the front on the right side: seen from outside, the right one.
      pieces_.pieces[p].is_right_one = name.find("sleeve") != std::string::npos;
      return name;
    }
    if (const std::string named = texts_[p].value("piece name"); !named.empty()) return named;
    const SvgShape& shape = shape_of(p);
    if (!shape.label.empty()) return shape.label;
    if (!shape.title.empty()) return shape.title;
    if (!is_automatic_id(shape.id)) return shape.id;
    int group = shape.group;
    for (; group >= 0; group = drawing_.groups[static_cast<std::size_t>(group)].parent) {
      if (pieces_in_group.at(group) > 1) break;
      const SvgGroup& one = drawing_.groups[static_cast<std::size_t>(group)];
      if (!one.title.empty()) return one.title;
      if (!one.label.empty() && !is_automatic_id(one.label)) return one.label;
      if (!is_automatic_id(one.id)) return one.id;
    }
    if (!first_text_[p].empty()) return first_text_[p];
    return shape.id;
  }

  void check_sizes() {
    double largest = 0;
    for (std::size_t p = 0; p < pieces_.pieces.size(); ++p) {
      largest = std::max(largest, outline_of(p).box.sizes().maxCoeff());
    }
    UnitEvidence evidence;
    const double unit = options_.unit.value_or(scale_.x());
    (options_.unit ? evidence.asked : evidence.stated) = unit;
    evidence.stated_by = drawing_.physical ? "its width and viewBox" : "96 units an inch";
    evidence.largest = largest / unit;
    drawing_unit(evidence, pieces_.source, pieces_.remarks);
  }

  /// An outline that is a piece.
  struct Chosen {
    int outline = 0;  ///< index into outlines_
    bool is_cut_line = false;
  };
  struct OpenPath {
    PiecePath path;
    int shape = 0;
  };

  SvgDrawing drawing_;
  DrawingOptions options_;
  PieceDrawing pieces_;
  Vec2 scale_ = Vec2::Zero();
  std::vector<SvgMeaning> meanings_;  ///< of each shape
  bool classed_ = false;              ///< outlines are told by their classes
  std::vector<Outline> outlines_;
  std::vector<int> order_;      ///< of outlines_, the largest first
  std::vector<Chosen> chosen_;  ///< of each piece
  std::vector<OpenPath> open_;
  std::vector<int> lines_;   ///< shapes that are a grain or a fold
  std::vector<int> points_;  ///< shapes that are notches or drill holes
  std::vector<PieceTexts> texts_;
  std::vector<std::string> first_text_;
  std::vector<bool> said_;          ///< whether a text says how often a piece is cut
  std::vector<bool> said_on_fold_;  ///< whether that text says that it is cut on the fold
  std::vector<bool> said_of_own_;   ///< whether that text names the piece's own material
};

}  // namespace

PieceDrawing svg_pieces(std::string_view text, const std::string& source,
                        const DrawingOptions& options) {
  return Finder(text, source, options).find();
}

}  // namespace toile
