// Files for other 3D programs: binary glTF of ease-map, read byte by byte, and OBJ of toile fit.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "io/mesh_file.h"
#include "pattern/file/garment_file.h"
#include "tests/support/run_program.h"
#include "tests/support/tubes.h"

namespace toile::pipeline {
namespace exchange_test {

using Json = nlohmann::json;
using Numbers = std::vector<float>;

/// A file's JSON and its numbers, by the glTF 2.0 specification.
class Glb {
 public:
  explicit Glb(const std::string& bytes) {
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(word(bytes, 4), 2U);
    EXPECT_EQ(word(bytes, 8), bytes.size());
    const std::size_t length = word(bytes, 12);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    EXPECT_EQ(length % 4, 0U);
    json = Json::parse(bytes.substr(20, length));
    EXPECT_EQ(bytes.substr(24 + length, 4), std::string("BIN\0", 4));
    buffer_ = bytes.substr(28 + length);
    EXPECT_EQ(word(bytes, 20 + length), buffer_.size());
    EXPECT_EQ(json["buffers"][0]["byteLength"], buffer_.size());
  }

  /// The primitive of the mesh that the object of that name shows.
  Json primitive(const std::string& name) const {
    for (const Json& node : json["nodes"]) {
      if (node["name"] == name) return json["meshes"][node["mesh"].get<int>()]["primitives"][0];
    }
    ADD_FAILURE() << "no object " << name;
    return {};
  }
  Numbers attribute(const std::string& name, const char* semantic) const {
    return numbers<float>(primitive(name)["attributes"][semantic], 5126);
  }
  std::vector<std::uint32_t> corners(const std::string& name) const {
    return numbers<std::uint32_t>(primitive(name)["indices"], 5125);
  }
  std::string material(const std::string& name) const {
    return json["materials"][primitive(name)["material"].get<int>()]["name"];
  }

  Json json;

 private:
  static std::uint32_t word(const std::string& bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (int i = 3; i >= 0; --i) {
      number = number << 8 | static_cast<unsigned char>(bytes.at(at + static_cast<std::size_t>(i)));
    }
    return number;
  }
  template <class Number>
  std::vector<Number> numbers(const Json& accessor_index, int type) const {
    const Json& accessor = json["accessors"][accessor_index.get<int>()];
    EXPECT_EQ(accessor["componentType"], type);
    const Json& view = json["bufferViews"][accessor["bufferView"].get<int>()];
    const std::map<std::string, std::size_t> widths = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}};
    std::vector<Number> all(accessor["count"].get<std::size_t>() * widths.at(accessor["type"]));
    EXPECT_EQ(view["byteLength"], 4 * all.size());
    const std::size_t from = view["byteOffset"];
    EXPECT_EQ(from % 4, 0U);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::uint32_t bits = word(buffer_, from + 4 * i);
      std::memcpy(&all[i], &bits, 4);
    }
    return all;
  }

  std::string buffer_;
};

Vec3 third(const Numbers& numbers, std::size_t i) {
  return {numbers.at(3 * i), numbers.at(3 * i + 1), numbers.at(3 * i + 2)};
}

/// A cylinder with cloth around it that stands off by 10 mm at the bottom, and 30 mm at the top.
class Exchange : public testing::Test {
 protected:
  Exchange() {
    write_mesh(body, test::closed_tube(0.15, 0.15, 1.6, 300));
    garment = test::cloth_tube(0.16, 0.16, 0.8, 1.3, 60, 10);
    for (Vec3& node : garment.points) {
      const double wider = (0.16 + 0.02 * (node.y() - 0.8) / 0.5) / 0.16;
      node.x() *= wider;
      node.z() *= wider;
    }
    write_dressed(dressed, garment);
  }
  pipeline::Run ease_map(std::vector<std::string> more) const {
    std::vector<std::string> words = {"--body", body, dressed, "-o", scratch / "ease.html", "-q"};
    words.insert(words.end(), more.begin(), more.end());
    return run("ease-map", words);
  }
  Glb glb(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"--glb", scratch / "worn.glb", "--top", "40mm"};
    words.insert(words.end(), more.begin(), more.end());
    const pipeline::Run done = ease_map(words);
    EXPECT_EQ(done.exit_code, 0) << done.err;
    return Glb(read_text(scratch / "worn.glb"));
  }

  ScratchFolder scratch;
  fs::path body = scratch / "body.ply";
  fs::path dressed = scratch / "dressed.obj";
  DressedGarment garment;
};

