#include "geometry/body/find_skeleton.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/body/centreline.h"
#include "geometry/body/crotch.h"
#include "geometry/body/proportions.h"
#include "geometry/error.h"

namespace toile {

namespace {

// Shares of the height.
constexpr double arm_to_wrist = upper_arm_share + forearm_share;
constexpr double arm_to_tip = arm_to_wrist + hand_share;
// Share of the height that thighs may touch below the crotch. Clean bodies are at 0.001. At half or
// double no joint of five bodies moves.
constexpr double touching = 0.004;
// From the shoulder joint, which is above the armpit, to the elbow, where no hand tells the arm's
// length: 0.146 to 0.164 of six bodies. At half or double, that elbow is in the upper arm's middle
// or at the stump's end.
constexpr double shoulder_to_elbow = 0.16;

// Of a section's girth, to the one before: it is less where a walk goes on along a finger. There it
// is 0.57, and 0.81 where the thumb leaves the hand. Half of it sees no finger, double every step.
constexpr double finger_share = 0.65;

// Share of the height, level across the section where the thighs join: 0.2 to 0.33 of people who
// stand, 0.5 of one who sits. At half of it people who stand are refused, at double none who sits.
constexpr double longest_lap = 0.4;

/// The range of a section in x, metres.
struct Extent {
  double low = 0;
  double high = 0;
};

Extent extent_in_x(const Section& section) {
  Extent extent{section.points.front().x(), section.points.front().x()};
  for (const Vec3& point : section.points) {
    extent.low = std::min(extent.low, point.x());
    extent.high = std::max(extent.high, point.x());
  }
  return extent;
}

/// Metres that a section extends to one side of x = 0: 1 is left (+x), -1 is right.
double extent_to(const Section& section, int side) {
  const Extent extent = extent_in_x(section);
  return side > 0 ? extent.high : -extent.low;
}

/// The station of least girth with `along` in [low, high], or the first station if there is none.
const Station& min_girth(const std::vector<Station>& stations, double low, double high) {
  const Station* least = nullptr;
  for (const Station& station : stations) {
    if (station.along < low || station.along > high) continue;
    if (least == nullptr || station.section.girth < least->section.girth) least = &station;
  }
  return least != nullptr ? *least : stations.front();
}

class SkeletonFinder {
 public:
  SkeletonFinder(const TriangleMesh& body, const std::string& name) : body_(body), name_(name) {
    for (const Vec3& point : body.points) height_ = std::max(height_, point.y());
    walk_.step = height_ / 200;
    walk_.min_area = 3.5e-4 * height_ * height_;  // 10 cm^2 at 1.70 m; a finger is less
    walk_.reach = 0.05 * height_;
    walk_.length = height_;
  }

  Skeleton find() {
    find_all();
    if (!lacks_.empty()) fail(lacks_.begin()->second);
    check_arms();
    skeleton_.segments = body_segments();
    return std::move(skeleton_);
  }

  ShownJoints find_shown() {
    find_all();
    if (const int cut = shorter_arm(); cut != 0) {
      drop_arm(cut, std::string("the ") + (cut > 0 ? "left" : "right") +
                        " arm is shorter than the other");
    }
    if (lacks_.contains("left_arm") && lacks_.contains("right_arm")) {
      fail(lacks_.at("left_arm") + ", and " + lacks_.at("right_arm"));
    }
    for (const Segment& segment : body_segments()) {
      if (skeleton_.joints.contains(segment.from) && skeleton_.joints.contains(segment.to)) {
        skeleton_.segments.push_back(segment);
      }
    }
    return {std::move(skeleton_), std::move(lacks_)};
  }

 private:
  /// Legs and trunk have to be there; what else is not goes to lacks_.
  void find_all() {
    if (!(height_ > 0)) fail("nothing stands above y = 0");
    find_legs();
    find_trunk();
    find_neck();
    for (const int side : {1, -1}) find_arm(side);
    place_elbows_of_cut_arms();
    check_trunk();
  }

  static std::string arm_of(int side) { return side > 0 ? "left_arm" : "right_arm"; }

