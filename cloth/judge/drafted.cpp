#include "cloth/judge/drafted.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "cloth/ease/figure_errors.h"
#include "cloth/judge/constants.h"
#include "geometry/body/torso_section.h"
#include "geometry/slice.h"

namespace toile {

namespace {

/// Metres from the side of the neck toward the shoulder at which lengths are taken, clear of the
/// neckline. Half and double were not tried.
constexpr double beside_neck = 0.01;

/// Metres by which front and back of a hem that is meant level may be drafted apart. Those of the
/// sample T-shirt, which has no bust dart, are 4 cm apart. Half and double were not tried.
constexpr double meant_level = 0.05;

/// Metres above the floor below which the body does not hold cloth off: feet. Half and double were
/// not tried.
constexpr double above_feet = 0.12;

/// A worn line down one face, from its highest point: where it ends, and its length on the flat
/// panels. Metres.
struct Fall {
  Vec3 top;
  Vec3 end;
  double length = 0;
};

class ShoulderHung {
 public:
  ShoulderHung(const DressedGarment& dressed, const TriangleMesh& body)
      : dressed_(dressed), body_(body) {}

  /// Metres that the hem hangs higher than drafted, at the plane of a given x. None: the cloth does
  /// not join the hem to the top.
  std::optional<double> hem_risen(double x) const {
    const std::optional<Fall> back = fall_at(x, false);
    const std::optional<Fall> front = fall_at(x, true);
    if (!back || !front) return std::nullopt;
    const std::vector<Vec3> outline = outline_at(x);
    double back_end = hangs_to(outline, back->top, back->length, -1);
    double front_end = hangs_to(outline, front->top, front->length, 1);
    if (std::abs(back_end - front_end) < meant_level) {
      back_end = front_end = std::max(back_end, front_end);
    }
    return (back->end.y() - back_end + front->end.y() - front_end) / 2;
  }

 private:
  /// The line from its highest point down one face.
  std::optional<Fall> fall_at(double x, bool front) const {
    ClothPath highest;
    std::size_t top = 0;
    Fall fall;
    fall.top.y() = -std::numeric_limits<double>::infinity();
    for (ClothPath& path : paths_on_plane(dressed_, {{x, 0, 0}, Vec3::UnitX()})) {
      const auto at =
          std::ranges::max_element(path, {}, [](const PathStep& step) { return step.worn_to.y(); });
      if (at == path.end() || at->worn_to.y() <= fall.top.y()) continue;
      fall.top = at->worn_to;
      top = static_cast<std::size_t>(at - path.begin()) + 1;
      highest = std::move(path);
    }
    if (highest.empty()) return std::nullopt;
    // The way that leads down the front is that to the end which lies farther in front.
    const bool forward = highest.back().worn_to.z() > highest.front().worn_from.z();
    if (forward != front) {
      highest = reversed(highest);
      top = highest.size() - top;
    }
    if (top >= highest.size()) return std::nullopt;
    fall.end = highest.back().worn_to;
    highest.erase(highest.begin(), highest.begin() + static_cast<std::ptrdiff_t>(top));
    fall.length = flat_length(highest);
    return fall;
  }

  /// The body's points at a plane, from the top down, without its feet.
  std::vector<Vec3> outline_at(double x) const {
    std::vector<Vec3> outline;
    for (const Section& section : slice(body_, {x, 0, 0}, Vec3::UnitX())) {
      std::ranges::copy_if(section.points, std::back_inserter(outline),
                           [](const Vec3& p) { return p.y() > above_feet; });
    }
    std::ranges::sort(outline, std::ranges::greater{}, [](const Vec3& p) { return p.y(); });
    return outline;
  }

  /// The height to which a taut thread of that length comes down from a point, on the front (`side`
  /// 1) or the back (-1) of the outline. It bridges what is hollow, and hangs straight from what
  /// stands out the most.
  static double hangs_to(const std::vector<Vec3>& outline, const Vec3& from, double length,
                         double side) {
    std::vector<Vec2> hull = {Vec2(side * from.z(), from.y())};
    const auto lowest = [&] {
      double left = length;
      for (std::size_t i = 1; i < hull.size(); ++i) left -= (hull[i] - hull[i - 1]).norm();
      return hull.back().y() - left;
    };
    for (const Vec3& point : outline) {
      const Vec2 p(side * point.z(), point.y());
      if (p.y() >= from.y() || p.x() <= hull.back().x()) continue;
      if (p.y() < lowest()) break;  // the thread does not get there
      while (hull.size() > 1) {
        const Vec2 a = hull[hull.size() - 1] - hull[hull.size() - 2];
        const Vec2 b = p - hull[hull.size() - 2];
        if (a.x() * b.y() - a.y() * b.x() <= 0) break;
        hull.pop_back();
      }
      hull.push_back(p);
    }
    return lowest();
  }

