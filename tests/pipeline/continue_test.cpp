// dress --continue: a garment whose pattern was changed a little goes on from its earlier drape.
#include <gtest/gtest.h>

#include <cmath>

#include "pattern/file/garment_file.h"
#include "tests/support/worn_sample.h"

namespace toile::pipeline {
namespace continue_test {

using Json = nlohmann::json;

class Continue : public WornSample {
 protected:
  void SetUp() override {
    make_body();
    mesh(sample("tshirt"), "25mm");
    ASSERT_EQ(dress("earlier").exit_code, 0);
  }

  /// The garment anew, 2 cm longer.
  void lengthen() const {
    Json pattern = Json::parse(read_text(sample("tshirt")));
    for (const char* panel : {"left_front", "right_front", "left_back", "right_back"}) {
      for (Json& vertex : pattern["pattern"]["panels"][panel]["vertices"]) {
        if (vertex[1] == 0) vertex[1] = -2;
      }
    }
    write_text(folder / "longer.json", pattern.dump());
    mesh(folder / "longer.json", "25mm");
  }

  pipeline::Run go_on(const std::string& name, std::vector<std::string> options = {}) const {
    options.insert(options.end(), {"--continue", folder / "earlier.obj"});
    return dress(name, options);
  }

  /// Root mean square of the distances between the points of two drapes of one garment, metres.
  double apart(const std::string& one, const std::string& other) const {
    const DressedGarment a = read_dressed(folder / (one + ".obj"));
    const DressedGarment b = read_dressed(folder / (other + ".obj"));
    double sum = 0;
    for (std::size_t n = 0; n < a.points.size(); ++n) {
      sum += (a.points[n] - b.points[n]).squaredNorm();
    }
    return std::sqrt(sum / static_cast<double>(a.points.size()));
  }
};

TEST_F(Continue, AnUnchangedGarmentStaysWhereItLies) {
  const auto done = go_on("same");
  ASSERT_EQ(done.exit_code, 0) << done.err;
  EXPECT_LT(apart("same", "earlier"), 0.001);
  const Json said = report("same");
  EXPECT_EQ(said["scene"]["continued"]["outside_mm"], 0);
  EXPECT_EQ(said["stages"].size(), 1U);
}

TEST_F(Continue, AMovedHemEndsAsFromFlatPanels) {
  lengthen();
  ASSERT_EQ(dress("anew").exit_code, 0);
  const auto done = go_on("longer");
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const Json on = report("longer");
  const Json anew = report("anew");
  EXPECT_NEAR(on["scene"]["continued"]["outside_mm"], 20, 0.1);
  EXPECT_EQ(on["verdict"], anew["verdict"]);
  for (std::size_t i = 0; i < anew["wraps"].size(); ++i) {
    EXPECT_NEAR(on["wraps"][i]["fraction"], anew["wraps"][i]["fraction"], 0.02);
  }
  EXPECT_NEAR(on["strain_off_seams"]["p99"], anew["strain_off_seams"]["p99"], 0.003);
  // The same bits once more, on another number of threads.
  ASSERT_EQ(go_on("again", {"--threads", "1"}).exit_code, 0);
  EXPECT_EQ(read_text(folder / "again.obj"), read_text(folder / "longer.obj"));
}

TEST_F(Continue, AnotherGarmentIsDressedFromFlatPanelsAndThatIsSaid) {
  mesh(sample("tube_top"), "40mm");
  const auto done = go_on("other");
  EXPECT_EQ(done.exit_code, 0) << done.err;
  const Json said = report("other");
  EXPECT_EQ(said["scene"]["continued"].count("outside_mm"), 0U);
  const std::string why = said["scene"]["continued"]["from_flat_panels"];
  EXPECT_NE(why.find("is new"), std::string::npos) << why;
  EXPECT_NE(done.err.find("warning: dressed from flat panels"), std::string::npos) << done.err;
  ASSERT_EQ(dress("plain").exit_code, 0);
  EXPECT_EQ(read_text(folder / "other.obj"), read_text(folder / "plain.obj"));
}

TEST_F(Continue, OfAFileThatIsNoDrapeIsAnError) {
  write_text(folder / "earlier.obj", "v 0 0 0\n");
  const auto done = go_on("bad");
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_NE(done.err.find("earlier.obj"), std::string::npos) << done.err;
  EXPECT_FALSE(fs::exists(folder / "bad.obj"));
  EXPECT_EQ(go_on("paper", {"--method", "paper"}).exit_code, 2);
}

}  // namespace continue_test
}  // namespace toile::pipeline
