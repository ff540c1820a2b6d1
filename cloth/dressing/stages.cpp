#include "cloth/dressing/stages.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "cloth/dressing/constants.h"
#include "cloth/model/constants.h"
#include "cloth/model/gathers.h"
#include "cloth/relaxation/constants.h"
#include "cloth/start/start.h"

namespace toile {

namespace {

double compression_of(const Level& level) {
  return soft_compression[std::min<std::size_t>(level.depth, soft_compression.size() - 1)];
}

/// Stops at the residual of cloth that may go on to the next mesh. It is the same whatever rest is
/// asked for at the end. So a drape brought nearer to rest continues from where the other one
/// stopped, and both end near each other. With a smaller residual, the finest mesh needs no fewer
/// iterations [measured].
void stop_when_settled(RelaxOptions& options) {
  options.stop_median = settled_residual;
  options.stop_rms = rms_over_median * settled_residual;
  options.stop_wide = 0;
}

RelaxOptions level_options(const Level& level) {
  RelaxOptions options;
  options.self_radius = search_radius(level);
  return options;
}

/// Of stages that sew: the cloth is stiff, weightless, and drawn to the body.
RelaxOptions sewing_options(const Level& level, const Closing& closing) {
  RelaxOptions options = level_options(level);
  options.compression = soft_compression.back();
  options.bending_from = options.bending_to = closing.bending;
  options.gravity = 0;
  options.body_attraction = closing.pull;
  options.linearization_radius = closing_linearization_radius;
  options.friction = false;
  options.barrier = true;
  options.firm_push = false;
  return options;
}

RelaxOptions rest_options(const Level& level, bool bounded, const DressOptions& wanted) {
  RelaxOptions options = level_options(level);
  options.bounded = bounded;
  ask_for_rest(wanted, options);
  return options;
}

/// Progress of the whole dressing once a level has settled. Each mesh costs some four times the
/// coarser one, and rest more than twice what comes before.
double progress_when_settled(const Level& level) {
  return 0.3 * std::pow(0.25, std::max(level.depth - 1, 0));
}

/// Progress after one more run that sews: nobody knows how many there will be.
double progress_when_sewn(const Level& level, const Journal& journal) {
  return 0.5 * (journal.progress() + progress_when_settled(level));
}

/// The level's model, with gathered rows that give way along their seams. Stiff rows come nearer to
/// each other by turning the garment about the body, by up to a right angle, while a seam stands
/// open. But the seam is to close from where it was placed: its sides would then pass through the
/// cloth.
GarmentModel with_slack_gathers(const Level& level) {
  GarmentModel model = level.model;
  for (const auto& [triangle, along] : gathered_rows(*level.mesh, gathered_edges(*level.mesh))) {
    model.stretch[triangle].weft_stiffness *= gathered_stiffness;
  }
  return model;
}

/// A run that begins with the forces that the state's warm start holds.
Staged run_on(const std::string& name, const Level& level, const GarmentModel& model, State state,
              RelaxOptions options, double end, Journal& journal) {
  // A seam that has to come past a layer would jam on it. The distance grid lets it through, and
  // pushes it out on the right side.
  options.layer_contact = options.closing_iterations == 0 && is_clear_of_layers(level, state);
  options.warm_start = &state.warm_start;
  RelaxReport report = journal.run(name, *level.mesh, model, options, state.nodes, end);
  state.warm_start = std::move(report.warm_start);
  state.extra_offset = std::move(report.extra_offset);
  return {std::move(state), journal.stages().back(), std::move(report.held),
          std::move(report.open)};
}

/// A run in which friction holds the cloth where it first touches.
Staged run(const std::string& name, const Level& level, const GarmentModel& model, State state,
           const RelaxOptions& options, double end, Journal& journal) {
  state.warm_start.drop_anchors();
  return run_on(name, level, model, std::move(state), options, end, journal);
}

}  // namespace

Scene closing_scene(Scene scene) {
  const auto stiffen = [](Fabric& fabric) {
    fabric.stretch_warp = std::max(fabric.stretch_warp, closing_stretch);
    fabric.stretch_weft = std::max(fabric.stretch_weft, closing_stretch);
    fabric.shear = std::max(fabric.shear, closing_shear);
  };
  stiffen(scene.fabric);
  for (auto& [name, fabric] : scene.fabrics) stiffen(fabric);
  scene.strain_limit.reset();
  scene.shear_limit.reset();
  // Pressed flat by it, a hem that starts below would be sewn in folds.
  scene.floor.reset();
  return scene;
}

Positioned position(const PanelMesh& mesh, int depth, const Scene& scene, double resting_offset,
                    Journal& journal) {
  const auto start = std::chrono::steady_clock::now();
  Positioned positioned{find_start(mesh, scene), {}};
  positioned.level = compiled_level(mesh, depth, closing_scene(scene), positioned.placement.placed,
                                    resting_offset);
  StageReport report;
  report.name = "position";
  report.nodes = positioned.level.model.nodes;
  report.converged = positioned.placement.points_inside == 0;
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  journal.add(report, mesh, positioned.placement.placed);
  return positioned;
}

Staged close_seams(const Level& level, State state, const Closing& closing, bool heeds_body,
                   Journal& journal) {
  RelaxOptions options = sewing_options(level, closing);
  const double across =
      std::max(1.0, std::sqrt(static_cast<double>(level.mesh->flat.size()) / closing_points));
  options.closing_iterations = static_cast<int>(closing_iterations * across);
  options.passing_iterations = passing_iterations;
  options.passes_body = closing.through_body;
  options.max_iterations = options.closing_iterations + max_closing_wait + 2 * passing_iterations;
  options.bounded = true;
  options.bounded_by_body = heeds_body;
  options.momentum = closing_momentum;
  return run("close_seams", level, with_slack_gathers(level), std::move(state), options,
             progress_when_sewn(level, journal), journal);
}

Staged untangle(const Level& level, State state, double pull, Journal& journal) {
  Staged staged{std::move(state), {}};
  if (!is_clear_of_itself(level, staged.state)) {
    RelaxOptions options = sewing_options(level, {untangling_stiffness, pull});
    options.max_iterations = untangling_iterations;
    options.untangles = true;
    options.bounded_by_body = true;
    staged = run("untangle", level, level.model, std::move(staged.state), options,
                 progress_when_sewn(level, journal), journal);
    if (!staged.report.converged) return staged;
  }
  RelaxOptions options = sewing_options(level, {closing_attempts.front().bending, pull});
  options.max_iterations = softening_iterations;
  options.bending_to = 1;
  options.bounded = true;
  staged = run("untangle", level, level.model, std::move(staged.state), options,
               progress_when_sewn(level, journal), journal);
  // This stage ends with full stiffness, not with rest.
  journal.mark_converged();
  staged.report.converged = true;
  return staged;
}

Widening widening_of(const Level& level, const std::vector<WidePanel>& panels) {
  Widening wide(level.model.stretch.size());
  for (std::size_t p = 0; p < panels.size(); ++p) {
    if (panels[p].factor == 1) continue;
    const MeshedPanel& panel = level.mesh->panels[p];
    for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
      const StretchTriangle& s = level.model.stretch[t];
      Vec2 along = Vec2::Zero();
      for (int i = 0; i < 3; ++i) {
        const Vec3& corner = level.placed[level.model.triangles[t][i]];
        along += panels[p].across.dot(corner) * Vec2(s.weft[i], s.warp[i]);
      }
      along.normalize();
      wide[t] = {panels[p].factor, along.x(), along.y()};
    }
  }
  return wide;
}

