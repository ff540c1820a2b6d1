#include "geometry/body/clean_body.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/angles.h"
#include "geometry/body/body_frame.h"
#include "geometry/body/body_unit.h"
#include "geometry/body/find_skeleton.h"
#include "geometry/body/incomplete_body.h"
#include "geometry/body/limbs_through.h"
#include "geometry/body/missing_feet.h"
#include "geometry/body/sheet.h"
#include "geometry/body/stand_level.h"
#include "geometry/error.h"
#include "geometry/surface_distance.h"

namespace toile {

namespace {

using Box = Eigen::AlignedBox3d;
using Matrix = Eigen::Matrix3d;

Box bounds(const TriangleMesh& mesh) {
  Box box;
  for (const Vec3& point : mesh.points) box.extend(point);
  return box;
}

/// A body turned and lifted to stand on y = 0, in the file's unit.
struct Standing {
  TriangleMesh mesh;
  Matrix turn = Matrix::Identity();
  double lifted = 0;
  std::optional<Skeleton> skeleton;
  std::string no_skeleton;
};

/// Turns the body and lifts it onto y = 0. A turn by right angles holds 0, 1 and -1 only, so that
/// no coordinate is rounded but y by the lift.
Standing stand(const TriangleMesh& mesh, const Matrix& turn, const std::string& name) {
  Standing body;
  body.mesh = mesh;
  body.turn = turn;
  if (turn != Matrix::Identity()) {
    for (Vec3& p : body.mesh.points) p = turn * p;
  }
  const double floor = bounds(body.mesh).min().y();
  if (floor != 0) {
    for (Vec3& p : body.mesh.points) p.y() -= floor;
    body.lifted = -floor;
  }
  try {
    body.skeleton = find_skeleton(body.mesh, name);
  } catch (const Error& failed) {
    body.no_skeleton = failed.what();
  }
  return body;
}

/// The rotation that brings `axis` to +y, and the axis's name.
struct Upright {
  const char* axis;
  Matrix turn;
};

std::vector<Upright> uprights() {
  const auto rows = [](const Vec3& x, const Vec3& y, const Vec3& z) {
    Matrix turn;
    turn << x.transpose(), y.transpose(), z.transpose();
    return turn;
  };
  const Vec3 x = Vec3::UnitX();
  const Vec3 y = Vec3::UnitY();
  const Vec3 z = Vec3::UnitZ();
  return {{"y", Matrix::Identity()}, {"z", rows(x, z, -y)}, {"-z", rows(x, -z, y)},
          {"-y", rows(-x, -y, z)},   {"x", rows(-y, x, z)}, {"-x", rows(y, -x, z)}};
}

/// A turn about y, from +z to +x; exact by right angles.
Matrix turn_about_y(double degrees) {
  const double quarters = degrees / 90;
  double sine = std::sin(degrees * std::numbers::pi / 180);
  double cosine = std::cos(degrees * std::numbers::pi / 180);
  if (quarters == std::round(quarters)) {
    sine = std::round(sine);
    cosine = std::round(cosine);
  }
  return (Matrix() << cosine, 0, sine, 0, 1, 0, -sine, 0, cosine).finished();
}

/// Degrees in (-180, 180] of the turn about y that brings `across` to +x.
double to_the_left(const Vec3& across) {
  return std::atan2(across.z(), across.x()) * 180 / std::numbers::pi;
}

/// Degrees by which the body has to be turned about y for its left to be at +x, by its shoulders.
/// The hips that find_skeleton() finds are beside each other in any case, and a step parts the
/// feet.
double askew(const Skeleton& skeleton) {
  return to_the_left(skeleton.joint("left_shoulder") - skeleton.joint("right_shoulder"));
}

/// Degrees by which an upright body might have to be turned about y: first by the direction in
/// which its points spread most.
std::vector<double> likely_turns(const TriangleMesh& mesh, const Matrix& upright) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : mesh.points) mean += p / static_cast<double>(mesh.points.size());
  Matrix spread = Matrix::Zero();
  for (const Vec3& p : mesh.points) spread += (p - mean) * (p - mean).transpose();
  spread = upright * spread * upright.transpose();
  const double most = std::atan2(2 * spread(0, 2), spread(0, 0) - spread(2, 2)) / 2;
  return {most * 180 / std::numbers::pi, 30, -30, 60, -60};
}

/// `turn`, followed by a quarter turn if the body is wider from front to back than from side to
/// side. Arms held out make every body widest from side to side.
Matrix sideways(const TriangleMesh& mesh, const Matrix& turn) {
  const Vec3 size = (turn * bounds(mesh).sizes()).cwiseAbs();
  return size.z() > 1.4 * size.x() ? Matrix(turn_about_y(-90) * turn) : turn;
}

