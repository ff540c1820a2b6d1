#include "io/point_file.h"

#include <gtest/gtest.h>

#include <string>

#include "geometry/error.h"
#include "io/mesh_file.h"
#include "tests/support/run_program.h"

namespace toile {
namespace point_file_test {

std::string error_of(const std::string& text) {
  try {
    parse_points(text, "scan.pts");
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

bool begins(const std::string& text, const std::string& with) { return text.find(with) == 0; }

TEST(PointFile, TablesHaveAnySeparatorCommentsAndHeading) {
  for (const char* text :
       {"1 2 3\n4 5 6\n", "1,2,3\r\n4,5,6\r\n", "x;y;z\n1; 2; 3\n4; 5; 6", "2\n1 2 3\n4 5 6\n",
        "# a scan\n1 2 3 // first\n\n4\t5\t6\n", "1\n1 2 3\n1\n4 5 6\n",
        "1 2 3 255 0 0\n4 5 6 0 255 0\n", "1 2 3 0.5 10 20 30\n4 5 6 0.5 10 20 30\n"}) {
    const PointCloud cloud = parse_points(text, "scan");
    ASSERT_EQ(cloud.points.size(), 2u) << text;
    EXPECT_EQ(cloud.points[0], Vec3(1, 2, 3)) << text;
    EXPECT_EQ(cloud.points[1], Vec3(4, 5, 6)) << text;
    EXPECT_TRUE(cloud.normals.empty()) << text;
  }
}

TEST(PointFile, CommasAreDecimalWhereOtherGapsLeaveThreeNumbers) {
  for (const char* text :
       {"0,25 1,5 -0,5\n1 2,5 3e0\n", "x;y;z\n0,25;1,5;-0,5\r\n1;2,5;3\r\n",
        "2\n0,25\t1,5\t-0,5\t255\n1,0\t2,50\t3,0\t7\n", "0.25,1.5,-0.5\n1,2.5,3\n",
        "x,y,z\n0,25 1,5 -0,5\n1 2,5 3\n", "0.25 , 1.5 , -0.5\n1 ,2.5 ,3\n",
        "0,25, 1,5, -0,5\n1, 2,5, 3,0\n", "0,25,\t1,5,\t-0,5,\n1,\t2,5,\t3\n",
        "0.25, 1.5, -0.5,\n1, 2.5, 3\n", "0.25 1.5 -0.5 7,5\n1 2.5 3 7,5\n"}) {
    const PointCloud cloud = parse_points(text, "scan");
    ASSERT_EQ(cloud.points.size(), 2u) << text;
    EXPECT_EQ(cloud.points[0], Vec3(0.25, 1.5, -0.5)) << text;
    EXPECT_EQ(cloud.points[1], Vec3(1, 2.5, 3)) << text;
  }
  const PointCloud whole = parse_points("1 2 3\n1,5 2,5 3,5\n", "scan");
  EXPECT_EQ(whole.points[1], Vec3(1.5, 2.5, 3.5));
  const PointCloud normals = parse_points("1,5 2,5 3,5 0,6 0,8 0,0\n", "scan");
  ASSERT_EQ(normals.normals.size(), 1u);
  EXPECT_NEAR(normals.normals[0].y(), 0.8, 1e-15);
  EXPECT_TRUE(begins(error_of("1,5 2,5 3,5\n1,5 2,5\n"), "scan.pts:2: has 2 of the numbers"));
  EXPECT_TRUE(begins(error_of("1,5 2,5 3,5\n1,5 2,5,1 2\n"), "scan.pts:2: '2,5,1' is not a"));
}

TEST(PointFile, CommasThatPartDigitsAndColumnsAreNamed) {
  for (const char* text : {"0,25,1,5,-0,5\n0,0846,0,8215,0,1351\n", "-0,0846,0,8215,-0,1351\n"}) {
    EXPECT_TRUE(error_of(text).find("do commas part both digits and columns") != std::string::npos)
        << error_of(text);
  }
  // Zeros before a point or after the coordinates are no sign of it.
  EXPECT_EQ(parse_points("0.5,-0.25,0\n0,0,0,007\n", "scan").points.size(), 2u);
}

TEST(PointFile, ColumnsOfUnitLengthAreNormals) {
  const PointCloud fourth = parse_points("1 2 3 0 0 1\n4 5 6 0.6 0.8 0\n", "scan");
  ASSERT_EQ(fourth.normals.size(), 2u);
  EXPECT_EQ(fourth.normals[0], Vec3(0, 0, 1));
  EXPECT_NEAR(fourth.normals[1].x(), 0.6, 1e-15);
  const PointCloud seventh = parse_points("1 2 3 9 9 9 0 1 0\n4 5 6 8 8 8 1 0 0\n", "scan");
  ASSERT_EQ(seventh.normals.size(), 2u);
  EXPECT_EQ(seventh.normals[1], Vec3(1, 0, 0));
  EXPECT_TRUE(parse_points("1 2 3 0 0 1\n4 5 6 0 0 2\n", "scan").normals.empty());
}

TEST(PointFile, WrongTablesAreErrorsWithTheirLine) {
  EXPECT_TRUE(begins(error_of("1 2 3\n4 x 6\n"), "scan.pts:2: 'x' is not a number"));
  EXPECT_TRUE(begins(error_of("1 2 3\n4 5\n"), "scan.pts:2: has 2 of the numbers"));
  EXPECT_TRUE(begins(error_of("1 2 3\n\n4 5 nan\n"), "scan.pts:3: a coordinate is not"));
  EXPECT_TRUE(begins(error_of("1 2 3e9\n"), "scan.pts:1: a coordinate is 3e+09, beyond"));
  EXPECT_TRUE(begins(error_of("3\n1 2 3\n4 5 6\n"), "scan.pts:3: the file announces 3 points"));
  EXPECT_TRUE(begins(error_of("1\n1 2 3\n4 5 6\n2\n"), "scan.pts:4: the file announces 1 points"));
  EXPECT_EQ(error_of(""), "no error");
}

TEST(PointFile, PlyAndObjWithoutFacesArePoints) {
  const pipeline::ScratchFolder folder;
  pipeline::write_text(folder / "a.ply",
                       "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
                       "property float y\nproperty float z\nproperty float nx\n"
                       "property float ny\nproperty float nz\nproperty uchar red\n"
                       "end_header\n1 2 3 0 0 2 7\n4 5 6 0 0 0 7\n");
  const BodyFile ply = read_body_file(folder / "a.ply");
  EXPECT_TRUE(ply.soup.polygons.empty());
  ASSERT_EQ(ply.soup.points.size(), 2u);
  EXPECT_EQ(ply.soup.points[1], Vec3(4, 5, 6));
  ASSERT_EQ(ply.normals.size(), 2u);
  EXPECT_EQ(ply.normals[0], Vec3(0, 0, 1));
  EXPECT_EQ(ply.normals[1], Vec3(0, 0, 0));
  pipeline::write_text(folder / "b.obj", "v 1 2 3\nv 4 5 6\n");
  EXPECT_EQ(read_body_file(folder / "b.obj").soup.points.size(), 2u);
  EXPECT_THROW(read_mesh(folder / "b.obj"), Error);
  pipeline::write_text(folder / "c.xyz", "# nothing\n");
  EXPECT_THROW(read_body_file(folder / "c.xyz"), Error);
  EXPECT_THROW(read_body_file(folder / "d.las"), Error);
}

TEST(PointFile, PosesAreRotationsWithATranslation) {
  const pipeline::ScratchFolder folder;
  const auto pose = [&](const std::string& text) {
    pipeline::write_text(folder / "pose.txt", text);
    return read_scan_pose(folder / "pose.txt");
  };
  const Eigen::Matrix4d quarter = pose("# camera\n0 0 1 5\n0 1 0 6\n-1 0 0 7\n0 0 0 1\n");
  EXPECT_EQ(quarter * Eigen::Vector4d(1, 2, 3, 1), Eigen::Vector4d(8, 8, 6, 1));
  EXPECT_THROW(pose("2 0 0 0\n0 2 0 0\n0 0 2 0\n0 0 0 1\n"), Error);
  EXPECT_THROW(pose("1 0 0 0\n0 1 0 0\n0 0 -1 0\n0 0 0 1\n"), Error);
  EXPECT_THROW(pose("1 0 0 0\n0 1 0 0\n0 0 1 0\n"), Error);
  EXPECT_THROW(pose("1 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n"), Error);
  const std::string rows = "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";
  EXPECT_TRUE(pose(rows + "\n# the end\n").isIdentity(0));
  EXPECT_THROW(pose("1 0 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n"), Error);
  try {
    pose(rows + "0 0 0 1\n");
    ADD_FAILURE() << "a fifth row was read";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("pose.txt:5: is a fifth row"), std::string::npos)
        << error.what();
  }
}

}  // namespace point_file_test
}  // namespace toile
