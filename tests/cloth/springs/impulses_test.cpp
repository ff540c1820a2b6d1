#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "tests/support/impulse_shares.h"

namespace toile {
namespace impulses_test {

// Reference case 12, point in a triangle.
struct PointRow {
  std::array<double, 3> weights;
  double squares, printed_coefficient, printed_change, printed_residual;
  int passes;
  double motionless_coefficient, movable_coefficient, share_of_point, share_of_vertex;
};
constexpr PointRow point_rows[] = {
    {{1.0 / 3, 1.0 / 3, 1.0 / 3}, 0.333333333333333, 1.5, 0.5, 0.5, 7, 3, 0.75, 0.25, 0.75},
    {{0.5, 0.5, 0},
     0.5,
     1.33333333333333,
     0.666666666666667,
     0.333333333333333,
     5,
     2,
     0.666666666666667,
     0.333333333333333,
     0.666666666666667},
    {{0.5, 0.25, 0.25},
     0.375,
     1.45454545454545,
     0.545454545454545,
     0.454545454545455,
     6,
     2.66666666666667,
     0.727272727272727,
     0.272727272727273,
     0.727272727272727},
    {{0.6, 0.3, 0.1},
     0.46,
     1.36986301369863,
     0.63013698630137,
     0.36986301369863,
     5,
     2.17391304347826,
     0.684931506849315,
     0.315068493150685,
     0.684931506849315},
    {{0.8, 0.1, 0.1},
     0.66,
     1.20481927710843,
     0.795180722891566,
     0.204819277108434,
     3,
     1.51515151515151,
     0.602409638554217,
     0.397590361445783,
     0.602409638554217},
    {{0.9, 0.1, 0},
     0.82,
     1.0989010989011,
     0.901098901098901,
     0.0989010989010989,
     2,
     1.21951219512195,
     0.549450549450549,
     0.450549450549451,
     0.549450549450549},
    {{1, 0, 0}, 1, 1, 1, 0, 0, 1, 0.5, 0.5, 0.5},
    {{0.45, 0.45, 0.1},
     0.415,
     1.41342756183746,
     0.586572438162544,
     0.413427561837456,
     6,
     2.40963855421687,
     0.706713780918728,
     0.293286219081272,
     0.706713780918728},
    {{0.2, 0.5, 0.3},
     0.38,
     1.44927536231884,
     0.550724637681159,
     0.449275362318841,
     6,
     2.63157894736842,
     0.72463768115942,
     0.27536231884058,
     0.72463768115942},
};

// Reference case 12, general masses; the change of the relative velocity is 1.
struct MassRow {
  std::array<double, 3> mass;
  double other;
  std::array<double, 3> weights;
  std::array<double, 4> changes;
};
constexpr MassRow mass_rows[] = {
    {{1, 1, 1}, 1, {1.0 / 3, 1.0 / 3, 1.0 / 3}, {0.25, 0.25, 0.25, -0.75}},
    {{1, 1, 1},
     1,
     {0.6, 0.3, 0.1},
     {0.410958904109589, 0.205479452054795, 0.0684931506849315, -0.684931506849315}},
    {{1, 2, 3},
     1,
     {1.0 / 3, 1.0 / 3, 1.0 / 3},
     {0.276923076923077, 0.138461538461538, 0.0923076923076923, -0.830769230769231}},
    {{1, 2, 3},
     1,
     {0.6, 0.3, 0.1},
     {0.42603550295858, 0.106508875739645, 0.0236686390532544, -0.710059171597633}},
    {{1, 1, 1},
     10,
     {1.0 / 3, 1.0 / 3, 1.0 / 3},
     {0.769230769230769, 0.769230769230769, 0.769230769230769, -0.230769230769231}},
    {{1, 1, 1},
     10,
     {0.6, 0.3, 0.1},
     {1.07142857142857, 0.535714285714286, 0.178571428571429, -0.178571428571429}},
    {{1, 1, 1}, 1e+30, {1.0 / 3, 1.0 / 3, 1.0 / 3}, {1, 1, 1, -3e-30}},
    {{1, 1, 1},
     1e+30,
     {0.6, 0.3, 0.1},
     {1.30434782608696, 0.652173913043478, 0.217391304347826, -2.17391304347826e-30}},
    {{0.5, 1, 2},
     1e+30,
     {1.0 / 3, 1.0 / 3, 1.0 / 3},
     {1.71428571428571, 0.857142857142857, 0.428571428571429, -2.57142857142857e-30}},
    {{0.5, 1, 2},
     1e+30,
     {0.6, 0.3, 0.1},
     {1.47239263803681, 0.368098159509202, 0.0613496932515337, -1.22699386503067e-30}},
};

// Reference case 12, edges.
struct EdgeRow {
  double w1, w2, printed_change, printed_residual;
  int passes;
  double twice_printed_residual, motionless_coefficient;
};
constexpr EdgeRow edge_rows[] = {
    {0, 0, 0.5, 0.5, 7, 0, 1},
    {0, 0.25, 0.5, 0.5, 7, 0, 1},
    {0, 0.5, 0.5, 0.5, 7, 0, 1},
    {0, 1, 0.5, 0.5, 7, 0, 1},
    {0.1, 0, 0.41, 0.59, 9, 0.18, 1.21951219512195},
    {0.1, 0.25, 0.41, 0.59, 9, 0.18, 1.21951219512195},
    {0.1, 0.5, 0.41, 0.59, 9, 0.18, 1.21951219512195},
    {0.1, 1, 0.41, 0.59, 9, 0.18, 1.21951219512195},
    {0.25, 0, 0.3125, 0.6875, 13, 0.375, 1.6},
    {0.25, 0.25, 0.3125, 0.6875, 13, 0.375, 1.6},
    {0.25, 0.5, 0.3125, 0.6875, 13, 0.375, 1.6},
    {0.25, 1, 0.3125, 0.6875, 13, 0.375, 1.6},
    {0.5, 0, 0.25, 0.75, 17, 0.5, 2},
    {0.5, 0.25, 0.25, 0.75, 17, 0.5, 2},
    {0.5, 0.5, 0.25, 0.75, 17, 0.5, 2},
    {0.5, 1, 0.25, 0.75, 17, 0.5, 2},
    {0.75, 0, 0.3125, 0.6875, 13, 0.375, 1.6},
    {0.75, 0.25, 0.3125, 0.6875, 13, 0.375, 1.6},
    {0.75, 0.5, 0.3125, 0.6875, 13, 0.375, 1.6},
    {0.75, 1, 0.3125, 0.6875, 13, 0.375, 1.6},
    {0.9, 0, 0.41, 0.59, 9, 0.18, 1.21951219512195},
    {0.9, 0.25, 0.41, 0.59, 9, 0.18, 1.21951219512195},
    {0.9, 0.5, 0.41, 0.59, 9, 0.18, 1.21951219512195},
    {0.9, 1, 0.41, 0.59, 9, 0.18, 1.21951219512195},
    {1, 0, 0.5, 0.5, 7, 0, 1},
    {1, 0.25, 0.5, 0.5, 7, 0, 1},
    {1, 0.5, 0.5, 0.5, 7, 0, 1},
    {1, 1, 0.5, 0.5, 7, 0, 1},
};

constexpr double digits = 1e-12;  // the tables carry 15

template <std::size_t N>
double change_at(const std::array<double, N>& weights, const std::array<double, N>& changes) {
  double sum = 0;
  for (std::size_t i = 0; i < N; ++i) sum += weights[i] * changes[i];
  return sum;
}

/// Applications after which at most 1 % is left when each leaves `residual` of the rest.
int passes_to_one_percent(double residual) {
  int passes = 0;
  for (double left = 1; left > 0.01 * (1 + 1e-9); left *= residual) ++passes;
  return passes;
}

TEST(Impulses, OnePointOfATriangleStopsAtOnceAgainstAMotionlessVertex) {
  double worst = 0;
  for (const PointRow& row : point_rows) {
    const auto shares = motionless_shares(row.weights, {1, 1, 1});
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(shares[i], row.weights[i] * row.motionless_coefficient, digits * 10);
    }
    worst = std::max(worst, std::abs(1 - change_at(row.weights, shares)));
    EXPECT_NEAR(inverse_mass_at(row.weights, {1, 1, 1}), row.squares, digits);
  }
  EXPECT_LT(worst, digits);
  std::cout << "largest residual of the share w/S: " << worst << '\n';
}

TEST(Impulses, PrintedTriangleSharesLeaveAResidual) {
  double largest = 0;
  for (const PointRow& row : point_rows) {
    const auto shares = printed_triangle_shares(row.weights);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(shares[i], row.weights[i] * row.printed_coefficient, digits);
    }
    const double change = change_at(row.weights, shares);
    EXPECT_NEAR(change, row.printed_change, digits);
    EXPECT_NEAR(1 - change, row.printed_residual, digits);
    if (row.printed_residual > 0) {
      EXPECT_EQ(passes_to_one_percent(1 - change), row.passes);
    }
    largest = std::max(largest, 1 - change);
  }
  EXPECT_NEAR(largest, 0.5, digits);  // at the centroid
  std::cout << "the printed shares leave up to " << largest << " of the approach\n";
}

