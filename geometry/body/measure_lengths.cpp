// Lengths along the trunk, the limbs and the side.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "geometry/body/measure_taker.h"
#include "geometry/body/outline_points.h"
#include "geometry/body/tape.h"

namespace toile {

namespace {

constexpr double degrees = 180 / std::numbers::pi;

}  // namespace

void MeasureTaker::take_trunk_lengths() {
  Needs front;
  const Vec3 pit = point("front_neck", front);
  const Vec3 waist = point("waist", front);
  add_lines("front_centre_length", front, {over(pit, waist, 1)},
            "from the front neck point to the waist, taut over the front's middle");
  Needs back;
  const Vec3 nape = point("cervicale", back);
  const Vec3 waist_back = point("waist_back", back);
  add_lines("back_centre_length", back, {over(nape, waist_back, -1)},
            "from the cervicale to the waist, taut over the back's middle");

  Needs span;
  const Vec3 left = point("left_bust_point", span);
  const Vec3 right = point("right_bust_point", span);
  add_lines("bust_span", span, {{left, right}}, "straight from bust point to bust point");
  Needs seat;
  const Vec3 left_seat = point("left_seat_point", seat);
  const Vec3 right_seat = point("right_seat_point", seat);
  add_lines("seat_span", seat, {{left_seat, right_seat}},
            "straight between the points of the seat that stand out the most");

  Needs hips;
  const double y_waist = level(shape_.levels.waist, "waist", hips);
  const double y_hip = level(shape_.levels.hip, "hip", hips);
  Needs rear = hips;
  const Vec3 hip_back = point("hip", rear);
  const Vec3 rear_waist = point("waist_back", rear);
  add_lines("back_hip_depth", rear, {over(rear_waist, hip_back, -1)},
            "from waist to hip, taut over the back's middle");
  Needs fore = hips;
  const Vec3 fore_waist = point("waist", fore);
  Vec3 hip_front = fore_waist;
  const std::vector<Section> at_hip = slice(shape_.frame.mesh, {0, y_hip, 0}, Vec3::UnitY());
  if (fore.missing.empty() && !at_hip.empty()) {
    const Line half =
        clipped(tape_around(at_hip.front(), Vec3::UnitY()), {{Vec3::Zero(), Vec3::UnitX()}});
    if (half.empty()) fore.missing = "the hip has no left side";
    for (const Vec3& end : half) {
      if (&end != &half.front() && &end != &half.back()) continue;
      if (hip_front == fore_waist || end.z() > hip_front.z()) hip_front = end;
    }
  }
  add_lines("front_hip_depth", fore, {over(fore_waist, hip_front, 1)},
            "from waist to hip, taut over the front's middle");
  add_height("waist_to_hip", hips, y_hip, y_waist, rear_waist,
             "upright, from the waist's to the hip's level");
  Needs rise;
  const Vec3 crotch = point("crotch", rise);
  add_height("crotch_depth", rise, crotch.y(), level(shape_.levels.waist, "waist", rise),
             rear_waist, "upright, from the waist's level to the crotch");
  Needs through;
  const Vec3 from = point("waist", through);
  const Vec3 to = point("waist_back", through);
  point("crotch", through);
  add_lines("crotch_length", through,
            {tape_between(shape_.frame.mesh, from, to, Vec3::UnitY(), -Vec3::UnitY())},
            "from the front's waist between the legs to the back's, taut in the middle plane");
  Needs width;
  const Vec3 left_shoulder = point("left_shoulder", width);
  const Vec3 right_shoulder = point("right_shoulder", width);
  add_lines("shoulder_width", width, {{left_shoulder, right_shoulder}},
            "straight from shoulder point to shoulder point");
}

void MeasureTaker::take_side_lengths(int side) {
  take_shoulder_lengths(side);
  take_bust_lengths(side);
  take_shoulder_slopes(side);
  take_armscye_lengths(side);
  take_neck_to_shoulder(side);
  take_across_widths(side);
  take_vertical_trunk(side);
  take_hip_side_lengths(side);
  take_arm_length(side);
}

void MeasureTaker::take_shoulder_lengths(int side) {
  const std::string which = side_prefix(side);
  Needs ridge;
  const Vec3 neck = point(which + "side_neck", ridge);
  const Vec3 shoulder = point(which + "shoulder", ridge);
  add_lines(which + "shoulder_length", ridge, {on_skin(neck, shoulder)},
            "from the side neck point to the shoulder point, on the skin");
  add_angle(which + "shoulder_angle", ridge,
            degrees * std::atan2(neck.y() - shoulder.y(), side * (shoulder.x() - neck.x())),
            {neck, shoulder}, "below level, from the side neck point to the shoulder point");
}

/// From the bust point the tape hangs straight down to the waist's level.
std::vector<Vec3> MeasureTaker::from_bust_to_waist(const Section& upright, const Vec3& apex,
                                                   const Vec3& waist) const {
  const std::vector<Section> at_waist = slice(shape_.frame.mesh, waist, Vec3::UnitY());
  if (at_waist.empty()) return {};
  const Vec3 end = at_x(at_waist.front(), apex.x(), 1).value_or(apex);
  return taut(part_between(upright, apex, end, Vec3::UnitZ()), Vec3::UnitZ());
}

void MeasureTaker::take_bust_lengths(int side) {
  const std::string which = side_prefix(side);
  Needs ridge;
  const Vec3 neck = point(which + "side_neck", ridge);
  point(which + "shoulder", ridge);
  Needs bust = ridge;
  const Vec3 apex = point(which + "bust_point", bust);
  const Vec3 waist = point("waist", bust);
  Needs breast = bust;
  const Vec3 fold = point("underbust", breast);
  Line down;
  Line under;
  const std::vector<Section> upright =
      bust.missing.empty() ? slice(shape_.frame.mesh, apex, Vec3::UnitX()) : std::vector<Section>();
  if (!upright.empty()) {
    down = from_bust_to_waist(upright.front(), apex, waist);
    if (breast.missing.empty()) {
      const Vec3 below(apex.x(), fold.y(), fold.z());
      for (const Vec3& p : part_between(upright.front(), apex, below, Vec3::UnitZ())) {
        if (p.y() >= fold.y() - 1e-4) under.push_back(p);
      }
    }
  }
  const Line to_apex = over(neck, apex, 1);
  add_lines(which + "front_full_length", bust, {to_apex, down},
            "from the side neck point over the bust point down to the waist, taut");
  add_lines(which + "bust_depth", bust, {to_apex},
            "from the side neck point to the bust point, taut");
  add_lines(which + "bust_radius", breast, {under},
            "from the bust point down to the underbust level, on the skin");
  Needs rear = ridge;
  const Vec3 waist_back = point("waist_back", rear);
  add_lines(
      which + "back_full_length", rear, {over(neck, waist_back, -1)},
      "from the side neck point to the waist at the back's middle, taut over the shoulder blade");
}

void MeasureTaker::take_shoulder_slopes(int side) {
  const std::string which = side_prefix(side);
  const auto to_waist = [&](const std::string& name, const std::string& end, double facing,
                            const std::string& where) {
    Needs needs;
    const Vec3 a = point(which + "shoulder", needs);
    const Vec3 b = point(end, needs);
    add_lines(which + name, needs, {over(a, b, facing)},
              "from the shoulder point to the waist at the " + where + "'s middle, taut");
  };
  to_waist("front_shoulder_slope", "waist", 1, "front");
  to_waist("back_shoulder_slope", "waist_back", -1, "back");

  Needs strap;
  const Vec3 neck = point(which + "side_neck", strap);
  point(which + "shoulder", strap);
  const Vec3 bust_side = point(which + "bust_side", strap);
  add_lines(which + "front_strap", strap, {over(neck, bust_side, 1)},
            "from the side neck point over the front to the side line at the bust's level, taut");
  add_lines(which + "back_strap", strap, {over(neck, bust_side, -1)},
            "from the side neck point over the back to the side line at the bust's level, taut");
}

void MeasureTaker::take_armscye_lengths(int side) {
  const std::string which = side_prefix(side);
  Needs needs;
  const Vec3 armpit = point(which + "armpit", needs);
  const Vec3 waist_side = point(which + "waist_side", needs);
  const Vec3 bust_side = point(which + "bust_side", needs);
  Line from_armpit = {Vec3(bust_side.x(), armpit.y(), bust_side.z())};
  const Line lower =
      tape_between(shape_.frame.mesh, bust_side, waist_side, Vec3::UnitX(), side * Vec3::UnitX());
  from_armpit.insert(from_armpit.end(), lower.begin(), lower.end());
  add_lines(which + "side_length", needs, {from_armpit},
            "from the armpit's level down the side line to the waist, taut");
  Needs of_shoulder;
  const Vec3 shoulder = point(which + "shoulder", of_shoulder);
  add_height(which + "armscye_depth", needs, armpit.y(), shoulder.y(), armpit,
             "upright, from the shoulder point to the armpit");
}

void MeasureTaker::take_neck_to_shoulder(int side) {
  const std::string which = side_prefix(side);
  Needs needs;
  const Vec3 neck = point(which + "side_neck", needs);
  const Vec3 shoulder = point(which + "shoulder", needs);
  const Vec3 cervicale = point("cervicale", needs);
  const Vec3 pit = point("front_neck", needs);
  add_lines(which + "back_neck", needs,
            {tape_between(shape_.frame.mesh, cervicale, neck, pit - cervicale, -Vec3::UnitZ())},
            "from the cervicale to the side neck point, around the neck's base");
  add_lines(which + "front_across_shoulder", needs, {over(pit, shoulder, 1)},
            "from the front neck point to the shoulder point, taut");
  add_lines(which + "back_across_shoulder", needs, {over(cervicale, shoulder, -1)},
            "from the cervicale to the shoulder point, taut");
}

void MeasureTaker::take_across_widths(int side) {
  const std::string which = side_prefix(side);
  const auto across = [&](const std::string& name, double facing, const std::string& where) {
    Needs needs;
    const Vec3 top = point(which + "shoulder", needs);
    const Vec3 bottom = point(which + "armpit", needs);
    const double y = (top.y() + bottom.y()) / 2;
    const std::vector<Section> sections = needs.missing.empty()
                                              ? slice(shape_.frame.mesh, {0, y, 0}, Vec3::UnitY())
                                              : std::vector<Section>();
    Line line;
    if (!sections.empty()) {
      // From the middle to the armhole's plane, on one face of the trunk with the arms.
      const auto on_face = [&](double x) {
        return at_x(sections.front(), x, facing).value_or(Vec3(x, y, -10 * facing));
      };
      line =
          taut(part_between(sections.front(), on_face(0), on_face(top.x()), facing * Vec3::UnitZ()),
               facing * Vec3::UnitZ());
    }
    add_lines(which + name, needs, {line},
              "level, half-way from armpit to shoulder point, from the " + where +
                  "'s middle to the armhole");
  };
  across("across_chest", 1, "front");
  across("across_back", -1, "back");
}

/// The closed tape around the trunk, in the plane through both points that holds z. Empty where the
/// trunk has no closed section there.
std::vector<Vec3> MeasureTaker::around_trunk(const Vec3& shoulder_middle,
                                             const Vec3& crotch) const {
  constexpr std::size_t min_points = 9;  // fewer are no trunk
  const Vec3 normal = (crotch - shoulder_middle).cross(Vec3::UnitZ());
  // The skin over the shoulder's middle rises a little above the line between its ends.
  const double top = shoulder_middle.y() + 0.02 * shape_.frame.height;
  Line outline;
  for (const Section& section : slice(shape_.frame.mesh, shoulder_middle, normal)) {
    if (!section.closed) continue;
    Line kept;
    for (const Vec3& p : section.points) {
      if (p.y() >= crotch.y() && p.y() <= top) kept.push_back(p);
    }
    if (kept.size() > outline.size()) outline = kept;
  }
  if (outline.size() < min_points) return {};
  outline.push_back(crotch);
  Section section;
  section.points = outline;
  Line line = tape_around(section, normal);
  line.push_back(line.front());
  return line;
}

void MeasureTaker::take_vertical_trunk(int side) {
  const std::string which = side_prefix(side);
  Needs needs;
  const Vec3 neck = point(which + "side_neck", needs);
  const Vec3 shoulder = point(which + "shoulder", needs);
  const Vec3 crotch = point("crotch", needs);
  Line loop;
  if (needs.missing.empty()) loop = around_trunk((neck + shoulder) / 2, crotch);
  add_lines(which + "vertical_trunk", needs, {loop},
            "around the trunk, from the shoulder's middle over front, crotch and back, taut");
}

/// From the waist's side over the hip to its widest place, and then straight down to y. Empty
/// where there is no hip.
std::vector<Vec3> MeasureTaker::hanging_from_waist(int side, const Vec3& waist_side,
                                                   const Vec3& hip_side, double crotch_height,
                                                   double y) const {
  const double lowest = crotch_height - 0.05 * shape_.frame.height;
  // The side of the trunk: neither its middle, where the legs part, nor a hand beside it.
  const auto is_side = [&](const Vec3& p) {
    return side * p.x() > 0.3 * std::abs(waist_side.x()) && p.y() <= waist_side.y() &&
           p.y() >= lowest && std::abs(p.x()) < 1.5 * std::abs(hip_side.x());
  };
  Line part;
  for (const Section& section : slice(shape_.frame.mesh, waist_side, Vec3::UnitZ())) {
    std::ranges::copy_if(section.points, std::back_inserter(part), is_side);
  }
  if (part.empty()) return {};
  const Vec3 widest = *std::ranges::max_element(
      part, [side](const Vec3& a, const Vec3& b) { return side * a.x() < side * b.x(); });
  Line upper = {waist_side};
  for (const Vec3& p : part) {
    if (p.y() > widest.y() && side * p.x() > 0.7 * side * waist_side.x()) upper.push_back(p);
  }
  std::stable_sort(upper.begin() + 1, upper.end(),
                   [](const Vec3& a, const Vec3& b) { return a.y() > b.y(); });
  upper.push_back(widest);
  Line line = taut(upper, side * Vec3::UnitX());
  line.emplace_back(widest.x(), y, widest.z());
  return line;
}

void MeasureTaker::take_hip_side_lengths(int side) {
  const std::string which = side_prefix(side);
  Needs hip;
  const Vec3 waist_side = point(which + "waist_side", hip);
  const Vec3 hip_side = point(which + "hip_side", hip);
  const Vec3 crotch = point("crotch", hip);
  const Line to_hip =
      tape_between(shape_.frame.mesh, waist_side, hip_side, Vec3::UnitX(), side * Vec3::UnitX());
  add_lines(which + "side_hip_depth", hip, {to_hip}, "from waist to hip down the side line, taut");
  const auto hang = [&](const std::string& name, double y, const Needs& needs,
                        const std::string& where) {
    Line line;
    if (needs.missing.empty()) line = hanging_from_waist(side, waist_side, hip_side, crotch.y(), y);
    add_lines(which + name, needs, {line},
              "from the waist over the hip's side, then straight down to " + where);
  };
  Needs floor = hip;
  point("floor", floor);
  hang("waist_to_floor", 0, floor, "the floor");
  Needs knee = hip;
  hang("waist_to_knee", point(which + "knee", knee).y(), knee, "the knee's level");
  Needs ankle = hip;
  hang("waist_to_ankle", point(which + "ankle", ankle).y(), ankle, "the ankle's level");
  add_angle(
      which + "hip_angle", hip,
      degrees * std::atan2(side * (hip_side.x() - waist_side.x()), waist_side.y() - hip_side.y()),
      {waist_side, hip_side}, "off upright, from the hip's side to the waist's");
}

void MeasureTaker::take_arm_length(int side) {
  const std::string which = side_prefix(side);
  Needs arm;
  const Vec3 top = point(which + "shoulder", arm);
  const Vec3 elbow = point(which + "elbow", arm);
  const Vec3 wrist = point(which + "wrist", arm);
  std::vector<Line> along = {{}};
  if (arm.missing.empty()) along = {on_skin(top, elbow), on_skin(elbow, wrist)};
  add_lines(which + "arm_length", arm, along,
            "from the shoulder point over the elbow to the wrist's bone, on the skin",
            "5.4.14 and 5.4.15");
  Vec3 bone = Vec3::UnitX();
  if (lack_of(which + "arm").empty()) {
    bone = skeleton()->joint(which + "elbow") - skeleton()->joint(which + "shoulder");
  }
  add_angle(which + "arm_angle", arm, degrees * std::atan2(-bone.y(), side * bone.x()),
            {top, elbow}, "of the upper arm below level, as the body stands");
}

}  // namespace toile