TEST_F(Exchange, AGlbHasThePanelsAsTheyAreWorn) {
  const Glb file = glb();
  EXPECT_EQ(file.json["asset"]["version"], "2.0");
  EXPECT_EQ(file.json["nodes"].size(), 3U);
  EXPECT_EQ(file.material("front"), "cloth");
  EXPECT_EQ(file.material("body"), "skin");
  for (int panel = 0; panel < 2; ++panel) {
    const std::string name = garment.panels[panel];
    SCOPED_TRACE(name);
    const Numbers points = file.attribute(name, "POSITION");
    const Numbers normals = file.attribute(name, "NORMAL");
    const Numbers flat = file.attribute(name, "TEXCOORD_0");
    const std::vector<std::uint32_t> corners = file.corners(name);
    std::size_t next = 0;
    for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
      if (garment.panel_of_triangle[t] != panel) continue;
      for (int k = 0; k < 3; ++k) {
        const std::size_t i = corners.at(next++);
        const Vec3& node = garment.points[garment.triangles[t][k]];
        EXPECT_EQ(third(points, i), node.cast<float>().cast<double>());
        // glTF counts v downward from the top of a picture, OBJ upward from its bottom: 1 - v.
        const Vec2& vt = garment.flat[garment.flat_triangles[t][k]];
        EXPECT_EQ(flat.at(2 * i), static_cast<float>(vt.x()));
        EXPECT_EQ(flat.at(2 * i + 1), static_cast<float>(1 - vt.y()));
        // A cone that opens upward by 20 mm on 500. At its ends the neighbours lie on one side.
        const Vec3 away = Vec3(node.x(), -0.02 / 0.5 * std::hypot(node.x(), node.z()), node.z());
        EXPECT_GT(third(normals, i).dot(away.normalized()), 0.998);
        EXPECT_NEAR(third(normals, i).norm(), 1, 1e-6);
      }
    }
    EXPECT_EQ(next, corners.size());
    const Json box =
        file.json["accessors"][file.primitive(name)["attributes"]["POSITION"].get<int>()];
    EXPECT_EQ(box["min"][1], 0.8F);
    EXPECT_EQ(box["max"][1], 1.3F);
  }
}

/// Where front and back meet, both have a point with the same normal.
TEST_F(Exchange, NormalsAreSmoothOverASeam) {
  const Glb file = glb();
  std::map<std::array<double, 3>, std::vector<Vec3>> normals_at;
  for (const std::string name : {"front", "back"}) {
    const Numbers points = file.attribute(name, "POSITION");
    const Numbers normals = file.attribute(name, "NORMAL");
    EXPECT_EQ(points.size(), 3U * 31 * 11);
    for (std::size_t i = 0; i < points.size() / 3; ++i) {
      const Vec3 at = third(points, i);
      normals_at[{at.x(), at.y(), at.z()}].push_back(third(normals, i));
    }
  }
  int shared = 0;
  for (const auto& [at, normals] : normals_at) {
    if (normals.size() < 2) continue;
    ++shared;
    EXPECT_EQ(normals[0], normals[1]);
  }
  EXPECT_EQ(shared, 2 * 11);
}

/// The second map: both panels within the unit square, as they are cut, and apart.
TEST_F(Exchange, PanelsLieSideBySide) {
  const Glb file = glb();
  double scale = 0;
  std::vector<std::array<float, 4>> boxes;
  for (const std::string name : {"front", "back"}) {
    const Numbers flat = file.attribute(name, "TEXCOORD_0");
    const Numbers side = file.attribute(name, "TEXCOORD_1");
    std::array<float, 4> box = {2, 2, -2, -2};
    for (std::size_t i = 0; i < side.size(); i += 2) {
      box = {std::min(box[0], side[i]), std::min(box[1], side[i + 1]), std::max(box[2], side[i]),
             std::max(box[3], side[i + 1])};
      const double apart = std::hypot(flat[i] - flat[0], flat[i + 1] - flat[1]);
      const double shown = std::hypot(side[i] - side[0], side[i + 1] - side[1]);
      if (apart < 0.1) continue;
      if (scale == 0) scale = shown / apart;
      EXPECT_NEAR(shown / apart, scale, 1e-4 * scale);
    }
    EXPECT_GE(std::min(box[0], box[1]), 0);
    EXPECT_LE(std::max(box[2], box[3]), 1);
    boxes.push_back(box);
  }
  const auto& [a, b] = std::tie(boxes[0], boxes[1]);
  EXPECT_TRUE(a[2] < b[0] || b[2] < a[0] || a[3] < b[1] || b[3] < a[1]);
  EXPECT_GT(scale, 1);  // most of the square is used
}

