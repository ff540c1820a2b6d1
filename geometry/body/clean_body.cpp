#include "geometry/body/clean_body.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "geometry/body/find_skeleton.h"
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

double inferred_unit(double height, const std::string& name) {
  for (const double unit : {1.0, 0.1, 0.01, 0.001, 0.0254}) {
    if (height * unit >= 1.0 && height * unit <= 2.3) return unit;
  }
  throw Error(name,
              "a body " + number_text(height) +
                  " units tall is between 1.00 and 2.30 m in none of m, dm, cm, mm, in",
              "give --unit");
}

/// A body turned and lifted to stand on y = 0, in the file's unit.
struct Standing {
  TriangleMesh mesh;
  double lifted = 0;
  std::optional<Skeleton> skeleton;
  std::string no_skeleton;
};

/// Turns the body and lifts it onto y = 0. The matrix holds 0, 1 and -1 only, so no coordinate is
/// rounded but y by the lift.
Standing stand(const TriangleMesh& mesh, const Matrix& turn, const std::string& name) {
  Standing body;
  body.mesh = mesh;
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

/// A turn about y by -90 degrees: +x comes to +z.
Matrix quarter_turn() { return (Matrix() << 0, 0, -1, 0, 1, 0, 1, 0, 0).finished(); }
/// A turn about y by 180 degrees.
Matrix half_turn() { return Vec3(-1, 1, -1).asDiagonal(); }

/// `turn`, followed by a quarter turn if the body is wider from front to back than from side to
/// side. Arms held out make every body widest from side to side.
Matrix sideways(const TriangleMesh& mesh, const Matrix& turn) {
  const Vec3 size = (turn * bounds(mesh).sizes()).cwiseAbs();
  return size.z() > 1.4 * size.x() ? Matrix(quarter_turn() * turn) : turn;
}

/// The index in uprights() of the axis that the body stands along, judged by its box. A box that is
/// clearly longer along z than along y is z-up. Arms out to the sides span hardly more than the
/// body's height.
std::size_t likely_axis(const TriangleMesh& mesh) {
  const Vec3 size = bounds(mesh).sizes();
  return size.z() > 1.5 * size.y() && size.z() >= 0.8 * size.x() ? 1 : 0;
}

Standing stand_up(const TriangleMesh& mesh, const std::string& name, std::string& turned) {
  const std::vector<Upright> axes = uprights();
  std::size_t chosen = likely_axis(mesh);
  Matrix turn = sideways(mesh, axes[chosen].turn);
  Standing body = stand(mesh, turn, name);
  if (!body.skeleton) {
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
      turn = sideways(mesh, axes[chosen].turn);
      body = std::move(other);
    }
  }
  bool about_y = turn != axes[chosen].turn;
  if (body.skeleton && toes_forward(body.mesh, *body.skeleton) < -0.01) {
    turn = half_turn() * turn;
    body = stand(mesh, turn, name);
    about_y = true;
  }
  if (chosen != 0) turned = std::string("from ") + axes[chosen].axis + " up to y up";
  if (about_y) turned += (turned.empty() ? "" : ", and ") + std::string("to face +z");
  return body;
}

void scale(Standing& body, double factor) {
  if (factor == 1) return;
  for (Vec3& p : body.mesh.points) p *= factor;
  if (!body.skeleton) return;
  for (auto& [joint, point] : body.skeleton->joints) point *= factor;
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
  for (const Segment& segment : body_segments()) {
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
  const double unit =
      options.metres_per_unit ? *options.metres_per_unit : inferred_unit(tall, name);
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
  // An earlier run may have turned the body. Its joints then lie within the unturned one, too.
  if (toes_forward(body.mesh, *body.skeleton) < -0.01) {
    report.skeleton_refused = "its toes point to -z";
    return std::nullopt;
  }
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

  std::optional<Standing> given = as_given(surface.mesh, options, name, report);
  Standing standing = given ? std::move(*given) : stand_up(surface.mesh, name, report.turned);
  const double units_tall = bounds(standing.mesh).max().y();
  report.unit_inferred = !options.metres_per_unit;
  report.metres_per_unit =
      options.metres_per_unit ? *options.metres_per_unit : inferred_unit(units_tall, name);
  report.height = units_tall * report.metres_per_unit;
  if (!(report.height >= 0.1 && report.height <= 10)) {
    throw Error(name, "the body would be " + number_text(report.height) + " m tall",
                "give the unit that the file is in with --unit");
  }
  report.lifted = standing.lifted * report.metres_per_unit;
  scale(standing, report.metres_per_unit);
  report.brought = bring_near(standing);
  body.mesh = std::move(standing.mesh);
  body.skeleton = std::move(standing.skeleton);
  report.no_skeleton = std::move(standing.no_skeleton);
  return body;
}

}  // namespace toile
