#include "geometry/scan/reconstruct_scan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/body/find_skeleton.h"
#include "geometry/body/mannequin/mannequin.h"
#include "geometry/error.h"
#include "tests/support/scanner.h"
#include "tests/support/shapes.h"

namespace toile {
namespace reconstruct_scan_test {

/// The mannequin and a scan of it, made once.
class ReconstructScan : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    body = new TriangleMesh(make_mannequin({.edge_length = 0.012}).surface);
    scan = new test::Scan(test::scan_body(*body, {.points = points}));
    made = new ReconstructedScan(reconstruct_scan(scan->cloud, "scan"));
  }
  static void TearDownTestSuite() {
    delete body;
    delete scan;
    delete made;
  }

  static std::string error_of(const PointCloud& cloud, const ScanOptions& options = {}) {
    try {
      reconstruct_scan(cloud, "scan.ply", options);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }

  static constexpr int points = 40000;
  /// Of tests that don't ask how true the surface is: a third of the time.
  static constexpr ScanOptions coarse = {.edge_length = 0.02};
  static TriangleMesh* body;
  static test::Scan* scan;
  static ReconstructedScan* made;
};

TriangleMesh* ReconstructScan::body = nullptr;
test::Scan* ReconstructScan::scan = nullptr;
ReconstructedScan* ReconstructScan::made = nullptr;

TEST_F(ReconstructScan, IsTrueToTheBodyThatWasScanned) {
  EXPECT_TRUE(test::is_closed(made->mesh));
  const test::Agreement found = test::agreement(made->mesh, *body, *scan, 0.015, 10000);
  EXPECT_GT(found.seen_2mm, 0.95);
  EXPECT_GT(found.seen_5mm, 0.995);
  EXPECT_GT(found.unseen, 0.01);
  // The rest are the ends of the armpits.
  EXPECT_GT(found.unseen_10mm, 0.9);

  const double crotch = find_skeleton(*body, "body").joint("pelvis").y();
  EXPECT_NEAR(find_skeleton(made->mesh, "scan").joint("pelvis").y(), crotch, 0.012);

  const ScanReport& report = made->report;
  EXPECT_EQ(report.points_read, points);
  EXPECT_EQ(report.kept + report.outliers + report.floor + report.stray, report.points_read);
  const auto of_body = static_cast<double>(scan->truth.size());
  EXPECT_NEAR(report.kept, of_body, 0.02 * of_body);
  EXPECT_GT(report.outliers + report.stray, 0.7 * 0.01 * points);
  EXPECT_TRUE(report.floor_found);
  EXPECT_EQ(report.up.name(), "y");
  EXPECT_EQ(report.metres_per_unit, 1);
  EXPECT_NEAR(report.noise, 0.001, 0.0005);
  // Range noise is along the ray, so less of it is along the normal.
  EXPECT_LT(report.error_rms, 0.002);  // with some outliers near the skin
  EXPECT_LT(report.error_95, 0.002);
}

TEST_F(ReconstructScan, ListsWhatNoCameraSaw) {
  const ScanReport& report = made->report;
  const Landmarks marks = given_landmarks(find_landmarks(*body, "body"));
  for (const char* name : {"left_armpit", "right_armpit", "crotch", "crown"}) {
    const auto listed =
        std::any_of(report.holes.begin(), report.holes.end(), [&](const ScanHole& hole) {
          return (hole.centre - *place_of(marks, name)).norm() < 0.06 && hole.area < 0.02;
        });
    EXPECT_TRUE(listed) << name;
  }
  // Both soles.
  const auto soles = std::count_if(report.holes.begin(), report.holes.end(), [](const auto& hole) {
    return hole.centre.y() < 0.02 && hole.area > 0.005;
  });
  EXPECT_EQ(soles, 2);
}

TEST_F(ReconstructScan, OtherUnitsAndAxesAreFoundByTheFloor) {
  PointCloud turned;
  for (const Vec3& p : scan->cloud.points)
    turned.points.push_back(1000 * Vec3(p.z(), p.x(), p.y()));
  const ReconstructedScan other = reconstruct_scan(turned, "scan", coarse);
  EXPECT_EQ(other.report.up.name(), "z");
  EXPECT_EQ(other.report.metres_per_unit, 0.001);
  EXPECT_TRUE(other.report.unit_inferred);
  turned.points.clear();
  for (const Vec3& p : scan->cloud.points) turned.points.push_back(Vec3(p.x(), -p.y(), -p.z()));
  EXPECT_EQ(sort_scan(turned.points, {}).up.name(), "-y");
}

TEST_F(ReconstructScan, GivenNormalsAreUsedWhicheverWayTheyPoint) {
  const SurfaceDistance surface(*body);
  PointCloud cloud;
  for (const Vec3& p : scan->truth) {
    cloud.points.push_back(p);
    cloud.normals.push_back(-surface.closest_point(p).normal);
  }
  const ReconstructedScan other = reconstruct_scan(cloud, "scan", coarse);
  EXPECT_TRUE(other.report.normals_given);
  EXPECT_FALSE(other.report.floor_found);
  EXPECT_NEAR(test::volume(other.mesh), test::volume(*body), 0.02 * test::volume(*body));
}

TEST_F(ReconstructScan, OtherThingsInTheScanAreDropped) {
  PointCloud cloud = scan->cloud;
  for (const Vec3& p : test::spread_points(test::sphere(0.15, 3), 3000)) {
    cloud.points.push_back(p + Vec3(0.9, 1.0, 0.3));
  }
  const ScanParts parts = sort_scan(cloud.points, {});
  EXPECT_EQ(parts.part.size(), cloud.points.size());
  EXPECT_EQ(std::count(parts.part.end() - 3000, parts.part.end(), ScanPart::stray), 3000);
  EXPECT_LT(std::count(parts.part.begin(), parts.part.end(), ScanPart::stray), 3100);
}

TEST_F(ReconstructScan, WhatIsLeftOutAtTheBodyIsCounted) {
  EXPECT_LT(made->report.off_surface, 0.002);
  // Something round that is carried before the chest, a centimetre away.
  double chest = 0;
  for (const Vec3& p : body->points) {
    if (std::abs(p.y() - 1.2) < 0.1 && std::abs(p.x()) < 0.1) chest = std::max(chest, p.z());
  }
  PointCloud cloud = scan->cloud;
  for (const Vec3& p : test::spread_points(test::sphere(0.1, 3), 3000)) {
    cloud.points.push_back(p + Vec3(0, 1.2, chest + 0.11));
  }
  const ScanReport report = reconstruct_scan(cloud, "carried", coarse).report;
  EXPECT_GT(report.off_surface, 0.03);
}

TEST_F(ReconstructScan, AFlatSideIsNoFloor) {
  const ScanParts slab =
      sort_scan(test::spread_points(test::box({-0.15, 0, -0.12}, {0.15, 1.7, 0.12}), 20000), {});
  EXPECT_FALSE(slab.floor_found);
  EXPECT_EQ(slab.up.name(), "y");
  EXPECT_NEAR(slab.height, 1.7, 0.01);
}

TEST_F(ReconstructScan, WhatLiesOnAFloorStandsAlongItsLength) {
  // The floor reaches beyond what lies on it, along z.
  std::vector<Vec3> both =
      test::spread_points(test::box({-0.2, 0.1, -0.85}, {0.2, 0.3, 0.85}), 20000);
  for (const Vec3& p : test::spread_points(test::box({-0.5, 0, -1.1}, {0.5, 0.001, 1.1}), 20000)) {
    both.push_back(p);
  }
  const ScanParts parts = sort_scan(both, {});
  EXPECT_FALSE(parts.floor_found);
  EXPECT_EQ(parts.up.axis, 2);
  EXPECT_NEAR(
      static_cast<double>(std::count(parts.part.begin(), parts.part.end(), ScanPart::floor)), 20000,
      100);
}

TEST_F(ReconstructScan, SheetsAndFilledSpacesAreNoBodies) {
  PointCloud sheet;
  for (int i = 0; i < 100; ++i) {
    for (int j = 0; j < 100; ++j) sheet.points.emplace_back(0.01 * i, 0.017 * j, 0.0001 * (i % 3));
  }
  EXPECT_NE(error_of(sheet).find("is a flat sheet"), std::string::npos) << error_of(sheet);
  PointCloud block;
  for (int i = 0; i < 30; ++i) {
    for (int j = 0; j < 100; ++j) {
      for (int k = 0; k < 18; ++k) block.points.emplace_back(0.017 * i, 0.017 * j, 0.017 * k);
    }
  }
  EXPECT_NE(error_of(block).find("fill a space"), std::string::npos) << error_of(block);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> within(0, 1.7);
  PointCloud cube;
  for (int i = 0; i < 60000; ++i) {
    const double x = within(random);
    const double y = within(random);
    cube.points.emplace_back(x, y, within(random));
  }
  EXPECT_NE(error_of(cube).find("fill a space"), std::string::npos) << error_of(cube);
}

TEST_F(ReconstructScan, WhatIsNoScanOfABodyIsAnError) {
  PointCloud few;
  few.points.assign(scan->cloud.points.begin(), scan->cloud.points.begin() + 900);
  EXPECT_NE(error_of(few).find("900 points"), std::string::npos) << error_of(few);
  PointCloud one;
  one.points.assign(5000, Vec3(0, 1, 0));
  EXPECT_NE(error_of(one).find("scan.ply: "), std::string::npos);
  PointCloud line;
  for (int i = 0; i < 5000; ++i) line.points.emplace_back(0, i * 1.7 / 5000, 0);
  EXPECT_NE(error_of(line), "no error");
  PointCloud front;
  for (const Vec3& p : scan->truth) {
    if (p.z() > 0.02) front.points.push_back(p);
  }
  EXPECT_NE(error_of(front, coarse).find("scan the body from all sides"), std::string::npos)
      << error_of(front);
}

}  // namespace reconstruct_scan_test
}  // namespace toile
