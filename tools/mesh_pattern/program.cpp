// mesh-pattern: from a flat sewing pattern to meshed panels with paired seams.
#include "geometry/error.h"
#include "pattern/constants.h"
#include "pattern/file/garment_file.h"
#include "tools/mesh_pattern/run.h"
#include "tools/programs.h"

namespace toile {

namespace po = boost::program_options;

CommandLineProgram mesh_pattern_program() {
  CommandLineProgram program;
  program.name = "mesh-pattern";
  program.summary = "meshes the panels of a sewing pattern, seam sides point to point";
  program.usage = "PATTERN.json -o garment.obj [--edge-length 10mm]";
  add_edge_length_option(program.options);
  program.options.add_options()(
      "subdivisions", po::value<int>()->default_value(-1),
      "levels of the nested triangulation, 0 to 4; -1 chooses by edge length and size")(
      "flat", po::bool_switch(), "lay the panels out flat instead of placing them")(
      "pattern", po::value<std::string>()->required(), "the pattern; also as argument");
  program.positional.add("pattern", 1);
  program.output_extensions = {".obj"};  // garment.garment.json is written beside it
  program.prepare = [](const po::variables_map& given, const CommonSettings& common) {
    MeshPatternSettings settings;
    settings.pattern = given["pattern"].as<std::string>();
    settings.mesh.edge_length = read_edge_length(given);
    settings.mesh.subdivisions = given["subdivisions"].as<int>();
    if (settings.mesh.subdivisions < -1 || settings.mesh.subdivisions > max_subdivisions) {
      throw UsageError("--subdivisions", "is out of range",
                       "use 0 to " + std::to_string(max_subdivisions) + ", or -1");
    }
    settings.flat = given["flat"].as<bool>();
    Job job;
    job.files.reads = {settings.pattern};
    job.files.writes = {common.output, garment_json_path(common.output)};
    job.work = [settings, &common] {
      run_mesh_pattern(settings, common);
      return exit_done;
    };
    return job;
  };
  return program;
}

}  // namespace toile
