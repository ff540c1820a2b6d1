#include "tools/ease_map/run.h"

#include <cmath>

#include "cloth/scene/closed_body.h"
#include "cloth/scene/constants.h"
#include "geometry/error.h"
#include "io/mesh_file.h"
#include "io/output_file.h"
#include "io/skeleton_file.h"
#include "io/text.h"
#include "pattern/garment_file.h"
#include "tools/ease_map/report.h"

namespace toile {

namespace {

namespace fs = std::filesystem;

/// Girths at the levels that the body's joints tell; none, with a note, where there are no joints.
std::vector<GirthEase> girths_of(const EaseReport& report, const SurfaceDistance& skin,
                                 const EaseMapSettings& settings, const CommonSettings& common) {
  const fs::path path = settings.skeleton.value_or(skeleton_path(settings.body));
  if (!settings.skeleton && !fs::exists(path)) {
    common.say("no girth ease: there are no joints in " + path.string() +
               "; clean-body writes them beside the body");
    return {};
  }
  const Skeleton skeleton = read_skeleton_of(skin, path);
  for (const char* joint : {"pelvis", "waist", "chest"}) {
    if (skeleton.joints.count(joint) == 0) {
      throw Error(path.string(), std::string("has no joint '") + joint + "'",
                  "let clean-body write it");
    }
  }
  return measure_girth_ease(report.garment, report.body, skeleton);
}

void warn_if_implausible(const EaseReport& report) {
  const EaseStatistics& all = report.map.garment;
  if (all.p50 > 0.5) {
    CommonSettings::warn("half of the garment is more than " +
                         std::to_string(std::lround(100 * all.p50)) +
                         " cm away from the body: are both in metres and in the same place?");
  } else if (all.inside > 0.01) {
    CommonSettings::warn(std::to_string(std::lround(100 * all.inside)) +
                         " % of the garment's area lies inside the body");
  }
}

/// What is cut smaller than the body goes around it by being stretched.
void warn_if_too_small(const std::vector<GirthEase>& girths) {
  for (const GirthEase& girth : girths) {
    const double missing = girth.body - girth.as_cut;
    if (girth.level.empty() || missing < flesh_give) continue;
    CommonSettings::warn("at the " + girth.level + " the garment is cut " +
                         fixed_number(100 * missing, 1) +
                         " cm smaller than the body, and stretched by that");
  }
}

}  // namespace

void run_ease_map(const EaseMapSettings& settings, const CommonSettings& common) {
  if (settings.ply) check_extension(*settings.ply, {".ply"});  // only PLY files hold colours
  if (settings.png) check_extension(*settings.png, {".png"});
  EaseReport report;
  report.garment = read_dressed(settings.garment);
  report.body = read_closed_body(settings.body);
  report.options = settings.ease;
  report.garment_name = settings.garment.filename().string();
  report.body_name = settings.body.filename().string();
  const SurfaceDistance skin(report.body);
  report.map = measure_ease(report.garment, skin, settings.ease);
  report.girths = girths_of(report, skin, settings, common);
  report.top = settings.top.value_or(suggested_top(report.map));
  warn_if_implausible(report);
  warn_if_too_small(report.girths);
  if (!common.quiet) {
    for (const std::string& line : ease_summary(report)) common.say(line);
  }

  if (settings.csv) write_file(*settings.csv, ease_csv(report));
  if (settings.json) write_file(*settings.json, ease_json(report));
  if (common.report) write_file(*common.report, ease_json(report));
  if (settings.ply) {
    write_mesh(*settings.ply, {report.garment.points, report.garment.triangles},
               ease_colours(report));
  }
  std::vector<int> widths = {420};
  if (settings.png) widths.push_back(900);
  const std::vector<std::string> pictures = ease_pictures(report, widths);
  if (settings.png) write_file(*settings.png, pictures[1]);
  write_file(common.output, ease_page(report, pictures[0]));
  common.say("wrote " + common.output.string());
}

}  // namespace toile
