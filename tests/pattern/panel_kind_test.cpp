#include "pattern/panel_kind.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace toile {
namespace panel_kind_test {

PanelKind kind(const std::string& name, const std::string& label = "",
               const std::string& part = "") {
  MeshedPanel panel;
  panel.name = name;
  panel.label = label;
  panel.part = part;
  return kind_of(panel);
}

TEST(PanelKind, ByName) {
  EXPECT_EQ(kind("left_sleeve_f"), PanelKind::sleeve);
  EXPECT_EQ(kind("sl_right_cuff_skirt_b"), PanelKind::sleeve);
  EXPECT_EQ(kind("pant_l_cuff_skirt_f"), PanelKind::trousers);
  EXPECT_EQ(kind("pant_f_r"), PanelKind::trousers);
  EXPECT_EQ(kind("skirt_front_0"), PanelKind::skirt);
  EXPECT_EQ(kind("skirtFront"), PanelKind::skirt);
  EXPECT_EQ(kind("wb_back"), PanelKind::band);
  EXPECT_EQ(kind("left_ftorso"), PanelKind::top);
  EXPECT_EQ(kind("top_front"), PanelKind::top);
  EXPECT_EQ(kind("front"), PanelKind::unknown);
  EXPECT_EQ(kind("stop"), PanelKind::unknown);
  EXPECT_EQ(kind("piece1"), PanelKind::unknown);
}

TEST(PanelKind, ByNamesInFiveLanguages) {
  for (const char* name : {"Ärmel links", "manche", "manga", "manica", "Manschette"}) {
    EXPECT_EQ(kind(name), PanelKind::sleeve) << name;
  }
  for (const char* name : {"Vorderhose", "jambe gauche", "pantalón", "gamba"}) {
    EXPECT_EQ(kind(name), PanelKind::trousers) << name;
  }
  for (const char* name : {"Rockvorderteil", "jupe", "falda", "gonna"}) {
    EXPECT_EQ(kind(name), PanelKind::skirt) << name;
  }
  for (const char* name : {"Kapuze", "col", "canesú", "camicia"}) {
    EXPECT_EQ(kind(name), PanelKind::top) << name;
  }
  EXPECT_EQ(kind("Bund"), PanelKind::band);
  EXPECT_TRUE(names_headwear("Kragen"));
  EXPECT_EQ(face_by_name("Rückenteil"), -1);
  EXPECT_EQ(side_by_name("manche gauche"), 1);
}

TEST(PanelKind, LabelAndPartComeFirst) {
  EXPECT_EQ(kind("piece1", "arm"), PanelKind::sleeve);
  EXPECT_EQ(kind("piece1", "leg"), PanelKind::skirt);
  EXPECT_EQ(kind("pant_f_l", "leg"), PanelKind::trousers);
  EXPECT_EQ(kind("piece1", "body"), PanelKind::top);
  EXPECT_EQ(kind("wb_front", "body"), PanelKind::band);
  EXPECT_EQ(kind("front", "", "left_leg"), PanelKind::trousers);
  EXPECT_EQ(kind("front", "", "right_arm"), PanelKind::sleeve);
  EXPECT_EQ(kind("front", "", "torso"), PanelKind::unknown);
  EXPECT_EQ(kind("skirt_front", "", "torso"), PanelKind::skirt);
  EXPECT_EQ(kind("skirt_front", "", "head"), PanelKind::skirt);
  EXPECT_EQ(kind("piece1", "", "head"), PanelKind::top);
}

TEST(PanelKind, SidesAndFaces) {
  EXPECT_EQ(side_by_name("left_sleeve_f"), 1);
  EXPECT_EQ(side_by_name("pant_f_r"), -1);
  EXPECT_EQ(side_by_name("skirt_front"), 0);
  EXPECT_EQ(face_by_name("right_btorso"), -1);
  EXPECT_EQ(face_by_name("pant_f_r"), 1);
  EXPECT_EQ(face_by_name("left_sleeve"), 0);
}

std::string against(const std::string& name, const std::string& part,
                    const std::string& label = "") {
  MeshedPanel panel;
  panel.name = name;
  panel.part = part;
  panel.label = label;
  return against_part(panel);
}

TEST(PanelKind, NameAndPartAgree) {
  for (const auto& [name, part] :
       {std::pair("left_sleeve", "left_arm"), std::pair("skirt_front", "torso"),
        std::pair("trousers_front", "torso"), std::pair("right_trousers", "right_leg"),
        std::pair("hood", "head"), std::pair("collar", "torso"), std::pair("panel_7", "head"),
        std::pair("front_left", "torso"), std::pair("skirt_front", "")}) {
    EXPECT_EQ(against(name, part), "") << name;
  }
}

TEST(PanelKind, ASkirtIsNoPieceOfTheHead) {
  EXPECT_EQ(against("skirt_front", "head"), "its name says a skirt");
  EXPECT_EQ(against("sleeve", "torso"), "its name says a sleeve");
  EXPECT_EQ(against("bodice", "left_leg"), "its name says a top");
}

TEST(PanelKind, ARightSleeveIsNotForTheLeftArm) {
  EXPECT_EQ(against("right_sleeve", "left_arm"), "its name says right");
}

TEST(PanelKind, ALabelCountsBeforeTheName) {
  EXPECT_EQ(against("skirt", "torso", "arm"), "its label is 'arm'");
  EXPECT_EQ(against("skirt", "torso", "leg"), "");
}

TEST(PanelKind, APartThatWasFoundIsNoWitness) {
  MeshedPanel panel;
  panel.name = "right_sleeve";
  panel.part = "left_arm";
  panel.part_source = PartSource::found;
  EXPECT_EQ(against_part(panel), "");
}

}  // namespace panel_kind_test
}  // namespace toile
