#include "geometry/body/clean_body.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "geometry/body/mannequin/mannequin.h"
#include "geometry/error.h"
#include "tests/support/shapes.h"

namespace toile {
namespace clean_body_test {

PolygonSoup mannequin_soup() {
  static const PolygonSoup soup = [] {
    MannequinOptions options;
    options.edge_length = 0.015;
    return test::soup(make_mannequin(options).surface);
  }();
  return soup;
}

double lowest(const TriangleMesh& mesh) {
  double y = mesh.points.front().y();
  for (const Vec3& p : mesh.points) y = std::min(y, p.y());
  return y;
}

/// Farthest distance between joints of the same name.
double farthest(const Skeleton& a, const Skeleton& b) {
  double distance = 0;
  for (const auto& [name, joint] : a.joints) {
    distance = std::max(distance, (joint - b.joint(name)).norm());
  }
  return distance;
}

TEST(CleanBody, UnitIsToldFromTheHeight) {
  for (const double unit : {1.0, 0.1, 0.01, 0.001, 0.0254}) {
    PolygonSoup soup = mannequin_soup();
    for (Vec3& p : soup.points) p /= unit;
    const CleanBody body = clean_body(soup, "body");
    EXPECT_EQ(body.report.metres_per_unit, unit);
    EXPECT_TRUE(body.report.unit_inferred);
    EXPECT_NEAR(body.report.height, 1.70, 0.005);
    ASSERT_TRUE(body.skeleton);
    EXPECT_NEAR(body.skeleton->joint("head").y(), body.report.height, 1e-9);
  }
  PolygonSoup giant = mannequin_soup();
  for (Vec3& p : giant.points) p *= 3;
  EXPECT_THROW(clean_body(giant, "giant"), Error);
  CleanOptions stated;
  stated.metres_per_unit = 1;
  EXPECT_NEAR(clean_body(giant, "giant", stated).report.height, 5.1, 0.02);
  stated.metres_per_unit = 0.001;
  EXPECT_THROW(clean_body(giant, "speck", stated), Error);
}

TEST(CleanBody, TheHeightMayBeStatedWhereNoUnitFits) {
  PolygonSoup character = mannequin_soup();
  for (Vec3& p : character.points) p *= 3.1 / 1.7;
  CleanOptions options;
  options.height = 1.68;
  const CleanBody body = clean_body(character, "character", options);
  EXPECT_NEAR(body.report.height, 1.68, 1e-9);
  EXPECT_NEAR(body.report.metres_per_unit, 1.68 / 3.1, 0.002);
  EXPECT_FALSE(body.report.unit_inferred);
  // Joints beside it are in metres of the same height.
  options.skeleton = body.skeleton;
  EXPECT_EQ(clean_body(character, "character", options).report.skeleton_refused, "");
}

TEST(CleanBody, ASheetIsNoBody) {
  TriangleMesh sheet = test::box({-0.5, 0, -0.005}, {0.5, 1.7, 0.005});
  const Eigen::Matrix3d askew =
      Eigen::AngleAxisd(0.5, Vec3(1, 1, 0).normalized()).toRotationMatrix();
  for (const bool turned : {false, true}) {
    for (Vec3& p : sheet.points) p = turned ? Vec3(askew * p) : p;
    try {
      clean_body(test::soup(sheet), "sheet.obj");
      ADD_FAILURE() << "is taken";
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("sheet.obj: is a flat sheet"), std::string::npos)
          << error.what();
    }
  }
}

TEST(CleanBody, StandsOnTheFloorAndElsewhereStays) {
  PolygonSoup soup = mannequin_soup();
  for (Vec3& p : soup.points) p += Vec3(0.25, -0.8125, 0.5);
  const CleanBody body = clean_body(soup, "body");
  EXPECT_EQ(lowest(body.mesh), 0);
  EXPECT_NEAR(body.report.lifted, 0.8125, 1e-6);
  ASSERT_TRUE(body.skeleton);
  EXPECT_NEAR(body.skeleton->joint("pelvis").x(), 0.25, 0.003);
}

TEST(CleanBody, FromKilometresAwayItIsBroughtToTheOrigin) {
  const CleanBody here = clean_body(mannequin_soup(), "body");
  PolygonSoup soup = mannequin_soup();
  const Vec3 away(1e4, 1e4, -5e3);
  for (Vec3& p : soup.points) p += away;
  const CleanBody body = clean_body(soup, "body");
  EXPECT_NEAR((body.report.brought + Vec3(1e4, 0, -5e3)).norm(), 0, 0.5);
  ASSERT_EQ(body.mesh.points.size(), here.mesh.points.size());
  const Vec3 shift = body.mesh.points[0] - here.mesh.points[0];
  EXPECT_LT(shift.norm(), 0.5);
  for (std::size_t i = 0; i < here.mesh.points.size(); ++i) {
    ASSERT_LT((body.mesh.points[i] - here.mesh.points[i] - shift).norm(), 1e-9);
  }
  ASSERT_TRUE(body.skeleton && here.skeleton);
  for (const auto& [joint, point] : here.skeleton->joints) {
    EXPECT_LT((body.skeleton->joint(joint) - point - shift).norm(), 1e-6) << joint;
  }
  EXPECT_EQ(here.report.brought, Vec3(0, 0, 0));
}

TEST(CleanBody, IsTurnedByRightAnglesToStandFacingForward) {
  const CleanBody upright = clean_body(mannequin_soup(), "body");
  EXPECT_EQ(upright.report.turned, "");
  struct Turn {
    const char* says;
    Vec3 (*apply)(const Vec3&);
  };
  const std::vector<Turn> turns = {
      {"from z up to y up", [](const Vec3& p) { return Vec3(p.x(), -p.z(), p.y()); }},
      {"from z up to y up, and to face +z",
       [](const Vec3& p) { return Vec3(-p.x(), p.z(), p.y()); }},
      {"to face +z", [](const Vec3& p) { return Vec3(-p.x(), p.y(), -p.z()); }},
      {"to face +z", [](const Vec3& p) { return Vec3(p.z(), p.y(), -p.x()); }},
      {"to face +z", [](const Vec3& p) { return Vec3(-p.z(), p.y(), p.x()); }},
      {"from -y up to y up", [](const Vec3& p) { return Vec3(-p.x(), -p.y(), p.z()); }},
      {"from x up to y up", [](const Vec3& p) { return Vec3(p.y(), -p.x(), p.z()); }},
  };
  for (const Turn& turn : turns) {
    PolygonSoup soup = mannequin_soup();
    for (Vec3& p : soup.points) p = turn.apply(p);
    const CleanBody body = clean_body(soup, "body");
    EXPECT_EQ(body.report.turned, turn.says);
    ASSERT_TRUE(body.skeleton) << turn.says;
    EXPECT_LT(farthest(*body.skeleton, *upright.skeleton), 1e-6) << turn.says;
    EXPECT_NEAR(test::volume(body.mesh), test::volume(upright.mesh), 1e-9) << turn.says;
  }
}

PolygonSoup turned_soup(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  PolygonSoup soup = mannequin_soup();
  for (Vec3& p : soup.points) p = Eigen::AngleAxisd(angle, Vec3::UnitY()) * p;
  return soup;
}

TEST(CleanBody, IsTurnedAboutTheVerticalToFaceForward) {
  const CleanBody straight = clean_body(mannequin_soup(), "body");
  for (const double degrees : {30.0, -62.0, 100.0, -170.0, 12.0}) {
    const CleanBody body = clean_body(turned_soup(degrees), "body");
    ASSERT_TRUE(body.skeleton) << degrees;
    EXPECT_NEAR(body.report.turned_degrees, -degrees, 0.5);
    EXPECT_NE(body.report.turned.find("degrees about the vertical to face +z"), std::string::npos)
        << body.report.turned;
    EXPECT_LT(farthest(*body.skeleton, *straight.skeleton), 0.01) << degrees;
    EXPECT_GT(body.skeleton->joint("left_shoulder").x(), 0.1);
  }
  const CleanBody nearly = clean_body(turned_soup(5), "body");
  EXPECT_TRUE(nearly.skeleton);
  EXPECT_EQ(nearly.report.turned_degrees, 0);

  // z up, and turned about it.
  PolygonSoup lying = turned_soup(30);
  for (Vec3& p : lying.points) p = Vec3(p.x(), -p.z(), p.y());
  const CleanBody body = clean_body(lying, "body");
  ASSERT_TRUE(body.skeleton);
  EXPECT_LT(farthest(*body.skeleton, *straight.skeleton), 0.01);
  EXPECT_EQ(body.report.turned.substr(0, 22), "from z up to y up, and");
}

TEST(CleanBody, ALeaningScanIsTurnedUpright) {
  const CleanBody straight = clean_body(mannequin_soup(), "body");
  EXPECT_EQ(straight.report.levelled_degrees, 0);
  for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitX()), Vec3(Vec3::UnitZ())}) {
    for (const double degrees : {5.0, 15.0}) {
      PolygonSoup leaning = mannequin_soup();
      const Eigen::AngleAxisd lean(degrees * std::numbers::pi / 180, axis);
      for (Vec3& p : leaning.points) p = lean * p;
      const CleanBody body = clean_body(leaning, "body");
      ASSERT_TRUE(body.skeleton);
      EXPECT_NEAR(body.report.levelled_degrees, degrees, 2);
      // 1.5 degrees at the top of 1.70 m.
      EXPECT_LT(farthest(*body.skeleton, *straight.skeleton), 0.045) << degrees;
    }
  }
  PolygonSoup leaning = mannequin_soup();
  for (Vec3& p : leaning.points) p = Eigen::AngleAxisd(0.2, Vec3::UnitX()) * p;
  CleanOptions kept;
  kept.level = false;
  EXPECT_EQ(clean_body(leaning, "body", kept).report.levelled_degrees, 0);
}

