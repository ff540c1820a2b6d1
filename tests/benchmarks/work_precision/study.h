// Which knobs are turned, and what comes of it.
#pragma once

#include <functional>
#include <vector>

#include "tests/benchmarks/work_precision/measure.h"
#include "tests/benchmarks/work_precision/worn.h"

namespace toile::precision {

/// What is run of one case.
struct Plan {
  bool paper = true;
  bool all_knobs = true;      ///< else the presets and the paper's defaults only
  bool few_of_paper = false;  ///< where a run of the paper's method takes minutes
  bool fast = false;          ///< less of everything: to see that it runs
};

/// Each method's reference, and each setting of its knobs, against it. Says on stderr what it does.
std::vector<Row> study(const Case& scene, const Plan& plan);

/// A line of the table of terms.
struct TermRow {
  std::string scene;
  std::string term;
  Outcome outcome;
  Error error;  ///< of the drape without the term, brought as far to rest, against that with all
  std::size_t body_intersections = 0;
  std::size_t self_intersections = 0;
};

/// What each term costs and buys on a garment: with all terms first, then with one switched. Empty
/// where the garment's data is absent.
std::vector<TermRow> study_terms(Wardrobe& wardrobe, const WornGarment& garment, double edge_mm);
std::string csv_of(const std::vector<TermRow>& rows);

}  // namespace toile::precision
