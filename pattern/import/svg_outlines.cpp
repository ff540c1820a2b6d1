#include "pattern/import/svg_outlines.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "geometry/error.h"
#include "geometry/polygon.h"
#include "io/json_words.h"
#include "io/limits.h"
#include "pattern/constants.h"
#include "pattern/import/join_paths.h"
#include "pattern/import/sew_line.h"

namespace toile {

namespace {

/// Closed paths of a drawing at most: they are compared with each other.
constexpr std::size_t max_closed_paths = 20'000;

class OutlineFinder {
 public:
  explicit OutlineFinder(SvgSheet& sheet) : sheet_(sheet) {}

  SvgOutlines find() {
    collect();
    nest();
    choose();
    return std::move(found_);
  }

 private:
  PiecePath to_metres(const DrawnPath& path) const {
    PiecePath curves;
    Vec2 from = sheet_.metres(path.start);
    for (const DrawnSegment& segment : path.segments) {
      const Vec2 to = sheet_.metres(segment.end);
      for (const double value : {to.x(), to.y()}) {
        const std::string problem = coordinate_problem(value, max_metres);
        if (!problem.empty()) throw Error(sheet_.pieces.source, problem, coordinate_remedy);
      }
      if (!segment.curved) {
        if (from != to) curves.push_back(EdgeCurve::line(from, to));
      } else {
        curves.push_back(EdgeCurve::cubic(from, sheet_.metres(segment.control1),
                                          sheet_.metres(segment.control2), to));
      }
      from = to;
    }
    return curves;
  }

  /// Sorts all shapes by what they are. Loose lines are joined.
  void collect() {
    for (std::size_t s = 0; s < sheet_.drawing.shapes.size(); ++s) {
      SvgMeaning meaning = meaning_of(sheet_.drawing, sheet_.drawing.shapes[s]);
      found_.classed = found_.classed || meaning.role == SvgRole::outline ||
                       (meaning.role == SvgRole::allowance && !meaning.material.empty());
      sheet_.meanings.push_back(std::move(meaning));
    }
    leave_out_unreadable();
    // What is loose is joined with what has the same meaning, in the same group.
    using Key = std::tuple<int, SvgRole, std::string>;
    std::map<Key, std::vector<int>> loose;
    for (std::size_t s = 0; s < sheet_.drawing.shapes.size(); ++s) {
      const SvgShape& shape = sheet_.drawing.shapes[s];
      const SvgMeaning& meaning = sheet_.meanings[s];
      switch (meaning.role) {
        case SvgRole::unseen:
          continue;
        case SvgRole::remark:
          sheet_.ignore(meaning.what);
          continue;
        case SvgRole::grain:
        case SvgRole::fold:
          found_.marked_lines.push_back(static_cast<int>(s));
          continue;
        case SvgRole::notch:
        case SvgRole::drill_hole:
          if (is_mark(shape)) {
            found_.marked_points.push_back(static_cast<int>(s));
            continue;
          }
          sheet_.meanings[s] = {};  // a piece that is named after its notches
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
        loose[{shape.group, sheet_.meanings[s].role, sheet_.meanings[s].material}].push_back(
            static_cast<int>(s));
      }
    }
    for (const auto& [key, shapes] : loose) join(shapes);
    if (found_.all.size() > max_closed_paths) {
      throw Error(sheet_.pieces.source,
                  "has " + std::to_string(found_.all.size()) + " closed paths, more than 20,000",
                  "is it really a pattern?");
    }
  }

  /// Refuses outlines and folds that can't be read. Other lines are counted, and the first is
  /// named.
  void leave_out_unreadable() {
    for (std::size_t s = 0; s < sheet_.drawing.shapes.size(); ++s) {
      const SvgShape& shape = sheet_.drawing.shapes[s];
      if (!shape.unreadable) continue;
      const SvgRole role = sheet_.meanings[s].role;
      const bool can_be_outline =
          role == SvgRole::unknown && !(is_freesewing(sheet_.drawing) && is_freesewing_mark(shape));
      if (can_be_outline || role == SvgRole::outline) {
        sheet_.pieces.left_out.push_back({shape.id, "", *shape.unreadable});
        continue;
      }
      if (role == SvgRole::allowance || role == SvgRole::cut_out || role == SvgRole::fold) {
        throw Error(*shape.unreadable);
      }
      const std::string what = "line that can't be read";
      if (sheet_.pieces.ignored.count(what) == 0) {
        sheet_.pieces.remarks.push_back(
            {false, std::string(shape.unreadable->what()) + "; it is no outline, and left out"});
      }
      sheet_.ignore(what);
      sheet_.meanings[s].role = SvgRole::unseen;
    }
  }

