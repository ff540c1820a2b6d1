#include "geometry/body/limb_landmarks.h"

#include <algorithm>
#include <vector>

#include "geometry/body/centreline.h"
#include "geometry/body/extreme.h"
#include "geometry/body/outline_points.h"
#include "geometry/body/proportions.h"
#include "geometry/body/tape.h"

namespace toile {

namespace {

// Share of the height from the thinnest place of the forearm to the wrist's bone, where arm lengths
// end. At half of it arms are 6 mm shorter than GarmentCode's, at double 11 mm longer.
constexpr double wrist_bone = 0.0066;
// Of the other hand's length: an arm with less has none. At half or double, the answer is the same
// for six bodies with both hands and one whose forearm is cut.
constexpr double least_hand = 0.4;

// Girth below the calf of a leg that is cut, as a share of the calf's. With more the leg may still
// get thicker further down.
constexpr double thinner_below = 0.9;
// Share of the height above the end of a leg that is cut.
constexpr double hole_edge = 0.015;

class LimbFinder {
 public:
  explicit LimbFinder(BodyShape& shape)
      : shape_(shape),
        mesh_(shape.frame.mesh),
        h_(shape.frame.height),
        skeleton_(&*shape.frame.skeleton) {}

  void find() {
    for (const int side : {1, -1}) {
      find_leg(side);
      if (!shape_.frame.missing.contains(side_prefix(side) + "arm")) find_arm(side);
    }
  }

 private:
  void add(const std::string& name, const std::optional<Vec3>& place, double confidence,
           const std::string& reason = "") {
    add_landmark(shape_.landmarks, name, place, confidence, reason);
  }
  void absent(const std::string& name, const std::string& reason) {
    add(name, std::nullopt, 0, reason);
  }

  /// Why the body lacks a part; empty: it is there.
  std::string lack_of(const std::string& part) const {
    const auto found = shape_.frame.missing.find(part);
    return found == shape_.frame.missing.end() ? "" : found->second;
  }

  std::optional<Section> leg_at(double y, int side) const {
    const Vec3 knee = skeleton_->joint(side_prefix(side) + "knee");
    const Vec3 hip = skeleton_->joint(side_prefix(side) + "hip");
    const Vec3 ankle = skeleton_->joint(side_prefix(side) + "ankle");
    const Vec3& from = y > knee.y() ? hip : knee;
    const Vec3& to = y > knee.y() ? knee : ankle;
    const double t = std::clamp((y - from.y()) / (to.y() - from.y()), 0.0, 1.0);
    Vec3 at = from + t * (to - from);
    at.y() = y;
    return section_at(slice(mesh_, at, Vec3::UnitY()), at, Vec3::UnitY(), 0, 0.05 * h_);
  }

  void find_leg(int side) {
    const std::string which = side_prefix(side);
    const double crotch = skeleton_->joint("pelvis").y();
    const double knee = skeleton_->joint(which + "knee").y();
    find_gluteal_fold(side, crotch, knee);
    // The knee is placed by the crotch's height above the floor.
    if (const std::string why = no_floor(shape_); !why.empty()) {
      absent(which + "knee", why);
    } else {
      const auto kneecap = leg_at(knee, side);
      add(which + "knee",
          kneecap ? std::optional(on_ray(*kneecap, kneecap->centroid, Vec3::UnitZ(), Vec3::UnitY()))
                  : std::nullopt,
          0.5, "proportion and the leg's thin place above the calf show the knee");
    }
    const std::string cut = lack_of(which + "foot");
    std::vector<Vec2> calf;
    std::vector<Vec2> ankle;
    for (double y = cut.empty() ? 0.03 * h_ : 0; y < knee; y += 0.003 * h_) {
      const auto section = leg_at(y, side);
      if (!section) continue;
      if (y < 0.14 * h_) ankle.emplace_back(y, -section->girth);
      if ((y > 0.13 * h_ || !cut.empty()) && y < knee - 0.02 * h_) {
        calf.emplace_back(y, section->girth);
      }
    }
    if (cut.empty()) {
      add_leg(which + "calf", calf, side, -Vec3::UnitZ());
      add_leg(which + "ankle", ankle, side, side * Vec3::UnitX());
    } else {
      add_calf_of_cut_leg(which + "calf", calf, side, cut);
      absent(which + "ankle", cut);
    }
  }

  /// A leg that is cut shows its calf if it gets thinner below.
  void add_calf_of_cut_leg(const std::string& name, const std::vector<Vec2>& girths, int side,
                           const std::string& cut) {
    const std::string why = cut + ", and does not show its calf";
    if (girths.size() < 5) return absent(name, why);
    const Extreme most = greatest(girths, 0.025 * h_);
    // Next to the end the surface is that of a filled hole.
    const double sure = girths.front().x() + hole_edge * h_;
    double least_below = most.value;
    for (const Vec2& girth : girths) {
      if (girth.x() > sure && girth.x() < most.at) least_below = std::min(least_below, girth.y());
    }
    if (most.is_end || least_below > thinner_below * most.value) return absent(name, why);
    add_leg(name, girths, side, -Vec3::UnitZ());
  }

