#include "cloth/fabric.h"

#include <gtest/gtest.h>

#include "tests/pattern/samples.h"
#include "tests/pipeline/run_program.h"

namespace toile {
namespace {

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
      "bending_N_m": 8e-5, "friction": 0.7})");
  const Fabric fabric = find_fabric(file.string());
  EXPECT_EQ(fabric.name, "denim");
  EXPECT_EQ(fabric.areal_density, 0.4);
  EXPECT_EQ(fabric.stretch_warp, 5000);
  EXPECT_EQ(fabric.stretch_weft, 3000.5);
  EXPECT_EQ(fabric.shear, 0);
  EXPECT_EQ(fabric.bending_warp, 8e-5);
  EXPECT_EQ(fabric.friction_skin, 0.7);
}

TEST_F(FabricFile, WhatIsMissingStaysAsTheDesignSays) {
  pipeline::write_text(file, R"({"friction": 0.1})");
  for (const Fabric& fabric : {find_fabric(file.string()), find_fabric("default")}) {
    EXPECT_EQ(fabric.areal_density, 0.15);
    EXPECT_EQ(fabric.stretch_warp, 1000);
    EXPECT_EQ(fabric.stretch_weft, 1000);
    EXPECT_EQ(fabric.shear, 200);
    EXPECT_EQ(fabric.bending_warp, 1e-5);
  }
  EXPECT_EQ(find_fabric(file.string()).friction_skin, 0.1);
  EXPECT_EQ(find_fabric("default").friction_skin, 0.4);
}

TEST_F(FabricFile, UnknownNamesAndKeysAreNamed) {
  EXPECT_HOLDS(samples::error_of([] { find_fabric("velvet"); }), "'velvet'");
  EXPECT_HOLDS(error(R"({"weight": 1})"), "'weight'");
  EXPECT_HOLDS(error(R"({"weight": 1})"), file.filename().string());
}

TEST_F(FabricFile, ValuesOutOfRangeAreRefused) {
  for (const char* value : {"0", "-1", "1e999", "-1e999"}) {
    for (const char* key :
         {"areal_density_kg_per_m2", "stretch_warp_N_per_m", "stretch_weft_N_per_m"}) {
      const std::string message =
          error("{\"" + std::string(key) + "\": " + std::string(value) + "}");
      EXPECT_HOLDS(message, file.filename().string());
      EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 0) << message;
    }
  }
  for (const char* key : {"shear_N_per_m", "bending_N_m", "friction"}) {
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

}  // namespace
}  // namespace toile
