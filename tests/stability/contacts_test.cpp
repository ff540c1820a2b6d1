// Cases 4 and 5: sharp, thin and narrow bodies, cloth that is thrown, pinched, stacked and folded.
#include <numeric>

#include "cloth/model/compile.h"
#include "cloth/relaxation/relax.h"
#include "cloth/relaxation/release.h"
#include "cloth/scene/collider.h"
#include "cloth/springs/spring_motion.h"
#include "geometry/distance_grid.h"
#include "geometry/intersections.h"
#include "tests/cloth/panels.h"
#include "tests/stability/hard_case.h"
#include "tests/support/shapes.h"

namespace toile::test {
namespace contacts_test {

/// A plate with a spike 1 mm wide, 4 cm high, and a wall 1 mm thick, 3 cm high, along z.
TriangleMesh spikes_and_knives() {
  const TriangleMesh plate = box({-0.2, -0.05, -0.2}, {0.2, 0, 0.2});
  const TriangleMesh wall = box({0.0295, -0.01, -0.15}, {0.0305, 0.03, 0.15});
  return together(together(plate, wall), spike(-0.031, 0.002, 0.0005, 0.04));
}

class Contacts : public testing::Test {
 protected:
  explicit Contacts(const TriangleMesh& mesh = spikes_and_knives()) : body(mesh) {
    scene.collider = &body;
    force.bounded = true;
  }

  /// A level square of cloth, its middle at `middle`.
  static void add_sheet(PanelMesh& garment, double side, int cells, const Vec3& middle) {
    add_panel(garment, "sheet", grid(side, side, cells, cells), [&](const Vec2& p) {
      return Vec3(middle + Vec3(p.x() - side / 2, 0, side / 2 - p.y()));
    });
    garment.edge_length = side / cells;
  }

  static void expect_finite(const std::vector<Vec3>& x) {
    for (const Vec3& p : x) ASSERT_TRUE(p.allFinite());
  }

  /// Counts what meets, and expects nothing to.
  std::string expect_clear(const std::vector<Vec3>& x, const std::vector<Triangle>& triangles) {
    expect_finite(x);
    const TriangleMesh cloth{x, triangles};
    const std::size_t with_body = intersections(cloth, body.body()).size();
    const std::size_t with_itself = self_intersections(cloth).size();
    EXPECT_EQ(with_body, 0U);
    EXPECT_EQ(with_itself, 0U);
    return std::to_string(with_body) + " intersections with the body, " +
           std::to_string(with_itself) + " with itself";
  }

  RelaxReport relaxed(const PanelMesh& garment, std::vector<Vec3>& x, int most = 4000) {
    model = compile(garment, scene, garment.placed);
    RelaxOptions options;
    static_cast<ForceOptions&>(options) = force;
    options.max_iterations = most;
    options.stop_median = 0.01;
    options.stop_rms = 0.1;
    x = model.start;
    return relax(model, options, x);
  }

  static std::string figures(const RelaxReport& report) {
    return "residual " + number(report.residual.median, 2) + ", " + number(report.residual.rms, 2) +
           " after " + std::to_string(report.iterations) + " iterations";
  }

