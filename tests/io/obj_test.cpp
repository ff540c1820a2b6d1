#include "io/obj.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <random>

#include "geometry/error.h"

namespace toile {
namespace obj_test {

const std::string quad_with_line =
    "# two panels\n"
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
    "vt 0 0\nvt 1 0\nvt 1 1\n"
    "vn 0 0 1\nusemtl none\ns off\n"
    "g front left\n"
    "f 1/1/1 2/2/1 3/3/1 4//1\n"
    "g back\n"
    "f -4 -3 -2\n"
    "l 1 2 3\n";

std::string message_of(const std::string& text) {
  try {
    parse_obj(text, "some.obj");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Obj, ReadsFacesGroupsAndLines) {
  const ObjData data = parse_obj(quad_with_line, "quad.obj");
  EXPECT_EQ(data.points.size(), 4u);
  EXPECT_EQ(data.texture.size(), 3u);
  ASSERT_EQ(data.faces.size(), 2u);
  EXPECT_EQ(data.faces[0].corners.size(), 4u);
  EXPECT_EQ(data.faces[0].corners[2].point, 2);
  EXPECT_EQ(data.faces[0].corners[2].texture, 2);
  EXPECT_EQ(data.faces[0].corners[3].texture, -1);
  EXPECT_EQ(data.groups, (std::vector<std::string>{"front left", "back"}));
  EXPECT_EQ(data.faces[1].group, 1);
  EXPECT_EQ(data.faces[1].corners[0].point, 0);
  EXPECT_EQ(data.faces[1].corners[2].point, 2);
  EXPECT_EQ(data.lines, (std::vector<std::array<int, 2>>{{0, 1}, {1, 2}}));
}

TEST(Obj, ReadsWindowsLinesContinuationsAndForwardReferences) {
  const ObjData data =
      parse_obj("f 1 2 \\\r\n3\r\nv 0 0 0 # origin\r\nv +1 0 0 1.0\r\nv 0 1e0 0 .5 .5 .5", "x.obj");
  ASSERT_EQ(data.faces.size(), 1u);
  EXPECT_EQ(data.faces[0].group, -1);
  EXPECT_EQ(data.faces[0].corners[2].point, 2);
  EXPECT_EQ(data.points[2], Vec3(0, 1, 0));
}

TEST(Obj, NamesTheLineOfWhatIsWrong) {
  EXPECT_NE(message_of("v 0 0 0\nv 1 x 0\n").find("some.obj:2: 'x' is not a number"),
            std::string::npos);
  EXPECT_NE(message_of("v 0 nan 0\n").find("some.obj:1: 'nan' is not a finite"), std::string::npos);
  EXPECT_NE(message_of("v 0 1e999 0\n").find("not a finite"), std::string::npos);
  EXPECT_EQ(
      message_of("v 0 0 0\nv 0 1e18 0\n"),
      "some.obj:2: a coordinate is 1e+18, beyond 1,000,000 units; correct the point or remove "
      "it");
  EXPECT_NE(message_of("v 0 0\n").find("some.obj:1: a number is missing"), std::string::npos);
  EXPECT_NE(message_of("v 0 0 0\n\nf 1 1 2\n").find("some.obj:3: refers to vertex 2"),
            std::string::npos);
  EXPECT_NE(message_of("v 0 0 0\nf 1/1 1/1 1/1\n").find("texture coordinate 1"), std::string::npos);
  EXPECT_NE(message_of("v 0 0 0\nf 0 1 1\n").find("some.obj:2"), std::string::npos);
  EXPECT_NE(message_of("v 0 0 0\nf -2 1 1\n").find("some.obj:2"), std::string::npos);
  EXPECT_NE(message_of("v 0 0 0\nf 1 1\n").find("fewer than three"), std::string::npos);
  EXPECT_NE(message_of("v 0 0 0\nf 99999999999999999999 1 1\n").find("some.obj:2"),
            std::string::npos);
  EXPECT_NE(message_of("").find("holds no OBJ statement"), std::string::npos);
  EXPECT_NE(message_of("Dear reader,\nthis is a letter.\n").find("holds no OBJ statement"),
            std::string::npos);
}

TEST(Obj, TooSmallForADoubleIsZero) {
  EXPECT_EQ(parse_obj("v 1e-400 0 0\n", "x.obj").points[0].x(), 0.0);
}

TEST(Obj, DoublesSurviveTheRoundTripBitForBit) {
  std::mt19937_64 random(7);
  ObjData data;
  for (int i = 0; i < 3000; ++i) {
    Vec3 point;
    for (int k = 0; k < 3; ++k) {
      double value = 0;
      do {
        value = std::bit_cast<double>(random());
      } while (!(std::abs(value) <= max_coordinate));
      point[k] = value;
    }
    data.points.push_back(point);
  }
  data.points.emplace_back(0.1, -0.0, std::numeric_limits<double>::denorm_min());
  data.texture.emplace_back(1.0 / 3, -1e-7);
  data.groups = {"panel one"};
  data.faces.push_back({{{0, 0}, {1, -1}, {2, 0}}, 0});
  data.lines.push_back({5, 9});
  data.comments = {"a comment"};
  const auto path = std::filesystem::temp_directory_path() / "toile_obj_round_trip.obj";
  write_obj(path, data);
  const ObjData back = read_obj(path);
  std::filesystem::remove(path);
  ASSERT_EQ(back.points.size(), data.points.size());
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(back.points[i][k]),
                std::bit_cast<std::uint64_t>(data.points[i][k]));
    }
  }
  EXPECT_EQ(back.texture, data.texture);
  EXPECT_EQ(back.groups, data.groups);
  EXPECT_EQ(back.lines, data.lines);
  EXPECT_EQ(back.faces[0].corners[1].texture, -1);
  EXPECT_EQ(back.faces[0].corners[2].texture, 0);
}

TEST(Obj, MutatedFilesAreReadOrRefusedButNeverCrash) {
  std::mt19937 random(11);
  const std::string alphabet = "vftlgo 0123456789.-+e/\\#\n\r\tnai\xff";
  int read = 0;
  int refused = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string text = quad_with_line;
    const int edits = 1 + static_cast<int>(random() % 6);
    for (int e = 0; e < edits && !text.empty(); ++e) {
      const std::size_t at = random() % text.size();
      const char c = alphabet[random() % alphabet.size()];
      switch (random() % 4) {
        case 0:
          text[at] = c;
          break;
        case 1:
          text.insert(at, 1, c);
          break;
        case 2:
          text.erase(at, 1 + random() % 5);
          break;
        default:
          text = text.substr(0, at) + text.substr(random() % text.size());
      }
    }
    try {
      const ObjData data = parse_obj(text, "mutant.obj");
      ++read;
      for (const ObjFace& face : data.faces) {
        ASSERT_GE(face.corners.size(), 3u);
        for (const ObjCorner& corner : face.corners) {
          ASSERT_GE(corner.point, 0);
          ASSERT_LT(corner.point, static_cast<int>(data.points.size()));
          ASSERT_LT(corner.texture, static_cast<int>(data.texture.size()));
        }
      }
      for (const Vec3& point : data.points) ASSERT_TRUE(point.allFinite());
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(read, 1000);
  EXPECT_GT(refused, 1000);
}

TEST(Obj, AMissingFileIsAnError) { EXPECT_THROW(read_obj("no/such/file.obj"), Error); }

}  // namespace obj_test
}  // namespace toile
