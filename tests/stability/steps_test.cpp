// Case 1: steps a hundred times too long and too short, and a million of them at rest.
#include <numeric>

#include "cloth/model/compile.h"
#include "cloth/relaxation/relax.h"
#include "cloth/relaxation/release.h"
#include "cloth/scene/collider.h"
#include "cloth/springs/spring_motion.h"
#include "geometry/distance_grid.h"
#include "geometry/error.h"
#include "tests/cloth/panels.h"
#include "tests/stability/hard_case.h"
#include "tests/support/shapes.h"

namespace toile::test {
namespace steps_test {

/// A handkerchief of 20 cm that hangs over a ball.
class Handkerchief : public testing::Test {
 protected:
  Handkerchief() {
    add_panel(garment, "handkerchief", grid(0.2, 0.2, 10, 10),
              [](const Vec2& p) { return Vec3(p.x() - 0.1, 0.105, 0.1 - p.y()); });
    scene.collider = &ball;
    options.bounded = true;
    options.max_iterations = 40000;
    options.stop_median = 1e-5;
    options.stop_rms = 1e-4;
    model = compile(garment, scene, garment.placed);
  }

  std::vector<Vec3> relaxed(const RelaxOptions& by) {
    std::vector<Vec3> x = model.start;
    last = relax(model, by, x);
    return x;
  }

  static SpringStage falling() {
    SpringStage stage;
    stage.gravity = 1;
    stage.friction = true;
    return stage;
  }

  static double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double most = 0;
    for (std::size_t n = 0; n < a.size(); ++n) most = std::max(most, (a[n] - b[n]).norm());
    return most;
  }

  /// Lets go of the handkerchief at rest for that many steps.
  void rest_by_release(int steps) {
    const std::vector<Vec3> rest = relaxed(options);
    ReleaseOptions released;
    static_cast<ForceOptions&>(released) = options;
    released.warm_start = &last.warm_start;
    std::vector<Vec3> x = rest;
    // The longest step that is stable is not longer for a longer run.
    released.seconds = 0.01;
    const double step = release(model, released, x).time_step;
    released.seconds = 1.01 * steps * step;
    x = rest;
    const ReleaseReport report = release(model, released, x);
    EXPECT_GE(report.steps, steps);
    EXPECT_LT(report.all.max, 5e-4);
    EXPECT_LT(report.kinetic, 1e-9);
    state("1 " + number(steps, 7) + " steps at rest", "release", "rests",
          "moved " + number(1000 * report.all.max) + " mm at most, " + number(report.kinetic) +
              " J at the end, simulated " + number(report.seconds) + " s");
  }

  /// Settles by the paper's springs, then looks at as many steps in five parts.
  void rest_by_springs(int steps) {
    SpringOptions springs;
    SpringMotion motion(garment, model, springs, garment.placed);
    const SpringStage drape = falling();
    const int settling = static_cast<int>(3 / motion.time_step());
    for (int i = 0; i < settling; ++i) motion.step(drape);
    const std::vector<Vec3> rest = motion.points();
    double first_drift = 0, drift = 0, first_fastest = 0, fastest = 0;
    for (int part = 0; part < 5; ++part) {
      fastest = 0;
      for (int i = 0; i < steps / 5; ++i) {
        motion.step(drape);
        for (const Vec3& v : motion.velocities()) fastest = std::max(fastest, v.norm());
      }
      drift = farthest(rest, motion.points());
      if (part == 0) first_drift = drift, first_fastest = fastest;
    }
    EXPECT_LT(drift, 2e-3);
    EXPECT_LT(fastest, 2 * first_fastest + 1e-3);
    state("1 " + number(steps, 7) + " steps at rest", "paper", "rests",
          "moved " + number(1000 * drift) + " mm at most (" + number(1000 * first_drift) +
              " in the first fifth), fastest node " + number(1000 * first_fastest) +
              " mm/s first, " + number(1000 * fastest) + " last");
  }

  const Collider ball{sphere(0.1, 4)};
  PanelMesh garment;
  Scene scene;
  GarmentModel model;
  RelaxOptions options;
  RelaxReport last;
};

using LongHandkerchief = Handkerchief;

// A node's step is its force over its stiffness; what can be set is how far it may go.
TEST_F(Handkerchief, RelaxesWhateverItsLongestMove) {
  const std::vector<Vec3> usual = relaxed(options);
  EXPECT_TRUE(last.converged);
  const int usual_iterations = last.iterations;
  for (const double factor : {100.0, 0.01}) {
    RelaxOptions other = options;
    other.max_move *= factor;
    const std::vector<Vec3> x = relaxed(other);
    EXPECT_TRUE(last.converged) << factor;
    // It may rest in another of its folds, but not elsewhere.
    const double away = farthest(usual, x);
    EXPECT_LT(away, 0.05) << factor;
    state("1 longest move x " + number(factor), "relaxation", "at rest",
          std::to_string(last.iterations) +
              " iterations (usual: " + std::to_string(usual_iterations) + "), rests " +
              number(1000 * away) + " mm from the usual at most");
  }
}

TEST_F(Handkerchief, FallsTheSameByStepsAHundredTimesShorter) {
  SpringOptions springs;
  SpringMotion usual(garment, model, springs, garment.placed);
  springs.time_step = usual.time_step() / 100;
  SpringMotion shorter(garment, model, springs, garment.placed);
  const SpringStage drape = falling();
  const int steps = static_cast<int>(0.05 / usual.time_step());
  for (int i = 0; i < steps; ++i) usual.step(drape);
  for (int i = 0; i < 100 * steps; ++i) shorter.step(drape);
  const double fallen = farthest(garment.placed, usual.points());
  const double away = farthest(usual.points(), shorter.points());
  EXPECT_GT(fallen, 5e-3);
  EXPECT_LT(away, 0.1 * fallen);
  state("1 steps x 0.01", "paper", "agrees",
        "after 50 ms and a fall of " + number(1000 * fallen) + " mm, " + number(1000 * away) +
            " mm apart at most");
}

TEST_F(Handkerchief, StepsAHundredTimesLongerAreRefused) {
  SpringOptions springs;
  const double usual = SpringMotion(garment, model, springs, garment.placed).time_step();
  springs.time_step = 100 * usual;
  try {
    const SpringMotion motion(garment, model, springs, garment.placed);
    FAIL() << "a step of " << motion.time_step() << " s";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("too long"), std::string::npos) << error.what();
    state("1 steps x 100", "paper", "error", error.what());
  }
}

TEST_F(Handkerchief, RestsForManySteps) {
  rest_by_release(20000);
  rest_by_springs(20000);
}

TEST_F(LongHandkerchief, RestsForAMillionStepsOfRelease) { rest_by_release(1000000); }
TEST_F(LongHandkerchief, RestsForAMillionStepsOfThePaper) { rest_by_springs(1000000); }

class TooLongSteps : public HardCase {};

TEST_F(TooLongSteps, AreAnErrorOfDress) {
  const fs::path garment = band();
  for (const char* step : {"1e-3", "5e-3"}) {
    const Ending ending = dress(mannequin(), garment, "paper", {"--time-step", step});
    EXPECT_EQ(ending.outcome, "error") << ending.said;
    EXPECT_TRUE(ending.says("moves stably up to")) << ending.said;
    state(std::string("1 --time-step ") + step, "paper", ending.outcome, ending.first_words());
  }
}

}  // namespace steps_test
}  // namespace toile::test
