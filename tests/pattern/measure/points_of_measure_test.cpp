// Points of measure of garments whose measures are known by hand.
#include "pattern/measure/points_of_measure.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "pattern/measure/measuring_rule.h"
#include "pattern/measure/spec_sheet.h"
#include "tests/pattern/samples.h"

namespace toile {
namespace points_of_measure_test {

/// A pattern and its panels.
struct Measured {
  explicit Measured(Pattern drawn)
      : pattern(std::move(drawn)), panels(pattern, panel_classes(pattern)) {}
  static Measured of(const std::string& file) {
    std::vector<Remark> remarks;
    return Measured(parse_pattern(file, "test", remarks));
  }
  static Measured sample(const std::string& name) {
    std::vector<Remark> remarks;
    return Measured(read_pattern(
        std::filesystem::path(TOILE_SOURCE_DIR) / "samples" / (name + ".json"), remarks));
  }

  /// Centimetres.
  double by_rule(const std::string& rule) const { return 100 * measure_by_rule(panels, rule); }
  std::map<std::string, double> all() const {
    std::map<std::string, double> measures;
    for (const MeasuredPoint& point : measure_all_points(panels)) {
      measures[point.name] = 100 * *point.actual;
    }
    return measures;
  }

  Pattern pattern;
  SewnPanels panels;
};

void expect_points(const std::map<std::string, double>& measured,
                   const std::map<std::string, double>& by_hand) {
  for (const auto& [name, value] : by_hand) {
    ASSERT_TRUE(measured.contains(name)) << name;
    EXPECT_NEAR(measured.at(name), value, 0.01) << name;
  }
}

/// A skirt of two panels, 50 cm wide below and 44 above. The front has a dart of 4 cm that is 10 cm
/// deep. Its sides are straight and 60 cm high.
const std::string darted_skirt = samples::file(
    samples::polygon("skirt_front", "[-25,0],[25,0],[22,60],[2,60],[0,50],[-2,60],[-22,60]",
                     R"("translation": [0,40,20])") +
        "," +
        samples::polygon("skirt_back", "[-25,0],[25,0],[22,60],[-22,60]",
                         R"("translation": [0,40,-20])"),
    R"([{"panel": "skirt_front", "edge": 1}, {"panel": "skirt_back", "edge": 1}],
       [{"panel": "skirt_front", "edge": 6}, {"panel": "skirt_back", "edge": 3}],
       [{"panel": "skirt_front", "edge": 3}, {"panel": "skirt_front", "edge": 4}])");

TEST(PointsOfMeasure, ALevelLineLeavesOutADart) {
  const Measured skirt = Measured::of(darted_skirt);
  // At 57.5 cm each panel is 2 (25 - 3 * 57.5/60) = 44.25 cm wide, the dart 3 cm.
  const double whole = 2 * 44.25 - 3;
  EXPECT_NEAR(skirt.by_rule("around skirt_front.1:end 2.5cm below"), whole, 0.01);
  EXPECT_NEAR(skirt.by_rule("half around skirt_back.1:end 2.5cm below"), whole / 2, 0.01);
  EXPECT_NEAR(skirt.by_rule("around skirt_front.1:0.5"), 2 * 47, 0.01);
}

TEST(PointsOfMeasure, RulesMeasureStraightAndAlong) {
  const Measured skirt = Measured::of(darted_skirt);
  EXPECT_NEAR(skirt.by_rule("between skirt_front.0:start skirt_front.0:end"), 50, 1e-9);
  EXPECT_NEAR(skirt.by_rule("between skirt_front.0:start skirt_front.3:start"), std::hypot(27, 60),
              1e-9);
  EXPECT_NEAR(skirt.by_rule("drop skirt_front.2:start skirt_front.3:end"), 10, 1e-9);
  EXPECT_NEAR(skirt.by_rule("level skirt_front.2:start skirt_front.3:end"), 22, 1e-9);
  EXPECT_NEAR(skirt.by_rule("twice along skirt_front.3 skirt_front.4"), 4 * std::hypot(2, 10),
              1e-9);
  EXPECT_NEAR(skirt.by_rule("down skirt_front.2:0.5"), 60, 1e-6);
}

TEST(PointsOfMeasure, AWaistIsThatOfClosedDarts) {
  const auto measures = Measured::of(darted_skirt).all();
  expect_points(measures, {{"half waist", (44 + 40) / 2.0}, {"half hem", 50}});
}

TEST(PointsOfMeasure, NamesInQuotesMayHaveBlanksAndDots) {
  std::string text = darted_skirt;
  for (std::size_t at = 0; (at = text.find("skirt_back", at)) != std::string::npos;) {
    text.replace(at, 10, "back .v2");
  }
  EXPECT_NEAR(Measured::of(text).by_rule("along \"back .v2\".0 skirt_front.0"), 100, 1e-9);
}

TEST(PointsOfMeasure, RulesThatSayNothingAreRefused) {
  const Measured skirt = Measured::of(darted_skirt);
  for (const std::string rule : {"",
                                 "half",
                                 "along",
                                 "beside skirt_front.0",
                                 "along skirt_front",
                                 "along skirt_front.7",
                                 "along skirt_side.0",
                                 "along skirt_front.",
                                 "along \"skirt_front\"",
                                 "between skirt_front.0",
                                 "between skirt_front.0:start skirt_back.0:end",
                                 "down skirt_front.2:middle",
                                 "down skirt_front.2:1.5",
                                 "around skirt_front.1:end 2.5 below",
                                 "around skirt_front.1:end 2.5cm",
                                 "around skirt_front.1:end -1cm below",
                                 "around skirt_front.1:0.5 2cm below",
                                 "around skirt_front.1:end 70cm below",
                                 "along skirt_front.0 extra",
                                 "down skirt_front.0:0.5",
                                 "down skirt_front.2:nan"}) {
    EXPECT_THROW(skirt.by_rule(rule), Error) << rule;
  }
}

// The sample's front has the vertices (0, 0), (26.5, 0), (26, 41.5), (19.5, 62.887), (9, 66.4),
// (0, 56.4). The back has (0, 61.8), (9, 64) and (19.5, 60.487). A sleeve is 22 cm long, and its
// cap ends 11 cm down.
TEST(PointsOfMeasure, OfTheTShirtAreThoseOfItsVertices) {
  const auto measures = Measured::sample("tshirt").all();
  // The side seam is 0.5 cm in at 41.5 cm, so 0.47 cm at 39.
  const double half_front = 26.5 - 0.5 * 39 / 41.5;
  expect_points(measures, {{"half chest", 2 * half_front},
                           {"half hem", 53},
                           {"across shoulder", 39},
                           {"neck width", 18},
                           {"front neck drop", 10},
                           {"back neck drop", 2.2},
                           {"centre front length", 56.4},
                           {"centre back length", 61.8},
                           {"front length from the neck's side", 66.4},
                           {"back length from the neck's side", 64},
                           {"left shoulder", std::hypot(10.5, 66.4 - 62.887)},
                           {"right shoulder", std::hypot(10.5, 66.4 - 62.887)},
                           {"left sleeve length", 22},
                           {"right sleeve length", 22},
                           {"left sleeve inseam", std::hypot(11, 1.5)}});
}

TEST(PointsOfMeasure, AnOpenFrontIsMeasuredFromEdgeToEdge) {
  std::ifstream file(std::filesystem::path(TOILE_SOURCE_DIR) / "samples" / "tshirt.json");
  nlohmann::json shirt = nlohmann::json::parse(file);
  std::erase_if(shirt["pattern"]["stitches"].get_ref<nlohmann::json::array_t&>(),
                [](const nlohmann::json& stitch) {
                  return stitch[0]["panel"] == "left_front" && stitch[1]["panel"] == "right_front";
                });
  const auto whole = Measured::sample("tshirt").all();
  const auto open = Measured::of(shirt.dump()).all();
  EXPECT_EQ(open.size(), whole.size());
  expect_points(open, whole);
}

// The sample's shoulder seam is parted by a princess seam.
TEST(PointsOfMeasure, ShouldersOfTwoPiecesAreOne) {
  const auto measures = Measured::sample("bodice_dress").all();
  const double piece = std::hypot(14.451 - 11, 45.5 - 44.312);
  const double other = std::hypot(17.599 - 14.755, 22.292 - 20.02);
  expect_points(measures, {{"left shoulder", piece + other},
                           {"across shoulder", 2 * 18.271},
                           {"neck width", 2 * 11.3},
                           {"front neck drop", 14.5}});
  // The armhole is of the side front and the back.
  EXPECT_GT(measures.at("left armhole"), 40);
}

TEST(PointsOfMeasure, OfTrousersHaveBothLegs) {
  const auto measures = Measured::sample("trousers").all();
  for (const std::string name :
       {"front rise", "back rise", "inseam", "outseam", "half thigh", "half leg opening"}) {
    ASSERT_TRUE(measures.contains("left " + name)) << name;
    EXPECT_NEAR(measures.at("left " + name), measures.at("right " + name), 1e-6) << name;
  }
  // The hems are 18.5 cm in front and 21.5 cm at the back.
  EXPECT_NEAR(measures.at("left half leg opening"), 20, 1e-6);
  // The two rises and the inseam make up the outseam, but for what the crotch leads aside.
  EXPECT_GT(measures.at("left back rise"), measures.at("left front rise"));
  EXPECT_GT(measures.at("left outseam"), measures.at("left inseam"));
}

TEST(SpecSheet, ComparesBySizeAndTolerance) {
  const Measured shirt = Measured::sample("tshirt");
  const std::string table =
      "name,tolerance_cm,M,L,measured\n"
      "half hem,0.2,53,54,\n"
      "sleeve length,,21.6,22.5,\n"
      "\"my own, front\",0,26.5,26.5,along left_front.0\n"
      "collar height,1,5,5,\n";
  const auto of_m =
      measure_to_spec(shirt.panels, read_spec_sheet(table, "t.csv", "M"), "t.csv", 0.005);
  ASSERT_EQ(of_m.size(), 5u);  // both sleeves
  EXPECT_EQ(of_m[0].result(), "in tolerance");
  EXPECT_EQ(of_m[1].name, "left sleeve length");
  EXPECT_EQ(of_m[1].result(), "in tolerance");
  EXPECT_NEAR(*of_m[2].difference(), 0.004, 1e-6);
  EXPECT_EQ(of_m[3].result(), "in tolerance");
  EXPECT_EQ(of_m[4].result(), "not found");
  const auto of_l =
      measure_to_spec(shirt.panels, read_spec_sheet(table, "t.csv", "L"), "t.csv", 0.0049);
  EXPECT_EQ(of_l[0].result(), "too small");
  EXPECT_EQ(of_l[1].result(), "too small");
}

TEST(SpecSheet, RefusesWhatIsNoSpec) {
  const auto refused = [](const std::string& table, const std::string& size,
                          const std::string& words) {
    try {
      read_spec_sheet(table, "t.csv", size);
      ADD_FAILURE() << table;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  refused("", "", "empty");
  refused("point,spec_cm\na,1\n", "", "t.csv:1: there is no column 'name'");
  refused("name,S,M\na,1,2\n", "", "several sizes");
  refused("name,S,M\na,1,2\n", "XL", "no size 'XL'");
  refused("name,spec_cm\nhalf hem,wide\n", "", "t.csv:2: 'wide' is no length");
  refused("name,spec_cm\nhalf hem,-3\n", "", "'-3' is no length");
  refused("name,spec_cm\n,5\n", "", "t.csv:2: has no name");
}

}  // namespace points_of_measure_test
}  // namespace toile
