#include "pattern/import/piece_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/closest_points.h"
#include "geometry/error.h"
#include "geometry/inset_polygon.h"
#include "geometry/polygon.h"
#include "io/text.h"
#include "pattern/import/join_paths.h"
#include "pattern/import/weak_outline.h"

namespace toile {

namespace {

/// Metres: points of the outline that are nearer to the fold lie on it.
constexpr double fold_reach = 1e-3;

/// Metres: points of the outline on the fold are as near to it as others, but for this.
constexpr double fold_noise = 5e-5;

/// Metres: nearer points of an outline are one. Below, directions are noise.
constexpr double same_outline_point = 2e-5;

/// Metres: a declared corner is one of the outline if a point of it is nearer.
constexpr double declared_reach = 1e-3;

/// Metres: shorter chords say nothing of a direction.
constexpr double telling_chord = 5e-4;

/// Square metres: a smaller piece is a drawing error.
constexpr double min_piece_area = 1e-5;

/// Without points that repeat the one before them, and without spikes that go back on themselves.
std::vector<Vec2> cleaned(const std::vector<Vec2>& loop) {
  std::vector<Vec2> kept;
  for (const Vec2& point : loop) {
    if (kept.empty() || (point - kept.back()).norm() > same_outline_point) kept.push_back(point);
  }
  while (kept.size() > 1 && (kept.back() - kept.front()).norm() <= same_outline_point)
    kept.pop_back();
  return kept;
}

/// The notch where `change` takes it and the point one metre along it.
template <class Change>
PieceNotch changed_notch(PieceNotch notch, const Change& change) {
  if (notch.angle) {
    const Vec2 tip = notch.at + Vec2(std::cos(*notch.angle), std::sin(*notch.angle));
    const Vec2 along = change(tip) - change(notch.at);
    notch.angle = std::atan2(along.y(), along.x());
  }
  notch.at = change(notch.at);
  return notch;
}

template <class Change>
void change_points(PieceShape& shape, const Change& change) {
  const auto all = [&](std::vector<Vec2>& points) {
    for (Vec2& point : points) point = change(point);
  };
  all(shape.outline);
  all(shape.corners);
  for (PieceNotch& notch : shape.notches) notch = changed_notch(notch, change);
  for (auto& line : shape.internal_lines) all(line);
  for (auto& loop : shape.cut_outs) all(loop);
  all(shape.drill_holes);
  for (auto* line : {&shape.grain, &shape.fold}) {
    if (*line) *line = PieceLine{change((*line)->from), change((*line)->to)};
  }
}

/// The line on which a piece is folded.
struct FoldLine {
  Vec2 from;
  Vec2 across;  ///< unit vector square to it

