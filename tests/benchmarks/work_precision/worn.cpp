#include "tests/benchmarks/work_precision/worn.h"

#include <map>
#include <sstream>

#include "cloth/model/compile.h"
#include "cloth/scene/fabric.h"
#include "cloth/springs/dress_springs.h"
#include "io/mesh_file.h"
#include "io/skeleton_file.h"
#include "pattern/file/garment_file.h"

namespace toile::precision {

namespace {

namespace fs = std::filesystem;

class Worn : public Case {
 public:
  Worn(const std::string& scene, double edge_mm, PanelMesh garment, const Wearer& wearer,
       Switched term)
      : Case(scene, edge_mm), garment_(std::move(garment)), wearer_(wearer) {
    scene_.collider = &wearer.collider;
    scene_.skeleton = &wearer.skeleton;
    for (const MeshedPanel& panel : garment_.panels) {
      if (!panel.fabric.empty()) scene_.fabrics[panel.fabric] = find_fabric(panel.fabric);
    }
    switch_term(term);
    garment_.placed = position_panels(garment_, wearer.collider.grid(), scene_.skeleton).placed;
    model_ = compile(garment_, scene_, garment_.placed);
  }

  const PanelMesh& garment() const override { return garment_; }
  const GarmentModel& model() const override { return model_; }
  const SurfaceDistance* body() const override { return &wearer_.collider.skin(); }
  double springs_at_rest() const override { return 0.005; }
  Outcome run(Method method, const Setting& setting) const override {
    Outcome done;
    const Stopwatch watch;
    const DressResult result = method == Method::relaxation ? relaxed(setting) : by_paper(setting);
    watch.stop(done);
    done.points = material_points(garment_, result.nodes, result.triangles);
    done.residual = result.residual;
    done.converged = result.converged;
    const StageReport& last = result.stages.back();
    done.sewn = last.name == "rest" || last.name == "drape";
    for (const StageReport& stage : result.stages) {
      if (stage.nodes == last.nodes) done.iterations += stage.steps;
      done.simulated += stage.simulated;
    }
    return done;
  }

 private:
  void switch_term(Switched term) {
    switch (term) {
      case Switched::none:
        break;
      case Switched::bending:
        scene_.fabric.bending_warp = scene_.fabric.bending_weft = 0;
        break;
      case Switched::self_contact:
        scene_.self_contact = false;
        break;
      case Switched::edge_contact:
        scene_.body_contact = BodyContactTerm::nodes;
        break;
      case Switched::friction:
        scene_.fabric.friction_skin = scene_.fabric.friction_cloth = 0;
        break;
      case Switched::strain_limit:
        scene_.strain_limit = 0.01;
        break;
    }
  }

  DressResult relaxed(const Setting& setting) const {
    DressOptions options;
    options.stop_median = options.stop_wide = setting.residual;
    options.stop_rms = 10 * setting.residual;
    options.max_iterations = setting.iterations;
    return dress(garment_, scene_, options);
  }

  DressResult by_paper(const Setting& setting) const {
    SpringDressOptions options;
    options.motion.step_share = setting.step_share;
    options.motion.converged_strain = setting.exact_limit;
    options.stop_median = setting.residual;
    options.stop_rms = 10 * setting.residual;
    options.longest_drape = setting.seconds;
    return dress_springs(garment_, scene_, options);
  }

  PanelMesh garment_;
  const Wearer& wearer_;
  Scene scene_;
  GarmentModel model_;
};

}  // namespace

Wearer::Wearer(const fs::path& body)
    : collider(fan_triangles(read_mesh(body))), skeleton(read_skeleton(skeleton_path(body))) {}

struct Wardrobe::Shelf {
  pipeline::ScratchFolder folder;
  pipeline::Bodies bodies{folder.path()};
  std::map<std::string, Wearer> wearers;
  std::map<std::string, PanelMesh> garments;
};

Wardrobe::Wardrobe() : shelf_(std::make_unique<Shelf>()) {}
Wardrobe::~Wardrobe() = default;

std::unique_ptr<Case> Wardrobe::get(const WornGarment& garment, double edge_mm, Switched term) {
  const auto pattern = pipeline::pattern_for(garment.body, garment.pattern);
  const auto body = pattern ? shelf_->bodies.get(garment.body) : std::nullopt;
  if (!body) return nullptr;
  const Wearer& wearer = shelf_->wearers.try_emplace(garment.body, *body).first->second;
  std::ostringstream length;
  length << edge_mm << "mm";
  const std::string name = garment.scene + " " + length.str();
  if (shelf_->garments.count(name) == 0) {
    const fs::path mesh = shelf_->folder / (name + ".obj");
    pipeline::run_or_throw("mesh-pattern", {pattern->string(), "-o", mesh.string(), "--edge-length",
                                            length.str(), "-q"});
    shelf_->garments[name] = read_garment(mesh);
  }
  return std::make_unique<Worn>(garment.scene, edge_mm, shelf_->garments[name], wearer, term);
}

}  // namespace toile::precision
