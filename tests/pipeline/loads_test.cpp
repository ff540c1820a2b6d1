// Strain, tension and pressure of garments that were dressed, as ease-map tells them.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/worn_sample.h"

namespace toile::pipeline {
namespace loads_test {

using Json = nlohmann::json;

class Loads : public testing::Test {
 protected:
  void dress(const std::string& sample, const std::vector<std::string>& options = {}) {
    const fs::path pattern = fs::path(TOILE_SOURCE_DIR) / "samples" / (sample + ".json");
    ASSERT_EQ(run("mesh-pattern", {pattern, "-o", mesh, "--edge-length", "20mm", "-q"}).exit_code,
              0);
    std::vector<std::string> words = {"--body",          body, mesh, "-o", dressed, "--report",
                                      folder / "d.json", "-q"};
    words.insert(words.end(), options.begin(), options.end());
    run("dress", words);
  }

  pipeline::Run ease_map(const std::vector<std::string>& options = {}) const {
    std::vector<std::string> words = {"--body", body, dressed, "--report", report,
                                      "--csv",  csv,  "--ply", ply};
    words.insert(words.end(), options.begin(), options.end());
    return run("ease-map", words);
  }

  Json reported() const { return Json::parse(read_text(report)); }

  ScratchFolder folder;
  fs::path body = clean_mannequin(), mesh = folder / "g.obj", dressed = folder / "d.obj",
           report = folder / "e.json", csv = folder / "e.csv", ply = folder / "e.ply";
};

/// The column of a table, by its name.
std::vector<double> column(const fs::path& csv, const std::string& name) {
  std::istringstream rows(read_text(csv));
  std::string row;
  std::getline(rows, row);
  const auto fields = [](const std::string& text) {
    std::vector<std::string> all;
    std::istringstream in(text);
    for (std::string field; std::getline(in, field, ',');) all.push_back(field);
    return all;
  };
  const std::vector<std::string> names = fields(row);
  const auto at = std::ranges::find(names, name) - names.begin();
  std::vector<double> values;
  while (std::getline(rows, row)) values.push_back(std::stod(fields(row).at(at)));
  return values;
}

TEST_F(Loads, SkinBearsTheWeightOfWhatHangsFromItAlone) {
  for (const char* sample : {"tshirt", "trousers", "elastic_skirt"}) {
    dress(sample);
    ASSERT_EQ(ease_map().exit_code, 0);
    const Json loads = reported()["loads"];
    const double weight = loads["weight_N"];
    EXPECT_GT(weight, 0.5);
    EXPECT_NEAR(loads["of_skin_N"][1].get<double>(), weight, 0.01 * weight) << sample;
    for (const int axis : {0, 2}) {
      EXPECT_NEAR(loads["of_skin_N"][axis].get<double>(), 0, 0.01 * weight) << sample;
    }
    EXPECT_LT(loads["unexplained_N"].get<double>(), 0.05 * weight) << sample;
  }
}

// The skirt hangs from its elastic alone: friction holds it, and friction is at most 0.4 of the
// pressure.
TEST_F(Loads, AWaistbandPressesHardEnoughToHoldItsSkirt) {
  dress("elastic_skirt");
  ASSERT_EQ(ease_map().exit_code, 0);
  const std::vector<double> pressure = column(csv, "pressure_kPa");
  const std::vector<double> friction = column(csv, "friction_kPa");
  double pressed = 0, held = 0;
  for (const double p : pressure) pressed += p;
  for (const double f : friction) held += f;
  EXPECT_GT(held, 0);
  EXPECT_LE(held, 1.05 * 0.4 * pressed);
  const Json panels = reported()["loads"]["panels"];
  for (const Json& panel : panels) {
    // The elastic pulls with 1.8 N around a radius of 11 cm: 16 N/m, which 2 cm of cloth spread to
    // 0.8 kPa. Within half and double of that.
    EXPECT_GT(panel["pressure_kPa"]["largest"].get<double>(), 0.4);
    EXPECT_LT(panel["pressure_kPa"]["largest"].get<double>(), 1.6);
  }
}

TEST_F(Loads, ATightBandPressesByTensionOverRadius) {
  dress("band_small");
  ASSERT_EQ(ease_map().exit_code, 0);
  const Json report_ = reported();
  int seen = 0;
  for (std::size_t i = 0; i < report_["girths"].size(); ++i) {
    const Json& girth = report_["girths"][i];
    const Json& level = report_["loads"]["levels"][i];
    const double tension = level["tension_N_per_m"]["mean"];
    if (girth.contains("no_girth") || tension < 20) continue;
    ++seen;
    // A trunk is no cylinder, and tapers: so within a third.
    const double radius = girth["body_cm"].get<double>() / 100 / (2 * std::acos(-1.0));
    const double pressure = level["pressure_kPa"]["mean"];
    EXPECT_NEAR(1000 * pressure / (tension / radius), 1, 0.34) << level;
    // The strain along the level, of the inner face, by its lengths. It falls steeply off the edge,
    // so a row of triangles has not the very level's.
    const double strain =
        100 * ((girth["garment_cm"].get<double>() - girth["offset_cm"].get<double>()) /
                   girth["on_the_line_cm"].get<double>() -
               1);
    EXPECT_NEAR(level["strain_weft_percent"]["mean"].get<double>(), strain, 0.5 + 0.2 * strain);
  }
  EXPECT_GE(seen, 1);
}

TEST_F(Loads, AreLeftOutWithANoteWhereWhatWasDressedIsNotKnown) {
  dress("band");
  fs::rename(mesh, folder / "moved.obj");
  fs::rename(folder / "g.garment.json", folder / "moved.garment.json");
  const pipeline::Run without = ease_map();
  ASSERT_EQ(without.exit_code, 0) << without.err;
  EXPECT_FALSE(reported().contains("loads"));
  EXPECT_NE(reported()["notes"].dump().find("--garment-mesh"), std::string::npos);
  const pipeline::Run given = ease_map({"--garment-mesh", folder / "moved.obj"});
  ASSERT_EQ(given.exit_code, 0) << given.err;
  EXPECT_TRUE(reported().contains("loads"));
  EXPECT_NE(read_text(ply).find("property float pressure_kPa"), std::string::npos);
  EXPECT_NE(read_text(ply).find("property float tension_most_N_per_m"), std::string::npos);
}

TEST_F(Loads, OfAnotherGarmentAreRefused) {
  dress("band");
  const fs::path other = folder / "other.obj";
  ASSERT_EQ(run("mesh-pattern", {fs::path(TOILE_SOURCE_DIR) / "samples" / "tshirt.json", "-o",
                                 other, "--edge-length", "30mm", "-q"})
                .exit_code,
            0);
  const pipeline::Run refused = ease_map({"--garment-mesh", other});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_NE(refused.err.find("other.obj"), std::string::npos);
  EXPECT_NE(refused.err.find("another garment"), std::string::npos);

  // What was meshed anew under the same name is only left out.
  fs::copy_file(other, mesh, fs::copy_options::overwrite_existing);
  fs::copy_file(folder / "other.garment.json", folder / "g.garment.json",
                fs::copy_options::overwrite_existing);
  const pipeline::Run without = ease_map();
  EXPECT_EQ(without.exit_code, 0) << without.err;
  EXPECT_FALSE(reported().contains("loads"));
  EXPECT_NE(reported()["notes"].dump().find("another garment"), std::string::npos);
}

TEST_F(Loads, ADamagedReportIsOneMessage) {
  dress("band");
  Json damaged = Json::parse(read_text(folder / "d.json"));
  for (const auto& [at, value] : std::vector<std::pair<std::string, Json>>{
           {"/scene/gravity_m_per_s2", Json::array()},
           {"/scene/gravity_m_per_s2", Json::array({0, 0, 0})},
           {"/scene/fabrics/0/quantities/thickness_mm", -1},
           {"/scene/fabrics/0/panels", 7},
           {"/scene/fabrics", 7},
           {"/inputs", 7}}) {
    Json report_ = damaged;
    report_[Json::json_pointer(at)] = value;
    write_text(folder / "d.json", report_.dump());
    const pipeline::Run refused = ease_map();
    EXPECT_EQ(refused.exit_code, 1) << at;
    EXPECT_NE(refused.err.find("d.json"), std::string::npos) << refused.err;
    EXPECT_EQ(refused.err.find("not foreseen"), std::string::npos) << refused.err;
  }
}

TEST_F(Loads, AreNotToldWhereALimitHeldTheDrape) {
  dress("band_small", {"--strain-limit", "0.02"});
  ASSERT_EQ(ease_map().exit_code, 0);
  EXPECT_FALSE(reported().contains("loads"));
  EXPECT_NE(reported()["notes"].dump().find("limits of strain"), std::string::npos);
}

}  // namespace loads_test
}  // namespace toile::pipeline
