#include "cloth/judge/tight_seams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "cloth/judge/constants.h"
#include "cloth/model/compile.h"
#include "cloth/scene/constants.h"
#include "tests/cloth/panels.h"

namespace toile {
namespace {

using test::grid;
using test::side;

constexpr int columns = 4;
constexpr double height = 0.3;  // metres, of the seams
constexpr int rows = 30;        // of 1 cm

/// Flat panels side by side along x, from the first one's left side at x = 0. Each is sewn to the
/// next one.
struct Strip {
  std::vector<double> widths;   ///< metres, per panel
  std::vector<double> strains;  ///< along x, per panel
  double stiffness = 20000;     ///< N/m of weft and warp
  std::optional<double> strain_limit;

  PanelMesh garment() const {
    PanelMesh garment;
    double left = 0;
    for (std::size_t p = 0; p < widths.size(); ++p) {
      const double stretched = 1 + strains[p];
      test::add_panel(garment, std::string(1, static_cast<char>('a' + p)),
                      grid(widths[p], height, columns, rows), [&](const Vec2& flat) {
                        return Vec3(left + stretched * flat.x(), flat.y(), 0);
                      });
      left += stretched * widths[p];
    }
    for (std::size_t p = 0; p + 1 < widths.size(); ++p) {
      garment.seams.push_back(test::seam(garment.panels[p].name + garment.panels[p + 1].name,
                                         side(garment.panels[p], columns, rows, true),
                                         side(garment.panels[p + 1], columns, rows, false)));
    }
    return garment;
  }

  Scene scene() const {
    Scene scene;
    scene.fabric.stretch_weft = scene.fabric.stretch_warp = stiffness;
    scene.strain_limit = strain_limit;
    return scene;
  }

