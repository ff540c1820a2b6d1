// dress --quality: what each preset leaves, and how far from the converged drape it ends.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "io/mesh_file.h"
#include "tests/support/run_program.h"

namespace toile {
namespace {

using Json = nlohmann::json;
using pipeline::read_text;
using pipeline::run;
namespace fs = std::filesystem;

class Quality : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run("make-mannequin", {"-o", body, "--edge-length", "12mm", "-q"}).exit_code, 0);
    const fs::path pattern = fs::path(TOILE_SOURCE_DIR) / "samples" / "tshirt.json";
    ASSERT_EQ(
        run("mesh-pattern", {pattern, "-o", garment, "--edge-length", "25mm", "-q"}).exit_code, 0);
  }

  pipeline::Run dress(const std::string& name, const std::vector<std::string>& options) {
    std::vector<std::string> words = {"--body",
                                      body,
                                      garment,
                                      "-o",
                                      folder / (name + ".obj"),
                                      "--report",
                                      folder / (name + ".json"),
                                      "-q"};
    words.insert(words.end(), options.begin(), options.end());
    return run("dress", words);
  }

  std::vector<Vec3> nodes(const std::string& name) const {
    return read_mesh(folder / (name + ".obj")).points;
  }

  pipeline::ScratchFolder folder;
  fs::path body = folder / "body.ply";
  fs::path garment = folder / "garment.obj";
};

/// Root of the mean square, metres.
double rms_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).squaredNorm();
  return std::sqrt(sum / static_cast<double>(a.size()));
}

TEST_F(Quality, FinerPresetsLeaveLessAndEndNearerToRest) {
  const std::map<std::string, double> left = {{"draft", 0.05}, {"standard", 0.01}, {"fine", 0.001}};
  std::map<std::string, Json> reports;
  for (const auto& [quality, most] : left) {
    ASSERT_EQ(dress(quality, {"--quality", quality}).exit_code, 0) << quality;
    const Json report = Json::parse(read_text(folder / (quality + ".json")));
    EXPECT_LT(report["residual"]["median"], most) << quality;
    EXPECT_LT(report["residual"]["rms"], 10 * most) << quality;
    EXPECT_LT(report["residual"]["wide"], most) << quality;
    EXPECT_EQ(report["intersections"]["body"], 0) << quality;
    EXPECT_EQ(report["intersections"]["self"], 0) << quality;
    reports[quality] = report;
  }
  ASSERT_EQ(dress("rest", {"--residual", "0.00001"}).exit_code, 0);
  const auto rest = nodes("rest");
  const double draft = rms_distance(nodes("draft"), rest);
  const double standard = rms_distance(nodes("standard"), rest);
  const double fine = rms_distance(nodes("fine"), rest);
  std::cout << "from the converged drape: draft " << 1e3 * draft << ", standard " << 1e3 * standard
            << ", fine " << 1e3 * fine << " mm rms\n";
  EXPECT_LT(fine, standard);
  EXPECT_LE(standard, draft);
  EXPECT_LT(standard, 2e-3);
  EXPECT_LT(fine, 1e-3);
  // A tenth of a percentage point.
  const Json converged = Json::parse(read_text(folder / "rest.json"));
  EXPECT_NEAR(reports["standard"]["strain_off_seams"]["p99"].get<double>(),
              converged["strain_off_seams"]["p99"].get<double>(), 1e-3);
}

TEST_F(Quality, IsOneOfThreeAndNoResidualBeside) {
  EXPECT_EQ(dress("a", {"--quality", "best"}).exit_code, 2);
  EXPECT_EQ(dress("a", {"--quality", "fine", "--residual", "0.1"}).exit_code, 2);
  EXPECT_FALSE(fs::exists(folder / "a.obj"));
}

}  // namespace
}  // namespace toile
