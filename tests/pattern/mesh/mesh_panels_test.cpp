#include "pattern/mesh/mesh_panels.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "geometry/angles.h"
#include "geometry/polygon.h"
#include "geometry/triangulate.h"
#include "pattern/constants.h"
#include "pattern/mesh/doubled_triangles.h"
#include "pattern/mesh/nesting.h"
#include "pattern/mesh/seam_orientation.h"
#include "tests/pattern/samples.h"
#include "tests/pattern/sewn.h"

namespace toile {
namespace mesh_panels_test {

using samples::curved;
using samples::file;
using samples::polygon;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

PanelMesh mesh(const Pattern& pattern, const MeshSettings& settings) {
  std::vector<Remark> remarks;
  return mesh_panels(pattern, settings, remarks);
}

/// Edges of a panel's triangles that only one triangle has.
std::vector<std::array<int, 2>> border_edges(const PanelMesh& garment, const MeshedPanel& panel) {
  std::map<std::array<int, 2>, int> count;
  for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
    const Triangle& triangle = garment.triangles[at(t)];
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = triangle[k];
      const int b = triangle[(k + 1) % 3];
      ++count[{std::min(a, b), std::max(a, b)}];
    }
  }
  std::vector<std::array<int, 2>> border;
  for (const auto& [edge, triangles] : count) {
    EXPECT_LE(triangles, 2);
    if (triangles == 1) border.push_back(edge);
  }
  return border;
}

double area_of(const PanelMesh& garment, const MeshedPanel& panel) {
  double area = 0;
  for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
    const auto& [a, b, c] = garment.triangles[at(t)];
    const Vec2 u = garment.flat[at(b)] - garment.flat[at(a)];
    const Vec2 v = garment.flat[at(c)] - garment.flat[at(a)];
    EXPECT_GT(u.x() * v.y() - u.y() * v.x(), 0);
    area += (u.x() * v.y() - u.y() * v.x()) / 2;
  }
  return area;
}

double drawn_area(const PatternPanel& panel) {
  std::vector<Vec2> outline;
  for (const OutlineStep& step : panel.outline) {
    std::vector<Vec2> points = panel.edges[at(step.edge)].curve.sample(2000);
    if (!step.forward) std::reverse(points.begin(), points.end());
    outline.insert(outline.end(), points.begin(), points.end() - 1);
  }
  return std::abs(signed_area(outline));
}

double distance_to_outline(const PatternPanel& panel, const Vec3& placed) {
  double least = 1e300;
  for (const PatternEdge& edge : panel.edges) {
    const int steps = edge.curve.straight() ? 1 : 4000;
    const std::vector<Vec2> points = edge.curve.sample(steps);
    for (int i = 0; i < steps; ++i) {
      const Vec3 a = panel.place(points[at(i)]);
      const Vec3 run = panel.place(points[at(i + 1)]) - a;
      const double f = std::clamp((placed - a).dot(run) / run.squaredNorm(), 0.0, 1.0);
      least = std::min(least, (placed - a - f * run).norm());
    }
  }
  return least;
}