TEST(Impulses, FourEqualMovableMassesAreWhatThePrintedSharesAreFor) {
  for (const PointRow& row : point_rows) {
    const auto shares = movable_shares(row.weights, {1, 1, 1}, 1);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(shares[i], row.weights[i] * row.movable_coefficient, digits);
      // Printed for half the relative velocity.
      EXPECT_NEAR(2 * shares[i], printed_triangle_shares(row.weights)[i], digits);
    }
    EXPECT_NEAR(change_at(row.weights, {shares[0], shares[1], shares[2]}), row.share_of_point,
                digits);
    EXPECT_NEAR(-shares[3], row.share_of_vertex, digits);
  }
}

TEST(Impulses, SharesFollowTheMasses) {
  for (const MassRow& row : mass_rows) {
    const std::array<double, 3> inverse = {1 / row.mass[0], 1 / row.mass[1], 1 / row.mass[2]};
    const auto shares = movable_shares(row.weights, inverse, 1 / row.other);
    double momentum = row.other * shares[3];
    for (std::size_t i = 0; i < 3; ++i) momentum += row.mass[i] * shares[i];
    EXPECT_NEAR(momentum, 0, digits);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(shares[i], row.changes[i], digits);
    if (row.other > 1e20) {
      const auto motionless = motionless_shares(row.weights, inverse);
      for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(motionless[i], row.changes[i], digits);
    }
  }
}

