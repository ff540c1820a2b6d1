// Cusick's drape tester, ISO 9073-9: a round sheet held on a smaller disc; how much of a shadow it
// has, and how many folds [reference case 9].
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "cloth/model/compile.h"
#include "cloth/relaxation/relax.h"
#include "geometry/triangulate.h"
#include "tests/cloth/panels.h"
#include "tests/support/level_line.h"
#include "tests/validation/reference_table.h"
#include "tests/validation/report.h"
#include "tests/validation/scenes.h"

namespace toile {
namespace drape_test {

constexpr double pi = std::numbers::pi;
constexpr double disc = 0.09, sheet = 0.15;  // radii, metres

/// Rings of points from the middle out. The disc's edge is halfway between two rings. Both are
/// held, for that is where a clamped sheet of triangles has its clamp.
class DrapeTester {
 public:
  /// `free_rings` outside of those.
  explicit DrapeTester(int free_rings) : spacing_((sheet - disc) / (free_rings + 0.5)) {
    const int inner = static_cast<int>(disc / spacing_ - 0.5);
    for (int ring = free_rings; ring >= -inner - 1; --ring) {
      const double radius = disc + spacing_ * (ring + 0.5);
      if (radius < 0.5 * spacing_) break;
      const int around = static_cast<int>(std::lround(2 * pi * radius / spacing_));
      std::vector<Vec2>& points = ring == free_rings ? outline_ : interior_;
      for (int i = 0; i < around; ++i) {
        // Turned against each other, so that no direction is favoured.
        const double angle = 2 * pi * (i + 0.618 * ring) / around;
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
      }
    }
    interior_.emplace_back(0, 0);
    mesh_.triangles = triangulate(outline_, interior_);
    mesh_.points = outline_;
    mesh_.points.insert(mesh_.points.end(), interior_.begin(), interior_.end());
  }

  /// The sheet, flat but for a ripple of a millimetre and a half that differs by `start`.
  GarmentModel model(const Fabric& fabric, int start) {
    std::mt19937 random(static_cast<unsigned>(start));
    std::uniform_real_distribution<double> unit(-1, 1);
    std::array<Vec2, 8> waves;
    for (Vec2& wave : waves) wave = Vec2(unit(random), unit(random));
    garment_ = {};
    test::add_panel(garment_, "sheet", mesh_, [&](const Vec2& p) {
      const double out = std::max(0.0, p.norm() - disc - 0.6 * spacing_) / (sheet - disc);
      const double angle = std::atan2(p.y(), p.x());
      double height = 0;
      for (std::size_t n = 0; n < waves.size(); ++n) {
        const double phase = static_cast<double>(n + 2) * angle;
        height += waves[n].x() * std::cos(phase) + waves[n].y() * std::sin(phase);
      }
      return Vec3(p.x(), 0.0015 * out * height, -p.y());
    });
    Scene scene;
    scene.fabric = fabric;
    GarmentModel model = compile(garment_, scene, garment_.placed);
    const double held = disc + 0.6 * spacing_;
    for (int n = 0; n < model.nodes; ++n) {
      const double r = garment_.flat[n].norm();
      if (r > held || r < disc - 0.6 * spacing_) continue;
      model.stretch_diagonal[n] = 1e30;
    }
    test::hold(model, [&](const Vec3& p) { return std::hypot(p.x(), p.z()) < held; });
    return model;
  }

  double drape_coefficient(const std::vector<Vec3>& x) const {
    const double flat = shadow(mesh_places());
    const double of_disc = pi * disc * disc;
    return (shadow(x) - of_disc) / (flat - of_disc);
  }

  int folds(const std::vector<Vec3>& x) const {
    std::vector<Vec3> rim(x.begin(), x.begin() + static_cast<long>(outline_.size()));
    const auto radius = [](const Vec3& p) { return std::hypot(p.x(), p.z()); };
    const auto first = std::min_element(rim.begin(), rim.end(), [&](const Vec3& a, const Vec3& b) {
      return radius(a) < radius(b);
    });
    std::rotate(rim.begin(), first, rim.end());
    rim.push_back(rim.front());
    test::LevelLine line;
    line.points = rim;
    return test::folds(line, 0.004);
  }

  double spacing() const { return spacing_; }
  std::size_t rim() const { return outline_.size(); }

 private:
  std::vector<Vec3> mesh_places() const {
    std::vector<Vec3> places;
    for (const Vec2& p : mesh_.points) places.emplace_back(p.x(), 0, -p.y());
    return places;
  }