  void add_leg(const std::string& name, const std::vector<Vec2>& girths, int side,
               const Vec3& direction) {
    if (girths.size() < 5) return absent(name, "the lower leg has no closed outline");
    const Extreme most = greatest(girths, 0.025 * h_);
    const auto section = leg_at(most.at, side);
    if (!section) return absent(name, "the lower leg has no closed outline");
    add(name, on_ray(*section, section->centroid, direction, Vec3::UnitY()),
        most.is_end ? 0.4 : 0.8);
  }

  /// The hollow of the back's outline between seat and thigh, in the plane of the seat's point.
  void find_gluteal_fold(int side, double crotch, double knee) {
    const std::string name = side_prefix(side) + "gluteal_fold";
    const auto seat = place_of(shape_.landmarks, side_prefix(side) + "seat_point");
    if (!seat) return absent(name, "the seat's point is not found");
    const double low = crotch - 0.35 * (crotch - knee);
    const auto thigh = leg_at(low, side);
    const auto to = thigh ? at_x(*thigh, seat->x(), -1) : std::nullopt;
    const std::vector<Section> sections = slice(mesh_, *seat, Vec3::UnitX());
    if (!to || sections.empty()) return absent(name, "the thigh has no closed outline");
    const std::vector<Vec3> curve = part_between(sections.front(), *seat, *to, -Vec3::UnitZ());
    if (curve.size() < 5) return absent(name, "the thigh has no outline from the side");
    const std::optional<Vec3> fold = bulge(curve, Vec3::UnitZ(), 0.2);
    if (!fold) return absent(name, "there is no fold between seat and thigh");
    add(name, fold, 0.5);
  }

  void find_arm(int side) {
    const std::string which = side_prefix(side);
    const Vec3& shoulder = skeleton_->joint(which + "shoulder");
    const Vec3& elbow = skeleton_->joint(which + "elbow");
    const Vec3& wrist = skeleton_->joint(which + "wrist");
    const bool is_cut = hand_of(side) < least_hand * std::max(hand_of(-side), hand_share * h_);
    const std::string cut = "the arm ends before a hand";
    add_on_arm(which + "elbow", elbow, (wrist - shoulder).normalized(), is_cut ? 0.3 : 0.6,
               is_cut ? cut + ": the other arm or proportion places its elbow" : "");
    if (is_cut) return absent(which + "wrist", cut);
    const Vec3 along = (wrist - elbow).normalized();
    add_on_arm(which + "wrist", wrist + wrist_bone * h_ * along, along, 0.6);
  }

  /// Metres that the arm goes on beyond its wrist; 0 where there is no arm.
  double hand_of(int side) const {
    if (shape_.frame.missing.contains(side_prefix(side) + "arm")) return 0;
    const Vec3 wrist = skeleton_->joint(side_prefix(side) + "wrist");
    const Vec3 along = (wrist - skeleton_->joint(side_prefix(side) + "elbow")).normalized();
    double reach = 0;
    for (const Vec3& p : mesh_.points) {
      const double on = along.dot(p - wrist);
      const double off = (p - wrist - on * along).norm();
      if (off < hand_share * h_ / 2 + on / 2 && on < 2 * hand_share * h_) {
        reach = std::max(reach, on);
      }
    }
    return reach;
  }

  /// The outer point of the arm's section, where a tape from the shoulder runs.
  void add_on_arm(const std::string& name, const Vec3& joint, const Vec3& along, double confidence,
                  const std::string& reason = "") {
    const auto section = section_at(slice(mesh_, joint, along), joint, along, 0, 0.04 * h_);
    if (!section) return absent(name, "the arm has no closed outline");
    Vec3 out = Vec3::UnitY() - along.y() * along;
    if (out.norm() < 1e-3) out = Vec3(joint.x() > 0 ? 1 : -1, 0, 0);
    add(name, on_ray(*section, section->centroid, out.normalized(), along), confidence, reason);
  }

  BodyShape& shape_;
  const TriangleMesh& mesh_;
  double h_;
  const Skeleton* skeleton_;
};

}  // namespace

void add_landmark(Landmarks& landmarks, const std::string& name, const std::optional<Vec3>& place,
                  double confidence, const std::string& reason) {
  const bool is_said = place || !reason.empty();
  landmarks.push_back({name, place, place ? confidence : 0,
                       is_said ? reason : "the surface has no closed outline there"});
}

void find_limb_landmarks(BodyShape& shape) { LimbFinder(shape).find(); }

}  // namespace toile
