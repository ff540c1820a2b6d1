// Writes Fig. 9 of Zhong & Xu 2009. It shows the hanging cloth without strain control, with
// positions adjusted at 10 %, and with velocities adjusted at 1 %. It also shows for which step
// three passes hold 1 %.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "io/output_file.h"
#include "io/view/picture.h"
#include "tests/figures/hanging_cloth.h"
#include "tests/figures/sheet.h"

namespace toile::figures {
namespace {

constexpr double held_within = 0.001;  // strain over the limit that counts as held

struct Case {
  std::string name;
  HangingClothOptions options;
  HangingCloth cloth;
};

StrainControlOptions in_order(double limit, bool compression) {
  StrainControlOptions options;
  options.limit = limit;
  options.compression = compression;
  options.sweep = StrainSweep::in_order;
  options.mean_of_passes = false;
  options.passes = 1000;
  options.tolerance = held_within;
  return options;
}

Case run(const std::string& name, StrainScheme scheme, const StrainControlOptions& control,
         double dt, std::optional<test::JacobiSum> jacobi = {}) {
  Case result{name, {}, {}};
  result.options.scheme = scheme;
  result.options.control = control;
  result.options.jacobi = jacobi;
  result.options.dt = dt;
  result.cloth = hang_cloth(result.options);
  const HangingCloth& c = result.cloth;
  std::cerr << name << ", step " << 1e3 * dt << " ms: "
            << (c.blew_up ? "blew up"
                          : "corners " + std::to_string(100 * c.strain.corners) + " %, max " +
                                std::to_string(100 * c.strain.max) + " %")
            << "\n";
  return result;
}

std::string table(const std::vector<Case>& cases) {
  std::ostringstream csv;
  csv << "case,step_s,corner_strain,max_strain,p99_strain,max_strain_during,held_within_0.001,"
         "blew_up,at_rest,fastest_m_s,simulated_s,passes_per_step,microseconds_per_step,wall_s\n";
  for (const Case& one : cases) {
    const HangingCloth& c = one.cloth;
    const double limit = one.options.control.limit;
    csv << '"' << one.name << "\"," << one.options.dt << ',';
    if (c.blew_up) {
      csv << ",,,,0,1,0,,";
    } else {
      // A bound just met rounds either way.
      csv << c.strain.corners << ',' << c.strain.max << ',' << c.strain.p99 << ',' << c.max_during
          << ',' << (c.strain.max <= limit + held_within + 1e-9) << ",0," << c.at_rest << ','
          << c.fastest << ',';
    }
    csv << c.seconds << ',' << c.passes << ',' << 1e6 * c.wall_seconds / c.steps << ','
        << c.wall_seconds << '\n';
  }
  return csv.str();
}

std::string curves(const std::vector<Case>& cases) {
  std::ostringstream csv;
  csv << "case,seconds,corner_strain,max_strain\n";
  for (const Case& one : cases) {
    for (const HangingClothMoment& m : one.cloth.curve) {
      csv << '"' << one.name << "\"," << m.seconds << ',' << m.corners << ',' << m.max << '\n';
    }
  }
  return csv.str();
}

TriangleMesh mesh_of(const HangingCloth& cloth) {
  TriangleMesh mesh;
  mesh.points = cloth.x;
  const test::SpringGrid& g = cloth.grid;
  for (int r = 0; r + 1 < g.rows; ++r) {
    for (int c = 0; c + 1 < g.columns; ++c) {
      mesh.triangles.push_back({g.node(c, r), g.node(c, r + 1), g.node(c + 1, r + 1)});
      mesh.triangles.push_back({g.node(c, r), g.node(c + 1, r + 1), g.node(c + 1, r)});
    }
  }
  return mesh;
}

/// Percent, per node: the largest strain of the springs that meet there.
std::vector<double> strains_of(const HangingCloth& cloth) {
  std::vector<double> percent(cloth.x.size(), 0);
  for (const Spring& s : cloth.grid.limited()) {
    const double strain = 100 * std::abs((cloth.x[s.b] - cloth.x[s.a]).norm() / s.rest - 1);
    for (const int end : {s.a, s.b}) percent[end] = std::max(percent[end], strain);
  }
  return percent;
}

std::string picture(const std::vector<Case>& cases) {
  Picture picture;
  picture.title = "Fig. 9: " + cases[0].name;
  for (std::size_t i = 1; i < cases.size(); ++i) picture.title += "  |  " + cases[i].name;
  picture.views = {View::front};
  picture.view_width = 1800;
  picture.bar = ColourBar{"strain of the springs at a node, %", magnitude_ramp(0, 12), ""};
  std::vector<PictureMesh> meshes;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    PictureMesh mesh;
    mesh.mesh = mesh_of(cases[i].cloth);
    for (Vec3& p : mesh.mesh.points) p.x() += 1.25 * static_cast<double>(i);
    mesh.values = strains_of(cases[i].cloth);
    mesh.ramp = picture.bar->ramp;
    meshes.push_back(std::move(mesh));
  }
  return picture_png(std::move(meshes), picture);
}

std::string percent(double fraction) { return number(100 * fraction, 2) + " %"; }

void write_sheet(const std::vector<Case>& shown, const std::vector<Case>& steps, Sheet& sheet) {
  sheet.say(
      "A square metre of soft cloth, 17 × 17 nodes, two corners held, let go from the "
      "horizontal. Strain is that of structural and shear springs.");
  sheet.pictures("Without control, positions adjusted, velocities adjusted",
                 {{picture(shown), "at rest"}});
  Chart chart{"Strain of the springs at the held corners", "seconds simulated", "strain, %", {}};
  std::vector<std::vector<std::string>> rows;
  for (const Case& one : shown) {
    Curve curve{one.name, {}, false};
    for (const HangingClothMoment& m : one.cloth.curve) {
      curve.points.emplace_back(m.seconds, 100 * m.corners);
    }
    chart.curves.push_back(curve);
    rows.push_back({one.name, number(1e3 * one.options.dt, 4), percent(one.cloth.strain.corners),
                    percent(one.cloth.strain.max), percent(one.cloth.max_during)});
  }
  sheet.chart(chart);
  const std::vector<std::string> columns = {"case", "step, ms", "corners", "largest",
                                            "largest on the way"};
  sheet.table("Strain at rest", columns, rows);
  rows.clear();
  for (const Case& one : steps) {
    const HangingCloth& c = one.cloth;
    const std::string step = number(1e3 * one.options.dt, 4);
    if (c.blew_up) {
      rows.push_back({one.name, step, "blew up", "", ""});
    } else {
      rows.push_back({one.name, step, percent(c.strain.corners), percent(c.strain.max),
                      percent(c.max_during)});
    }
  }
  sheet.table("For which step velocities hold 1 %", columns, rows);
  sheet.compare("hanging cloth, strain limit of the positions", "10 %",
                "corners " + percent(shown[1].cloth.strain.corners),
                shown[1].cloth.strain.max <= 0.1 + held_within + 1e-9);
  sheet.compare("hanging cloth, strain limit of the velocities", "1 %",
                "corners " + percent(shown[2].cloth.strain.corners) + ", largest " +
                    percent(shown[2].cloth.strain.max) + " at a step of " +
                    number(1e3 * shown[2].options.dt, 4) + " ms",
                shown[2].cloth.strain.max <= 0.01 + held_within + 1e-9);
  sheet.compare("hanging cloth without control", "“over elongated” at the corners",
                "corners " + percent(shown[0].cloth.strain.corners));
  sheet.write();
}

void write(const SheetSettings& settings) {
  const std::filesystem::path& folder = settings.folder;
  Sheet sheet(folder, "fig9", "Fig. 9: a hanging cloth with different strain controls");
  const std::vector<Case> shown = {
      run("no control", StrainScheme::none, {}, 0.000125),
      run("positions, 10 %, to convergence", StrainScheme::position, in_order(0.1, false),
          0.000125),
      run("velocities, 1 %, mean of three passes", StrainScheme::velocity, {}, 0.0000625)};
  std::vector<Case> all = shown;
  all.push_back(
      run("positions, 10 %, one sweep", StrainScheme::position, provot_options(), 0.000125));
  write_file(folder / "fig9.csv", table(all));
  write_file(folder / "fig9_curves.csv", curves(all));

  std::vector<Case> steps;
  for (const double dt : {0.002, 0.001, 0.0005, 0.00025, 0.000125, 0.0000625}) {
    steps.push_back(run("three passes, shared, mean", StrainScheme::velocity, {}, dt));
    steps.push_back(
        run("three passes, summed, mean", StrainScheme::velocity, {}, dt, test::JacobiSum::summed));
    steps.push_back(run("three passes, node average, mean", StrainScheme::velocity, {}, dt,
                        test::JacobiSum::node_average));
    steps.push_back(
        run("in order, to 0.1 % over", StrainScheme::velocity, in_order(0.01, true), dt));
  }
  write_file(folder / "fig9_steps.csv", table(steps));
  write_sheet(shown, steps, sheet);
}

}  // namespace
}  // namespace toile::figures

int main(int argc, char** argv) {
  return toile::figures::run_sheet(argc, argv, toile::figures::write);
}
