// make-mannequin: writes the sample body, or a mannequin made to measures.
#include "io/measure_names.h"
#include "io/mesh_file.h"
#include "io/skeleton_file.h"
#include "tools/make_mannequin/run.h"
#include "tools/pose_option.h"
#include "tools/programs.h"

namespace toile {
namespace {

namespace po = boost::program_options;

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
  add_measures(given["measures"].as<std::vector<std::string>>(), settings);
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
  MakeMannequinSettings settings;
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
  job.work = [settings, &common] { return run_make_mannequin(settings, common); };
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
