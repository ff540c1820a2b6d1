#include "geometry/body/measures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/body/centreline.h"
#include "geometry/body/measure_taker.h"
#include "geometry/body/tape.h"
#include "geometry/geodesic.h"

namespace toile {

Vec3 MeasureTaker::point(const std::string& landmark, Needs& needs) const {
  for (const Landmark& found : shape_.landmarks) {
    if (found.name != landmark) continue;
    if (found.place) {
      needs.confidence = std::min(needs.confidence, found.confidence);
      return *found.place;
    }
    if (needs.missing.empty()) needs.missing = "no landmark " + landmark + ": " + found.reason;
  }
  if (needs.missing.empty()) needs.missing = "no landmark " + landmark;
  return Vec3::Zero();
}

double MeasureTaker::level(const TrunkLevel& found, const std::string& name, Needs& needs) const {
  if (found.height) {
    needs.confidence = std::min(needs.confidence, found.confidence);
    return *found.height;
  }
  if (needs.missing.empty()) needs.missing = "no " + name + " level: " + found.reason;
  return 0;
}

void MeasureTaker::add(const std::string& name, const Needs& needs, double value,
                       std::vector<Line> lines, const std::string& definition,
                       const std::string& iso) {
  Measure measure;
  measure.name = name;
  measure.definition = definition;
  measure.iso = iso;
  measure.reason = needs.missing;
  if (needs.missing.empty()) {
    measure.value = value;
    measure.confidence = needs.confidence;
    measure.lines = std::move(lines);
  }
  measures_.push_back(std::move(measure));
}

void MeasureTaker::add_angle(const std::string& name, const Needs& needs, double degrees, Line line,
                             const std::string& definition) {
  add(name, needs, degrees, {std::move(line)}, definition);
  measures_.back().is_angle = true;
}

void MeasureTaker::add_lines(const std::string& name, Needs needs, std::vector<Line> lines,
                             const std::string& definition, const std::string& iso) {
  double length = 0;
  for (const Line& line : lines) {
    if (line.size() < 2 && needs.missing.empty())
      needs.missing = "no line on the skin joins its ends";
    length += length_of(line);
  }
  add(name, needs, length, std::move(lines), definition, iso);
}

void MeasureTaker::add_height(const std::string& name, const Needs& needs, double low, double high,
                              const Vec3& at, const std::string& definition,
                              const std::string& iso) {
  add(name, needs, high - low, {{Vec3(at.x(), low, at.z()), Vec3(at.x(), high, at.z())}},
      definition, iso);
}

MeasureTaker::Line MeasureTaker::girth_line(const Vec3& at, const Vec3& normal) const {
  const auto section =
      section_at(slice(shape_.frame.mesh, at, normal), at, normal, 0, 0.1 * shape_.frame.height);
  if (!section) return {};
  Line line = tape_around(*section, normal);
  if (!line.empty()) line.push_back(line.front());
  return line;
}

void MeasureTaker::add_girth(const std::string& name, Needs needs, const Vec3& at,
                             const Vec3& normal, const std::string& definition,
                             const std::string& iso) {
  Line line;
  if (needs.missing.empty()) {
    line = girth_line(at, normal);
    if (line.empty()) needs.missing = "no closed section there";
  }
  const double length = length_of(line);
  add(name, needs, length, {std::move(line)}, definition, iso);
  measures_.back().is_girth = true;
}

MeasureTaker::Line MeasureTaker::over(const Vec3& a, const Vec3& b, double facing) const {
  return tape_between(shape_.frame.mesh, a, b, Vec3::UnitZ(), facing * Vec3::UnitZ());
}

MeasureTaker::Line MeasureTaker::on_skin(const Vec3& a, const Vec3& b) const {
  return geodesic(shape_.frame.mesh, a, b);
}

std::string MeasureTaker::lack_of(const std::string& part) const {
  if (skeleton() == nullptr) return shape_.frame.no_skeleton;
  const auto found = shape_.frame.missing.find(part);
  return found == shape_.frame.missing.end() ? "" : found->second;
}

void MeasureTaker::take_heights() {
  const double h = shape_.frame.height;
  Needs stands;
  if (skeleton() == nullptr) stands.missing = "it is no whole body: " + shape_.frame.no_skeleton;
  if (stands.missing.empty()) stands.missing = no_floor(shape_);
  Needs crown = stands;
  if (const std::string why = lack_of("head"); crown.missing.empty() && !why.empty()) {
    crown.missing = "no head: " + why;
  }
  add_height("height", crown, 0, h,
             crown.missing.empty() ? skeleton()->joint("head") : Vec3(Vec3::Zero()),
             "from the floor to the crown", "5.1.1");
  const auto at_level = [&](const std::string& name, const TrunkLevel& found) {
    Needs needs = stands;
    const double y = level(found, name, needs);
    add_height(name + "_height", needs, 0, y, Vec3(0, 0, 0),
               "from the floor to the " + name + " level");
  };
  at_level("bust", shape_.levels.bust);
  at_level("waist", shape_.levels.waist);
  at_level("hip", shape_.levels.hip);
  const auto at_landmark = [&](const std::string& name, const std::string& landmark,
                               const std::string& what) {
    Needs needs = stands;
    const Vec3 p = point(landmark, needs);
    add_height(name, needs, 0, p.y(), p, "from the floor to " + what);
  };
  at_landmark("crotch_height", "crotch", "the crotch");
  at_landmark("inside_leg", "crotch", "the crotch, on the inside of the leg");
  at_landmark("left_knee_height", "left_knee", "the middle of the kneecap");
  at_landmark("right_knee_height", "right_knee", "the middle of the kneecap");
  at_landmark("cervicale_height", "cervicale", "the cervicale");
}

std::vector<Measure> MeasureTaker::taken() const {
  std::vector<Measure> all = measures_;
  for (Measure& measure : all) {
    for (Line& line : measure.lines) {
      for (Vec3& p : line) p = shape_.frame.given(p);
    }
  }
  return all;
}

std::vector<Measure> measure_body(const BodyShape& shape) {
  MeasureTaker taker(shape);
  taker.take_girths();
  taker.take_heights();
  taker.take_trunk_lengths();
  for (const int side : {1, -1}) taker.take_side_lengths(side);
  taker.take_arcs();
  for (const int side : {1, -1}) taker.take_limb_girths(side);
  return taker.taken();
}

namespace {

/// The plane of a closed tape.
BodyGirth girth_along(const Measure& measure) {
  const std::vector<Vec3>& tape = measure.lines.front();
  Vec3 middle = Vec3::Zero();
  for (const Vec3& p : tape) middle += p / static_cast<double>(tape.size());
  Vec3 moment = Vec3::Zero();
  for (std::size_t i = 0; i + 1 < tape.size(); ++i) {
    moment += (tape[i] - middle).cross(tape[i + 1] - middle);
  }
  if (moment.y() < 0) moment = -moment;
  return {measure.name, middle, moment.normalized(), *measure.value};
}

}  // namespace

MeasureValues values_of(const std::vector<Measure>& measures) {
  MeasureValues values;
  for (const Measure& measure : measures) {
    if (measure.value) values[measure.name] = *measure.value;
  }
  return values;
}

MeasureValues without_sides(const MeasureValues& values) {
  MeasureValues whole;
  for (const auto& [name, value] : values) {
    const bool has_side = name.starts_with("left_") || name.starts_with("right_");
    const std::string bare = has_side ? name.substr(name.find('_') + 1) : name;
    if (bare != name && values.contains(bare)) continue;
    const auto left = values.find("left_" + bare);
    const auto right = values.find("right_" + bare);
    const bool both = has_side && left != values.end() && right != values.end();
    whole[bare] = both ? (left->second + right->second) / 2 : value;
  }
  return whole;
}

BodyMeasures body_measures(const std::vector<Measure>& measures) {
  BodyMeasures taken;
  for (const Measure& measure : measures) {
    if (!measure.value || measure.is_angle) continue;
    taken.lengths[measure.name] = *measure.value;
    if (measure.is_girth) taken.girths.push_back(girth_along(measure));
    for (const std::string side : {"left", "right"}) {
      if (measure.name != side + "_shoulder_length") continue;
      taken.shoulder_points[side] = measure.lines.front().back();
    }
  }
  return taken;
}

const Measure* find_measure(const std::vector<Measure>& measures, const std::string& name) {
  const auto found = std::find_if(measures.begin(), measures.end(),
                                  [&](const Measure& m) { return m.name == name; });
  return found == measures.end() ? nullptr : &*found;
}

}  // namespace toile