/// The index in uprights() of the axis that the body stands along, judged by its box. A box that is
/// clearly longer along z than along y is z-up. Arms out to the sides span hardly more than the
/// body's height.
std::size_t likely_axis(const TriangleMesh& mesh) {
  const Vec3 size = bounds(mesh).sizes();
  return size.z() > 1.5 * size.y() && size.z() >= 0.8 * size.x() ? 1 : 0;
}

/// Says in `report` how the body was turned.
void report_turn(const Upright& axis, const Matrix& turn, CleanReport& report) {
  const Matrix about = turn * axis.turn.transpose();
  report.turned_degrees = std::atan2(about(0, 2), about(0, 0)) * 180 / std::numbers::pi;
  const double quarters = report.turned_degrees / 90;
  if (axis.turn != Matrix::Identity()) {
    report.turned = std::string("from ") + axis.axis + " up to y up";
  }
  if (quarters == 0) return;
  if (!report.turned.empty()) report.turned += ", and ";
  if (quarters != std::round(quarters)) {
    report.turned +=
        "by " + number_text(std::abs(report.turned_degrees), 3) + " degrees about the vertical ";
  }
  report.turned += "to face +z";
}

/// The turn of an upright body that brings `front` to +z.
Matrix to_the_front(const Upright& axis, const AxisDirection& front, const std::string& name) {
  const Vec3 ahead = axis.turn * front.vector();
  if (std::abs(ahead.y()) > 0.5) {
    throw Error(name, "stands along " + std::string(axis.axis) + " and can't face " + front.name(),
                "correct --front, or give --up");
  }
  return turn_about_y(std::atan2(-ahead.x(), ahead.z()) * 180 / std::numbers::pi) * axis.turn;
}

/// Turns a body that leans as a whole, as a scanner that was not level leaves it. Returns whether
/// it then turned out to face backward: the toes of a body that leans back are off the floor.
bool stand_upright(Standing& body, const TriangleMesh& mesh, const std::string& name,
                   CleanReport& report) {
  // Postures differ by 1 degree. At 1, straight bodies would be turned; at 4, a bust would be 8 mm
  // too small.
  constexpr double least_lean = 2 * radians_per_degree;
  // The joints of a leaning body are less true: twice more.
  bool was_backward = false;
  for (int round = 0; round < 3; ++round) {
    const auto upright = turn_upright(*body.skeleton, round == 0 ? least_lean : least_lean / 8);
    if (!upright || (round == 0 && !levels_soles(*upright, body.mesh))) break;
    Standing turned = stand(mesh, *upright * body.turn, name);
    if (!turned.skeleton) break;
    report.levelled_degrees += Eigen::AngleAxisd(*upright).angle() * 180 / std::numbers::pi;
    body = std::move(turned);
    if (toes_forward(body.mesh, *body.skeleton) >= -0.01) continue;
    turned = stand(mesh, turn_about_y(180) * body.turn, name);
    if (!turned.skeleton) continue;
    body = std::move(turned);
    was_backward = !was_backward;
  }
  return was_backward;
}

/// Whether it stands as a body does that has two legs, but no head or one arm.
bool lacks_a_part(const TriangleMesh& mesh, const std::string& name) {
  return !body_frame(mesh, name).missing.empty();
}

