// import-pattern: from a pattern maker's drawing to a pattern in JSON.
#include <algorithm>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "geometry/error.h"
#include "io/output_file.h"
#include "io/text.h"
#include "tools/import_pattern/run.h"
#include "tools/programs.h"

namespace toile {

namespace po = boost::program_options;

namespace {

double read_unit(const std::string& word) {
  if (word == "mm") return 1e-3;
  if (word == "cm") return 1e-2;
  if (word == "inch" || word == "in") return 0.0254;
  throw UsageError("--unit", "'" + shown_text(word) + "' is unknown", "use mm, cm or in");
}

double read_chord_error(const std::string& text) {
  const double error = parse_length(text, "--chord-error");
  if (error < 1e-6 || error > 5e-3) {
    throw UsageError("--chord-error", "'" + shown_text(text) + "' is out of range",
                     "use 0.001mm to 5mm");
  }
  return error;
}

double read_allowance(const std::string& text) {
  const double allowance = parse_length(text, "--seam-allowance");
  if (allowance > 0.1) {
    throw UsageError("--seam-allowance", "'" + shown_text(text) + "' is more than 10 cm",
                     "use 10mm, say");
  }
  return allowance;
}

double read_corner_angle(double degrees) {
  if (!(degrees >= 5 && degrees <= 90)) {
    throw UsageError("--corner-angle", "is not between 5 and 90 degrees", "the default is 25");
  }
  return degrees * std::numbers::pi / 180;
}

/// The names as given, each once. Throws UsageError where a piece is given two.
std::vector<std::string> read_names(const std::vector<std::string>& names) {
  std::vector<std::string> once;
  std::map<std::string, std::string> given;
  for (const std::string& text : names) {
    if (std::find(once.begin(), once.end(), text) != once.end()) continue;
    once.push_back(text);
    const std::size_t equals = text.rfind('=');
    if (equals == std::string::npos) continue;  // refused with the drawing's pieces at hand
    const std::string piece = text.substr(0, equals);
    const std::string name = text.substr(equals + 1);
    const std::string& first = given.emplace(piece, name).first->second;
    if (first == name) continue;
    throw UsageError("--name",
                     "calls '" + shown_text(piece) + "' both '" + shown_text(first) + "' and '" +
                         shown_text(name) + "'",
                     "give a piece one name");
  }
  return once;
}

}  // namespace

void add_import_options(po::options_description& options) {
  options.add_options()("unit", po::value<std::string>(),
                        "of the drawing: mm, cm or in; else as the file says")(
      "size", po::value<std::string>(), "the size to take of a drawing with several")(
      "seam-allowance", po::value<std::string>(),
      "taken off pieces that have a cut line only, such as 10mm")(
      "unfold", po::value<std::vector<std::string>>()->composing(),
      "PIECE or PIECE:EDGE: a half without a mark of its fold; may be repeated")(
      "name", po::value<std::vector<std::string>>()->composing(),
      "PIECE=NAME: what a piece is to be called; may be repeated")(
      "pair", po::value<std::vector<std::string>>()->composing(),
      "PIECE: cut as a pair, left and right; may be repeated")(
      "single", po::value<std::vector<std::string>>()->composing(),
      "PIECE: cut as one panel, though it is taken as a pair; may be repeated")(
      "without", po::value<std::vector<std::string>>()->composing(),
      "PIECE: of which no panel is made; may be repeated")(
      "cut-line", po::bool_switch(), "bound pieces by their cut lines, not by their sew lines")(
      "chord-error", po::value<std::string>()->default_value("0.1mm"),
      "from the drawn outline to the pattern's curves at most")(
      "corner-angle", po::value<double>()->default_value(25),
      "degrees: an outline that turns by more has a corner");
}

void read_import_options(const po::variables_map& given, ImportPatternSettings& settings) {
  const auto texts = [&](const char* option) {
    return given.count(option) > 0 ? given[option].as<std::vector<std::string>>()
                                   : std::vector<std::string>{};
  };
  if (given.count("unit") > 0) settings.drawn.unit = read_unit(given["unit"].as<std::string>());
  if (given.count("size") > 0) settings.pieces.size = given["size"].as<std::string>();
  if (given.count("seam-allowance") > 0) {
    settings.pieces.seam_allowance = read_allowance(given["seam-allowance"].as<std::string>());
  }
  settings.pieces.unfold = texts("unfold");
  settings.pieces.names = read_names(texts("name"));
  settings.pieces.pairs = texts("pair");
  settings.pieces.singles = texts("single");
  settings.pieces.without = texts("without");
  settings.drawn.cut_line = given["cut-line"].as<bool>();
  po::options_description all;
  add_import_options(all);
  for (const auto& option : all.options()) {
    const std::string& name = option->long_name();
    if (given.count(name) == 0 || given[name].defaulted()) continue;
    settings.of_drawings.push_back("--" + name);
  }
  settings.pieces.edges.chord_error = read_chord_error(given["chord-error"].as<std::string>());
  settings.pieces.edges.corner_angle = read_corner_angle(given["corner-angle"].as<double>());
}

CommandLineProgram import_pattern_program() {
  CommandLineProgram program;
  program.name = "import-pattern";
  program.summary = "makes a pattern of the pieces in a DXF (AAMA/ASTM) or SVG drawing";
  program.usage = "DRAWING -o pattern.json [--seam-allowance 10mm]";
  add_import_options(program.options);
  program.options.add_options()("all-sizes", po::bool_switch(),
                                "a pattern of each size: -o is a folder");
  program.options.add_options()("drawing", po::value<std::string>()->required(),
                                "the drawing; also as argument");
  program.positional.add("drawing", 1);
  program.prepare = [](const po::variables_map& given, const CommonSettings& common) {
    ImportPatternSettings settings;
    settings.drawing = given["drawing"].as<std::string>();
    read_import_options(given, settings);
    const bool all_sizes = given["all-sizes"].as<bool>();
    if (all_sizes && !settings.pieces.size.empty()) {
      throw UsageError("--size", "is for one size, and --all-sizes for all", "leave one out");
    }
    if (!all_sizes) check_extension(common.output, {".json"});
    Job job;
    job.files.reads = {settings.drawing};
    (all_sizes ? job.files.folders : job.files.writes) = {common.output};
    job.work = [settings, all_sizes, &common] {
      if (all_sizes) return import_all_sizes(settings, common) ? exit_done : exit_negative;
      return run_import_pattern(settings, common).pattern.left_out.empty() ? exit_done
                                                                           : exit_negative;
    };
    return job;
  };
  return program;
}

}  // namespace toile