TEST(Impulses, EdgesStopAtOnceAndThePrintedSharesLeaveHalfOrMore) {
  double worst = 0;
  double min_left = 1;
  for (const EdgeRow& row : edge_rows) {
    const std::array<double, 2> weights = {1 - row.w1, row.w1};
    const auto shares = motionless_shares(weights, {1, 1});
    EXPECT_NEAR(shares[0], (1 - row.w1) * row.motionless_coefficient, digits);
    EXPECT_NEAR(shares[1], row.w1 * row.motionless_coefficient, digits);
    worst = std::max(worst, std::abs(1 - change_at(weights, shares)));

    const auto printed = printed_edge_shares(row.w1, row.w2);
    const double change = change_at(weights, printed);
    EXPECT_NEAR(change, row.printed_change, digits);
    EXPECT_NEAR(1 - change, row.printed_residual, digits);
    EXPECT_NEAR(1 - 2 * change, row.twice_printed_residual, digits);
    EXPECT_EQ(passes_to_one_percent(1 - change), row.passes);
    min_left = std::min(min_left, 1 - change);
  }
  EXPECT_LT(worst, digits);
  EXPECT_NEAR(min_left, 0.5, digits);
  std::cout << "largest residual of the motionless share: " << worst
            << "; the printed shares leave at least " << min_left << '\n';
}

TEST(Impulses, HeldNodesTakeNothing) {
  const auto shares = motionless_shares<3>({0.2, 0.3, 0.5}, {0, 1, 2});
  EXPECT_EQ(shares[0], 0);
  EXPECT_NEAR(change_at<3>({0.2, 0.3, 0.5}, shares), 1, digits);
  EXPECT_EQ(motionless_shares<2>({0.5, 0.5}, {0, 0})[0], 0);
}

}  // namespace impulses_test
}  // namespace toile
