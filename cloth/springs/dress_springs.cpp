#include "cloth/springs/dress_springs.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "cloth/judge/measures.h"
#include "cloth/model/compile.h"
#include "cloth/scene/collider.h"
#include "cloth/springs/constants.h"
#include "cloth/start/start.h"
#include "geometry/error.h"
#include "geometry/intersections.h"

namespace toile {

namespace {

/// Looks between two frames for those who watch.
constexpr int frame_looks = 2;

class SpringDressing {
 public:
  SpringDressing(const PanelMesh& garment, const Scene& scene, const SpringDressOptions& options,
                 const FrameWatcher& watcher);
  DressResult run();

 private:
  template <typename Over>
  StageReport& stage(const std::string& name, double longest, SpringStage forces,
                     const Over& is_over);
  void wrap();
  bool sew();
  void drape();
  void look(const std::string& name, double progress);
  Residual residual();
  bool is_clean() const;
  void finish();

  const PanelMesh& garment_;
  const SpringDressOptions& options_;
  const FrameWatcher& watcher_;
  const Placement placement_;
  const GarmentModel model_;
  DressResult result_;
  SpringMotion motion_;
  std::vector<Vec3> looked_x_;
  std::vector<Vec3> looked_v_;
  std::vector<double> rest_areas_;
  Outlines outlines_;
  std::vector<double> rest_perimeters_;
  double mean_edge_ = 0;  // metres
  double unit_time_ = 0;  // that the wrap ended with
  double time_ = 0;       // simulated so far
  int looks_ = 0;
};

SpringDressing::SpringDressing(const PanelMesh& garment, const Scene& scene,
                               const SpringDressOptions& options, const FrameWatcher& watcher)
    : garment_(garment),
      options_(options),
      watcher_(watcher),
      placement_(find_start(garment, scene, shoulder_start_height)),
      model_(compile(garment, scene, placement_.placed)),
      motion_(garment, model_, options.motion, placement_.placed),
      rest_areas_(panel_areas(garment)),
      outlines_(panel_outlines(garment)),
      rest_perimeters_(panel_perimeters(garment)) {
  for (const Spring& edge : motion_.sheet().edges()) mean_edge_ += edge.rest;
  mean_edge_ /= std::max<std::size_t>(motion_.sheet().edges().size(), 1);
  StageReport report;
  report.name = "position";
  report.nodes = motion_.sheet().points();
  report.converged = placement_.points_inside == 0;
  result_.stages.push_back(report);
  looked_x_ = motion_.points();
  looked_v_ = motion_.velocities();
}

DressResult SpringDressing::run() {
  wrap();
  if (sew()) drape();
  finish();
  return std::move(result_);
}

void SpringDressing::wrap() {
  motion_.stiffen_bending(sewing_bending_factor);
  const bool has_seams = motion_.open_pairs() > 0;
  SpringStage forces;
  forces.attraction = has_seams ? 0 : wrap_attraction;
  forces.sewing = options_.motion.sewing;
  forces.open = 1;
  const double loosest = forces.sewing.unit_time;
  stage("wrap", options_.longest_wrap, forces, [&](SpringStage& now, double time) {
    now.sewing.unit_time =
        std::max(min_wrap_unit_time, loosest * std::exp2(-time / tightening_seconds));
    unit_time_ = now.sewing.unit_time;
    now.open = std::max(0.0, 1 - time / closing_seconds);
    // Drawn near before the shoulders have met above, the panels would slide down in front.
    now.attraction = has_seams ? wrap_attraction * std::pow(1 - now.open, 3) : wrap_attraction;
    return has_seams && motion_.open_gap(wrapped_share) < wrapped_gap;
  });
}

bool SpringDressing::sew() {
  if (garment_.seams.empty()) return true;
  SpringStage forces;
  forces.attraction = wrap_attraction;
  forces.sewing = options_.motion.sewing;
  const double loosest = unit_time_;
  forces.sewing.unit_time = loosest;
  int open = motion_.open_pairs();
  double gap = motion_.open_gap(1);
  double came_nearer = 0;
  stage("sew", options_.longest_sew, forces, [&](SpringStage& now, double time) {
    now.sewing.unit_time =
        std::max(min_sewing_unit_time, loosest * std::exp2(-time / tightening_seconds));
    const bool at_full_force = now.sewing.unit_time == min_sewing_unit_time;
    const double gap_now = motion_.open_gap(1);
    if (motion_.open_pairs() < open || gap_now < sewing_progress * gap || !at_full_force) {
      came_nearer = time;
      gap = gap_now;
    }
    open = motion_.open_pairs();
    return open == 0 || time - came_nearer > sewing_patience;
  });
  if (open > 0) {
    result_.stages.back().converged = false;
    return false;
  }
  // Small folds that went through each other at the seams open as the stiff cloth smooths itself.
  stage("sew", max_untangling_seconds, forces, [&](SpringStage&, double) { return is_clean(); });
  return true;
}

void SpringDressing::drape() {
  if (is_clean()) motion_.close_bounds();
  motion_.stiffen_bending(1);
  if (options_.motion.converged_strain) motion_.converge_strain();
  SpringStage forces;
  forces.gravity = 1;
  stage("drape", options_.longest_drape, forces, [&](SpringStage& now, double time) {
    now.friction = time > frictionless_seconds;
    const Residual& left = result_.residual;
    return now.friction && left.median < options_.stop_median && left.rms < options_.stop_rms;
  });
  result_.converged = result_.stages.back().converged;
}

bool SpringDressing::is_clean() const {
  return self_intersections({motion_.points(), motion_.sheet().triangles()}).empty();
}

template <typename Over>
StageReport& SpringDressing::stage(const std::string& name, double longest, SpringStage forces,
                                   const Over& is_over) {
  const auto start = std::chrono::steady_clock::now();
  const double dt = motion_.time_step();
  const int steps_a_look = std::max(1, static_cast<int>(std::lround(watch_interval / dt)));
  forces.sewing.most = options_.hand_pull * mean_edge_;
  forces.sewing.fastest = 1;
  StageReport report;
  report.name = name;
  double time = 0;
  while (time < longest && !report.converged) {
    for (int i = 0; i < steps_a_look; ++i) motion_.step(forces);
    report.steps += steps_a_look;
    time += steps_a_look * dt;
    time_ += steps_a_look * dt;
    result_.residual = residual();
    look(name, time / longest);
    report.converged = is_over(forces, time);
  }
  report.nodes = motion_.sheet().points() - static_cast<int>(motion_.counts().merged);
  report.simulated = time;
  report.residual = result_.residual;
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result_.stages.emplace_back(report);
}

void SpringDressing::look(const std::string& name, double progress) {
  const std::vector<Vec3>& points = motion_.points();
  const double area = largest_change(rest_areas_, panel_areas(garment_, points));
  const double perimeter = largest_change(rest_perimeters_, panel_perimeters(outlines_, points));
  result_.during.area = std::max(result_.during.area, area);
  result_.during.perimeter = std::max(result_.during.perimeter, perimeter);
  if (watcher_ && looks_++ % frame_looks == 0) watcher_({garment_, name, points, progress, time_});
}

/// Mean over the time since the last look.
Residual SpringDressing::residual() {
  const auto& x = motion_.points();
  const auto& v = motion_.velocities();
  const double dt = motion_.time_step();
  const double span = dt * std::max(1L, std::lround(watch_interval / dt));
  std::vector<double> left;
  for (std::size_t n = 0; n < x.size(); ++n) {
    const double mass = motion_.sheet().mass()[n];
    if (mass <= 0) continue;
    const Vec3 gained = v[n] - looked_v_[n] + options_.motion.drag * (x[n] - looked_x_[n]);
    left.push_back(mass * gained.norm() / span / model_.mean_weight);
  }
  looked_x_ = x;
  looked_v_ = v;
  Residual residual = residual_of(std::move(left));
  residual.hardest = -1;  // it counts the points that have mass
  return residual;
}

void SpringDressing::finish() {
  const SpringSheet& sheet = motion_.sheet();
  result_.placement = placement_;
  result_.body_offset = options_.motion.tolerance;
  result_.time_step = motion_.time_step();
  std::vector<int> index(sheet.points(), -1);
  for (int p = 0; p < sheet.points(); ++p) {
    const int n = sheet.node(p);
    if (index[n] < 0) {
      index[n] = static_cast<int>(result_.nodes.size());
      result_.nodes.push_back(motion_.points()[n]);
    }
  }
  result_.triangles = sheet.triangles();
  for (Triangle& t : result_.triangles) {
    for (int& corner : t) corner = index[corner];
  }
  const auto count = [](auto n) { return static_cast<int>(n); };
  const Scene& scene = model_.scene;
  result_.terms = {
      {"edge_springs", count(sheet.edges().size())},
      {"softened_edges", sheet.softened()},
      {"bending_springs", count(sheet.bending().size())},
      {"seam", count(motion_.counts().merged + motion_.open_pairs())},
      {"subject_facets",
       scene.collider != nullptr ? count(scene.collider->surface().triangles.size()) : 0},
      {"self_contact", scene.self_contact ? count(sheet.triangles().size()) : 0},
      {"strain_limit",
       options_.motion.strain_scheme != StrainScheme::none ? count(sheet.edges().size()) : 0}};
}

}  // namespace

DressResult dress_springs(const PanelMesh& garment, const Scene& scene,
                          const SpringDressOptions& options, const FrameWatcher& watcher) {
  if (scene.collider == nullptr) {
    throw Error("scene", "has no body", "give one to dress");
  }
  return SpringDressing(garment, scene, options, watcher).run();
}

}  // namespace toile
