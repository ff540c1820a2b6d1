// measure-body: a body's landmarks and the measures that tailors take.
#include <map>

#include "geometry/error.h"
#include "io/json_words.h"
#include "io/output_file.h"
#include "io/skeleton_file.h"
#include "tools/measure_body/run.h"
#include "tools/programs.h"

namespace toile {

namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;

std::optional<fs::path> path_given(const po::variables_map& given, const std::string& name) {
  if (given.count(name) == 0) return std::nullopt;
  return given[name].as<std::string>();
}

/// "vit=FILE" and the like.
std::pair<DraftingProgram, fs::path> other_file(const std::string& text) {
  static const std::map<std::string, DraftingProgram> programs = {
      {"vit", DraftingProgram::valentina},
      {"freesewing", DraftingProgram::freesewing},
      {"garmentcode", DraftingProgram::garmentcode}};
  const std::size_t equals = text.find('=');
  const auto found = programs.find(text.substr(0, equals));
  if (equals == std::string::npos || equals + 1 == text.size() || found == programs.end()) {
    throw UsageError("--as", in_quotes(text) + " names no program and file",
                     "give vit=FILE, freesewing=FILE or garmentcode=FILE");
  }
  return {found->second, text.substr(equals + 1)};
}

}  // namespace

CommandLineProgram measure_body_program() {
  CommandLineProgram program;
  program.name = "measure-body";
  program.summary = "takes a body's landmarks and the measures that tailors need";
  program.usage = "body.ply -o measures.json|.csv [options]";
  using Texts = std::vector<std::string>;
  program.options.add_options()("body", po::value<std::string>()->required(),
                                "the body, closed, as clean-body writes it; also as argument")(
      "at", po::value<Texts>()->default_value({}, ""),
      "another measure, as 'girth plane=hip tilt=10deg'; may be repeated")(
      "at-file", po::value<std::string>(), "a file with such measures, one a line")(
      "against", po::value<std::string>(),
      "measures taken before (.json, .csv, .vit, .yaml), to compare with, line by line; in cm "
      "where "
      "their file states no unit")(
      "as", po::value<Texts>()->default_value({}, ""),
      "vit=FILE, freesewing=FILE or garmentcode=FILE: the measures under the names of that "
      "program; may be repeated")("html", po::value<std::string>(),
                                  "write a page that shows each measure on the body")(
      "png", po::value<std::string>(), "write a picture of measures and landmarks on the body")(
      "unit", po::value<std::string>()->default_value("cm"), "of what is written: cm or in");
  program.positional.add("body", 1);
  program.output_extensions = {".json", ".csv"};
  program.prepare = [](const po::variables_map& given, const CommonSettings& common) {
    MeasureBodySettings settings;
    settings.body = given["body"].as<std::string>();
    settings.freehand = given["at"].as<Texts>();
    settings.freehand_file = path_given(given, "at-file");
    settings.against = path_given(given, "against");
    settings.html = path_given(given, "html");
    settings.png = path_given(given, "png");
    settings.unit = given["unit"].as<std::string>();
    if (settings.unit == "in") settings.unit = "inch";
    if (settings.unit != "cm" && settings.unit != "inch") {
      throw UsageError("--unit", in_quotes(settings.unit) + " is unknown", "give cm or in");
    }
    for (const std::string& text : given["as"].as<Texts>()) {
      settings.others.push_back(other_file(text));
    }
    if (settings.html) check_extension(*settings.html, {".html", ".htm"});
    if (settings.png) check_extension(*settings.png, {".png"});
    Job job;
    // The joints are not read, and must not be lost either.
    job.files.reads = {settings.body, skeleton_beside(settings.body)};
    for (const auto& file : {settings.freehand_file, settings.against}) {
      if (file) job.files.reads.push_back(*file);
    }
    job.files.writes = {common.output};
    for (const auto& file : {settings.html, settings.png}) {
      if (file) job.files.writes.push_back(*file);
    }
    for (const auto& [other, file] : settings.others) job.files.writes.push_back(file);
    job.work = [settings, &common] { return run_measure_body(settings, common); };
    return job;
  };
  return program;
}

}  // namespace toile
