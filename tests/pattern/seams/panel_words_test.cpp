#include "pattern/seams/panel_words.h"

#include <gtest/gtest.h>

namespace toile {
namespace panel_words_test {

PanelWords words(const std::string& name) {
  PatternPanel panel;
  panel.name = name;
  return words_of(panel);
}

TEST(PanelWords, ReadFiveLanguages) {
  for (const char* name : {"front left", "Vorderteil links", "devant gauche", "delantero izquierdo",
                           "davanti sinistra", "left_ftorso"}) {
    EXPECT_EQ(words(name).face, 1) << name;
    EXPECT_EQ(words(name).side, 1) << name;
  }
  for (const char* name : {"back right", "Rückenteil rechts", "dos droit", "espalda derecha",
                           "dietro destra", "right_btorso"}) {
    EXPECT_EQ(words(name).face, -1) << name;
    EXPECT_EQ(words(name).side, -1) << name;
  }
}

TEST(PanelWords, TellWhatAPanelIsAPieceOf) {
  for (const char* name : {"sleeve", "Ärmel", "manche", "manga", "manica", "left_sleeve_f"}) {
    EXPECT_EQ(words(name).role, PanelRole::sleeve) << name;
  }
  for (const char* name : {"cuff", "Manschette", "poignet", "puño", "sl_left_cuff_f"}) {
    EXPECT_EQ(words(name).role, PanelRole::cuff) << name;
  }
  for (const char* name : {"waistband", "Bund", "ceinture", "pretina", "wb_front"}) {
    EXPECT_EQ(words(name).role, PanelRole::waistband) << name;
  }
  EXPECT_EQ(words("Kragen").role, PanelRole::collar);
  EXPECT_EQ(words("cappuccio").role, PanelRole::hood);
  EXPECT_EQ(words("Vorderhose").role, PanelRole::trousers);
  EXPECT_EQ(words("jupe devant").role, PanelRole::skirt);
  EXPECT_EQ(words("piece7").role, PanelRole::unknown);
}

TEST(PanelWords, NumberAndStemTellPiecesOfOneNameApart) {
  EXPECT_EQ(words("skirt_panel_12").number, 12);
  EXPECT_EQ(words("skirt_panel_12").stem, words("skirt_panel_3").stem);
  EXPECT_NE(words("skirt_panel_12").whole, words("skirt_panel_3").whole);
  EXPECT_EQ(words("left_sleeve_f").whole, words("right_sleeve_f").whole);
  EXPECT_EQ(words("skirt").number, -1);
}

std::string beside(const std::string& name, const std::string& material = "") {
  PatternPanel panel;
  panel.name = name;
  panel.material = material;
  return kind_beside_shell(panel);
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
