#include "cloth/dressing/journal.h"

#include <algorithm>

namespace toile {

namespace {

/// Reports of a run between two frames: a frame every 200 iterations.
constexpr int frame_interval = 4;

}  // namespace

StageReport stage_of(const std::string& name, int nodes, const RelaxReport& report) {
  StageReport stage;
  stage.name = name;
  stage.open = report.open.empty() ? 0 : *std::ranges::max_element(report.open);
  stage.nodes = nodes;
  stage.steps = report.iterations;
  stage.searches = report.searches;
  stage.seconds = report.seconds;
  stage.converged = report.converged;
  stage.residual = report.residual;
  return stage;
}

void Journal::begin_attempt(int attempt) {
  attempt_ = attempt;
  during_ = {};
}

RelaxReport Journal::run(const std::string& stage, const PanelMesh& mesh, const GarmentModel& model,
                         const RelaxOptions& options, std::vector<Vec3>& x, double end) {
  const std::vector<double> areas = panel_areas(mesh);
  const Outlines outlines = panel_outlines(mesh);
  const std::vector<double> perimeters = panel_perimeters(mesh);
  const double begin = progress_;
  int calls = 0;
  RelaxReport report = relax(model, options, x, [&](const RelaxProgress& at) {
    const std::vector<Vec3> points = point_positions(model, at.nodes, at.open);
    measure(mesh, areas, outlines, perimeters, points);
    progress_ = begin + (end - begin) * at.iteration / options.max_iterations;
    if (watcher_ && calls++ % frame_interval == 0) show(mesh, stage, points);
  });
  progress_ = end;
  if (watcher_) show(mesh, stage, point_positions(model, x, report.open));
  stages_.push_back(stage_of(stage, model.nodes, report));
  stages_.back().attempt = attempt_;
  return report;
}

void Journal::add(const StageReport& stage, const PanelMesh& mesh,
                  const std::vector<Vec3>& points) {
  stages_.push_back(stage);
  if (watcher_) show(mesh, stage.name, points);
}

void Journal::join_stages(std::size_t first) {
  if (first >= stages_.size()) return;
  StageReport joined = stages_.back();
  for (std::size_t i = first; i + 1 < stages_.size(); ++i) {
    joined.steps += stages_[i].steps;
    joined.searches += stages_[i].searches;
    joined.seconds += stages_[i].seconds;
  }
  stages_.resize(first);
  stages_.push_back(joined);
}

void Journal::show(const PanelMesh& mesh, const std::string& stage,
                   std::vector<Vec3> points) const {
  if (view_) std::ranges::transform(points, points.begin(), view_);
  watcher_({mesh, stage, points, progress_});
}

void Journal::measure(const PanelMesh& mesh, const std::vector<double>& areas,
                      const Outlines& outlines, const std::vector<double>& perimeters,
                      const std::vector<Vec3>& points) {
  const double area = largest_change(areas, panel_areas(mesh, points));
  const double perimeter = largest_change(perimeters, panel_perimeters(outlines, points));
  during_.area = std::max(during_.area, area);
  during_.perimeter = std::max(during_.perimeter, perimeter);
}

}  // namespace toile