/// The bytes of the PLY's colours are sRGB, and the file's floats are linear light.
TEST_F(Exchange, ColoursAreThoseOfTheEaseMap) {
  const Glb file = glb({"--ply", scratch / "worn.ply"});
  const std::string ply = read_text(scratch / "worn.ply");
  std::istringstream head(ply.substr(0, ply.find("end_header\n")));
  std::size_t size = 0, red = 0;
  for (std::string line; std::getline(head, line) && !line.starts_with("element face");) {
    if (line == "property uchar red") red = size;
    const bool is_double = line.starts_with("property double");
    if (line.starts_with("property")) {
      size += line.starts_with("property uchar") ? 1 : is_double ? 8 : 4;
    }
  }
  ASSERT_GT(red, 0U);
  const char* vertices = ply.data() + ply.find("end_header\n") + 11;
  std::map<std::array<float, 3>, std::array<double, 3>> light_at;
  for (std::size_t n = 0; n < garment.points.size(); ++n) {
    std::array<double, 3> light{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double s = static_cast<unsigned char>(vertices[size * n + red + k]) / 255.0;
      light[k] = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    }
    const Eigen::Vector3f at = garment.points[n].cast<float>();
    light_at[{at.x(), at.y(), at.z()}] = light;
  }
  const Numbers points = file.attribute("front", "POSITION");
  const Numbers colours = file.attribute("front", "COLOR_0");
  std::set<float> reds;
  for (std::size_t i = 0; i < points.size(); i += 3) {
    const auto& light = light_at.at({points[i], points[i + 1], points[i + 2]});
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(colours.at(i + k), light[k], 0.006);
    reds.insert(colours[i]);
  }
  EXPECT_GT(reds.size(), 5U);  // the gap is not the same everywhere
  EXPECT_NE(file.json["scenes"][0]["extras"]["colours"].get<std::string>().find("up to 40 mm"),
            std::string::npos);
}

/// Two faces, and a rim at hem and top edge: welded, each edge has two triangles.
TEST_F(Exchange, ThickClothIsClosed) {
  const Glb file = glb({"--glb-thickness", "1mm"});
  std::map<std::array<double, 3>, int> welded;
  std::map<std::pair<int, int>, int> turns;  // of an edge: there less back
  std::map<std::pair<int, int>, int> counts;
  double volume = 0;
  for (const std::string name : {"front", "back"}) {
    const Numbers points = file.attribute(name, "POSITION");
    const Numbers normals = file.attribute(name, "NORMAL");
    const std::vector<std::uint32_t> corners = file.corners(name);
    for (const std::size_t i : corners) EXPECT_NEAR(third(normals, i).norm(), 1, 1e-6);
    for (std::size_t t = 0; t < corners.size(); t += 3) {
      std::array<int, 3> ids{};
      std::array<Vec3, 3> at;
      for (std::size_t k = 0; k < 3; ++k) {
        at[k] = third(points, corners[t + k]);
        ids[k] = welded.try_emplace({at[k].x(), at[k].y(), at[k].z()}, welded.size()).first->second;
      }
      const Vec3 facing = (at[1] - at[0]).cross(at[2] - at[0]);
      EXPECT_GT(facing.dot(third(normals, corners[t])), 0);
      volume += at[0].cross(at[1]).dot(at[2]) / 6;
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = ids[k], b = ids[(k + 1) % 3];
        turns[std::minmax(a, b)] += a < b ? 1 : -1;
        ++counts[std::minmax(a, b)];
      }
    }
  }
  for (const auto& [edge, count] : counts) {
    EXPECT_EQ(count, 2);
    EXPECT_EQ(turns[edge], 0);
  }
  // 1 mm of a cone's wall, 17 cm in radius.
  EXPECT_NEAR(volume, 0.001 * 2 * std::numbers::pi * 0.17 * 0.5, 0.01 * volume);
  EXPECT_EQ(ease_map({"--glb-thickness", "1mm"}).exit_code, 2);
}

