#include "geometry/body/mannequin/mannequin_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>

#include "geometry/body/find_landmarks.h"
#include "geometry/body/mannequin/mannequin_build.h"
#include "geometry/body/measures.h"
#include "geometry/body/torso_section.h"
#include "geometry/slice.h"

namespace toile {

namespace {

using Of = std::function<double(double)>;

/// The height within 24 mm of `from` at which `of` has its largest value, by a parabola through
/// samples 6 mm apart. It is `from` where the largest value is at an end: then the surface has no
/// such level there.
double summit(const Of& of, double from) {
  constexpr double step = 0.006;  // metres
  constexpr int reach = 4;
  std::array<double, 2 * reach + 1> values;
  for (int i = 0; i < 2 * reach + 1; ++i) values[i] = of(from + (i - reach) * step);
  const auto most = static_cast<int>(std::ranges::max_element(values) - values.begin());
  if (most == 0 || most == 2 * reach) return from;
  const double bend = values[most - 1] - 2 * values[most] + values[most + 1];
  const double aside = bend < 0 ? (values[most - 1] - values[most + 1]) / (2 * bend) : 0;
  return from + (most - reach + aside) * step;
}

/// The lowest height at which one section goes across the middle.
double crotch_of(const TriangleMesh& body, double low, double high) {
  const auto is_one = [&body](double y) {
    const std::vector<Section> sections = slice(body, {0, y, 0}, Vec3::UnitY());
    return std::ranges::any_of(sections, [](const Section& section) {
      const auto [left, right] =
          std::ranges::minmax(section.points, {}, [](const Vec3& point) { return point.x(); });
      return left.x() < 0 && right.x() > 0;
    });
  };
  if (is_one(low) || !is_one(high)) return low;
  while (high - low > 1e-4) {
    const double middle = (low + high) / 2;
    (is_one(middle) ? high : low) = middle;
  }
  return high;
}

/// Metres from the cervicale down the back to the waist, as a tape lies.
double back_length(const TriangleMesh& body, double waist, double cervicale) {
  std::vector<Vec2> back;  // height, metres behind the middle
  for (const Section& section : slice(body, Vec3::Zero(), Vec3::UnitX())) {
    for (const Vec3& point : section.points) {
      if (point.y() < waist || point.y() > cervicale || point.z() > 0) continue;
      back.emplace_back(point.y(), -point.z());
    }
  }
  std::ranges::sort(back, {}, [](const Vec2& point) { return point.x(); });
  std::vector<Vec2> hull;
  for (const Vec2& point : back) {
    while (hull.size() >= 2) {
      const Vec2 a = hull.back() - hull[hull.size() - 2];
      const Vec2 b = point - hull.back();
      if (a.x() * b.y() - a.y() * b.x() < 0) break;
      hull.pop_back();
    }
    hull.push_back(point);
  }
  double length = 0;
  for (std::size_t i = 1; i < hull.size(); ++i) length += (hull[i] - hull[i - 1]).norm();
  return length;
}

}  // namespace

std::string measure_of(const MannequinGirth& girth) {
  std::string name = girth.name;
  std::ranges::replace(name, ' ', '_');
  std::ranges::replace(name, '-', '_');
  return name;
}

MeasureValues mannequin_measures(const Mannequin& mannequin) {
  const TriangleMesh& body = mannequin.surface;
  const Skeleton& joints = mannequin.skeleton;
  MeasureValues measures;
  double height = 0;
  for (const Vec3& point : body.points) height = std::max(height, point.y());
  measures["height"] = height;
  for (const MannequinGirth& girth : mannequin.girths) {
    // Where a thick arm touches the trunk, the section holds both. The tape finds a free place.
    if (girth.name == "upper arm" && girth.measured > most_of_an_arm * height) continue;
    measures[measure_of(girth)] = girth.measured;
  }
  const auto girth = [&body](double y) {
    const std::optional<Section> section = torso_section(body, y);
    return section ? section->girth : 0.0;
  };
  const auto farthest = [&body](double y, double sign) {
    double most = -1;
    if (const std::optional<Section> section = torso_section(body, y)) {
      for (const Vec3& point : section->points) most = std::max(most, sign * point.z());
    }
    return most;
  };
  for (const MannequinGirth& level : mannequin.girths) {
    const std::string& name = level.name;
    if (name != "bust" && name != "hip" && name != "waist") continue;
    double y = level.centre.y();
    if (name == "bust") y = summit([&](double at) { return farthest(at, 1); }, y);
    if (name == "hip") y = summit([&](double at) { return farthest(at, -1); }, y);
    if (name == "waist") y = summit([&](double at) { return -girth(at); }, y);
    measures[name + "_height"] = y;
    measures[name] = girth(y);
  }
  const double pelvis = joints.joint("pelvis").y();
  measures["crotch_height"] = crotch_of(body, 0.85 * pelvis, 1.12 * pelvis);
  measures["cervicale_height"] = joints.joint("neck").y();
  measures["knee_height"] = joints.joint("left_knee").y();
  measures["arm_length"] = (joints.joint("left_elbow") - joints.joint("left_shoulder")).norm() +
                           (joints.joint("left_wrist") - joints.joint("left_elbow")).norm();
  // The head is the largest around above the ears.
  double head = 0;
  for (double y = height - 0.16 * height / 1.7; y < height - 0.04; y += 0.01) {
    head = std::max(head, girth(y));
  }
  measures["head"] = head;
  // Where landmarks were taken for others, the place that is known here is the right one. A length
  // along the arm is 16 % more than that of its bones.
  const auto take = [&measures](const std::string& name, double value, double alike) {
    const auto own = measures.find(name);
    if (own == measures.end() || std::abs(value / own->second - 1) <= alike) measures[name] = value;
  };
  const MeasureValues tape =
      without_sides(values_of(measure_body(find_landmarks(body, "mannequin"))));
  for (const auto& [name, value] : tape) {
    if (name.ends_with("_height")) take(name, value, 0.12);
  }
  // Of the levels that count, whoever found them: a length is between both of its ends.
  const double waist = measures["waist_height"];
  measures["waist_to_hip"] = waist - measures["hip_height"];
  measures["waist_to_floor"] = waist;
  measures["waist_to_knee"] = waist - measures["knee_height"];
  measures["crotch_depth"] = waist - measures["crotch_height"];
  // Below the breasts, which take less than two fifths of the way from bust to waist.
  measures["underbust"] = girth(waist + 0.57 * (measures["bust_height"] - waist));
  measures["back_centre_length"] = back_length(body, waist, measures["cervicale_height"]);
  measures["inside_leg"] = measures["crotch_height"];
  for (const auto& [name, value] : tape) {
    if (!name.ends_with("_height")) take(name, value, 0.25);
  }
  return measures;
}

MeasureValues measures_by_proportion(const MeasureValues& known) {
  static const MeasureValues sample = [] {
    MannequinOptions options;
    options.edge_length = 0.012;
    return mannequin_measures(mesh_mannequin(built_mannequin({}), options));
  }();
  const auto scale_of = [&known](std::initializer_list<const char*> names) {
    double sum = 0;
    int count = 0;
    for (const char* name : names) {
      const auto found = known.find(name);
      if (found == known.end()) continue;
      sum += found->second / sample.at(name);
      ++count;
    }
    return count > 0 ? sum / count : 1.0;
  };
  const double around = scale_of({"bust", "waist", "hip"});
  const double along = scale_of({"height"});
  MeasureValues filled;
  for (const auto& [name, value] : sample) {
    if (known.contains(name)) continue;
    const auto has = [&name = name](const char* word) {
      return name.find(word) != std::string::npos;
    };
    const bool is_along = has("height") || has("length") || has("depth") || has("_to_") ||
                          has("inside_leg") || has("strap") || has("slope") || has("trunk");
    filled[name] = value * (has("angle") ? 1 : is_along ? along : around);
  }
  return filled;
}

}  // namespace toile
