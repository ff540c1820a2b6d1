#include "pattern/import/upright.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <string>

#include "geometry/angles.h"
#include "io/output_file.h"
#include "pattern/file/pattern_file.h"
#include "pattern/import/imported_pattern.h"
#include "pattern/import/svg_pieces.h"
#include "pattern/seams/find_seams.h"
#include "tests/pattern/samples.h"

namespace toile {
namespace upright_test {

using samples::real_pattern;

PieceShape shape(const std::vector<Vec2>& outline, double grain_degrees) {
  PieceShape made;
  made.outline = outline;
  const double angle = to_radians(90 + grain_degrees);
  made.grain = PieceLine{Vec2::Zero(), Vec2(std::cos(angle), std::sin(angle))};
  return made;
}

std::vector<Vec2> box(double width, double height) {
  return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

/// A front: its neck and its armholes are curved, its hem is wider.
std::vector<Vec2> front() {
  std::vector<Vec2> points = {{-0.3, 0},  {0.3, 0},    {0.25, 0.4},
                              {0.2, 0.5}, {0.2, 0.62}, {0.08, 0.65}};
  for (int i = 1; i < 12; ++i) {
    const double angle = -std::numbers::pi * i / 12;
    points.emplace_back(0.08 * std::cos(angle), 0.65 + 0.1 * std::sin(angle));
  }
  for (const Vec2& point : {Vec2(-0.08, 0.65), {-0.2, 0.62}, {-0.2, 0.5}, {-0.25, 0.4}}) {
    points.push_back(point);
  }
  return points;
}

std::vector<double> degrees(const UprightTurns& upright) {
  std::vector<double> all;
  for (const double turn : upright.turns) all.push_back(to_degrees(turn));
  return all;
}

void expect_turns(const std::vector<PieceShape>& shapes, const std::vector<double>& expected) {
  const std::vector<double> turns = degrees(upright_turns(shapes));
  ASSERT_EQ(turns.size(), expected.size());
  for (std::size_t i = 0; i < turns.size(); ++i) {
    EXPECT_NEAR(std::remainder(turns[i] - expected[i], 360), 0, 1e-6) << i << ": " << turns[i];
  }
}

TEST(Upright, TheGrainOfMostOfTheDrawingIsTurnedUpright) {
  expect_turns({shape(box(0.4, 0.6), 0), shape(box(0.2, 0.1), 0)}, {0, 0});
  expect_turns({shape(box(0.6, 0.4), 90), shape(box(0.2, 0.1), 90)}, {90, 90});
  // A piece that lies askew is turned on by itself.
  expect_turns({shape(box(0.4, 0.6), 0), shape(box(0.2, 0.1), 20)}, {0, -20});
  PieceShape ungrained = shape(box(0.2, 0.1), 0);
  ungrained.grain.reset();
  expect_turns({shape(box(0.6, 0.4), -70), ungrained}, {70, 70});
  EXPECT_FALSE(upright_turns({ungrained}).has_grain);
}

PieceShape bare(std::vector<Vec2> outline, double degrees = 0) {
  PieceShape made;
  const Eigen::Rotation2Dd turn(to_radians(degrees));
  for (Vec2& point : outline) point = turn * point;
  made.outline = std::move(outline);
  return made;
}

/// A half: its fold is on the left, its side leans.
std::vector<Vec2> half() { return {{0, 0}, {0.3, 0}, {0.25, 0.45}, {0.1, 0.6}, {0, 0.55}}; }

TEST(Upright, WithoutGrainLinesMirrorImagesAndFoldsTellTheWarp) {
  for (const double degrees : {0., 37., 90., 180., 270.}) {
    expect_turns({bare(front(), degrees), bare(half(), degrees), bare(box(0.4, 0.1), degrees)},
                 {-degrees, -degrees, -degrees});
  }
  const UprightTurns told = upright_turns({bare(front(), 90)});
  EXPECT_FALSE(told.has_grain);
  EXPECT_TRUE(told.by_shape && told.end_by_shape && !told.nested);
  // Any end of a band will do: it stays.
  expect_turns({bare(box(0.4, 0.1)), bare(box(0.2, 0.1))}, {0, 0});
}

TEST(Upright, NestedPiecesWithoutGrainLinesAreTurnedOneByOne) {
  const UprightTurns told = upright_turns({bare(front(), 30), bare(half(), -20), bare(half(), 77)});
  EXPECT_TRUE(told.nested);
  const std::vector<double> turns = degrees(told);
  EXPECT_NEAR(std::remainder(turns[0] + 30, 360), 0, 0.01);
  // Halves do not always tell which end is up.
  EXPECT_NEAR(std::remainder(turns[1] - 20, 180), 0, 0.01);
  EXPECT_NEAR(std::remainder(turns[2] + 77, 180), 0, 0.01);
}

TEST(Upright, PiecesOnTheBiasAndAcrossTheGrainAreTurnedAsTheRest) {
  const std::vector<PieceShape> shapes = {shape(box(0.6, 0.4), 90), shape(box(0.3, 0.1), 45),
                                          shape(box(0.3, 0.1), 0), shape(box(0.3, 0.1), 88)};
  expect_turns(shapes, {90, 90, 90, 92});
  EXPECT_EQ(upright_turns(shapes).off_grain, (std::vector<bool>{false, true, true, false}));
  // Where all is cut on the bias, edges are turned upright: the longer way.
  expect_turns({shape(box(0.4, 0.6), 45)}, {0});
  expect_turns({turned_shape(shape(box(0.4, 0.6), 45), to_radians(30))}, {-30});
  expect_turns({shape(box(0.6, 0.4), -45)}, {90});
}

TEST(Upright, ShapesTellTheUpperEnd) {
  for (const double turned : {0.0, 37.0, 90.0, 180.0, 270.0}) {
    const PieceShape drawn = turned_shape(shape(front(), 0), to_radians(turned));
    expect_turns({drawn}, {-turned});
    EXPECT_TRUE(upright_turns({drawn}).end_by_shape);
  }
  EXPECT_FALSE(upright_turns({shape(box(0.4, 0.6), 0)}).end_by_shape);
}

/// The drawing as a whole, turned or mirrored.
PieceDrawing changed(PieceDrawing drawing, double degrees, bool mirrored) {
  Eigen::Matrix2d change = Eigen::Rotation2Dd(to_radians(degrees)).toRotationMatrix();
  if (mirrored) change.col(0) = -change.col(0);
  const auto point = [&](Vec2& at) { at = change * at; };
  const auto path = [&](PiecePath& curves) {
    for (EdgeCurve& curve : curves) {
      const std::array<Vec2, 4> p = curve.cubics().front();
      curve = curve.straight()
                  ? EdgeCurve::line(change * p[0], change * p[3])
                  : EdgeCurve::cubic(change * p[0], change * p[1], change * p[2], change * p[3]);
    }
  };
  for (Piece& piece : drawing.pieces) {
    path(piece.outline);
    for (Vec2& corner : piece.corners) point(corner);
    for (PieceNotch& notch : piece.notches) {
      point(notch.at);
      notch.angle.reset();
    }
    for (PiecePath& line : piece.internal_lines) path(line);
    for (PiecePath& loop : piece.cut_outs) path(loop);
    for (Vec2& hole : piece.drill_holes) point(hole);
    for (auto* line : {&piece.grain, &piece.fold}) {
      if (!*line) continue;
      point((*line)->from);
      point((*line)->to);
    }
  }
  return drawing;
}

/// A pattern as written and read again, and its seams: lengths of both sides, and their edges.
struct Sewn {
  ImportedPattern made;
  std::set<std::string> edges;
  std::multiset<int> tenths;  ///< millimetres, of both sides of a seam
};

Sewn sewn(const PieceDrawing& drawing) {
  Sewn result;
  std::vector<Remark> remarks;
  result.made = import_pieces(drawing, {}, remarks);
  const Pattern pattern =
      parse_pattern(readable_json(pattern_json(result.made)), "a.json", remarks);
  FindSeamsOptions options;
  options.drawn_walk = true;
  options.certain = false;
  for (const FoundSeam& seam : find_seams(pattern, options).seams) {
    std::set<std::string> sides;
    for (const EdgeRef& side : {seam.a, seam.b}) {
      sides.insert(pattern.panels[static_cast<std::size_t>(side.panel)].name + ":" +
                   std::to_string(side.edge));
    }
    result.edges.insert(*sides.begin() + " " + *sides.rbegin());
    result.tenths.insert(static_cast<int>(std::lround(1e3 * (seam.length_a + seam.length_b))));
  }
  return result;
}

TEST(Upright, TurnedDrawingsGiveTheSamePanelsAndSeams) {
  // Its shapes tell which end is up. Where they don't, half a turn stays open.
  for (const char* name : {"brian.svg"}) {
    const auto path = real_pattern(std::string("../freesewing/") + name);
    if (!path) GTEST_SKIP() << name << " is not in ../shared/data or TOILE_DATA";
    const PieceDrawing drawing = svg_pieces(read_file(*path), name, {});
    const Sewn straight = sewn(drawing);
    EXPECT_GT(straight.edges.size(), 5u);
    for (const double turned : {37.0, 90.0, 180.0, 270.0}) {
      const Sewn other = sewn(changed(drawing, turned, false));
      EXPECT_EQ(other.edges, straight.edges) << name << " turned by " << turned;
      ASSERT_EQ(other.made.panels.size(), straight.made.panels.size());
      for (std::size_t p = 0; p < other.made.panels.size(); ++p) {
        const ImportedPanel& a = straight.made.panels[p];
        const ImportedPanel& b = other.made.panels[p];
        EXPECT_EQ(a.name, b.name);
        ASSERT_EQ(a.outline.vertices.size(), b.outline.vertices.size()) << name << turned;
        for (std::size_t v = 0; v < a.outline.vertices.size(); ++v) {
          const Vec2 apart = a.outline.vertices[v] - a.moved - b.outline.vertices[v] + b.moved;
          EXPECT_LT(apart.norm(), 1e-6) << name << turned << a.name << v;
        }
      }
    }
    const Sewn mirrored = sewn(changed(drawing, 0, true));
    EXPECT_EQ(mirrored.tenths, straight.tenths) << name;
  }
}

}  // namespace upright_test
}  // namespace toile
