#include "cloth/fabric_test/drape_tester.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "cloth/model/compile.h"
#include "cloth/relaxation/relax.h"
#include "geometry/triangulate.h"

namespace toile {

namespace {

/// Metres: a cell of the shadow's raster. Half and double were not tried.
constexpr double raster_cell = 0.00025;

/// Metres by which a fold goes out and in at least. Creases of single triangles are shallower.
constexpr double node_depth = 0.004;

/// Metres, about: the ripple that a sheet starts with, at its rim. Without one it would not know
/// where to fold.
constexpr double ripple = 0.0015;

/// Share of the stiffness that resists compression while the sheet finds its folds, as in dress.
/// Without that step a coarse sheet stands on creases that it can't break. Silk of 11 mm edges
/// reads 66 to 70 % for 44 %. Five times as much reads 51 %.
constexpr double settling_compression = 0.02;

/// Rings beside the plate's edge: both are held.
constexpr double held_rings = 0.6;

}  // namespace

DrapeTester::DrapeTester(const DrapeTesterSizes& sizes) : sizes_(sizes) {
  const double over = sizes.sheet - sizes.plate;
  const int free_rings = std::max(2, static_cast<int>(std::lround(over / sizes.spacing - 0.5)));
  spacing_ = over / (free_rings + 0.5);
  const int inner = static_cast<int>(sizes.plate / spacing_ - 0.5);
  for (int ring = free_rings; ring >= -inner - 1; --ring) {
    const double radius = sizes.plate + spacing_ * (ring + 0.5);
    if (radius < 0.5 * spacing_) break;
    const int around = static_cast<int>(std::lround(2 * std::numbers::pi * radius / spacing_));
    std::vector<Vec2>& points = ring == free_rings ? outline_ : interior_;
    for (int i = 0; i < around; ++i) {
      // Turned against each other, so that no direction is favoured.
      const double angle = 2 * std::numbers::pi * (i + 0.618 * ring) / around;
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
  }
  interior_.emplace_back(0, 0);
  mesh_.triangles = triangulate(outline_, interior_);
  mesh_.points = outline_;
  mesh_.points.insert(mesh_.points.end(), interior_.begin(), interior_.end());
}

GarmentModel DrapeTester::model(const Fabric& fabric, int start) const {
  std::mt19937 random(static_cast<unsigned>(start));
  std::uniform_real_distribution<double> unit(-1, 1);
  std::array<Vec2, 8> waves;
  for (Vec2& wave : waves) wave = Vec2(unit(random), unit(random));
  const double held = sizes_.plate + held_rings * spacing_;
  PanelMesh sheet;
  sheet.flat = mesh_.points;
  sheet.triangles = mesh_.triangles;
  for (const Vec2& p : mesh_.points) {
    const double out = std::max(0.0, p.norm() - held) / (sizes_.sheet - sizes_.plate);
    const double angle = std::atan2(p.y(), p.x());
    double height = 0;
    for (std::size_t n = 0; n < waves.size(); ++n) {
      const double phase = static_cast<double>(n + 2) * angle;
      height += waves[n].x() * std::cos(phase) + waves[n].y() * std::sin(phase);
    }
    sheet.placed.emplace_back(p.x(), ripple * out * height, -p.y());
  }
  MeshedPanel& panel = sheet.panels.emplace_back();
  panel.name = "sheet";
  panel.points = static_cast<int>(sheet.flat.size());
  panel.triangles = static_cast<int>(sheet.triangles.size());
  Scene scene;
  scene.fabric = fabric;
  GarmentModel model = compile(sheet, scene, sheet.placed);
  for (int n = 0; n < model.nodes; ++n) {
    if (sheet.flat[n].norm() >= held) continue;
    // No force moves what is stiff beyond all others, and weighs nothing.
    model.stretch_diagonal[n] = 1e30;
    model.mass[n] = 0;
  }
  return model;
}

TestDrape DrapeTester::drape(const Fabric& fabric, int start, double compression) const {
  const GarmentModel sheet = model(fabric, start);
  RelaxOptions options;
  options.max_iterations = 60000;
  options.stop_median = 1e-3;  // the coefficient differs by 0.2 points at most from that at 1e-4
  options.stop_rms = std::numeric_limits<double>::infinity();  // holds what is held
  options.bounded = true;
  TestDrape drape;
  drape.mesh = {sheet.start, sheet.node_triangles};
  // It finds its folds as cloth does that dress settles.
  options.compression = std::min(settling_compression, compression);
  relax(sheet, options, drape.mesh.points);
  options.compression = compression;
  drape.at_rest = relax(sheet, options, drape.mesh.points).converged;
  drape.coefficient = coefficient(drape.mesh.points);
  drape.nodes = nodes(drape.mesh.points);
  for (std::size_t n = 0; n < rim(); ++n) {
    drape.drop -= drape.mesh.points[n].y() / static_cast<double>(rim());
  }
  return drape;
}

double DrapeTester::coefficient(const std::vector<Vec3>& x) const {
  const double of_plate = std::numbers::pi * sizes_.plate * sizes_.plate;
  return (shadow(x) - of_plate) / (shadow(flat()) - of_plate);
}

int DrapeTester::nodes(const std::vector<Vec3>& x) const {
  std::vector<double> radii;
  for (std::size_t n = 0; n < rim(); ++n) radii.push_back(std::hypot(x[n].x(), x[n].z()));
  std::rotate(radii.begin(), std::min_element(radii.begin(), radii.end()), radii.end());
  radii.push_back(radii.front());
  int found = 0;
  bool out = true;
  double extreme = 0;
  for (const double r : radii) {
    extreme = out ? std::max(extreme, r) : std::min(extreme, r);
    if (out ? r >= extreme - node_depth : r <= extreme + node_depth) continue;
    found += static_cast<int>(out);
    out = !out;
    extreme = r;
  }
  return found;
}

std::vector<Vec3> DrapeTester::flat() const {
  std::vector<Vec3> places;
  for (const Vec2& p : mesh_.points) places.emplace_back(p.x(), 0, -p.y());
  return places;
}

/// Of the sheet lit from above, m².
double DrapeTester::shadow(const std::vector<Vec3>& x) const {
  const int half = static_cast<int>(1.05 * sizes_.sheet / raster_cell);
  const std::size_t side = 2 * static_cast<std::size_t>(half);
  std::vector<char> dark(side * side, 0);
  const auto cross = [](const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); };
  for (const Triangle& t : mesh_.triangles) {
    std::array<Vec2, 3> c;
    for (int i = 0; i < 3; ++i) c[i] = Vec2(x[t[i]].x(), x[t[i]].z()) / raster_cell;
    const double twice = cross(c[1] - c[0], c[2] - c[0]);
    if (twice == 0 || !std::isfinite(twice)) continue;
    const auto in_raster = [&](const Vec2& p) {
      return Vec2(p.cwiseMax(-half).cwiseMin(half - 1));
    };
    const Vec2 low = in_raster(c[0].cwiseMin(c[1]).cwiseMin(c[2]));
    const Vec2 high = in_raster(c[0].cwiseMax(c[1]).cwiseMax(c[2]));
    for (int j = static_cast<int>(std::floor(low.y())); j <= high.y(); ++j) {
      for (int i = static_cast<int>(std::floor(low.x())); i <= high.x(); ++i) {
        const Vec2 p(i + 0.5, j + 0.5);
        bool inside = true;
        for (int k = 0; k < 3; ++k) {
          inside = inside && cross(c[(k + 1) % 3] - c[k], p - c[k]) * twice >= 0;
        }
        if (inside) {
          dark.at(static_cast<std::size_t>(j + half) * side + static_cast<std::size_t>(i + half)) =
              1;
        }
      }
    }
  }
  return raster_cell * raster_cell * static_cast<double>(std::ranges::count(dark, 1));
}

}  // namespace toile
