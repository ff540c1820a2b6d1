#include "pattern/file/garment_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "io/output_file.h"
#include "tests/pattern/samples.h"

namespace toile {
namespace garment_file_test {

namespace fs = std::filesystem;
using samples::error_of;

/// A folder of its own for each test.
class GarmentFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() /
              ("toile_garment_file_" +
               std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    obj_ = folder_ / "garment.obj";
    json_ = folder_ / "garment.garment.json";
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Writes `from` replaced by `to` in the file, and the message that reading the pair gives.
  std::string message_after(const fs::path& file, const std::string& from, const std::string& to) {
    const std::string text = read_file(file);
    const std::size_t at = text.find(from);
    if (at == std::string::npos) return "the file does not hold " + from;
    std::string changed = text;
    changed.replace(at, from.size(), to);
    write_file(file, changed);
    const std::string message = error_of([&] { read_garment(obj_); });
    write_file(file, text);
    return message;
  }

  fs::path folder_;
  fs::path obj_;
  fs::path json_;
};

PanelMesh bag(int subdivisions = 1) {
  std::vector<Remark> remarks;
  Pattern pattern = samples::parse(samples::bag);
  pattern.panels[0].part = BodyPart::torso;
  pattern.panels[0].fabric = "denim";
  pattern.panels[0].placement = {PlacementSide::back,
                                 0.5,
                                 PlacementAxis::minus_y,
                                 37.5,
                                 0.01,
                                 0.123456789012345678,
                                 "chest",
                                 1 / 3.0};
  pattern.panels[1].grain = 0.1;
  pattern.panels[0].edges[2].elastic = {0.7, 12.5};
  pattern.panels[0].drill_holes = {{0.1, 0.1}};
  pattern.panels[0].cut_outs = {{{0.1, 0.2}, {0.2, 0.2}, {0.15, 0.3}}};
  using Share = PanelAttachment::Share;
  pattern.panels[1].attachments = {
      {"1", 1, Share::whole, {AttachedTo::level, "bust", 1 / 3.0, Vec3::Zero(), true, 70, 1 / 7.0}},
      {"v2", 1, Share::end, {AttachedTo::point, "", 0, Vec3(0.1, 1 / 9.0, 3), false, 5, 6}}};
  return mesh_panels(pattern, {0.03, subdivisions}, remarks);
}

void expect_equal(const PanelMesh& a, const PanelMesh& b) {
  EXPECT_EQ(a.flat, b.flat);
  EXPECT_EQ(a.placed, b.placed);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.subdivisions, b.subdivisions);
  EXPECT_EQ(a.edge_length, b.edge_length);
  ASSERT_EQ(a.panels.size(), b.panels.size());
  for (std::size_t p = 0; p < a.panels.size(); ++p) {
    EXPECT_EQ(a.panels[p].name, b.panels[p].name);
    EXPECT_EQ(a.panels[p].is, b.panels[p].is);
    EXPECT_EQ(a.panels[p].placement, b.panels[p].placement);
    EXPECT_EQ(a.panels[p].fabric, b.panels[p].fabric);
    EXPECT_EQ(a.panels[p].grain, b.panels[p].grain);
    EXPECT_EQ(a.panels[p].first_point, b.panels[p].first_point);
    EXPECT_EQ(a.panels[p].points, b.panels[p].points);
    EXPECT_EQ(a.panels[p].first_triangle, b.panels[p].first_triangle);
    EXPECT_EQ(a.panels[p].triangles, b.panels[p].triangles);
  }
  ASSERT_EQ(a.seams.size(), b.seams.size());
  for (std::size_t s = 0; s < a.seams.size(); ++s) {
    EXPECT_EQ(a.seams[s].name, b.seams[s].name);
    EXPECT_EQ(a.seams[s].a, b.seams[s].a);
    EXPECT_EQ(a.seams[s].b, b.seams[s].b);
    EXPECT_EQ(a.seams[s].length_a, b.seams[s].length_a);
    EXPECT_EQ(a.seams[s].length_b, b.seams[s].length_b);
  }
  ASSERT_EQ(a.elastics.size(), 1u);
  ASSERT_EQ(b.elastics.size(), 1u);
  EXPECT_EQ(a.elastics[0].name, "front.2");
  EXPECT_EQ(a.elastics[0].name, b.elastics[0].name);
  EXPECT_EQ(a.elastics[0].points, b.elastics[0].points);
  EXPECT_EQ(a.elastics[0].ratio, b.elastics[0].ratio);
  EXPECT_EQ(a.elastics[0].stiffness, b.elastics[0].stiffness);
  ASSERT_EQ(a.attachments.size(), 2u);
  ASSERT_EQ(b.attachments.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(a.attachments[i].name, b.attachments[i].name);
    EXPECT_EQ(a.attachments[i].points, b.attachments[i].points);
    EXPECT_EQ(a.attachments[i].how, b.attachments[i].how);
  }
  ASSERT_EQ(a.marks.size(), 1u);
  ASSERT_EQ(b.marks.size(), 1u);
  EXPECT_EQ(a.marks[0].name, b.marks[0].name);
  EXPECT_EQ(a.marks[0].points, b.marks[0].points);
  ASSERT_EQ(a.cut_outs.size(), 1u);
  ASSERT_EQ(b.cut_outs.size(), 1u);
  EXPECT_EQ(a.cut_outs[0].name, b.cut_outs[0].name);
  EXPECT_EQ(a.cut_outs[0].points, b.cut_outs[0].points);
  // Vertex 2 is the end of edge 1.
  EXPECT_EQ(a.attachments[0].name, "back.1");
  EXPECT_EQ(a.attachments[1].name, "back.v2");
  EXPECT_EQ(a.attachments[1].points, std::vector<int>{a.attachments[0].points.back()});
}

TEST_F(GarmentFile, SurvivesTheRoundTripExactly) {
  for (const int subdivisions : {0, 2}) {
    const PanelMesh garment = bag(subdivisions);
    write_garment(obj_, garment);
    expect_equal(read_garment(obj_), garment);
  }
}

TEST_F(GarmentFile, TheJsonMayStandElsewhere) {
  const PanelMesh garment = bag();
  write_garment(obj_, garment);
  fs::rename(json_, folder_ / "other.json");
  EXPECT_HOLDS(error_of([&] { read_garment(obj_); }),
               "garment.garment.json: is missing: it holds the panels and seams of ");
  expect_equal(read_garment(obj_, folder_ / "other.json"), garment);
}

TEST_F(GarmentFile, ReadsTheNameOfEarlierVersions) {
  const PanelMesh garment = bag();
  const fs::path earlier = folder_ / "garment.json";
  write_garment(obj_, garment);
  fs::rename(json_, earlier);
  EXPECT_EQ(garment_json_beside(obj_), earlier);
  expect_equal(read_garment(obj_), garment);
  // A pattern, a report of dress and a table of that name are something else.
  for (const char* other :
       {R"({"pattern": {"panels": {}}})", R"({"panels": [], "seams": {"open": 0}})", "[]"}) {
    write_file(earlier, other);
    EXPECT_HOLDS(error_of([&] { read_garment(obj_); }), "garment.garment.json: is missing");
  }
}

TEST_F(GarmentFile, ReadsWhatAnotherProgramWrote) {
  // Two right triangles side by side, texture coordinates in another order than the vertices.
  write_file(obj_,
             "o whatever\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nv 3 0 0\nv 2 1 0\n"
             "vt 0 1\nvt 1 0\nvt 0 0\nf 1/3 2/2 3/1\nf 4/3 5/2 6/1\n");
  write_file(json_, R"({"panels": [
      {"name": "one", "first_point": 0, "points": 3, "first_triangle": 0, "triangles": 1},
      {"name": "two", "first_point": 3, "points": 3, "first_triangle": 1, "triangles": 1}],
    "seams": [{"name": "s", "a": [1, 2], "b": [3, 5], "length_a": 1.4142, "length_b": 1}]})");
  const PanelMesh garment = read_garment(obj_);
  EXPECT_EQ(garment.subdivisions, 0);
  EXPECT_EQ(garment.flat[0], Vec2(0, 0));
  EXPECT_EQ(garment.flat[2], Vec2(0, 1));
  EXPECT_EQ(garment.flat[5], Vec2(0, 1));
  EXPECT_EQ(garment.panels[1].name, "two");
  EXPECT_EQ(garment.seams[0].b, (std::vector<int>{3, 5}));
}