  const DressedGarment& dressed_;
  const TriangleMesh& body_;
};

/// The x at which the neckline is the widest on both sides, a little outward. Empty: it has none.
std::vector<double> sides_of_neck(const DressedGarment& dressed,
                                  const std::vector<GarmentLevel>& levels) {
  const auto neckline = std::ranges::find(levels, "neckline", &GarmentLevel::name);
  if (neckline == levels.end()) return {};
  const auto [right, left] =
      std::ranges::minmax(neckline->nodes, {}, [&](int node) { return dressed.points[node].x(); });
  return {dressed.points[right].x() - beside_neck, dressed.points[left].x() + beside_neck};
}

}  // namespace

std::vector<double> start_heights(const PanelMesh& pattern, const DressedGarment& dressed) {
  std::vector<double> heights(dressed.points.size(), 0);
  std::vector<int> corners(dressed.points.size(), 0);
  for (std::size_t t = 0; t < dressed.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const int node = dressed.triangles[t][i];
      const double height = pattern.placed[pattern.triangles[t][i]].y();
      heights[node] += (height - heights[node]) / ++corners[node];
    }
  }
  return heights;
}

double came_down_at_centre(const std::vector<int>& loop, const std::vector<double>& starts,
                           const DressedGarment& dressed, double middle) {
  const auto came_down = [&](int node) { return starts[node] - dressed.points[node].y(); };
  double sum = 0;
  int crossings = 0;
  double mean = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const int from = loop[i];
    const int to = loop[(i + 1) % loop.size()];
    mean += came_down(from) / static_cast<double>(loop.size());
    const double a = dressed.points[from].x() - middle;
    const double b = dressed.points[to].x() - middle;
    if ((a >= 0) == (b >= 0)) continue;
    sum += came_down(from) + a / (a - b) * (came_down(to) - came_down(from));
    ++crossings;
  }
  return crossings > 1 ? sum / crossings : mean;
}

bool left_its_place(const GarmentLevel& level, double height_error) {
  return level.drafted_body &&
         std::abs(*level.risen()) >= std::max(worth_saying_slid, height_error);
}

void set_drafted(const PanelMesh& pattern, const DressedGarment& dressed, const TriangleMesh& body,
                 const Skeleton& skeleton, std::vector<Girth>& girths,
                 std::vector<GarmentLevel>& levels) {
  const std::vector<double> starts = start_heights(pattern, dressed);
  const auto girth_at = [&](double height) -> std::optional<double> {
    if (height <= skeleton.joint("pelvis").y() || height >= skeleton.joint("chest").y()) return {};
    const std::optional<Section> torso = torso_section(body, height);
    return torso ? std::optional<double>(torso->girth) : std::nullopt;
  };
  for (Girth& girth : girths) {
    if (!girth.is_of_trunk) continue;
    double height = 0;
    for (const int t : girth.triangles) {
      for (const int node : dressed.triangles[t]) height += starts[node];
    }
    girth.drafted_body = girth_at(height / (3.0 * static_cast<double>(girth.triangles.size())));
  }
  const double middle = skeleton.joint("pelvis").x();
  const std::vector<double> sides = sides_of_neck(dressed, levels);
  const ShoulderHung hung(dressed, body);
  const bool has_seam =
      std::ranges::find(levels, "waist seam", &GarmentLevel::name) != levels.end();
  for (GarmentLevel& level : levels) {
    if (sides.empty() && level.name == "top edge") {
      level.drafted = level.height + came_down_at_centre(level.nodes, starts, dressed, middle);
    } else if (level.name == "hem" && !has_seam) {
      double sum = 0;
      int found = 0;
      for (const double x : sides) {
        const std::optional<double> here = hung.hem_risen(x);
        if (!here) continue;
        sum += *here;
        ++found;
      }
      if (found > 0) level.drafted = level.height - sum / found;
    }
    if (level.name == "waist seam") level.waist = girth_at(skeleton.joint("waist").y());
    if (level.drafted) level.drafted_body = girth_at(*level.drafted);
    if (!level.drafted_body) continue;
    for (const double height : {*level.drafted - drafted_error, *level.drafted + drafted_error}) {
      const double differs = std::abs(girth_at(height).value_or(0) - *level.drafted_body);
      if (differs < *level.drafted_body) {
        level.drafted_body_error = std::max(level.drafted_body_error, differs);
      }
    }
  }
}

}  // namespace toile
