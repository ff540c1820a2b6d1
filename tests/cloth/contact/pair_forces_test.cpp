#include "cloth/contact/pair_forces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace toile {
namespace pair_forces_test {

using Corners = std::array<Vec3, 4>;

/// Forces (N) on the ends of two edges that keep a gap of 2 mm.
Corners forces_on(const Corners& x) {
  PairForces forces;
  forces.pairs() = {{{0, 1, 2, 3}, true, 0.002}};
  const std::vector<Vec3> points(x.begin(), x.end());
  forces.activate(points);
  forces.push(0, forces.active(), true, 0, as_vec4(points));
  Corners force;
  for (std::size_t v = 0; v < 4; ++v) {
    Vec4 sum = {0, 0, 0, 0};
    double stiffness = 0;
    forces.add(v, sum, stiffness);
    force[v] = as_vec3(sum);
  }
  return force;
}

/// Two edges of 1 cm, one `height` metres over the other, at share `t` of a closed path. On it the
/// edges turn past parallel twice, slide, and sink.
Corners at(double t, double height) {
  const double phase = 2 * std::numbers::pi * t;
  const double angle = 0.6 * std::sin(phase);
  const double slide = 0.002 * std::cos(phase);
  const double above = height + 0.0003 * std::cos(phase + 1);
  const Vec3 along(0.005 * std::cos(angle), 0, 0.005 * std::sin(angle));
  const Vec3 middle(slide, above, 0.0005);
  return {Vec3(-0.005, 0, 0), Vec3(0.005, 0, 0), middle - along, middle + along};
}

/// The push is the slope of an energy and has no jumps. Otherwise cloth whose folds lie edge on
/// edge would never come to rest. Without the share that turning edges get, the push jumps by 0.2 N
/// here.
TEST(PairForces, EdgesPushWithoutJumpsAndDoNoWorkOnAClosedPath) {
  for (const double height : {0.0015, 0.0007}) {
    constexpr int steps = 20000;
    double work = 0;
    double turned_over = 0;
    double largest_jump = 0;
    Corners before = at(0, height);
    Corners force_before = forces_on(before);
    for (int i = 1; i <= steps; ++i) {
      const Corners here = at(static_cast<double>(i) / steps, height);
      const Corners force = forces_on(here);
      double step = 0;
      for (std::size_t v = 0; v < 4; ++v) {
        step += 0.5 * (force[v] + force_before[v]).dot(here[v] - before[v]);
        largest_jump = std::max(largest_jump, (force[v] - force_before[v]).norm());
      }
      work += step;
      turned_over += std::abs(step);
      before = here;
      force_before = force;
    }
    EXPECT_GT(turned_over, 1e-5);
    EXPECT_LT(std::abs(work), 1e-4 * turned_over) << height;
    EXPECT_LT(largest_jump, 0.002) << height;
    std::cout << "at " << height << " m: work on the path " << work << " of " << turned_over
              << " J, largest jump of a force " << largest_jump << " N\n";
  }
}

/// Edges that cross at a large angle have the whole push.
TEST(PairForces, CrossingEdgesPushWithAll) {
  const Corners x = {Vec3(-0.005, 0, 0), Vec3(0.005, 0, 0), Vec3(0, 0.0015, -0.005),
                     Vec3(0, 0.0015, 0.005)};
  const Corners force = forces_on(x);
  const double all = contact_push(0.0015, 0.002, true).force;
  EXPECT_NEAR((force[2] + force[3]).y(), all, 1e-12);
  EXPECT_NEAR((force[0] + force[1]).y(), -all, 1e-12);
}

/// Two edges meet, come apart and meet again. A pair that is passed over pushes what it would push
/// if it were looked at anew.
TEST(PairForces, PairsThatArePassedOverPushTheSame) {
  PairForces forces;
  forces.pairs() = {{{0, 1, 2, 3}, true, 0.002}};
  const auto points_at = [](int i) {
    const Corners x = at(0.01 * i, 0.002 + 0.0005 * std::cos(0.3 * i));
    return std::vector<Vec3>(x.begin(), x.end());
  };
  forces.activate(points_at(0));
  int pushes = 0;
  for (int i = 0; i < 200; ++i) {
    const std::vector<Vec3> points = points_at(i);
    forces.follow(as_vec4(points));
    forces.push(0, forces.active(), true, 0, as_vec4(points));
    const Corners anew = forces_on({points[0], points[1], points[2], points[3]});
    for (std::size_t v = 0; v < 4; ++v) {
      Vec4 sum = {0, 0, 0, 0};
      double stiffness = 0;
      forces.add(v, sum, stiffness);
      EXPECT_EQ(as_vec3(sum), anew[v]) << i;
    }
    pushes += anew[0].norm() > 0 ? 1 : 0;
  }
  EXPECT_GT(pushes, 20);
  EXPECT_LT(pushes, 180);
}

}  // namespace pair_forces_test
}  // namespace toile