TEST(CleanBody, APersonWhoLeansOnLevelSolesStays) {
  PolygonSoup leaning = mannequin_soup();
  for (Vec3& p : leaning.points) p.z() += 0.08 * std::max(0.0, p.y() - 0.1);
  const CleanBody body = clean_body(leaning, "body");
  ASSERT_TRUE(body.skeleton);
  EXPECT_EQ(body.report.levelled_degrees, 0);
}

TEST(CleanBody, SmallChildrenAndFormsHaveAUnitToo) {
  PolygonSoup child = mannequin_soup();
  for (Vec3& p : child.points) p *= 0.75 / 1.7;
  EXPECT_NEAR(clean_body(child, "child").report.height, 0.75, 0.005);
  // 63 cm tall and a third as deep: not a person of 63 inches.
  PolygonSoup form = test::soup(test::box({-20, 0, -12}, {20, 63, 12}));
  const CleanReport report = clean_body(form, "form").report;
  EXPECT_EQ(report.metres_per_unit, 0.01);
  EXPECT_NEAR(report.height, 0.63, 1e-9);
}

TEST(CleanBody, GivenJointsTurnABodyToo) {
  const CleanBody straight = clean_body(mannequin_soup(), "body");
  CleanOptions options;
  options.skeleton = straight.skeleton;
  const double angle = 30 * std::numbers::pi / 180;
  for (auto& [name, joint] : options.skeleton->joints) {
    joint = Eigen::AngleAxisd(angle, Vec3::UnitY()) * joint;
  }
  const CleanBody body = clean_body(turned_soup(30), "body", options);
  EXPECT_EQ(body.report.skeleton_refused, "");
  EXPECT_NEAR(body.report.turned_degrees, -30, 0.5);
  EXPECT_LT(farthest(*body.skeleton, *straight.skeleton), 0.01);
}

