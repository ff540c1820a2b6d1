// Garments with a known fault are told right: the place, the sign, the centimetres within the bar.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "tests/support/worn_sample.h"

namespace toile::pipeline {
namespace fit_faults_test {

using Json = nlohmann::json;

class FitFaults : public testing::Test {
 protected:
  /// The ease map's report of a sample whose corners were moved, in centimetres.
  Json ease(const std::string& sample,
            const std::function<void(const std::string& panel, double& x, double& y)>& move) {
    Json pattern =
        Json::parse(read_text(fs::path(TOILE_SOURCE_DIR) / "samples" / (sample + ".json")));
    for (auto& [name, panel] : pattern["pattern"]["panels"].items()) {
      for (Json& corner : panel["vertices"]) {
        double x = corner[0];
        double y = corner[1];
        move(name, x, y);
        corner = {x, y};
      }
    }
    write_text(folder / "p.json", pattern.dump());
    EXPECT_EQ(run("mesh-pattern",
                  {folder / "p.json", "-o", folder / "g.obj", "--edge-length", "15mm", "-q"})
                  .exit_code,
              0);
    EXPECT_EQ(run("dress", {"--body", clean_mannequin(), folder / "g.obj", "-o", folder / "d.obj",
                            "--report", folder / "d.json", "-q"})
                  .exit_code,
              0);
    return ease_map({});
  }

  /// The same drape's, with more options.
  Json ease_map(const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"--body",   clean_mannequin(), folder / "d.obj",
                                          "--report", folder / "e.json", "-q"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    EXPECT_EQ(run("ease-map", arguments).exit_code, 0);
    return Json::parse(read_text(folder / "e.json"));
  }

  static const Json& named(const Json& rows, const std::string& key, const std::string& name) {
    for (const Json& row : rows) {
      if (row.value(key, "") == name) return row;
    }
    ADD_FAILURE() << "no " << name << " in " << rows;
    static const Json none;
    return none;
  }

