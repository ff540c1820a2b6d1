#include "tools/dress/run.h"

#include <unistd.h>

#include <chrono>
#include <iomanip>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cloth/dressing/panels_over.h"
#include "cloth/judge/verdict.h"
#include "cloth/scene/closed_body.h"
#include "cloth/scene/collider.h"
#include "cloth/start/placement_warnings.h"
#include "geometry/body/skeleton.h"
#include "geometry/error.h"
#include "io/distance_cache_file.h"
#include "io/output_file.h"
#include "io/skeleton_file.h"
#include "pattern/garment_file.h"
#include "tools/dress/report.h"
#include "tools/dress/watch.h"

namespace toile {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A layer that was dressed, written and judged.
struct Done {
  PanelMesh garment;  ///< its panels placed where they started
  Scene scene;        ///< fabrics and options; its surfaces are those of the last layer's
  DressResult result;
  std::optional<Certificate> certificate;
  std::vector<std::string> warnings;  ///< of where its panels were placed
  double seconds = 0;                 ///< all it took, but for the judging
  Json other_seconds;
  std::size_t distances = 0;  ///< of the body, that were computed
  Judgement judgement;
  TriangleMesh cloth;  ///< as written
};

class Outfit {
 public:
  Outfit(const OutfitSettings& settings, const CommonSettings& common)
      : settings_(settings), common_(common) {}

  int run();

 private:
  void read();
  void keep_distances();
  Scene scene_of(const OutfitLayer& layer) const;
  /// The layers that are dressed; null: none.
  const TriangleMesh* layers_below() const {
    return collider_->cloth().triangles.empty() ? nullptr : &collider_->cloth();
  }
  Done dress_layer(const OutfitLayer& layer, PanelMesh garment);
  void write_and_judge(std::size_t layer, const TriangleMesh* others);
  /// Which panels of a layer lie over another one, by their indices.
  std::vector<int> panels_over(std::size_t layer, std::size_t other) const;
  bool is_below_panels(std::size_t layer) const;
  Collider collider_of(std::size_t layers, std::size_t under, std::size_t without) const;
  bool turn_panels_out(std::size_t over);
  bool dress_one_by_one();
  void relax_coupled();
  Json report_of_layer(std::size_t layer) const;
  Json coupled_json() const;
  /// Of a scene: each layer's entry, and what became of the whole.
  Json whole_report() const;
  std::string verdict() const;  // the first of a layer that is not "sewn"

