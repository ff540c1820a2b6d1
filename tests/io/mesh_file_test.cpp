#include "io/mesh_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>

#include "geometry/error.h"
#include "io/limits.h"
#include "io/mesh_formats.h"
#include "io/obj.h"
#include "io/output_file.h"
#include "tests/support/shapes.h"

namespace toile {
namespace mesh_file_test {

namespace fs = std::filesystem;

class MeshFile : public testing::Test {
 protected:
  MeshFile() : folder_(fs::temp_directory_path() / ("toile-mesh-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~MeshFile() override { fs::remove_all(folder_); }

  fs::path file(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return folder_ / name;
  }

  std::string error_of(const std::string& name, const std::string& content) const {
    try {
      read_mesh(file(name, content));
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }

  fs::path folder_;
};

/// Coordinates that a careless number format would change.
TriangleMesh awkward() {
  TriangleMesh mesh = test::cube();
  mesh.points[0] = {0.1, 1.0 / 3, -1e-300};
  mesh.points[1] = {std::nextafter(1.0, 2.0), std::numeric_limits<double>::denorm_min(), 1e6};
  mesh.points[2] = {-0.0, 123456.789012345678, 2.0 / 7};
  return mesh;
}

TEST_F(MeshFile, DoublesSurviveObjPlyAndOff) {
  const TriangleMesh mesh = awkward();
  for (const char* name : {"m.obj", "m.ply", "m.off", "m.PLY"}) {
    write_mesh(folder_ / name, mesh);
    const PolygonSoup soup = read_mesh(folder_ / name);
    EXPECT_EQ(soup.points, mesh.points) << name;
    EXPECT_TRUE(std::signbit(soup.points[2].x())) << name;
    EXPECT_EQ(soup.polygons, test::soup(mesh).polygons) << name;
  }
}

TEST_F(MeshFile, StlKeepsTheTrianglesAsFloats) {
  const TriangleMesh mesh = test::sphere(0.7, 2);
  write_mesh(folder_ / "m.stl", mesh);
  const PolygonSoup soup = read_mesh(folder_ / "m.stl");
  ASSERT_EQ(soup.polygons.size(), mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int corner = 0; corner < 3; ++corner) {
      EXPECT_EQ(soup.points[soup.polygons[t][corner]],
                mesh.points[mesh.triangles[t][corner]].cast<float>().cast<double>());
    }
  }
}

TEST_F(MeshFile, PlyHoldsColoursAndValuesAndIsStillRead) {
  const TriangleMesh mesh = test::cube();
  const std::vector<Colour> colours(mesh.points.size(), Colour{1, 128 / 255.0, 0});
  MeshProperties properties;
  properties.colours = colours;
  properties.points = {{"gap_mm", std::vector<double>(mesh.points.size(), 2.5)}};
  properties.triangles = {{"tension", std::vector<double>(mesh.triangles.size(), 7)}};
  write_mesh(folder_ / "m.ply", mesh, properties);
  const std::string bytes = read_file(folder_ / "m.ply");
  EXPECT_NE(bytes.find("property uchar red\nproperty uchar green\nproperty uchar blue\n"),
            std::string::npos);
  EXPECT_NE(bytes.find("\xff\x80"), std::string::npos);
  EXPECT_NE(bytes.find("property float gap_mm\nelement face"), std::string::npos);
  EXPECT_NE(bytes.find("property float tension\nend_header"), std::string::npos);
  EXPECT_EQ(read_mesh(folder_ / "m.ply").points, mesh.points);
  EXPECT_EQ(read_mesh(folder_ / "m.ply").polygons.size(), mesh.triangles.size());
  EXPECT_THROW(write_mesh(folder_ / "m.obj", mesh, properties), Error);
  EXPECT_FALSE(fs::exists(folder_ / "m.obj"));
}

TEST_F(MeshFile, PlyVariantsSayTheSame) {
  const std::string declarations =
      "comment made by hand\nelement vertex 4\nproperty uchar quality\nproperty float x\n"
      "property float y\nproperty float z\nelement face 1\nproperty list uchar short "
      "vertex_index\nproperty uchar flags\nelement edge 1\nproperty int v1\nproperty int v2\n"
      "end_header\n";
  const std::string text = "ply\nformat ascii 1.0\n" + declarations +
                           "7 0 0 0\n7 1.5 0 0\n7 1.5 2 0\n7 0 2 -3\n4 0 1 2 3 9\n0 1\n";
  std::string big = "ply\r\nformat binary_big_endian 1.0\r\n";
  for (const char c : declarations) big += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const auto big_float = [&big](float value) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, 4);
    for (int shift = 24; shift >= 0; shift -= 8) big += static_cast<char>(bits >> shift);
  };
  for (const auto& p : {Vec3(0, 0, 0), Vec3(1.5, 0, 0), Vec3(1.5, 2, 0), Vec3(0, 2, -3)}) {
    big += '\7';
    for (int i = 0; i < 3; ++i) big_float(static_cast<float>(p[i]));
  }
  big += std::string("\4\0\0\0\1\0\2\0\3\11", 10) + std::string("\0\0\0\0\0\0\0\1", 8);
  for (const PolygonSoup& soup : {parse_ply(text, "t"), parse_ply(big, "b")}) {
    ASSERT_EQ(soup.points.size(), 4u);
    EXPECT_EQ(soup.points[3], Vec3(0, 2, -3));
    ASSERT_EQ(soup.polygons.size(), 1u);
    EXPECT_EQ(soup.polygons[0], (std::vector<int>{0, 1, 2, 3}));
  }
}

TEST_F(MeshFile, TextStlAndOffVariants) {
  const PolygonSoup stl = parse_stl(
      "solid a\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n"
      "   vertex 0 1e0 0\n  endloop\n endfacet\nendsolid a\n",
      "t");
  ASSERT_EQ(stl.polygons.size(), 1u);
  EXPECT_EQ(stl.points[2], Vec3(0, 1, 0));
  const PolygonSoup off = parse_off(
      "COFF # coloured\n3 1 0\n\n0 0 0 255 0 0 255\n1 0 0 0 0 0 255\n0 1 0 0 0 0 255\n"
      "3 0 1 2 0.5 0.5 0.5\n",
      "t");
  EXPECT_EQ(off.points[1], Vec3(1, 0, 0));
  EXPECT_EQ(off.polygons[0], (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(parse_off("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "t").points.size(), 3u);
}

TEST_F(MeshFile, ErrorsNameThePlace) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
      "property float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n";
  EXPECT_NE(error_of("a.ply", ply + "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n").find("a.ply:11: "),
            std::string::npos);
  EXPECT_NE(error_of("a.ply", ply + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n").find("a.ply:13: "),
            std::string::npos);
  EXPECT_NE(error_of("a.ply", ply + "0 0 0\n1 0 0\n").find("ends before vertex 2"),
            std::string::npos);
  EXPECT_NE(error_of("a.ply", "ply\nformat ascii 1.0\nelement vertex x\n").find("a.ply:3: "),
            std::string::npos);
  EXPECT_NE(error_of("a.off", "OFF\n3 1 0\n0 0 0\n1 0 inf\n").find("a.off:4: "), std::string::npos);
  EXPECT_NE(error_of("a.off", "solid\n").find("instead of OFF"), std::string::npos);
  EXPECT_NE(error_of("a.stl", "solid x\nfacet\nouter loop\nvertex 0 0\n").find("a.stl:4: "),
            std::string::npos);
  EXPECT_NE(error_of("a.stl", "short").find("too short"), std::string::npos);
  std::string stl = format_stl(test::cube());
  stl.resize(stl.size() - 1);
  EXPECT_NE(error_of("a.stl", stl).find("byte 80"), std::string::npos);
  std::string binary = format_ply(test::cube(), {});
  const double not_a_number = std::nan("");
  std::memcpy(&binary[binary.find("end_header\n") + 11 + 24 + 8], &not_a_number, 8);
  EXPECT_NE(error_of("a.ply", binary).find("vertex 1: a coordinate is not a finite"),
            std::string::npos);
}

TEST_F(MeshFile, WhatIsNoMeshIsAnError) {
  EXPECT_NE(error_of("a.xyz", "0 0 0\n").find("not a mesh format"), std::string::npos);
  EXPECT_NE(error_of("noextension", "0 0 0\n").find("no extension"), std::string::npos);
  EXPECT_NE(error_of("a.obj", "v 0 0 0\nv 1 0 0\n").find("no faces"), std::string::npos);
  for (const char* name : {"a.obj", "a.ply", "a.stl", "a.off"}) {
    EXPECT_NE(error_of(name, ""), "no error") << name;
    EXPECT_NE(error_of(name, "Dear reader,\nthis is a letter.\n"), "no error") << name;
  }
  EXPECT_THROW(read_mesh(folder_ / "missing.obj"), Error);
  EXPECT_THROW(write_mesh(folder_ / "none" / "m.ply", test::cube()), Error);
}

TEST_F(MeshFile, HugeCountsAreNotBelieved) {
  EXPECT_NE(error_of("a.off", "OFF\n2000000000 2000000000 0\n0 0 0\n").find("ends before point 2"),
            std::string::npos);
  EXPECT_NE(error_of("a.ply",
                     "ply\nformat binary_little_endian 1.0\nelement vertex 2000000000\n"
                     "property double x\nproperty double y\nproperty double z\n"
                     "end_header\nabc")
                .find("ends within vertex 0"),
            std::string::npos);
  std::string stl(84, ' ');
  stl.replace(80, 4, "\xff\xff\xff\xff");
  EXPECT_NE(error_of("a.stl", stl).find("announces 4294967295"), std::string::npos);
  EXPECT_NE(error_of("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2000000000 0 1 2\n"), "no error");
}

TEST_F(MeshFile, FarPointsAreRefusedInEachFormat) {
  for (const std::string far : {"1e15", "-1e18", "1e300", "1000001"}) {
    const auto expect = [&](const std::string& name, const std::string& content,
                            const std::string& line) {
      const std::string error = error_of(name, content);
      EXPECT_NE(error.find(name + ":" + line + ": a coordinate is "), std::string::npos) << error;
      EXPECT_NE(error.find(", beyond 1,000,000 units; "), std::string::npos) << error;
    };
    expect("far.obj", "v 0 0 0\nv 0 " + far + " 0\nv 1 0 0\nf 1 2 3\n", "2");
    expect("far.off", "OFF\n3 1 0\n0 0 0\n0 0 " + far + "\n1 0 0\n3 0 1 2\n", "4");
    expect("far.stl",
           "solid\nfacet normal 0 0 0\nouter loop\nvertex " + far +
               " 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n",
           "4");
    TriangleMesh mesh = test::cube();
    mesh.points[1].x() = std::stod(far);
    EXPECT_NE(error_of("far.ply", format_ply(mesh, {})).find("vertex 1: a coordinate is"),
              std::string::npos);
    if (far != "1e300") {  // no float is as large
      EXPECT_NE(error_of("far.stl", format_stl(mesh)).find("triangle"), std::string::npos);
    }
  }
  EXPECT_EQ(error_of("near.obj", "v 0 0 0\nv 0 1e6 0\nv 1 0 0\nf 1 2 3\n"), "no error");
}

TEST_F(MeshFile, AFaceOfVeryManyCornersIsRefusedInEachFormat) {
  const auto face = [](const char* keyword, int corners) {
    std::string text = keyword;
    for (int i = 0; i < corners; ++i) text.append(i % 2 == 0 ? " 1" : " 2");
    return text.append("\n");
  };
  const int many = max_face_corners + 1;
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
  EXPECT_EQ(error_of("a.obj", obj + face("f", many - 1)), "no error");
  EXPECT_NE(error_of("a.obj", obj + face("f", many)).find("a.obj:4: a face has more than 1000"),
            std::string::npos);
  const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_NE(
      error_of("a.off", off + face("1001", many)).find("a.off:6: the number of corners is 1001"),
      std::string::npos);
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
      "z\nelement face 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_NE(error_of("a.ply", ply + face("1001", many)).find("corners of face 0 is 1001"),
            std::string::npos);
}

std::string mutated(std::string text, std::mt19937& random) {
  const auto pick = [&random](std::size_t n) { return n == 0 ? 0 : random() % n; };
  static const std::vector<std::string> pieces = {"nan",
                                                  "inf",
                                                  "-1",
                                                  "4294967295",
                                                  "99999999999999999999",
                                                  "1e999",
                                                  "-",
                                                  "\n",
                                                  " ",
                                                  "#",
                                                  std::string(1, '\0'),
                                                  "\xff\xff\xff\xff",
                                                  "0x1p3",
                                                  "+",
                                                  "element vertex 7\n",
                                                  "3 0 1 2\n"};
  for (std::size_t i = 1 + pick(3); i > 0; --i) {
    const std::size_t at = pick(text.size());
    switch (pick(6)) {
      case 0:
        if (!text.empty()) text[at] = static_cast<char>(random());
        break;
      case 1:
        text.erase(at, 1 + pick(20));
        break;
      case 2:
        text.insert(at, pieces[pick(pieces.size())]);
        break;
      case 3:
        text.resize(at);
        break;
      case 4:
        text.insert(at, text.substr(pick(text.size()), pick(40)));
        break;
      default: {  // a number or word replaced whole
        const std::size_t begin = text.find_first_of(" \n", at);
        if (begin == std::string::npos) break;
        const std::size_t end = std::min(text.find_first_of(" \n", begin + 1), text.size());
        text.replace(begin + 1, end - begin - 1, pieces[pick(pieces.size())]);
      }
    }
  }
  return text;
}

/// Every mutation either parses to a sound soup or is an Error: no crash, no hang, no huge memory.
template <class Parse>
void fuzz(const std::string& good, const Parse& parse) {
  std::mt19937 random(20240607);
  int parsed = 0;
  int refused = 0;
  for (int i = 0; i < 4000; ++i) {
    PolygonSoup soup;
    try {
      soup = parse(mutated(good, random));
      ++parsed;
    } catch (const Error& error) {
      EXPECT_LT(std::string(error.what()).size(), 400u) << error.what();
      ++refused;
      continue;
    }
    for (const Vec3& point : soup.points) ASSERT_TRUE(point.allFinite());
    for (const auto& polygon : soup.polygons) {
      ASSERT_GE(polygon.size(), 3u);
      for (const int corner : polygon) {
        ASSERT_GE(corner, 0);
        ASSERT_LT(corner, static_cast<int>(soup.points.size()));
      }
    }
  }
  // The mutations test both sides: some parse and some are Errors.
  EXPECT_GT(parsed, 40);
  EXPECT_GT(refused, 400);
}

PolygonSoup parse_obj_soup(const std::string& text) {
  const ObjData data = parse_obj(text, "fuzz");
  PolygonSoup soup;
  soup.points = data.points;
  for (const ObjFace& face : data.faces) {
    auto& polygon = soup.polygons.emplace_back();
    for (const ObjCorner& corner : face.corners) polygon.push_back(corner.point);
  }
  return soup;
}

TEST(MeshFuzz, Obj) {
  fuzz(
      "# a cube\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 .5\nvt 0 1\ng a\nf 1/1 2/1 3/1 4/1\nf -1 -2 -3\n"
      "l 1 2 3\n",
      [](const std::string& text) { return parse_obj_soup(text); });
}

TEST(MeshFuzz, PlyBinary) {
  fuzz(format_ply(test::cube(), {}),
       [](const std::string& text) { return parse_ply(text, "fuzz"); });
}

TEST(MeshFuzz, PlyText) {
  fuzz(
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
      "float z\nproperty list uchar int extra\nelement face 2\nproperty list uchar int "
      "vertex_indices\nend_header\n0 0 0 0\n1 0 0 1 5\n1 1 0 0\n0 1 0 2 1 1\n4 0 1 2 3\n3 0 1 2\n",
      [](const std::string& text) { return parse_ply(text, "fuzz"); });
}

TEST(MeshFuzz, StlBinary) {
  // Most mutations change the length, which then contradicts the count. So this test flips bytes
  // only.
  std::mt19937 random(7);
  const std::string good = format_stl(test::cube());
  int parsed = 0;
  for (int i = 0; i < 4000; ++i) {
    std::string bytes = good;
    for (int flips = 0; flips < 4; ++flips)
      bytes[random() % bytes.size()] = static_cast<char>(random());
    try {
      for (const Vec3& point : parse_stl(bytes, "fuzz").points) ASSERT_TRUE(point.allFinite());
      ++parsed;
    } catch (const Error&) {
    }
  }
  EXPECT_GT(parsed, 1000);
  EXPECT_LT(parsed, 4000);
}

TEST(MeshFuzz, StlText) {
  fuzz(
      "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
      "endloop\nendfacet\nendsolid s\n",
      [](const std::string& text) { return parse_stl(text, "fuzz"); });
}

TEST(MeshFuzz, Off) {
  fuzz(format_off(test::cube()), [](const std::string& text) { return parse_off(text, "fuzz"); });
}

}  // namespace mesh_file_test
}  // namespace toile