  void lack(const std::string& part, const std::string& problem) {
    lacks_.try_emplace(part, problem);
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw Error(name_, "no skeleton is found: " + problem,
                "it has to stand upright with arms and legs apart");
  }

  Vec3& joint(int side, const std::string& joint_name) {
    return skeleton_.joints[(side > 0 ? "left_" : "right_") + joint_name];
  }

  /// The closed sections at height y that are large enough, in falling area.
  std::vector<Section> sections_at(double y) const {
    std::vector<Section> sections = slice(body_, Vec3(0, y, 0), Vec3::UnitY());
    std::erase_if(sections,
                  [this](const Section& s) { return !s.closed || s.area < walk_.min_area; });
    return sections;
  }

  /// The section at height y that holds the whole trunk around `middle`, if there is one.
  std::optional<Section> trunk_section(double y, const Vec3& middle) const {
    return section_at(sections_at(y), Vec3(middle.x(), y, middle.z()), Vec3::UnitY(),
                      walk_.min_area, walk_.reach);
  }

  void find_legs() {
    // A quarter of the height is below the hands and above the feet.
    const double shin = 0.25 * height_;
    std::vector<Section> shins = sections_at(shin);
    if (shins.size() != 2) {
      fail("a level cut at a quarter of the height meets " + std::to_string(shins.size()) +
           " parts instead of two legs");
    }
    if (shins[0].centroid.x() < shins[1].centroid.x()) std::swap(shins[0], shins[1]);

    std::array<std::vector<Station>, 2> up;
    for (int leg = 0; leg < 2; ++leg) {
      up[leg] = walk_level(body_, shins[leg].centroid, 0.65 * height_, walk_);
    }
    // Both walks end in the trunk. The crotch is the level where they first meet in one section.
    std::size_t first = 0;
    const std::size_t both = std::min(up[0].size(), up[1].size());
    while (first < both && up[0][first].section.centroid != up[1][first].section.centroid) ++first;
    if (first == both || first == 0) fail("the legs don't meet below the waist");
    double apart = up[0][first - 1].along;
    double joined = up[0][first].along;
    for (int i = 0; i < 8; ++i) {
      const double y = (apart + joined) / 2;
      const auto left = trunk_section(y, up[0][first - 1].section.centroid);
      const auto right = trunk_section(y, up[1][first - 1].section.centroid);
      (left && right && left->centroid == right->centroid ? joined : apart) = y;
    }
    auto pelvis = trunk_section(joined, up[0][first].section.centroid);
    // Thighs that touch, or a film between them, join the sections too low.
    const auto seen =
        find_crotch(body_, {up[0][first - 1].section.centroid, up[1][first - 1].section.centroid,
                            pelvis->centroid, height_});
    if (seen && seen->y() > joined + touching * height_) {
      if (auto higher = trunk_section(seen->y(), pelvis->centroid)) {
        joined = seen->y();
        pelvis = std::move(higher);
      }
    }
    if (widest_chord(*pelvis) > longest_lap * height_) {
      fail("the thighs are not upright, as of a person who sits");
    }
    crotch_ = joined;
    skeleton_.joints["pelvis"] = pelvis->centroid;

    for (const int side : {1, -1}) {
      const int leg = side > 0 ? 0 : 1;
      std::vector<Station> leg_line = walk_level(body_, shins[leg].centroid, 0, walk_);
      std::reverse(leg_line.begin(), leg_line.end());
      leg_line.insert(leg_line.end(), up[leg].begin() + 1,
                      up[leg].begin() + static_cast<std::ptrdiff_t>(first));
      const Vec3 thigh = point_along(leg_line, crotch_ - 0.02 * height_);
      joint(side, "hip") = Vec3(thigh.x(), crotch_ + 0.04 * height_, pelvis->centroid.z());
      const double thin = min_girth(leg_line, 0.5 * crotch_, 0.7 * crotch_).along;
      joint(side, "knee") = point_along(
          leg_line,
          std::clamp(knee_share * crotch_, thin - knee_span * height_, thin + knee_span * height_));
      // The ankle's least girth lies above its bones.
      const double above_ankle = min_girth(leg_line, 0.03 * height_, 0.14 * height_).along;
      joint(side, "ankle") = point_along(leg_line, std::max(0.65 * above_ankle, 0.03 * height_));
    }
  }

