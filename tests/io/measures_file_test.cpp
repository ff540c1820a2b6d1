#include "io/measures_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "geometry/error.h"

namespace toile {
namespace measures_file_test {

namespace fs = std::filesystem;

class MeasuresFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() /
              ("toile_measures_" + std::to_string(testing::UnitTest::GetInstance()->random_seed()) +
               testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  MeasureSet read(const std::string& name, const std::string& text) const {
    return read_measures(write(name, text));
  }
  std::string message(const std::string& name, const std::string& text) const {
    try {
      read(name, text);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

 private:
  fs::path folder_;
};

TEST_F(MeasuresFile, OwnJsonHasUnitsAndNulls) {
  const MeasureSet set = read("a.json", R"({"unit": "mm", "measures": {
    "height": {"value": 66, "unit": "inch"}, "chest": {"value": 940}, "waist": 707,
    "left_knee": {"value": null, "reason": "covered"}, "right_knee": {"value": 360},
    "shoulder_angle": {"value": 21, "unit": "deg"}, "wingspan": 3}})");
  EXPECT_NEAR(set.values.at("height"), 1.6764, 1e-12);
  EXPECT_NEAR(set.values.at("bust"), 0.940, 1e-12);
  EXPECT_NEAR(set.values.at("waist"), 0.707, 1e-12);
  EXPECT_NEAR(set.values.at("right_knee"), 0.360, 1e-12);
  EXPECT_EQ(set.values.at("shoulder_angle"), 21);
  EXPECT_EQ(set.values.size(), 5U);
  EXPECT_EQ(set.left_out, std::vector<std::string>{"wingspan"});
}

TEST_F(MeasuresFile, SeamlyMeInItsUnit) {
  const std::string body = R"xml(<personal><gender>male</gender></personal><body-measurements>
    <m name="height" value="70"/><m name="bust_circ" value="40"/><m name="hip_circ" value="39.5"/>
    <m name="bust_arc_f" value="21"/><m name="bust_arc_b" value="(bust_circ - bust_arc_f)"/>
    <m name="rib_circ" value="0"/><m name="knee_of_a_dog" value="9"/></body-measurements>)xml";
  for (const std::string end : {"vit", "smis"}) {
    const MeasureSet set = read("a." + end, "<?xml version=\"1.0\"?><" + end +
                                                "><unit>inch</unit>" + body + "</" + end + ">");
    EXPECT_EQ(set.gender, "male");
    EXPECT_NEAR(set.values.at("height"), 1.778, 1e-12);
    EXPECT_NEAR(set.values.at("bust"), 1.016, 1e-12);
    EXPECT_NEAR(set.values.at("bust_arc"), 0.2667, 1e-12) << "half of what goes around the front";
    EXPECT_EQ(set.values.size(), 4U);
    EXPECT_EQ(set.left_out.size(), 3U);
  }
}

TEST_F(MeasuresFile, FreeSewingCountsMillimetresAndDegrees) {
  for (const std::string text :
       {R"({"chest": 940, "seat": 980, "hips": 860, "shoulderSlope": 13, "heel": 310})",
        R"({"name": "me", "measies": {"chest": 940, "seat": 980, "hips": 860, "shoulderSlope": 13,
            "heel": 310}})"}) {
    const MeasureSet set = read("a.json", text);
    EXPECT_NEAR(set.values.at("bust"), 0.94, 1e-12);
    EXPECT_NEAR(set.values.at("hip"), 0.98, 1e-12) << "FreeSewing's seat, not its hips";
    EXPECT_NEAR(set.values.at("abdomen"), 0.86, 1e-12);
    EXPECT_EQ(set.values.at("shoulder_angle"), 13);
    EXPECT_EQ(set.left_out, std::vector<std::string>{"heel"});
  }
}

TEST_F(MeasuresFile, GarmentCodeSumsGiveWhatIsMissing) {
  const MeasureSet set =
      read("a.yaml", "body:\n  height: 171.99\n  head_l: 26.3262\n  bust: 99.84\n  hips: 103.5\n");
  EXPECT_NEAR(set.values.at("cervicale_height"), 1.456638, 1e-9);
  EXPECT_NEAR(set.values.at("hip"), 1.035, 1e-12);
}

TEST_F(MeasuresFile, TablesWithAndWithoutHeader) {
  EXPECT_NEAR(read("a.csv", "bust,94\nhip,38.6,inch\n").values.at("hip"), 0.98044, 1e-12);
  const MeasureSet set = read("b.csv", "measure,definition,value,unit\nbust,\"a, b\",940,mm\n");
  EXPECT_NEAR(set.values.at("bust"), 0.94, 1e-12);
}

TEST_F(MeasuresFile, SaysWhatIsWrongAndWhere) {
  EXPECT_NE(message("a.json", "{\"measures\": {\"bust\": -3}}").find("bust is -3"),
            std::string::npos);
  EXPECT_NE(message("a.json", "{\"measures\": {\"bust\": 9, \"chest\": 9}}").find("twice"),
            std::string::npos);
  EXPECT_NE(message("a.json", "[1]").find("no object"), std::string::npos);
  EXPECT_NE(message("a.csv", "bust,94\nhip,wide\n").find("a.csv:2"), std::string::npos);
  // A first row is a header only where it names a column of values.
  EXPECT_NE(message("a.csv", "waist,94 cm\nhip,99\n").find("a.csv:1"), std::string::npos);
  EXPECT_NE(message("a.vit", "<vit><m").find("is no XML"), std::string::npos);
  EXPECT_NE(message("a.vit", "<vit></vit>").find("body-measurements"), std::string::npos);
  EXPECT_NE(message("a.csv", "wings,94\n").find("has no measure"), std::string::npos);
  EXPECT_NE(message("a.txt", "bust 94").find("is no file of measures"), std::string::npos);
}

TEST_F(MeasuresFile, WordsOfACommandLine) {
  MeasureSet set;
  add_measure("bust=94", 0.01, set);
  add_measure("height=5.5in", 0.01, set);
  add_measure("left_knee=360mm", 0.01, set);
  EXPECT_NEAR(set.values.at("bust"), 0.94, 1e-12);
  EXPECT_NEAR(set.values.at("height"), 0.1397, 1e-12);
  EXPECT_NEAR(set.values.at("left_knee"), 0.36, 1e-12);
  for (const char* wrong : {"bust", "bust=", "bust=x", "wings=3", "left_bust=94", "bust=0",
                            "waist=3ells", "chest=94"}) {
    EXPECT_THROW(add_measure(wrong, 0.01, set), Error) << wrong;
  }
}

}  // namespace measures_file_test
}  // namespace toile
