// Case 3: a garment of 200,000 nodes.
#include "tests/stability/hard_case.h"

namespace toile::test {
namespace very_large_test {

using pipeline::run;

TEST(LongVeryLarge, TwoHundredThousandNodes) {
  pipeline::ScratchFolder folder;
  ASSERT_EQ(run("make-mannequin", {"-o", folder / "body.ply", "-q"}).exit_code, 0);
  const std::string tshirt = std::string(TOILE_SOURCE_DIR) + "/samples/tshirt.json";
  ASSERT_EQ(run("mesh-pattern", {tshirt, "-o", folder / "tee.obj", "--edge-length", "2.05mm", "-q"})
                .exit_code,
            0);
  const pipeline::Run done =
      run("dress",
          {"--body", folder / "body.ply", folder / "tee.obj", "-o", folder / "dressed.obj",
           "--report", folder / "report.json", "--quality", "draft", "-q"},
          7200);
  ASSERT_TRUE(done.exit_code == 0 || done.exit_code == 3) << done.exit_code << done.err;
  const Json report = Json::parse(pipeline::read_text(folder / "report.json"));
  const int nodes = report["stages"].back()["nodes"];
  EXPECT_GT(nodes, 180000);
  EXPECT_EQ(report["intersections"]["body"], 0);
  EXPECT_EQ(report["intersections"]["self"], 0);
  state("3 T-shirt of " + std::to_string(nodes) + " nodes, draft", "relaxation",
        report["verdict"].get<std::string>(),
        number(done.seconds, 4) + " s (" + number(done.processor_seconds, 4) +
            " s of processor), " + number(done.peak_MiB, 4) + " MiB");
}

}  // namespace very_large_test
}  // namespace toile::test
