// The heavy elastica: a strip clamped level bends under its own weight [reference case 4].
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cloth/model/compile.h"
#include "geometry/angles.h"
#include "tests/cloth/panels.h"
#include "tests/validation/reference_table.h"
#include "tests/validation/report.h"
#include "tests/validation/scenes.h"

namespace toile {
namespace cantilever_test {

constexpr double length = 0.1, width = 0.05;  // metres
constexpr double areal_density = 0.2;         // kg/m²

struct Bent {
  double drop_over_reach = 0;
  double tip_angle = 0;  // degrees
};

struct Cantilever {
  double gamma;
  int elements;  // along the length
  test::Cut cut;

  /// To both sides of x = 0. A free mesh has no vertices in a line but at its border: it is
  /// mirrored there.
  PlanarMesh mesh() const {
    const double edge = length / elements;
    if (cut == test::Cut::unstructured) {
      return test::mirrored(test::cut_rectangle(length, width, edge, cut));
    }
    PlanarMesh mesh = test::cut_rectangle(2 * length, width, edge, cut);
    for (Vec2& p : mesh.points) p.x() -= length;
    return mesh;
  }

  PanelMesh garment() const {
    PanelMesh garment;
    test::add_panel(garment, "strip", mesh(), [](const Vec2& p) { return Vec3(p.x(), 0, -p.y()); });
    return garment;
  }

  /// Held at the line that both halves are bent over.
  GarmentModel model(const PanelMesh& garment) const {
    Scene scene;
    scene.self_contact = false;
    scene.fabric.areal_density = areal_density;
    scene.fabric.bending_warp = scene.fabric.bending_weft =
        areal_density * 9.81 * std::pow(length, 3) / gamma;
    // Strained by 2e-4 at most.
    scene.fabric.stretch_warp = scene.fabric.stretch_weft = 1000;
    scene.fabric.shear = 500;
    GarmentModel model = compile(garment, scene, garment.placed);
    test::hold(model, [](const Vec3& p) { return std::abs(p.x()) < 1e-9; });
    return model;
  }

