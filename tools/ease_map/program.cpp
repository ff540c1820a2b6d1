// ease-map: how far a dressed garment stands off the body, to look at and to calculate with.
#include <algorithm>

#include "io/output_file.h"
#include "io/skeleton_file.h"
#include "io/text.h"
#include "tools/ease_map/dress_report.h"
#include "tools/ease_map/pdf.h"
#include "tools/ease_map/run.h"
#include "tools/programs.h"

namespace toile {

namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;

std::optional<fs::path> path_option(const po::variables_map& given, const std::string& name) {
  if (given.count(name) == 0) return std::nullopt;
  return given[name].as<std::string>();
}

}  // namespace

CommandLineProgram ease_map_program() {
  CommandLineProgram program;
  program.name = "ease-map";
  program.summary = "measures and shows the gap between a dressed garment and the body";
  program.usage =
      "--body body.ply dressed.obj -o ease.html [options]\n"
      "       ease-map --body body.ply dressed.obj --report ease.json [options]";
  program.options.add_options()("body", po::value<std::string>()->required(),
                                "the body, closed, as clean-body writes it")(
      "garment", po::value<std::string>()->required(), "the dressed garment; also as argument")(
      "garment-mesh", po::value<std::string>(),
      "the garment before it was dressed, for strain, tension and pressure (default: the one that "
      "the report of dress names)")(
      "csv", po::value<std::string>(),
      "write panel, flat and space coordinates, gap, strain, tension and pressure of each point")(
      "ply", po::value<std::string>(),
      "write the garment with a colour, gap and loads at each point, and loads of each triangle")(
      "png", po::value<std::string>(), "write a picture, front and back")(
      "pdf", po::value<std::string>(), "write the page as a PDF file, A4; needs Chromium")(
      "glb", po::value<std::string>(),
      "write body and garment as glTF, for Blender and other 3D programs")(
      "glb-thickness", po::value<std::string>(),
      "thickness of the cloth there (default: a surface)")(
      "skeleton", po::value<std::string>(),
      "the body's joints, for girths (default: body.body.json beside the body)")(
      "dress-report", po::value<std::string>(),
      "the report of dress, for its verdict and warnings (default: dressed.json beside "
      "dressed.obj)")(
      "contact", po::value<std::string>(),
      "cloth nearer than this counts as touching (default: 1 mm more than the offset of the drape, "
      "if there is a report of dress, else 3 mm)")(
      "target", po::value<std::string>(),
      "the ease that is meant: close, fitted, semi-fitted, loose, or a JSON file of your own")(
      "repeat", po::value<std::vector<std::string>>()->composing(),
      "another drape of this garment on this body, on another mesh or from another start: errors "
      "are then of their spread; give two or more")(
      "against", po::value<std::string>(),
      "another drape, or the folder of toile fit, to show the differences from: another size, "
      "fabric, body or edit")(
      "at", po::value<std::vector<std::string>>()->composing(),
      "also measure the trunk's girth at this height above the floor; may be given again")(
      "top", po::value<std::string>(),
      "gap at the end of the colour scale; to compare garments (default: to suit this one)");
  program.positional.add("garment", 1);
  program.output_extensions = {".html", ".htm"};
  program.instead_of_output = {"report", "csv", "ply", "png", "pdf", "glb"};
  program.prepare = [](const po::variables_map& given, const CommonSettings& common) {
    EaseMapSettings settings;
    settings.garment = given["garment"].as<std::string>();
    settings.body = given["body"].as<std::string>();
    settings.csv = path_option(given, "csv");
    settings.ply = path_option(given, "ply");
    settings.png = path_option(given, "png");
    settings.pdf = path_option(given, "pdf");
    settings.glb = path_option(given, "glb");
    if (given.count("glb-thickness") != 0) {
      if (!settings.glb)
        throw UsageError("--glb-thickness", "is of the file of --glb", "give both");
      settings.thickness =
          parse_length(given["glb-thickness"].as<std::string>(), "--glb-thickness");
    }
    settings.skeleton = path_option(given, "skeleton");
    settings.dress_report = path_option(given, "dress-report");
    settings.meshed = path_option(given, "garment-mesh");
    if (given.count("contact") != 0) {
      settings.contact = parse_length(given["contact"].as<std::string>(), "--contact");
    }
    if (given.count("top") != 0)
      settings.top = parse_length(given["top"].as<std::string>(), "--top");
    if (given.count("target") != 0) {
      settings.targets = read_ease_targets(given["target"].as<std::string>());
    }
    if (given.count("repeat") != 0) {
      const auto& files = given["repeat"].as<std::vector<std::string>>();
      settings.repeats.assign(files.begin(), files.end());
      for (std::size_t i = 0; i < files.size(); ++i) {
        if (files[i] == settings.garment || std::count(files.begin(), files.end(), files[i]) > 1) {
          throw UsageError("--repeat", "'" + shown_text(files[i]) + "' is given twice",
                           "give another drape");
        }
      }
      if (files.size() < 2) {
        throw UsageError("--repeat", "is given once",
                         "give two drapes or more: one tells no spread");
      }
    }
    settings.against = path_option(given, "against");
    if (settings.against && fs::is_directory(*settings.against)) *settings.against /= "dressed.obj";
    if (given.count("at") != 0) {
      for (const std::string& height : given["at"].as<std::vector<std::string>>()) {
        settings.heights.push_back(parse_length(height, "--at"));
      }
    }
    if (settings.ply) check_extension(*settings.ply, {".ply"});  // only PLY files hold colours
    if (settings.png) check_extension(*settings.png, {".png"});
    if (settings.pdf) {
      check_extension(*settings.pdf, {".pdf"});
      check_printer();
    }
    if (settings.glb) check_extension(*settings.glb, {".glb"});
    Job job;
    job.files.reads = {settings.garment, settings.body,
                       settings.skeleton.value_or(skeleton_beside(settings.body)),
                       settings.dress_report.value_or(dress_report_path(settings.garment))};
    if (settings.meshed) job.files.reads.push_back(*settings.meshed);
    for (const fs::path& drape : settings.repeats) {
      job.files.reads.push_back(drape);
      job.files.reads.push_back(dress_report_path(drape));
    }
    if (settings.against) {
      job.files.reads.push_back(*settings.against);
      job.files.reads.push_back(dress_report_path(*settings.against));
    }
    if (!common.output.empty()) job.files.writes = {common.output};
    for (const auto& file :
         {settings.csv, settings.ply, settings.png, settings.pdf, settings.glb}) {
      if (file) job.files.writes.push_back(*file);
    }
    job.work = [settings, &common] {
      run_ease_map(settings, common);
      return exit_done;
    };
    return job;
  };
  return program;
}

}  // namespace toile
