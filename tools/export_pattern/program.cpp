// export-pattern: from a pattern in JSON to a drawing at scale.
#include "geometry/error.h"
#include "io/text.h"
#include "tools/export_pattern/run.h"
#include "tools/programs.h"

namespace toile {

namespace po = boost::program_options;

CommandLineProgram export_pattern_program() {
  CommandLineProgram program;
  program.name = "export-pattern";
  program.summary = "draws a pattern at scale, as SVG, DXF (AAMA/ASTM) or PDF";
  program.usage = "PATTERN.json -o FILE.svg|.dxf|.pdf [--seam-allowance 10mm]";
  program.options.add_options()("seam-allowance", po::value<std::string>(),
                                "drawn around each panel, such as 10mm; else none")(
      "pattern", po::value<std::string>()->required(), "the pattern; also as argument");
  program.positional.add("pattern", 1);
  program.output_extensions = {".svg", ".dxf", ".pdf"};
  program.prepare = [](const po::variables_map& given, const CommonSettings& common) {
    ExportPatternSettings settings;
    settings.pattern = given["pattern"].as<std::string>();
    if (given.count("seam-allowance") > 0) {
      const std::string text = given["seam-allowance"].as<std::string>();
      settings.sheet.seam_allowance = parse_length(text, "--seam-allowance");
      if (settings.sheet.seam_allowance > 0.1) {
        throw UsageError("--seam-allowance", "'" + shown_text(text) + "' is more than 10 cm",
                         "use 10mm, say");
      }
    }
    Job job;
    job.files.reads = {settings.pattern};
    job.files.writes = {common.output};
    job.work = [settings, &common] {
      run_export_pattern(settings, common);
      return exit_done;
    };
    return job;
  };
  return program;
}

}  // namespace toile
