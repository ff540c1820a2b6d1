#include "tools/clean_body/run.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "geometry/body/clean_body.h"
#include "geometry/body/measures.h"
#include "geometry/error.h"
#include "io/floor_height.h"
#include "io/mesh_file.h"
#include "io/output_file.h"
#include "io/sidecar.h"
#include "io/skeleton_file.h"
#include "io/text.h"
#include "tools/clean_body/report.h"
#include "tools/clean_body/scan.h"
#include "tools/report.h"

namespace toile {

namespace {

namespace po = boost::program_options;

std::string unit_name(double metres) {
  for (const auto& [name, size] : length_units()) {
    if (size == metres) return name;
  }
  return "?";
}

std::string number(double value, const char* format) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string count(int n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

/// What was changed, a line each, in the order in which it was done. `scan` is null for a mesh.
void say_changes(const CleanReport& report, const ScanReport* scan, const CommonSettings& common) {
  const RepairReport& r = report.repair;
  const double unit = report.metres_per_unit;
  const bool inferred = scan == nullptr ? report.unit_inferred : scan->unit_inferred;
  const double file_unit = scan == nullptr ? unit : scan->metres_per_unit;
  const auto say_count = [&common](int n, const char* one, const char* many) {
    if (n > 0) common.say(count(n, one, many));
  };
  if (scan == nullptr) {
    common.say("read " + count(r.points_read, "point", "points") + ", " +
               count(r.polygons_read, "polygon", "polygons"));
  }
  say_count(r.points_merged, "point that doubled another, or that nothing used, merged or removed",
            "points that doubled others, or that nothing used, merged or removed");
  say_count(r.polygons_removed, "polygon without area or listed twice removed",
            "polygons without area or listed twice removed");
  say_count(r.polygons_triangulated, "polygon cut into triangles", "polygons cut into triangles");
  say_count(r.points_split, "point split where the surface met itself",
            "points split where the surface met itself");
  say_count(r.borders_stitched, "pair of border edges stitched", "pairs of border edges stitched");
  if (r.components_dropped > 0) {
    common.say(count(r.components_dropped, "separate part", "separate parts") + " dropped, " +
               number(100 * r.dropped_area, "%.2g") + " % of the whole surface");
  }
  if (!r.holes_filled.empty()) {
    common.say(count(static_cast<int>(r.holes_filled.size()), "hole", "holes") +
               " filled, the largest " + number(100 * unit * largest_hole(r), "%.1f") +
               " cm across");
  }
  if (r.turned_inside_out) common.say("turned inside out: its facets faced inward");
  if (r.self_intersections_found > 0) {
    common.say(count(r.self_intersections_found, "pair", "pairs") + " of intersecting triangles, " +
               std::to_string(r.self_intersections_left) +
               " left after repair, which moved the surface by at most " +
               number(1000 * unit * r.largest_move, "%.2f") + " mm");
  }
  if (!report.turned.empty()) common.say("turned " + report.turned);
  if (report.levelled_degrees > 0) {
    common.say("turned by " + number(report.levelled_degrees, "%.1f") +
               " degrees to stand upright (--up keeps it as it is)");
  }
  if (inferred) {
    common.say("unit taken to be " + unit_name(file_unit) + ", since the body is then " +
               number(report.height, "%.2f") + " m tall (--unit or --height states it)");
  }
  // A scan's floor is never met to the last bit.
  if (std::abs(report.lifted) > (scan == nullptr ? 0 : 5e-5)) {
    common.say("lifted by " + number(100 * report.lifted, "%.2f") + " cm to stand on y = 0");
  }
  if (!report.brought.isZero(0)) {
    common.say("moved by " + number(report.brought.x(), "%.2f") + " m along x and " +
               number(report.brought.z(), "%.2f") + " m along z: it stood too far from the origin");
  }
}

/// "95 cm above the floor, at the left leg", or at x and z where there are no joints.
std::string place_of(const Vec3& point, const std::optional<Skeleton>& skeleton) {
  std::string part = skeleton ? name_of(part_near(*skeleton, point)) : "";
  std::replace(part.begin(), part.end(), '_', ' ');
  return floor_height(point.y()) + ", at " +
         (part.empty()
              ? "x " + number(point.x(), "%.2f") + " m, z " + number(point.z(), "%.2f") + " m"
              : "the " + part);
}

std::string crossing_warning(const Crossings& crossings) {
  std::string part = name_of(crossings.part);
  std::replace(part.begin(), part.end(), '_', ' ');
  const std::string where = count(crossings.pairs, "pair", "pairs") + " of triangles cross on " +
                            number(100 * crossings.area_share, "%.2g") + " % of the surface, " +
                            floor_heights(crossings.low, crossings.high) +
                            (part.empty() ? "" : ", most at the " + part);
  if (is_usable(crossings)) {
    return where +
           "; they can't be repaired safely; a drape that lies there may be called intersecting";
  }
  return where +
         "; this body can't be relied on: cloth there is fitted to a surface that no person has; "
         "repair it in a mesh editor";
}

/// What the user should know about the body as it is written.
std::vector<std::string> warnings_about(const CleanBody& body) {
  const CleanReport& report = body.report;
  const RepairReport& r = report.repair;
  const double unit = report.metres_per_unit;
  std::vector<std::string> warnings;
  for (const FilledHole& hole : report.large_holes) {
    warnings.push_back("a hole " + number(100 * hole.across, "%.1f") + " cm across was filled, " +
                       place_of(hole.middle, body.skeleton) + "; the surface there is a guess");
  }
  if (report.crossings) warnings.push_back(crossing_warning(*report.crossings));
  if (r.dropped_area > 0.05) {
    warnings.push_back("the parts dropped are " + number(100 * r.dropped_area, "%.0f") +
                       " % of the surface; was the body one piece?");
  }
  const bool is_form = body.skeleton && !body.skeleton->joints.contains("left_ankle");
  if ((report.height < 1.0 && !is_form) || report.height > 2.3) {
    warnings.push_back("the body is " + number(report.height, "%.2f") +
                       " m tall; is the unit right?");
  }
  // Programs that scale all models to one size write 1 or 2 units, to single precision.
  const double whole = report.height / unit;
  if (report.unit_inferred && unit == 1 &&
      (std::abs(whole - 1) < 1e-6 || std::abs(whole - 2) < 1e-6)) {
    warnings.push_back("the body is exactly " +
                       count(static_cast<int>(std::lround(whole)), "unit", "units") +
                       " tall, as files of no true size are; metres are a guess; give --height, "
                       "or --unit");
  }
  return warnings;
}

std::optional<AxisDirection> read_direction(const po::variables_map& given, const char* option) {
  if (given.count(option) == 0) return std::nullopt;
  const std::optional<AxisDirection> direction = axis_direction(given[option].as<std::string>());
  if (!direction) {
    throw po::error("--" + std::string(option) + " is one of x, -x, y, -y, z, -z");
  }
  return direction;
}

/// Whether an earlier run's skeleton is beside a body that has none. It would be taken for that
/// body's.
bool is_stale_skeleton(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) return false;
  try {
    read_skeleton(path);
  } catch (const Error&) {
    return false;  // not ours
  }
  return true;
}

}  // namespace

void add_body_options(po::options_description& options) {
  options.add_options()("unit", po::value<std::string>(),
                        "the unit of the body's file: m, dm, cm, mm or in; told from the body's "
                        "height when not given")("height", po::value<std::string>(),
                                                 "how tall the body is, such as 168cm, where its "
                                                 "file has no unit of length: 30cm to 3m")(
      "up", po::value<std::string>(),
      "the axis of the body's file that points up: x, y, z, or --up=-z; found when not given")(
      "front", po::value<std::string>(),
      "the axis of the body's file that it faces along; found when not given")(
      "points", po::bool_switch(), "take a mesh's points as a scan and ignore its faces");
}

void read_body_options(const po::variables_map& given, CleanBodySettings& settings) {
  if (given.count("unit") != 0) {
    const auto unit = length_units().find(given["unit"].as<std::string>());
    if (unit == length_units().end()) throw po::error("--unit is one of m, dm, cm, mm, in");
    settings.metres_per_unit = unit->second;
  }
  if (given.count("height") != 0) {
    if (settings.metres_per_unit) throw po::error("--unit and --height both state the size");
    const std::string text = given["height"].as<std::string>();
    settings.height = parse_length(text, "--height");
    if (*settings.height < 0.3 || *settings.height > 3) {
      throw UsageError("--height", "'" + text + "' is out of range", "use 30cm to 3m");
    }
  }
  settings.as_points = given["points"].as<bool>();
  settings.up = read_direction(given, "up");
  settings.front = read_direction(given, "front");
  if (settings.up && settings.front && settings.up->axis == settings.front->axis) {
    throw po::error("--up and --front are along the same axis");
  }
}

std::pair<std::optional<Skeleton>, std::string> joints_beside(const CleanBodySettings& settings) {
  const std::filesystem::path beside = skeleton_beside(settings.inputs.front());
  std::optional<Skeleton> joints;
  if (std::filesystem::exists(beside)) joints = read_skeleton(beside);
  return {joints, beside.string()};
}

CleanedInput clean_input(BodyInput& input, const std::optional<Skeleton>& joints,
                         const std::string& joints_name, const CleanBodySettings& settings,
                         const CommonSettings& common) {
  CleanedInput cleaned;
  std::optional<ScanReport>& scan = cleaned.scan;
  CleanOptions options;
  options.skeleton = joints;
  options.metres_per_unit = settings.metres_per_unit;
  options.height = settings.height;
  options.up = settings.up;
  options.level = !settings.up;
  options.front = settings.front;
  if (!input.scan.points.empty()) {
    if (input.left_out > 0) {
      common.say(std::to_string(input.left_out) + " of " +
                 std::to_string(input.left_out + input.scan.points.size()) +
                 " points left out, evenly: no more are needed");
    }
    ScanOptions scan_options;
    scan_options.metres_per_unit = settings.metres_per_unit;
    scan_options.height = settings.height;
    scan_options.up = settings.up;
    if (settings.edge_length) scan_options.edge_length = *settings.edge_length;
    ReconstructedScan made = reconstruct_scan(input.scan, input.name, scan_options);
    scan = std::move(made.report);
    input.scan = {};
    input.soup.points = std::move(made.mesh.points);
    for (const Triangle& t : made.mesh.triangles) input.soup.polygons.push_back({t[0], t[1], t[2]});
    options.metres_per_unit = 1;
    if (scan->floor_found) options.up = scan->up;
    say_scan(*scan, input.files, common);
  } else if (settings.edge_length) {
    throw Error("--edge-length", "is of scans, and " + input.name + " is a mesh",
                "leave it out, or add --points");
  }
  CleanBody& body = cleaned.body;
  body = clean_body(input.soup, input.name, options);
  if (scan && body.skeleton && body.skeleton->cleaned) {
    body.skeleton->cleaned->metres_per_unit = scan->metres_per_unit;
    body.skeleton->cleaned->rotation = body.skeleton->cleaned->rotation * scan->level;
  }
  say_changes(body.report, scan ? &*scan : nullptr, common);
  std::vector<std::string>& warnings = cleaned.warnings;
  warnings = warnings_about(body);
  if (scan) {
    warn_of_scan(*scan, warnings);
    cleaned.holes = placed_holes(*scan, body);
    say_holes(cleaned.holes, common, warnings);
  }
  common.say((is_usable(body.report.crossings) ? "a closed body of " : "a closed surface of ") +
             std::to_string(body.mesh.points.size()) + " points, " +
             number(100 * body.report.height, "%.2f") + " cm tall");
  if (!body.report.skeleton_refused.empty()) {
    warnings.push_back(joints_name + " is not this body's, " + body.report.skeleton_refused +
                       "; its joints are searched for");
  } else if (options.skeleton) {
    cleaned.joints_given = true;
    common.say("joints taken from " + joints_name);
  }
  if (!body.skeleton) warnings.push_back(body.report.no_skeleton);
  if (!body.report.missing.empty()) warnings.push_back(input.name + ": " + body.report.missing);
  if (body.skeleton) {
    const BodyShape shape = find_landmarks(body.mesh, input.name);
    cleaned.landmarks = given_landmarks(shape);
    body.skeleton->measures = body_measures(measure_body(shape));
  }
  return cleaned;
}

nlohmann::ordered_json cleaned_json(const CleanedInput& cleaned, const BodyInput& input) {
  nlohmann::ordered_json report =
      clean_body_json(cleaned.body, cleaned.joints_given, cleaned.warnings);
  report["read"]["file"] = valid_utf8(input.name);
  if (const std::optional<ScanReport>& scan = cleaned.scan) {
    report["read"]["points"] = input.left_out + static_cast<std::size_t>(scan->points_read);
    report["read"]["polygons"] = 0;
    report["unit"] = {{"metres", scan->metres_per_unit}, {"inferred", scan->unit_inferred}};
    report["scan"] = scan_json(*scan, input.files, cleaned.holes);
  }
  return report;
}

CleanBodyResult run_clean_body(const CleanBodySettings& settings, const CommonSettings& common) {
  BodyInput input = read_body_input(settings);
  const auto [given, beside] = joints_beside(settings);
  CleanedInput cleaned = clean_input(input, given, beside, settings, common);
  const CleanBody& body = cleaned.body;
  std::vector<std::string>& warnings = cleaned.warnings;
  const std::filesystem::path joints = skeleton_path(common.output);
  std::vector<std::filesystem::path> stale;
  for (const auto& path : {joints, earlier_sidecar_path(common.output)}) {
    if (!body.skeleton && is_stale_skeleton(path)) stale.push_back(path);
  }
  for (const auto& path : stale) {
    warnings.push_back(path.string() + " was another body's skeleton and is removed");
  }
  for (const std::string& warning : warnings) CommonSettings::warn(warning);
  OutputFiles files;
  write_mesh(files.at(common.output), body.mesh);
  if (body.skeleton) {
    write_skeleton(files.at(joints), *body.skeleton, cleaned.landmarks);
  }
  write_report(files, common, cleaned_json(cleaned, input));
  files.commit();
  for (const auto& path : stale) std::filesystem::remove(path);
  return {warnings, is_usable(body.report.crossings)};
}

}  // namespace toile
