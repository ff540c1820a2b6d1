// How far the end of a run is from where it should be.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/benchmarks/work_precision/case.h"

namespace toile::precision {

/// What can be measured on one drape.
struct Drape {
  std::vector<Vec3> nodes;
  double strain_p99 = 0;     ///< off the seams, a fraction
  double lowest = 0;         ///< metres, height of the lowest node
  std::vector<double> gaps;  ///< metres, per node; empty: there is no body
  double ease = 0;           ///< mean of the gaps
};
Drape measure(const Case& scene, const Outcome& outcome);

struct Error {
  double rms = 0;  ///< metres, of the nodes' distances
  double max = 0;
  double strain_p99 = 0;       ///< |difference|
  std::optional<double> ease;  ///< metres, mean |difference of gaps|
};
Error error_of(const Drape& drape, const Drape& reference);

/// A line of the CSV.
struct Row {
  std::string scene;
  double edge_mm = 0;
  std::size_t nodes = 0;
  std::string method;
  std::string knob;
  std::string value;
  Outcome outcome;  ///< its points are not kept
  Drape drape;      ///< its nodes and gaps are not kept
  Error error;      ///< against the same method's reference
  double reference_residual = 0;
  std::string reference_end;           ///< as end_of()
  std::optional<double> models_apart;  ///< metres, rms between the methods' references
};

/// A heading and its rows, comma-separated.
std::string csv_of(const std::vector<Row>& rows);

std::string number(double value, int significant = 4);

}  // namespace toile::precision
