#include "tests/stability/hard_case.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>

#include "geometry/intersections.h"
#include "geometry/repair.h"
#include "io/mesh_file.h"
#include "pattern/file/garment_file.h"

namespace toile::test {

using pipeline::read_text;
using pipeline::run;

void state(const std::string& hard_case, const std::string& method, const std::string& outcome,
           const std::string& figures) {
  std::cout << "| " << hard_case << " | " << method << " | " << outcome << " | " << figures << " |"
            << std::endl;
}

std::string number(double value, int digits) {
  std::ostringstream out;
  out.precision(digits);
  out << value;
  return out.str();
}

std::string Ending::figures() const {
  if (report.empty()) return first_words();
  const Json& meets = report["intersections"];
  return "strain p99 " + number(100 * report["strain_off_seams"]["p99"].get<double>()) + " %, " +
         std::to_string(meets["body"].get<int>() + meets["self"].get<int>()) +
         " intersections, residual " + number(report["residual"]["median"].get<double>(), 2) +
         ", " + number(report["residual"]["rms"].get<double>(), 2);
}

std::string Ending::first_words() const {
  std::string words = said.substr(0, said.find('\n'));
  words = words.substr(words.find("error: ") == std::string::npos ? 0 : words.find("error: ") + 7);
  // Files by their names alone: the folder is another one each time.
  for (std::size_t at = words.find("/tmp/"); at != std::string::npos; at = words.find("/tmp/")) {
    const std::size_t end = words.find_first_of(" :,;'", at);
    const std::size_t slash = words.rfind('/', end == std::string::npos ? end : end - 1);
    words.erase(at, slash + 1 - at);
  }
  return words;
}

const fs::path& HardCase::mannequin() {
  static const pipeline::ScratchFolder shared;
  static const fs::path body = [] {
    const fs::path path = shared / "body.ply";
    run("make-mannequin", {"-o", path, "--edge-length", "14mm", "-q"});
    return path;
  }();
  return body;
}

Json HardCase::sample(const std::string& name) {
  return Json::parse(read_text(fs::path(TOILE_SOURCE_DIR) / "samples" / (name + ".json")));
}

fs::path HardCase::meshed(const Json& pattern, const std::string& name,
                          const std::string& edge_length) {
  const fs::path file = folder / (name + "-pattern.json");
  const fs::path garment = folder / (name + ".obj");
  pipeline::write_text(file, pattern.dump());
  const pipeline::Run done =
      run("mesh-pattern", {file, "-o", garment, "--edge-length", edge_length, "-q"});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  return garment;
}

fs::path HardCase::band(const std::function<void(Json& panels, Json& stitches)>& change) {
  Json pattern = sample("band");
  if (change) change(pattern["pattern"]["panels"], pattern["pattern"]["stitches"]);
  return meshed(pattern, "band");
}

Ending HardCase::dress(const fs::path& body, const fs::path& garment, const std::string& method,
                       const std::vector<std::string>& options, int seconds) {
  const fs::path dressed = folder / ("dressed-" + method + ".obj");
  const fs::path report = folder / ("dressed-" + method + "-report.json");
  fs::remove(dressed);
  fs::remove(report);
  std::vector<std::string> words = {"--body",   body,   garment,    "-o",   dressed,
                                    "--report", report, "--method", method, "-q"};
  words.insert(words.end(), options.begin(), options.end());
  const pipeline::Run done = run("dress", words, seconds);
  Ending ending;
  ending.exit_code = done.exit_code;
  ending.said = done.err;
  ending.seconds = done.seconds;
  EXPECT_TRUE(done.exit_code == 0 || done.exit_code == 1 || done.exit_code == 3)
      << method << " ended with " << done.exit_code << " after " << done.seconds
      << " s: " << done.err;
  if (done.exit_code == 1) {
    ending.outcome = "error";
    EXPECT_NE(done.err.find("dress: error: "), std::string::npos) << done.err;
    EXPECT_FALSE(fs::exists(dressed) || fs::exists(report)) << done.err;
  } else if (fs::exists(report)) {
    ending.report = Json::parse(read_text(report));
    ending.outcome = ending.report["verdict"];
    check_written(ending, body, dressed);
  }
  return ending;
}

void HardCase::check_written(const Ending& ending, const fs::path& body,
                             const fs::path& dressed) const {
  EXPECT_EQ(ending.exit_code, ending.outcome == "sewn" ? 0 : 3);
  // Of what is not finite, JSON makes null; the reader of meshes refuses it.
  EXPECT_EQ(ending.report.dump().find("null"), std::string::npos) << ending.report;
  const DressedGarment garment = read_dressed(dressed);
  const TriangleMesh cloth{garment.points, garment.triangles};
  const Json& meets = ending.report["intersections"];
  EXPECT_EQ(meets["body"], intersections(cloth, fan_triangles(read_mesh(body))).size());
  EXPECT_EQ(meets["self"], self_intersections(cloth).size());
}

std::string HardCase::refused(const std::string& program, std::vector<std::string> words,
                              int exit_code) {
  const fs::path output = folder / "refused.obj";
  words.insert(words.end(), {"-o", output, "-q"});
  const pipeline::Run done = run(program, words, 60);
  Ending ending;
  ending.said = done.err;
  EXPECT_EQ(done.exit_code, exit_code) << program << ": " << done.err;
  EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
  EXPECT_NE(done.err.find(program + ": error: "), std::string::npos) << done.err;
  EXPECT_FALSE(fs::exists(output)) << done.err;
  return ending.first_words();
}

}  // namespace toile::test
