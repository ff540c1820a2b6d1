#include "cloth/dress.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>

#include "cloth/levels.h"
#include "cloth/measures.h"
#include "geometry/error.h"
#include "geometry/intersections.h"

namespace toile {

namespace {

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
  void stage(const std::string& name, RelaxOptions options);
  void go_finer();
  RelaxOptions level_options() const;
  bool clean() const;
  const PanelMesh& mesh() const { return meshes_[level_]; }

  Scene scene_;
  const DressOptions& options_;
  const FrameWatcher& watcher_;
  std::vector<PanelMesh> meshes_;  // finest first
  int level_ = 0;
  DressResult result_;
};

DressResult Dressing::run() {
  level_ = static_cast<int>(meshes_.size()) - 1; if(getenv("SL")) level_=std::min(level_,atoi(getenv("SL"))); double pull=getenv("PULL")?atof(getenv("PULL")):1;
  position();

  RelaxOptions wrap = level_options();
  // A mesh without coarser ones has farther to carry the pull of its seams.
  const double across = std::sqrt(mesh().flat.size() / 700.0);
  wrap.closing_iterations = static_cast<int>(3000 * std::max(1.0, across));
  wrap.max_iterations = 2 * wrap.closing_iterations;
  const double stiff=getenv("BB")?atof(getenv("BB")):100; wrap.bending_from = wrap.bending_to = stiff;
  wrap.gravity = 0; wrap.pull=pull;
  wrap.friction = false;
  wrap.bounded = getenv("WB") != nullptr;
  if (getenv("CL")) {
    wrap.closing_iterations = atoi(getenv("CL"));
    wrap.max_iterations = 2 * wrap.closing_iterations;
  }
  wrap.momentum = 0.99;
  stage("wrap", wrap);

  RelaxOptions sew = level_options();
  sew.gravity = 0; sew.pull=pull;
  sew.friction = false;
  sew.max_iterations = 300;
  sew.bending_from=sew.bending_to=stiff;
  bool bounded = clean();
  for (int k=0;k<6 && !bounded;++k) { 
  stage("sew", sew);  bounded = clean(); fprintf(stderr,"after %d: %d\n",k,(int)self_intersections({result_.nodes, result_.program.node_triangles}).size()); }
  sew.bending_to=1; sew.max_iterations=1000; sew.bounded=bounded;
  stage("sew",sew);
  for (;; go_finer()) {
    RelaxOptions fall = level_options();
    fall.friction = false;
    fall.bounded = bounded;
    fall.max_iterations = getenv("FALL") ? atoi(getenv("FALL")) : 2000;
    stage("drape", fall);
    bounded = bounded || clean();
    if (level_ == 0) break;
  }

  RelaxOptions rest = level_options();
  rest.bounded = bounded;
  rest.max_iterations = options_.max_iterations;
  rest.stop_median = options_.stop_median;
  rest.stop_rms = options_.stop_rms;
  stage("drape", rest);
  result_.residual = result_.stages.back().residual;
  result_.converged = result_.stages.back().converged;
  return std::move(result_);
}

void Dressing::position() {
  const auto start = std::chrono::steady_clock::now();
  result_.placement = place_panels(mesh(), *scene_.body, scene_.skeleton);
  result_.program = compile(mesh(), scene_, result_.placement.placed);
  result_.nodes = result_.program.start;
  StageReport report;
  report.name = "position";
  report.vertices = result_.program.nodes;
  report.converged = result_.placement.points_inside == 0;
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result_.stages.push_back(report);
}

RelaxOptions Dressing::level_options() const {
  RelaxOptions options;
  // Coarse faces cut across the body's curves: the cloth is held farther off.
  options.body_offset = scene_.body_offset * (1 + 0.5 * level_);
  const double c1=getenv("C1")?atof(getenv("C1")):0.2, c2=getenv("C2")?atof(getenv("C2")):0.05; options.compression = level_==0?1:level_==1?c1:c2;
  options.self_radius = 0.005 * (1 + 0.5 * level_);
  return options;
}

void Dressing::stage(const std::string& name, RelaxOptions options) {
  const std::vector<double> areas = panel_areas(mesh());
  const std::vector<double> perimeters = panel_perimeters(mesh());
  int calls = 0;
  const auto watch = [&](const RelaxProgress& at) {
    const std::vector<Vec3> points = point_positions(result_.program, at.nodes, at.open);
    const double area = largest_change_percent(areas, panel_areas(mesh(), points));
    const double perimeter = largest_change_percent(perimeters, panel_perimeters(mesh(), points));
    result_.during.area_percent = std::max(result_.during.area_percent, area);
    result_.during.perimeter_percent = std::max(result_.during.perimeter_percent, perimeter);
    if (watcher_ && calls++ % 4 == 0) watcher_({mesh(), name, points, 0});
  };
  const RelaxReport report = relax(result_.program, options, result_.nodes, watch);
  StageReport& stage = result_.stages.emplace_back();
  stage.name = name;
  stage.vertices = result_.program.nodes;
  stage.steps = report.iterations;
  stage.searches = report.searches;
  stage.seconds = report.seconds;
  stage.converged = report.converged;
  if (report.open > 0) fprintf(stderr, "OPEN %g\n", report.open);
  stage.residual = report.residual;
}

void Dressing::go_finer() {
  const PanelMesh& coarse = mesh();
  const PanelMesh& fine = meshes_[level_ - 1];
  Program program = compile(fine, scene_, fine.placed);
  result_.nodes = refine_positions(coarse, result_.program.node_of_point, result_.nodes, fine,
                                   program.node_of_point, program.nodes);
  result_.program = std::move(program);
  --level_;
}

bool Dressing::clean() const {
  return self_intersections({result_.nodes, result_.program.node_triangles}).empty();
}

}  // namespace

DressResult dress(const PanelMesh& garment, const Scene& scene, const DressOptions& options,
                  const FrameWatcher& watcher) {
  if (scene.body == nullptr) throw Error("scene", "has no body", "give one to dress");
  return Dressing(garment, scene, options, watcher).run();
}

}  // namespace toile
