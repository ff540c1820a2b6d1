// Writes the limits of the paper's method by the length of edges: the largest stable step, and the
// cost of a step. It finds up to which step the explicit motion is stable, and up to which the
// strain control holds.
#include <algorithm>
#include <cmath>
#include <iostream>

#include "tests/figures/sheet.h"

namespace toile::figures {
namespace {

/// Thrown out of a dressing that has lost its cloth.
struct BlewUp {};

struct Trial {
  bool blew_up = false;
  double max_strain = 0;  ///< of any edge at any look
  double time_step = 0;   ///< seconds
  long steps = 0;
  double seconds_per_step = 0;
};

/// The first `simulated` seconds of the wrap.
Trial wrap(const PanelMesh& garment, const Wearer& wearer, const SpringOptions& motion,
           double simulated) {
  constexpr double lost = 0.1;  // strain: what is stable has less than half of it
  Scene scene;
  scene.collider = &wearer.subject;
  scene.skeleton = &wearer.mannequin.skeleton;
  SpringDressOptions options;
  options.motion = motion;
  options.longest_wrap = simulated;
  options.longest_sew = options.longest_drape = 0;
  Trial trial;
  const auto look = [&](const DressFrame& frame) {
    for (const Triangle& t : garment.triangles) {
      for (int k = 0; k < 3; ++k) {
        const int a = t[k];
        const int b = t[(k + 1) % 3];
        const double strain = std::abs((frame.points[a] - frame.points[b]).norm() /
                                           (garment.flat[a] - garment.flat[b]).norm() -
                                       1);
        if (!(strain < lost)) throw BlewUp();
        trial.max_strain = std::max(trial.max_strain, strain);
      }
    }
  };
  try {
    const DressResult result = dress_springs(garment, scene, options, look);
    trial.time_step = result.time_step;
    for (const StageReport& stage : result.stages) {
      trial.steps += stage.steps;
      trial.seconds_per_step += stage.seconds;
    }
    trial.seconds_per_step /= static_cast<double>(std::max(1L, trial.steps));
  } catch (const BlewUp&) {
    trial.blew_up = true;
  }
  return trial;
}

void by_edge_length(const Wearer& wearer, Sheet& sheet) {
  constexpr double simulated = 0.03;
  std::vector<std::vector<std::string>> rows;
  for (const double edge_mm : {30, 25, 20, 15, 10, 7}) {
    const PanelMesh garment = sample_garment("tshirt", edge_mm / 1000);
    const SpringOptions motion;
    const Trial trial = wrap(garment, wearer, motion, simulated);
    const double stable = trial.time_step / motion.step_share;
    std::cerr << "edges of " << edge_mm << " mm: stable step " << 1e6 * stable << " us, "
              << 1e3 * trial.seconds_per_step << " ms a step" << std::endl;
    rows.push_back({number(edge_mm, 0), std::to_string(garment.flat.size()),
                    number(1e6 * stable, 1), number(1e3 * trial.seconds_per_step, 2),
                    number(trial.seconds_per_step / trial.time_step, 0)});
  }
  sheet.table(
      "The T-shirt by the length of its edges, while wrapping",
      {"edges, mm", "points", "largest stable step, µs", "ms a step", "seconds a simulated second"},
      rows);
}

void by_step(const SheetSettings& settings, const Wearer& wearer, Sheet& sheet) {
  constexpr double simulated = 0.25;
  const PanelMesh garment = sample_garment("tshirt", settings.edge_length);
  SpringOptions motion;
  const double stable = wrap(garment, wearer, motion, 0.001).time_step / motion.step_share;
  std::vector<std::vector<std::string>> rows;
  double last_stable = 0;
  for (const double share : {0.25, 0.5, 0.9, 1.0, 1.1, 1.2, 1.4, 1.7, 2.0}) {
    std::vector<std::string> row = {number(share, 2), number(1e6 * share * stable, 1)};
    for (const StrainScheme scheme : {StrainScheme::none, StrainScheme::velocity}) {
      motion.time_step = share * stable;
      motion.strain_scheme = scheme;
      const Trial trial = wrap(garment, wearer, motion, simulated);
      row.push_back(trial.blew_up ? "lost" : number(100 * trial.max_strain, 2));
      if (scheme == StrainScheme::none && !trial.blew_up)
        last_stable = std::max(last_stable, share);
    }
    std::cerr << "share " << share << ": " << row[2] << ", " << row[3] << std::endl;
    rows.push_back(row);
  }
  sheet.table("Largest strain while wrapping, %, by the step",
              {"step, of the largest stable", "µs", "no strain control", "velocities at 1 %"},
              rows);
  sheet.say(
      "The bound of the largest stable step is safe: without strain control the T-shirt "
      "keeps its cloth up to " +
      number(last_stable, 2) + " of it, as far as was tried.");
}

void write(const SheetSettings& settings) {
  Sheet sheet(settings.folder, "limits", "The method's limits");
  const Wearer wearer(standing_pose());
  by_edge_length(wearer, sheet);
  by_step(settings, wearer, sheet);
  sheet.write();
}

}  // namespace
}  // namespace toile::figures

int main(int argc, char** argv) {
  return toile::figures::run_sheet(argc, argv, toile::figures::write);
}