Level widened(Level level, const Widening& wide) {
  for (std::size_t t = 0; t < wide.size(); ++t) {
    StretchTriangle& s = level.model.stretch[t];
    for (int i = 0; i < 3; ++i) {
      const double less =
          (1 / wide[t].factor - 1) * (wide[t].weft * s.weft[i] + wide[t].warp * s.warp[i]);
      s.weft[i] += less * wide[t].weft;
      s.warp[i] += less * wide[t].warp;
    }
  }
  return level;
}

Staged shrink(const Level& level, Staged staged, Widening wide, double pull, Journal& journal) {
  RelaxOptions options = sewing_options(level, {1, pull});
  options.max_iterations = shrinking_iterations;
  options.bounded = true;
  const auto is_wide = [](const WideTriangle& triangle) { return triangle.factor > 1; };
  while (std::ranges::any_of(wide, is_wide)) {
    for (WideTriangle& triangle : wide) {
      triangle.factor = std::max(shrinking_ratio * triangle.factor, 1.0);
    }
    staged = run("shrink", level, widened(level, wide).model, std::move(staged.state), options,
                 progress_when_sewn(level, journal), journal);
    // This stage ends with the cloth's own width, not with rest.
    journal.mark_converged();
    staged.report.converged = true;
  }
  return staged;
}