  bool is_mark(const SvgShape& shape) const {
    if (shape.use >= 0) return true;
    Eigen::AlignedBox2d box;
    for (const DrawnPath& path : shape.paths) {
      box.extend(sheet_.metres(path.start));
      for (const DrawnSegment& segment : path.segments) box.extend(sheet_.metres(segment.end));
    }
    return box.sizes().prod() < smallest_piece;
  }

  void add_closed(PiecePath path, int shape) {
    SvgOutline outline;
    outline.polygon = loop_points(path, place_tolerance);
    if (outline.polygon.size() < 3) return;
    outline.path = std::move(path);
    for (const Vec2& point : outline.polygon) outline.box.extend(point);
    outline.area = std::abs(signed_area(outline.polygon));
    outline.shape = shape;
    outline.meaning = sheet_.meanings[static_cast<std::size_t>(shape)];
    outline.part = sheet_.part_of(sheet_.drawing.shapes[static_cast<std::size_t>(shape)].group);
    found_.all.push_back(std::move(outline));
  }

  /// Joins the loose paths of some shapes to outlines and lines.
  void join(const std::vector<int>& shapes) {
    std::vector<PiecePath> paths;
    std::map<std::pair<double, double>, int> shape_at;
    for (const int s : shapes) {
      for (const DrawnPath& path : sheet_.drawing.shapes[static_cast<std::size_t>(s)].paths) {
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
      sheet_.note("gaps of up to " + number_text(joined.widest_closed_gap * 1000, 2) +
                  " mm in outlines are closed");
    }
    for (PiecePath& path : joined.closed) add_closed(path, shape_of(path));
    for (PiecePath& path : joined.open) {
      const int shape = shape_of(path);
      found_.open.push_back({std::move(path), shape});
    }
  }

  /// Which outline lies in which.
  void nest() {
    std::vector<int> by_area(found_.all.size());
    for (std::size_t i = 0; i < by_area.size(); ++i) by_area[i] = static_cast<int>(i);
    std::stable_sort(by_area.begin(), by_area.end(),
                     [&](int a, int b) { return outline(a).area > outline(b).area; });
    for (std::size_t i = 0; i < by_area.size(); ++i) {
      SvgOutline& one = outline(by_area[i]);
      const std::vector<Vec2> points = spread_points(one.polygon, 40, true);
      for (std::size_t k = i; k-- > 0 && one.around < 0;) {
        const SvgOutline& other = outline(by_area[k]);
        // Parts of FreeSewing may lie on each other.
        if (other.part != one.part || !other.box.contains(one.box.center())) continue;
        // Doubled paths are no piece in a piece.
        if (holds(other, points)) one.around = by_area[k];
      }
    }
    order_ = std::move(by_area);
  }

  SvgOutline& outline(int index) { return found_.all[static_cast<std::size_t>(index)]; }

  /// Which outlines are pieces. The larger ones come first, so what is around one is decided.
  void choose() {
    for (const int index : order_) {
      SvgOutline& one = outline(index);
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
          if (!found_.classed && !lies_in_piece(one, false)) choose_plain(index);
      }
    }
    choose_of_parts();
    std::stable_sort(found_.chosen.begin(), found_.chosen.end(),
                     [&](const SvgOutlines::Chosen& a, const SvgOutlines::Chosen& b) {
                       return outline(a.outline).shape < outline(b.outline).shape;
                     });
    if (!found_.chosen.empty()) return;
    if (!sheet_.pieces.left_out.empty()) throw Error(sheet_.pieces.left_out.front().error);
    std::string remedy = "join the ends of its lines, or close the path";
    PathGap gap = widest_open();
    throw Error(sheet_.pieces.source,
                gap.size > 0 ? "holds no closed outline; the longest line is open by " +
                                   number_text(gap.size * 1000) + " mm at " + sheet_.where(gap.at)
                             : "holds no closed outline",
                remedy);
  }

  /// FreeSewing's parts whose seam lines have no class of a material, such as ribbing: each one's
  /// largest outline without a class is a piece.
  void choose_of_parts() {
    if (!found_.classed) return;
    std::set<int> with_piece;
    for (const SvgOutline& one : found_.all) {
      if (one.of_piece) with_piece.insert(one.part);
    }
    for (const int index : order_) {
      const SvgOutline& one = outline(index);
      if (one.area < smallest_piece) break;
      if (one.part < 0 || one.meaning.role != SvgRole::unknown) continue;
      if (with_piece.insert(one.part).second) choose_outline(index, false);
    }
  }

