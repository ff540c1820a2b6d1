#include "pattern/classify/classify.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "pattern/file/pattern_file.h"
#include "pattern/mesh/mesh_panels.h"
#include "tests/cloth/panels.h"

namespace toile {
namespace classify_test {

using enum PanelRole;

PanelRole worn_as(const std::string& name, const std::string& label = "",
                  BodyPart part = BodyPart::none) {
  return classify({name, part, label}).worn_as;
}

TEST(Classify, ByName) {
  EXPECT_EQ(worn_as("left_sleeve_f"), sleeve);
  EXPECT_EQ(worn_as("sl_right_cuff_skirt_b"), sleeve);
  EXPECT_EQ(worn_as("pant_l_cuff_skirt_f"), trousers);
  EXPECT_EQ(worn_as("pant_f_r"), trousers);
  EXPECT_EQ(worn_as("skirt_front_0"), skirt);
  EXPECT_EQ(worn_as("skirtFront"), skirt);
  EXPECT_EQ(worn_as("wb_back"), waistband);
  EXPECT_EQ(worn_as("left_ftorso"), bodice);
  EXPECT_EQ(worn_as("top_front"), bodice);
  EXPECT_EQ(worn_as("front"), unknown);
  EXPECT_EQ(worn_as("stop"), unknown);
  EXPECT_EQ(worn_as("piece1"), unknown);
}

TEST(Classify, ByNamesInFiveLanguages) {
  for (const char* name : {"Ärmel", "manche gauche", "manga", "manica"}) {
    EXPECT_EQ(worn_as(name), sleeve) << name;
  }
  for (const char* name : {"Vorderhose", "pantalon dos", "pantalón", "gamba sinistra"}) {
    EXPECT_EQ(worn_as(name), trousers) << name;
  }
  for (const char* name : {"Vorderrock", "jupe devant", "falda", "gonna"}) {
    EXPECT_EQ(worn_as(name), skirt) << name;
  }
  for (const char* name : {"Oberteil", "corsage", "cuerpo", "corpino"}) {
    EXPECT_EQ(worn_as(name), bodice) << name;
  }
  EXPECT_EQ(worn_as("Bund"), waistband);
  EXPECT_EQ(classify({"Rückenteil"}).face, PanelFace::back);
  EXPECT_EQ(classify({"manche gauche"}).side, PanelSide::left);
}

TEST(Classify, WitnessesThatAgreeTellMoreTogether) {
  EXPECT_EQ(worn_as("piece1", "arm"), sleeve);
  EXPECT_EQ(worn_as("piece1", "leg"), skirt);
  EXPECT_EQ(worn_as("pant_f_l", "leg"), trousers);
  EXPECT_EQ(worn_as("piece1", "leg", BodyPart::left_leg), trousers);
  EXPECT_EQ(worn_as("cuff", "leg"), trousers);
  EXPECT_EQ(worn_as("piece1", "body"), bodice);
  EXPECT_EQ(worn_as("wb_front", "body"), waistband);
  EXPECT_EQ(worn_as("wb_front", "leg"), skirt);
  EXPECT_EQ(worn_as("front", "", BodyPart::left_leg), trousers);
  EXPECT_EQ(worn_as("front", "", BodyPart::right_arm), sleeve);
  EXPECT_EQ(worn_as("front", "", BodyPart::torso), unknown);
  EXPECT_EQ(worn_as("skirt_front", "", BodyPart::torso), skirt);
  EXPECT_EQ(worn_as("piece1", "", BodyPart::head), bodice);
}

TEST(Classify, TheNameTellsTheRole) {
  EXPECT_EQ(classify({"pant_l_cuff_skirt_f"}).role, cuff);
  EXPECT_EQ(classify({"collar"}).role, collar);
  EXPECT_EQ(classify({"piece1", BodyPart::none, "arm"}).role, sleeve);
  EXPECT_EQ(classify({"piece1", BodyPart::head}).role, hood);
  EXPECT_EQ(classify({"piece1", BodyPart::none, "leg"}).role, unknown);
}

TEST(Classify, PartsAreOfThePieceAndItsSide) {
  const auto part = [](const std::string& name, const std::string& label = "") {
    return classify({name, BodyPart::none, label}).part.is;
  };
  EXPECT_EQ(part("left_sleeve"), BodyPart::left_arm);
  EXPECT_EQ(part("pant_f_r"), BodyPart::right_leg);
  EXPECT_EQ(part("sleeve"), BodyPart::none);
  EXPECT_EQ(part("skirt_left"), BodyPart::torso);
  EXPECT_EQ(part("piece1", "body"), BodyPart::torso);
  EXPECT_EQ(part("hood"), BodyPart::none);
  EXPECT_EQ(part("piece1"), BodyPart::none);
}

TEST(Classify, SidesAndFaces) {
  EXPECT_EQ(classify({"left_sleeve_f"}).side, PanelSide::left);
  EXPECT_EQ(classify({"pant_f_r"}).side, PanelSide::right);
  EXPECT_EQ(classify({"skirt_front"}).side, PanelSide::none);
  EXPECT_EQ(classify({"right_btorso"}).face, PanelFace::back);
  EXPECT_EQ(classify({"pant_f_r"}).face, PanelFace::front);
  EXPECT_EQ(classify({"left_sleeve"}).face, PanelFace::none);
  // Panels named a to f.
  EXPECT_EQ(classify({"f"}).face, PanelFace::none);
  EXPECT_EQ(classify({"piece1", BodyPart::left_arm}).side, PanelSide::left);
}

TEST(Classify, SourcesAreSaid) {
  const PanelClass named = classify({"left_sleeve"});
  EXPECT_EQ(named.worn_as.by, PanelSource::name);
  EXPECT_EQ(text_of(named), "sleeve, left, by name");
  EXPECT_EQ(text_of(classify({"left_sleeve", BodyPart::left_arm})),
            "sleeve, left, by name and as stated");
  EXPECT_EQ(text_of(classify({"pant_l_cuff"})), "cuff of trousers, left, by name");
  EXPECT_EQ(text_of(classify({"piece1", BodyPart::none, "leg"})), "skirt, by label");
  EXPECT_EQ(text_of(classify({"front", BodyPart::torso})), "torso, front, as stated and by name");
  EXPECT_EQ(text_of(classify({"piece1"})), "");
}

std::string against(const std::string& name, BodyPart part, const std::string& label = "") {
  return classify({name, part, label}).contradiction;
}

TEST(Classify, NameAndPartAgree) {
  for (const auto& [name, part] :
       {std::pair("left_sleeve", BodyPart::left_arm), std::pair("skirt_front", BodyPart::torso),
        std::pair("trousers_front", BodyPart::torso),
        std::pair("right_trousers", BodyPart::right_leg), std::pair("hood", BodyPart::head),
        std::pair("collar", BodyPart::torso), std::pair("panel_7", BodyPart::head),
        std::pair("front_left", BodyPart::torso), std::pair("skirt_front", BodyPart::none),
        std::pair("left_cuff", BodyPart::left_leg)}) {
    EXPECT_EQ(against(name, part), "") << name;
  }
  EXPECT_EQ(against("skirt", BodyPart::torso, "leg"), "");
}

TEST(Classify, ContradictionsNameTheWitnesses) {
  EXPECT_EQ(against("skirt_front", BodyPart::head),
            "the pattern states the part 'head', but its name says a skirt");
  EXPECT_EQ(against("sleeve", BodyPart::torso),
            "the pattern states the part 'torso', but its name says a sleeve");
  EXPECT_EQ(against("right_sleeve", BodyPart::left_arm),
            "the pattern states the part 'left_arm', but its name says right");
  EXPECT_EQ(against("sleeve", BodyPart::none, "body"),
            "its label is 'body', but its name says a sleeve");
}

/// What the panels of a sample are once `change` was made to each of them.
std::map<std::string, PanelClass> classes(const std::string& sample, const auto& change) {
  std::vector<Remark> remarks;
  Pattern pattern =
      read_pattern(std::string(TOILE_SOURCE_DIR) + "/samples/" + sample + ".json", remarks);
  for (PatternPanel& panel : pattern.panels) change(panel);
  std::map<std::string, PanelClass> classes;
  for (const MeshedPanel& panel : mesh_panels(pattern, {0.05, 0}, remarks).panels) {
    classes[panel.name] = panel.is;
  }
  return classes;
}

TEST(Classify, ATwinsShapeTellsASleeveFromATrunk) {
  const PanelClass is = classes("tshirt", [](PatternPanel& panel) {
                          if (panel.name == "left_sleeve_f") panel.part = BodyPart::torso;
                        }).at("left_sleeve_f");
  EXPECT_EQ(is.worn_as, (Told<PanelRole>{sleeve, PanelSource::shape}));
  EXPECT_EQ(is.part, BodyPart::left_arm);
  EXPECT_FALSE(is.contradiction.empty());
}

TEST(Classify, ANameThatIsWrongGivesWayToItsTwin) {
  const PanelClass is = classes("trousers", [](PatternPanel& panel) {
                          if (panel.name == "left_front") panel.name = "left_sleeve";
                        }).at("left_sleeve");
  EXPECT_EQ(is.worn_as, (Told<PanelRole>{trousers, PanelSource::shape}));
  EXPECT_EQ(is.part, BodyPart::left_leg);
}

TEST(Classify, TheSkeletonPlacesNoSkirtAtAnArm) {
  const PanelClass is = classes("gathered_skirt", [](PatternPanel& panel) {
                          if (panel.name == "skirt_front") panel.part = BodyPart::left_arm;
                        }).at("skirt_front");
  EXPECT_EQ(is.worn_as, (Told<PanelRole>{skirt, PanelSource::shape}));
  EXPECT_EQ(is.part, BodyPart::torso);
  EXPECT_EQ(is.side, PanelSide::none);
}

TEST(Classify, WhatStandsAtTheOtherArmHasNoPlace) {
  for (const bool exchanged : {false, true}) {
    PanelMesh garment;
    for (const auto& [name, x] : {std::pair("left_sleeve", 0.3), {"front", -0.2}}) {
      const double aside = exchanged ? -x : x;
      test::add_panel(garment, name, test::grid(0.4, 0.4, 4, 4),
                      [&](const Vec2& p) { return Vec3(aside + p.x(), p.y(), 0); });
    }
    classify(garment, {{"left_sleeve", BodyPart::right_arm}, {"front"}});
    EXPECT_EQ(garment.panels[0].is.part, BodyPart::left_arm);
    EXPECT_EQ(garment.has_places, !exchanged);
  }
}

TEST(Classify, TwoSeamsToAPanelMakeATubeWithIt) {
  PanelMesh garment;
  for (const auto& [name, width] : {std::pair("skirt_front", 0.5), {"skirt_back", 0.6}}) {
    test::add_panel(garment, name, test::grid(width, 0.6, 5, 6),
                    [](const Vec2& p) { return Vec3(p.x(), p.y(), 0); });
  }
  const auto side = [&](int panel, bool right) {
    return test::side(garment.panels[panel], 5, 6, right);
  };
  garment.seams = {test::seam("left", side(0, true), side(1, false)),
                   test::seam("right", side(0, false), side(1, true))};
  classify(garment, {{"skirt_front", BodyPart::left_arm}, {"skirt_back"}});
  EXPECT_EQ(garment.panels[0].is.worn_as, (Told<PanelRole>{skirt, PanelSource::seams}));
}

TEST(Classify, SeamsTellTheSideOfASleeve) {
  const auto side = [](const auto& change) {
    return classes("tshirt",
                   [&](PatternPanel& panel) {
                     if (panel.name == "left_sleeve_f") panel.part = BodyPart::right_arm;
                     change(panel);
                   })
        .at("left_sleeve_f")
        .side;
  };
  const Told<PanelSide> left{PanelSide::left, PanelSource::seams};
  EXPECT_EQ(side([](PatternPanel&) {}), left);
  // Fronts and backs tell it by where they are sewn.
  EXPECT_EQ(side([](PatternPanel& panel) {
              if (panel.name == "left_front") panel.name = "front_1";
              if (panel.name == "left_back") panel.name = "back_1";
              if (panel.name != "left_sleeve_b") return;
              panel.name = "piece";
              panel.part = BodyPart::none;
            }),
            left);
}

/// A sleeve of one piece, 0.4 x 0.5 m, whose left and right edges are sewn together.
PanelMesh sewn_sleeve() {
  PanelMesh garment;
  test::add_panel(garment, "sleeve", test::grid(0.4, 0.5, 4, 5),
                  [](const Vec2& p) { return Vec3(p.x(), p.y(), 0); });
  garment.seams = {test::seam("underarm", test::side(garment.panels[0], 4, 5, false),
                              test::side(garment.panels[0], 4, 5, true))};
  return garment;
}

TEST(Classify, APanelSewnToItselfAcrossItsWidthClosesAround) {
  EXPECT_TRUE(closes_around(sewn_sleeve(), 0));
}

TEST(Classify, ADartDoesNot) {
  PanelMesh garment = sewn_sleeve();
  // Both sides begin at the tip.
  garment.seams[0].b.front() = garment.seams[0].a.front();
  EXPECT_FALSE(closes_around(garment, 0));
  garment.seams.clear();
  EXPECT_FALSE(closes_around(garment, 0));
}

}  // namespace classify_test
}  // namespace toile