  void find_trunk() {
    WalkOptions options = walk_;
    trunk_ = walk_level(body_, skeleton_.joint("pelvis"), 0.995 * height_, options);
    if (trunk_.back().along < 0.9 * height_) fail("the trunk can't be followed up to a head");
    for (const int side : {1, -1}) find_armpit(side);
    // The other arm's level stands for the armpit of an arm that is not there.
    for (const int side : {1, -1}) {
      if (!lacks_.contains(arm_of(side))) continue;
      if (lacks_.contains(arm_of(-side))) {
        fail(lacks_.at("left_arm") + ", and " + lacks_.at("right_arm"));
      }
      armpits_[side > 0 ? 0 : 1] = armpits_[side > 0 ? 1 : 0];
    }
    const double armpit = std::min(armpits_[0].y(), armpits_[1].y());
    const double span = armpit - crotch_;
    skeleton_.joints["waist"] =
        min_girth(trunk_, crotch_ + 0.3 * span, crotch_ + 0.85 * span).section.centroid;
    const Vec3 chest = point_along(trunk_, armpit - walk_.step);
    skeleton_.joints["chest"] = Vec3(chest.x(), (armpits_[0].y() + armpits_[1].y()) / 2, chest.z());
  }

  void find_armpit(int side) {
    // The lowest level between waist and neck where the trunk's section suddenly loses a part of
    // the arm. There can be several, as a level arm leaves the section piece by piece. Of a body
    // without a head it is higher up.
    std::size_t below = 0;
    for (std::size_t i = 1; i < trunk_.size() && below == 0; ++i) {
      if (trunk_[i].along < 0.6 * height_ || trunk_[i].along > 0.92 * height_) continue;
      const double lost =
          extent_to(trunk_[i].section, side) - extent_to(trunk_[i - 1].section, side);
      if (lost > 0.03 * height_) below = i;
    }
    if (below == 0) {
      return lack(arm_of(side), std::string("the ") + (side > 0 ? "left" : "right") +
                                    " arm does not leave the trunk");
    }
    double joined = trunk_[below].along;
    double apart = trunk_[below - 1].along;
    const double between =
        (extent_to(trunk_[below].section, side) + extent_to(trunk_[below - 1].section, side)) / 2;
    Section free = trunk_[below - 1].section;
    for (int i = 0; i < 8; ++i) {
      const double y = (joined + apart) / 2;
      auto section = trunk_section(y, free.centroid);
      if (section && extent_to(*section, side) < between) {
        apart = y;
        free = std::move(*section);
      } else {
        joined = y;
      }
    }
    // Below this level the trunk's section may still include some of the arm's underside, which is
    // flatter than any side of a trunk. The armpit lies where that ends.
    double reach = extent_to(free, side);
    for (std::size_t i = below; i-- > 0 && trunk_[i].along > joined - 0.035 * height_;) {
      const double inner = extent_to(trunk_[i].section, side);
      if (reach - inner > 0.5 * walk_.step) free = trunk_[i].section;
      reach = inner;
    }
    const auto crease = std::max_element(
        free.points.begin(), free.points.end(),
        [side](const Vec3& a, const Vec3& b) { return side * a.x() < side * b.x(); });
    armpits_[side > 0 ? 0 : 1] = *crease;
  }

  void find_neck() {
    const double shoulders = std::max(armpits_[0].y(), armpits_[1].y());
    const Station& thin = min_girth(trunk_, std::max(shoulders, 0.75 * height_), 0.93 * height_);
    double head_girth = 0;
    for (const Station& station : trunk_) {
      if (station.along > thin.along) head_girth = std::max(head_girth, station.section.girth);
    }
    if (head_girth < 1.05 * thin.section.girth) {
      skeleton_.joints["neck"] = point_along(trunk_, 0.985 * height_);
      return lack("head", "no neck is thinner than a head above it");
    }
    const auto width = [](const Section& section) {
      const Extent extent = extent_in_x(section);
      return extent.high - extent.low;
    };
    // The base of the neck is the level below where it has widened by 40 % toward the shoulders.
    const Station* base = &thin;
    for (auto at = trunk_.rbegin(); at != trunk_.rend(); ++at) {
      if (at->along > thin.along) continue;
      base = &*at;
      if (width(at->section) > 1.4 * width(thin.section)) break;
    }
    skeleton_.joints["neck"] = base->section.centroid;
    const Vec3 crown = point_along(trunk_, 0.985 * height_);
    skeleton_.joints["head"] = Vec3(crown.x(), height_, crown.z());
  }