/// Farthest distance from the points of `body` to those of `soup`, in metres, moved as `cleaned`
/// says.
double off(const CleanBody& body, const PolygonSoup& soup, double metres) {
  const BodyMove& move = *body.skeleton->cleaned;
  EXPECT_EQ(body.mesh.points.size(), soup.points.size());
  double farthest = 0;
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    const Vec3 moved = move.rotation * (metres * soup.points[i]) + move.translation;
    farthest = std::max(farthest, (moved - body.mesh.points[i]).norm());
  }
  return farthest;
}

TEST(CleanBody, SaysHowItMovedTheBody) {
  PolygonSoup file = turned_soup(30);
  for (Vec3& p : file.points) p = 100 * Vec3(p.x() + 20, -p.z(), p.y() - 0.8);
  const CleanBody body = clean_body(file, "body");
  ASSERT_TRUE(body.skeleton && body.skeleton->cleaned);
  EXPECT_EQ(body.skeleton->cleaned->metres_per_unit, 0.01);
  EXPECT_LT(off(body, file, 0.01), 1e-9);

  // Cleaned again from elsewhere, with its joints: the move is still that from the first file.
  PolygonSoup again = test::soup(body.mesh);
  CleanOptions options;
  options.skeleton = body.skeleton;
  for (Vec3& p : again.points) p.y() -= 0.3;
  for (auto& [name, joint] : options.skeleton->joints) joint.y() -= 0.3;
  options.skeleton->cleaned->translation.y() -= 0.3;
  const CleanBody twice = clean_body(again, "body", options);
  EXPECT_EQ(twice.report.skeleton_refused, "");
  EXPECT_EQ(twice.skeleton->cleaned->metres_per_unit, 0.01);
  EXPECT_LT(off(twice, file, 0.01), 1e-9);
}

