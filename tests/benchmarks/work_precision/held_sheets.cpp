#include "tests/benchmarks/work_precision/held_sheets.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "cloth/model/compile.h"
#include "cloth/springs/strain_control.h"
#include "tests/cloth/panels.h"
#include "tests/support/held_nodes.h"
#include "tests/support/spring_motion.h"

namespace toile::precision {

namespace {

/// As dress_springs(): 1/s of air drag, and seconds between two looks at what is left.
constexpr double drag = 5;
constexpr double look_interval = 0.005;

class HeldSheet : public Case {
 public:
  HeldSheet(std::string scene, double edge_mm, PanelMesh garment, const Fabric& fabric,
            const std::function<bool(const Vec3&)>& held)
      : Case(std::move(scene), edge_mm), garment_(std::move(garment)) {
    Scene at;
    at.fabric = fabric;
    at.self_contact = false;
    model_ = compile(garment_, at, garment_.placed);
    test::hold_nodes(model_, held);
  }

  const PanelMesh& garment() const override { return garment_; }
  const GarmentModel& model() const override { return model_; }
  double springs_at_rest() const override { return 1e-4; }
  Outcome run(Method method, const Setting& setting) const override {
    return method == Method::relaxation ? relaxed(setting) : sprung(setting);
  }

 private:
  Outcome relaxed(const Setting& setting) const;
  Outcome sprung(const Setting& setting) const;

  PanelMesh garment_;
  GarmentModel model_;
};

Outcome HeldSheet::relaxed(const Setting& setting) const {
  RelaxOptions options;
  options.max_iterations = setting.iterations;
  options.stop_median = setting.residual;
  options.stop_rms = std::numeric_limits<double>::infinity();  // holds what is held
  Outcome done;
  done.points = model_.start;
  const Stopwatch watch;
  const RelaxReport report = relax(model_, options, done.points);
  watch.stop(done);
  done.residual = report.residual;
  done.residual.rms = 0;
  done.converged = report.converged;
  done.iterations = report.iterations;
  return done;
}

/// Force left on the nodes that are free, as a mean over a look.
Residual left_of(const test::SpringMotion& now, const std::vector<Vec3>& x,
                 const std::vector<Vec3>& v, double span, double mean_weight) {
  Residual residual;
  std::vector<double> left;
  for (std::size_t n = 0; n < x.size(); ++n) {
    if (now.inverse_mass[n] == 0) continue;
    const Vec3 gained = now.v[n] - v[n] + drag * (now.x[n] - x[n]);
    left.push_back(gained.norm() / (now.inverse_mass[n] * span * mean_weight));
  }
  std::nth_element(left.begin(), left.begin() + left.size() / 2, left.end());
  residual.median = left[left.size() / 2];
  return residual;
}

StrainControlOptions limit_of(const Setting& setting) {
  StrainControlOptions limit;
  limit.measure_after = false;
  if (setting.exact_limit) {
    limit.sweep = StrainSweep::in_order;
    limit.mean_of_passes = false;
    limit.passes = 300;
    limit.tolerance = 1e-6;
  }
  return limit;
}

Outcome HeldSheet::sprung(const Setting& setting) const {
  Outcome done;
  const Stopwatch watch;
  const SpringSheet sheet(garment_, model_);
  const auto [springs, mass] = test::HeldSprings(sheet, model_);
  test::SpringMotion motion(springs, model_.start, mass, drag, model_.scene.gravity);
  StrainControl control(sheet.edges(), model_.nodes);
  const StrainControlOptions limit = limit_of(setting);
  const double dt = setting.step_share * stable_step(springs, motion.inverse_mass, drag);
  const int steps_a_look = std::max(1, static_cast<int>(std::lround(look_interval / dt)));
  std::vector<Vec3> looked_x = motion.x, looked_v = motion.v;
  while (done.simulated < setting.seconds && !done.converged) {
    for (int i = 0; i < steps_a_look; ++i) {
      motion.step(dt, [&] {
        control.adjust_velocities(motion.x, motion.inverse_mass, dt, limit, motion.v);
      });
    }
    done.iterations += steps_a_look;
    done.simulated += steps_a_look * dt;
    done.residual = left_of(motion, looked_x, looked_v, steps_a_look * dt, model_.mean_weight);
    // Let go at rest, it is balanced by nothing but its own slowness.
    constexpr double least = 0.1;
    done.converged = done.simulated > least && done.residual.median < setting.residual;
    looked_x = motion.x;
    looked_v = motion.v;
  }
  watch.stop(done);
  done.points = motion.x;
  return done;
}

}  // namespace

std::unique_ptr<Case> hanging_cloth(int nodes_across) {
  const int cells = nodes_across - 1;
  PanelMesh garment;
  test::add_panel(garment, "cloth", test::grid(1, 1, cells, cells),
                  [](const Vec2& p) { return Vec3(p.x(), 0, 1 - p.y()); });
  return std::make_unique<HeldSheet>(
      "hanging cloth", 1000.0 / cells, std::move(garment), Fabric(),
      [](const Vec3& p) { return p.z() == 0 && (p.x() == 0 || p.x() == 1); });
}

std::unique_ptr<Case> cantilever(int elements) {
  constexpr double length = 0.1, width = 0.05, weight_group = 10;
  Fabric fabric;
  fabric.areal_density = 0.2;
  fabric.shear = 500;
  fabric.bending_warp = fabric.bending_weft =
      fabric.areal_density * 9.81 * std::pow(length, 3) / weight_group;
  PanelMesh garment;
  // Bent over the line that is held, either half is clamped.
  test::add_panel(garment, "strip", test::grid(2 * length, width, 2 * elements, elements / 2),
                  [&](const Vec2& p) { return Vec3(p.x() - length, 0, -p.y()); });
  return std::make_unique<HeldSheet>("cantilever", 1000 * length / elements, std::move(garment),
                                     fabric, [](const Vec3& p) { return std::abs(p.x()) < 1e-9; });
}

}  // namespace toile::precision
