// Sample patterns without any place in them, put on the mannequin.
#include "cloth/start/find_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "cloth/start/place_panels.h"
#include "cloth/start/places_fit.h"
#include "cloth/start/positioning.h"
#include "geometry/body/mannequin/mannequin.h"
#include "geometry/error.h"
#include "io/output_file.h"
#include "tests/cloth/panels.h"
#include "tests/pattern/samples.h"

namespace toile {
namespace find_places_test {

using Json = nlohmann::ordered_json;

const Mannequin& body() {
  MannequinOptions coarse;
  coarse.edge_length = 0.015;
  static const Mannequin mannequin = make_mannequin(coarse);
  return mannequin;
}

Json sample(const std::string& name) {
  return Json::parse(read_file(std::string(TOILE_SOURCE_DIR) + "/samples/" + name + ".json"));
}

void strip(Json& pattern) {
  for (auto& [name, panel] : pattern["pattern"]["panels"].items()) {
    for (const char* key : {"translation", "rotation", "placement"}) panel.erase(key);
  }
}

std::vector<std::string> names_in(const Json& pattern) {
  std::vector<std::string> names;
  for (const auto& [name, panel] : pattern["pattern"]["panels"].items()) names.push_back(name);
  return names;
}

/// Calls the panels anew, in the order of their old names in `names`.
void rename(Json& pattern, const std::vector<std::string>& names,
            const std::map<std::string, std::string>& renamed) {
  Json& panels = pattern["pattern"]["panels"];
  Json anew = Json::object();
  for (const std::string& name : names) anew[renamed.at(name)] = panels[name];
  panels = anew;
  pattern["pattern"].erase("panel_order");
  for (Json& stitch : pattern["pattern"]["stitches"]) {
    for (Json& side : stitch) {
      if (side.is_object() && side.contains("panel")) side["panel"] = renamed.at(side["panel"]);
    }
  }
}

/// The panels renamed to p0, p1 ... in the order of their reversed names, so that no name tells.
std::map<std::string, std::string> rename(Json& pattern) {
  std::vector<std::string> names = names_in(pattern);
  std::ranges::sort(
      names, {}, [](const std::string& name) { return std::string(name.rbegin(), name.rend()); });
  std::map<std::string, std::string> renamed;
  for (std::size_t i = 0; i < names.size(); ++i) renamed[names[i]] = "p" + std::to_string(i);
  rename(pattern, names, renamed);
  return renamed;
}

PanelMesh meshed(const Json& pattern) {
  std::vector<Remark> remarks;
  MeshSettings coarse;
  coarse.edge_length = 0.03;
  return mesh_panels(parse_pattern(pattern.dump(), "test.json", remarks), coarse, remarks);
}

std::map<std::string, FoundPlace> by_name(const std::vector<FoundPlace>& places) {
  std::map<std::string, FoundPlace> named;
  for (const FoundPlace& place : places) named[place.panel] = place;
  return named;
}

Vec3 middle(const PanelMesh& garment, const std::string& name) {
  const auto panel = std::ranges::find(garment.panels, name, &MeshedPanel::name);
  Vec3 sum = Vec3::Zero();
  for (int p = panel->first_point; p < panel->first_point + panel->points; ++p) {
    sum += garment.placed[p];
  }
  return sum / panel->points;
}

std::vector<FoundPlace> place(PanelMesh& garment, const AskedPlaces& asked = {}) {
  return find_places(body().surface, body().skeleton, asked, garment);
}

TEST(FindPlaces, ATshirtStandsWhereItsSampleDoes) {
  Json pattern = sample("tshirt");
  const PanelMesh stated = meshed(pattern);
  strip(pattern);
  PanelMesh garment = meshed(pattern);
  EXPECT_FALSE(garment.has_places);
  const auto places = by_name(place(garment));
  EXPECT_EQ(text_of(places.at("left_front")), "left_front: torso, front");
  EXPECT_EQ(text_of(places.at("right_back")), "right_back: torso, back");
  EXPECT_EQ(text_of(places.at("left_sleeve_f")), "left_sleeve_f: left arm, front");
  EXPECT_EQ(text_of(places.at("right_sleeve_b")), "right_sleeve_b: right arm, back");
  for (const MeshedPanel& panel : garment.panels) {
    const Vec3 here = middle(garment, panel.name);
    const Vec3 there = middle(stated, panel.name);
    EXPECT_LT((here - there).head<2>().norm(), 0.14) << panel.name;
    EXPECT_GT(here.z() * there.z(), 0) << panel.name;
  }
  // Left and right are mirror images.
  const Vec3 left = middle(garment, "left_front");
  const Vec3 right = middle(garment, "right_front");
  EXPECT_NEAR(left.x(), -right.x(), 0.005);
  EXPECT_NEAR(left.y(), right.y(), 0.005);
}

TEST(PlacePanels, ShoulderSeamsComeToTheShouldersOfTallAndShort) {
  for (const double scale : {0.86, 1.0, 1.15}) {
    TriangleMesh surface = body().surface;
    Skeleton skeleton = body().skeleton;
    for (Vec3& point : surface.points) point.y() *= scale;
    for (auto& [name, joint] : skeleton.joints) joint.y() *= scale;
    const PanelMesh drawn = meshed(sample("tshirt"));
    PanelMesh garment = drawn;
    const PlacedPanels placed = place_panels(surface, &skeleton, {}, garment);
    EXPECT_EQ(placed.moved.has_value(), scale != 1.0);
    double top = 0;
    for (const Vec3& point : garment.placed) top = std::max(top, point.y());
    EXPECT_GT(top, skeleton.joint("left_shoulder").y() - 1e-6) << scale;
    EXPECT_LT(top, skeleton.joint("neck").y() + 0.06) << scale;
  }
}

TEST(FindPlaces, ADrawingThatLooksUpsideDownIsNamed) {
  Json pattern = sample("tshirt");
  strip(pattern);
  for (const bool turned : {false, true}) {
    if (turned) {
      for (auto& [name, panel] : pattern["pattern"]["panels"].items()) {
        for (Json& vertex : panel["vertices"]) {
          vertex = {-vertex[0].get<double>(), -vertex[1].get<double>()};
        }
      }
    }
    PanelMesh garment = meshed(pattern);
    const PlacedPanels placed = place_panels(body().surface, &body().skeleton, {}, garment);
    for (const FoundPlace& place : placed.places) EXPECT_EQ(place.upside_down, turned);
    EXPECT_EQ(placed.is_upside_down, turned);
  }
  for (const std::string name : {"jacket", "bodice_dress", "trousers", "fitted_tshirt"}) {
    Json other = sample(name);
    strip(other);
    PanelMesh garment = meshed(other);
    for (const FoundPlace& found : place(garment)) EXPECT_FALSE(found.upside_down) << name;
  }
}

TEST(FindPlaces, NamesTellFrontFromBackBeforeTheNeckline) {
  // The deeper neckline is called the back's.
  Json pattern = sample("tshirt");
  strip(pattern);
  std::map<std::string, std::string> swapped;
  for (const std::string& name : names_in(pattern)) {
    std::string other = name;
    const auto swap = [&](const std::string& from, const std::string& to) {
      if (!other.ends_with(from)) return false;
      other.replace(other.size() - from.size(), from.size(), to);
      return true;
    };
    EXPECT_TRUE(swap("front", "back") || swap("back", "front") || swap("_f", "_b") ||
                swap("_b", "_f"))
        << name;
    swapped[name] = other;
  }
  rename(pattern, names_in(pattern), swapped);
  PanelMesh garment = meshed(pattern);
  const auto places = by_name(place(garment));
  for (const char* side : {"left_", "right_"}) {
    EXPECT_EQ(places.at(side + std::string("front")).side, PlacementSide::front) << side;
    EXPECT_EQ(places.at(side + std::string("back")).side, PlacementSide::back) << side;
    EXPECT_GT(middle(garment, side + std::string("front")).z(),
              middle(garment, side + std::string("back")).z());
  }
}

TEST(FindPlaces, WithoutNamesTheSameParts) {
  for (const std::string name : {"tshirt", "trousers", "jacket", "bodice_dress"}) {
    Json pattern = sample(name);
    strip(pattern);
    PanelMesh named = meshed(pattern);
    const auto with = by_name(place(named));
    const auto renamed = rename(pattern);
    PanelMesh nameless = meshed(pattern);
    const auto without = by_name(place(nameless));
    for (const auto& [old, now] : renamed) {
      const FoundPlace& a = with.at(old);
      const FoundPlace& b = without.at(now);
      EXPECT_EQ(std::pair(is_arm(a.part), is_leg(a.part)),
                std::pair(is_arm(b.part), is_leg(b.part)))
          << name << " " << old;
      EXPECT_EQ(a.around, b.around) << name << " " << old;
      // The deeper neckline, the lower rise are in front. Limbs may change sides.
      EXPECT_TRUE(a.part != BodyPart::torso || a.side == b.side) << name << " " << old;
    }
  }
}

TEST(FindPlaces, ShouldersStandOnTheBodys) {
  Json pattern = sample("tshirt");
  strip(pattern);
  PanelMesh garment = meshed(pattern);
  place(garment);
  const double neck = body().skeleton.joint("neck").y();
  const double shoulder = body().skeleton.joint("left_shoulder").y();
  double highest = 0;
  for (const Vec3& p : garment.placed) highest = std::max(highest, p.y());
  EXPECT_GT(highest, shoulder);
  EXPECT_LT(highest, neck + 0.08);
}

TEST(FindPlaces, ASleeveOfOnePieceIsRolledAroundItsArm) {
  Json pattern = sample("jacket");
  strip(pattern);
  PanelMesh garment = meshed(pattern);
  const auto places = by_name(place(garment));
  EXPECT_EQ(text_of(places.at("left_sleeve")), "left_sleeve: left arm, around");
  const auto sleeve = std::ranges::find(garment.panels, "left_sleeve", &MeshedPanel::name);
  EXPECT_EQ(sleeve->is.part, BodyPart::left_arm);
  EXPECT_EQ(sleeve->placement.around, 1);
}

TEST(FindPlaces, ACuffOfOnePieceIsRolledBelowItsSleeveInAnyOrder) {
  Json pattern = Json::parse(read_file(TOILE_SOURCE_DIR "/tests/pattern/seams/drafts/sven.json"));
  Json& order = pattern["pattern"]["panel_order"];
  const DistanceGrid skin{SurfaceDistance(body().surface)};
  for (const bool cuffs_first : {false, true}) {
    if (cuffs_first) std::reverse(order.begin(), order.end());
    PanelMesh garment = meshed(pattern);
    const auto places = by_name(place(garment));
    EXPECT_EQ(text_of(places.at("left_cuff")), "left_cuff: left arm, around");
    EXPECT_EQ(text_of(places.at("right_cuff")), "right_cuff: right arm, around");
    garment.placed = position_panels(garment, skin, &body().skeleton).placed;
    const Vec3 elbow = body().skeleton.joint("left_elbow");
    const Vec3 down = (body().skeleton.joint("left_wrist") - elbow).normalized();
    const double sleeve = down.dot(middle(garment, "left_sleeve") - elbow);
    const double cuff = down.dot(middle(garment, "left_cuff") - elbow);
    EXPECT_GT(cuff, sleeve + 0.2) << cuffs_first;
    // The sleeve's middle is between shoulder and wrist.
    EXPECT_LT(sleeve, down.dot(body().skeleton.joint("left_wrist") - elbow)) << cuffs_first;
    EXPECT_GT(sleeve, down.dot(body().skeleton.joint("left_shoulder") - elbow)) << cuffs_first;
  }
}

/// The sample T-shirt with a strip around its neckline, open in front, which is drawn turned by
/// quarters of a turn.
Json with_collar(int quarters) {
  Json pattern = sample("tshirt");
  strip(pattern);
  const auto drawn = [&](double x, double y) {
    for (int i = 0; i < quarters; ++i) x = -std::exchange(y, x);
    return Json{x, y};
  };
  const double front = std::hypot(9, 10);  // the lengths of the neckline's edges, cm
  const double back = std::hypot(9, 2.2);
  const double width = 2 * (front + back);
  Json collar;
  collar["vertices"] = {drawn(0, 0),
                        drawn(front, 0),
                        drawn(front + back, 0),
                        drawn(front + 2 * back, 0),
                        drawn(width, 0),
                        drawn(width, 6),
                        drawn(0, 6)};
  for (int i = 0; i < 7; ++i) collar["edges"].push_back({{"endpoints", {i, (i + 1) % 7}}});
  pattern["pattern"]["panels"]["k7"] = collar;
  pattern["pattern"].erase("panel_order");
  const std::pair<const char*, int> neckline[] = {
      {"left_front", 4}, {"left_back", 1}, {"right_back", 4}, {"right_front", 1}};
  for (int i = 0; i < 4; ++i) {
    pattern["pattern"]["stitches"].push_back(
        {{{"panel", "k7"}, {"edge", i}},
         {{"panel", neckline[i].first}, {"edge", neckline[i].second}}});
  }
  return pattern;
}

TEST(FindPlaces, ACollarGoesAroundTheNeckHoweverItIsDrawn) {
  const DistanceGrid skin{SurfaceDistance(body().surface)};
  const Vec3 neck = body().skeleton.joint("neck");
  for (int quarters = 0; quarters < 4; ++quarters) {
    PanelMesh garment = meshed(with_collar(quarters));
    const auto places = by_name(place(garment));
    EXPECT_EQ(text_of(places.at("k7")), "k7: torso, around") << quarters;
    garment.placed = position_panels(garment, skin, &body().skeleton).placed;
    // Its ends are in front, its middle is behind, and its seam lies below its free edge.
    const auto collar = std::ranges::find(garment.panels, "k7", &MeshedPanel::name);
    double seam = 0;
    double edge = 0;
    for (int p = collar->first_point; p < collar->first_point + collar->points; ++p) {
      Vec2 upright = garment.flat[p];
      for (int i = 0; i < quarters; ++i) upright = {upright.y(), -upright.x()};
      const Vec3 from_neck = garment.placed[p] - neck;
      const double along = upright.x() - std::hypot(0.09, 0.1) - std::hypot(0.09, 0.022);
      EXPECT_GT(from_neck.z() * (std::abs(along) - 0.11), -0.004) << quarters << ' ' << along;
      EXPECT_LT(from_neck.norm(), 0.2);
      if (upright.y() < 0.001) seam = std::max(seam, garment.placed[p].y());
      if (upright.y() > 0.059) edge = std::max(edge, garment.placed[p].y());
    }
    EXPECT_GT(edge, seam + 0.03) << quarters;
  }
}

TEST(FindPlaces, ACollarOnAStandIsAtTheNeckAndNoLeg) {
  for (const double height : {4.0, 6.0}) {  // a stand of another size, and one that is alike
    Json pattern = with_collar(0);
    const double width = 2 * (std::hypot(9, 10) + std::hypot(9, 2.2));
    Json leaf;
    leaf["vertices"] = {{0, 0}, {width, 0}, {width, height}, {0, height}};
    for (int i = 0; i < 4; ++i) leaf["edges"].push_back({{"endpoints", {i, (i + 1) % 4}}});
    pattern["pattern"]["panels"]["k8"] = leaf;
    pattern["pattern"]["stitches"].push_back(
        {{{"panel", "k8"}, {"edge", 0}}, {{"panel", "k7"}, {"edge", 5}}});
    PanelMesh garment = meshed(pattern);
    const auto places = by_name(place(garment));
    EXPECT_EQ(text_of(places.at("k7")), "k7: torso, around") << height;
    EXPECT_EQ(text_of(places.at("k8")), "k8: torso, around") << height;
    const DistanceGrid skin{SurfaceDistance(body().surface)};
    garment.placed = position_panels(garment, skin, &body().skeleton).placed;
    EXPECT_GT(middle(garment, "k8").y(), body().skeleton.joint("neck").y()) << height;
    EXPECT_LT(middle(garment, "k8").y(), body().skeleton.joint("neck").y() + 0.15) << height;
  }
}

TEST(FindPlaces, HalfAHoodThatTheOtherHalfHoldsStandsAcrossFromIt) {
  Json pattern = Json::parse(read_file(TOILE_SOURCE_DIR "/tests/pattern/seams/drafts/hugo.json"));
  Json& inner = pattern["pattern"];
  Json order = Json::array();
  for (const Json& name : inner["panel_order"]) {
    const std::string text = name;
    const bool is_spare =
        text.find("ocket") != std::string::npos || text == "neckBinding" || text == "waistband";
    if (is_spare) inner["panels"].erase(text);
    if (!is_spare) order.push_back(name);
  }
  inner["panel_order"] = order;
  std::erase_if(inner["stitches"].get_ref<Json::array_t&>(), [](const Json& stitch) {
    return stitch.dump().find("waistband") != std::string::npos;
  });
  // The hood's right half hangs on its middle alone.
  inner["stitches"].push_back(
      {{{"panel", "left_hoodSide"}, {"edge", 3}}, {{"panel", "back"}, {"edge", 3}}});
  PanelMesh garment = meshed(pattern);
  place(garment);
  const Vec3 left = middle(garment, "left_hoodSide");
  const Vec3 right = middle(garment, "right_hoodSide");
  const double centre = body().skeleton.joint("neck").x();
  EXPECT_LT((left.x() - centre) * (right.x() - centre), 0);
  EXPECT_NEAR(std::abs(left.x() - centre), std::abs(right.x() - centre), 0.01);
}

TEST(FindPlaces, TrousersRunDownTheLegsBelowTheCrotch) {
  Json pattern = sample("trousers");
  strip(pattern);
  PanelMesh garment = meshed(pattern);
  const auto places = by_name(place(garment));
  EXPECT_EQ(places.at("left_front").part, BodyPart::left_leg);
  EXPECT_EQ(places.at("right_back").part, BodyPart::right_leg);
  double highest = 0;
  for (const Vec3& p : garment.placed) highest = std::max(highest, p.y());
  EXPECT_LT(highest, body().skeleton.joint("waist").y() + 0.05);
  // Both ends of a leg stand on its own side.
  const auto leg = std::ranges::find(garment.panels, "left_front", &MeshedPanel::name);
  Vec3 lowest(0, 9, 0);
  for (int p = leg->first_point; p < leg->first_point + leg->points; ++p) {
    if (garment.placed[p].y() < lowest.y()) lowest = garment.placed[p];
  }
  EXPECT_GT(lowest.x(), 0);
  EXPECT_LT(lowest.x(), 0.25);
}

/// A polygon of a pattern file, its edges in order.
Json polygon(const std::vector<std::array<double, 2>>& vertices) {
  Json panel = {{"vertices", vertices}, {"edges", Json::array()}};
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    panel["edges"].push_back({{"endpoints", {i, (i + 1) % vertices.size()}}});
  }
  return panel;
}

/// Leggings of one piece a leg, whose inseam is in two parts, on a waistband that closes itself.
TEST(FindPlaces, LegsOfOnePieceHangFromTheirHalvesOfTheWaistband) {
  Json pattern = sample("tube_top");
  const Json leg =
      polygon({{-10, 0}, {10, 0}, {17, 35}, {25, 70}, {18, 90}, {-18, 90}, {-25, 70}, {-17, 35}});
  const auto side = [](const char* panel, int edge) {
    return Json{{"panel", panel}, {"edge", edge}};
  };
  const auto leggings = [&](bool exchanged) {
    const char* first = exchanged ? "p3" : "p2";
    const char* second = exchanged ? "p2" : "p3";
    Json& inner = pattern["pattern"];
    inner.erase("panel_order");
    inner["panels"] = {
        {"p1", polygon({{0, 0}, {36, 0}, {72, 0}, {72, 5}, {0, 5}})}, {"p2", leg}, {"p3", leg}};
    inner["stitches"] = Json::array();
    const auto sew = [&](const Json& a, const Json& b) { inner["stitches"].push_back({a, b}); };
    sew(side("p1", 2), side("p1", 4));
    sew(side("p1", 0), side(first, 4));
    sew(side("p1", 1), side(second, 4));
    for (const char* of : {"p2", "p3"}) {
      sew(side(of, 1), side(of, 7));
      sew(side(of, 2), side(of, 6));
    }
    sew(side(first, 3), side(second, 5));
    sew(side(first, 5), side(second, 3));
    return meshed(pattern);
  };
  const DistanceGrid skin{SurfaceDistance(body().surface)};
  for (const bool exchanged : {false, true}) {
    PanelMesh garment = leggings(exchanged);
    const auto places = by_name(place(garment));
    EXPECT_EQ(text_of(places.at("p1")), "p1: torso, around");
    EXPECT_EQ(places.at("p2").part, exchanged ? BodyPart::left_leg : BodyPart::right_leg);
    EXPECT_EQ(places.at("p3").part, exchanged ? BodyPart::right_leg : BodyPart::left_leg);
    EXPECT_TRUE(places.at("p2").around);
    garment.placed = position_panels(garment, skin, &body().skeleton).placed;
    // The crotch is at the body's, 70 of 90 cm above the hem. The band is upon the legs.
    const MeshedPanel& leg_panel = garment.panels[1];
    double crotch = 0;
    double top = 0;
    for (int p = leg_panel.first_point; p < leg_panel.first_point + leg_panel.points; ++p) {
      if (std::abs(garment.flat[p].y() - 0.7) < 0.001) crotch = garment.placed[p].y();
      top = std::max(top, garment.placed[p].y());
    }
    EXPECT_NEAR(crotch, body().skeleton.joint("pelvis").y(), 0.03);
    EXPECT_NEAR(middle(garment, "p1").y(), top + 0.025, 0.03);
  }
}

TEST(FindPlaces, WhatIsAskedIsDone) {
  Json pattern = sample("tshirt");
  strip(pattern);
  PanelMesh garment = meshed(pattern);
  AskedPlaces asked;
  for (const std::string side : {"left", "right"}) {
    asked[side + "_front"].side = PlacementSide::back;
    asked[side + "_back"].side = PlacementSide::front;
  }
  const auto places = by_name(place(garment, asked));
  EXPECT_EQ(text_of(places.at("left_front")), "left_front: torso, back (as asked)");
  EXPECT_LT(middle(garment, "left_front").z(), 0);
  EXPECT_GT(middle(garment, "left_back").z(), 0);
}

TEST(FindPlaces, RefusesWhatNothingTells) {
  const auto refusal = [](PanelMesh garment, const Skeleton& skeleton, const AskedPlaces& asked) {
    try {
      find_places(body().surface, skeleton, asked, garment);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  Json pattern = sample("band");
  strip(pattern);
  const PanelMesh sewn = meshed(pattern);
  EXPECT_EQ(refusal(sewn, body().skeleton, {}), "");
  EXPECT_NE(refusal(sewn, {}, {}).find("'front'"), std::string::npos);
  EXPECT_NE(refusal(sewn, body().skeleton, {{"nobody", {}}}).find("'nobody'"), std::string::npos);
  const AskedPlaces aside = {{"front", {BodyPart::torso, PlacementSide::left, false}}};
  EXPECT_NE(refusal(sewn, body().skeleton, aside).find("sides of the head only"),
            std::string::npos);
  pattern["pattern"]["stitches"] = Json::array();
  const std::string heap = refusal(meshed(pattern), body().skeleton, {});
  EXPECT_NE(heap.find("'front'"), std::string::npos) << heap;
  EXPECT_NE(heap.find("--place"), std::string::npos) << heap;
}

TEST(PlacesFit, OnlyWhatLeansDoesNot) {
  Json pattern = sample("tshirt");
  const PanelMesh stated = meshed(pattern);
  EXPECT_TRUE(stands_as_drawn(stated));
  pattern["pattern"]["panels"]["left_back"]["rotation"] = {20, 0, 0};
  const PanelMesh leaning = meshed(pattern);
  EXPECT_FALSE(stands_as_drawn(leaning));
  PanelMesh found = leaning;
  const auto places = place(found);
  EXPECT_EQ(unfit_place(leaning, found, places), "panel 'left_back' leans by 20 degrees");
  EXPECT_EQ(unfit_place(stated, found, places), "");
}

}  // namespace find_places_test
}  // namespace toile