  /// A cut line is a piece where no seam line lies in it, or the user asks for it.
  void choose_allowance(int index) {
    if (!sheet_.options.cut_line) {
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
    const int seam = sheet_.options.cut_line ? -1 : seam_line_within(index);
    if (seam < 0) {
      choose_outline(index, false);
      return;
    }
    sheet_.note("the paths at " + sheet_.where(outline(index).polygon[0]) +
                " run along each other: the inner one is taken as the seam line");
    choose_outline(seam, false);
    outline(index).of_piece = true;
  }

  /// The opening of the longest open path.
  PathGap widest_open() const {
    PathGap gap;
    double longest = 0;
    for (const SvgLine& open : found_.open) {
      const double length = path_length(open.path);
      if (length <= longest) continue;
      longest = length;
      const Vec2& from = open.path.front().start();
      const Vec2& to = open.path.back().end();
      gap = {(to - from).norm(), (from + to) / 2};
    }
    return gap;
  }

  bool lies_in_piece(const SvgOutline& one, bool of_same_material) {
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
    const SvgOutline& cut = outline(index);
    return std::any_of(found_.all.begin(), found_.all.end(), [&](const SvgOutline& other) {
      if (&other == &cut || other.meaning.role == SvgRole::allowance || other.part != cut.part ||
          other.area < smallest_piece) {
        return false;
      }
      if (found_.classed && other.meaning.material != cut.meaning.material) {
        // The class of an allowance may lack the material, or say that of another part.
        return other.meaning.role == SvgRole::outline && runs_along(cut.polygon, other.path);
      }
      // A pocket that is drawn in a part is none, though its class is that of the allowance.
      return (cut.part >= 0 || other.around == index) && can_be_sew_line(cut.polygon, other.path);
    });
  }

  /// In a drawing with classes, the outline without one that the cut line runs along; -1: none.
  int unclassed_seam_line(int index) {
    const SvgOutline& cut = outline(index);
    const auto found = std::find_if(order_.begin(), order_.end(), [&](int i) {
      const SvgOutline& other = outline(i);
      return found_.classed && other.part == cut.part && other.meaning.role == SvgRole::unknown &&
             other.area >= smallest_piece && runs_along(cut.polygon, other.path);
    });
    return found == order_.end() ? -1 : *found;
  }

  /// The outline that runs along the inside of another one; -1: none.
  int seam_line_within(int index) {
    const SvgOutline& cut = outline(index);
    const auto found = std::find_if(order_.begin(), order_.end(), [&](int i) {
      const SvgOutline& inner = outline(i);
      return inner.around == index && inner.shape != cut.shape &&
             runs_along(cut.polygon, inner.path);
    });
    return found == order_.end() ? -1 : *found;
  }

  void choose_outline(int index, bool is_cut_line) {
    if (found_.chosen.size() >= static_cast<std::size_t>(max_panels)) {
      throw Error(sheet_.pieces.source,
                  "has more than " + std::to_string(max_panels) + " closed outlines",
                  "is it really a pattern?");
    }
    found_.chosen.push_back({index, is_cut_line});
    outline(index).of_piece = true;
  }

  SvgSheet& sheet_;
  SvgOutlines found_;
  std::vector<int> order_;  ///< of all outlines, the largest first
};

}  // namespace

void SvgSheet::note(const std::string& text, bool warning) {
  pieces.remarks.push_back({warning, pieces.source + ": " + text});
}

std::string SvgSheet::where(const Vec2& point) const {
  return "(" + number_text(point.x() / scale.x()) + ", " + number_text(-point.y() / scale.y()) +
         ")";
}

int SvgSheet::part_of(int group) const {
  return is_freesewing(drawing) ? freesewing_part(drawing, group) : -1;
}

double distance_to_polygon(const std::vector<Vec2>& polygon, const Vec2& point) {
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    least =
        std::min(least, distance_to_segment(point, polygon[i], polygon[(i + 1) % polygon.size()]));
  }
  return least;
}

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

bool holds(const SvgOutline& outline, const std::vector<Vec2>& points) {
  return std::all_of(points.begin(), points.end(), [&](const Vec2& point) {
    return outline.box.exteriorDistance(point) <= max_outline_gap &&
           (inside(outline.polygon, point) ||
            distance_to_polygon(outline.polygon, point) <= max_outline_gap);
  });
}

SvgOutlines find_outlines(SvgSheet& sheet) { return OutlineFinder(sheet).find(); }

}  // namespace toile
