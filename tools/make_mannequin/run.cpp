#include "tools/make_mannequin/run.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "geometry/body/measures.h"
#include "io/mesh_file.h"
#include "io/output_file.h"
#include "io/skeleton_file.h"
#include "tools/pose_option.h"
#include "tools/report.h"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

Json report_json(const Mannequin& mannequin) {
  double height = 0;
  for (const Vec3& point : mannequin.surface.points) height = std::max(height, point.y());
  Json girths = Json::object();
  for (const MannequinGirth& girth : mannequin.girths) {
    girths[girth.name] = {
        {"girth_cm", 100 * girth.measured},
        {"target_cm", 100 * girth.target},
        {"centre_cm", {100 * girth.centre.x(), 100 * girth.centre.y(), 100 * girth.centre.z()}},
        {"normal", {girth.normal.x(), girth.normal.y(), girth.normal.z()}},
    };
  }
  return {{"body",
           {{"points", mannequin.surface.points.size()},
            {"triangles", mannequin.surface.triangles.size()},
            {"height_m", height}}},
          {"girths", girths}};
}

Mannequin sample_mannequin(const MannequinOptions& options, const CommonSettings& common) {
  Mannequin mannequin = make_mannequin(options);
  for (const MannequinGirth& girth : mannequin.girths) {
    char line[80];
    std::snprintf(line, sizeof line, "%-12s %6.2f cm", girth.name.c_str(), 100 * girth.measured);
    common.say(line);
  }
  return mannequin;
}

}  // namespace

void add_measures(const std::vector<std::string>& texts, MeasureSettings& settings) {
  for (const std::string& text : texts) {
    if (text.find('=') == std::string::npos) {
      settings.files.emplace_back(text);
    } else {
      settings.measures.push_back(text);
    }
  }
}

MadeMannequin made_mannequin(const MakeMannequinSettings& settings, const CommonSettings& common) {
  MannequinOptions options = settings.mannequin;
  options.pose = pose_of(options.pose_name, PosedFigure::mannequin);
  if (settings.arms) {
    options.pose.left.shoulder_abduction = *settings.arms;
    options.pose.right.shoulder_abduction = *settings.arms;
    check_pose(options.pose, "--arms");
  }
  Json by_measures = Json::object();
  MadeMannequin made;
  made.mannequin = settings.measures
                       ? mannequin_by_measures(*settings.measures, options, common, by_measures)
                       : sample_mannequin(options, common);
  // Landmarks are those of a standing body.
  const bool stands = !is_pose_file(options.pose_name) && options.pose_name == "standing";
  if (stands) {
    const BodyShape shape = find_landmarks(made.mannequin.surface, "mannequin");
    made.landmarks = given_landmarks(shape);
    made.mannequin.skeleton.measures = body_measures(measure_body(shape));
  }
  made.report = report_json(made.mannequin);
  made.report.update(by_measures);
  return made;
}

ExitCode run_make_mannequin(const MakeMannequinSettings& settings, const CommonSettings& common) {
  const auto [mannequin, landmarks, report] = made_mannequin(settings, common);
  OutputFiles files;
  write_mesh(files.at(common.output), mannequin.surface);
  write_skeleton(files.at(skeleton_path(common.output)), mannequin.skeleton, landmarks);
  write_report(files, common, report);
  files.commit();
  // A measure that is missed is a warning.
  const auto warnings = report.find("warnings");
  return warnings != report.end() && !warnings->empty() ? exit_negative : exit_done;
}

}  // namespace toile