  void find_arm(int side) {
    if (lacks_.contains(arm_of(side))) return;
    const Vec3& armpit = armpits_[side > 0 ? 0 : 1];
    const std::string which = side > 0 ? "left" : "right";
    const Vec3 tip = *std::max_element(
        body_.points.begin(), body_.points.end(),
        [side](const Vec3& a, const Vec3& b) { return side * a.x() < side * b.x(); });
    const Vec3 outward = (tip - armpit).normalized();
    const Vec3 across = (Vec3::UnitY() - outward.y() * outward).normalized();
    // The walk starts in the arm's middle, at the first point whose section is the arm's alone.
    WalkOptions options = walk_;
    options.min_area = walk_.min_area / 2;
    std::vector<Station> arm;
    for (double on = 0.01; on < 0.08 && arm.empty(); on += 0.01) {
      arm = walk_limb(body_, armpit + height_ * (0.035 * across + on * outward), outward, options);
      if (!arm.empty() && arm.front().section.girth > 0.35 * height_) arm.clear();
    }
    if (arm.size() < 20) {
      return lack(arm_of(side),
                  "the " + which + " arm can't be followed from the armpit to a hand");
    }

    // The shoulder joint lies above the armpit, on the upper arm's line.
    const std::size_t far = std::min<std::size_t>(arm.size() - 1, 16);
    const Vec3 root = arm.front().section.centroid;
    const Vec3 axis = (arm[far].section.centroid - root).normalized();
    const double to_armpit_level = std::max(0.0, axis.dot(root - armpit));
    double back = to_armpit_level + 0.035 * height_;
    if (side * axis.x() > 1e-3) {
      const double to_armpit_side = side * (root.x() - armpit.x()) / (side * axis.x());
      back = std::clamp(to_armpit_side, to_armpit_level, back);
    }
    const Vec3 shoulder = root - back * axis;

    const double wrist = find_wrist(arm, back);
    joint(side, "shoulder") = shoulder;
    joint(side, "elbow") = point_along(arm, elbow_share * (back + wrist) - back);
    joint(side, "wrist") = point_along(arm, wrist);
    if (wrist == arm.back().along) cut_arms_[side > 0 ? 0 : 1] = {std::move(arm), back};
  }

  /// An arm that ends before a hand tells nothing of its elbow: the other arm does, or proportion.
  void place_elbows_of_cut_arms() {
    for (const int side : {1, -1}) {
      const auto& [arm, back] = cut_arms_[side > 0 ? 0 : 1];
      if (arm.empty()) continue;
      const bool is_other_whole =
          !lacks_.contains(arm_of(-side)) && cut_arms_[side > 0 ? 1 : 0].arm.empty();
      const double reach = is_other_whole
                               ? (joint(-side, "elbow") - joint(-side, "shoulder")).norm()
                               : shoulder_to_elbow * height_;
      if (reach < back + arm.back().along) joint(side, "elbow") = point_along(arm, reach - back);
    }
  }

