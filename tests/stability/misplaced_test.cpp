// Patterns laid out where the body is not: dressed where they belong.
#include <gtest/gtest.h>

#include "tests/stability/hard_case.h"

namespace toile::test {
namespace misplaced_test {

using Layouts = HardCase;

TEST_F(Layouts, TooLow) {
  for (const std::string name : {"tshirt", "bodice_dress"}) {
    for (const double centimetres : {20, 60, 110}) {
      Json pattern = sample(name);
      for (auto& [panel, piece] : pattern["pattern"]["panels"].items()) {
        piece["translation"][1] = piece["translation"][1].get<double>() - centimetres;
      }
      const Ending ending = dress(mannequin(), meshed(pattern), "relaxation");
      EXPECT_EQ(ending.outcome, "sewn") << name << ending.said;
      for (const Json& wrap : ending.report["wraps"]) EXPECT_GT(wrap["fraction"], 0.97) << wrap;
      EXPECT_TRUE(centimetres == 20 || ending.report["scene"].contains("layout_moved")) << name;
      state("7 " + name + ", " + number(centimetres) + " cm too low", "relaxation", ending.outcome,
            ending.figures());
    }
  }
}

TEST_F(Layouts, AllPanelsAtTheOrigin) {
  for (const std::string name : {"tshirt", "trousers"}) {
    Json pattern = sample(name);
    for (auto& [panel, piece] : pattern["pattern"]["panels"].items()) {
      piece["translation"] = {0, 0, 0};
    }
    const Ending ending = dress(mannequin(), meshed(pattern), "relaxation");
    EXPECT_EQ(ending.outcome, "sewn") << name << ": " << ending.said;
    EXPECT_TRUE(ending.report["scene"].contains("placed_by_seams")) << name;
    state("7 " + name + ", all panels at the origin", "relaxation", ending.outcome,
          ending.figures());
  }
}

/// It has no sleeves, so its panels' rotations are about the vertical alone.
TEST_F(Layouts, TurnedAboutTheVertical) {
  Json pattern = sample("walking_dress");
  for (auto& [panel, piece] : pattern["pattern"]["panels"].items()) {
    const Json at = piece["translation"];
    piece["translation"] = {at[2], at[1], -at[0].get<double>()};
    piece["rotation"][1] = piece["rotation"][1].get<double>() + 90;
  }
  const Ending ending = dress(mannequin(), meshed(pattern), "relaxation");
  EXPECT_EQ(ending.outcome, "sewn") << ending.said;
  EXPECT_TRUE(ending.report["scene"].contains("layout_moved")) << ending.said;
  state("7 walking_dress, turned by 90 degrees", "relaxation", ending.outcome, ending.figures());
}

}  // namespace misplaced_test
}  // namespace toile::test