TEST(CleanBody, LargeHolesThatWereFilledAreNamedWithTheirPlace) {
  PolygonSoup back = mannequin_soup();
  for (Vec3& p : back.points) p = Vec3(100 * p.x(), -100 * p.z(), 100 * p.y());  // z up, cm
  std::erase_if(back.polygons, [&](const std::vector<int>& polygon) {
    const Vec3& p = back.points[polygon[0]];
    return p.y() > 5 && p.z() > 105 && p.z() < 128 && std::abs(p.x()) < 7;
  });
  const CleanBody body = clean_body(back, "body");
  ASSERT_EQ(body.report.large_holes.size(), 1u);
  const FilledHole& hole = body.report.large_holes[0];
  EXPECT_NEAR(hole.across, 0.28, 0.03);
  EXPECT_NEAR(hole.middle.y(), 1.165, 0.02);
  EXPECT_LT(hole.middle.z(), -0.05);
  ASSERT_TRUE(body.skeleton);
  EXPECT_EQ(part_near(*body.skeleton, hole.middle), BodyPart::torso);
}

TEST(CleanBody, MissingSolesAreFilledMissingTorsoIsNot) {
  PolygonSoup soles = mannequin_soup();
  std::erase_if(soles.polygons, [&](const std::vector<int>& polygon) {
    return std::all_of(polygon.begin(), polygon.end(),
                       [&](int corner) { return soles.points[corner].y() < 0.01; });
  });
  const CleanBody body = clean_body(soles, "body");
  EXPECT_EQ(body.report.repair.holes_filled.size(), 2u);
  EXPECT_TRUE(test::is_closed(body.mesh));
  EXPECT_NEAR(body.report.height, 1.70, 0.01);
  EXPECT_TRUE(body.skeleton);

  PolygonSoup back = mannequin_soup();
  std::erase_if(back.polygons, [&](const std::vector<int>& polygon) {
    const Vec3& p = back.points[polygon[0]];
    return p.z() < -0.05 && p.y() > 0.9 && p.y() < 1.4 && std::abs(p.x()) < 0.12;
  });
  EXPECT_THROW(clean_body(back, "body"), Error);
}

TEST(CleanBody, ABodyWithoutASkeletonIsStillClean) {
  const CleanBody cube = clean_body(test::soup(test::cube()), "cube.obj");
  EXPECT_FALSE(cube.skeleton);
  EXPECT_NE(cube.report.no_skeleton.find("cube.obj: no skeleton"), std::string::npos);
  EXPECT_EQ(cube.mesh.points.size(), 8u);
}

}  // namespace clean_body_test
}  // namespace toile
