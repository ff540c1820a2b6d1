// render: pictures of garments and bodies, made without a display.
#include <sstream>

#include "tools/programs.h"
#include "tools/render/run.h"

namespace toile {

namespace {

namespace po = boost::program_options;

std::vector<View> views_of(const std::string& list) {
  std::vector<View> views;
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) {
    const std::optional<View> view = view_named(word);
    if (!view) {
      throw UsageError("--views", "'" + word + "' is no view",
                       "give front, back, left, right or top");
    }
    views.push_back(*view);
  }
  if (views.empty() || views.size() > 8) {
    throw UsageError("--views", "between one and eight views can be shown", "");
  }
  return views;
}

}  // namespace

CommandLineProgram render_program() {
  CommandLineProgram program;
  program.name = "render";
  program.summary =
      "draws garments and a body as a PNG picture, from several sides; back faces are violet";
  program.usage = "[--body body.ply] [garment.obj ...] -o picture.png [options]";
  program.options.add_options()("body", po::value<std::string>()->default_value(""),
                                "the body, drawn in one colour")(
      "garment", po::value<std::vector<std::string>>()->default_value({}, ""),
      "garments (flat, placed or dressed), each panel in its own colour, "
      "or each garment where there are several; also as arguments")(
      "views", po::value<std::string>()->default_value("front,back"),
      "front, back, left, right (the wearer's) and top, with commas between")(
      "width", po::value<int>()->default_value(900), "of a view, in pixels")(
      "whole", po::bool_switch(), "show the whole body, not only where the garment is")(
      "title", po::value<std::string>()->default_value(""), "text above the views");
  program.positional.add("garment", -1);
  program.output_extensions = {".png"};
  program.prepare = [](const po::variables_map& given, const CommonSettings& common) {
    RenderSettings settings;
    settings.body = given["body"].as<std::string>();
    settings.garments = given["garment"].as<std::vector<std::string>>();
    settings.views = views_of(given["views"].as<std::string>());
    settings.whole = given["whole"].as<bool>();
    settings.width = given["width"].as<int>();
    settings.title = given["title"].as<std::string>();
    if (settings.width < 64 || settings.width > 2048) {
      throw UsageError("--width", "is out of range", "give 64 to 2048 pixels");
    }
    Job job;
    job.files.reads.assign(settings.garments.begin(), settings.garments.end());
    if (!settings.body.empty()) job.files.reads.emplace_back(settings.body);
    job.files.writes = {common.output};
    job.work = [settings, &common] {
      run_render(settings, common);
      return exit_done;
    };
    return job;
  };
  return program;
}

}  // namespace toile