/// Everything that holds of any meshed pattern.
void expect_sound(const Pattern& pattern, const PanelMesh& garment, double smallest) {
  EXPECT_EQ(nesting_problem(garment), std::nullopt);
  EXPECT_GE(smallest_angle(garment.flat, garment.triangles), to_radians(smallest));
  ASSERT_EQ(garment.panels.size(), pattern.panels.size());
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const MeshedPanel& panel = garment.panels[p];
    SCOPED_TRACE(panel.name);
    const auto border = border_edges(garment, panel);
    // Points, edges and triangles of a disc, so no hole and no loose point.
    EXPECT_EQ(panel.triangles, 2 * panel.points - 2 - static_cast<int>(border.size()));
    const double drawn = drawn_area(pattern.panels[p]);
    EXPECT_NEAR(area_of(garment, panel), drawn, 1e-3 * drawn);
    // Mirrored or not, the flat panel has the placed one's measures.
    for (int i = panel.first_point + 1; i < panel.first_point + panel.points; ++i) {
      const auto first = at(panel.first_point);
      EXPECT_NEAR((garment.flat[at(i)] - garment.flat[first]).norm(),
                  (garment.placed[at(i)] - garment.placed[first]).norm(), 1e-12);
    }
    for (std::size_t i = 0; i < border.size(); i += 7) {
      EXPECT_LT(distance_to_outline(pattern.panels[p], garment.placed[at(border[i][0])]), 1e-6);
    }
  }
  for (const MeshedSeam& seam : garment.seams) {
    ASSERT_EQ(seam.a.size(), seam.b.size());
    const auto measured = [&](const std::vector<int>& side) {
      double length = 0;
      for (std::size_t i = 1; i < side.size(); ++i) {
        length += (garment.flat[at(side[i])] - garment.flat[at(side[i - 1])]).norm();
      }
      return length;
    };
    EXPECT_NEAR(measured(seam.a), seam.length_a, 2e-3 * seam.length_a);
    EXPECT_NEAR(measured(seam.b), seam.length_b, 2e-3 * seam.length_b);
  }
}

TEST(MeshPanels, ABagIsSoundAtEveryNumberOfSubdivisions) {
  const Pattern pattern = samples::parse(samples::bag);
  for (int subdivisions = 0; subdivisions <= max_subdivisions; ++subdivisions) {
    SCOPED_TRACE(subdivisions);
    const PanelMesh garment = mesh(pattern, {0.01, subdivisions});
    EXPECT_EQ(garment.subdivisions, subdivisions);
    expect_sound(pattern, garment, 20);
    for (int level = 0; level <= subdivisions; ++level) {
      EXPECT_EQ(samples::sewn_fault(garment, level), "");
    }
  }
}

TEST(MeshPanels, AWideSkirtGetsACoarserCoarsestMesh) {
  const auto subdivisions = [](const std::string& metres) {
    const Pattern pattern = samples::parse(
        file(polygon("skirt", "[0,0],[" + metres + "00,0],[" + metres + "00,200],[0,200]"), ""));
    return mesh(pattern, {0.02}).subdivisions;
  };
  // A metre has 2,900 triangles of 4 cm, and four have 11,500.
  EXPECT_EQ(subdivisions("1"), 1);
  EXPECT_EQ(subdivisions("4"), 2);
}

TEST(MeshPanels, NoBorderPointIsAddedAfterPairing) {
  const Pattern pattern = samples::parse(samples::bag);
  const PanelMesh garment = mesh(pattern, {0.01, 2});
  for (const MeshedPanel& panel : garment.panels) {
    // Three of the four edges are sewn; the open top is cut by its own length, 30 cm.
    std::size_t steps = 0;
    for (const MeshedSeam& seam : garment.seams) steps += seam.a.size() - 1;
    const std::size_t top = 4 * static_cast<std::size_t>(std::ceil(30.0 / 4 - 0.15));
    EXPECT_EQ(border_edges(garment, panel).size(), steps + top);
  }
}

TEST(MeshPanels, TheLongerSideOfASeamDecides) {
  const Pattern pattern = samples::parse(
      file(polygon("a", "[0,0],[20,0],[20,20],[0,20]") + "," +
               polygon("b", "[0,0],[20,0],[20,40],[0,40]", R"("translation": [25,0,0])"),
           R"([{"panel":"a","edge":1},{"panel":"b","edge":3}])"));
  const PanelMesh garment = mesh(pattern, {0.01, 0});
  EXPECT_EQ(garment.seams[0].a.size(), 41u);
  // Equal fractions of each side's own length.
  const auto& seam = garment.seams[0];
  for (std::size_t i = 0; i < seam.a.size(); ++i) {
    EXPECT_NEAR(garment.placed[at(seam.b[i])].y(), 2 * garment.placed[at(seam.a[i])].y(), 1e-12);
  }
}

