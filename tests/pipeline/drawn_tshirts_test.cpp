// T-shirts of Valentina and FreeSewing, from the drawing to the drape, as
// docs/bring-your-own-pattern.md prints it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/pattern/samples.h"
#include "tests/support/run_program.h"

namespace toile {
namespace drawn_tshirts_test {

using pipeline::read_text;
using pipeline::run;
using pipeline::ScratchFolder;

TEST(ValentinasTshirt, IsSewnOnTheAverageWoman) {
  TOILE_REAL_DATA(drawing, "patterns/valentina/tshirt_aama_r14_details.dxf");
  TOILE_REAL_DATA(woman, "bodies/mean_all.obj");
  const ScratchFolder folder;
  const auto file = [&](const std::string& name) { return (folder / name).string(); };
  const auto halves = run("import-pattern", {drawing.string(), "-o", file("halves.json")}, 60);
  EXPECT_EQ(halves.exit_code, 0) << halves.err;
  for (const char* half : {"--unfold Detail_2:5", "--unfold Detail_3:5", "--unfold Detail_4:0"}) {
    EXPECT_HOLDS(halves.err, half);
  }
  const auto pieces = run("import-pattern",
                          {drawing.string(),
                           "-o",
                           file("pieces.json"),
                           "--unfold",
                           "Detail_2",
                           "--unfold",
                           "Detail_3",
                           "--unfold",
                           "Detail_4",
                           "--pair",
                           "Detail",
                           "--name",
                           "Detail=sleeve",
                           "--name",
                           "Detail_2=front",
                           "--name",
                           "Detail_3=back",
                           "--name",
                           "Detail_4=front_band",
                           "--name",
                           "Detail_5=back_band"},
                          60);
  ASSERT_EQ(pieces.exit_code, 0) << pieces.err;
  const auto found =
      run("find-seams",
          {file("pieces.json"), "-o", file("joined.json"), "--report", file("seams.json")}, 120);
  EXPECT_EQ(found.exit_code, 0) << found.err;
  const auto report = nlohmann::json::parse(read_text(folder / "seams.json"));
  EXPECT_EQ(report["seams"].size(), 15u);
  EXPECT_EQ(report["splits"].size(), 2u) << "each cap, at the shoulder";
  const auto meshed =
      run("mesh-pattern",
          {file("joined.json"), "-o", file("garment.obj"), "--edge-length", "15mm", "-q"}, 60);
  ASSERT_EQ(meshed.exit_code, 0) << meshed.err;
  const auto cleaned = run("clean-body", {woman.string(), "-o", file("body.ply"), "-q"}, 120);
  ASSERT_EQ(cleaned.exit_code, 0) << cleaned.err;
  const auto dressed = run("dress",
                           {"--body", file("body.ply"), file("garment.obj"), "-o", file("worn.obj"),
                            "--report", file("worn.json"), "-q"},
                           300);
  EXPECT_EQ(dressed.exit_code, 0) << dressed.err;
  const auto worn = nlohmann::json::parse(read_text(folder / "worn.json"));
  EXPECT_EQ(worn["verdict"], "sewn");
  for (const auto& wrap : worn["wraps"]) EXPECT_GT(wrap["fraction"].get<double>(), 0.95) << wrap;
}

TEST(FreeSewingsTshirt, IsSewnOnTheMannequinOfItsMeasures) {
  TOILE_REAL_DATA(drawing, "patterns/freesewing/teagan_tshirt.svg");
  const ScratchFolder folder;
  const auto file = [&](const std::string& name) { return (folder / name).string(); };
  const auto done = [&](const std::string& program, const std::vector<std::string>& words) {
    const auto ended = run(program, words, 300);
    EXPECT_EQ(ended.exit_code, 0) << program << ": " << ended.err;
  };
  done("import-pattern", {drawing.string(), "-o", file("drawn.json"), "-q"});
  done("find-seams",
       {file("drawn.json"), "-o", file("sewn.json"), "--report", file("seams.json"), "-q"});
  const auto report = nlohmann::json::parse(read_text(folder / "seams.json"));
  EXPECT_EQ(report["seams"].size(), 14u);
  EXPECT_EQ(report["splits"].size(), 2u) << "each cap's middle part, at the shoulder";
  done("mesh-pattern",
       {file("sewn.json"), "-o", file("garment.obj"), "--edge-length", "15mm", "-q"});
  done("make-mannequin", {"-o", file("mannequin.obj"), "-q"});
  done("clean-body", {file("mannequin.obj"), "-o", file("body.ply"), "-q"});
  done("dress", {"--body", file("body.ply"), file("garment.obj"), "-o", file("worn.obj"), "-q"});
}

}  // namespace drawn_tshirts_test
}  // namespace toile
