// make-mannequin: writes the sample body, or a mannequin made to measures.
#include <cstdio>
#include <nlohmann/json.hpp>

#include "geometry/body/find_landmarks.h"
#include "geometry/body/mannequin/mannequin.h"
#include "io/measure_names.h"
#include "io/mesh_file.h"
#include "io/output_file.h"
#include "io/skeleton_file.h"
#include "tools/make_mannequin/by_measures.h"
#include "tools/pose_option.h"
#include "tools/programs.h"
#include "tools/report.h"

namespace toile {
namespace {

namespace po = boost::program_options;
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

/// What the command line asks for.
struct Settings {
  MannequinOptions mannequin;
  std::optional<double> arms;  ///< degrees away from the trunk, of the standing pose
  std::optional<MeasureSettings> measures;
};

ExitCode write_mannequin(const Settings& settings, const CommonSettings& common) {
  MannequinOptions options = settings.mannequin;
  options.pose = pose_of(options.pose_name, PosedFigure::mannequin);
  if (settings.arms) {
    options.pose.left.shoulder_abduction = *settings.arms;
    options.pose.right.shoulder_abduction = *settings.arms;
    check_pose(options.pose, "--arms");
  }
  Json by_measures = Json::object();
  const Mannequin mannequin =
      settings.measures ? mannequin_by_measures(*settings.measures, options, common, by_measures)
                        : sample_mannequin(options, common);
  OutputFiles files;
  write_mesh(files.at(common.output), mannequin.surface);
  // Landmarks are those of a standing body.
  const bool stands = !is_pose_file(options.pose_name) && options.pose_name == "standing";
  write_skeleton(
      files.at(skeleton_path(common.output)), mannequin.skeleton,
      stands ? given_landmarks(find_landmarks(mannequin.surface, "mannequin")) : Landmarks{});
  Json report = report_json(mannequin);
  report.update(by_measures);
  write_report(files, common, report);
  files.commit();
  // A measure that is missed is a warning.
  return by_measures.contains("warnings") && !by_measures["warnings"].empty() ? exit_negative
                                                                              : exit_done;
}

std::optional<MeasureSettings> measures_of(const po::variables_map& given) {
  if (given.count("measures") == 0) {
    for (const char* option : {"unit", "figure", "cup"}) {
      if (given.count(option) != 0) {
        throw po::error(std::string("--") + option + " goes with --measures");
      }
    }
    return std::nullopt;
  }
  MeasureSettings settings;
  for (const std::string& text : given["measures"].as<std::vector<std::string>>()) {
    if (text.find('=') == std::string::npos) {
      settings.files.emplace_back(text);
    } else {
      settings.measures.push_back(text);
    }
  }
  if (given.count("unit") != 0) {
    const auto unit = length_units().find(given["unit"].as<std::string>());
    if (unit == length_units().end()) throw po::error("--unit is none of cm, mm, dm, m, in");
    settings.unit = unit->second;
  }
  if (given.count("figure") != 0) settings.figure = given["figure"].as<std::string>();
  if (given.count("cup") != 0) settings.cup = given["cup"].as<std::string>();
  if (!settings.figure.empty() && settings.figure != "woman" && settings.figure != "man" &&
      settings.figure != "child") {
    throw po::error("--figure is none of woman, man, child");
  }
  settings.scales_edges = given["edge-length"].defaulted();
  return settings;
}

/// In lines of a terminal's width.
std::string names_of_measures() {
  constexpr std::size_t width = 80;
  std::string text;
  std::size_t column = 18;  // after "Names of measures:"
  for (const MeasureName& measure : measure_names()) {
    std::string word = std::string(measure.name) + (measure.is_sided ? " (left_, right_)" : "");
    if (&measure != &measure_names().back()) word += ',';
    const bool wraps = column + 1 + word.size() > width;
    if (!text.empty()) text += wraps ? '\n' : ' ';
    column = wraps ? word.size() : column + 1 + word.size();
    text += word;
  }
  return text;
}

Job prepare(const po::variables_map& given, const CommonSettings& common) {
  Settings settings;
  settings.mannequin.edge_length =
      parse_length(given["edge-length"].as<std::string>(), "--edge-length");
  settings.mannequin.pose_name = given["pose"].as<std::string>();
  if (given.count("arms") != 0) settings.arms = given["arms"].as<double>();
  settings.measures = measures_of(given);
  check_mesh_extension(common.output);
  Job job;
  if (is_pose_file(settings.mannequin.pose_name)) job.files.reads = {settings.mannequin.pose_name};
  if (settings.measures) {
    settings.measures->pose_is_given = given.count("arms") != 0 || !given["pose"].defaulted();
    for (const auto& file : settings.measures->files) job.files.reads.push_back(file);
  }
  job.files.writes = {common.output, skeleton_path(common.output)};
  job.work = [settings, &common] { return write_mannequin(settings, common); };
  return job;
}

}  // namespace

CommandLineProgram make_mannequin_program() {
  CommandLineProgram program;
  program.name = "make-mannequin";
  program.summary =
      "writes a body made to measures, or the sample: 1.70 m tall, bust 93.6, waist 70.7, hip 98 "
      "cm";
  program.usage =
      "-o body.ply [--measures FILE|NAME=NUMBER ...] [--figure woman|man|child] "
      "[--pose standing|walking|FILE.json] [--edge-length 9mm]";
  program.options.add_options()("edge-length", po::value<std::string>()->default_value("9mm"),
                                "mean edge of the mesh, 4mm to 15mm")(
      "pose", po::value<std::string>()->default_value("standing"),
      "standing, walking, or a file that gives joints' angles")(
      "arms", po::value<double>(), "degrees of the arms away from the trunk, 25 to 80")(
      "measures", po::value<std::vector<std::string>>()->composing(),
      "a file of measures (.json, .csv, .vit, .smis, .vst, .smms, .yaml) or NAME=NUMBER; may be "
      "repeated")("unit", po::value<std::string>(),
                  "of measures that state none: cm (the default), mm, dm, m or in")(
      "figure", po::value<std::string>(), "proportions of what is not given: woman, man or child")(
      "cup", po::value<std::string>(), "AA to H, in place of a measured underbust");
  program.footer = "Names of measures: " + names_of_measures() +
                   ". Those with (left_, right_) may be given for each side.";
  program.prepare = prepare;
  return program;
}

}  // namespace toile