TEST(MeshPanels, SeamPointsMeetAlongTheWholeSeam) {
  const PanelMesh garment = mesh(samples::parse(samples::bag), {0.01, 2});
  for (const MeshedSeam& seam : garment.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      const Vec3 gap = garment.placed[at(seam.a[i])] - garment.placed[at(seam.b[i])];
      // 40 cm apart in depth, and up to a centimetre where the sides differ in length.
      EXPECT_NEAR(gap.z(), 0.4, 1e-12);
      EXPECT_LT(std::hypot(gap.x(), gap.y()), 0.0101);
    }
  }
  EXPECT_EQ(garment.seams[0].name, "front.1-back.2");
  EXPECT_EQ(garment.seams[1].name, "left side");
}

TEST(MeshPanels, PlacedTrianglesFaceOutOfTheGarment) {
  const PanelMesh garment = mesh(samples::parse(samples::bag), {0.02, 1});
  for (const Triangle& t : garment.triangles) {
    const Vec3 normal = (garment.placed[at(t[1])] - garment.placed[at(t[0])])
                            .cross(garment.placed[at(t[2])] - garment.placed[at(t[0])]);
    EXPECT_GT(normal.z() * garment.placed[at(t[0])].z(), 0);
  }
}

TEST(MeshPanels, BorderPointsLieOnTheCurveOnEveryLevel) {
  const Pattern pattern =
      samples::parse(file(curved(R"({"type": "circle", "params": [12, 0, 0]})")));
  const PanelMesh garment = mesh(pattern, {0.01, 2});
  expect_sound(pattern, garment, 20);
  // The arc from (20,20) to (0,20) bulges left, down into the square: its centre is above.
  const Vec2 centre(0.1, 0.2 + std::sqrt(0.12 * 0.12 - 0.1 * 0.1));
  int on_arc = 0;
  for (const auto& [a, b] : border_edges(garment, garment.panels[0])) {
    for (const int i : {a, b}) {
      on_arc += std::abs((garment.flat[at(i)] - centre).norm() - 0.12) < 1e-12;
    }
  }
  EXPECT_GT(on_arc, 40);
}

TEST(MeshPanels, DartsNarrowStripsAndShortEdgesAreMeshed) {
  const std::vector<std::string> panels = {
      // A dart whose edges share the tip, and are sewn to each other.
      polygon("dart", "[0,0],[40,0],[40,30],[21,30],[20,15],[19,30],[0,30]"),
      // A waistband 2 cm wide; a strip narrower than the edge length; an edge of 4 mm.
      polygon("band", "[0,0],[70,0],[70,2],[0,2]"),
      polygon("tape", "[0,0],[30,0],[30,0.6],[0,0.6]"),
      polygon("nick", "[0,0],[30,0],[30,20],[15,20],[14.6,20.1],[0,20]"),
      // A sharp corner of about 11 degrees.
      polygon("godet", "[0,0],[40,0],[40,8]"),
  };
  for (const std::string& panel : panels) {
    SCOPED_TRACE(panel.substr(0, 8));
    const Pattern pattern = samples::parse(file(panel));
    std::vector<Remark> remarks;
    const PanelMesh garment = mesh_panels(pattern, {0.01, -1}, remarks);
    expect_sound(pattern, garment, 4);
  }
  const Pattern dart =
      samples::parse(file(panels[0], R"([{"panel":"dart","edge":3},{"panel":"dart","edge":4}])"));
  const PanelMesh garment = mesh(dart, {0.01, -1});
  EXPECT_EQ(samples::sewn_fault(garment, 0), "");
  EXPECT_EQ(samples::sewn_fault(garment, 2), "");
  // Both sides hold the one point at the tip.
  EXPECT_EQ(garment.seams[0].a.back(), garment.seams[0].b.back());
  EXPECT_NE(garment.seams[0].a.front(), garment.seams[0].b.front());
}