TEST_F(GarmentFile, NamesWhatDoesNotFitTogether) {
  const PanelMesh garment = bag();
  write_garment(obj_, garment);
  const std::string points = std::to_string(garment.panels[0].points);
  EXPECT_HOLDS(message_after(json_, "\"points\":" + points, "\"points\":7"), "panel 'front'");
  EXPECT_HOLDS(message_after(json_, "\"first_point\":0", "\"first_point\":1"), "panel 'front'");
  EXPECT_HOLDS(message_after(json_, "\"first_point\":0", "\"first_point\":-1"), "panel 0");
  EXPECT_HOLDS(message_after(json_, "\"triangles\":", "\"triangls\":"), "has no 'triangles'");
  EXPECT_HOLDS(message_after(json_, "\"a\":[", "\"a\":[123456,"),
               "seam 0, a[0]: 123456 is not in 0 to");
  EXPECT_HOLDS(message_after(json_, "\"a\":[", "\"a\":[0,"), "seam 0: has sides of");
  EXPECT_HOLDS(message_after(json_, "\"subdivisions\": 1", "\"subdivisions\": 2"),
               "states 2 subdivisions");
  EXPECT_HOLDS(message_after(json_, "\"length_a\":", "\"length_a\":\"long\",\"x\":"),
               "seam 0, length_a: is not a number");
  EXPECT_HOLDS(message_after(json_, "{", ""), "is not JSON");
  EXPECT_HOLDS(message_after(json_, "\"panels\": [", "\"panels\": [], \"old\": ["),
               "covers 0 points");
  EXPECT_HOLDS(message_after(obj_, "\nf ", "\n# "), "garment.garment.json: ");
  EXPECT_HOLDS(message_after(obj_, "\nf ", "\nf 1/2 "), "is no triangle");
  EXPECT_HOLDS(message_after(obj_, "\nvt ", "\nvn "), "garment.obj");
}

