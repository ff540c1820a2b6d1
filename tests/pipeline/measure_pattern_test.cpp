// The program measure-pattern, from a pattern and a specification to the table of both.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/pattern/samples.h"
#include "tests/support/run_program.h"

namespace toile {
namespace measure_pattern_test {

using pipeline::read_text;
using pipeline::run;
using pipeline::ScratchFolder;
using pipeline::write_text;
using Json = nlohmann::json;

std::string shirt() {
  return (std::filesystem::path(TOILE_SOURCE_DIR) / "samples" / "tshirt.json").string();
}

TEST(MeasurePattern, WhatItWritesIsASpecThatHolds) {
  const ScratchFolder folder;
  ASSERT_EQ(run("measure-pattern", {shirt(), "-o", folder / "pom.csv"}).exit_code, 0);
  // Its own figures as the spec, one of them a centimetre off.
  std::string spec = "name,spec_cm\n";
  std::istringstream rows(read_text(folder / "pom.csv"));
  std::string row;
  std::getline(rows, row);
  EXPECT_EQ(row, "name,measured,spec_cm,actual_cm,difference_cm,tolerance_cm,result");
  int count = 0;
  while (std::getline(rows, row)) {
    const std::string name = row.substr(0, row.find(','));
    const std::size_t actual = row.find(",,") + 2;
    const double value = std::stod(row.substr(actual)) + (name == "half hem" ? 1 : 0);
    spec += name + "," + std::to_string(value) + "\n";
    ++count;
  }
  EXPECT_GT(count, 15);
  write_text(folder / "spec.csv", spec);
  const auto done = run("measure-pattern", {shirt(), "-o", folder / "out.csv", "--pom",
                                            folder / "spec.csv", "--report", folder / "out.json"});
  EXPECT_EQ(done.exit_code, 3) << done.err;
  EXPECT_HOLDS(done.err, "warning: 1 of " + std::to_string(count) + " points of measure");
  const Json report = Json::parse(read_text(folder / "out.json"));
  EXPECT_HOLDS(report["warnings"].dump(), "points of measure are out of tolerance");
  for (const Json& point : report["points"]) {
    EXPECT_EQ(point["result"], point["name"] == "half hem" ? "too small" : "in tolerance") << point;
  }
}

TEST(MeasurePattern, BadSpecsLeaveNoFile) {
  const ScratchFolder folder;
  write_text(folder / "spec.csv", "name,spec_cm,measured\nmine,5,along nowhere.0\n");
  const auto done =
      run("measure-pattern", {shirt(), "-o", folder / "out.csv", "--pom", folder / "spec.csv"});
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_HOLDS(done.err, "there is no panel 'nowhere'");
  EXPECT_FALSE(std::filesystem::exists(folder / "out.csv"));
  EXPECT_EQ(run("measure-pattern", {shirt(), "-o", folder / "out.csv", "--size", "M"}).exit_code,
            2);
}

}  // namespace measure_pattern_test
}  // namespace toile