  ScratchFolder folder;
};

bool is_sleeve(const std::string& panel) { return panel.find("sleeve") != std::string::npos; }

TEST_F(FitFaults, AHemThatIsTooSmallRidesUpAndIsToldWhereItWasDraftedToLie) {
  const Json report = ease("tshirt", [](const std::string& panel, double& x, double& y) {
    if (!is_sleeve(panel) && y == 0 && x != 0) x -= std::copysign(3.5, x);
  });
  const Json& hem = named(report["garment_levels"], "name", "hem");
  // The hem is cut 92.0, the hip has 97.9 where the sample's hem lies, 86.7 cm above the floor.
  EXPECT_NEAR(hem["as_cut_cm"], 92.0, 0.05);
  EXPECT_NEAR(hem["drafted_ease_cm"], -5.9, 0.4);
  EXPECT_NEAR(hem["drafted_height_cm"], 86.7, 1.6);
  EXPECT_GT(hem["risen_cm"], 2.5);
  EXPECT_EQ(report["fit"]["verdict"], "too_small");
  const Json& level = named(report["fit"]["levels"], "name", "hem");
  EXPECT_EQ(level["panels"], Json({"left_back", "left_front", "right_back", "right_front"}));
  EXPECT_NE(report["findings"].at(0).get<std::string>().find("at the hem"), std::string::npos)
      << report["findings"];
}

TEST_F(FitFaults, ASleeveThatIsShorterEndsFartherAboveTheElbow) {
  const Json whole = ease("tshirt", [](const std::string&, double&, double&) {});
  const Json shorter = ease("tshirt", [](const std::string& panel, double& x, double&) {
    if (is_sleeve(panel) && std::abs(x) > 21) x -= std::copysign(3.0, x);
  });
  EXPECT_TRUE(whole["findings"].empty()) << whole["findings"];
  for (const std::string side : {"left", "right"}) {
    const Json& before = named(whole["lengths"], "name", side + " sleeve");
    const Json& after = named(shorter["lengths"], "name", side + " sleeve");
    EXPECT_NEAR(before["as_cut_cm"].get<double>() - after["as_cut_cm"].get<double>(), 3.0, 0.3);
    EXPECT_NEAR(
        before["ends"][0]["beyond_cm"].get<double>() - after["ends"][0]["beyond_cm"].get<double>(),
        3.0, 0.8);
  }
}

TEST_F(FitFaults, ASleeveThatIsShorterThanTheOtherIsTold) {
  const Json report = ease("tshirt", [](const std::string& panel, double& x, double&) {
    if (is_sleeve(panel) && panel.starts_with("left") && std::abs(x) > 21) {
      x -= std::copysign(3.0, x);
    }
  });
  // 3 cm are cut off one sleeve, whose cuff tapers on as before.
  const auto is_told = [](const Json& line) {
    const std::string text = line;
    return text.starts_with("the left sleeve is cut 3.") ||
           text.starts_with("the left sleeve ends ");
  };
  EXPECT_EQ(std::ranges::count_if(report["findings"], is_told), 1) << report["findings"];
}

TEST_F(FitFaults, ATopEdgeThatIsTooWideSlidesDown) {
  const Json whole = ease("trousers", [](const std::string&, double&, double&) {});
  const Json wide = ease("trousers", [](const std::string&, double& x, double& y) {
    if (y > 100 && std::abs(x) > 20) x += std::copysign(1.0, x);
  });
  const Json& before = named(whole["garment_levels"], "name", "top edge");
  const Json& after = named(wide["garment_levels"], "name", "top edge");
  EXPECT_NEAR(after["drafted_ease_cm"].get<double>() - before["drafted_ease_cm"].get<double>(), 4,
              1.0);
  EXPECT_LT(after["risen_cm"].get<double>(), before["risen_cm"].get<double>() - 1);

  // Too wide it is only against what is meant, and only where nothing is too tight.
  EXPECT_EQ(wide["fit"]["verdict"], "ok");
  const auto against = [&](const std::string& ease_cm) {
    write_text(folder / "t.json", R"({"name": "own", "ease_cm": )" + ease_cm + "}");
    return ease_map({"--target", folder / "t.json"});
  };
  const Json meant = against(R"({"top edge": [0, 1]})");
  EXPECT_EQ(meant["fit"]["verdict"], "too_wide");
  const Json& edge = named(meant["target"]["levels"], "level", "top edge");
  EXPECT_EQ(edge["is"], "too wide");
  EXPECT_EQ(edge["panels"], Json({"left_back", "left_front", "right_back", "right_front"}));
  EXPECT_EQ(against(R"({"top edge": [0, 1], "hip": [20, 30]})")["fit"]["verdict"], "ok");
  EXPECT_EQ(against(R"({"top edge": [0, 30]})")["fit"]["verdict"], "ok");
}

TEST_F(FitFaults, ANecklineThatGapes) {
  // 5 cm too much at the top of each front, in the middle.
  const Json report = ease("tshirt", [](const std::string& panel, double& x, double& y) {
    if (panel.ends_with("_front") && std::abs(x) < 0.001 && y > 56) {
      x = panel == "left_front" ? -5 : 5;
    }
  });
  EXPECT_GT(named(report["garment_levels"], "name", "neckline")["largest_gap_cm"], 3);
  bool is_told = false;
  for (const Json& finding : report["findings"]) {
    is_told = is_told || finding.get<std::string>().starts_with("the neckline gapes: it stands ");
  }
  EXPECT_TRUE(is_told) << report["findings"];
}

TEST_F(FitFaults, SleevesThatAreTooNarrow) {
  const Json report = ease("tshirt", [](const std::string& panel, double&, double& y) {
    if (is_sleeve(panel) && y < 0) y *= 0.62;
  });
  // Four panels of 20 cm and less lose 38 %: of 40.1 cm around the upper arm 25 are left for 30.2.
  for (const std::string side : {"left", "right"}) {
    const Json& arm = named(report["girths"], "level", side + " upper arm");
    EXPECT_NEAR(arm["as_cut_ease_cm"], -5.2, 0.4);
    EXPECT_NEAR(arm["ease_cm"], 0.3, 0.6);  // stretched, it touches
  }
}

}  // namespace fit_faults_test
}  // namespace toile::pipeline
