// A drape beside another, as ease-map shows it.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/worn_sample.h"

namespace toile::pipeline {
namespace against_test {

using nlohmann::json;

class Against : public WornSample {
 protected:
  /// The report of ease-map of NAME.obj.
  json ease_of(const std::string& name, const std::vector<std::string>& options = {}) const {
    std::vector<std::string> words = {"--body",
                                      body,
                                      folder / (name + ".obj"),
                                      "-o",
                                      folder / (name + ".html"),
                                      "--report",
                                      folder / (name + "-ease.json"),
                                      "-q"};
    words.insert(words.end(), options.begin(), options.end());
    succeed("ease-map", words);
    return report(name + "-ease");
  }
};

double girth_ease(const json& ease, const std::string& level) {
  for (const json& girth : ease["girths"]) {
    if (girth.value("level", "") == level) return girth["ease_cm"];
  }
  ADD_FAILURE() << "no girth at the " << level;
  return 0;
}

TEST_F(Against, DifferencesAreThoseOfTheReports) {
  make_body();
  mesh(sample("tshirt"), "25mm");
  EXPECT_EQ(dress("plain").exit_code, 0);
  // A tenth wider: a larger size of another shape.
  json pattern = json::parse(read_text(sample("tshirt")));
  for (auto& [name, panel] : pattern["pattern"]["panels"].items()) {
    for (json& vertex : panel["vertices"]) vertex[0] = 1.1 * vertex[0].get<double>();
  }
  write_text(folder / "wide.json", pattern.dump());
  mesh(folder / "wide.json", "25mm");
  EXPECT_EQ(dress("wide").exit_code, 0);

  const json plain = ease_of("plain");
  const json wide = ease_of("wide", {"--against", folder / "plain.obj"});
  int eases = 0;
  for (const json& row : wide["against"]["differences"]) {
    EXPECT_NEAR(row["difference_cm"], row["here_cm"].get<double>() - row["there_cm"].get<double>(),
                1e-3);
    EXPECT_EQ(row["is_sure"], std::abs(row["difference_cm"].get<double>()) >
                                  row["plus_minus_difference_cm"].get<double>());
    if (row["of"] != "ease") continue;
    ++eases;
    EXPECT_NEAR(row["here_cm"], girth_ease(wide, row["name"]), 1e-3);
    EXPECT_NEAR(row["there_cm"], girth_ease(plain, row["name"]), 1e-3);
  }
  EXPECT_GE(eases, 4);
  // The page has the maps, and the table's grey rows.
  const std::string page = read_text(folder / "wide.html");
  EXPECT_NE(page.find("\"tab\":\"Difference\""), std::string::npos);
  EXPECT_NE(page.find("<tr class=\"quiet\">"), std::string::npos);
}

TEST_F(Against, TheSameDrapeDiffersByNothing) {
  make_body();
  mesh(sample("tshirt"), "25mm");
  EXPECT_EQ(dress("plain").exit_code, 0);
  const json ease = ease_of("plain", {"--against", folder / "plain.obj"});
  for (const json& row : ease["against"]["differences"]) EXPECT_EQ(row["difference_cm"], 0);
}

TEST_F(Against, ADrapeWithoutReportIsRefused) {
  make_body();
  mesh(sample("tshirt"), "25mm");
  EXPECT_EQ(dress("plain").exit_code, 0);
  fs::copy_file(folder / "plain.obj", folder / "alone.obj");
  const pipeline::Run done =
      run("ease-map", {"--body", body, folder / "plain.obj", "-o", folder / "x.html", "--against",
                       folder / "alone.obj"});
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_NE(done.err.find("alone.json"), std::string::npos) << done.err;
  EXPECT_FALSE(fs::exists(folder / "x.html"));
}

}  // namespace against_test
}  // namespace toile::pipeline
