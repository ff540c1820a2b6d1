#include "pattern/seams/panel_words.h"

#include <gtest/gtest.h>

namespace toile {
namespace panel_words_test {

std::string beside(const std::string& name, const std::string& material = "") {
  PatternPanel panel;
  panel.name = name;
  panel.material = material;
  return kind_beside_shell(panel);
}

TEST(PanelWords, PartAndLabelTellWhatTheNameDoesNot) {
  PatternPanel panel;
  panel.name = "piece7";
  EXPECT_EQ(words_of(panel).role, PanelRole::unknown);
  panel.label = "arm";
  EXPECT_EQ(words_of(panel).role, PanelRole::sleeve);
  panel.name = "cuff";
  EXPECT_EQ(words_of(panel).role, PanelRole::cuff);
}

TEST(PanelWords, TellWhatIsNoPieceOfTheShell) {
  for (const char* name : {"left_frontPocketBag", "Taschenbeutel", "poche plaquée", "bolsillo",
                           "tasca", "chestPocketWelt", "backPocketFacing"}) {
    EXPECT_EQ(beside(name), "pocket") << name;
  }
  for (const char* name : {"collar interfacing", "Einlage", "entoilage col", "entretela"}) {
    EXPECT_EQ(beside(name), "interfacing") << name;
  }
  for (const char* name : {"front lining", "Ärmelfutter", "doublure dos", "forro", "fodera"}) {
    EXPECT_EQ(beside(name), "lining") << name;
  }
  for (const char* name : {"frontFacing", "Halsbeleg", "parementure", "vista", "paramontura"}) {
    EXPECT_EQ(beside(name), "") << name;
  }
  for (const char* name : {"armBinding", "Paspel", "biais", "ribete", "sbieco"}) {
    EXPECT_EQ(beside(name), "binding") << name;
  }
  EXPECT_EQ(beside("flyFacing"), "placket");
  EXPECT_EQ(beside("beltLoops"), "loop");
  EXPECT_EQ(beside("back", "lining cut 2"), "lining");
  for (const char* name : {"front", "waistband", "cuff", "collarStand", "yoke", "gusset", "Passe",
                           "bias skirt", "jupe en biais", "pattern_1", "backing"}) {
    EXPECT_EQ(beside(name, "fabric cut 2 from interfacing"), "") << name;
  }
}

TEST(PanelWords, TellRibbingInFiveLanguages) {
  for (const char* material :
       {"ribbing", "1x1 Rib", "Bündchenware", "bord-côte", "canalé", "costina"}) {
    EXPECT_TRUE(is_ribbing(material)) << material;
  }
  for (const char* material : {"fabric", "ribbon", "côté", "ribete", ""}) {
    EXPECT_FALSE(is_ribbing(material)) << material;
  }
}

}  // namespace panel_words_test
}  // namespace toile