Standing stand_up(const TriangleMesh& mesh, const CleanOptions& options, const std::string& name,
                  CleanReport& report) {
  const std::vector<Upright> axes = uprights();
  std::size_t chosen = likely_axis(mesh);
  if (options.up) {
    chosen = 0;
    while (axes[chosen].axis != options.up->name()) ++chosen;
  }
  const auto first_turn = [&](const Upright& axis) {
    return options.front ? to_the_front(axis, *options.front, name) : sideways(mesh, axis.turn);
  };
  Standing body = stand(mesh, first_turn(axes[chosen]), name);
  if (options.front) {
    report_turn(axes[chosen], body.turn, report);
    return body;
  }
  if (!body.skeleton && !options.up) {
    int found = 0;
    Standing other;
    std::size_t other_axis = chosen;
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      Standing tried = stand(mesh, sideways(mesh, axes[axis].turn), name);
      if (!tried.skeleton) continue;
      ++found;
      other = std::move(tried);
      other_axis = axis;
    }
    if (found == 1) {
      chosen = other_axis;
      body = std::move(other);
    }
  }
  // Without an arm or a head it may still show how it stands. Costs six frames.
  if (!body.skeleton && !options.up && !body_frame(body.mesh, name).skeleton) {
    std::vector<std::pair<std::size_t, Standing>> found;
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      if (axis == chosen) continue;
      Standing tried = stand(mesh, sideways(mesh, axes[axis].turn), name);
      if (lacks_a_part(tried.mesh, name)) found.emplace_back(axis, std::move(tried));
    }
    if (found.size() == 1) {
      chosen = found.front().first;
      body = std::move(found.front().second);
    }
  }
  const Matrix& upright = axes[chosen].turn;
  const auto turn_to = [&](const Matrix& turn) {
    Standing turned = stand(mesh, turn, name);
    if (turned.skeleton) body = std::move(turned);
  };
  if (!body.skeleton) {
    for (const double degrees : likely_turns(mesh, upright)) {
      if (!body.skeleton) turn_to(turn_about_y(degrees) * upright);
    }
  }
  if (!body.skeleton) {
    report_turn(axes[chosen], body.turn, report);
    return body;
  }
  // The joints of a body askew are less true than those of the same body that faces forward.
  for (int round = 0; round < 3 && std::abs(askew(*body.skeleton)) > max_askew; ++round) {
    turn_to(turn_about_y(askew(*body.skeleton)) * body.turn);
  }
  if (toes_forward(body.mesh, *body.skeleton) < -0.01) turn_to(turn_about_y(180) * body.turn);
  const Matrix facing = body.turn;
  const bool was_backward = options.level && stand_upright(body, mesh, name, report);
  report_turn(axes[chosen], was_backward ? Matrix(turn_about_y(180) * facing) : facing, report);
  return body;
}

void scale(Standing& body, double factor) {
  if (factor == 1) return;
  for (Vec3& p : body.mesh.points) p *= factor;
  if (!body.skeleton) return;
  for (auto& [joint, point] : body.skeleton->joints) point *= factor;
}

/// Gives a body that lacks limbs, in metres, the joints that it shows, and turns it to face +z.
void take_lacking(Standing& body, const CleanOptions& options, const std::string& name,
                  CleanReport& report) {
  std::optional<IncompleteBody> found = incomplete_body(body.mesh, name);
  if (!found) return;
  report.missing = found->problem;
  body.skeleton = std::move(found->skeleton);
  if (options.front || std::abs(found->degrees) <= max_askew) return;
  const Matrix turn = turn_about_y(found->degrees);
  for (Vec3& p : body.mesh.points) p = turn * p;
  for (auto& [joint, point] : body.skeleton->joints) point = turn * point;
  body.turn = turn * body.turn;
  report.turned_degrees += found->degrees;
  report.turned += (report.turned.empty() ? "by " : ", and by ") +
                   number_text(std::abs(found->degrees), 3) +
                   " degrees about the vertical to face +z";
}

/// Moves a body that stands more than 10 m from the y axis onto it. It returns the move in metres.
Vec3 bring_near(Standing& body) {
  constexpr double far = 10;  // metres
  Vec3 middle = bounds(body.mesh).center();
  middle.y() = 0;
  if (middle.norm() <= far) return Vec3::Zero();
  for (Vec3& p : body.mesh.points) p -= middle;
  if (body.skeleton) {
    for (auto& [joint, point] : body.skeleton->joints) point -= middle;
  }
  return -middle;
}

/// Why the given joints can't be used for a body in units of `unit` metres; empty: they can.
std::string refusal(const Skeleton& skeleton, const TriangleMesh& mesh, double unit) {
  // A body that lacks limbs has the segments that it shows.
  if (skeleton.segments.empty()) return "there are no segments among them";
  for (const Segment& segment : skeleton.segments) {
    for (const std::string& name : {segment.from, segment.to}) {
      if (!skeleton.joints.contains(name)) return "there is no '" + name + "' among them";
    }
  }
  const auto outside = joint_outside(skeleton, SurfaceDistance(mesh), unit);
  return outside ? "'" + outside->name + "' lies outside the body" : "";
}