  /// Metres along the arm's stations to the wrist. They begin `back` metres from the shoulder
  /// joint.
  double find_wrist(const std::vector<Station>& arm, double back) const {
    const double whole = back + arm.back().along;
    const double low = 0.62 * whole - back;
    const double high = 0.88 * whole - back;
    // A walk may go on along a finger, which is much thinner all at once.
    const auto from = std::ranges::find_if(arm, [&](const Station& at) { return at.along >= low; });
    const auto finger = std::adjacent_find(from, arm.end(), [](const auto& a, const auto& b) {
      return b.section.girth < finger_share * a.section.girth;
    });
    const double end = finger == arm.end() ? high : std::min(high, finger->along);
    // The thinnest station that a thicker hand is beyond: fingers may be thinner.
    const Station* thin = nullptr;
    double hand = 0;
    for (auto at = arm.rbegin(); at != arm.rend(); ++at) {
      const double girth = at->section.girth;
      if (at->along >= low && at->along <= end && hand > 1.05 * girth &&
          (thin == nullptr || girth <= thin->section.girth)) {
        thin = &*at;
      }
      hand = std::max(hand, girth);
    }
    if (thin != nullptr) return thin->along;
    // No hand is thicker than the wrist. Either the arm ends at the wrist, or proportion decides.
    if (whole < (arm_to_wrist + arm_to_tip) / 2 * height_) return arm.back().along;
    return arm_to_wrist / arm_to_tip * whole - back;
  }

  void check_trunk() {
    const auto require = [this](bool holds, const std::string& problem) {
      if (!holds) fail(problem);
    };
    const auto y = [this](const std::string& name) { return skeleton_.joint(name).y(); };
    require(crotch_ > 0.3 * height_ && crotch_ < 0.6 * height_,
            "the legs' length is not in proportion to the height");
    require(y("pelvis") < y("waist") && y("waist") < y("chest") && y("chest") < y("neck"),
            "waist, armpits and neck are not above one another");
    for (const int side : {1, -1}) {
      if (lacks_.contains(arm_of(side))) continue;
      const double length = arm_length(side);
      if (length > 0.2 * height_ && length < 0.5 * height_) continue;
      drop_arm(side, "an arm's length is not in proportion to the height");
    }
  }

  void drop_arm(int side, const std::string& why) {
    lack(arm_of(side), why);
    for (const char* name : {"shoulder", "elbow", "wrist"}) {
      skeleton_.joints.erase((side > 0 ? "left_" : "right_") + std::string(name));
    }
  }

  double arm_length(int side) {
    return (joint(side, "elbow") - joint(side, "shoulder")).norm() +
           (joint(side, "wrist") - joint(side, "elbow")).norm();
  }

  /// The side of an arm that is much shorter than the other, as one that is cut off; 0: neither is.
  int shorter_arm() {
    if (lacks_.contains("left_arm") || lacks_.contains("right_arm")) return 0;
    const double left = arm_length(1);
    const double right = arm_length(-1);
    return right > 1.3 * left ? 1 : left > 1.3 * right ? -1 : 0;
  }

  void check_arms() {
    if (shorter_arm() != 0) fail("the arms differ in length");
  }

  const TriangleMesh& body_;
  const std::string& name_;
  double height_ = 0;
  WalkOptions walk_;
  double crotch_ = 0;
  std::vector<Station> trunk_;   // from the crotch up to the crown
  std::array<Vec3, 2> armpits_;  // left, right
  struct CutArm {
    std::vector<Station> arm;  // empty: the arm has a hand, or is not there
    double back = 0;           // metres from the shoulder joint to the first station
  };
  std::array<CutArm, 2> cut_arms_;  // left, right
  Skeleton skeleton_;
  std::map<std::string, std::string> lacks_;  // why, by part
};

}  // namespace

double toes_forward(const TriangleMesh& body, const Skeleton& skeleton) {
  double height = 0;
  for (const Vec3& point : body.points) height = std::max(height, point.y());
  const double y = 0.012 * height;
  double forward = 0;
  for (const std::string ankle : {"left_ankle", "right_ankle"}) {
    const Vec3& above = skeleton.joint(ankle);
    const auto foot = section_at(slice(body, Vec3(0, y, 0), Vec3::UnitY()),
                                 Vec3(above.x(), y, above.z()), Vec3::UnitY(), 0, 0.1 * height);
    if (foot) forward += (foot->centroid.z() - above.z()) / 2;
  }
  return forward / height;
}

Skeleton find_skeleton(const TriangleMesh& body, const std::string& name) {
  return SkeletonFinder(body, name).find();
}

ShownJoints shown_joints(const TriangleMesh& body, const std::string& name) {
  return SkeletonFinder(body, name).find_shown();
}

}  // namespace toile
