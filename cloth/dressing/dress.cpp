#include "cloth/dressing/dress.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "cloth/contact/body_bounds.h"
#include "cloth/dressing/stability_test.h"
#include "cloth/judge/measures.h"
#include "cloth/model/compile.h"
#include "cloth/model/gathers.h"
#include "cloth/model/nested_meshes.h"
#include "cloth/scene/collider.h"
#include "cloth/start/resolve_intersections.h"
#include "geometry/error.h"
#include "geometry/intersections.h"

namespace toile {

namespace {

/// How often the panels are placed and sewn anew, each time twice as carefully.
constexpr int max_attempts = 3;
/// Factor on the bending stiffness while seams close; 30 lets folds go through their own seam.
constexpr double sewing_stiffness = 300;
/// Pull toward the skin while seams close, in weights of the cloth; 0 leaves one ridge down the
/// middle of a wide front.
constexpr double sewing_pull = 2;

/// Share of the stiffness that resists compression while the cloth finds its folds, from the finest
/// mesh to the coarsest. With all of it, cloth stands on creases that its mesh is too coarse to
/// break, and is strained more at rest.
constexpr std::array<double, 3> soft_compression = {0.02, 0.05, 0.01};
/// Iterations in which the finest mesh gets all of it, and is pushed back to its own offset: at
/// once, it would be thrown about.
constexpr int stiffening_iterations = 1000;

/// To the residual of cloth that may go on to the next mesh. The same whatever rest is asked for at
/// the end: then a drape brought nearer to rest goes on from where the other one stopped, and is
/// nearer to where both would end; with less, the finest mesh has no fewer iterations to do
/// [measured].
void settle(RelaxOptions& options) {
  options.stop_median = 0.05;
  options.stop_rms = 0.5;
  options.stop_wide = 0;
}

/// Metres that cloth falls without friction, on average, from which on it falls anew with it: a
/// soft waist slides off the hips that would hold it. Of ten garments in three fabrics, those that
/// stay fall 0.04 m at most, those that slide 0.1 and 0.2 m, and then 0.01 m [measured, 25 mm
/// edges].
constexpr double slid_off = 0.06;

/// Metres, while seams close, where nothing has to come to rest.
constexpr double closing_linearization_radius = 2e-4;

/// N/m, while seams close: softer cloth would be drawn into strings by them, and tangle.
constexpr double sewing_stretch = 1000;
constexpr double sewing_shear = 200;

/// The scene with no cloth softer than that.
Scene for_sewing(Scene scene) {
  const auto stiffen = [](Fabric& fabric) {
    fabric.stretch_warp = std::max(fabric.stretch_warp, sewing_stretch);
    fabric.stretch_weft = std::max(fabric.stretch_weft, sewing_stretch);
    fabric.shear = std::max(fabric.shear, sewing_shear);
  };
  stiffen(scene.fabric);
  for (auto& [name, fabric] : scene.fabrics) stiffen(fabric);
  // Limits are for the drape.
  scene.strain_limit.reset();
  scene.shear_limit.reset();
  return scene;
}

/// Lets gathered rows give way along their seams too. Drawn up while a seam stands open, they turn
/// the whole garment about the body by up to a right angle, for that brings them nearer; but the
/// seam is to close the way it was placed, so its sides would then pass through the cloth.
void slacken_gathers(const PanelMesh& garment, GarmentModel& model) {
  for (const auto& [triangle, along] : gathered_rows(garment, gathered_edges(garment))) {
    model.stretch[triangle].weft_stiffness *= gathered_stiffness;
  }
}

class Dressing {
 public:
  Dressing(const PanelMesh& garment, const Scene& scene, const DressOptions& options,
           const FrameWatcher& watcher)
      : scene_(scene), options_(options), watcher_(watcher) {
    meshes_.push_back(garment);
    while (meshes_.back().subdivisions > 0) meshes_.push_back(coarsen(meshes_.back()));
  }

  DressResult run();

