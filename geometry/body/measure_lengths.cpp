// Lengths along the trunk, the limbs and the side.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/body/measure_taker.h"
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
  const std::string which = side_prefix(side);
  const double h = shape_.frame.height;
  Needs ridge;
  const Vec3 neck = point(which + "side_neck", ridge);
  const Vec3 shoulder = point(which + "shoulder", ridge);
  add_lines(which + "shoulder_length", ridge, {on_skin(neck, shoulder)},
            "from the side neck point to the shoulder point, on the skin");
  add_angle(which + "shoulder_angle", ridge,
            degrees * std::atan2(neck.y() - shoulder.y(), side * (shoulder.x() - neck.x())),
            {neck, shoulder}, "below level, from the side neck point to the shoulder point");

  Needs bust = ridge;
  const Vec3 apex = point(which + "bust_point", bust);
  const Vec3 waist = point("waist", bust);
  const Line to_apex = over(neck, apex, 1);
  // From the bust point the tape hangs straight down to the waist's level.
  Line down;
  if (bust.missing.empty()) {
    const std::vector<Section> sections = slice(shape_.frame.mesh, apex, Vec3::UnitX());
    const std::vector<Section> level_sections = slice(shape_.frame.mesh, waist, Vec3::UnitY());
    if (!sections.empty() && !level_sections.empty()) {
      Vec3 end = apex;
      double foremost = -10;
      const auto& points = level_sections.front().points;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3& a = points[i];
        const Vec3& b = points[(i + 1) % points.size()];
        if ((a.x() - apex.x()) * (b.x() - apex.x()) > 0 || a.x() == b.x()) continue;
        const Vec3 p = a + (apex.x() - a.x()) / (b.x() - a.x()) * (b - a);
        if (p.z() <= foremost) continue;
        foremost = p.z();
        end = p;
      }
      down = taut(part_between(sections.front(), apex, end, Vec3::UnitZ()), Vec3::UnitZ());
    }
  }
  add_lines(which + "front_full_length", bust, {to_apex, down},
            "from the side neck point over the bust point down to the waist, taut");
  add_lines(which + "bust_depth", bust, {to_apex},
            "from the side neck point to the bust point, taut");
  Needs breast = bust;
  const Vec3 fold = point("underbust", breast);
  Line under;
  if (breast.missing.empty()) {
    const std::vector<Section> sections = slice(shape_.frame.mesh, apex, Vec3::UnitX());
    if (!sections.empty()) {
      const Line part =
          part_between(sections.front(), apex, Vec3(apex.x(), fold.y(), fold.z()), Vec3::UnitZ());
      for (const Vec3& p : part) {
        if (p.y() >= fold.y() - 1e-4) under.push_back(p);
      }
    }
  }
  add_lines(which + "bust_radius", breast, {under},
            "from the bust point down to the underbust level, on the skin");
  Needs rear = ridge;
  const Vec3 waist_back = point("waist_back", rear);
  add_lines(
      which + "back_full_length", rear, {over(neck, Vec3(waist_back), -1)},
      "from the side neck point to the waist at the back's middle, taut over the shoulder blade");

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

  Needs strap = ridge;
  const Vec3 bust_side = point(which + "bust_side", strap);
  add_lines(which + "front_strap", strap, {over(neck, bust_side, 1)},
            "from the side neck point over the front to the side line at the bust's level, taut");
  add_lines(which + "back_strap", strap, {over(neck, bust_side, -1)},
            "from the side neck point over the back to the side line at the bust's level, taut");

  Needs sides;
  const Vec3 armpit = point(which + "armpit", sides);
  const Vec3 waist_side = point(which + "waist_side", sides);
  const Vec3 bust_at_side = point(which + "bust_side", sides);
  Line from_armpit = {Vec3(bust_at_side.x(), armpit.y(), bust_at_side.z())};
  const Line lower = tape_between(shape_.frame.mesh, bust_at_side, waist_side, Vec3::UnitX(),
                                  side * Vec3::UnitX());
  from_armpit.insert(from_armpit.end(), lower.begin(), lower.end());
  add_lines(which + "side_length", sides, {from_armpit},
            "from the armpit's level down the side line to the waist, taut");
  add_height(which + "armscye_depth", sides, armpit.y(), shoulder.y(), armpit,
             "upright, from the shoulder point to the armpit");

  Needs nape = ridge;
  const Vec3 cervicale = point("cervicale", nape);
  const Vec3 pit = point("front_neck", nape);
  add_lines(which + "back_neck", nape,
            {tape_between(shape_.frame.mesh, cervicale, neck, pit - cervicale, -Vec3::UnitZ())},
            "from the cervicale to the side neck point, around the neck's base");
  add_lines(which + "front_across_shoulder", nape, {over(pit, shoulder, 1)},
            "from the front neck point to the shoulder point, taut");
  add_lines(which + "back_across_shoulder", nape, {over(cervicale, shoulder, -1)},
            "from the cervicale to the shoulder point, taut");

  const auto across = [&](const std::string& name, double facing, const std::string& where) {
    Needs needs;
    const Vec3 top = point(which + "shoulder", needs);
    const Vec3 bottom = point(which + "armpit", needs);
    Line line;
    if (needs.missing.empty()) {
      const double y = (top.y() + bottom.y()) / 2;
      const std::vector<Section> sections = slice(shape_.frame.mesh, {0, y, 0}, Vec3::UnitY());
      if (!sections.empty()) {
        // From the middle to the armhole's plane, on one face of the trunk with the arms.
        Line middle;
        const auto& points = sections.front().points;
        for (const double x : {0.0, top.x()}) {
          Vec3 found(x, y, -10 * facing);
          for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec3& a = points[i];
            const Vec3& b = points[(i + 1) % points.size()];
            if ((a.x() - x) * (b.x() - x) > 0 || a.x() == b.x()) continue;
            const Vec3 p = a + (x - a.x()) / (b.x() - a.x()) * (b - a);
            if (facing * p.z() > facing * found.z()) found = p;
          }
          middle.push_back(found);
        }
        line = taut(part_between(sections.front(), middle[0], middle[1], facing * Vec3::UnitZ()),
                    facing * Vec3::UnitZ());
      }
    }
    add_lines(which + name, needs, {line},
              "level, half-way from armpit to shoulder point, from the " + where +
                  "'s middle to the armhole");
  };
  across("across_chest", 1, "front");
  across("across_back", -1, "back");

  Needs trunk = ridge;
  const Vec3 crotch = point("crotch", trunk);
  std::vector<Line> loop;
  if (trunk.missing.empty()) {
    const Vec3 top = (neck + shoulder) / 2;
    // The plane through the shoulder's middle and the crotch that holds z.
    const Vec3 normal = (crotch - top).cross(Vec3::UnitZ());
    Line outline;
    for (const Section& section : slice(shape_.frame.mesh, top, normal)) {
      if (!section.closed) continue;
      Line kept;
      for (const Vec3& p : section.points) {
        if (p.y() >= crotch.y() && p.y() <= top.y() + 0.02 * h) kept.push_back(p);
      }
      if (kept.size() > outline.size()) outline = kept;
    }
    if (outline.size() > 8) {
      outline.push_back(crotch);
      Section section;
      section.points = outline;
      Line line = tape_around(section, normal);
      line.push_back(line.front());
      loop.push_back(line);
    }
  }
  add_lines(which + "vertical_trunk", trunk, loop.empty() ? std::vector<Line>{{}} : loop,
            "around the trunk, from the shoulder's middle over front, crotch and back, taut");

  Needs hip;
  const Vec3 side_waist = point(which + "waist_side", hip);
  const Vec3 side_hip = point(which + "hip_side", hip);
  const Vec3 under_crotch = point("crotch", hip);
  const Line to_hip =
      tape_between(shape_.frame.mesh, side_waist, side_hip, Vec3::UnitX(), side * Vec3::UnitX());
  add_lines(which + "side_hip_depth", hip, {to_hip}, "from waist to hip down the side line, taut");
  // Below its widest place the tape hangs straight down.
  const auto hang = [&](const std::string& name, double y, const Needs& needs,
                        const std::string& where) {
    Line line;
    if (needs.missing.empty()) {
      const std::vector<Section> sections = slice(shape_.frame.mesh, side_waist, Vec3::UnitZ());
      Line part;
      for (const Section& section : sections) {
        for (const Vec3& p : section.points) {
          if (side * p.x() > 0.3 * std::abs(side_waist.x()) && p.y() <= side_waist.y() &&
              p.y() >= under_crotch.y() - 0.05 * h &&
              std::abs(p.x()) < 1.5 * std::abs(side_hip.x())) {
            part.push_back(p);
          }
        }
      }
      if (!part.empty()) {
        const Vec3 widest = *std::max_element(
            part.begin(), part.end(),
            [side](const Vec3& a, const Vec3& b) { return side * a.x() < side * b.x(); });
        Line upper = {side_waist};
        for (const Vec3& p : part) {
          if (p.y() > widest.y() && side * p.x() > 0.7 * side * side_waist.x()) upper.push_back(p);
        }
        std::stable_sort(upper.begin() + 1, upper.end(),
                         [](const Vec3& a, const Vec3& b) { return a.y() > b.y(); });
        upper.push_back(widest);
        line = taut(upper, side * Vec3::UnitX());
        line.emplace_back(widest.x(), y, widest.z());
      }
    }
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
      degrees * std::atan2(side * (side_hip.x() - side_waist.x()), side_waist.y() - side_hip.y()),
      {side_waist, side_hip}, "off upright, from the hip's side to the waist's");

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