  /// Means of both tips; the angle is that of the last triangles.
  Bent measure(const PanelMesh& garment, const GarmentModel& model,
               const std::vector<Vec3>& x) const {
    double drop = 0, reach = 0, slope_drop = 0, slope_reach = 0;
    int tips = 0;
    const auto is_tip = [&](int p) { return std::abs(garment.flat[p].x()) > length * (1 - 1e-9); };
    for (std::size_t p = 0; p < x.size(); ++p) {
      if (!is_tip(static_cast<int>(p))) continue;
      ++tips;
      drop -= x[p].y();
      reach += std::abs(x[p].x());
    }
    for (std::size_t t = 0; t < model.triangles.size(); ++t) {
      const Triangle& corners = model.triangles[t];
      if (std::none_of(corners.begin(), corners.end(), is_tip)) continue;
      const StretchTriangle& s = model.stretch[t];
      Vec3 along = Vec3::Zero();
      for (int i = 0; i < 3; ++i) along += s.weft[i] * x[corners[i]];
      const double side = garment.flat[corners[0]].x() > 0 ? 1 : -1;
      slope_drop -= side * s.area * along.y();
      slope_reach += s.area * along.x();
    }
    EXPECT_GT(tips, 0);
    return {drop / reach, to_degrees(std::atan2(slope_drop, slope_reach))};
  }
};

/// Along a line at which its mesh is mirrored, a sheet bends more than it should, in proportion to
/// the size of its elements. And elements have to be small against the boundary layer.
const std::string mirrored_at_clamp = "bends more along the line that its mesh is mirrored at";
const std::string thin_layer = "boundary layer of less than six elements";

void state_bent(const test::Figure& drop, const test::Figure& tip, const Bent& bent, double ratio,
                double angle) {
  test::state(drop, bent.drop_over_reach, test::number(ratio, 6),
              test::number(100 * (bent.drop_over_reach / ratio - 1), 3) + " %");
  test::state(tip, bent.tip_angle, test::number(angle, 6),
              test::number(bent.tip_angle - angle, 3) + " degrees");
}

void bend(double gamma, int elements, bool bounded) {
  const test::ReferenceTable table("case04_heavy_elastica.csv");
  const double layer = elements / std::sqrt(gamma);
  const std::string at =
      ", " + std::to_string(elements) + " elements (boundary layer " + test::number(layer, 3) + ")";
  double least = 1e9, most = 0;
  for (const test::Cut cut : test::all_cuts) {
    const Cantilever scene{gamma, elements, cut};
    const PanelMesh garment = scene.garment();
    const GarmentModel model = scene.model(garment);
    const Bent bent = scene.measure(garment, model, test::relaxed(model, 1e-4));
    const double ratio = table.find("Gamma", gamma, "H_over_W");
    const double angle = table.find("Gamma", gamma, "tip_angle_deg");
    const std::string elastica = "elastica, weight group " + test::number(gamma) + ": ";
    test::Figure drop{elastica + "drop over reach", "relaxation", test::name_of(cut) + at};
    test::Figure tip{elastica + "tip angle", "relaxation", test::name_of(cut) + at, "degrees"};
    if (!bounded) {
      state_bent(drop, tip, bent, ratio, angle);
      continue;
    }
    drop.asked = 0.02, tip.asked = layer > 6 ? 1 : 0;
    if (elements < 32 && cut == test::Cut::unstructured) drop.reason = mirrored_at_clamp;
    if (layer < 6) drop.reason = thin_layer;
    test::expect_relative(drop, bent.drop_over_reach, ratio,
                          !drop.reason.empty() ? 0.03
                          : elements < 32      ? 0.02
                                               : 0.01);
    test::expect_near(tip, bent.tip_angle, angle, 1);
    least = std::min(least, bent.drop_over_reach);
    most = std::max(most, bent.drop_over_reach);
  }
  if (!bounded) return;
  test::Figure spread{"elastica, weight group " + test::number(gamma) +
                          ": drop over reach, spread over the three cuts",
                      "relaxation", at.substr(2), "%"};
  spread.asked = 2;
  if (elements < 32) spread.reason = layer < 6 ? thin_layer : mirrored_at_clamp;
  test::expect_near(spread, 100 * (most / least - 1), 0, elements >= 32 ? 1 : layer < 6 ? 4 : 2.5);
}

TEST(Cantilever, BendsAsTheHeavyElastica) {
  for (const double gamma : {1.0, 10.0}) {
    bend(gamma, 8, false);
    bend(gamma, 16, true);
  }
}

TEST(LongCantilever, BendsAsTheHeavyElastica) {
  for (const double gamma : {0.1, 1.0, 10.0, 100.0}) bend(gamma, 32, gamma < 100);
  // Boundary layers of less than two elements: information.
  bend(1000, 32, false);
}

// The springs across an edge have the fabric's energy at one curvature only, and are no stiffer
// than the step can bear. So their figures are information.
TEST(LongCantilever, OfSprings) {
  const test::ReferenceTable table("case04_heavy_elastica.csv");
  for (const double gamma : {10.0, 100.0}) {
    for (const test::Cut cut : test::all_cuts) {
      const Cantilever scene{gamma, 16, cut};
      const PanelMesh garment = scene.garment();
      const GarmentModel model = scene.model(garment);
      const std::vector<Vec3> x = test::sprung(garment, model, {.seconds = 6, .speed = 1e-5});
      const std::string elastica = "elastica, weight group " + test::number(gamma) + ": ";
      const std::string at = test::name_of(cut) + ", 16 elements";
      state_bent({elastica + "drop over reach", "springs", at},
                 {elastica + "tip angle", "springs", at, "degrees"},
                 scene.measure(garment, model, x), table.find("Gamma", gamma, "H_over_W"),
                 table.find("Gamma", gamma, "tip_angle_deg"));
    }
  }
}

}  // namespace cantilever_test
}  // namespace toile