TEST(MeshPanels, APanelOfTwoArcsIsADisc) {
  const Pattern pattern = samples::parse(file(R"("disc": {"vertices": [[0,0],[20,0]], "edges": [
      {"endpoints": [0,1], "curvature": {"type": "circle", "params": [10,0,1]}},
      {"endpoints": [1,0], "curvature": {"type": "circle", "params": [10,0,1]}}]})"));
  const PanelMesh garment = mesh(pattern, {0.005, 2});
  expect_sound(pattern, garment, 25);
  EXPECT_NEAR(area_of(garment, garment.panels[0]), std::numbers::pi * 0.01,
              1e-3 * std::numbers::pi * 0.01);
}

TEST(MeshPanels, WhatACoarseLevelCannotShowUsesFewerSubdivisionsAndSaysSo) {
  // The tip of a notch comes within 4 mm of an arc; chords of 8 cm would cut it off.
  const Pattern pattern = samples::parse(file(
      R"("notched": {"vertices": [[0,0],[0,20],[-20,20],[-20,12],[4.3,10],[-20,8],[-20,0]],
        "edges": [{"endpoints": [0,1], "curvature": {"type": "circle", "params": [13,0,1]}},
          {"endpoints": [1,2]}, {"endpoints": [2,3]}, {"endpoints": [3,4]}, {"endpoints": [4,5]},
          {"endpoints": [5,6]}, {"endpoints": [6,0]}]})"));
  std::vector<Remark> remarks;
  check_pattern(pattern, remarks);
  ASSERT_TRUE(remarks.empty());
  const PanelMesh garment = mesh_panels(pattern, {0.01, 3}, remarks);
  EXPECT_EQ(garment.subdivisions, 2);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_EQ(remarks[0].text,
            "test.json: panel 'notched' has an outline that crosses itself on the coarser level; "
            "2 subdivisions are used");
  expect_sound(pattern, garment, 4);
  // At 8 cm and no finer level, there is nothing to fall back to.
  EXPECT_HOLDS(samples::error_of([&] {
                 mesh(pattern, {0.08, 0});
               }),
               "panel 'notched': has an outline that crosses itself at this edge length; ask for a "
               "shorter --edge-length");
}

