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

}  // namespace panel_words_test
}  // namespace toile