  const Collider body;
  Scene scene;
  ForceOptions force;
  GarmentModel model;
};

/// Metres that the thrown cloth falls, under so much gravity as gives it its speed.
constexpr double way = 0.13;
double throwing(double speed) { return speed * speed / (2 * way) / 9.81; }
double landing(double speed) { return 3 * way / speed; }

TEST_F(Contacts, ThrownAtSpikesAndKnives) {
  for (const double speed : {2.0, 50.0}) {
    PanelMesh garment;
    add_sheet(garment, 0.12, 12, {0, way + 0.04, 0});
    scene.gravity = Vec3(0, -9.81 * throwing(speed), 0);
    model = compile(garment, scene, garment.placed);
    ReleaseOptions options;
    static_cast<ForceOptions&>(options) = force;
    options.damping = 0;
    options.seconds = 2 * way / speed;
    std::vector<Vec3> x = model.start;
    const double arriving = release(model, options, x).speed_p99;
    EXPECT_NEAR(arriving, speed, 0.06 * speed);
    options.seconds = landing(speed);
    x = model.start;
    release(model, options, x);
    const std::string clear = expect_clear(x, model.node_triangles);
    double lowest = 1;
    for (const Vec3& p : x) lowest = std::min(lowest, p.y());
    EXPECT_GT(lowest, 0) << "above the plate";
    state("4 thrown at a spike and a knife at " + number(arriving) + " m/s", "release", "stopped",
          clear + ", lowest node " + number(1000 * lowest) + " mm above the plate");
  }
}

TEST_F(Contacts, ThrownAtSpikesAndKnivesByThePapersMethod) {
  PanelMesh garment;
  add_sheet(garment, 0.12, 12, {0, way + 0.04, 0});
  scene.gravity *= throwing(50);
  // What bounds cloth against cloth slows what flies.
  scene.self_contact = false;
  model = compile(garment, scene, garment.placed);
  const SpringOptions options;
  SpringMotion motion(garment, model, options, garment.placed);
  SpringStage stage;
  stage.gravity = 1;
  stage.friction = true;
  double fastest = 0;
  for (double t = 0; t < landing(50); t += motion.time_step()) {
    motion.step(stage);
    for (const Vec3& v : motion.velocities()) fastest = std::max(fastest, v.norm());
  }
  EXPECT_GT(fastest, 40);
  expect_finite(motion.points());
  const TriangleMesh cloth{motion.points(), garment.triangles};
  const std::size_t with_body = intersections(cloth, body.body()).size();
  // Its collisions are found at the ends of steps; what is cut is counted, none may be through.
  double lowest = 1;
  for (const Vec3& p : motion.points()) lowest = std::min(lowest, p.y());
  EXPECT_GT(lowest, 0) << "above the plate";
  state("4 thrown at spike and knife at " + number(fastest) + " m/s", "paper",
        with_body == 0 ? "stopped" : "stopped, cut",
        std::to_string(with_body) + " intersections with the body, " +
            std::to_string(self_intersections(cloth).size()) + " with itself");
}

TEST_F(Contacts, LaidOverSpikesAndKnives) {
  PanelMesh garment;
  // Edges of 1.5 cm over a spike and a wall of 1 mm.
  add_sheet(garment, 0.24, 16, {0.003, 0.05, 0.002});
  std::vector<Vec3> x;
  const RelaxReport report = relaxed(garment, x);
  const auto lifted =
      std::ranges::count_if(report.extra_offset, [](double lift) { return lift > 0; });
  EXPECT_GT(lifted, 0);
  EXPECT_LT(lifted, model.nodes / 2);
  state("4 laid over a spike and a knife of 1 mm, edges of 15 mm", "relaxation",
        report.converged ? "at rest" : "not at rest",
        expect_clear(x, model.node_triangles) + ", " + figures(report));
}

class ThinPlate : public Contacts {
 protected:
  ThinPlate() : Contacts(box({-0.06, -0.0005, -0.06}, {0.06, 0.0005, 0.06})) {}
};

TEST_F(ThinPlate, HoldsASheet) {
  PanelMesh garment;
  add_sheet(garment, 0.2, 16, {0.002, 0.006, 0.003});
  std::vector<Vec3> x;
  const RelaxReport report = relaxed(garment, x, 8000);
  const std::string clear = expect_clear(x, model.node_triangles);
  EXPECT_GT(x[x.size() / 2].y(), 0.0005) << "on the plate";
  state("4 plate 1 mm thick", "relaxation", report.converged ? "at rest" : "not at rest",
        clear + ", " + figures(report));
}

/// Two blocks 3 mm apart, cloth between them: each keeps it off by 2 mm.
class Pinched : public Contacts {
 protected:
  Pinched()
      : Contacts(together(box({-0.1, -0.1, -0.1015}, {0.1, 0.1, -0.0015}),
                          box({-0.1, -0.1, 0.0015}, {0.1, 0.1, 0.1015}))) {}
};

TEST_F(Pinched, BetweenTwoBlocks) {
  PanelMesh garment;
  add_panel(garment, "sheet", grid(0.1, 0.2, 8, 16),
            [](const Vec2& p) { return Vec3(p.x() - 0.05, p.y() - 0.05, 0); });
  std::vector<Vec3> x;
  const RelaxReport report = relaxed(garment, x);
  const std::string clear = expect_clear(x, model.node_triangles);
  state("4 pinched between blocks 3 mm apart", "relaxation",
        report.converged ? "at rest" : "not at rest", clear + ", " + figures(report));
}

class Plate : public Contacts {
 protected:
  Plate() : Contacts(box({-0.2, -0.05, -0.2}, {0.2, 0, 0.2})) {}

