// What the rows say: selections and sentences, all computed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/benchmarks/work_precision/page.h"

namespace toile::precision {

/// Scenes in their order; the mesh of each on which all knobs were turned.
struct MeshedScene {
  std::string name;
  double edge_mm = 0;
};
std::vector<MeshedScene> meshed_scenes(const std::vector<Row>& rows);

/// Rows of a scene, a mesh and a method ("": both), the references left out.
std::vector<const Row*> rows_of(const std::vector<Row>& rows, const MeshedScene& scene,
                                const std::string& method);
const Row* find_row(const std::vector<Row>& rows, const MeshedScene& scene,
                    const std::string& method, const std::string& knob, const std::string& value);

/// Least processor time of the runs that ended no farther than that (metres, rms) from their rest.
std::optional<double> seconds_within(const std::vector<Row>& rows, const MeshedScene& scene,
                                     const std::string& method, double distance);
/// Distances that seconds_within() is asked for, metres.
inline constexpr double asked_distances[] = {0.1, 0.03, 0.01, 0.003, 0.001, 0.0003};

/// Where each method loses to the other, or to itself, in sentences.
std::vector<std::string> losses(const Results& results);

/// The presets at Results::presets_mm: garment, preset, and its figures.
struct Preset {
  const Row* row;
  double time_ratio;  ///< of processor times, to standard
};
std::vector<Preset> presets(const Results& results);

std::string mm(double metres, int digits = 2);

}  // namespace toile::precision
