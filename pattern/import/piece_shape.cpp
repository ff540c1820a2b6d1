#include "pattern/import/piece_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/error.h"
#include "geometry/inset_polygon.h"
#include "geometry/polygon.h"
#include "io/text.h"
#include "pattern/import/join_paths.h"

namespace toile {

namespace {

/// Metres: points of the outline that are nearer to the fold lie on it.
constexpr double fold_reach = 1e-3;

/// Metres: points of the outline on the fold are as near to it as others, but for this.
constexpr double fold_noise = 5e-5;

/// Metres: nearer points of an outline are one. Below, directions are noise.
constexpr double same_outline_point = 2e-5;

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

template <class Change>
void change_points(PieceShape& shape, const Change& change) {
  const auto all = [&](std::vector<Vec2>& points) {
    for (Vec2& point : points) point = change(point);
  };
  all(shape.outline);
  all(shape.corners);
  for (PieceNotch& notch : shape.notches) {
    if (notch.angle) {
      const Vec2 tip = notch.at + Vec2(std::cos(*notch.angle), std::sin(*notch.angle));
      const Vec2 along = change(tip) - change(notch.at);
      notch.angle = std::atan2(along.y(), along.x());
    }
    notch.at = change(notch.at);
  }
  for (auto& line : shape.internal_lines) all(line);
  for (auto& loop : shape.cut_outs) all(loop);
  all(shape.drill_holes);
  if (shape.grain) shape.grain = PieceLine{change(shape.grain->from), change(shape.grain->to)};
}

}  // namespace

OutlinePlace nearest_place(const std::vector<Vec2>& outline, const Vec2& point) {
  OutlinePlace best;
  best.distance = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2& from = outline[i];
    const Vec2 along = outline[(i + 1) % outline.size()] - from;
    const double square = along.squaredNorm();
    const double share = square > 0 ? std::clamp((point - from).dot(along) / square, 0.0, 1.0) : 0;
    const Vec2 at = from + share * along;
    const double distance = (point - at).norm();
    if (distance < best.distance) best = {i, at, distance};
  }
  return best;
}

