// Girths of trunk and limbs, and their arcs.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/body/centreline.h"
#include "geometry/body/measure_taker.h"
#include "geometry/body/measures.h"
#include "geometry/body/tape.h"
#include "geometry/body/torso_section.h"

namespace toile {

void MeasureTaker::take_girths() {
  const auto around_trunk = [this](const std::string& name, const TrunkLevel& found,
                                   const std::string& definition, const std::string& iso = "") {
    Needs needs;
    const double y = level(found, name, needs);
    // The largest section is the trunk's; arms have others.
    Vec3 at(0, y, 0);
    if (needs.missing.empty()) {
      const std::vector<Section> sections = slice(shape_.frame.mesh, at, Vec3::UnitY());
      if (!sections.empty()) at = sections.front().centroid;
    }
    add_girth(name, needs, at, Vec3::UnitY(), definition, iso);
  };
  around_trunk("bust", shape_.levels.bust, "level, around the trunk at the bust points", "5.3.4");
  around_trunk("underbust", shape_.levels.underbust, "level, around the trunk below the breasts");
  around_trunk("waist", shape_.levels.waist, "level, around the trunk in the hollow of the waist",
               "5.3.10");
  around_trunk("abdomen", shape_.levels.abdomen,
               "level, around the trunk where the belly stands out the most");
  around_trunk("hip", shape_.levels.hip, "level, around the trunk where the seat is fullest",
               "5.3.13");

  Needs needs;
  const Vec3 back = point("cervicale", needs);
  const Vec3 front = point("front_neck", needs);
  Needs base = needs;
  const Vec3 left = point("left_side_neck", base);
  const Vec3 right = point("right_side_neck", base);
  const double h = shape_.frame.height;
  Vec3 throat = Vec3::Zero();
  Vec3 along = Vec3::UnitY();
  if (skeleton() != nullptr && needs.missing.empty()) {
    // The least girth above the base, square to the neck's middle line.
    double least = 10;
    std::array<Vec3, 2> ends = {Vec3::Zero(), Vec3::UnitY()};
    const Vec3 low = skeleton()->joint("neck");
    for (double y = low.y(); y < low.y() + 0.06 * h; y += 0.002 * h) {
      const Vec3 at(low.x(), y, low.z());
      const auto section =
          section_at(slice(shape_.frame.mesh, at, Vec3::UnitY()), at, Vec3::UnitY(), 0, 0.1 * h);
      if (!section || section->girth >= least) continue;
      least = section->girth;
      throat = section->centroid;
    }
    if (least == 10) needs.missing = "the neck has no closed section";
    for (const int up : {0, 1}) {
      const Vec3 at = throat + Vec3(0, (up == 0 ? -0.012 : 0.012) * h, 0);
      const auto section =
          section_at(slice(shape_.frame.mesh, at, Vec3::UnitY()), at, Vec3::UnitY(), 0, 0.1 * h);
      ends[up] = section ? section->centroid : at;
    }
    along = (ends[1] - ends[0]).normalized();
    // A chin in the upper section would tilt the plane.
    if (along.y() < 0.8) along = Vec3::UnitY();
    double best = 10;
    for (double t = -0.015 * h; t < 0.016 * h; t += 0.002 * h) {
      const double girth = length_of(girth_line(throat + t * along, along));
      if (girth <= 0 || girth >= best) continue;
      best = girth;
      ends[0] = throat + t * along;
    }
    throat = ends[0];
  }
  add_girth("neck", needs, throat, along, "square to the neck's middle line, at its thinnest place",
            "5.3.2");
  if (base.missing.empty()) base.missing = needs.missing;
  const Vec3 sloping =
      base.missing.empty() ? Vec3((front - back).cross(left - right)) : Vec3::UnitY();
  add_girth("neck_base", base, (back + front + left + right) / 4, sloping,
            "around the neck's base in the plane through cervicale and front neck point");

  std::optional<Section> widest;
  const std::string headless = lack_of("head");
  if (headless.empty()) {
    widest = head_section(shape_.frame.mesh, skeleton()->joint("neck").y(), h);
  }
  Needs head;
  if (!headless.empty()) head.missing = "no head: " + headless;
  if (headless.empty() && !widest) head.missing = "no head: it has no closed section";
  add_girth("head", head, widest ? widest->centroid : Vec3(Vec3::Zero()), Vec3::UnitY(),
            "level, the greatest around the upper half of the head");
}

void MeasureTaker::take_arcs() {
  struct Arc {
    const char* name;
    const char* level;
    const TrunkLevel* found;
    double facing;
    const char* where;
  };
  const TrunkLevels& levels = shape_.levels;
  const std::array<Arc, 8> arcs = {{
      {"bust_arc", "bust", &levels.bust, 1,
       "at the bust, from the front's middle to the side line"},
      {"back_arc", "bust", &levels.bust, -1,
       "at the bust, from the back's middle to the side line"},
      {"front_waist_arc", "waist", &levels.waist, 1,
       "at the waist, from the front's middle to the side line"},
      {"back_waist_arc", "waist", &levels.waist, -1,
       "at the waist, from the back's middle to the side line"},
      {"front_abdominal_arc", "abdomen", &levels.abdomen, 1,
       "at the abdomen, from the front's middle to the side line"},
      {"back_abdominal_arc", "abdomen", &levels.abdomen, -1,
       "at the abdomen, from the back's middle to the side line"},
      {"front_hip_arc", "hip", &levels.hip, 1,
       "at the hip, from the front's middle to the side line"},
      {"back_hip_arc", "hip", &levels.hip, -1,
       "at the hip, from the back's middle to the side line"},
  }};
  for (const int side : {1, -1}) {
    for (const Arc& arc : arcs) {
      Needs needs;
      const double y = level(*arc.found, arc.level, needs);
      if (skeleton() == nullptr && needs.missing.empty()) {
        needs.missing = "no side line: " + shape_.frame.no_skeleton;
      }
      Line line;
      if (needs.missing.empty()) {
        const std::vector<Section> sections = slice(shape_.frame.mesh, {0, y, 0}, Vec3::UnitY());
        const Vec3 at_side(0, y, side_line(shape_, y));
        if (!sections.empty()) {
          line = clipped(tape_around(sections.front(), Vec3::UnitY()),
                         {{at_side, arc.facing * Vec3::UnitZ()}, {at_side, side * Vec3::UnitX()}});
        }
      }
      add_lines(side_prefix(side) + arc.name, needs, {line}, std::string("level, ") + arc.where);
    }
    Needs needs;
    const Vec3 bust = point(side_prefix(side) + "bust_point", needs);
    const double y = level(levels.waist, "waist", needs);
    Line line;
    if (needs.missing.empty()) {
      const std::vector<Section> sections = slice(shape_.frame.mesh, {0, y, 0}, Vec3::UnitY());
      if (!sections.empty()) {
        const Vec3 middle = sections.front().centroid;
        line = clipped(tape_around(sections.front(), Vec3::UnitY()),
                       {{middle, Vec3::UnitZ()},
                        {Vec3::Zero(), side * Vec3::UnitX()},
                        {Vec3(bust.x(), y, 0), -side * Vec3::UnitX()}});
      }
    }
    add_lines(side_prefix(side) + "dart_placement", needs, {line},
              "level, at the waist, from the front's middle to below the bust point");
  }
}

void MeasureTaker::take_limb_girths(int side) {
  const std::string which = side_prefix(side);
  Needs whole;
  if (skeleton() == nullptr) whole.missing = "no limbs: " + shape_.frame.no_skeleton;
  Needs whole_arm;
  if (const std::string why = lack_of(which + "arm"); !why.empty()) {
    whole_arm.missing = (skeleton() == nullptr ? "no limbs: " : "no " + which + "arm: ") + why;
  }
  const auto joint = [&](const std::string& name) {
    const bool is_there = skeleton() != nullptr && skeleton()->joints.contains(which + name);
    return is_there ? skeleton()->joint(which + name) : Vec3(Vec3::UnitY());
  };
  const Vec3 hip = joint("hip");
  const Vec3 knee = joint("knee");
  const Vec3 ankle_joint = joint("ankle");
  const double h = shape_.frame.height;
  const auto leg_middle = [&](double y) {
    const Vec3& from = y > knee.y() ? hip : knee;
    const Vec3& to = y > knee.y() ? knee : ankle_joint;
    Vec3 at = from + (y - from.y()) / (to.y() - from.y()) * (to - from);
    at.y() = y;
    return at;
  };
  Needs needs = whole;
  const Vec3 crotch = point("crotch", needs);
  // Directly below the crotch the two legs may still be one section.
  Vec3 thigh = Vec3::Zero();
  bool is_one = false;
  for (double below = 0.002 * h; needs.missing.empty() && !is_one && below < 0.05 * h;
       below += 0.002 * h) {
    thigh = leg_middle(crotch.y() - below);
    const Line line = girth_line(thigh, Vec3::UnitY());
    is_one = !line.empty() && std::all_of(line.begin(), line.end(), [side, h](const Vec3& p) {
      return side * p.x() > -0.02 * h;
    });
  }
  if (needs.missing.empty() && !is_one) needs.missing = "the thighs touch below the crotch";
  add_girth(which + "upper_thigh", needs, thigh, Vec3::UnitY(),
            "level, around the thigh directly below the crotch", "5.3.20");
  Needs kneecap = whole;
  point(which + "knee", kneecap);
  kneecap.confidence = 1;  // the knee's level hardly changes its girth
  if (needs.missing.empty()) needs.missing = kneecap.missing;
  add_girth(which + "mid_thigh", needs,
            needs.missing.empty() ? leg_middle((crotch.y() + knee.y()) / 2) : knee, Vec3::UnitY(),
            "level, around the thigh half-way from crotch to knee");
  add_girth(which + "knee", kneecap, knee, Vec3::UnitY(), "level, around the middle of the kneecap",
            "5.3.22");
  const auto at_landmark = [&](const std::string& name, const std::string& definition,
                               const std::string& iso) {
    Needs more = whole;
    const Vec3 p = point(which + name, more);
    add_girth(which + name, more, more.missing.empty() ? leg_middle(p.y()) : knee, Vec3::UnitY(),
              definition, iso);
  };
  at_landmark("calf", "level, the greatest around the calf", "5.3.24");
  at_landmark("ankle", "level, the least above the ankle", "");

  const Vec3 shoulder = joint("shoulder");
  const Vec3 elbow = joint("elbow");
  const Vec3 wrist = joint("wrist");
  const Vec3 upper = (elbow - shoulder).normalized();
  const Vec3 lower = (wrist - elbow).normalized();
  /// The place of a bone at which the arm is the broadest, between two shares of it.
  const auto broadest = [&](const Vec3& from, const Vec3& to, double first, double last) {
    double most = 0;
    Vec3 place = elbow;
    for (double t = first; whole_arm.missing.empty() && t < last; t += 0.05) {
      const Vec3 at = from + t * (to - from);
      const double girth = length_of(girth_line(at, (to - from).normalized()));
      if (girth <= most || girth > most_of_an_arm * h) continue;
      most = girth;
      place = at;
    }
    return place;
  };
  const Vec3 arm = broadest(shoulder, elbow, 0.35, 0.8);
  const Vec3 forearm = broadest(elbow, wrist, 0.1, 0.5);
  const auto free_of_trunk = [&](const Vec3& at, const Vec3& along) {
    Needs arm_needs = whole_arm;
    if (arm_needs.missing.empty() && length_of(girth_line(at, along)) > most_of_an_arm * h) {
      arm_needs.missing = "the arm touches the trunk there";
    }
    return arm_needs;
  };
  add_girth(which + "upper_arm", free_of_trunk(arm, upper), arm, upper,
            "square to the arm, the greatest between armpit and elbow");
  const Vec3 bent = (wrist - shoulder).normalized();
  Needs hand = whole_arm;
  if (hand.missing.empty()) point(which + "wrist", hand);
  hand.confidence = 1;
  Needs at_elbow = free_of_trunk(elbow, bent);
  // Without a hand the elbow is placed by proportion.
  if (at_elbow.missing.empty() && !hand.missing.empty()) point(which + "elbow", at_elbow);
  add_girth(which + "elbow", at_elbow, elbow, bent, "square to the arm, around the elbow");
  add_girth(which + "forearm", free_of_trunk(forearm, lower), forearm, lower,
            "square to the forearm, the greatest below the elbow");
  add_girth(which + "wrist", hand, wrist, lower, "square to the forearm, the least above the hand",
            "5.3.19");
}

}  // namespace toile
