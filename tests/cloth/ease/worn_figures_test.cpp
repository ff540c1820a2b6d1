// Errors of figures from other drapes, by hand.
#include "cloth/ease/worn_figures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace toile {
namespace worn_figures_test {

/// A drape with one girth of this ease, one edge at this height and one length.
WornFigures drape(double ease, double height, double worn) {
  WornFigures figures;
  Girth girth;
  girth.name = "hip";
  girth.body = 1;
  girth.hull = 1 + ease;
  girth.garment = 1 + ease;
  girth.error = 0.5;
  figures.girths.rows = {girth};
  GarmentLevel level;
  level.name = "hem";
  level.height = height;
  level.height_error = 0.5;
  figures.levels = {level};
  GarmentLength length;
  length.name = "left sleeve";
  length.worn = worn;
  length.error = 0.5;
  figures.lengths = {length};
  return figures;
}

TEST(WornFigures, ErrorsAreThoseOfTheSpread) {
  WornFigures figures = drape(0.05, 0.9, 0.60);
  take_errors_from({drape(0.06, 0.9, 0.61), drape(0.07, 0.9, 0.56)}, figures);
  // Student's t of two degrees of freedom at 95 % is 2.92. The standard deviation of 5, 6 and 7 cm
  // is 1 cm, that of 60, 61 and 56 cm is the root of 7.
  const double wide = 2.91999 * std::sqrt(4 / 3.0);
  EXPECT_NEAR(figures.girths.rows[0].error, 0.01 * wide, 1e-6);
  EXPECT_NEAR(figures.levels[0].height_error, 0, 1e-12);
  EXPECT_NEAR(figures.lengths[0].error, 0.01 * wide * std::sqrt(7), 1e-5);
}

TEST(WornFigures, AFigureThatOthersLackKeepsItsError) {
  WornFigures figures = drape(0.05, 0.9, 0.60);
  WornFigures other = drape(0.06, 0.9, 0.61);
  WornFigures fold = drape(0.06, 0.9, 0.61);
  fold.girths.rows[0].hull = 0.5;  // no girth there
  fold.lengths.clear();
  take_errors_from({other, fold}, figures);
  EXPECT_EQ(figures.girths.rows[0].error, 0.5);
  EXPECT_EQ(figures.lengths[0].error, 0.5);
  EXPECT_LT(figures.levels[0].height_error, 0.5);
}

}  // namespace worn_figures_test
}  // namespace toile
