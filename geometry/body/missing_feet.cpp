#include "geometry/body/missing_feet.h"

#include <algorithm>
#include <cmath>

#include "geometry/body/centreline.h"

namespace toile {

namespace {

// Shares of the height.
constexpr double foot_height = 0.04;  // up to there above the leg's end a foot is looked for
constexpr double shin_above = 0.1;    // the shin, above the leg's end
// Feet are 2.2 to 3.2 times as long as the shin is deep, ends of cut legs 0.7 to 1.3 times. At half
// of it each cut leg has a foot, at double hardly any does.
constexpr double least_ratio = 1.5;
constexpr double lifted = 0.02;  // a leg that ends higher does not stand

struct Leg {
  bool has_foot = true;
  double end = 0;  ///< metres above the floor
};

Leg leg_below(const TriangleMesh& body, const Vec3& knee, double height) {
  WalkOptions options;
  options.step = height / 200;
  options.min_area = 3.5e-4 * height * height;  // as where legs are looked for
  options.reach = 0.05 * height;
  options.length = height;
  const std::vector<Station> leg = walk_level(body, knee, 0, options);
  if (leg.empty()) return {};
  const double end = leg.back().along;
  double foot = 0;
  double shin = widest_chord(leg.front().section);
  for (const Station& station : leg) {
    if (station.along < end + foot_height * height)
      foot = std::max(foot, widest_chord(station.section));
    if (station.along > end + shin_above * height) shin = widest_chord(station.section);
  }
  return {foot > least_ratio * shin, end};
}

}  // namespace

std::vector<std::string> missing_feet(const TriangleMesh& body, const Skeleton& skeleton) {
  double height = 0;
  for (const Vec3& point : body.points) height = std::max(height, point.y());
  if (!skeleton.joints.contains("left_knee") || !skeleton.joints.contains("right_knee")) return {};
  const Leg left = leg_below(body, skeleton.joint("left_knee"), height);
  const Leg right = leg_below(body, skeleton.joint("right_knee"), height);
  const auto is_missing = [height](const Leg& leg, const Leg& other) {
    if (leg.has_foot) return false;
    // Beside a foot that stands, a leg down to the floor is whole: its heel is lifted.
    return !other.has_foot || leg.end > lifted * height;
  };
  std::vector<std::string> missing;
  if (is_missing(left, right)) missing.emplace_back("left");
  if (is_missing(right, left)) missing.emplace_back("right");
  return missing;
}

}  // namespace toile
