#include "geometry/body/mannequin/mannequin.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>

#include "geometry/error.h"
#include "geometry/intersections.h"
#include "geometry/slice.h"
#include "geometry/surface_distance.h"

namespace toile {
namespace mannequin_test {

const Mannequin& mannequin() {
  static const Mannequin made = make_mannequin({.edge_length = 0.012});
  return made;
}

/// The girth of the largest horizontal section at `height`: of the torso or of one leg.
double tape_at(double height) {
  return slice(mannequin().surface, Vec3(0, height, 0), Vec3::UnitY()).front().girth;
}

// Zhong & Xu 2009, Fig. 12, in centimetres. Measured here from the mesh alone.
TEST(Mannequin, HasTheMeasuresOfThePaper) {
  EXPECT_NEAR(100 * tape_at(1.230), 93.64, 0.5) << "bust";
  EXPECT_NEAR(100 * tape_at(1.050), 70.66, 0.5) << "waist";
  EXPECT_NEAR(100 * tape_at(0.950), 85.97, 0.5) << "abdomen";
  EXPECT_NEAR(100 * tape_at(0.860), 98.00, 0.5) << "hip";
  EXPECT_NEAR(100 * tape_at(0.735), 55.77, 0.5) << "upper thigh";
  EXPECT_NEAR(100 * tape_at(0.620), 47.91, 0.5) << "mid-thigh";
  EXPECT_NEAR(100 * tape_at(0.460), 35.31, 0.5) << "knee";
}

// The waist is where the trunk is narrowest, the hip where it is widest.
TEST(Mannequin, MeasuresAreTakenWhereTheBodyHasThem) {
  double narrowest = 1;
  double widest = 0;
  for (double y = 0.80; y < 1.20; y += 0.01) {
    narrowest = std::min(narrowest, tape_at(y));
    widest = std::max(widest, tape_at(y));
  }
  EXPECT_NEAR(100 * narrowest, 70.66, 1.0);
  EXPECT_NEAR(100 * widest, 98.00, 1.5);
}

TEST(Mannequin, ReportsWhatItMeasured) {
  std::map<std::string, double> measured;
  for (const MannequinGirth& girth : mannequin().girths) {
    EXPECT_NEAR(girth.measured, girth.target, 0.003) << girth.name;
    measured[girth.name] = girth.measured;
  }
  EXPECT_EQ(measured.size(), 13u);
  EXPECT_NEAR(measured.at("bust"), tape_at(1.230), 1e-9);
  EXPECT_GT(measured.at("upper arm"), measured.at("elbow"));
  EXPECT_GT(measured.at("elbow"), measured.at("wrist"));
  EXPECT_GT(measured.at("calf"), measured.at("ankle"));
}

TEST(Mannequin, StandsOnTheFloorAndIsOfAWomansHeight) {
  Vec3 low = Vec3::Constant(9);
  Vec3 high = -low;
  for (const Vec3& p : mannequin().surface.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  EXPECT_EQ(low.y(), 0);
  EXPECT_NEAR(high.y(), 1.70, 0.01);
  EXPECT_NEAR(high.x(), -low.x(), 0.001);
  EXPECT_GT(high.z(), -low.z()) << "toes and bust are in front";
}

// find_skeleton() uses these sections of a standing body.
TEST(Mannequin, HasLimbsThatSectionsTellApart) {
  const auto sections = [](double y) {
    return slice(mannequin().surface, Vec3(0, y, 0), Vec3::UnitY()).size();
  };
  EXPECT_EQ(sections(0.30), 2u) << "calves";
  EXPECT_EQ(sections(0.735), 2u) << "thighs";
  EXPECT_EQ(sections(0.82), 1u) << "hips, below the hands";
  EXPECT_EQ(sections(1.05), 3u) << "waist and arms";
  EXPECT_EQ(sections(1.23), 3u) << "bust and arms";
  EXPECT_EQ(sections(1.36), 1u) << "shoulders";
  EXPECT_EQ(sections(1.60), 1u) << "head";
}

TEST(Mannequin, IsOneClosedManifoldWithoutHandles) {
  const TriangleMesh& surface = mannequin().surface;
  std::map<std::array<int, 2>, int> blocks;
  std::set<int> used;
  double volume = 0;
  for (const Triangle& t : surface.triangles) {
    for (int i = 0; i < 3; ++i) {
      ++blocks[{t[i], t[(i + 1) % 3]}];
      used.insert(t[i]);
    }
    volume += surface.points[t[0]].dot(surface.points[t[1]].cross(surface.points[t[2]])) / 6;
  }
  for (const auto& [edge, count] : blocks) {
    ASSERT_EQ(count, 1);
    ASSERT_EQ(blocks.count({edge[1], edge[0]}), 1u);
  }
  EXPECT_EQ(used.size(), surface.points.size());
  const auto vertices = static_cast<long>(used.size());
  const auto edges = static_cast<long>(blocks.size() / 2);
  const auto faces = static_cast<long>(surface.triangles.size());
  EXPECT_EQ(vertices - edges + faces, 2) << "one sphere";
  // The volume is positive, and about that of a woman of 1.70 m.
  EXPECT_GT(volume, 0.050);
  EXPECT_LT(volume, 0.070);
}

TEST(Mannequin, DoesNotIntersectItself) {
  EXPECT_TRUE(self_intersections(mannequin().surface).empty());
}

TEST(Mannequin, IsSymmetric) {
  const SurfaceDistance body(mannequin().surface);
  double worst = 0;
  for (const Vec3& p : mannequin().surface.points) {
    worst = std::max(worst, std::abs(body.closest_point(Vec3(-p.x(), p.y(), p.z())).distance));
  }
  EXPECT_LT(worst, 0.001);
}

TEST(Mannequin, IsTheSameEveryTime) {
  const Mannequin coarse = make_mannequin({.edge_length = 0.015});
  const Mannequin again = make_mannequin({.edge_length = 0.015});
  EXPECT_TRUE(coarse.surface.points == again.surface.points);
  EXPECT_TRUE(coarse.surface.triangles == again.surface.triangles);
}

TEST(Mannequin, RefusesEdgeLengthsItCantMesh) {
  EXPECT_THROW(make_mannequin({.edge_length = 0}), Error);
  EXPECT_THROW(make_mannequin({.edge_length = 0.5}), Error);
}

}  // namespace mannequin_test
}  // namespace toile
