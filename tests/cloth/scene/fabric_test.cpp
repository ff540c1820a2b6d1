#include "cloth/scene/fabric.h"

#include <gtest/gtest.h>

#include "tests/pattern/samples.h"
#include "tests/support/run_program.h"

namespace toile {
namespace fabric_test {

class FabricFile : public testing::Test {
 protected:
  std::string error(const std::string& text) {
    pipeline::write_text(file, text);
    return samples::error_of([&] { find_fabric(file.string()); });
  }

  pipeline::ScratchFolder scratch;
  std::filesystem::path file = scratch / "fabric.json";
};

TEST_F(FabricFile, EveryQuantityIsRead) {
  pipeline::write_text(file, R"({"name": "denim", "areal_density_kg_per_m2": 0.4,
      "stretch_warp_N_per_m": 5000, "stretch_weft_N_per_m": 3000.5, "shear_N_per_m": 0,
      "bending_warp_N_m": 8e-5, "bending_weft_N_m": 3e-5, "thickness_mm": 0.8,
      "friction_skin": 0.7, "friction_cloth": 0.3, "damping_s": 1e-5, "source": "a book",
      "estimated": ["damping_s"]})");
  const Fabric fabric = find_fabric(file.string());
  EXPECT_EQ(fabric.name, "denim");
  EXPECT_EQ(fabric.areal_density, 0.4);
  EXPECT_EQ(fabric.stretch_warp, 5000);
  EXPECT_EQ(fabric.stretch_weft, 3000.5);
  EXPECT_EQ(fabric.shear, 0);
  EXPECT_EQ(fabric.bending_warp, 8e-5);
  EXPECT_EQ(fabric.bending_weft, 3e-5);
  EXPECT_NEAR(fabric.thickness, 0.0008, 1e-15);
  EXPECT_EQ(fabric.friction_skin, 0.7);
  EXPECT_EQ(fabric.friction_cloth, 0.3);
  EXPECT_EQ(fabric.damping, 1e-5);
  EXPECT_EQ(fabric.source, "a book");
}

TEST_F(FabricFile, OneKeyMayStandForBoth) {
  pipeline::write_text(file, R"({"friction_cloth": 0.2, "bending_weft_N_m": 2e-5,
                                 "friction": 0.7, "bending_N_m": 4e-5})");
  const Fabric fabric = find_fabric(file.string());
  EXPECT_EQ(fabric.friction_skin, 0.7);
  EXPECT_EQ(fabric.friction_cloth, 0.2);
  EXPECT_EQ(fabric.bending_warp, 4e-5);
  EXPECT_EQ(fabric.bending_weft, 2e-5);
}

TEST_F(FabricFile, WhatIsTooStiffToComeToRestIsCutAndSaysSo) {
  pipeline::write_text(file, R"({"stretch_warp_N_per_m": 1e7, "stretch_weft_N_per_m": 1e5,
                                 "shear_N_per_m": 2e6})");
  const Fabric fabric = find_fabric(file.string());
  EXPECT_EQ(fabric.stretch_warp, 1e5);
  EXPECT_EQ(fabric.stretch_weft, 1e5);
  EXPECT_EQ(fabric.shear, 1e5);
  EXPECT_EQ(fabric.stiffness_given, 1e7);
  pipeline::write_text(file, R"({"stretch_warp_N_per_m": 1e5})");
  EXPECT_EQ(find_fabric(file.string()).stiffness_given, 0);
}

TEST_F(FabricFile, WhatIsMissingStaysAsTheDesignSays) {
  pipeline::write_text(file, R"({"friction": 0.1})");
  for (const Fabric& fabric : {find_fabric(file.string()), find_fabric("default")}) {
    EXPECT_EQ(fabric.areal_density, 0.15);
    EXPECT_EQ(fabric.stretch_warp, 1000);
    EXPECT_EQ(fabric.stretch_weft, 1000);
    EXPECT_EQ(fabric.shear, 200);
    EXPECT_EQ(fabric.bending_warp, 1e-5);
    EXPECT_EQ(fabric.bending_weft, 1e-5);
    EXPECT_EQ(fabric.thickness, 0.0003);
  }
  EXPECT_EQ(find_fabric(file.string()).friction_skin, 0.1);
  EXPECT_EQ(find_fabric("default").friction_skin, 0.4);
}

TEST_F(FabricFile, UnknownNamesAndKeysAreNamed) {
  const std::string unknown = samples::error_of([] { find_fabric("velvet"); });
  EXPECT_HOLDS(unknown, "'velvet'");
  for (const std::string& name : fabric_names()) EXPECT_HOLDS(unknown, name);
  EXPECT_HOLDS(error(R"({"estimated": ["weight"]})"), "'weight'");
  EXPECT_HOLDS(samples::error_of([&] { find_fabric(scratch / "."); }), "neither known nor a file");
  EXPECT_HOLDS(error(R"({"weight": 1})"), "'weight'");
  EXPECT_HOLDS(error(R"({"weight": 1})"), file.filename().string());
}

