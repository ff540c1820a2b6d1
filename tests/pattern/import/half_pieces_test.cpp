#include "pattern/import/half_pieces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/polygon.h"
#include "tests/pattern/samples.h"

namespace toile {
namespace half_pieces_test {

/// A front's half, folded at x = 0: its side slopes, its neckline is cut low.
const std::vector<Vec2> half_front = {{0, 0}, {0.26, 0}, {0.22, 0.4}, {0.1, 0.45}, {0, 0.35}};

PieceShape shape(const std::vector<Vec2>& outline, double turned = 0) {
  PieceShape made;
  const Eigen::Rotation2Dd turn(turned);
  for (const Vec2& point : outline) made.outline.push_back(turn * point);
  made.grain = PieceLine{turn * Vec2(0.05, 0), turn * Vec2(0.05, 0.2)};
  return made;
}

std::optional<int> fold_of(const PieceShape& piece) {
  return likely_fold(piece, edges_of(piece, {}, "piece"));
}

TEST(HalfPieces, AreFoldedAtTheStraightEdgeAlongTheGrain) {
  for (const double turned : {0.0, 0.6, 2.0}) {
    const PieceShape piece = shape(half_front, turned);
    const auto fold = fold_of(piece);
    ASSERT_TRUE(fold) << turned;
    const PieceLine line = fold_along(edges_of(piece, {}, "piece"), *fold, "piece");
    EXPECT_NEAR((line.to - line.from).norm(), 0.35, 1e-9);
  }
}

TEST(HalfPieces, WithoutAGrainTheWarpIsUpright) {
  PieceShape piece = shape(half_front);
  piece.grain.reset();
  EXPECT_TRUE(fold_of(piece));
  piece = shape(half_front, 0.6);
  piece.grain.reset();
  EXPECT_FALSE(fold_of(piece));
}

TEST(HalfPieces, WholePiecesAreNone) {
  // A rectangle is its own mirror image. Of the other, part lies on either side of each line.
  EXPECT_FALSE(fold_of(shape({{0, 0}, {0.3, 0}, {0.3, 0.4}, {0, 0.4}})));
  EXPECT_FALSE(fold_of(shape({{0, 0}, {0.3, 0.1}, {0.3, 0.3}, {0.4, 0.5}, {0.1, 0.6}})));
}

TEST(HalfPieces, OnlyAStraightEdgeIsAFold) {
  PieceShape piece = shape(half_front);
  std::vector<Vec2>& outline = piece.outline;
  for (int i = 1; i < 20; ++i) {
    const double share = i / 20.0;
    outline.emplace_back(0.03 * std::sin(share * M_PI), 0.35 * (1 - share));
  }
  const EdgedOutline edges = edges_of(piece, {}, "piece");
  EXPECT_HOLDS(
      samples::error_of([&] { fold_along(edges, static_cast<int>(edges.edges.size()), "piece"); }),
      "has no edge");
  int curved = 0;
  for (std::size_t i = 0; i < edges.edges.size(); ++i) {
    curved += edges.edges[i].curves.front().straight ? 0 : 1;
    if (edges.edges[i].curves.front().straight) continue;
    EXPECT_HOLDS(samples::error_of([&] { fold_along(edges, static_cast<int>(i), "piece"); }),
                 "is curved");
  }
  EXPECT_EQ(curved, 1);
}

TEST(HalfPieces, NamesMayHaveColons) {
  const std::vector<std::string> names = {"front", "back:2", "back"};
  EXPECT_EQ(named_piece("front", names, "--unfold").piece, 0u);
  EXPECT_EQ(named_piece("front:12", names, "--unfold").edge, 12);
  EXPECT_EQ(named_piece("back:2", names, "--unfold").piece, 1u);
  EXPECT_EQ(named_piece("back:2", names, "--unfold").edge, -1);
  EXPECT_EQ(named_piece("back:3", names, "--unfold").piece, 2u);
  EXPECT_HOLDS(samples::error_of([&] { named_piece("side", names, "--unfold"); }),
               "its pieces are front, back:2, back");
  EXPECT_HOLDS(samples::error_of([&] { named_piece("front:x", names, "--unfold"); }),
               "names no piece");
}

}  // namespace half_pieces_test
}  // namespace toile