  /// Of the sheet lit from above, m²: counted in cells of a quarter of a millimetre.
  double shadow(const std::vector<Vec3>& x) const {
    constexpr double cell = 0.00025;
    constexpr int half = static_cast<int>(1.05 * sheet / cell);
    std::vector<char> dark(4 * half * half, 0);
    for (const Triangle& t : mesh_.triangles) {
      std::array<Vec2, 3> c;
      for (int i = 0; i < 3; ++i) c[i] = Vec2(x[t[i]].x(), x[t[i]].z()) / cell;
      const auto cross = [](const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); };
      const double twice = cross(c[1] - c[0], c[2] - c[0]);
      if (twice == 0) continue;
      const Vec2 low = c[0].cwiseMin(c[1]).cwiseMin(c[2]);
      const Vec2 high = c[0].cwiseMax(c[1]).cwiseMax(c[2]);
      for (int j = static_cast<int>(std::floor(low.y())); j <= high.y(); ++j) {
        for (int i = static_cast<int>(std::floor(low.x())); i <= high.x(); ++i) {
          const Vec2 p(i + 0.5, j + 0.5);
          bool inside = true;
          for (int k = 0; k < 3; ++k) {
            inside = inside && cross(c[(k + 1) % 3] - c[k], p - c[k]) * twice >= 0;
          }
          if (inside) dark.at((j + half) * 2 * half + i + half) = 1;
        }
      }
    }
    return cell * cell * static_cast<double>(std::count(dark.begin(), dark.end(), 1));
  }

  double spacing_;
  std::vector<Vec2> outline_;
  std::vector<Vec2> interior_;
  PlanarMesh mesh_;
  PanelMesh garment_;
};

struct Draped {
  std::vector<Vec3> x;
  bool at_rest = false;
  double coefficient = 0;
  int folds = 0;
};

Draped drape(DrapeTester& tester, const Fabric& fabric, int start, double compression = 1) {
  const GarmentModel model = tester.model(fabric, start);
  RelaxOptions options;
  options.max_iterations = 60000;
  options.stop_median = 1e-3;  // the coefficient differs by 0.002 at most from that at 1e-4
  options.stop_rms = std::numeric_limits<double>::infinity();  // holds what is held
  options.bounded = true;
  options.compression = compression;
  Draped draped{model.start};
  draped.at_rest = relax(model, options, draped.x).converged;
  draped.coefficient = 100 * tester.drape_coefficient(draped.x);
  draped.folds = tester.folds(draped.x);
  return draped;
}

struct Spread {
  double mean = 0, least = 1e9, most = 0;
  int fewest = 1000, largest = 0, at_rest = 0;
};

constexpr int starts = 5;

Spread drape_often(DrapeTester& tester, const Fabric& fabric) {
  Spread spread;
  for (int start = 1; start <= starts; ++start) {
    const Draped one = drape(tester, fabric, start);
    spread.mean += one.coefficient / starts;
    spread.least = std::min(spread.least, one.coefficient);
    spread.most = std::max(spread.most, one.coefficient);
    spread.fewest = std::min(spread.fewest, one.folds);
    spread.largest = std::max(spread.largest, one.folds);
    spread.at_rest += one.at_rest;
  }
  return spread;
}

void state_drape(const std::string& fabric, const DrapeTester& tester, const Spread& spread) {
  const std::string mesh =
      test::number(1000 * tester.spacing(), 2) + " mm, " + std::to_string(starts) + " starts";
  test::Figure figure{"drape tester, " + fabric + ": coefficient", "relaxation", mesh, "%"};
  figure.reason = std::to_string(spread.fewest) + " to " + std::to_string(spread.largest) +
                  " folds; " + std::to_string(spread.at_rest) + " of " + std::to_string(starts) +
                  " came to rest";
  test::state(figure, spread.mean, "",
              test::number(spread.least) + " to " + test::number(spread.most) + " %");
}

TEST(Drape, TheTesterReadsShadowsOfKnownShape) {
  // What the tables say of shadows with lobes, and of a flat sheet: 1.
  DrapeTester tester(5);
  const test::ReferenceTable table("case09_drape_coefficient.csv");
  const GarmentModel model = tester.model({}, 1);
  double worst = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double mean = table.at(row, "mean_radius_m");
    if (mean <= disc) continue;
    std::vector<Vec3> x;
    for (Vec3 p : model.start) {
      const double r = std::hypot(p.x(), p.z());
      const double edge = mean + table.at(row, "amplitude_m") *
                                     std::cos(table.at(row, "lobes") * std::atan2(p.z(), p.x()));
      const double scale = r > disc ? (disc + (r - disc) / (sheet - disc) * (edge - disc)) / r : 1;
      x.emplace_back(scale * p.x(), p.y(), scale * p.z());
    }
    worst =
        std::max(worst, std::abs(tester.drape_coefficient(x) - table.at(row, "drape_coefficient")));
    EXPECT_EQ(tester.folds(x), table.at(row, "lobes"));
  }
  test::expect_near(
      {"drape tester: coefficient of shadows of known shape", "shadow", "86 rim points", "points"},
      100 * worst, 0, 0.5);
}