TEST(MeshPanels, SharpCornersSewnTogetherEncloseCloth) {
  // Two triangles with a corner of 22 degrees, sewn along both sides of it.
  const std::string triangle = "[0,0],[40,0],[40,16]";
  const Pattern pattern =
      samples::parse(file(polygon("front", triangle, R"("translation": [0,0,10])") + "," +
                              polygon("back", triangle, R"("translation": [0,0,-10])"),
                          R"([{"panel":"front","edge":0},{"panel":"back","edge":0}],
              [{"panel":"front","edge":2},{"panel":"back","edge":2}])"));
  for (int subdivisions = 1; subdivisions <= 2; ++subdivisions) {
    SCOPED_TRACE(subdivisions);
    const PanelMesh garment = mesh(pattern, {0.01, subdivisions});
    EXPECT_TRUE(doubled_triangles(garment).empty());
    EXPECT_EQ(samples::sewn_fault(garment, 0), "");
    expect_sound(pattern, garment, 5);
  }
}

// With one step, the triangle on edge 4 has two corners in one node.
TEST(MeshPanels, AnEdgeWhoseEndsAreSewnTogetherClosesLikeADart) {
  const std::string text =
      file(polygon("p", "[0,0],[40,0],[40,30],[21,30],[20.5,15],[19.5,15],[19,30],[0,30]"),
           R"([{"panel":"p","edge":3},{"panel":"p","edge":5},{"reversed": true}])");
  for (const double edge_length : {0.005, 0.015, 0.03}) {
    std::vector<Remark> remarks;
    const PanelMesh garment = mesh_panels(samples::parse(text), {edge_length}, remarks);
    for (int coarser = 0; coarser <= garment.subdivisions; ++coarser) {
      EXPECT_EQ(samples::sewn_fault(garment, coarser), "") << edge_length << " " << coarser;
    }
  }
}

TEST(MeshPanels, AnEdgeThatAsksForNeedlesIsNamed) {
  const Pattern pattern =
      samples::parse(file(polygon("sound", "[0,0],[20,0],[20,20],[0,20]") + "," +
                          polygon("sharp", "[0,0],[20,0],[20,20],[19.7,0.3],[0,0.3]")));
  std::vector<Remark> remarks;
  const std::string error = samples::error_of([&] { mesh_panels(pattern, {0.02, -1}, remarks); });
  EXPECT_HOLDS(error, "test.json: panel 'sharp', edge ");
  EXPECT_HOLDS(error, ": gets triangles like needles at this edge length");
  // Edges 1 and 2 meet at one degree.
  EXPECT_TRUE(error.find("edge 1:") != std::string::npos ||
              error.find("edge 2:") != std::string::npos)
      << error;
}

TEST(MeshPanels, StepsAreShorterWhereTheChordsOfACurveMakeNeedles) {
  // One step of 20 cm leaves 2.6 degrees between edges 0 and 1. Two leave more, as edge 1 bulges.
  const std::string panel = R"("p": {"vertices": [[0,0],[20,0],[0,0.9]], "edges": [
      {"endpoints": [0,1]},
      {"endpoints": [1,2], "curvature": {"type": "quadratic", "params": [[0.5, -0.1]]}},
      {"endpoints": [2,0]}]})";
  const PanelMesh garment = mesh(samples::parse(file(panel)), {0.25, 0});
  EXPECT_GT(smallest_angle(garment.flat, garment.triangles), needle_angle);
  EXPECT_GT(garment.triangles.size(), 1U);
}

TEST(MeshPanels, ShorterEdgesForTheAskingAndAMessageForTooMany) {
  const Pattern pattern = samples::parse(samples::bag);
  const std::size_t coarse = mesh(pattern, {0.02, -1}).triangles.size();
  const std::size_t fine = mesh(pattern, {0.01, -1}).triangles.size();
  EXPECT_GT(static_cast<double>(fine), 3 * static_cast<double>(coarse));
  EXPECT_LT(static_cast<double>(fine), 5 * static_cast<double>(coarse));
  EXPECT_HOLDS(samples::error_of([&] { mesh(pattern, {1e-5, -1}); }), "million triangles");
  EXPECT_HOLDS(samples::error_of([&] {
                 mesh(pattern, {1e-300, -1});
               }),
               "more than a million million");
}

TEST(MeshPanels, EdgesHaveAboutTheLengthAskedFor) {
  const PanelMesh garment = mesh(samples::parse(samples::bag), {0.01, -1});
  double sum = 0;
  double longest = 0;
  int count = 0;
  for (const Triangle& t : garment.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double length = (garment.flat[at(t[(k + 1) % 3])] - garment.flat[at(t[k])]).norm();
      sum += length;
      longest = std::max(longest, length);
      ++count;
    }
  }
  EXPECT_NEAR(sum / count, 0.01, 0.001);
  EXPECT_LT(longest, 0.016);
}

TEST(MeshPanels, TheSameInputGivesTheSameBits) {
  const Pattern pattern = samples::parse(samples::bag);
  const PanelMesh one = mesh(pattern, {0.01, -1});
  const PanelMesh two = mesh(pattern, {0.01, -1});
  EXPECT_EQ(one.flat, two.flat);
  EXPECT_EQ(one.placed, two.placed);
  EXPECT_EQ(one.triangles, two.triangles);
}

TEST(MeshPanels, TheGrainIsMirroredWithItsPanel) {
  const std::string clockwise = "[0,0],[0,20],[20,20],[20,0]";
  const Pattern pattern = samples::parse(file(polygon("p", clockwise, R"("grain": 30)")));
  EXPECT_DOUBLE_EQ(mesh(pattern, {0.02, 0}).panels[0].grain, to_radians(-30));
}

