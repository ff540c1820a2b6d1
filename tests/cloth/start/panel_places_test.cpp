#include "cloth/start/panel_places.h"

#include <gtest/gtest.h>

#include <string>

#include "geometry/error.h"

namespace toile {
namespace panel_places_test {

TEST(AskedPlace, IsReadFromText) {
  const auto [panel, place] = parse_asked_place("front=torso:back");
  EXPECT_EQ(panel, "front");
  EXPECT_EQ(place.part, BodyPart::torso);
  EXPECT_EQ(place.side, PlacementSide::back);
  EXPECT_FALSE(place.around);
  const auto [sleeve, rolled] = parse_asked_place("a=b=left_arm:around");
  EXPECT_EQ(sleeve, "a=b");
  EXPECT_EQ(rolled.part, BodyPart::left_arm);
  EXPECT_TRUE(rolled.around);
  EXPECT_EQ(parse_asked_place("p=left").second.side, PlacementSide::left);
}

TEST(AskedPlace, WhatIsNoPlaceIsRefused) {
  for (const std::string text :
       {"front", "=torso", "front=", "front=chest", "front=torso:front:up", "front=torso:left_arm",
        "front=front:back", "front=torso:front:around", "front=torso:", "front=around:around"}) {
    try {
      parse_asked_place(text);
      FAIL() << text;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("'" + text + "'"), std::string::npos);
    }
  }
}

TEST(FoundPlace, IsSaidInOneLine) {
  EXPECT_EQ(text_of({"front", BodyPart::torso, PlacementSide::front, false, false}),
            "front: torso, front");
  EXPECT_EQ(text_of({"s", BodyPart::left_arm, PlacementSide::left, true, true}),
            "s: left arm, around (as asked)");
}

}  // namespace panel_places_test
}  // namespace toile