TEST_F(FabricFile, ValuesOutOfRangeAreRefused) {
  for (const char* value : {"0", "-1", "1e999", "-1e999"}) {
    for (const char* key : {"areal_density_kg_per_m2", "thickness_mm", "stretch_warp_N_per_m",
                            "stretch_weft_N_per_m"}) {
      const std::string message =
          error("{\"" + std::string(key) + "\": " + std::string(value) + "}");
      EXPECT_HOLDS(message, file.filename().string());
      EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 0) << message;
    }
  }
  for (const char* key : {"shear_N_per_m", "bending_N_m", "bending_weft_N_m", "friction",
                          "friction_skin", "friction_cloth", "damping_s"}) {
    EXPECT_EQ(error("{\"" + std::string(key) + "\": 0}"), "");
    EXPECT_HOLDS(error("{\"" + std::string(key) + "\": -0.1}"), key);
  }
}

TEST_F(FabricFile, WhatIsNoFabricIsRefused) {
  for (const char* text : {"", "[]", "3", "{\"friction\": \"rough\"}", "{\"friction\": null}",
                           "{\"name\": 3}", "{\"friction\": 0.4", "friction = 0.4"}) {
    EXPECT_HOLDS(error(text), file.filename().string());
  }
}

TEST_F(FabricFile, TheMessageSaysWhere) {
  EXPECT_HOLDS(error("{\"stretch_warp_N_per_m\": \"big\"}"),
               "fabric.json: 'stretch_warp_N_per_m': is not a number");
  EXPECT_HOLDS(error("{\"friction\": 0.4,\n}"), "fabric.json:2:1: is not JSON here");
  EXPECT_HOLDS(error("{\"estimated\": [3]}"), "'estimated'[0]: is not text");
  EXPECT_HOLDS(error("{\"friction\": null}"), "'friction': is null");
}

TEST_F(FabricFile, WhatNoFabricHasIsAMistakenUnit) {
  EXPECT_HOLDS(error("{\"thickness_mm\": 300}"), "'thickness_mm' is 300, more than any fabric has");
  EXPECT_HOLDS(error("{\"areal_density_kg_per_m2\": 150}"), "'areal_density_kg_per_m2' is 150");
  EXPECT_HOLDS(error("{\"bending_N_m\": 1e300}"), "more than any fabric has");
}

/// Of what can be worn; far outside, a unit was mistaken.
void expect_plausible(const Fabric& fabric) {
  const auto expect_within = [&](const char* what, double value, double least, double most) {
    EXPECT_TRUE(value >= least && value <= most) << fabric.name << ": " << what << " " << value;
  };
  expect_within("areal density", fabric.areal_density, 0.03, 0.8);
  expect_within("thickness", fabric.thickness, 0.0001, 0.003);
  // Fibres and air: wool and cotton are some 1300 to 1550 kg/m³, fabrics some 5 to 60 % of it.
  expect_within("density", fabric.areal_density / fabric.thickness, 70, 900);
  for (const double stretch : {fabric.stretch_warp, fabric.stretch_weft}) {
    expect_within("stretch", stretch, 10, 20000);
  }
  expect_within("shear", fabric.shear, 5, 500);
  for (const double bending : {fabric.bending_warp, fabric.bending_weft}) {
    expect_within("bending", bending, 5e-7, 2e-4);
    // The length of a strip that bends by about its own length under its weight [Peirce 1930].
    expect_within("bending length", std::cbrt(bending / (9.81 * fabric.areal_density)), 0.008,
                  0.04);
  }
  for (const double friction : {fabric.friction_skin, fabric.friction_cloth}) {
    expect_within("friction", friction, 0.1, 1);
  }
}

TEST(FabricPresets, EachIsPlausibleAndHasASource) {
  const std::vector<std::string> names = fabric_names();
  for (const char* wanted :
       {"default", "cotton-poplin", "denim", "silk-satin", "wool-suiting", "jersey"}) {
    EXPECT_EQ(std::count(names.begin(), names.end(), wanted), 1) << wanted;
  }
  for (const std::string& name : names) {
    const Fabric fabric = find_fabric(name);
    EXPECT_EQ(fabric.name, name);
    expect_plausible(fabric);
    if (name == "default") continue;
    EXPECT_GT(fabric.source.size(), 80U) << name;
    EXPECT_TRUE(fabric.source.find("19") != std::string::npos ||
                fabric.source.find("20") != std::string::npos)
        << name << ": a source has a year";
  }
}

}  // namespace fabric_test
}  // namespace toile