  /// So many layers, a little more than their gap apart, under ten times their weight.
  void stack(int layers) {
    PanelMesh garment;
    for (int i = 0; i < layers; ++i) {
      add_sheet(garment, 0.08, 8, {0.0005 * (i % 3), 0.0025 * (i + 1), 0.0005 * (i % 2)});
    }
    scene.gravity *= 10;
    std::vector<Vec3> x;
    const RelaxReport report = relaxed(garment, x, 3000);
    const std::string clear = expect_clear(x, model.node_triangles);
    const std::size_t each = x.size() / static_cast<std::size_t>(layers);
    double least = 1;
    for (std::size_t n = each; n < x.size(); ++n) {
      least = std::min(least, x[n].y() - x[n - each].y());
    }
    EXPECT_GT(least, 0) << "in their order";
    state("5 " + std::to_string(layers) + " layers pressed together", "relaxation",
          report.converged ? "at rest" : "not at rest",
          clear + ", " + number(1000 * least) + " mm between layers at least, " + figures(report));
  }
};

using LongPlate = Plate;

TEST_F(Plate, LayersPressedTogether) { stack(10); }
TEST_F(LongPlate, FiftyLayersPressedTogether) { stack(50); }

/// The right half lies exactly on the left one, point on point.
TEST_F(Plate, FoldedInExactContact) {
  PanelMesh garment;
  add_panel(garment, "folded", grid(0.16, 0.08, 16, 8), [](const Vec2& p) {
    return Vec3(std::min(p.x(), 0.16 - p.x()) - 0.04, 0.004, 0.04 - p.y());
  });
  EXPECT_FALSE(self_intersections({garment.placed, garment.triangles}).empty());
  force.bounded = false;  // bounds would keep them as they are
  std::vector<Vec3> x;
  const RelaxReport report = relaxed(garment, x);
  expect_finite(x);
  const TriangleMesh cloth{x, model.node_triangles};
  EXPECT_EQ(intersections(cloth, body.body()).size(), 0U);
  const std::size_t left = self_intersections(cloth).size();
  state("5 folded, in exact contact with itself", "relaxation",
        left == 0 ? "comes apart" : "stays in contact",
        std::to_string(left) + " intersections with itself left, which the verdict would name, " +
            figures(report));
}

/// It stands on its lower edge, and has nothing that tells it which way to fall.
TEST_F(Plate, ASheetEdgeOn) {
  PanelMesh garment;
  add_panel(garment, "edge on", grid(0.1, 0.1, 10, 10),
            [](const Vec2& p) { return Vec3(p.x() - 0.05, p.y() + 0.003, 0); });
  std::vector<Vec3> x;
  const RelaxReport report = relaxed(garment, x, 8000);
  const std::string clear = expect_clear(x, model.node_triangles);
  double top = 0;
  for (const Vec3& p : x) top = std::max(top, p.y());
  state("5 sheet edge-on", "relaxation", report.converged ? "at rest" : "not at rest",
        clear + ", its top at " + number(100 * top) + " of 10 cm, " + figures(report));
}

}  // namespace contacts_test
}  // namespace toile::test
