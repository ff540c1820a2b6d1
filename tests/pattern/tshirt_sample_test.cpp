// The sample T-shirt against the sample mannequin: ease, shoulders and where it starts, from the
// drawing alone. What every sample has to hold is in sample_patterns_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "geometry/body/mannequin/mannequin.h"
#include "geometry/slice.h"
#include "geometry/surface_distance.h"
#include "pattern/file/pattern_file.h"

namespace toile {
namespace tshirt_sample_test {

const Mannequin& mannequin() {
  static const Mannequin made = make_mannequin({.edge_length = 0.012});
  return made;
}

double body_girth(const std::string& name) {
  for (const MannequinGirth& girth : mannequin().girths) {
    if (girth.name == name) return girth.measured;
  }
  ADD_FAILURE() << "the mannequin has no girth " << name;
  return 0;
}

struct Tshirt {
  Pattern pattern;
  std::vector<Remark> remarks;
};

const Tshirt& tshirt() {
  static const Tshirt read = [] {
    Tshirt shirt;
    shirt.pattern = read_pattern(TOILE_SOURCE_DIR "/samples/tshirt.json", shirt.remarks);
    return shirt;
  }();
  return read;
}

const EdgeCurve& curve(const EdgeRef& ref) {
  return tshirt().pattern.panels[ref.panel].edges[ref.edge].curve;
}

const Stitch& seam(const std::string& name) {
  for (const Stitch& stitch : tshirt().pattern.stitches) {
    if (stitch.name == name) return stitch;
  }
  throw std::runtime_error("the T-shirt has no seam " + name);
}

/// The part's panels together, measured across the drawing between the heights `low` and `high`.
double min_width(BodyPart part, double low, double high) {
  double sum = 0;
  for (const PatternPanel& panel : tshirt().pattern.panels) {
    if (panel.part != part) continue;
    double least = 1;
    for (double y = low; y <= high; y += 0.005) {
      double left = 1;
      double right = -1;
      for (const PatternEdge& edge : panel.edges) {
        const std::vector<Vec2> points = edge.curve.sample(64);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
          const Vec2& a = points[i];
          const Vec2& b = points[i + 1];
          if ((a.y() < y) == (b.y() < y)) continue;
          const double x = a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
          left = std::min(left, x);
          right = std::max(right, x);
        }
      }
      least = std::min(least, right - left);
    }
    sum += least;
  }
  return sum;
}

/// Edges of the torso's panels that are sewn to nothing and end above `height` in the drawing.
double open_edges_above(double height) {
  std::set<std::pair<int, int>> sewn;
  for (const Stitch& stitch : tshirt().pattern.stitches) {
    sewn.insert({stitch.a.panel, stitch.a.edge});
    sewn.insert({stitch.b.panel, stitch.b.edge});
  }
  double sum = 0;
  for (int p = 0; p < static_cast<int>(tshirt().pattern.panels.size()); ++p) {
    const PatternPanel& panel = tshirt().pattern.panels[p];
    if (panel.part != BodyPart::torso) continue;
    for (int e = 0; e < static_cast<int>(panel.edges.size()); ++e) {
      if (sewn.contains({p, e}) || panel.edges[e].curve.start().y() < height) continue;
      sum += panel.edges[e].curve.length();
    }
  }
  return sum;
}

/// The height of the shoulder at a distance from the body's middle.
double shoulder_height(double x) {
  double top = 0;
  for (const Section& section : slice(mannequin().surface, Vec3(x, 0, 0), Vec3::UnitX())) {
    for (const Vec3& point : section.points) top = std::max(top, point.y());
  }
  return top;
}

TEST(TshirtSample, LeftAndRightAreMirrorImages) {
  for (const char* name : {"shoulder", "side", "armhole, front", "armhole, back", "underarm"}) {
    EXPECT_NEAR(curve(seam(std::string("left ") + name).a).length(),
                curve(seam(std::string("right ") + name).a).length(), 1e-5)
        << name;
  }
}

TEST(TshirtSample, HasEaseAtBustHipAndNeck) {
  const double bust = min_width(BodyPart::torso, 0.30, 0.41) - body_girth("bust");
  EXPECT_GT(bust, 0.08);
  EXPECT_LT(bust, 0.13);
  EXPECT_GT(min_width(BodyPart::torso, 0.005, 0.05) - body_girth("hip"), 0.04);
  const double neck = open_edges_above(0.5) - body_girth("neck");
  EXPECT_GT(neck, 0.05);
  EXPECT_LT(neck, 0.16);
}

TEST(TshirtSample, SleeveGoesAroundTheArm) {
  // The widest place of the halves is where the underarm seam begins, square to the overarm seam.
  double width = 0;
  for (const EdgeRef& side : {seam("left underarm").a, seam("left underarm").b}) {
    width += std::max(std::abs(curve(side).start().y()), std::abs(curve(side).end().y()));
  }
  EXPECT_GT(width - body_girth("upper arm"), 0.06);
  EXPECT_LT(width - body_girth("upper arm"), 0.16);
}

// A seam that slopes more than the shoulder would hang on the shoulder's tip.
TEST(TshirtSample, ShoulderSlopesLikeTheBodyOrLess) {
  const auto degrees = [](double drop, double run) {
    return std::atan2(drop, run) * 180 / std::numbers::pi;
  };
  const double body = degrees(shoulder_height(0.09) - shoulder_height(0.19), 0.10);
  EXPECT_NEAR(body, 21, 1.5);
  for (const EdgeRef& side : {seam("left shoulder").a, seam("left shoulder").b}) {
    const Vec2 along = curve(side).end() - curve(side).start();
    const double drawn = degrees(std::abs(along.y()), std::abs(along.x()));
    EXPECT_LE(drawn, body + 0.5);
    EXPECT_GE(drawn, body - 4);
  }
}

TEST(TshirtSample, StartsClearOfTheBody) {
  const SurfaceDistance body(mannequin().surface);
  for (const PatternPanel& panel : tshirt().pattern.panels) {
    double nearest = 1;
    for (const PatternEdge& edge : panel.edges) {
      for (const Vec2& point : edge.curve.sample(40)) {
        nearest = std::min(nearest, body.closest_point(panel.place(point)).distance);
      }
    }
    EXPECT_GT(nearest, 0.005) << panel.name;
  }
}

// Pulled straight together, the sides of a shoulder seam meet above the shoulder, and those of a
// side seam below the arm.
TEST(TshirtSample, TorsoSeamsMeetOutsideTheBody) {
  const SurfaceDistance body(mannequin().surface);
  for (const char* name : {"left shoulder", "right shoulder", "left side", "right side"}) {
    const Stitch& stitch = seam(name);
    const PatternPanel& a = tshirt().pattern.panels[stitch.a.panel];
    const PatternPanel& b = tshirt().pattern.panels[stitch.b.panel];
    std::vector<Vec2> side_a = curve(stitch.a).sample(20);
    std::vector<Vec2> side_b = curve(stitch.b).sample(20);
    if ((a.place(side_a.front()) - b.place(side_b.front())).norm() >
        (a.place(side_a.front()) - b.place(side_b.back())).norm()) {
      std::reverse(side_b.begin(), side_b.end());
    }
    for (std::size_t i = 0; i < side_a.size(); ++i) {
      const Vec3 meeting = (a.place(side_a[i]) + b.place(side_b[i])) / 2;
      EXPECT_GT(body.closest_point(meeting).distance, 0) << name << ", point " << i;
    }
  }
}

}  // namespace tshirt_sample_test
}  // namespace toile
