#include "geometry/body/refine_joints.h"

#include <algorithm>
#include <string>
#include <vector>

#include "geometry/body/centreline.h"
#include "geometry/body/crotch.h"
#include "geometry/body/extreme.h"
#include "geometry/body/proportions.h"
#include "geometry/body/torso_section.h"
#include "geometry/parallel.h"

namespace toile {

namespace {

// Shares of the height.
// The parabolas' reach. Half or double of the leg's moves no knee of five bodies. Half or double of
// the wrist's moves three of their wrists by 7 to 9 mm.
constexpr double leg_reach = 0.025;
constexpr double wrist_reach = 0.02;
constexpr double arm_step = 0.002;
// Between sections. At half or double, armpits move by 2 mm.
constexpr double armpit_step = 0.0012;
constexpr double armpit_reach = 0.05;  // up and down
// By which the trunk's half gets wider where the arm joins. Half or double moves no armpit.
constexpr double arm_jump = 0.03;
// Metres outward a metre up: the underside of an arm is flatter, the side of a trunk steeper. At
// half of it armpits of wide chests are 14 to 40 mm lower, at double 3 mm higher.
constexpr double underside = 0.5;

struct Refiner {
  BodyFrame& frame;

  Vec3& joint(const std::string& name) { return frame.skeleton->joints[name]; }

  /// The girths of a limb, negative, at these places, in planes square to `normal`.
  std::vector<Vec2> girths(const std::vector<double>& along, const Vec3& from, const Vec3& slope,
                           const Vec3& normal) const {
    std::vector<std::optional<Section>> sections(along.size());
    parallel_for(along.size(), [&](std::size_t i) {
      const Vec3 at = from + along[i] * slope;
      sections[i] = section_at(slice(frame.mesh, at, normal), at, normal, 0, 0.05 * frame.height);
    });
    std::vector<Vec2> found;
    for (std::size_t i = 0; i < along.size(); ++i) {
      if (sections[i]) found.emplace_back(along[i], -sections[i]->girth);
    }
    return found;
  }

  /// The height where an arm's underside goes over into the trunk's side; nothing where it does
  /// not leave the trunk near the joint.
  std::optional<double> armpit(int side) const {
    const double step = armpit_step * frame.height;
    const int reach = static_cast<int>(armpit_reach / armpit_step);
    const double top = frame.skeleton->joint("chest").y() + reach * step;
    std::vector<double> out(2 * static_cast<std::size_t>(reach), 0);  // from above
    parallel_for(out.size(), [&](std::size_t i) {
      const auto section = torso_section(frame.mesh, top - static_cast<double>(i) * step);
      if (!section) return;
      for (const Vec3& p : section->points) out[i] = std::max(out[i], side * p.x());
    });
    std::size_t apart = out.size();
    while (apart > 1 && out[apart - 2] - out[apart - 1] < arm_jump * frame.height) --apart;
    // Steepness over four steps. As far as it is flat, it is the arm's.
    constexpr std::size_t window = 4;
    if (apart <= 1) return std::nullopt;
    --apart;
    const auto flatness = [&](std::size_t i) {
      return (out[i] - out[i + window]) / (static_cast<double>(window) * step);
    };
    std::size_t at = apart;
    while (at + window + 1 < out.size() && flatness(at) > underside) ++at;
    if (at + window + 1 >= out.size()) return std::nullopt;
    double index = static_cast<double>(at);
    if (at > apart) {
      const double above = flatness(at - 1);
      const double here = flatness(at);
      index -= (underside - here) / (above - here);
    }
    return top - index * step;
  }

  bool has(const std::string& name) const { return frame.skeleton->joints.contains(name); }

  void find_armpits() {
    const bool both = has("left_shoulder") && has("right_shoulder");
    const auto left = has("left_shoulder") ? armpit(1) : armpit(-1);
    const auto right = both ? armpit(-1) : left;
    if (left && right) joint("chest").y() = (*left + *right) / 2;
  }

  void find_knee(const std::string& side) {
    const double h = frame.height;
    const double crotch = joint("pelvis").y();
    Vec3& knee = joint(side + "knee");
    const Vec3 hip = joint(side + "hip");
    const Vec3 ankle = joint(side + "ankle");
    std::vector<double> heights;
    for (double y = 0.5 * crotch; y < 0.7 * crotch; y += 0.003 * h) heights.push_back(y);
    const Vec3 slope = (hip - ankle) / (hip.y() - ankle.y());
    const Vec3 from = ankle - ankle.y() * slope;
    const std::vector<Vec2> found = girths(heights, from, slope, Vec3::UnitY());
    if (found.size() < 8) return;
    const Extreme thin = greatest(found, leg_reach * h);
    double y = knee_share * crotch;
    // A leg that gets thinner all the way shows no knee.
    if (!thin.is_end) y = std::clamp(y, thin.at - knee_span * h, thin.at + knee_span * h);
    const Vec3& next = y > knee.y() ? hip : ankle;
    knee += (y - knee.y()) / (next.y() - knee.y()) * (next - knee);
  }

  /// The wrist's thin place, by a parabola through the girths of the forearm and of the hand.
  void find_wrist(const std::string& side) {
    const double h = frame.height;
    const Vec3 shoulder = joint(side + "shoulder");
    Vec3& elbow = joint(side + "elbow");
    Vec3& wrist = joint(side + "wrist");
    const Vec3 along = (wrist - elbow).normalized();
    std::vector<double> places;
    for (double t = -0.045 * h; t < 0.04 * h; t += arm_step * h) places.push_back(t);
    const std::vector<Vec2> found = girths(places, wrist, along, along);
    if (found.size() < 12) return;
    const Extreme thin = greatest(found, wrist_reach * h);
    if (thin.is_end) return;
    const double moved = thin.at;
    wrist += moved * along;
    elbow += elbow_share * moved * (elbow - shoulder).normalized();
  }
};

}  // namespace

std::optional<Vec3> refine_joints(BodyFrame& frame) {
  Refiner refiner{frame};
  auto seen = find_crotch(frame.mesh, {refiner.joint("left_hip"), refiner.joint("right_hip"),
                                       refiner.joint("pelvis"), frame.height});
  if (seen) {
    const double up = seen->y() - refiner.joint("pelvis").y();
    for (const char* name : {"pelvis", "left_hip", "right_hip"}) refiner.joint(name).y() += up;
  }
  refiner.find_armpits();
  for (const char* side : {"left_", "right_"}) {
    refiner.find_knee(side);
    if (refiner.has(side + std::string("wrist"))) refiner.find_wrist(side);
  }
  return seen;
}

}  // namespace toile