PieceShape shape_of(const Piece& piece, const std::string& place, double tolerance) {
  PieceShape shape;
  shape.outline = cleaned(loop_points(piece.outline, tolerance));
  if (shape.outline.size() < 3 || std::abs(signed_area(shape.outline)) < min_piece_area) {
    throw Error(place, "has no area", "remove it from the drawing, or draw its outline");
  }
  if (signed_area(shape.outline) < 0) std::reverse(shape.outline.begin(), shape.outline.end());
  if (const auto crossing = first_crossing(shape.outline)) {
    throw Error(place,
                "its outline crosses or touches itself at " +
                    millimetres_text(shape.outline[static_cast<std::size_t>((*crossing)[0])]),
                "draw it without the crossing");
  }
  shape.corners = piece.corners;
  shape.notches = piece.notches;
  for (const PiecePath& path : piece.internal_lines) {
    shape.internal_lines.push_back(path_points(path, tolerance));
  }
  for (const PiecePath& path : piece.cut_outs) {
    std::vector<Vec2> loop = cleaned(loop_points(path, tolerance));
    if (loop.size() >= 3) shape.cut_outs.push_back(std::move(loop));
  }
  shape.drill_holes = piece.drill_holes;
  shape.grain = piece.grain;
  return shape;
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
  const Vec2 across(-along.y(), along.x());
  const auto side = [&](const Vec2& point) { return (point - fold.from).dot(across); };
  const auto mirror = [&](const Vec2& point) -> Vec2 { return point - 2 * side(point) * across; };
  const std::size_t count = half.outline.size();
  double least = std::numeric_limits<double>::max();
  double most = std::numeric_limits<double>::lowest();
  for (const Vec2& point : half.outline) {
    least = std::min(least, side(point));
    most = std::max(most, side(point));
  }
  if (least < -fold_reach && most > fold_reach) {
    remarks.push_back(
        {true, place + ": lies on both sides of its mirror line; it is taken as whole"});
    return std::nullopt;
  }
  // The runs of points on the fold: there has to be one, of two points or more.
  const auto on = [&](std::size_t i) {
    return std::abs(side(half.outline[i % count])) <= fold_reach;
  };
  std::size_t runs = 0;
  std::size_t first_off = 0;  // the first point behind the run
  for (std::size_t i = 0; i < count; ++i) {
    if (on(i) && !on(i + 1)) {
      ++runs;
      first_off = i + 1;
    }
  }
  std::size_t run = 0;  // points of the run, backwards from first_off
  if (runs > 0) {
    while (run < count && on(first_off + count - 1 - run)) ++run;
  }
  if (runs == 0 || run < 2) {
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
  const double body = most > -least ? 1 : -1;
  double nearest = fold_reach;
  for (std::size_t i = 1; i <= run; ++i) {
    nearest = std::min(nearest, std::abs(side(half.outline[(first_off + count - i) % count])));
  }
  const auto leaves = [&](std::size_t i) {
    return body * side(half.outline[i % count]) > nearest + fold_noise;
  };
  while (run > 2 && leaves(first_off + count - 1)) {
    first_off = (first_off + count - 1) % count;
    --run;
  }
  while (run > 2 && leaves(first_off + count - run)) --run;
  const auto onto_fold = [&](const Vec2& point) -> Vec2 { return point - side(point) * across; };
  PieceShape whole = half;
  std::vector<Vec2> path;
  path.push_back(onto_fold(half.outline[(first_off + count - 1) % count]));
  for (std::size_t i = 0; i < count - run; ++i)
    path.push_back(half.outline[(first_off + i) % count]);
  path.push_back(onto_fold(half.outline[(first_off + count - run) % count]));
  whole.outline = path;
  for (std::size_t i = path.size() - 1; i-- > 1;) whole.outline.push_back(mirror(path[i]));
  whole.outline = cleaned(whole.outline);
  if (first_crossing(whole.outline)) {
    throw Error(place, "crosses itself when it is unfolded", "check its mirror line");
  }

  const auto both = [&](std::vector<Vec2>& points, bool keep_on_fold) {
    std::vector<Vec2> all;
    for (const Vec2& point : points) {
      if (std::abs(side(point)) <= fold_reach) {
        if (keep_on_fold) all.push_back(point);
        continue;
      }
      all.push_back(point);
      all.push_back(mirror(point));
    }
    points = std::move(all);
  };
  both(whole.corners, false);
  both(whole.drill_holes, true);
  whole.notches.clear();
  for (const PieceNotch& notch : half.notches) {
    whole.notches.push_back(notch);
    if (std::abs(side(notch.at)) <= fold_reach) continue;
    PieceNotch twin = notch;
    twin.at = mirror(notch.at);
    if (notch.angle) {
      const Vec2 tip = mirror(notch.at + Vec2(std::cos(*notch.angle), std::sin(*notch.angle)));
      twin.angle = std::atan2((tip - twin.at).y(), (tip - twin.at).x());
    }
    whole.notches.push_back(twin);
  }
  const auto mirror_all = [&](std::vector<std::vector<Vec2>>& lines) {
    std::vector<std::vector<Vec2>> all;
    for (const std::vector<Vec2>& line : lines) {
      const bool lies_on_fold = std::all_of(line.begin(), line.end(), [&](const Vec2& point) {
        return std::abs(side(point)) <= fold_reach;
      });
      all.push_back(line);
      if (lies_on_fold) continue;
      all.push_back(line);
      for (Vec2& point : all.back()) point = mirror(point);
    }
    lines = std::move(all);
  };
  mirror_all(whole.internal_lines);
  mirror_all(whole.cut_outs);
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
  // Declared corners and notches stand on the cut line: they go to the nearest place inwards.
  for (Vec2& corner : inner.corners) corner = nearest_place(inner.outline, corner).at;
  for (PieceNotch& notch : inner.notches) notch.at = nearest_place(inner.outline, notch.at).at;
  return inner;
}

}  // namespace toile