TEST(MeshPanels, TheRealPatternsAreSound) {
  for (const std::string name : {"shirt_mean.json", "dress_pencil.json"}) {
    SCOPED_TRACE(name);
    const auto path = samples::real_pattern(name);
    if (!path) GTEST_SKIP() << name << " is not in ../shared/data or TOILE_DATA";
    std::vector<Remark> remarks;
    const Pattern pattern = read_pattern(*path, remarks);
    const PanelMesh garment = mesh(pattern, {0.01, -1});
    EXPECT_EQ(garment.subdivisions, 2);
    expect_sound(pattern, garment, 20);
    for (int level = 0; level <= 2; ++level) EXPECT_EQ(samples::sewn_fault(garment, level), "");
    if (name == "shirt_mean.json") {
      EXPECT_GE(garment.flat.size(), 8000u);
      EXPECT_LE(garment.flat.size(), 12000u);
    }
    // GarmentCode's own rule, the end of one edge to the start of the other, is what the placed
    // end points say too.
    const Orientation orientation = orient(pattern, remarks);
    for (const bool reversed : orientation.reversed) EXPECT_TRUE(reversed);
    for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
      const bool front = pattern.panels[p].translation.z() > 0;
      EXPECT_EQ(orientation.mirrored[p], !front) << pattern.panels[p].name;
    }
  }
}

TEST(MeshPanels, HoldsEdgesThatGarmentCodeLabelsForIt) {
  const std::string skirt = R"("skirt": {"translation": [0,0,0],
      "vertices": [[0,0],[20,0],[20,20],[10,20],[0,20]],
      "edges": [{"endpoints": [0,1]}, {"endpoints": [1,2]},
                {"endpoints": [2,3], "label": "lower_interface"},
                {"endpoints": [3,4], "label": "left_collar"}, {"endpoints": [4,0]}]})";
  std::vector<Remark> remarks;
  const PanelMesh garment = mesh(parse_pattern(file(skirt), "test.json", remarks), {0.05});
  ASSERT_EQ(garment.attachments.size(), 2u);
  EXPECT_EQ(garment.attachments[0].how.to, AttachedTo::height);
  EXPECT_TRUE(garment.attachments[0].how.only_if_it_slips);
  EXPECT_EQ(garment.attachments[1].how.to, AttachedTo::side);
  EXPECT_FALSE(garment.attachments[1].how.only_if_it_slips);
  for (const int point : garment.attachments[0].points) {
    EXPECT_DOUBLE_EQ(garment.flat[at(point)].y(), 0.2);
    EXPECT_GE(garment.flat[at(point)].x(), 0.1);
  }
}

// GarmentCode's jumpsuit has such an edge. dress refused the garment, for it had no points.
TEST(MeshPanels, ALabelledEdgeThatIsMergedIsNotHeldAndSaid) {
  const std::string skirt = R"("skirt": {"translation": [0,0,0],
      "vertices": [[0,0],[20,0],[20,20],[0.02,20],[0,20]],
      "edges": [{"endpoints": [0,1]}, {"endpoints": [1,2]}, {"endpoints": [2,3]},
                {"endpoints": [3,4], "label": "lower_interface"}, {"endpoints": [4,0]}]})";
  std::vector<Remark> remarks;
  Pattern pattern = parse_pattern(file(skirt), "test.json", remarks);
  remarks.clear();
  EXPECT_TRUE(mesh_panels(pattern, {0.05}, remarks).attachments.empty());
  const auto said = std::ranges::count_if(remarks, [](const Remark& remark) {
    return remark.warning && remark.text ==
                                 "test.json: panel 'skirt', edge 3 is labelled 'lower_interface', "
                                 "but too short to be held while the garment is dressed";
  });
  EXPECT_EQ(said, 1);
}

}  // namespace mesh_panels_test
}  // namespace toile