TEST_F(Exchange, TheBodyIsAsItIs) {
  const Glb file = glb();
  const TriangleMesh skin = fan_triangles(read_mesh(body));
  const Numbers points = file.attribute("body", "POSITION");
  ASSERT_EQ(points.size(), 3 * skin.points.size());
  for (std::size_t i = 0; i < skin.points.size(); ++i) {
    EXPECT_EQ(third(points, i), skin.points[i].cast<float>().cast<double>());
  }
  const std::vector<std::uint32_t> corners = file.corners("body");
  ASSERT_EQ(corners.size(), 3 * skin.triangles.size());
  for (std::size_t c = 0; c < corners.size(); ++c) {
    EXPECT_EQ(static_cast<int>(corners[c]), skin.triangles[c / 3][c % 3]);
  }
}

/// Of an OBJ file that is read word by word.
struct ObjText {
  std::vector<Vec3> points, normals;
  std::vector<std::string> objects, materials;
  std::vector<std::array<std::array<int, 3>, 3>> faces;  // v, vt, vn of three corners, from 1

  explicit ObjText(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string what;
      words >> what;
      if (what == "v" || what == "vn") {
        Vec3& vector = (what == "v" ? points : normals).emplace_back();
        words >> vector.x() >> vector.y() >> vector.z();
      } else if (what == "o" || what == "usemtl") {
        (what == "o" ? objects : materials).push_back(line.substr(what.size() + 1));
      } else if (what == "f") {
        auto& face = faces.emplace_back();
        for (auto& corner : face) {
          std::string indices;
          words >> indices;
          std::sscanf(indices.c_str(), "%d/%d/%d", &corner[0], &corner[1], &corner[2]);
          if (indices.find("//") != std::string::npos) {
            std::sscanf(indices.c_str(), "%d//%d", &corner[0], &corner[2]);
          }
        }
      }
    }
  }
};

/// What toile fit leaves for other programs is one scene: garment, body and glTF in the same axes.
TEST(ExchangeOfFit, WritesGarmentAndBodyInTheSameAxes) {
  const ScratchFolder folder;
  ASSERT_EQ(
      run("make-mannequin", {"-o", folder / "m.obj", "--edge-length", "14mm", "-q"}).exit_code, 0);
  const fs::path source = fs::path(TOILE_SOURCE_DIR) / "samples" / "tshirt.json";
  const pipeline::Run done =
      run("toile", {"fit", "--body", folder / "m.obj", source, "-o", folder / "out",
                    "--edge-length", "35mm", "--quality", "draft", "--fabric", "denim", "-q"});
  ASSERT_EQ(done.exit_code, 0) << done.err;
  const fs::path out = folder / "out";
  const ObjText cloth(read_text(out / "dressed.obj"));
  const DressedGarment garment = read_dressed(out / "dressed.obj");
  EXPECT_EQ(cloth.objects, garment.panels);
  EXPECT_EQ(cloth.materials, std::vector<std::string>(garment.panels.size(), "denim"));
  ASSERT_EQ(cloth.normals.size(), cloth.points.size());
  const ObjText skin(read_text(out / "body.obj"));
  EXPECT_EQ(skin.objects, std::vector<std::string>{"body"});
  const PolygonSoup ply = read_mesh(out / "body.ply");
  EXPECT_EQ(skin.points, ply.points);
  EXPECT_EQ(skin.faces.size(), ply.polygons.size());
  // All faces look where their normals do.
  for (const ObjText* obj : {&cloth, &skin}) {
    int against = 0;
    for (const auto& face : obj->faces) {
      std::array<Vec3, 3> at;
      for (std::size_t k = 0; k < 3; ++k) at[k] = obj->points.at(face[k][0] - 1);
      const Vec3 facing = (at[1] - at[0]).cross(at[2] - at[0]);
      for (const auto& corner : face) {
        EXPECT_EQ(corner[2], corner[0]);
        against += facing.dot(obj->normals.at(corner[2] - 1)) < 0 ? 1 : 0;
      }
    }
    EXPECT_LT(against, 0.02 * static_cast<double>(obj->faces.size()));
  }
  const Glb file(read_text(out / "dressed.glb"));
  EXPECT_EQ(file.material(garment.panels[0]), "denim");
  for (const std::string& name : {garment.panels[0], std::string("body")}) {
    const Numbers points = file.attribute(name, "POSITION");
    const std::vector<Vec3>& all = name == "body" ? skin.points : cloth.points;
    for (std::size_t i = 0; i < points.size() / 3; ++i) {
      const auto is_there = [&](const Vec3& p) { return (p - third(points, i)).norm() < 1e-6; };
      ASSERT_TRUE(std::ranges::any_of(all, is_there)) << name << ' ' << i;
    }
  }
}

}  // namespace exchange_test
}  // namespace toile::pipeline
