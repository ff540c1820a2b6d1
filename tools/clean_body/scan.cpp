#include "tools/clean_body/scan.h"

#include <Eigen/Core>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/floor_height.h"
#include "io/point_file.h"
#include "io/text.h"

namespace toile {

namespace {

/// Square metres of a hole that deserves a warning: 5 cm by 5 cm, as large_hole.
constexpr double large_scan_hole = large_hole * large_hole;

std::string counted(int n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

/// Where a hole is that no camera sees well, or the part of the body.
std::string place_name(const Skeleton& skeleton, const Vec3& at) {
  std::vector<std::pair<std::string, Vec3>> places;
  const auto add = [&](const std::string& place, const std::string& joint, const auto& at_joint) {
    const auto found = skeleton.joints.find(joint);
    if (found != skeleton.joints.end()) places.emplace_back(place, at_joint(found->second));
  };
  const auto itself = [](const Vec3& joint) { return joint; };
  add("crown", "head", itself);
  add("crotch", "pelvis", itself);
  const double armpits = skeleton.joint("chest").y();
  for (const std::string side : {"left", "right"}) {
    add(side + " armpit", side + "_shoulder", [&](const Vec3& joint) {
      return Vec3(joint.x(), std::min(joint.y(), armpits), joint.z());
    });
    add(side + " sole", side + "_ankle",
        [](const Vec3& joint) { return Vec3(joint.x(), 0, joint.z() + 0.05); });
  }
  constexpr double near = 0.1;  // metres
  const auto off = [&](const auto& place) { return (place.second - at).norm(); };
  const auto nearest = std::min_element(
      places.begin(), places.end(), [&](const auto& a, const auto& b) { return off(a) < off(b); });
  if (off(*nearest) < near) return nearest->first;
  std::string part = name_of(part_near(skeleton, at));
  std::replace(part.begin(), part.end(), '_', ' ');
  return part;
}

std::string hole_text(const PlacedHole& hole) {
  return fixed_number(1e4 * hole.area, 0) + " cm² that no point is near, " +
         floor_height(hole.centre.y()) + ", at " +
         (hole.place.empty() ? "x " + fixed_number(hole.centre.x(), 2) + " m, z " +
                                   fixed_number(hole.centre.z(), 2) + " m"
                             : "the " + hole.place);
}

}  // namespace

BodyInput read_body_input(const CleanBodySettings& settings) {
  BodyInput input;
  input.files = static_cast<int>(settings.inputs.size());
  input.name = settings.inputs.front().string();
  bool has_normals = true;
  for (std::size_t i = 0; i < settings.inputs.size(); ++i) {
    BodyFile file = read_body_file(settings.inputs[i]);
    if (input.files == 1 && !settings.as_points && !file.soup.polygons.empty()) {
      if (!settings.poses.empty()) {
        throw Error("--pose", "is of scans, and " + input.name + " is a mesh",
                    "leave it out, or add --points");
      }
      input.soup = std::move(file.soup);
      return input;
    }
    Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
    if (!settings.poses.empty()) pose = read_scan_pose(settings.poses[i]);
    const Eigen::Matrix3d turn = pose.topLeftCorner<3, 3>();
    const Vec3 move = pose.topRightCorner<3, 1>();
    const std::size_t share = BodyInput::most_points / settings.inputs.size();
    const std::size_t every =
        std::max<std::size_t>(1, (file.soup.points.size() + share - 1) / share);
    const std::size_t before = input.scan.points.size();
    has_normals = has_normals && !file.normals.empty();
    for (std::size_t k = 0; k < file.soup.points.size(); k += every) {
      input.scan.points.emplace_back(turn * file.soup.points[k] + move);
      if (has_normals) input.scan.normals.emplace_back(turn * file.normals[k]);
    }
    input.left_out += file.soup.points.size() - (input.scan.points.size() - before);
  }
  if (!has_normals) input.scan.normals.clear();
  return input;
}

std::vector<PlacedHole> placed_holes(const ScanReport& scan, const CleanBody& body) {
  std::vector<PlacedHole> holes;
  const BodyMove& move = body.report.move;
  for (const ScanHole& hole : scan.holes) {
    const Vec3 centre = move.rotation * hole.centre + move.translation;
    holes.push_back({body.skeleton ? place_name(*body.skeleton, centre) : "", centre, hole.area});
  }
  return holes;
}

void say_scan(const ScanReport& scan, int files, const CommonSettings& common) {
  common.say("read " + counted(scan.points_read, "point", "points") + " of " +
             counted(files, "file", "files") +
             (scan.normals_given ? ", with normals" : ", normals are found"));
  if (scan.outliers > 0) {
    common.say(counted(scan.outliers, "point", "points") + " dropped that few others are near");
  }
  if (scan.floor > 0) {
    common.say(counted(scan.floor, "point", "points") + " of the floor dropped");
  }
  if (scan.stray > 0) {
    common.say(counted(scan.stray, "point", "points") + " of " +
               counted(scan.stray_parts, "other thing", "other things") + " dropped");
  }
  if (scan.floor_slope > 0) {
    common.say("turned by " + fixed_number(scan.floor_slope, 1) +
               " degrees: the floor sloped by as much");
  }
  common.say(std::to_string(scan.kept) + " points of a body, about " +
             fixed_number(1000 * scan.spacing, 1) + " mm apart, with " +
             fixed_number(1000 * scan.noise, 1) + " mm of noise");
  if (scan.floor_found && !scan.up_given && scan.up.name() != "y") {
    common.say("the floor tells that it stands along " + scan.up.name() + " (--up states it)");
  }
  common.say("the surface is " + fixed_number(1000 * scan.error_rms, 2) +
             " mm from the points (rms), 95 % of them are within " +
             fixed_number(1000 * scan.error_95, 2) + " mm; they are near to " +
             fixed_number(100 * scan.seen, 1) + " % of it");
}

void warn_of_scan(const ScanReport& scan, std::vector<std::string>& warnings) {
  constexpr double steep = 8;  // degrees; a scanner on a stand is off by less
  if (scan.lies) {
    warnings.push_back(
        "the body lies on a floor, or leans on a wall: no camera saw what is there, and girths may "
        "be 4 cm wrong; scan it standing free");
  }
  // Outliers among the kept points are a tenth of that.
  constexpr double most_off = 0.01;
  if (scan.off_surface > most_off) {
    warnings.push_back(fixed_number(100 * scan.off_surface, 0) + " % of the points are more than " +
                       fixed_number(100 * far_off, 0) +
                       " cm off the surface: what they show, such as another person, is left out; "
                       "scan one person alone");
  }
  if (scan.floor_slope > steep) {
    warnings.push_back("the floor sloped by " + fixed_number(scan.floor_slope, 0) +
                       " degrees and was taken to be level; is the scan turned right?");
  }
}

void say_holes(const std::vector<PlacedHole>& holes, const CommonSettings& common,
               std::vector<std::string>& warnings) {
  for (const PlacedHole& hole : holes) {
    if (hole.area < large_scan_hole) {
      common.say("hole closed: " + hole_text(hole));
    } else {
      warnings.push_back("a hole was closed: " + hole_text(hole) +
                         "; the surface there is a guess");
    }
  }
}

nlohmann::ordered_json scan_json(const ScanReport& scan, int files,
                                 const std::vector<PlacedHole>& holes) {
  nlohmann::ordered_json listed = nlohmann::ordered_json::array();
  for (const PlacedHole& hole : holes) {
    listed.push_back({{"place", hole.place},
                      {"area_cm2", 1e4 * hole.area},
                      {"centre_m", {hole.centre.x(), hole.centre.y(), hole.centre.z()}}});
  }
  return {{"files", files},
          {"points", scan.points_read},
          {"dropped",
           {{"outliers", scan.outliers},
            {"floor", scan.floor},
            {"stray", scan.stray},
            {"stray_parts", scan.stray_parts}}},
          {"kept", scan.kept},
          {"normals_given", scan.normals_given},
          {"spacing_mm", 1000 * scan.spacing},
          {"noise_mm", 1000 * scan.noise},
          {"up", scan.up.name()},
          {"floor_found", scan.floor_found},
          {"floor_slope_degrees", scan.floor_slope},
          {"lies", scan.lies},
          {"seen_percent", 100 * scan.seen},
          {"holes", listed},
          {"error_mm", {{"rms", 1000 * scan.error_rms}, {"p95", 1000 * scan.error_95}}}};
}

}  // namespace toile