/// The coefficient of ideal limp cloth is 0. A mesh has no folds finer than its edges. If its
/// lengths are kept, it is held up by that. It comes down where compression is nearly free, as in
/// cloth that buckles.
void drape_limp(DrapeTester& tester, double bound) {
  Fabric limp;
  limp.bending_warp = limp.bending_weft = 1e-9;
  limp.shear = 0.5;
  const std::string mesh = test::number(1000 * tester.spacing(), 2) + " mm";
  test::Figure figure{"drape tester, without stiffness, compression nearly free: coefficient",
                      "relaxation", mesh, "%"};
  figure.reason = "no folds finer than the mesh";
  test::expect_near(figure, drape(tester, limp, 1, 0.01).coefficient, 0, bound);
  figure.what = "drape tester, without stiffness: coefficient";
  test::state(figure, drape(tester, limp, 1).coefficient, "0 %");
}

TEST(Drape, StaysWithinItsLimits) {
  DrapeTester tester(5);
  Fabric stiff;
  stiff.bending_warp = stiff.bending_weft = 1;
  test::expect_near({"drape tester, stiff as a board: coefficient", "relaxation", "11 mm", "%"},
                    drape(tester, stiff, 1).coefficient, 100, 0.2);
  drape_limp(tester, 20);
}

TEST(LongDrape, WithoutStiffnessFallsFartherAsTheMeshGetsFiner) {
  DrapeTester tester(11);
  drape_limp(tester, 10);
}

// As long as it bends by far less than it is wide, a sheet is a plate.
TEST(Drape, AStiffSheetSagsAsAPlate) {
  const test::ReferenceTable table("case09_stiff_plate.csv");
  double reference = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.at(row, "nu") == 0 && table.at(row, "r_m") == sheet) {
      reference = table.at(row, "w_times_D_over_q_m4");
    }
  }
  ASSERT_GT(reference, 0);
  for (const int rings : {5, 10}) {
    DrapeTester tester(rings);
    Fabric stiff;
    stiff.bending_warp = stiff.bending_weft = 0.01;
    GarmentModel model = tester.model(stiff, 1);
    for (Vec3& p : model.start) p.y() = 0;
    const std::vector<Vec3> x = test::relaxed(model, 1e-4);
    double sag = 0;
    for (std::size_t n = 0; n < tester.rim(); ++n) sag -= x[n].y() / tester.rim();
    const double wanted = reference * stiff.areal_density * 9.81 / stiff.bending_weft;
    test::Figure figure{"drape tester, stiff plate: sag of the rim", "relaxation",
                        test::number(1000 * tester.spacing(), 2) + " mm", "mm"};
    figure.asked = 0.02;
    test::expect_relative(figure, 1000 * sag, 1000 * wanted, 0.02);
  }
}

TEST(Drape, TheSameBitsForAnyNumberOfThreads) {
  DrapeTester tester(5);
  const auto run = [&](int threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return drape(tester, {}, 1).x;
  };
  const std::vector<Vec3> one = run(1);
  const std::vector<Vec3> again = run(2);
  EXPECT_TRUE(one == again);
  EXPECT_TRUE(one == run(2));
  double differ = 0;
  for (std::size_t n = 0; n < one.size(); ++n)
    differ = std::max(differ, (one[n] - again[n]).norm());
  test::expect_near(
      {"drape tester, run again, one thread and two: differs by", "relaxation", "11 mm", "mm"},
      1000 * differ, 0, 0);
}

TEST(Drape, OfTheDefaultFabric) {
  DrapeTester tester(5);
  const Spread spread = drape_often(tester, {});
  state_drape("default", tester, spread);
  EXPECT_EQ(spread.at_rest, starts);
}

TEST(LongDrape, OfEachFabricAsTheMeshGetsFiner) {
  for (const std::string& name : fabric_names()) {
    DrapeTester coarse(5), fine(11);
    const Spread at_coarse = drape_often(coarse, find_fabric(name));
    const Spread at_fine = drape_often(fine, find_fabric(name));
    state_drape(name, coarse, at_coarse);
    state_drape(name, fine, at_fine);
    test::Figure figure{"drape tester, " + name + ": mean coefficient, 11 mm against 5",
                        "relaxation", std::to_string(starts) + " starts", "%"};
    figure.asked = 1;
    figure.reason = "at 11 mm a fold has seven edges along the rim";
    test::expect_near(figure, at_coarse.mean, at_fine.mean, 5);
  }
}

// How much of the step from 11 mm to 5 is left from there on.
TEST(LongDrape, HardlyChangesFromFiveMillimetresOn) {
  for (const char* name : {"cotton-poplin", "denim"}) {
    DrapeTester fine(11), finest(22);
    const Spread at_fine = drape_often(fine, find_fabric(name));
    const Spread at_finest = drape_often(finest, find_fabric(name));
    state_drape(name, finest, at_finest);
    test::Figure figure{
        std::string("drape tester, ") + name + ": mean coefficient, 5 mm against 2.7", "relaxation",
        std::to_string(starts) + " starts", "%"};
    figure.asked = 1;
    figure.reason = "single starts scatter by more";
    test::expect_near(figure, at_fine.mean, at_finest.mean, 1.5);
  }
}

}  // namespace drape_test
}  // namespace toile