 private:
  void position();
  bool jammed() const;
  double fallen(const std::vector<Vec3>& from) const;
  bool lost() const;
  DressResult give_up();
  bool wrap(double care);
  bool sew(double care);
  void fall_as_sewn(bool bounded);
  void fall(bool bounded);
  void end_dressing();
  void come_to_rest(bool bounded);
  void drape_to_rest(const RelaxOptions& options);
  void let_go_of(bool bounded);
  const StageReport& stage(const std::string& name, RelaxOptions options);
  void go_finer();
  GarmentModel compiled(Scene scene) const;
  RelaxOptions level_options() const;
  RelaxOptions rest_options(bool bounded) const;
  double near_cloth() const;
  double end_of_stage(const RelaxOptions& options) const;
  double soft() const;
  bool clean() const;
  bool clear_of_layers() const;
  const PanelMesh& mesh() const { return meshes_[level_]; }

  Scene scene_;
  const DressOptions& options_;
  const FrameWatcher& watcher_;
  std::vector<PanelMesh> meshes_;  // finest first
  int level_ = 0;
  int attempt_ = 1;
  bool holds_on_ = false;     // by friction, already while it falls
  double progress_ = 0;       // of the whole dressing, 0 to 1
  std::vector<Vec3> placed_;  // the mesh in hand, where its panels started
  GarmentModel model_;        // of it
  DressResult result_;
};

/// Metres: the tightest curves of a body, and of the folds of cloth.
constexpr double body_curve = 0.03;
constexpr double fold_curve = 0.01;
constexpr double max_body_offset = 0.006;  ///< metres; beyond, the drape would be another one
/// Metres, while the cloth finds its place over another; it comes to rest nearer.
constexpr double max_fold_offset = 0.015;

/// Metres that the nodes of a mesh of such edges keep from a surface: no less than asked for, and
/// so much that its faces clear curves of that radius, whose sagitta they cut off; at most `most`.
double clearing_offset(double asked, double edge_length, double tightest_curve, double most) {
  constexpr double face_clearance = 0.001;
  const double needed = face_clearance + edge_length * edge_length / (8 * tightest_curve);
  return std::max(asked, std::min(needed, most));
}

DressResult Dressing::run() {
  result_.body_offset = clearing_offset(body_offset_of(scene_, meshes_.front()),
                                        meshes_.front().edge_length, body_curve, max_body_offset);
  level_ = static_cast<int>(meshes_.size()) - 1;
  position();
  const bool has_seams = !meshes_.front().seams.empty();
  bool is_clean = !has_seams && clean();
  for (int attempt = 0; has_seams && attempt < max_attempts && !is_clean; ++attempt) {
    // A tangle is not undone but avoided: the panels start again, stiffer and slower.
    result_.nodes = model_.start;
    result_.during = {};
    attempt_ = attempt + 1;
    is_clean = wrap(std::pow(2.0, attempt)) && sew(std::pow(2.0, attempt));
    if (jammed()) return give_up();
  }
  model_ = compiled(scene_);
  // On the coarsest mesh, though it be the only one.
  fall_as_sewn(is_clean);
  is_clean = is_clean || clean();
  while (level_ > 0) {
    go_finer();
    if (level_ == 0) break;
    if (!lost()) fall(is_clean);
    is_clean = is_clean || clean();
  }
  const bool is_lost = lost();
  if (!is_lost) come_to_rest(is_clean);
  if (!is_lost && options_.release_seconds > 0) let_go_of(is_clean);
  end_dressing();
  measure_lasting(mesh(), model_.attachments, point_positions(model_, result_.nodes, 0),
                  result_.attachments);
  result_.held = model_.attachments;
  result_.terms = term_counts(model_);
  result_.triangles = model_.node_triangles;
  result_.tight_seams = tight_seams(mesh(), model_, result_.nodes, result_.warm_start.multipliers);
  if (scene_.strain_limit) {
    result_.tight_regions =
        tight_regions(mesh(), model_, result_.nodes, result_.warm_start.multipliers);
  }
  return std::move(result_);
}

/// Seams that have stayed this far open are held apart by something: care won't help.
bool Dressing::jammed() const {
  constexpr double hardly_closed = 0.1;
  return result_.stages.back().open > hardly_closed;
}

/// Metres that the cloth has come down from where it was, on average.
double Dressing::fallen(const std::vector<Vec3>& from) const {
  const auto middle = [](const std::vector<Vec3>& points) {
    const Vec3 sum = std::accumulate(points.begin(), points.end(), Vec3(Vec3::Zero()));
    return Vec3(sum / static_cast<double>(points.size()));
  };
  const Vec3 way = middle(result_.nodes) - middle(from);
  return way.dot(scene_.gravity.normalized());
}

/// Whether the cloth has fallen off, to the feet or farther: it would go on sliding.
bool Dressing::lost() const {
  constexpr double far = 0.6;  // metres; panels are lifted by a third of that at most
  return fallen(result_.placement.placed) > far;
}

/// The garment as far as it came, its seams open.
DressResult Dressing::give_up() {
  std::vector<Vec3> points = point_positions(model_, result_.nodes, result_.stages.back().open);
  result_.attachments = measure_attachments(mesh(), model_.attachments, points);
  for (; level_ > 0; --level_) points = refine_points(mesh(), points, meshes_[level_ - 1]);
  result_.terms = term_counts(model_);
  result_.residual = result_.stages.back().residual;
  result_.nodes = std::move(points);
  result_.triangles = mesh().triangles;
  return std::move(result_);
}

bool Dressing::wrap(double care) {
  RelaxOptions options = level_options();
  // A mesh without coarser ones has farther to carry the pull of its seams.
  const double across = std::max(1.0, std::sqrt(mesh().flat.size() / 700.0));
  options.closing_iterations = static_cast<int>(3000 * across * care);
  options.max_iterations = 2 * options.closing_iterations;
  options.bending_from = options.bending_to = sewing_stiffness * care;
  options.compression = soft_compression.back();
  options.gravity = 0;
  options.pull = sewing_pull;
  options.linearization_radius = closing_linearization_radius;
  options.friction = false;
  options.bounded = true;
  options.momentum = 0.99;
  const std::vector<StretchTriangle> drawn_up = model_.stretch;
  slacken_gathers(mesh(), model_);
  const bool closed = stage("wrap", options).converged;
  model_.stretch = drawn_up;
  return closed;
}

bool Dressing::sew(double care) {
  RelaxOptions options = level_options();
  options.max_iterations = 300;
  options.compression = soft_compression.back();
  options.bending_from = options.bending_to = sewing_stiffness * care;
  options.gravity = 0;
  options.pull = sewing_pull;
  options.linearization_radius = closing_linearization_radius;
  options.friction = false;
  // Stiff seams open small folds that have gone through themselves.
  bool is_clean = clean();
  for (int i = 0; i < 3 && !is_clean; ++i) {
    stage("sew", options);
    is_clean = clean();
  }
  if (!is_clean) return false;
  options.max_iterations = 500;
  options.bending_to = 1;
  options.bounded = true;
  stage("sew", options);
  // What this stage is for is that state, not rest.
  result_.stages.back().converged = true;
  return true;
}

double Dressing::soft() const {
  return soft_compression[std::min<std::size_t>(level_, soft_compression.size() - 1)];
}

/// What slides off without friction, and stays with it, has it from here on.
void Dressing::fall_as_sewn(bool bounded) {
  const std::vector<Vec3> sewn = result_.nodes;
  fall(bounded);
  if (fallen(sewn) <= slid_off) return;
  auto slid = std::pair(std::exchange(result_.nodes, sewn), result_.warm_start);
  holds_on_ = true;
  fall(bounded);
  if (fallen(sewn) <= slid_off) return;
  holds_on_ = false;
  std::tie(result_.nodes, result_.warm_start) = std::move(slid);
}

void Dressing::fall(bool bounded) {
  RelaxOptions options = level_options();
  options.compression = soft();
  options.friction = holds_on_;
  options.bounded = bounded;
  options.max_iterations = 2000;
  settle(options);
  stage("drape", options);
}

/// From here on friction holds what attachments held on the way.
void Dressing::end_dressing() {
  if (model_.attachments.empty() || !result_.attachments.empty()) return;
  result_.attachments =
      measure_attachments(mesh(), model_.attachments, point_positions(model_, result_.nodes, 0));
  model_.attachments = lasting(std::move(model_.attachments));
}

/// Of the garment's own mesh.
RelaxOptions Dressing::rest_options(bool bounded) const {
  RelaxOptions options = level_options();
  options.body_offset = result_.body_offset;
  options.bounded = bounded;
  ask_for_rest(options_, options);
  return options;
}

void Dressing::come_to_rest(bool bounded) {
  RelaxOptions options = rest_options(bounded);
  options.compression = soft();
  options.stiffening_iterations = stiffening_iterations;
  // What is far too small is held off the body by its own tension, and never at rest.
  const bool hopeless = !tight_seams(mesh(), model_, result_.nodes).empty();
  if (hopeless) options.max_iterations = std::min(stiffening_iterations, options.max_iterations);
  if (lasting(model_.attachments).size() < model_.attachments.size()) {
    // What is let go before friction holds it would slide off meanwhile.
    RelaxOptions settling = options;
    settling.max_iterations = std::min(2 * stiffening_iterations, options.max_iterations);
    settle(settling);
    stage("drape", settling);
    end_dressing();
    options.warm_start = &result_.warm_start;
    options.compression = 1;
    options.stiffening_iterations = 0;
  }
  drape_to_rest(options);
}

void Dressing::drape_to_rest(const RelaxOptions& options) {
  const StageReport& last = stage("drape", options);
  result_.residual = last.residual;
  result_.converged = last.converged;
}

void Dressing::let_go_of(bool bounded) {
  ReleaseOptions options;
  static_cast<ForceOptions&>(options) = level_options();
  options.body_offset = result_.body_offset;
  options.bounded = bounded;
  options.layer_contact = clear_of_layers();
  options.seconds = options_.release_seconds;
  RestingState state = {result_.nodes, result_.warm_start, result_.converged};
  result_.release = test_stability(model_, options, state, [&](RestingState& moved) {
    result_.nodes = std::move(moved.nodes);
    result_.warm_start = std::move(moved.warm_start);
    RelaxOptions again = rest_options(bounded);
    again.warm_start = &result_.warm_start;
    drape_to_rest(again);
    moved = {result_.nodes, result_.warm_start, result_.converged};
  });
}

void Dressing::position() {
  const auto start = std::chrono::steady_clock::now();
  result_.placement = start_of(mesh(), scene_);
  placed_ = result_.placement.placed;
  model_ = compiled(for_sewing(scene_));
  result_.nodes = model_.start;
  StageReport report;
  report.name = "position";
  report.vertices = model_.nodes;
  report.converged = result_.placement.points_inside == 0;
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result_.stages.push_back(report);
  if (watcher_) watcher_({mesh(), report.name, result_.placement.placed, 0});
}

/// The mesh in hand, which keeps as far from the skin as it does on its level.
GarmentModel Dressing::compiled(Scene scene) const {
  scene.body_offset = level_options().body_offset;
  return compile(mesh(), scene, placed_);
}

RelaxOptions Dressing::level_options() const {
  RelaxOptions options;
  options.body_offset = result_.body_offset * (1 + 0.5 * level_);
  if (has_layers(scene_)) {
    options.body_offset = std::max(
        options.body_offset, clearing_offset(0, mesh().edge_length, fold_curve, max_fold_offset));
  }
  options.self_radius = near_cloth();
  return options;
}

/// Metres within which cloth is looked for: coarser cloth moves farther between two searches, and
/// has no more neighbours for it; fine cloth would have too many.
double Dressing::near_cloth() const {
  constexpr double most = 0.02;
  const double room = 0.0015 + self_gap_of(scene_, mesh());  // before it touches
  return std::min(most, std::max(room, 0.4 * mesh().edge_length));
}

const StageReport& Dressing::stage(const std::string& name, RelaxOptions options) {
  // A seam that has to come past a layer would jam on it; the distance grid lets it through, and
  // pushes it out on the right side.
  options.layer_contact = options.closing_iterations == 0 && clear_of_layers();
  const std::vector<double> areas = panel_areas(mesh());
  const Outlines outlines = panel_outlines(mesh());
  const std::vector<double> perimeters = panel_perimeters(mesh());
  const double begin = progress_;
  const double end = end_of_stage(options);
  int calls = 0;
  const auto watch = [&](const RelaxProgress& at) {
    const std::vector<Vec3> points = point_positions(model_, at.nodes, at.open);
    const double area = largest_change_percent(areas, panel_areas(mesh(), points));
    const double perimeter = largest_change_percent(perimeters, panel_perimeters(outlines, points));
    result_.during.area_percent = std::max(result_.during.area_percent, area);
    result_.during.perimeter_percent = std::max(result_.during.perimeter_percent, perimeter);
    progress_ = begin + (end - begin) * at.iteration / options.max_iterations;
    if (watcher_ && calls++ % 4 == 0) watcher_({mesh(), name, points, progress_});
  };
  options.multipliers = &result_.warm_start.multipliers;
  const RelaxReport report = relax(model_, options, result_.nodes, watch);
  result_.warm_start = report.warm_start;
  result_.lift = report.lift;
  progress_ = end;
  if (watcher_) {
    watcher_({mesh(), name, point_positions(model_, result_.nodes, report.open), progress_});
  }
  result_.stages.push_back(stage_of(name, model_.nodes, report));
  result_.stages.back().attempt = attempt_;
  return result_.stages.back();
}

/// Progress at the end of a stage that begins now; roughly: each mesh costs some four times the
/// coarser one, and coming to rest more than twice what comes before.
double Dressing::end_of_stage(const RelaxOptions& options) const {
  const bool is_last = options.compression == 1 || options.stiffening_iterations > 0;
  if (is_last) return 1;
  const double end_of_level = 0.3 * std::pow(0.25, std::max(level_ - 1, 0));
  // Nobody knows how many times it will be sewn before it falls.
  return options.gravity > 0 ? end_of_level : 0.5 * (progress_ + end_of_level);
}

void Dressing::go_finer() {
  const PanelMesh& coarse = mesh();
  const PanelMesh& fine = meshes_[level_ - 1];
  placed_ = refine_placed(coarse, placed_, fine);
  --level_;
  GarmentModel model = compiled(scene_);
  result_.nodes = refine_positions(coarse, model_.node_of_point, result_.nodes, fine,
                                   model.node_of_point, model.nodes);
  model_ = std::move(model);
  std::vector<LimitMultiplier> finer;
  for (const LimitMultiplier& held : result_.warm_start.multipliers)
    finer.insert(finer.end(), 4, held);
  result_.warm_start.multipliers = std::move(finer);
}

bool Dressing::clean() const {
  return self_intersections({result_.nodes, model_.node_triangles}).empty();
}

/// Whether the cloth is outside of all layers below and meets none of them, so that it can be kept
/// so. (What is a little inside by the smoothed distance may be outside by the exact one.)
bool Dressing::clear_of_layers() const {
  constexpr double surely_inside = -0.005;
  if (!has_layers(scene_)) return false;
  for (const Vec3& p : result_.nodes) {
    if (scene_.collider->grid().at(p).distance < surely_inside) return false;
  }
  return intersections({result_.nodes, model_.node_triangles}, scene_.collider->cloth()).empty();
}

}  // namespace

StageReport stage_of(const std::string& name, int vertices, const RelaxReport& report) {
  StageReport stage;
  stage.name = name;
  stage.open = report.open;
  stage.vertices = vertices;
  stage.steps = report.iterations;
  stage.searches = report.searches;
  stage.seconds = report.seconds;
  stage.converged = report.converged;
  stage.residual = report.residual;
  return stage;
}

void ask_for_rest(const DressOptions& wanted, RelaxOptions& options) {
  // Iterations without coming nearer to rest after which a run gives up.
  constexpr int patience = 8000;
  options.max_iterations = wanted.max_iterations;
  options.stop_median = wanted.stop_median;
  options.stop_rms = wanted.stop_rms;
  options.stop_wide = wanted.stop_wide;
  options.patience = patience;
}

DressResult dress(const PanelMesh& garment, const Scene& scene, const DressOptions& options,
                  const FrameWatcher& watcher) {
  if (scene.collider == nullptr) throw Error("scene", "has no body", "give one to dress");
  return Dressing(garment, scene, options, watcher).run();
}

std::vector<Vec3> material_points(const PanelMesh& garment, const DressResult& result) {
  std::vector<Vec3> points = result.placement.placed;
  points.resize(garment.flat.size(), Vec3::Zero());
  for (std::size_t t = 0; t < garment.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      points[garment.triangles[t][i]] = result.nodes[result.triangles[t][i]];
    }
  }
  return points;
}

}  // namespace toile