  /// Metres from the line, signed.
  double side(const Vec2& point) const { return (point - from).dot(across); }
  bool holds(const Vec2& point) const { return std::abs(side(point)) <= fold_reach; }
  Vec2 onto(const Vec2& point) const { return point - side(point) * across; }
  Vec2 mirrored(const Vec2& point) const { return point - 2 * side(point) * across; }
};

/// The points of an outline that lie on its fold: `points` of them, those before `behind`.
struct FoldRun {
  std::size_t behind = 0;
  std::size_t points = 0;
};

/// `body`: the sign of the side on which the outline lies.
FoldRun find_fold_run(const std::vector<Vec2>& outline, const FoldLine& fold, double body,
                      const std::string& place) {
  const std::size_t count = outline.size();
  const auto on = [&](std::size_t i) { return fold.holds(outline[i % count]); };
  std::size_t runs = 0;
  FoldRun run;
  for (std::size_t i = 0; i < count; ++i) {
    if (on(i) && !on(i + 1)) {
      ++runs;
      run.behind = i + 1;
    }
  }
  if (runs > 0) {
    while (run.points < count && on(run.behind + count - 1 - run.points)) ++run.points;
  }
  if (runs == 0 || run.points < 2) {
    throw Error(place, "its outline does not run along its mirror line",
                "draw the mirror line on the edge where the piece is folded");
  }
  if (runs > 1) {
    throw Error(place,
                "its outline meets its mirror line in " + std::to_string(runs) +
                    " places, so that the whole would have holes, which are not cut",
                "take the mirror line out, and sew the half to a second one along it");
  }
  // A curve that leaves the fold gently is near it for a while: its points are not of the fold.
  double nearest = fold_reach;
  for (std::size_t i = 1; i <= run.points; ++i) {
    nearest = std::min(nearest, std::abs(fold.side(outline[(run.behind + count - i) % count])));
  }
  const auto leaves = [&](std::size_t i) {
    return body * fold.side(outline[i % count]) > nearest + fold_noise;
  };
  while (run.points > 2 && leaves(run.behind + count - 1)) {
    run.behind = (run.behind + count - 1) % count;
    --run.points;
  }
  while (run.points > 2 && leaves(run.behind + count - run.points)) --run.points;
  return run;
}

/// The outline and its mirror image, joined at the fold.
std::vector<Vec2> mirrored_outline(const std::vector<Vec2>& outline, const FoldLine& fold,
                                   const FoldRun& run) {
  const std::size_t count = outline.size();
  std::vector<Vec2> path;
  path.push_back(fold.onto(outline[(run.behind + count - 1) % count]));
  for (std::size_t i = 0; i < count - run.points; ++i) {
    path.push_back(outline[(run.behind + i) % count]);
  }
  path.push_back(fold.onto(outline[(run.behind + count - run.points) % count]));
  std::vector<Vec2> whole = path;
  for (std::size_t i = path.size() - 1; i-- > 1;) whole.push_back(fold.mirrored(path[i]));
  return cleaned(whole);
}

std::vector<Vec2> mirrored_points(const std::vector<Vec2>& points, const FoldLine& fold,
                                  bool keep_on_fold) {
  std::vector<Vec2> all;
  for (const Vec2& point : points) {
    const bool on_fold = fold.holds(point);
    if (!on_fold || keep_on_fold) all.push_back(point);
    if (!on_fold) all.push_back(fold.mirrored(point));
  }
  return all;
}

std::vector<std::vector<Vec2>> mirrored_lines(const std::vector<std::vector<Vec2>>& lines,
                                              const FoldLine& fold) {
  std::vector<std::vector<Vec2>> all;
  for (const std::vector<Vec2>& line : lines) {
    all.push_back(line);
    if (std::ranges::all_of(line, [&](const Vec2& point) { return fold.holds(point); })) continue;
    all.push_back(line);
    for (Vec2& point : all.back()) point = fold.mirrored(point);
  }
  return all;
}

/// Adds the mirror image of what is marked on the half.
void mirror_marks(const FoldLine& fold, PieceShape& shape) {
  shape.corners = mirrored_points(shape.corners, fold, false);
  shape.drill_holes = mirrored_points(shape.drill_holes, fold, true);
  std::vector<PieceNotch> notches;
  for (const PieceNotch& notch : shape.notches) {
    notches.push_back(notch);
    if (fold.holds(notch.at)) continue;
    notches.push_back(changed_notch(notch, [&](const Vec2& p) { return fold.mirrored(p); }));
  }
  shape.notches = std::move(notches);
  shape.internal_lines = mirrored_lines(shape.internal_lines, fold);
  shape.cut_outs = mirrored_lines(shape.cut_outs, fold);
}

/// Where point `i` of a counter-clockwise outline goes when its sides move inwards by `distance`.
Vec2 inset_point(const std::vector<Vec2>& outline, std::size_t i, double distance) {
  const std::size_t count = outline.size();
  const auto normal = [&](std::size_t step) -> Vec2 {
    Vec2 run = Vec2::Zero();
    for (std::size_t k = step; k != 0 && k != count && run.norm() < telling_chord;
         k = (k + step) % count) {
      run = outline[(i + k) % count] - outline[i];
    }
    if (step != 1) run = -run;
    return Vec2(-run.y(), run.x()).normalized();
  };
  const Vec2 both = normal(1) + normal(count - 1);
  // A spike's tip would go to infinity.
  return outline[i] + distance * both * (2 / std::max(both.squaredNorm(), 0.04));
}

}  // namespace

OutlinePlace nearest_place(const std::vector<Vec2>& outline, const Vec2& point) {
  OutlinePlace best;
  best.distance = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2& from = outline[i];
    const Vec2& to = outline[(i + 1) % outline.size()];
    const Vec2 at = from + closest_on_segment(point, from, to) * (to - from);
    const double distance = (point - at).norm();
    if (distance < best.distance) best = {i, at, distance};
  }
  return best;
}

std::vector<std::size_t> declared_points(const PieceShape& shape) {
  std::vector<std::size_t> points;
  points.reserve(shape.corners.size());
  for (const Vec2& corner : shape.corners) {
    const auto nearest = std::ranges::min_element(
        shape.outline, {}, [&](const Vec2& point) { return (point - corner).squaredNorm(); });
    if ((*nearest - corner).norm() > declared_reach) continue;
    points.push_back(static_cast<std::size_t>(nearest - shape.outline.begin()));
  }
  return points;
}