/// The body placed by the given joints; nothing if they are absent or refused.
std::optional<Standing> as_given(const TriangleMesh& mesh, const CleanOptions& options,
                                 const std::string& name, CleanReport& report) {
  if (!options.skeleton) return std::nullopt;
  const double floor = bounds(mesh).min().y();
  const double tall = bounds(mesh).max().y() - floor;
  const double unit = body_unit(options, tall, 0, name);
  report.skeleton_refused = refusal(*options.skeleton, mesh, unit);
  if (!report.skeleton_refused.empty()) return std::nullopt;
  Standing body;
  body.mesh = mesh;
  body.lifted = floor == 0 ? 0 : -floor;
  for (Vec3& p : body.mesh.points) p.y() -= floor;
  body.skeleton = *options.skeleton;
  for (auto& [joint, point] : body.skeleton->joints) {
    point /= unit;
    point.y() -= floor;
  }
  const bool has_all = has_all_limbs(*body.skeleton);
  if (!has_all) report.missing = "the given joints are those of a body that lacks limbs";
  if (const double degrees = has_all ? askew(*body.skeleton) : 0; std::abs(degrees) > max_askew) {
    body.turn = turn_about_y(degrees);
    for (Vec3& p : body.mesh.points) p = body.turn * p;
    for (auto& [joint, point] : body.skeleton->joints) point = body.turn * point;
  }
  // An earlier run may have turned the body. Its joints then lie within the unturned one, too.
  if (has_all && toes_forward(body.mesh, *body.skeleton) < -0.01) {
    report.skeleton_refused = "its toes point to -z";
    return std::nullopt;
  }
  report_turn(uprights().front(), body.turn, report);
  return body;
}

}  // namespace

std::optional<JointOutside> joint_outside(const Skeleton& skeleton, const SurfaceDistance& body,
                                          double unit) {
  for (const Segment& segment : body_segments()) {
    for (const std::string& name : {segment.from, segment.to}) {
      const auto joint = skeleton.joints.find(name);
      if (joint == skeleton.joints.end()) continue;
      const double by = unit * body.closest_point(joint->second / unit).distance;
      if (!(by < joint_tolerance)) return JointOutside{name, by};
    }
  }
  return std::nullopt;
}

CleanBody clean_body(const PolygonSoup& soup, const std::string& name,
                     const CleanOptions& options) {
  CleanBody body;
  CleanReport& report = body.report;
  RepairedSurface surface = repair(soup, name, options.repair);
  report.repair = surface.report;
  refuse_sheet(surface.mesh.points, name);

  std::optional<Standing> given = as_given(surface.mesh, options, name, report);
  Standing standing = given ? std::move(*given) : stand_up(surface.mesh, options, name, report);
  const Vec3 size = bounds(standing.mesh).sizes();
  const double units_tall = bounds(standing.mesh).max().y();
  // A whole body may step out or reach forward.
  const double depth = standing.skeleton ? 0 : std::min(size.x(), size.z());
  report.unit_inferred = !options.metres_per_unit && !options.height;
  report.metres_per_unit = body_unit(options, units_tall, depth, name);
  report.height = units_tall * report.metres_per_unit;
  if (!(report.height >= 0.1 && report.height <= 10)) {
    throw Error(name, "the body would be " + number_text(report.height) + " m tall",
                "give the unit that the file is in with --unit");
  }
  report.lifted = standing.lifted * report.metres_per_unit;
  scale(standing, report.metres_per_unit);
  if (!standing.skeleton) take_lacking(standing, options, name, report);
  report.brought = bring_near(standing);
  for (const FilledHole& hole : report.repair.holes_filled) {
    const double across = hole.across * report.metres_per_unit;
    if (across < large_hole) continue;
    const Vec3 lift(0, standing.lifted, 0);
    report.large_holes.push_back(
        {(standing.turn * hole.middle + lift) * report.metres_per_unit + report.brought, across});
  }
  body.mesh = std::move(standing.mesh);
  body.skeleton = std::move(standing.skeleton);
  if (report.repair.self_intersections_left > 0) {
    report.crossings = crossings_of(body.mesh, body.skeleton);
  }
  report.move = {standing.turn, Vec3(0, report.lifted, 0) + report.brought, report.metres_per_unit};
  if (body.skeleton) {
    BodyMove move = report.move;
    // Joints that came with the body tell of an earlier move.
    if (given && body.skeleton->cleaned) {
      const BodyMove& earlier = *body.skeleton->cleaned;
      move.translation += move.rotation * earlier.translation;
      move.rotation = move.rotation * earlier.rotation;
      move.metres_per_unit = earlier.metres_per_unit;
    }
    body.skeleton->cleaned = move;
  }
  if (body.skeleton) {
    const std::vector<std::string> cut = missing_feet(body.mesh, *body.skeleton);
    if (!cut.empty() && !report.missing.empty()) report.missing += "; ";
    if (cut.size() == 2) {
      report.missing += "both legs end before their feet: heights can't be measured";
    }
    if (cut.size() == 1) report.missing += "the " + cut.front() + " leg ends before a foot";
  }
  report.no_skeleton = std::move(standing.no_skeleton);
  return body;
}

}  // namespace toile
