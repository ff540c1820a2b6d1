#include "pattern/classify/panel_name.h"

#include <gtest/gtest.h>

namespace toile {
namespace panel_name_test {

TEST(PanelName, ReadFiveLanguages) {
  for (const char* name : {"front left", "Vorderteil links", "devant gauche", "delantero izquierdo",
                           "davanti sinistra", "left_ftorso"}) {
    EXPECT_EQ(read_panel_name(name).face, 1) << name;
    EXPECT_EQ(read_panel_name(name).side, 1) << name;
  }
  for (const char* name : {"back right", "Rückenteil rechts", "dos droit", "espalda derecha",
                           "dietro destra", "right_btorso"}) {
    EXPECT_EQ(read_panel_name(name).face, -1) << name;
    EXPECT_EQ(read_panel_name(name).side, -1) << name;
  }
}

TEST(PanelName, TellWhatAPanelIsAPieceOf) {
  for (const char* name : {"sleeve", "Ärmel", "manche", "manga", "manica", "left_sleeve_f"}) {
    EXPECT_EQ(read_panel_name(name).first_role(), PanelRole::sleeve) << name;
  }
  for (const char* name : {"cuff", "Manschette", "poignet", "puño", "sl_left_cuff_f"}) {
    EXPECT_EQ(read_panel_name(name).first_role(), PanelRole::cuff) << name;
  }
  for (const char* name : {"waistband", "Bund", "ceinture", "pretina", "wb_front"}) {
    EXPECT_EQ(read_panel_name(name).first_role(), PanelRole::waistband) << name;
  }
  EXPECT_EQ(read_panel_name("Kragen").first_role(), PanelRole::collar);
  EXPECT_EQ(read_panel_name("cappuccio").first_role(), PanelRole::hood);
  EXPECT_EQ(read_panel_name("Vorderhose").first_role(), PanelRole::trousers);
  EXPECT_EQ(read_panel_name("jupe devant").first_role(), PanelRole::skirt);
  EXPECT_EQ(read_panel_name("piece7").first_role(), PanelRole::unknown);
}

TEST(PanelName, NumberAndStemTellPiecesOfOneNameApart) {
  EXPECT_EQ(read_panel_name("skirt_panel_12").number, 12);
  EXPECT_EQ(read_panel_name("skirt_panel_12").stem, read_panel_name("skirt_panel_3").stem);
  EXPECT_NE(read_panel_name("skirt_panel_12").whole, read_panel_name("skirt_panel_3").whole);
  EXPECT_EQ(read_panel_name("left_sleeve_f").whole, read_panel_name("right_sleeve_f").whole);
  EXPECT_EQ(read_panel_name("skirt").number, -1);
}

TEST(PanelName, SaysAllThatAPanelMayBeAPieceOf) {
  const PanelName cuff = read_panel_name("pant_l_cuff_skirt_f");
  EXPECT_EQ(cuff.first_role(), PanelRole::cuff);
  EXPECT_TRUE(cuff.says(PanelRole::trousers));
  EXPECT_TRUE(cuff.says(PanelRole::skirt));
  EXPECT_FALSE(cuff.says(PanelRole::sleeve));
  EXPECT_FALSE(read_panel_name("short sleeve").says(PanelRole::trousers));
}

}  // namespace panel_name_test
}  // namespace toile
