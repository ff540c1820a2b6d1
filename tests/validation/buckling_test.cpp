// A strip clamped on edge falls over sideways when it is too long [reference case 5]: information,
// for sheets of hinges have no torsional stiffness of their own.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cloth/model/compile.h"
#include "cloth/relaxation/relax.h"
#include "tests/cloth/panels.h"
#include "tests/validation/reference_table.h"
#include "tests/validation/report.h"
#include "tests/validation/scenes.h"

namespace toile {
namespace buckling_test {

constexpr double length = 0.1, width = 0.02;  // metres

/// How far the tip leans aside, as a share of the length, at a weight group of `gamma`.
double lean(double gamma, test::Cut cut) {
  PanelMesh garment;
  const PlanarMesh half = test::cut_rectangle(length, width, length / 20, cut);
  test::add_panel(garment, "strip", test::mirrored(half), [](const Vec2& p) {
    // Hardly bent, to have a side to go to; both halves to the same.
    return Vec3(p.x(), p.y(), 1e-4 * length * std::pow(p.x() / length, 2));
  });
  Scene scene;
  scene.self_contact = false;
  scene.fabric.areal_density = 0.2;
  scene.fabric.bending_warp = scene.fabric.bending_weft = 0.2 * 9.81 * std::pow(length, 3) / gamma;
  scene.fabric.stretch_warp = scene.fabric.stretch_weft = 2000;
  scene.fabric.shear = 1000;
  GarmentModel model = compile(garment, scene, garment.placed);
  test::hold(model, [](const Vec3& p) { return p.x() == 0; });
  // Near the threshold nothing comes to rest in any time: where it is by then counts.
  RelaxOptions options;
  options.max_iterations = 60000;
  options.stop_median = 1e-5;
  options.stop_rms = std::numeric_limits<double>::infinity();
  std::vector<Vec3> x = model.start;
  relax(model, options, x);
  double most = 0;
  for (const Vec3& p : x) most = std::max(most, std::abs(p.z()) / length);
  return most;
}

TEST(LongBuckling, LateralOfAStripOnEdge) {
  const test::ReferenceTable table("case05_lateral_buckling.csv");
  ASSERT_EQ(table.text(0, "load"), "self_weight");
  const double critical = table.at(0, "critical_load_group");
  for (const test::Cut cut : {test::Cut::structured, test::Cut::unstructured}) {
    double stands = 0.1 * critical, leans = 4 * critical;
    ASSERT_GT(lean(leans, cut), 0.05);
    while (leans / stands > 1.05) {
      const double middle = std::sqrt(leans * stands);
      (lean(middle, cut) < 0.02 ? stands : leans) = middle;
    }
    const double measured = std::sqrt(leans * stands);
    test::Figure figure{"lateral buckling of a strip on edge: weight group", "relaxation",
                        test::name_of(cut) + ", 20 elements, length 5 widths"};
    figure.reason = "from above: what has not fallen over in 60,000 iterations counts as standing";
    test::state(figure, measured, test::number(critical),
                test::number(100 * (measured / critical - 1), 3) + " %");
  }
}

}  // namespace buckling_test
}  // namespace toile
