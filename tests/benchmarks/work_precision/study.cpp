#include "tests/benchmarks/work_precision/study.h"

#include <iostream>

#include "cloth/dressing/quality.h"

namespace toile::precision {

namespace {

/// Far below what any preset asks for: what is left moves nothing that the errors would show.
constexpr double at_rest = 1e-5;

Setting reference_of(const Case& scene, Method method, const Plan& plan) {
  Setting setting;
  setting.knob = "reference";
  setting.residual = method == Method::relaxation ? at_rest : scene.springs_at_rest();
  if (plan.fast) setting.residual *= 10;
  setting.exact_limit = true;
  setting.seconds = plan.fast || plan.few_of_paper ? 3 : 8;
  return setting;
}

std::vector<Setting> relaxation_settings(const Plan& plan) {
  std::vector<Setting> settings;
  for (const Quality& quality : qualities) {
    settings.push_back({.knob = "quality", .value = quality.name, .residual = quality.residual});
  }
  if (!plan.all_knobs || plan.fast) return settings;
  for (const double residual : {0.5, 0.2, 0.02, 0.005, 0.0003, 0.0001}) {
    settings.push_back({.knob = "residual", .value = number(residual), .residual = residual});
  }
  for (const int iterations : {250, 500, 1000, 2000, 4000, 8000}) {
    settings.push_back({.knob = "iterations",
                        .value = std::to_string(iterations),
                        .residual = at_rest,
                        .iterations = iterations});
  }
  return settings;
}

std::vector<Setting> paper_settings(const Plan& plan) {
  constexpr double standard = 0.05;  // of --method paper
  std::vector<Setting> settings;
  settings.push_back({.knob = "default", .value = "", .residual = standard});
  if (!plan.all_knobs || plan.fast) return settings;
  settings.push_back(
      {.knob = "exact limit", .value = "", .residual = standard, .exact_limit = true});
  if (plan.few_of_paper) return settings;
  for (const double residual : {0.5, 0.2, 0.02}) {
    settings.push_back({.knob = "residual", .value = number(residual), .residual = residual});
  }
  for (const double share : {0.45}) {
    settings.push_back(
        {.knob = "step share", .value = number(share), .residual = standard, .step_share = share});
  }
  for (const double seconds : {0.3, 0.8, 2.4}) {
    settings.push_back({.knob = "simulated seconds",
                        .value = number(seconds),
                        .residual = 1e-9,
                        .seconds = seconds});
  }
  return settings;
}

struct Ran {
  Outcome outcome;
  Drape drape;
};

Ran run(const Case& scene, Method method, const Setting& setting) {
  std::cerr << scene.scene() << ", " << number(scene.edge_mm()) << " mm, " << name_of(method)
            << ", " << setting.knob << ' ' << setting.value << ": " << std::flush;
  Ran ran;
  ran.outcome = scene.run(method, setting);
  ran.drape = measure(scene, ran.outcome);
  const Outcome& done = ran.outcome;
  std::cerr << number(done.wall) << " s, " << number(done.processor) << " s of processors, "
            << done.iterations << " iterations, residual " << number(done.residual.median) << ", "
            << end_of(done) << std::endl;
  return ran;
}

void add_rows(const Case& scene, Method method, const std::vector<Setting>& settings,
              const Setting& reference_setting, const Ran& reference,
              const std::optional<double>& apart, std::vector<Row>& rows) {
  const auto add = [&](const Setting& setting, const Ran& ran) {
    Row row;
    row.scene = scene.scene();
    row.edge_mm = scene.edge_mm();
    row.nodes = reference.drape.nodes.size();
    row.method = name_of(method);
    row.knob = setting.knob;
    row.value = setting.value;
    row.error = error_of(ran.drape, reference.drape);
    row.outcome = ran.outcome;
    row.outcome.points.clear();
    row.drape = ran.drape;
    row.drape.nodes.clear();
    row.drape.gaps.clear();
    row.reference_residual = reference.outcome.residual.median;
    row.reference_end = end_of(reference.outcome);
    row.models_apart = apart;
    rows.push_back(std::move(row));
  };
  add(reference_setting, reference);
  for (const Setting& setting : settings) add(setting, run(scene, method, setting));
}

}  // namespace

std::vector<Row> study(const Case& scene, const Plan& plan) {
  const Setting at_rest_of = reference_of(scene, Method::relaxation, plan);
  const Ran relaxation = run(scene, Method::relaxation, at_rest_of);
  std::vector<Row> rows;
  if (!plan.paper) {
    add_rows(scene, Method::relaxation, relaxation_settings(plan), at_rest_of, relaxation, {},
             rows);
    return rows;
  }
  const Setting paper_at_rest = reference_of(scene, Method::paper, plan);
  const Ran paper = run(scene, Method::paper, paper_at_rest);
  std::optional<double> apart;
  if (paper.outcome.sewn) apart = error_of(paper.drape, relaxation.drape).rms;
  add_rows(scene, Method::relaxation, relaxation_settings(plan), at_rest_of, relaxation, apart,
           rows);
  // Where it does not sew, there is no rest to be near to.
  add_rows(scene, Method::paper, paper.outcome.sewn ? paper_settings(plan) : std::vector<Setting>(),
           paper_at_rest, paper, apart, rows);
  return rows;
}

}  // namespace toile::precision
