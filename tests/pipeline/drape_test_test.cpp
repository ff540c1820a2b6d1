// drape-test: sheets of known fabrics on the tester.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace toile::pipeline {
namespace drape_test_test {

using Json = nlohmann::json;

class DrapeTest : public testing::Test {
 protected:
  pipeline::Run test(std::vector<std::string> words) const {
    words.insert(words.end(), {"-o", picture, "--report", report});
    return run("drape-test", words);
  }
  Json reported() const { return Json::parse(read_text(report)); }

  ScratchFolder folder;
  fs::path picture = folder / "d.png", report = folder / "d.json";
};

TEST_F(DrapeTest, DenimIsWithinThePublishedBand) {
  const auto done = test({"denim", "--edge-length", "8mm", "--starts", "3"});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_NE(done.err.find("denim: drape coefficient"), std::string::npos);
  const Json coefficient = reported()["coefficient_percent"];
  EXPECT_GT(coefficient["least"].get<double>(), 70);
  EXPECT_LT(coefficient["most"].get<double>(), 90);
  // Real cloths of 70 to 80 % have 6 to 9 nodes.
  EXPECT_GE(reported()["nodes"]["mean"].get<double>(), 5);
  EXPECT_LE(reported()["nodes"]["mean"].get<double>(), 9);
  EXPECT_EQ(read_text(picture).substr(1, 3), "PNG");
}

TEST_F(DrapeTest, ABoardStaysFlat) {
  write_text(folder / "board.json", R"({"name": "board", "bending_N_m": 1})");
  ASSERT_EQ(test({folder / "board.json", "--edge-length", "15mm", "--starts", "1"}).exit_code, 0);
  EXPECT_GT(reported()["coefficient_percent"]["mean"].get<double>(), 99);
  EXPECT_EQ(reported()["fabric"]["name"], "board");
}

TEST_F(DrapeTest, BadInputIsOneMessage) {
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"velvet"},
                                             {"denim", "--sheet", "17cm"},
                                             {"denim", "--starts", "0"},
                                             {"denim", "--edge-length", "0.1mm"},
                                             {"denim", "--plate", "0cm"},
                                             {"denim", "--sheet", "3m"}}) {
    const auto refused = test(words);
    EXPECT_EQ(refused.exit_code, words.size() == 1 ? 1 : 2) << words.back();
    EXPECT_FALSE(refused.err.empty());
    EXPECT_FALSE(fs::exists(picture));
  }
}

}  // namespace drape_test_test
}  // namespace toile::pipeline
