#include "pattern/import/weak_outline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "geometry/angles.h"
#include "geometry/polygon.h"

namespace toile {

namespace {

/// Metres: points that are nearer touch, and a loop that is thinner on average bounds no cloth.
/// Slits of real files are up to 0.03 mm wide. Half and double of it read 58 drawings alike.
constexpr double touching = 1e-4;

/// Metres: shorter thin loops are noise; longer ones are notches up to the next constant, and
/// slashes beyond it. Slit notches are 3 to 10 mm deep: half of the latter makes slashes of some.
/// Half and double of the first, and double of the latter, read 58 drawings alike.
constexpr double shortest_slit = 1e-3;
constexpr double longest_notch = 0.015;

/// Metres: the mouth of a notch at most, and its depth. V and castle notches are 3 to 6 mm wide and
/// deep. Half of the first misses those of 5 mm. Double of it, and half and double of the others,
/// read 58 drawings alike.
constexpr double widest_mouth = 8e-3;
constexpr double least_depth = 2e-3;
constexpr double most_depth = 12e-3;

/// Share by which both sides of a notch may differ, and the outline's turn at its mouth. Half and
/// double of them read 58 drawings alike.
constexpr double notch_likeness = 0.3;
constexpr double mouth_turn = to_radians(20);

/// Loops that are taken off one outline at most.
constexpr int max_loops_taken = 100;

/// A place where the outline meets itself: the loop is the point `at`, then the points after `from`
/// up to `to`.
struct Touch {
  std::size_t from = 0;
  std::size_t to = 0;
  Vec2 at = Vec2::Zero();
};

/// Two points of the outline that are one, with as few as possible in between.
std::optional<Touch> touching_points(const std::vector<Vec2>& outline) {
  using Cell = std::pair<std::int64_t, std::int64_t>;
  const auto cell_of = [](const Vec2& point) -> Cell {
    return {static_cast<std::int64_t>(std::floor(point.x() / touching)),
            static_cast<std::int64_t>(std::floor(point.y() / touching))};
  };
  std::map<Cell, std::vector<std::size_t>> cells;
  std::optional<Touch> best;
  std::size_t fewest = outline.size();
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Cell cell = cell_of(outline[k]);
    for (std::int64_t x = cell.first - 1; x <= cell.first + 1; ++x) {
      for (std::int64_t y = cell.second - 1; y <= cell.second + 1; ++y) {
        const auto found = cells.find({x, y});
        if (found == cells.end()) continue;
        for (const std::size_t i : found->second) {
          const std::size_t between = std::min(k - i, outline.size() - (k - i));
          if (between < 2 || between >= fewest) continue;
          if ((outline[i] - outline[k]).norm() > touching) continue;
          fewest = between;
          best = Touch{i, k - 1, outline[i]};
        }
      }
    }
    cells[cell].push_back(k);
  }
  return best;
}

/// Where segments `a` and `b` of the outline meet.
Touch crossing_point(const std::vector<Vec2>& outline, std::size_t a, std::size_t b) {
  if (a > b) std::swap(a, b);
  const std::size_t count = outline.size();
  const auto at = [&](std::size_t i) -> const Vec2& { return outline[i % count]; };
  const Vec2 first = at(a + 1) - at(a);
  const Vec2 second = at(b + 1) - at(b);
  const double cross = first.x() * second.y() - first.y() * second.x();
  if (std::abs(cross) > 1e-9 * first.norm() * second.norm() && b != a + 1) {
    const Vec2 arm = at(b) - at(a);
    const double share = (arm.x() * second.y() - arm.y() * second.x()) / cross;
    return {a, b, at(a) + std::clamp(share, 0.0, 1.0) * first};
  }
  // They lie on each other: the end that is nearest to the other segment.
  Touch touch{a, b, at(a)};
  double least = 1;
  const auto offer = [&](const Vec2& point, const Vec2& from, const Vec2& to) {
    const double off = distance_to_segment(point, from, to);
    if (off >= least) return;
    least = off;
    touch.at = point;
  };
  offer(at(a), at(b), at(b + 1));
  offer(at(b + 1), at(a), at(a + 1));
  if (b != a + 1) {
    offer(at(a + 1), at(b), at(b + 1));
    offer(at(b), at(a), at(a + 1));
  }
  return touch;
}

double perimeter(const std::vector<Vec2>& loop) {
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    length += (loop[(i + 1) % loop.size()] - loop[i]).norm();
  }
  return length;
}

PieceNotch notch_towards(const Vec2& mouth, const Vec2& tip) {
  return {mouth, std::atan2(tip.y() - mouth.y(), tip.x() - mouth.x())};
}