TEST_F(GarmentFile, FarPointsAreRefused) {
  for (const char* far : {"1000.5", "1e15", "-1e18", "1e300"}) {
    const std::string point = std::string("\nv ") + far + " 0 0\nv ";
    write_garment(obj_, bag());
    EXPECT_HOLDS(message_after(obj_, "\nv ", point), "garment.obj:2: a coordinate is");
    write_garment(obj_, bag());
    EXPECT_HOLDS(message_after(obj_, "\nvt ", std::string("\nvt ") + far + " 0\nvt "),
                 ": a coordinate is");
  }
}

TEST_F(GarmentFile, FlatTrianglesMustNotBeTurnedOver) {
  write_file(obj_, "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 3/3 2/2\n");
  write_file(json_, R"({"panels": [], "seams": []})");
  EXPECT_HOLDS(error_of([&] { read_garment(obj_); }), "not counter-clockwise");
  write_file(obj_, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_HOLDS(error_of([&] { read_garment(obj_); }), "has no flat coordinates");
}

TEST_F(GarmentFile, PlacedPanelsMustNotBeCrushed) {
  PanelMesh garment = bag();
  const int first = garment.panels[1].first_point;
  for (int p = first; p < first + garment.panels[1].points; ++p) garment.placed[p].setZero();
  write_garment(obj_, garment);
  EXPECT_HOLDS(error_of([&] { read_garment(obj_); }),
               "panel '" + garment.panels[1].name + "' is placed with less than");
}

TEST_F(GarmentFile, FlatTrianglesMustNotLieOnEachOther) {
  const std::string corners =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\n";
  const std::string two = corners + "f 1/1 2/2 3/3\nf 2/2 4/4 3/3\n";
  write_file(json_, R"({"panels": [], "seams": []})");
  write_file(obj_, two + "f 2/2 3/3 1/1\n");
  EXPECT_HOLDS(error_of([&] { read_garment(obj_); }), "faces 0 and 2 lie on each other");
  write_file(obj_, two + "f 1/1 2/2 4/4\n");
  EXPECT_HOLDS(error_of([&] { read_garment(obj_); }), "faces 0 and 2 lie on each other");
  write_file(obj_, two);
  EXPECT_HOLDS(error_of([&] { read_garment(obj_); }), "covers 0 points");
}

// They were taken as they stood, and changed the drape without a word.
TEST_F(GarmentFile, LengthsThatTheMeshDoesNotHaveAreRefused) {
  write_garment(obj_, bag());
  EXPECT_HOLDS(message_after(json_, "\"edge_length\": 0.03", "\"edge_length\": 1e300"),
               "garment.json, edge_length: 1e+300 m does not fit the mesh");
  EXPECT_HOLDS(message_after(json_, "\"edge_length\": 0.03", "\"edge_length\": -0.03"),
               "does not fit the mesh");
  EXPECT_HOLDS(message_after(json_, "\"edge_length\": 0.03", "\"edge_length\": 3"),
               "does not fit the mesh");
  EXPECT_HOLDS(message_after(json_, "\"length_a\":", "\"length_a\":1"), "seam 0, length_a: ");
}

TEST_F(GarmentFile, AnAttachmentWithoutPointsIsLeftOutWithAWarning) {
  PanelMesh garment = bag();
  ASSERT_FALSE(garment.attachments.empty());
  const std::size_t sound = garment.attachments.size();
  garment.attachments.insert(garment.attachments.begin(), {"front.1", {}, {}});
  write_garment(obj_, garment);
  std::vector<std::string> warnings;
  EXPECT_EQ(read_garment(obj_, {}, &warnings).attachments.size(), sound);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_HOLDS(warnings[0], "attachment 0 (front.1) has no points and is left out");
}

TEST_F(GarmentFile, MutatedPairsAreReadOrRefusedButNeverCrash) {
  write_garment(obj_, bag());
  const std::string obj = read_file(obj_);
  const std::string json = read_file(json_);
  std::mt19937 random(5);
  const std::string alphabet = "0123456789{}[],:\"-. \nvftl/";
  int refused = 0;
  for (int round = 0; round < 1500; ++round) {
    std::string changed_obj = obj;
    std::string changed_json = json;
    std::string& text = random() % 3 == 0 ? changed_obj : changed_json;
    for (int e = 0; e < 3; ++e) {
      const std::size_t at = random() % text.size();
      if (random() % 2 == 0) {
        text[at] = alphabet[random() % alphabet.size()];
      } else {
        text.erase(at, 1 + random() % 3);
      }
    }
    write_file(obj_, changed_obj);
    write_file(json_, changed_json);
    try {
      const PanelMesh garment = read_garment(obj_);
      for (const Triangle& triangle : garment.triangles) {
        for (const int corner : triangle) {
          ASSERT_LT(static_cast<std::size_t>(corner), garment.flat.size());
        }
      }
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 300);
  EXPECT_LT(refused, 1500);
}

TEST_F(GarmentFile, ADressedGarmentSurvivesTheRoundTrip) {
  DressedGarment dressed;
  dressed.points = {{0, 0, 0.1}, {1, 0, 0}, {0, 1, 1.0 / 3}, {1, 1, 0}};
  dressed.triangles = {{0, 1, 2}, {2, 1, 3}};
  dressed.flat = {{0, 0}, {1, 0}, {0, 1}, {5, 1}, {6, 0}, {6, 1}};
  dressed.flat_triangles = {{0, 1, 2}, {3, 4, 5}};
  dressed.panels = {"front", "left sleeve"};
  dressed.panel_of_triangle = {0, 1};
  write_dressed(obj_, dressed);
  const DressedGarment back = read_dressed(obj_);
  EXPECT_EQ(back.points, dressed.points);
  EXPECT_EQ(back.triangles, dressed.triangles);
  EXPECT_EQ(back.flat, dressed.flat);
  EXPECT_EQ(back.flat_triangles, dressed.flat_triangles);
  EXPECT_EQ(back.panels, dressed.panels);
  EXPECT_EQ(back.panel_of_triangle, dressed.panel_of_triangle);
}

TEST_F(GarmentFile, ADressedGarmentIsWrittenForOtherPrograms) {
  DressedGarment dressed;
  dressed.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  dressed.triangles = {{0, 1, 2}, {2, 1, 3}};
  dressed.flat = {{0, 0}, {1, 0}, {0, 1}, {5, 1}, {6, 0}, {6, 1}};
  dressed.flat_triangles = {{0, 1, 2}, {3, 4, 5}};
  dressed.panels = {"front", "left sleeve"};
  dressed.panel_of_triangle = {0, 1};
  dressed.fabrics = {"denim", ""};
  write_dressed(obj_, dressed);
  const std::string text = read_file(obj_);
  EXPECT_HOLDS(text, "vn 0 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\n");
  EXPECT_HOLDS(text, "o front\nusemtl denim\nf 1/1/1 2/2/2 3/3/3\n");
  EXPECT_HOLDS(text, "o left sleeve\nusemtl cloth\nf 3/4/3 2/5/2 4/6/4\n");
}

TEST_F(GarmentFile, ADressedGarmentNeedsFlatCoordinatesAndPanels) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n";
  const auto message = [&](const std::string& faces) {
    write_file(obj_, points + faces);
    return error_of([&] { read_dressed(obj_); });
  };
  EXPECT_EQ(message("g p\nf 1/1 2/2 3/3\n"), "");
  EXPECT_HOLDS(message("g p\nf 1/1 2/2 3/3\nf 3/3 1/1 2/2\n"), "face 1 is face 0 again");
  EXPECT_HOLDS(message("f 1/1 2/2 3/3\n"), "belongs to no panel");
  EXPECT_HOLDS(message("g p\nf 1 2 3\n"), "no flat coordinates");
  EXPECT_HOLDS(message("g p\nf 1/1 2/2 4/3 3/3\n"), "is no triangle");
  EXPECT_HOLDS(message(""), "holds no face");
}

}  // namespace garment_file_test
}  // namespace toile
