#include <array>
#include <iostream>

#include "cloth/dressing/quality.h"
#include "geometry/intersections.h"
#include "tests/benchmarks/work_precision/study.h"

namespace toile::precision {

namespace {

struct Term {
  Switched term;
  const char* name;
};

constexpr std::array<Term, 6> terms = {{{Switched::none, "all terms"},
                                        {Switched::bending, "without bending"},
                                        {Switched::self_contact, "without self contact"},
                                        {Switched::edge_contact, "without edge contact"},
                                        {Switched::friction, "without friction"},
                                        {Switched::strain_limit, "with a strain limit of 1 %"}}};

}  // namespace

std::vector<TermRow> study_terms(Wardrobe& wardrobe, const WornGarment& garment, double edge_mm) {
  const Quality& quality = qualities.back();
  std::vector<TermRow> rows;
  Drape with_all;
  for (const Term& term : terms) {
    const auto scene = wardrobe.get(garment, edge_mm, term.term);
    if (!scene) return rows;
    std::cerr << garment.scene << ", " << term.name << ": " << std::flush;
    TermRow row;
    row.scene = garment.scene;
    row.term = term.name;
    // What comes to no rest ends some time.
    row.outcome = scene->run(
        Method::relaxation,
        {.knob = "terms", .value = term.name, .residual = quality.residual, .iterations = 40000});
    std::cerr << number(row.outcome.wall) << " s, " << end_of(row.outcome) << std::endl;
    const Drape drape = measure(*scene, row.outcome);
    if (rows.empty()) with_all = drape;
    row.error = error_of(drape, with_all);
    const TriangleMesh cloth = {drape.nodes, scene->model().node_triangles};
    row.self_intersections = self_intersections(cloth).size();
    row.body_intersections = intersections(cloth, scene->body()->mesh()).size();
    rows.push_back(std::move(row));
    rows.back().outcome.points.clear();
  }
  return rows;
}

std::string csv_of(const std::vector<TermRow>& rows) {
  std::string text =
      "scene,terms,wall_s,processor_s,iterations,end,distance_rms_mm,distance_max_mm,"
      "strain_p99_points,ease_mm,body_intersections,self_intersections\n";
  for (const TermRow& row : rows) {
    text += row.scene + "," + row.term + "," + number(row.outcome.wall) + "," +
            number(row.outcome.processor) + "," + std::to_string(row.outcome.iterations) + "," +
            end_of(row.outcome) + "," + number(1e3 * row.error.rms) + "," +
            number(1e3 * row.error.max) + "," + number(1e2 * row.error.strain_p99) + "," +
            number(1e3 * row.error.ease.value_or(0)) + "," +
            std::to_string(row.body_intersections) + "," + std::to_string(row.self_intersections) +
            "\n";
  }
  return text;
}

}  // namespace toile::precision
