#include "tests/benchmarks/work_precision/measure.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "cloth/ease/ease.h"
#include "cloth/judge/measures.h"
#include "pattern/file/garment_file.h"

namespace toile::precision {

Drape measure(const Case& scene, const Outcome& outcome) {
  const GarmentModel& model = scene.model();
  Drape drape;
  drape.nodes.resize(model.nodes);
  for (std::size_t p = 0; p < outcome.points.size(); ++p) {
    drape.nodes[model.node_of_point[p]] = outcome.points[p];
  }
  const DressedGarment dressed = as_dressed(scene.garment(), drape.nodes, model.node_triangles);
  drape.strain_p99 = measure_garment(scene.garment(), dressed).strain_off_seams.p99;
  drape.lowest = drape.nodes.front().y();
  for (const Vec3& p : drape.nodes) drape.lowest = std::min(drape.lowest, p.y());
  if (scene.body() != nullptr) {
    drape.gaps = measure_ease(dressed, *scene.body()).node_gaps;
    drape.ease = std::accumulate(drape.gaps.begin(), drape.gaps.end(), 0.0) /
                 static_cast<double>(drape.gaps.size());
  }
  return drape;
}

Error error_of(const Drape& drape, const Drape& reference) {
  Error error;
  const auto count = static_cast<double>(reference.nodes.size());
  for (std::size_t n = 0; n < reference.nodes.size(); ++n) {
    const double square = (drape.nodes[n] - reference.nodes[n]).squaredNorm();
    error.rms += square / count;
    error.max = std::max(error.max, square);
  }
  error.rms = std::sqrt(error.rms);
  error.max = std::sqrt(error.max);
  error.strain_p99 = std::abs(drape.strain_p99 - reference.strain_p99);
  if (reference.gaps.empty()) return error;
  double sum = 0;
  for (std::size_t n = 0; n < reference.gaps.size(); ++n) {
    sum += std::abs(drape.gaps[n] - reference.gaps[n]);
  }
  error.ease = sum / count;
  return error;
}

std::string number(double value, int significant) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", significant, value);
  return text;
}

std::string csv_of(const std::vector<Row>& rows) {
  std::string text =
      "scene,edge_mm,nodes,method,knob,value,wall_s,processor_s,iterations,simulated_s,end,"
      "residual_median,residual_rms,distance_rms_mm,distance_max_mm,strain_p99_percent,"
      "strain_p99_error_points,ease_mean_mm,ease_error_mm,lowest_m,models_apart_rms_mm,"
      "reference_residual_median,reference_end\n";
  for (const Row& row : rows) {
    const Outcome& run = row.outcome;
    const bool worn = row.error.ease.has_value();
    const std::vector<std::string> cells = {row.scene,
                                            number(row.edge_mm),
                                            std::to_string(row.nodes),
                                            row.method,
                                            row.knob,
                                            row.value,
                                            number(run.wall),
                                            number(run.processor),
                                            std::to_string(run.iterations),
                                            number(run.simulated),
                                            end_of(run),
                                            number(run.residual.median),
                                            number(run.residual.rms),
                                            number(1e3 * row.error.rms),
                                            number(1e3 * row.error.max),
                                            number(1e2 * row.drape.strain_p99),
                                            number(1e2 * row.error.strain_p99),
                                            worn ? number(1e3 * row.drape.ease) : "",
                                            worn ? number(1e3 * *row.error.ease) : "",
                                            number(row.drape.lowest),
                                            row.models_apart ? number(1e3 * *row.models_apart) : "",
                                            number(row.reference_residual),
                                            row.reference_end};
    for (std::size_t i = 0; i < cells.size(); ++i) text += (i > 0 ? "," : "") + cells[i];
    text += "\n";
  }
  return text;
}

}  // namespace toile::precision
