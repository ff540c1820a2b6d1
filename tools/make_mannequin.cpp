// make-mannequin: writes the sample body, a mannequin made to a woman's measures.
#include <cstdio>
#include <nlohmann/json.hpp>

#include "geometry/body/mannequin/mannequin.h"
#include "geometry/error.h"
#include "io/mesh_file.h"
#include "io/output_file.h"
#include "io/skeleton_file.h"
#include "tools/pose_option.h"
#include "tools/programs.h"

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
        {"centre", {girth.centre.x(), girth.centre.y(), girth.centre.z()}},
        {"normal", {girth.normal.x(), girth.normal.y(), girth.normal.z()}},
    };
  }
  return {{"body",
           {{"points", mannequin.surface.points.size()},
            {"triangles", mannequin.surface.triangles.size()},
            {"height_m", height}}},
          {"girths", girths}};
}

void write_mannequin(MannequinOptions options, const CommonSettings& common) {
  options.pose = pose_of(options.pose_name, PosedFigure::mannequin);
  const Mannequin mannequin = make_mannequin(options);
  for (const MannequinGirth& girth : mannequin.girths) {
    char line[80];
    std::snprintf(line, sizeof line, "%-12s %6.2f cm", girth.name.c_str(), 100 * girth.measured);
    common.say(line);
  }
  OutputFiles files;
  write_mesh(files.at(common.output), mannequin.surface);
  write_skeleton(files.at(skeleton_path(common.output)), mannequin.skeleton);
  if (common.report) {
    write_file(files.at(*common.report), report_json(mannequin).dump(1) + "\n");
  }
  files.commit();
}

Job prepare(const po::variables_map& given, const CommonSettings& common) {
  MannequinOptions options;
  options.edge_length = parse_length(given["edge-length"].as<std::string>(), "--edge-length");
  options.pose_name = given["pose"].as<std::string>();
  check_mesh_extension(common.output);
  Job job;
  if (is_pose_file(options.pose_name)) job.files.reads = {options.pose_name};
  job.files.writes = {common.output, skeleton_path(common.output)};
  job.work = [options, &common] {
    write_mannequin(options, common);
    return exit_done;
  };
  return job;
}

}  // namespace

CommandLineProgram make_mannequin_program() {
  CommandLineProgram program;
  program.name = "make-mannequin";
  program.summary =
      "writes the sample body: a mannequin 1.70 m tall, bust 93.6, waist 70.7, hip 98 cm";
  program.usage = "-o mannequin.ply [--pose standing|walking|FILE.json] [--edge-length 9mm]";
  program.options.add_options()("edge-length", po::value<std::string>()->default_value("9mm"),
                                "mean edge of the mesh, 4mm to 15mm")(
      "pose", po::value<std::string>()->default_value("standing"),
      "standing, walking, or a file that gives joints' angles");
  program.prepare = prepare;
  return program;
}

}  // namespace toile