/// Takes off one loop. False: it is cloth, and the outline crosses itself.
bool take_loop(PlainOutline& plain, const Touch& touch) {
  const std::vector<Vec2>& all = plain.outline;
  const auto place = [&](std::size_t i) { return all.begin() + static_cast<std::ptrdiff_t>(i); };
  std::vector<Vec2> loop = {touch.at};
  loop.insert(loop.end(), place(touch.from + 1), place(touch.to + 1));
  std::vector<Vec2> rest(all.begin(), place(touch.from + 1));
  if ((rest.back() - touch.at).norm() > touching) rest.push_back(touch.at);
  const std::size_t next = touch.to + 1;
  const bool same = next < all.size() && (all[next] - touch.at).norm() <= touching;
  rest.insert(rest.end(), place(std::min(all.size(), next + (same ? 1 : 0))), all.end());
  if (std::abs(signed_area(loop)) > std::abs(signed_area(rest))) std::swap(loop, rest);
  if (rest.size() < 3) return false;
  const double area = signed_area(loop);
  const Vec2 tip = *std::ranges::max_element(
      loop, {}, [&](const Vec2& point) { return (point - touch.at).norm(); });
  if (std::abs(area) <= touching * perimeter(loop) / 2) {
    const double depth = (tip - touch.at).norm();
    const bool to_hole = std::ranges::any_of(plain.holes, [&](const std::vector<Vec2>& hole) {
      return std::ranges::any_of(
          hole, [&](const Vec2& point) { return (point - tip).norm() <= 2 * touching; });
    });
    if (depth > shortest_slit && !to_hole) {
      if (depth <= longest_notch) {
        plain.notches.push_back(notch_towards(touch.at, tip));
      } else {
        plain.slashes.push_back({touch.at, tip});
      }
    }
  } else if (area * signed_area(rest) < 0 && inside(rest, tip)) {
    plain.holes.push_back(loop);
  } else {
    return false;
  }
  plain.outline = std::move(rest);
  return true;
}

bool are_alike(double a, double b) {
  return std::abs(a - b) <= notch_likeness * std::max(std::abs(a), std::abs(b));
}

double turn_between(const Vec2& from, const Vec2& to) {
  return std::abs(std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to)));
}

/// Whether the points after `first` and before the one `steps` on are a notch: one is a V, two are
/// a castle.
bool is_notch(const std::vector<Vec2>& outline, std::size_t first, std::size_t steps) {
  const std::size_t count = outline.size();
  const auto at = [&](std::size_t i) -> const Vec2& { return outline[(first + i) % count]; };
  const Vec2 mouth = at(steps) - at(0);
  const double width = mouth.norm();
  if (width > widest_mouth) return false;
  const Vec2 in = at(0) - at(count - 1);
  const Vec2 out = at(steps + 1) - at(steps);
  // The mouth of a slit is too narrow for a direction.
  const Vec2 along =
      (width < touching ? Vec2(in.normalized() + out.normalized()) : mouth).normalized();
  if (turn_between(in, along) > mouth_turn || turn_between(along, out) > mouth_turn) return false;
  double depths[2] = {0, 0};
  for (std::size_t i = 1; i < steps; ++i) {
    const Vec2 arm = at(i) - at(0);
    depths[i - 1] = along.x() * arm.y() - along.y() * arm.x();
    const double depth = std::abs(depths[i - 1]);
    if (depth < least_depth || depth > most_depth) return false;
  }
  return are_alike((at(1) - at(0)).norm(), (at(steps) - at(steps - 1)).norm()) &&
         (steps == 2 ||
          (are_alike(depths[0], depths[1]) && are_alike((at(2) - at(1)).norm(), width)));
}

void take_notches(PlainOutline& plain) {
  std::vector<Vec2>& outline = plain.outline;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    for (const std::size_t steps : {2U, 3U}) {
      const std::size_t count = outline.size();
      if (count < steps + 4 || !is_notch(outline, i, steps)) continue;
      const Vec2 mouth = (outline[i] + outline[(i + steps) % count]) / 2;
      const Vec2 tip = (outline[(i + 1) % count] + outline[(i + steps - 1) % count]) / 2;
      plain.notches.push_back(notch_towards(mouth, tip));
      std::rotate(outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(i), outline.end());
      outline.erase(outline.begin() + 1, outline.begin() + static_cast<std::ptrdiff_t>(steps));
      i = 0;
      break;
    }
  }
}

}  // namespace

PlainOutline plain_outline(std::vector<Vec2> outline) {
  PlainOutline plain;
  plain.outline = std::move(outline);
  for (int taken = 0; taken < max_loops_taken; ++taken) {
    const auto crossing = first_crossing(plain.outline);
    if (!crossing) break;
    auto touch = touching_points(plain.outline);
    if (!touch) {
      touch = crossing_point(plain.outline, static_cast<std::size_t>((*crossing)[0]),
                             static_cast<std::size_t>((*crossing)[1]));
    }
    if (!take_loop(plain, *touch)) break;
  }
  take_notches(plain);
  return plain;
}

}  // namespace toile
