#include "cloth/dressing/outfit.h"

#include <gtest/gtest.h>

#include "geometry/error.h"
#include "geometry/intersections.h"
#include "tests/cloth/panels.h"
#include "tests/support/tubes.h"

namespace toile {
namespace outfit_test {

constexpr double radius = 0.1, height = 0.1;
constexpr int columns = 12, rows = 4;

/// A front and a back that are sewn at both sides, around a cylinder of 62.8 cm.
OutfitLayer tube(const std::string& name, double girth) {
  OutfitLayer layer;
  layer.name = name;
  for (const double z : {0.15, -0.15}) {
    test::add_panel(layer.garment, z > 0 ? "front" : "back",
                    test::grid(girth / 2, height, columns, rows), [&](const Vec2& p) {
                      return Vec3((p.x() - girth / 4) * (z > 0 ? 1 : -1), 0.2 + p.y(), z);
                    });
  }
  const auto side_of = [&](int panel, bool right) {
    return test::side(layer.garment.panels[panel], columns, rows, right);
  };
  layer.garment.seams = {test::seam("left", side_of(0, true), side_of(1, false)),
                         test::seam("right", side_of(0, false), side_of(1, true))};
  return layer;
}

/// Tubes that cling to a cylinder: what is a little short is held by friction.
class OutfitTest : public testing::Test {
 protected:
  WornOutfit dress(bool coupled = false) {
    DressOptions options;
    options.stop_median = options.stop_wide = 0.05;
    options.stop_rms = 0.5;
    outfit.method = relaxation_method(options, coupled);
    return dress_outfit(outfit, collider, nullptr, hooks);
  }

  Collider collider{test::closed_tube(radius, radius, 0.5, 40)};
  Outfit outfit{.layers = {tube("shirt", 0.635), tube("coat", 0.65)}};
  OutfitHooks hooks;
};

TEST_F(OutfitTest, ALayerIsDressedOverTheOneBelow) {
  const WornOutfit worn = dress();
  ASSERT_EQ(worn.layers.size(), 2U);
  EXPECT_EQ(worn.verdict(), Verdict::sewn);
  EXPECT_FALSE(worn.coupled);
  for (const WornLayer& layer : worn.layers) {
    EXPECT_EQ(layer.judgement.garment.seams.open, 0);
    EXPECT_EQ(layer.judgement.body_intersections, 0);
    EXPECT_EQ(layer.judgement.layer_intersections, 0);
    EXPECT_EQ(layer.scene.collider, nullptr);
  }
  for (const Vec3& p : worn.layers[1].result.nodes) {
    EXPECT_GT(std::hypot(p.x(), p.z()), radius);
  }
  EXPECT_TRUE(intersections(worn.layers[0].cloth, worn.layers[1].cloth).empty());
  // The body wears the shirt; nothing is to be dressed over the coat.
  EXPECT_EQ(collider.cloth().triangles.size(), worn.layers[0].cloth.triangles.size());
}

TEST_F(OutfitTest, NothingIsDressedOverALayerThatFailed) {
  std::vector<Warning> warnings;
  hooks.warn = [&](const Warning& warning) { warnings.push_back(warning); };
  // The file moves the shirt into the body.
  hooks.write = [](std::size_t, const DressedGarment& garment) {
    DressedGarment moved = garment;
    for (Vec3& p : moved.points) p.x() += 0.1;
    return moved;
  };
  const WornOutfit worn = dress();
  ASSERT_EQ(worn.layers.size(), 1U);
  EXPECT_EQ(worn.verdict(), Verdict::intersecting);
  ASSERT_FALSE(warnings.empty());
  EXPECT_EQ(warnings.back().code, "layers_not_dressed");
  EXPECT_EQ(warnings.back().place, "shirt");
  EXPECT_EQ(warnings.back().text,
            "layer shirt is intersecting: the layers over it are not dressed");
}

TEST_F(OutfitTest, ALayerThatIsTooTightIsDressedOver) {
  outfit.layers[0] = tube("shirt", 0.44);
  const WornOutfit worn = dress();
  ASSERT_EQ(worn.layers.size(), 2U);
  EXPECT_EQ(worn.layers[0].judgement.verdict, Verdict::too_tight);
  EXPECT_EQ(worn.verdict(), Verdict::too_tight);
}

// What is written is what others read, so it decides.
TEST_F(OutfitTest, TheGarmentIsJudgedAsItWasWritten) {
  hooks.write = [](std::size_t, const DressedGarment& garment) {
    DressedGarment written = garment;
    for (Vec3& p : written.points) p *= 0.98;
    return written;
  };
  const WornOutfit worn = dress();
  ASSERT_EQ(worn.layers.size(), 1U);
  EXPECT_EQ(worn.verdict(), Verdict::intersecting);
  EXPECT_GT(worn.layers[0].judgement.body_intersections, 0);
  EXPECT_EQ(worn.layers[0].cloth.points[0], Vec3(0.98 * worn.layers[0].result.nodes[0]));
}

TEST_F(OutfitTest, CoupledLayersMoveTogetherAndAreJudgedAgain) {
  outfit.certify = true;
  std::vector<std::string> events;
  hooks.begin = [&](std::size_t layer) { events.push_back("begin " + std::to_string(layer)); };
  hooks.dressed = [&](std::size_t layer, const WornLayer&) {
    events.push_back("dressed " + std::to_string(layer));
  };
  hooks.judged = [&](std::size_t layer, const WornLayer& worn) {
    events.push_back("judged " + std::to_string(layer) + " " + to_string(worn.judgement.verdict));
  };
  int frames = 0;
  hooks.watch = [&](std::size_t) { return [&](const DressFrame&) { ++frames; }; };
  const WornOutfit worn = dress(true);
  ASSERT_TRUE(worn.coupled);
  EXPECT_EQ(events, (std::vector<std::string>{"begin 0", "dressed 0", "judged 0 sewn", "begin 1",
                                              "dressed 1", "judged 1 sewn", "begin 2",
                                              "judged 0 sewn", "judged 1 sewn"}));
  ASSERT_TRUE(worn.coupled_certificate);
  std::size_t checked = worn.coupled_certificate->frames().size();
  for (const WornLayer& layer : worn.layers) checked += layer.certificate->frames().size();
  EXPECT_EQ(checked, static_cast<std::size_t>(frames));
  EXPECT_TRUE(worn.coupled_certificate->stayed_clean());
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(worn.layers[i].result.nodes, worn.coupled->nodes[i]);
  }
}

TEST_F(OutfitTest, PanelsOverAnotherThatAreMissingAreAnError) {
  outfit.layers[0].panels_over = {{"coat", {"lapel"}}};
  EXPECT_THROW(dress(true), Error);
}

}  // namespace outfit_test
}  // namespace toile