PieceShape shape_of(const Piece& piece, const std::string& place, double tolerance,
                    std::vector<Remark>& remarks) {
  PieceShape shape;
  shape.outline = cleaned(loop_points(piece.outline, tolerance));
  if (is_line(shape.outline)) {
    throw Error(place, "has no area", "remove it from the drawing, or draw its outline");
  }
  if (signed_area(shape.outline) < 0) std::reverse(shape.outline.begin(), shape.outline.end());
  PlainOutline plain = plain_outline(std::move(shape.outline));
  shape.outline = cleaned(plain.outline);
  if (const auto crossing = first_crossing(shape.outline)) {
    throw Error(place,
                "its outline crosses or touches itself at " +
                    millimetres_text(shape.outline[static_cast<std::size_t>((*crossing)[0])]),
                "draw it without the crossing");
  }
  if (signed_area(shape.outline) < min_piece_area) {
    throw Error(place, "has no area", "remove it from the drawing, or draw its outline");
  }
  shape.corners = piece.corners;
  shape.has_all_corners = piece.has_all_corners;
  shape.notches = piece.notches;
  shape.notches.insert(shape.notches.end(), plain.notches.begin(), plain.notches.end());
  shape.cut_outs = std::move(plain.holes);
  shape.internal_lines = std::move(plain.slashes);
  const auto note = [&](std::size_t count, const std::string& what) {
    if (count == 0) return;
    remarks.push_back({false, place + ": " + std::to_string(count) + what});
  };
  note(plain.notches.size(), " notches drawn in its outline are taken out of it, and are notches");
  note(shape.cut_outs.size(), " loops that a slit joins to its outline are cut-outs");
  note(shape.internal_lines.size(), " slits of its outline are internal lines");
  for (const PiecePath& path : piece.internal_lines) {
    shape.internal_lines.push_back(path_points(path, tolerance));
  }
  for (const PiecePath& path : piece.cut_outs) {
    std::vector<Vec2> loop = cleaned(loop_points(path, tolerance));
    if (loop.size() >= 3) shape.cut_outs.push_back(std::move(loop));
  }
  shape.drill_holes = piece.drill_holes;
  shape.grain = piece.grain;
  shape.fold = piece.fold;
  return shape;
}

PieceShape turned_shape(const PieceShape& shape, double angle) {
  PieceShape turned = shape;
  if (angle == 0) return turned;
  const Eigen::Rotation2Dd turn(angle);
  change_points(turned, [&](const Vec2& point) -> Vec2 { return turn * point; });
  return turned;
}

PieceShape mirrored_shape(const PieceShape& shape) {
  PieceShape mirrored = shape;
  change_points(mirrored, [](const Vec2& point) -> Vec2 { return {-point.x(), point.y()}; });
  std::reverse(mirrored.outline.begin(), mirrored.outline.end());
  return mirrored;
}

std::optional<PieceShape> unfolded_shape(const PieceShape& half, const PieceLine& fold,
                                         const std::string& place, std::vector<Remark>& remarks) {
  const Vec2 along = (fold.to - fold.from).normalized();
  if (!along.allFinite() || along.squaredNorm() < 0.5) {
    throw Error(place, "its mirror line has no length", "draw the line where the piece is folded");
  }
  const FoldLine line{fold.from, Vec2(-along.y(), along.x())};
  double min_side = std::numeric_limits<double>::max();
  double max_side = std::numeric_limits<double>::lowest();
  for (const Vec2& point : half.outline) {
    min_side = std::min(min_side, line.side(point));
    max_side = std::max(max_side, line.side(point));
  }
  if (min_side < -fold_reach && max_side > fold_reach) {
    remarks.push_back(
        {true, place + ": lies on both sides of its mirror line; it is taken as whole"});
    return std::nullopt;
  }
  const double body = max_side > -min_side ? 1 : -1;
  PieceShape whole = half;
  whole.outline =
      mirrored_outline(half.outline, line, find_fold_run(half.outline, line, body, place));
  if (first_crossing(whole.outline)) {
    throw Error(place, "crosses itself when it is unfolded", "check its mirror line");
  }
  mirror_marks(line, whole);
  return whole;
}

PieceShape without_allowance(const PieceShape& shape, double allowance, const std::string& place) {
  PieceShape inner = shape;
  const std::vector<std::vector<Vec2>> inset = inset_polygon(shape.outline, allowance);
  if (inset.size() != 1) {
    throw Error(place,
                inset.empty() ? "nothing is left of it without its seam allowance"
                              : "falls apart without its seam allowance",
                "check --seam-allowance");
  }
  inner.outline = cleaned(inset.front());
  if (inner.outline.size() < 3) {
    throw Error(place, "nothing is left of it without its seam allowance",
                "check --seam-allowance");
  }
  inner.corners.clear();
  for (const std::size_t i : declared_points(shape)) {
    const Vec2 at = inset_point(shape.outline, i, allowance);
    inner.corners.push_back(nearest_place(inner.outline, at).at);
  }
  return inner;
}

}  // namespace toile