Staged untangle_worn(const Level& level, State state, Journal& journal) {
  RelaxOptions options = level_options(level);
  options.compression = compression_of(level);
  options.max_iterations = untangling_iterations;
  options.untangles = true;
  options.bounded_by_body = true;
  return run("untangle", level, level.model, std::move(state), options, journal.progress(),
             journal);
}

Staged settle(const Level& level, State state, bool bounded, bool friction, Journal& journal) {
  RelaxOptions options = level_options(level);
  options.compression = compression_of(level);
  options.friction = friction;
  options.bounded = bounded;
  options.max_iterations = settling_iterations << level.depth;
  stop_when_settled(options);
  return run("settle", level, level.model, std::move(state), options, progress_when_settled(level),
             journal);
}

State lifted(const Level& level, State state, bool bounded, Journal& journal) {
  const std::optional<double> floor = level.model.scene.floor;
  if (!floor) return state;
  double low = *floor;
  for (const Vec3& p : state.nodes) low = std::min(low, p.y());
  if (low == *floor) return state;
  RelaxOptions options = level_options(level);
  options.compression = compression_of(level);
  options.friction = false;
  options.bounded = bounded;
  options.max_iterations = lifting_iterations;
  Level rising = level;
  for (int i = 1; i < lifting_steps; ++i) {
    rising.model.scene.floor = low + (*floor - low) * i / lifting_steps;
    state =
        run("settle", rising, rising.model, std::move(state), options, journal.progress(), journal)
            .state;
  }
  return state;
}

Staged follow(const Level& level, State state, bool bounded, bool friction, Journal& journal) {
  RelaxOptions options = level_options(level);
  options.compression = compression_of(level);
  options.friction = friction;
  options.bounded = bounded;
  options.max_iterations = following_iterations;
  Staged staged =
      run("follow", level, level.model, std::move(state), options, journal.progress(), journal);
  // This stage ends with its iterations, not with rest.
  journal.mark_converged();
  staged.report.converged = true;
  return staged;
}

Staged release_attachments(const Level& level, State state, bool bounded, int max_iterations,
                           Journal& journal) {
  RelaxOptions options = level_options(level);
  options.bounded = bounded;
  options.compression = compression_of(level);
  options.stiffening_iterations = stiffening_iterations;
  options.max_iterations = std::min(2 * stiffening_iterations, max_iterations);
  options.patience = rest_patience;
  stop_when_settled(options);
  return run("release_attachments", level, level.model, std::move(state), options, 1, journal);
}

Staged rest(const Level& level, State state, bool bounded, bool stiffens,
            const DressOptions& wanted, Journal& journal) {
  RelaxOptions options = rest_options(level, bounded, wanted);
  if (!stiffens) return run_on("rest", level, level.model, std::move(state), options, 1, journal);
  options.compression = compression_of(level);
  options.stiffening_iterations = stiffening_iterations;
  return run("rest", level, level.model, std::move(state), options, 1, journal);
}

void ask_for_rest(const DressOptions& wanted, RelaxOptions& options) {
  options.max_iterations = wanted.max_iterations;
  options.stop_median = wanted.stop_median;
  options.stop_rms = wanted.stop_rms;
  options.stop_wide = wanted.stop_wide;
  if (wanted.release_seconds > 0 && wanted.stop_wide > 0) {
    options.stop_wide = std::min(wanted.stop_wide, releasable_residual);
  }
  options.patience = rest_patience;
}

bool is_at_rest(const StageReport& report, const DressOptions& wanted) {
  const Residual& left = report.residual;
  return report.converged || (left.median < wanted.stop_median && left.rms < wanted.stop_rms &&
                              (wanted.stop_wide == 0 || left.wide < wanted.stop_wide));
}

double search_radius(const Level& level) {
  const double min_radius = min_search_margin + self_gap_of(level.model.scene, *level.mesh);
  return std::min(max_search_radius,
                  std::max(min_radius, search_radius_share * level.mesh->edge_length));
}

}  // namespace toile