  std::vector<TightSeam> tight(const std::vector<LimitMultiplier>& multipliers = {}) const {
    const PanelMesh mesh = garment();
    const GarmentModel model = compile(mesh, scene(), mesh.placed);
    return tight_seams(mesh, model, model.start, multipliers);
  }
};

/// Two panels of these widths, strained alike.
Strip pair(double stiffness, double strain, double width_a = 0.5, double width_b = 0.3) {
  return {{width_a, width_b}, {strain, strain}, stiffness, {}};
}

TEST(TightSeams, TensionIsStiffnessTimesStrainAndHalfOfBothPanelsIsMissing) {
  const std::vector<TightSeam> tight = pair(10000, 0.04).tight();
  ASSERT_EQ(tight.size(), 1U);
  EXPECT_EQ(tight[0].name, "ab");
  EXPECT_NEAR(tight[0].tension, 400, 1e-6);
  EXPECT_NEAR(tight[0].missing, 0.5 * 0.04 * (0.5 + 0.3), 1e-10);
}

TEST(TightSeams, BelowAHandsPullThereAreNone) {
  static_assert(hand_pull == 300);
  EXPECT_TRUE(pair(10000, 0.0299, 1, 1).tight().empty());
  EXPECT_EQ(pair(10000, 0.0301, 1, 1).tight().size(), 1U);
}

TEST(TightSeams, SlackAndPushedClothIsNotTight) {
  EXPECT_TRUE(pair(10000, 0).tight().empty());
  EXPECT_TRUE(pair(10000, -0.1, 1, 1).tight().empty());
}

TEST(TightSeams, SoftFabricIsTightFromTheLargestWornStrainOn) {
  static_assert(max_worn_strain == 0.25);
  EXPECT_TRUE(pair(100, 0.249).tight().empty());
  const std::vector<TightSeam> tight = pair(100, 0.251).tight();
  ASSERT_EQ(tight.size(), 1U);
  EXPECT_NEAR(tight[0].tension, 25.1, 1e-8);
}

TEST(TightSeams, LessThanTheFleshGivesIsNotMissing) {
  static_assert(flesh_give == 0.01);
  // 400 N/m; half of 2 % of both widths is 9.8 mm, then 10.2 mm.
  EXPECT_TRUE(pair(20000, 0.02, 0.49, 0.49).tight().empty());
  const std::vector<TightSeam> tight = pair(20000, 0.02, 0.51, 0.51).tight();
  ASSERT_EQ(tight.size(), 1U);
  EXPECT_NEAR(tight[0].missing, 0.0102, 1e-10);
}

TEST(TightSeams, APanelsStretchIsSharedByTheSeamsAtItsEnds) {
  // Only the middle panel is stretched, and pulls at both seams from one side.
  const Strip strip{{0.4, 0.6, 0.4}, {0, 0.05, 0}, 20000, {}};
  const std::vector<TightSeam> tight = strip.tight();
  ASSERT_EQ(tight.size(), 2U);
  for (const TightSeam& seam : tight) {
    EXPECT_NEAR(seam.tension, 0.5 * 20000 * 0.05, 1e-6);
    EXPECT_NEAR(seam.missing, 0.5 * 0.05 * 0.6, 1e-10);
  }
}

TEST(TightSeams, AllSeamsAroundATubeLackWhatTheTubeLacks) {
  // A prism of three panels, stretched by 5 % all around.
  constexpr double width = 0.3, strain = 0.05;
  constexpr double length = width * (1 + strain);
  PanelMesh garment;
  for (int p = 0; p < 3; ++p) {
    const double angle = 2 * std::numbers::pi / 3 * p;
    const Vec3 along(std::cos(angle), 0, std::sin(angle));
    const Vec3 middle = length / (2 * std::sqrt(3.0)) * Vec3(std::sin(angle), 0, -std::cos(angle));
    test::add_panel(garment, std::string(1, static_cast<char>('a' + p)),
                    grid(width, height, columns, rows), [&](const Vec2& flat) {
                      return Vec3(middle + (1 + strain) * (flat.x() - width / 2) * along +
                                  flat.y() * Vec3::UnitY());
                    });
  }
  for (int p = 0; p < 3; ++p) {
    garment.seams.push_back(test::seam(std::to_string(p),
                                       side(garment.panels[p], columns, rows, true),
                                       side(garment.panels[(p + 1) % 3], columns, rows, false)));
  }
  Scene scene;
  scene.fabric.stretch_weft = scene.fabric.stretch_warp = 10000;
  const GarmentModel model = compile(garment, scene, garment.placed);
  double missing = 0;
  const std::vector<TightSeam> tight = tight_seams(garment, model, model.start);
  ASSERT_EQ(tight.size(), 3U);
  for (const TightSeam& seam : tight) {
    EXPECT_NEAR(seam.tension, 10000 * strain, 1e-6);
    missing += seam.missing;
  }
  EXPECT_NEAR(missing, 3 * width * strain, 1e-10);
}

/// 400 N/m by multipliers on the triangles beside the seam's first `pulled` edges of 1 cm, in
/// addition to the cloth's own 20 N/m.
std::vector<TightSeam> partly_pulled(int pulled) {
  const Strip strip{{1, 1}, {0.02, 0.02}, 1000, 0.02};
  const PanelMesh garment = strip.garment();
  std::vector<LimitMultiplier> multipliers(garment.triangles.size());
  for (int row = 0; row < pulled; ++row) {
    multipliers[garment.panels[0].first_triangle + 2 * (row * columns + columns - 1)].weft = 400;
    multipliers[garment.panels[1].first_triangle + 2 * row * columns + 1].weft = 400;
  }
  return strip.tight(multipliers);
}

TEST(TightSeams, TensionIsAMeanOverAHandsBreadth) {
  static_assert(hand_breadth == 0.1);
  // The bound is 250 N/m, the tension of a strain of 25 %: 5 cm of 420 N/m do not reach it.
  EXPECT_TRUE(partly_pulled(5).empty());
  const std::vector<TightSeam> tight = partly_pulled(8);
  ASSERT_EQ(tight.size(), 1U);
  EXPECT_NEAR(tight[0].tension, 20 + 0.8 * 400, 1e-6);
  EXPECT_NEAR(tight[0].missing, 0.02, 1e-10);
}

}  // namespace
}  // namespace toile
