#include "cloth/judge/wear_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <utility>

#include "cloth/judge/place_on_body.h"
#include "tests/cloth/figure.h"

namespace toile {
namespace wear_check_test {

using test::figure;
using test::pi;

/// Adds a tube of one panel around the line from `from` to `to`.
MeshedPanel& add_tube(PanelMesh& garment, const std::string& name, const Vec3& from, const Vec3& to,
                      double radius) {
  const double length = (to - from).norm();
  const Vec3 axis = (to - from) / length;
  const Vec3 u = axis.unitOrthogonal();
  const Vec3 v = axis.cross(u);
  const int around = 24;
  const int along = 8;
  MeshedPanel& panel = test::add_panel(
      garment, name, test::grid(2 * pi * radius, length, around, along), [&](const Vec2& p) {
        const double angle = p.x() / radius;
        return Vec3(from + p.y() * axis + radius * (std::cos(angle) * u + std::sin(angle) * v));
      });
  garment.seams.push_back(test::seam(name + " seam", test::side(panel, around, along, false),
                                     test::side(panel, around, along, true)));
  return garment.panels.back();
}

WearFindings check(const PanelMesh& garment, const Skeleton& skeleton = figure()) {
  const DressedGarment dressed = test::as_dressed(garment, garment.placed);
  return check_worn(garment, dressed, skeleton);
}

/// The figure with its thighs level.
Skeleton sitting() {
  Skeleton sits = figure();
  for (const auto& [side, x] : {std::pair("left", 0.1), std::pair("right", -0.1)}) {
    sits.joints[std::string(side) + "_knee"] = {x, 0.85, 0.4};
    sits.joints[std::string(side) + "_ankle"] = {x, 0.45, 0.4};
  }
  return sits;
}

PanelMesh moved(PanelMesh garment, const std::function<Vec3(const Vec3&)>& move) {
  for (Vec3& p : garment.placed) p = move(p);
  return garment;
}

/// Around the trunk, from the waist down.
PanelMesh skirt() {
  PanelMesh garment;
  add_tube(garment, "skirt", {0, 0.4, 0}, {0, 1.0, 0}, 0.25);
  return garment;
}

PanelMesh sleeve(const std::string& name, double from, double to) {
  PanelMesh garment;
  add_tube(garment, name, {from, 1.3, 0}, {to, 1.3, 0}, 0.07);
  return garment;
}

TEST(WearCheck, ASkirtAboutTheHips) {
  const WearFindings worn = check(skirt());
  EXPECT_TRUE(worn.is_checked);
  EXPECT_FALSE(worn.misplaced);
  EXPECT_TRUE(worn.unwrapped.empty());
  ASSERT_EQ(worn.openings.size(), 2U);
  for (const Opening& opening : worn.openings) {
    EXPECT_EQ(opening.limbs, through_hem);
    EXPECT_NEAR(opening.length, 2 * pi * 0.25, 1e-9);
  }
}

TEST(WearCheck, ASkirtTooLowOrTooHighIsMisplaced) {
  for (const double up : {-0.3, -0.6, 0.25}) {
    const WearFindings worn =
        check(moved(skirt(), [&](const Vec3& p) { return Vec3(p + Vec3(0, up, 0)); }));
    ASSERT_TRUE(worn.misplaced) << up;
    EXPECT_EQ(worn.misplaced->should_be, "waist or hips");
  }
  const WearFindings low =
      check(moved(skirt(), [](const Vec3& p) { return Vec3(p + Vec3(0, -0.3, 0)); }));
  EXPECT_EQ(low.misplaced->at, "thighs, 70 cm above the floor");
}

TEST(WearCheck, ASkirtOnTheThighsOfOneWhoSitsIsMisplaced) {
  PanelMesh garment;
  add_tube(garment, "skirt", {0, 0.85, 0.39}, {0, 0.85, 0.2}, 0.25);
  const WearFindings slid = check(garment, sitting());
  ASSERT_TRUE(slid.misplaced);
  EXPECT_EQ(slid.misplaced->should_be, "waist or hips");
  garment = {};
  add_tube(garment, "skirt", {0, 0.9, 0}, {0, 1.0, 0}, 0.25);
  EXPECT_FALSE(check(garment, sitting()).misplaced);
}

TEST(WearCheck, BelowTheFloor) {
  const WearFindings worn =
      check(moved(skirt(), [](const Vec3& p) { return Vec3(p + Vec3(0, -1, 0)); }));
  ASSERT_TRUE(worn.misplaced);
  EXPECT_EQ(worn.misplaced->at, "below the floor by 30 cm");
}

TEST(WearCheck, AStraplessTopBelongsAboutTheChest) {
  PanelMesh top;
  add_tube(top, "top", {0, 0.9, 0}, {0, 1.25, 0}, 0.22);
  EXPECT_FALSE(check(top).misplaced);
  const WearFindings low =
      check(moved(top, [](const Vec3& p) { return Vec3(p + Vec3(0, -0.25, 0)); }));
  ASSERT_TRUE(low.misplaced);
  EXPECT_EQ(low.misplaced->should_be, "chest or shoulders");
}

TEST(WearCheck, ASleeveBelongsOnItsArm) {
  EXPECT_FALSE(check(sleeve("left_sleeve", 0.3, 0.6)).misplaced);
  const WearFindings other = check(sleeve("left_sleeve", -0.6, -0.3));
  ASSERT_TRUE(other.misplaced);
  EXPECT_EQ(other.misplaced->part, BodyPart::left_arm);
  EXPECT_EQ(other.misplaced->should_be, "left arm");
  EXPECT_EQ(other.misplaced->at, "right arm, 130 cm above the floor");
  // Beside its arm it is where it should be, and goes around nothing.
  const WearFindings beside = check(moved(sleeve("left_sleeve", 0.3, 0.6),
                                          [](const Vec3& p) { return Vec3(p + Vec3(0, 0, 0.2)); }));
  EXPECT_FALSE(beside.misplaced);
  EXPECT_EQ(beside.unwrapped, std::vector{BodyPart::left_arm});
}

/// A left sleeve with a crown of 5 cm, sewn to a ring about the shoulder. `turn` radians about the
/// arm bring the crown away from the top.
PanelMesh set_in_sleeve(double turn) {
  constexpr double radius = 0.07;
  constexpr double length = 0.3;
  PanelMesh garment;
  const auto around = [&](double x, double flat_x) {
    const double angle = flat_x / radius + turn;
    return Vec3(x, 1.3 + radius * std::cos(angle), radius * std::sin(angle));
  };
  test::add_panel(garment, "left_sleeve", test::grid(2 * pi * radius, length, 24, 8),
                  [&](const Vec2& p) { return around(0.6 - p.y(), p.x()); });
  for (Vec2& p : garment.flat) p.y() *= 1 + 0.05 / length * std::cos(p.x() / radius);
  test::add_panel(garment, "left_front", test::grid(2 * pi * radius, 0.05, 24, 2),
                  [&](const Vec2& p) { return around(0.25 + p.y(), p.x()); });
  std::vector<int> of_sleeve;
  std::vector<int> of_front;
  for (int i = 0; i <= 24; ++i) {
    of_sleeve.push_back(8 * 25 + i);
    of_front.push_back(garment.panels[1].first_point + 2 * 25 + i);
  }
  garment.seams = {test::seam("underarm", test::side(garment.panels[0], 24, 8, false),
                              test::side(garment.panels[0], 24, 8, true)),
                   test::seam("ring", test::side(garment.panels[1], 24, 2, false),
                              test::side(garment.panels[1], 24, 2, true)),
                   test::seam("armhole", of_sleeve, of_front)};
  return garment;
}

TEST(WearCheck, ASleeveSetInUpsideDownIsMisplaced) {
  const auto at = [](double turn) {
    const WearFindings worn = check(set_in_sleeve(turn));
    return worn.misplaced ? worn.misplaced->at : "";
  };
  const std::string upside_down = "the sleeve is upside down, its crown at the armpit";
  EXPECT_EQ(at(pi), upside_down);
  EXPECT_EQ(at(0.8 * pi), upside_down);
  EXPECT_NE(at(0), upside_down);
  EXPECT_NE(at(0.3), upside_down);
}

TEST(WearCheck, ANameTellsTheSideBeforeAPartThatThePatternStates) {
  PanelMesh garment = sleeve("right_sleeve", 0.3, 0.6);
  garment.panels[0].is = classify({"right_sleeve", BodyPart::left_arm});
  ASSERT_TRUE(check(garment).misplaced);
  EXPECT_EQ(check(garment).misplaced->should_be, "right arm");
  for (const PanelSource source : {PanelSource::seams, PanelSource::asked}) {
    garment.panels[0].is.part = {BodyPart::left_arm, source};
    EXPECT_FALSE(check(garment).misplaced);
  }
}

TEST(WearCheck, ASleeveThatDoesNotReachDownItsArmDoesNotGoAroundIt) {
  // A strip at the shoulder, open below.
  PanelMesh strip;
  test::add_panel(strip, "left_sleeve", test::grid(0.1, 0.1, 4, 4),
                  [](const Vec2& p) { return Vec3(0.2 + p.x(), 1.42, p.y() - 0.05); });
  const WearFindings worn = check(strip);
  EXPECT_TRUE(worn.misplaced || !worn.unwrapped.empty());
}

TEST(WearCheck, ASkirtThatSlidDownIsMisplaced) {
  PanelMesh garment;
  add_tube(garment, "skirt", {0, 0.4, 0}, {0, 1.05, 0}, 0.25);
  const auto let_down = [&](double by) {
    std::vector<Vec3> points = garment.placed;
    for (Vec3& p : points) p.y() -= by;
    return check_worn(garment, test::as_dressed(garment, points), figure());
  };
  EXPECT_FALSE(let_down(0).misplaced);
  const double waist = figure().joint("waist").y();
  const double level = std::min(waist, 1.05);
  EXPECT_FALSE(let_down(1.05 - level + 0.07).misplaced);
  const WearFindings slid = let_down(1.05 - level + 0.09);
  ASSERT_TRUE(slid.misplaced);
  EXPECT_NE(slid.misplaced->at.find("slid down by 9 cm: its top edge is cut 157 cm long"),
            std::string::npos)
      << slid.misplaced->at;
}

TEST(WearCheck, TrousersBelongOnTwoLegs) {
  PanelMesh trousers;
  add_tube(trousers, "left_pant", {0.1, 0.1, 0}, {0.1, 0.7, 0}, 0.09);
  add_tube(trousers, "right_pant", {-0.1, 0.1, 0}, {-0.1, 0.7, 0}, 0.09);
  EXPECT_FALSE(check(trousers).misplaced);
  EXPECT_TRUE(check(trousers).unwrapped.empty());
  // Both tubes on the left leg.
  PanelMesh both;
  add_tube(both, "left_pant", {0.1, 0.1, 0}, {0.1, 0.7, 0}, 0.09);
  add_tube(both, "right_pant", {0.1, 0.1, 0}, {0.1, 0.7, 0}, 0.12);
  const WearFindings worn = check(both);
  ASSERT_TRUE(worn.misplaced);
  EXPECT_EQ(worn.misplaced->part, BodyPart::right_leg);
}

/// A tube around the trunk with two holes of 36 cm at its sides, as a sleeveless top has.
PanelMesh tube_with_armholes(double low) {
  PanelMesh garment;
  add_tube(garment, "piece", {0, low, 0}, {0, low + 0.6, 0}, 0.25);
  // Cut out squares of 2 by 2 cells of 6.5 by 7.5 cm.
  std::vector<Triangle> kept;
  for (int t = 0; t < static_cast<int>(garment.triangles.size()); ++t) {
    const int cell = t / 2;
    const int row = cell / 24;
    const int column = cell % 24;
    const bool is_hole = (row == 4 || row == 5) && (column % 12 == 3 || column % 12 == 4);
    if (!is_hole) kept.push_back(garment.triangles[t]);
  }
  garment.triangles = kept;
  garment.panels[0].triangles = static_cast<int>(kept.size());
  return garment;
}

TEST(WearCheck, AShirtAboutTheWaistHasTwoArmholesWithNothingInThem) {
  const WearFindings worn = check(tube_with_armholes(0.5));
  ASSERT_EQ(worn.openings.size(), 4U);
  EXPECT_TRUE(worn.misplaced || !worn.unwrapped.empty());
}

// The neckline hangs where it is highest: 0.2 m from the middle, 5 cm beyond the shoulders' joints.
TEST(WearCheck, AStrapThatSlidOffItsShoulderIsMisplaced) {
  const PanelMesh wide = tube_with_armholes(0.925);
  const auto worn_from = [&](double left, double right) {
    const auto scaled = [&](double to) {
      return [=](const Vec3& p) {
        return Vec3(p.x() * (p.x() > 0 ? left : right) / to, p.y(), p.z());
      };
    };
    const PanelMesh started = moved(wide, scaled(0.25));
    const PanelMesh lies = moved(wide, [](const Vec3& p) {
      return Vec3(p.x() * 0.8, p.y() + 0.1 * std::abs(p.x()), p.z());
    });
    return check_worn(started, test::as_dressed(lies, lies.placed), figure());
  };
  const auto at_neckline = [](const Opening& o) { return o.limbs == through_neckline; };
  const WearFindings off = worn_from(0.1, 0.2);
  ASSERT_TRUE(std::ranges::any_of(off.openings, at_neckline));
  ASSERT_TRUE(off.misplaced);
  EXPECT_EQ(off.misplaced->should_be, "left shoulder");
  EXPECT_EQ(off.misplaced->part, BodyPart::left_arm);
  const WearFindings other = worn_from(0.2, 0.1);
  ASSERT_TRUE(other.misplaced);
  EXPECT_EQ(other.misplaced->should_be, "right shoulder");
  EXPECT_FALSE(worn_from(0.2, 0.2).misplaced) << "it was cut so wide";
}

/// The tube with armholes at its sides, and a sleeve in each. `open`: its sides are cut from the
/// hem to the armholes.
PanelMesh shirt(bool open) {
  PanelMesh garment = moved(tube_with_armholes(0.925), [](const Vec3& p) {
    const double angle = pi / 3;
    return Vec3(std::cos(angle) * p.x() - std::sin(angle) * p.z(), p.y(),
                std::sin(angle) * p.x() + std::cos(angle) * p.z());
  });
  if (open) {
    // Holes took cells from each of the two columns, so that triangles are told by their middles.
    std::erase_if(garment.triangles, [&](const Triangle& t) {
      const Vec2 middle = (garment.flat[t[0]] + garment.flat[t[1]] + garment.flat[t[2]]) / 3;
      const int column = static_cast<int>(middle.x() / (2 * pi * 0.25 / 24));
      return middle.y() < 4 * 0.075 && column % 12 == 3;
    });
    garment.panels[0].triangles = static_cast<int>(garment.triangles.size());
  }
  const std::vector<Vec3> placed = garment.placed;
  for (const int first : {3, 15}) {
    std::vector<int> hole;
    for (const auto& [row, column] :
         {std::pair(4, 0), std::pair(4, 1), std::pair(4, 2), std::pair(5, 2), std::pair(6, 2),
          std::pair(6, 1), std::pair(6, 0), std::pair(5, 0), std::pair(4, 0)}) {
      hole.push_back(row * 25 + first + column);
    }
    const double side = placed[hole[0]].x() > 0 ? 1 : -1;
    const double step = 0.07;
    test::add_panel(garment, side > 0 ? "left_sleeve" : "right_sleeve",
                    test::grid(8 * step, 0.3, 8, 4), [&](const Vec2& p) {
                      const Vec3& at = placed[hole[std::lround(p.x() / step)]];
                      return Vec3(at.x() + side * p.y(), at.y(), at.z());
                    });
    const MeshedPanel& sleeve = garment.panels.back();
    std::vector<int> cap(9);
    std::iota(cap.begin(), cap.end(), sleeve.first_point);
    garment.seams.push_back(test::seam("armhole", cap, hole));
    garment.seams.push_back(
        test::seam("underarm", test::side(sleeve, 8, 4, false), test::side(sleeve, 8, 4, true)));
  }
  return garment;
}

TEST(WearCheck, AShirtWhoseSidesAreOpenToItsSleevesDoesNotGoAroundTheTrunk) {
  const WearFindings sewn = check(shirt(false));
  EXPECT_FALSE(sewn.misplaced);
  EXPECT_TRUE(sewn.unwrapped.empty());
  const WearFindings open = check(shirt(true));
  EXPECT_EQ(open.openings.size(), sewn.openings.size()) << "one hem, which climbs to the sleeves";
  EXPECT_EQ(open.unwrapped, std::vector{BodyPart::torso});
}

TEST(WearCheck, ASheetOfNoKindIsNotChecked) {
  PanelMesh sheet;
  test::add_panel(sheet, "piece", test::grid(1, 1, 6, 6),
                  [](const Vec2& p) { return Vec3(p.x() - 0.5, 1.9, p.y() - 0.5); });
  const WearFindings worn = check(sheet);
  EXPECT_FALSE(worn.is_checked);
  EXPECT_FALSE(worn.misplaced);
  // A wrap skirt in front of the body does not go around it.
  test::name_panel(sheet.panels[0], "skirt");
  const WearFindings skirt =
      check(moved(sheet, [](const Vec3& p) { return Vec3(p.x(), p.z() + 0.5, 0.3); }));
  EXPECT_TRUE(skirt.is_checked);
  EXPECT_TRUE(skirt.misplaced || !skirt.unwrapped.empty());
}

TEST(WearCheck, AGarmentTurnedAboutTheVertical) {
  const auto turned = [&](double angle) {
    return check(moved(test::tube(), [&](const Vec3& p) {
      return Vec3(std::cos(angle) * p.x() + std::sin(angle) * p.z(), p.y() - 0.3,
                  std::cos(angle) * p.z() - std::sin(angle) * p.x());
    }));
  };
  EXPECT_FALSE(turned(0).misplaced);
  EXPECT_FALSE(turned(0.8).misplaced);
  ASSERT_TRUE(turned(pi / 2).misplaced);
  EXPECT_EQ(turned(pi / 2).misplaced->at, "turned about the vertical by 90 degrees");
  EXPECT_TRUE(turned(pi).misplaced);
}

/// A drawing shows one of a pair, and its reader calls it left or right by chance.
TEST(WearCheck, WhichOfAPairIsTheLeftOneIsLeftOpen) {
  const auto turned = [&](double angle) {
    PanelMesh garment = test::tube();
    garment.panels[0].is = classify({"left_piece", BodyPart::torso});
    garment.panels[1].is = classify({"right_piece", BodyPart::torso});
    return check(moved(garment, [&](const Vec3& p) {
      return Vec3(std::cos(angle) * p.x() + std::sin(angle) * p.z(), p.y() - 0.3,
                  std::cos(angle) * p.z() - std::sin(angle) * p.x());
    }));
  };
  EXPECT_FALSE(turned(pi / 2).misplaced);
  EXPECT_FALSE(turned(-pi / 2).misplaced);
  EXPECT_TRUE(turned(0).misplaced) << "one in front, the other at the back";
}

/// Adds a panel that covers a share of the directions around the trunk, its middle in front.
MeshedPanel& add_front(PanelMesh& garment, const std::string& name, double low, double high,
                       double share) {
  const double radius = 0.25;
  const double width = share * 2 * pi * radius;
  return test::add_panel(garment, name, test::grid(width, high - low, 24, 8), [&](const Vec2& p) {
    const double angle = (p.x() - width / 2) / radius;
    return Vec3(radius * std::sin(angle), low + p.y(), radius * std::cos(angle));
  });
}

/// A skirt's front, and a waistband on it that does not reach around the body either.
PanelMesh apron(double share) {
  PanelMesh garment;
  const MeshedPanel skirt = add_front(garment, "apron_skirt", 0.5, 0.96, share);
  const MeshedPanel band = add_front(garment, "waistband", 0.96, 1.0, share);
  std::vector<int> top;
  std::vector<int> bottom;
  for (int column = 0; column <= 24; ++column) {
    top.push_back(skirt.first_point + 8 * 25 + column);
    bottom.push_back(band.first_point + column);
  }
  garment.seams.push_back(test::seam("waist", top, bottom));
  return garment;
}

TEST(WearCheck, AnApronCoversOneSideOfTheBody) {
  const PanelMesh worn = apron(0.6);
  const WearFindings findings = check(worn);
  EXPECT_TRUE(findings.is_checked);
  EXPECT_FALSE(findings.misplaced);
  EXPECT_TRUE(findings.unwrapped.empty());
  EXPECT_EQ(check(apron(0.4)).unwrapped, std::vector{BodyPart::torso});
}

TEST(WearCheck, AnApronThatSlidDownIsNotWorn) {
  const PanelMesh garment = apron(0.6);
  std::vector<Vec3> points = garment.placed;
  for (Vec3& p : points) p.y() -= 0.2;
  const WearFindings findings = check_worn(garment, test::as_dressed(garment, points), figure());
  EXPECT_TRUE(findings.misplaced || !findings.unwrapped.empty());
  ASSERT_TRUE(findings.slid);
  EXPECT_NEAR(findings.slid->down, 0.2, 1e-9);
}

/// A bib that a strap around the neck holds.
TEST(WearCheck, ABibApronHangsFromTheNeck) {
  PanelMesh garment;
  const MeshedPanel bib = add_front(garment, "apron", 0.6, 1.2, 0.6);
  // The strap runs from the bib's left upper corner around the neck to the right one.
  const MeshedPanel strap =
      test::add_panel(garment, "strap", test::grid(1, 0.1, 24, 1), [](const Vec2& p) {
        const double angle = 2 * pi * 0.3 + p.x() * 2 * pi * 0.4;
        const double up = std::sin(pi * p.x()) * 0.35;
        return Vec3(0.25 * std::sin(angle), 1.1 + p.y() + up, 0.25 * std::cos(angle));
      });
  garment.seams = {
      test::seam("left", {bib.first_point + 7 * 25 + 24, bib.first_point + 8 * 25 + 24},
                 {strap.first_point, strap.first_point + 25}),
      test::seam("right", {bib.first_point + 7 * 25, bib.first_point + 8 * 25},
                 {strap.first_point + 24, strap.first_point + 25 + 24})};
  const WearFindings findings = check(garment);
  EXPECT_TRUE(findings.is_checked);
  EXPECT_FALSE(findings.misplaced) << findings.misplaced->at;
  EXPECT_TRUE(findings.unwrapped.empty());
}

TEST(WearCheck, WhatLiesAtTheFeetHasSlid) {
  const PanelMesh garment = apron(1);
  std::vector<Vec3> points = garment.placed;
  for (Vec3& p : points) p = Vec3(p.x() + 0.6, 0.1 * p.y(), p.z());
  const WearFindings findings = check_worn(garment, test::as_dressed(garment, points), figure());
  EXPECT_TRUE(findings.misplaced || !findings.unwrapped.empty());
  ASSERT_TRUE(findings.slid);
  EXPECT_GT(findings.slid->down, 0.5);
}

TEST(WearCheck, WhatFellToTheFloorIsMisplacedWhateverItIs) {
  PanelMesh sheet;
  test::add_panel(sheet, "piece", test::grid(1, 0.2, 6, 6),
                  [](const Vec2& p) { return Vec3(p.x() - 0.5, 0.9 + p.y(), 0.3); });
  const auto lowered_by = [&](double fall) {
    std::vector<Vec3> points = sheet.placed;
    for (Vec3& p : points) p.y() -= fall;
    return check_worn(sheet, test::as_dressed(sheet, points), figure());
  };
  const WearFindings fallen = lowered_by(0.89);
  ASSERT_TRUE(fallen.misplaced);
  EXPECT_EQ(fallen.misplaced->should_be, "on the body");
  // Above the floor something else holds it.
  EXPECT_FALSE(lowered_by(0.3).misplaced);
}

// It was drafted to lie where it lies: nothing told where it goes.
TEST(WearCheck, WhatStandsAtTheFeetAndGoesAroundNothingIsNotWorn) {
  PanelMesh sheet;
  test::add_panel(sheet, "piece", test::grid(0.4, 0.2, 6, 6),
                  [](const Vec2& p) { return Vec3(p.x() - 0.2, 0.01 + p.y(), 0.3); });
  const WearFindings at_feet = check(sheet);
  ASSERT_TRUE(at_feet.misplaced);
  EXPECT_EQ(at_feet.misplaced->should_be, "on the body");
  const double shin = 0.1;
  PanelMesh gaiter;
  const Vec3 ankle = figure().joint("left_ankle");
  add_tube(gaiter, "piece", {ankle.x(), 0.01, ankle.z()}, {ankle.x(), 0.3, ankle.z()}, shin);
  EXPECT_FALSE(check(gaiter).misplaced) << check(gaiter).misplaced->should_be;
}

TEST(WearCheck, ACollarBelongsAtTheNeck) {
  const auto collar_at = [](double height) {
    PanelMesh garment;
    test::add_panel(garment, "collar", test::grid(0.3, 0.08, 6, 3),
                    [&](const Vec2& p) { return Vec3(p.x() - 0.15, height + p.y(), 0.15); });
    return check(garment);
  };
  EXPECT_FALSE(collar_at(1.35).misplaced);
  const WearFindings low = collar_at(0.8);
  ASSERT_TRUE(low.misplaced);
  EXPECT_EQ(low.misplaced->should_be, "neck or head");
  EXPECT_NE(low.misplaced->at.find("panel 'collar'"), std::string::npos) << low.misplaced->at;
}

TEST(WearCheck, WithoutAllJointsNothingIsChecked) {
  Skeleton skeleton = figure();
  skeleton.joints.erase("left_wrist");
  const PanelMesh garment = skirt();
  const DressedGarment dressed = test::as_dressed(garment, garment.placed);
  EXPECT_FALSE(check_worn(garment, dressed, skeleton).is_checked);
}

TEST(WearCheck, PlacesHaveNames) {
  EXPECT_EQ(place_on_body({0, 0.85, 0.1}, figure()), "hips, 85 cm above the floor");
  EXPECT_EQ(place_on_body({0.5, 1.3, 0}, figure()), "left arm, 130 cm above the floor");
  EXPECT_EQ(place_on_body({-0.1, 0.2, 0}, figure()), "shins, 20 cm above the floor");
  EXPECT_EQ(place_on_body({0, 1.0, 2}, figure()), "beside the body, 100 cm above the floor");
}

}  // namespace wear_check_test
}  // namespace toile