  const OutfitSettings& settings_;
  const CommonSettings& common_;
  const Clock::time_point start_ = Clock::now();
  std::vector<PanelMesh> garments_;        // one a layer: all are read before the first is dressed
  std::map<std::string, Fabric> fabrics_;  // by the names that panels give
  DistanceCache known_;                    // of the body, from earlier runs
  std::optional<Collider> collider_;
  std::optional<Skeleton> skeleton_;
  double read_seconds_ = 0;
  double grid_seconds_ = 0;
  std::vector<Done> done_;
  std::optional<CoupledResult> coupled_;
  std::optional<Certificate> coupled_certificate_;
};

void Outfit::read() {
  for (const OutfitLayer& layer : settings_.layers) {
    garments_.push_back(read_garment(layer.garment, layer.garment_json));
  }
  for (const PanelMesh& garment : garments_) {
    if (settings_.method.name != "paper") continue;
    if (!garment.elastics.empty()) {
      CommonSettings::warn("elastics are left out: --method paper does not know them");
    }
    if (!garment.attachments.empty()) {
      CommonSettings::warn("attachments are left out: --method paper does not know them");
    }
  }
  for (std::size_t i = 0; i < garments_.size(); ++i) {
    for (std::size_t other = 0; other < garments_.size(); ++other) panels_over(i, other);
  }
  fabrics_ = panel_fabrics(garments_, settings_.fabrics);
  const TriangleMesh body = read_closed_body(settings_.body);
  read_seconds_ = seconds_since(start_);
  const auto grid_start = Clock::now();
  if (settings_.cache) known_ = read_distance_cache(*settings_.cache, body).value_or(known_);
  collider_.emplace(body, known_);
  grid_seconds_ = seconds_since(grid_start);
  if (fs::exists(settings_.skeleton) || settings_.needs_skeleton) {
    skeleton_ = read_skeleton_of(collider_->skin(), settings_.skeleton);
  } else {
    CommonSettings::warn(
        settings_.skeleton.string() +
        " is missing: what the garment wraps is not measured; clean-body makes it");
  }
}

/// Of the body alone, so before a layer lies on it. What is hardly more than was known is not
/// written; nor is it an error when nothing can be.
void Outfit::keep_distances() {
  constexpr std::size_t worth_writing = 2000;  // nodes, a few milliseconds' work
  if (!settings_.cache || done_.front().distances < worth_writing) return;
  const auto start = Clock::now();
  try {
    write_distance_cache(*settings_.cache, collider_->body(), collider_->grid().cache());
  } catch (const Error& error) {
    CommonSettings::warn(std::string("the body's distances are not kept: ") + error.what());
  }
  done_.front().other_seconds["write_cache"] = seconds_since(start);
  done_.front().seconds += seconds_since(start);
}

Scene Outfit::scene_of(const OutfitLayer& layer) const {
  Scene scene;
  scene.fabric = layer.fabric;
  scene.fabrics = fabrics_;
  scene.collider = &*collider_;
  scene.skeleton = skeleton_ ? &*skeleton_ : nullptr;
  scene.gravity = settings_.gravity;
  scene.strain_limit = settings_.strain_limit;
  scene.shear_limit = settings_.shear_limit;
  return scene;
}

Done Outfit::dress_layer(const OutfitLayer& layer, PanelMesh garment) {
  const auto start = Clock::now();
  Done done;
  done.scene = scene_of(layer);
  const std::size_t known_before = collider_->grid().computed_nodes();
  // What is judged needs to know where the panels stood as much as what is dressed.
  garment.placed = position_panels(garment, collider_->grid(), done.scene.skeleton).placed;
  for (const PlacementWarning& warning : placement_warnings(garment, done.scene)) {
    done.warnings.push_back(text_of(warning));
    CommonSettings::warn(done.warnings.back());
  }
  for (const std::string& line : softened_fabrics(garment, done.scene)) {
    done.warnings.push_back(line);
    CommonSettings::warn(line);
  }
  if (settings_.certify_frames) done.certificate.emplace(collider_->body(), layers_below());
  {
    std::optional<fs::path> frames = settings_.frames;
    if (frames && settings_.scene) *frames /= layer.name;
    DressWatch watch(frames, !common_.quiet && isatty(STDERR_FILENO) != 0,
                     done.certificate ? &*done.certificate : nullptr);
    done.result =
        settings_.method.dress(garment, done.scene, [&](const DressFrame& frame) { watch(frame); });
    watch({garment, "dressed", material_points(garment, done.result), 1});
  }
  done.distances = collider_->grid().computed_nodes() - known_before;
  say_positions(done.result.placement, common_);
  say_terms(done.result, common_);
  done.garment = std::move(garment);
  done.seconds = seconds_since(start) + read_seconds_ + grid_seconds_;
  done.other_seconds = {{"read", read_seconds_}, {"body_grid", grid_seconds_}};
  read_seconds_ = 0;
  return done;
}

/// `others`: the cloth that this layer must not meet; null: none.
void Outfit::write_and_judge(std::size_t layer, const TriangleMesh* others) {
  const auto start = Clock::now();
  Done& done = done_[layer];
  const DressResult& result = done.result;
  const fs::path& output = settings_.layers[layer].output;
  write_dressed(output, as_dressed(done.garment, result.nodes, result.triangles));
  // Judged as anybody will read it, not as it is in memory.
  const DressedGarment written = read_dressed(output);
  const bool rests = result.converged && (!result.release || result.release->stays());
  done.judgement = judge(done.garment, written, collider_->body(), done.scene.skeleton, rests,
                         others, result.tight_seams);
  done.cloth = {written.points, written.triangles};
  const double seconds = seconds_since(start);
  done.other_seconds["write_and_judge"] = seconds;
  done.seconds += seconds;
}

std::vector<int> Outfit::panels_over(std::size_t layer, std::size_t other) const {
  const auto& all = settings_.layers[layer].panels_over;
  const auto found = all.find(settings_.layers[other].name);
  if (found == all.end()) return {};
  return panels_named(garments_[layer], found->second);
}

bool Outfit::is_below_panels(std::size_t layer) const {
  for (std::size_t i = 0; i < layer; ++i) {
    if (!panels_over(i, layer).empty()) return true;
  }
  return false;
}

/// The body and the first `layers`, but for what lies over the layer `under`, and all of `without`.
Collider Outfit::collider_of(std::size_t layers, std::size_t under, std::size_t without) const {
  Collider collider(collider_->body(), known_);
  for (std::size_t i = 0; i < layers; ++i) {
    if (i == without) continue;
    TriangleMesh cloth = done_[i].cloth;
    if (under < settings_.layers.size()) {
      leave_out(garments_[i], panels_over(i, under), cloth.triangles);
    }
    if (!cloth.triangles.empty()) collider.add_layer(cloth);
  }
  return collider;
}

/// Turns out the panels that lie over the layer that was dressed last; whether nothing meets then.
bool Outfit::turn_panels_out(std::size_t over) {
  const std::size_t nothing = settings_.layers.size();
  for (std::size_t i = 0; i < over; ++i) {
    const std::vector<int> panels = panels_over(i, over);
    if (panels.empty()) continue;
    Done& done = done_[i];
    // What the layer lay on, and the same with the other one on it.
    const Collider below = collider_of(i, nothing, nothing);
    Collider above = collider_of(i, nothing, nothing);
    above.add_layer(done_[over].cloth);
    const std::vector<char> moved = flip_over(done.garment, panels, below.grid(), above.grid(),
                                              done.result.triangles, done.result.nodes);
    done.result.warm_start.let_go(moved);
    const Collider others = collider_of(over + 1, nothing, i);
    write_and_judge(i, &others.cloth());
    const std::string& verdict = done.judgement.verdict;
    if (verdict == "sewn" || verdict == "unconverged") continue;
    CommonSettings::warn("layer " + settings_.layers[i].name + " is " + verdict +
                         " once its panels lie over " + settings_.layers[over].name +
                         ": the seams that join them to the rest have to be clear of it");
    return false;
  }
  return true;
}

/// Whether all could be dressed; none is over a layer that failed.
bool Outfit::dress_one_by_one() {
  for (std::size_t i = 0; i < garments_.size(); ++i) {
    const OutfitLayer& layer = settings_.layers[i];
    if (settings_.scene) common_.say("layer " + layer.name + ":");
    if (is_below_panels(i)) collider_ = collider_of(i, i, settings_.layers.size());
    done_.push_back(dress_layer(layer, garments_[i]));
    if (i == 0) keep_distances();
    Done& done = done_.back();
    write_and_judge(i, layers_below());
    if (done.certificate) say_certificate(*done.certificate, common_);
    say_result(done.result, done.judgement, common_);
    // What is not at rest is a surface still; what is open or meets something is none.
    const std::string& verdict = done.judgement.verdict;
    const bool is_surface = verdict == "sewn" || verdict == "unconverged";
    if (is_surface && is_below_panels(i)) {
      if (!turn_panels_out(i)) return false;
      collider_ = collider_of(i, settings_.layers.size(), settings_.layers.size());
    }
    if (i + 1 == garments_.size()) return is_surface;
    if (!is_surface) {
      CommonSettings::warn("layer " + layer.name + " is " + verdict +
                           ": the layers over it are not dressed");
      return false;
    }
    const auto grid_start = Clock::now();
    collider_->add_layer(done.cloth);
    grid_seconds_ = seconds_since(grid_start);
  }
  return true;
}

void Outfit::relax_coupled() {
  common_.say("together:");
  const Collider bare(collider_->body(), known_);
  Scene scene = scene_of(settings_.layers.front());
  scene.collider = &bare;
  std::vector<WornGarment> worn;
  for (const Done& done : done_) {
    worn.push_back({&done.garment, done.scene.fabric, done.result.nodes, done.result.warm_start,
                    done.result.body_offset, done.result.held});
  }
  if (settings_.certify_frames) coupled_certificate_.emplace(bare.body(), nullptr);
  {
    std::optional<fs::path> frames = settings_.frames;
    if (frames) *frames /= "together";
    DressWatch watch(frames, !common_.quiet && isatty(STDERR_FILENO) != 0,
                     coupled_certificate_ ? &*coupled_certificate_ : nullptr);
    coupled_ =
        settings_.method.relax_coupled(worn, scene, [&](const DressFrame& frame) { watch(frame); });
  }
  if (coupled_certificate_) say_certificate(*coupled_certificate_, common_);
  for (std::size_t i = 0; i < done_.size(); ++i) {
    DressResult& result = done_[i].result;
    result.nodes = coupled_->nodes[i];
    result.extra_offset = coupled_->extra_offset[i];
    result.tight_seams = coupled_->tight_seams[i];
    if (settings_.strain_limit) result.tight_regions = coupled_->tight_regions[i];
    result.converged = coupled_->stages.back().converged;
    result.residual = coupled_->stages.back().residual;
    result.release = coupled_->release;
    const PanelMesh& garment = done_[i].garment;
    measure_lasting(garment, result.held, material_points(garment, result), result.attachments);
  }
  for (std::size_t i = 0; i < done_.size(); ++i) {
    TriangleMesh others;
    for (std::size_t j = 0; j < done_.size(); ++j) {
      if (j == i) continue;
      append(others, {done_[j].result.nodes, done_[j].result.triangles});
    }
    write_and_judge(i, &others);
    common_.say("layer " + settings_.layers[i].name + ", moved together:");
    say_result(done_[i].result, done_[i].judgement, common_);
  }
  for (const LayerContact& pressing : coupled_->contacts) {
    std::ostringstream line;
    line << std::fixed << std::setprecision(1) << settings_.layers[pressing.outer].name
         << " presses on " << settings_.layers[pressing.inner].name << " with " << pressing.force
         << " N, " << pressing.force / pressing.area << " Pa where they touch";
    common_.say(line.str());
  }
}

Json Outfit::report_of_layer(std::size_t layer) const {
  const Done& done = done_[layer];
  Json report = report_of(done.garment, done.scene, settings_.method.name, done.result,
                          done.judgement, done.seconds);
  report["warnings"] = done.warnings;
  report["other_seconds"] = done.other_seconds;
  report["body_distances_computed"] = done.distances;
  if (settings_.method.quality) report.update(quality_json(*settings_.method.quality));
  if (done.certificate) report["certified"] = certified_json(*done.certificate);
  if (coupled_) report["moved_together_mm"] = moved_json(coupled_->moved[layer]);
  if (!settings_.scene) return report;
  Json named = {{"name", settings_.layers[layer].name},
                {"dressed", settings_.layers[layer].output.string()}};
  named.update(report);
  return named;
}

Json Outfit::coupled_json() const {
  Json json = {{"stages", stages_json(coupled_->stages)},
               {"converged", coupled_->stages.back().converged},
               {"residual", residual_json(coupled_->stages.back().residual)},
               {"pressing", Json::array()}};
  for (const LayerContact& pressing : coupled_->contacts) {
    json["pressing"].push_back({{"inner", settings_.layers[pressing.inner].name},
                                {"outer", settings_.layers[pressing.outer].name},
                                {"force_N", pressing.force},
                                {"area_m2", pressing.area},
                                {"mean_Pa", pressing.force / pressing.area}});
  }
  if (coupled_certificate_) json["certified"] = certified_json(*coupled_certificate_);
  return json;
}

std::string Outfit::verdict() const {
  for (const Done& done : done_) {
    if (done.judgement.verdict != "sewn") return done.judgement.verdict;
  }
  return "sewn";
}

Json Outfit::whole_report() const {
  Json report;
  report["scene_file"] = settings_.scene->string();
  report["body"] = settings_.body.string();
  report["layering"] = settings_.coupled ? "coupled" : "frozen";
  report["layers"] = Json::array();
  for (std::size_t i = 0; i < done_.size(); ++i) report["layers"].push_back(report_of_layer(i));
  report["not_dressed"] = Json::array();
  for (std::size_t i = done_.size(); i < settings_.layers.size(); ++i) {
    report["not_dressed"].push_back(settings_.layers[i].name);
  }
  if (coupled_) report["together"] = coupled_json();
  report["seconds"] = seconds_since(start_);
  report["verdict"] = verdict();
  return report;
}

int Outfit::run() {
  read();
  const bool all_dressed = dress_one_by_one();
  if (settings_.coupled && all_dressed && done_.size() > 1) relax_coupled();
  if (common_.report) {
    const Json report = settings_.scene ? whole_report() : report_of_layer(0);
    write_file(*common_.report, report.dump(2) + "\n");
  }
  if (settings_.scene) common_.say("outfit: " + verdict());
  return verdict() == "sewn" ? exit_done : exit_negative;
}

}  // namespace

int dress_outfit(const OutfitSettings& settings, const CommonSettings& common) {
  return Outfit(settings, common).run();
}

}  // namespace toile
