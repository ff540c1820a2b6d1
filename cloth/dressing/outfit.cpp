#include "cloth/dressing/outfit.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include "cloth/dressing/follow_body.h"
#include "cloth/dressing/outfit_warnings.h"
#include "cloth/dressing/panels_over.h"
#include "cloth/scene/floor.h"
#include "cloth/scene/standing_body.h"
#include "cloth/start/place_panels.h"
#include "geometry/error.h"

namespace toile {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Whether the garment is a surface that others can lie on: closed, and clear of everything.
bool is_surface(const Judgement& judgement) { return judgement.verdict >= Verdict::unconverged; }

class OutfitDresser {
 public:
  OutfitDresser(const Outfit& outfit, Collider& collider, const Skeleton* skeleton,
                const OutfitHooks& hooks)
      : outfit_(outfit), collider_(collider), skeleton_(skeleton), hooks_(hooks) {
    const bool is_one = count() == 1 && !outfit.layers.front().earlier;
    if (outfit.standing != nullptr && !is_one) {
      throw Error("outfit", "can't be taken along into a pose",
                  "give one garment, without an earlier drape");
    }
    if (count() > 1) cache_ = collider.grid().cache();
    for (std::size_t i = 0; i < count(); ++i) {
      for (std::size_t other = 0; other < count(); ++other) panels_over(i, other);
    }
  }

  WornOutfit run();

 private:
  std::size_t count() const { return outfit_.layers.size(); }
  Scene scene_of(const OutfitLayer& layer) const;
  /// The layers that are dressed; null: none.
  const TriangleMesh* layers_below() const {
    return collider_.cloth().triangles.empty() ? nullptr : &collider_.cloth();
  }
  FrameWatcher watcher_of(std::size_t layer, Certificate* certificate) const;
  void warn(const Warning& warning) const {
    if (hooks_.warn) hooks_.warn(warning);
  }
  void warn_of(const Warning& warning, WornLayer& worn) const {
    worn.warnings.push_back(warning);
    warn(warning);
  }
  std::vector<int> panels_over(std::size_t layer, std::size_t other) const;
  bool lies_under_panels(std::size_t layer) const;
  Collider collider_of(std::size_t layers, std::size_t under, std::size_t without) const;
  void put_in_place(const OutfitLayer& layer, WornLayer& worn) const;
  void continue_earlier(std::size_t layer, WornLayer& worn) const;
  WornLayer dress_layer(std::size_t layer) const;
  void write_and_judge(std::size_t layer, const TriangleMesh* others);
  bool turn_panels_out(std::size_t over);
  bool dress_one_by_one();
  void relax_coupled();
  void store_coupled();

  const Outfit& outfit_;
  Collider& collider_;
  const Skeleton* skeleton_;
  const OutfitHooks& hooks_;
  DistanceCache cache_;  // of the body, before the first of several layers
  WornOutfit worn_;
};

Scene OutfitDresser::scene_of(const OutfitLayer& layer) const {
  Scene scene;
  scene.fabric = layer.fabric;
  scene.fabrics = outfit_.fabrics;
  scene.collider = &collider_;
  scene.skeleton = skeleton_;
  scene.raised_distances = outfit_.raised_distances;
  scene.standing = outfit_.standing;
  scene.gravity = outfit_.gravity;
  if (outfit_.has_floor) scene.floor = floor_below(collider_.body(), outfit_.gravity);
  scene.strain_limit = outfit_.strain_limit;
  scene.shear_limit = outfit_.shear_limit;
  return scene;
}

FrameWatcher OutfitDresser::watcher_of(std::size_t layer, Certificate* certificate) const {
  FrameWatcher watcher;
  if (hooks_.watch) watcher = hooks_.watch(layer);
  return [certificate, watcher](const DressFrame& frame) {
    if (certificate != nullptr) certificate->check(frame);
    if (watcher) watcher(frame);
  };
}

/// Which panels of a layer lie over another one, by their indices.
std::vector<int> OutfitDresser::panels_over(std::size_t layer, std::size_t other) const {
  const auto& all = outfit_.layers[layer].panels_over;
  const auto found = all.find(outfit_.layers[other].name);
  if (found == all.end()) return {};
  return panels_named(outfit_.layers[layer].garment, found->second);
}

/// Whether panels of a layer below will lie over this one.
bool OutfitDresser::lies_under_panels(std::size_t layer) const {
  for (std::size_t i = 0; i < layer; ++i) {
    if (!panels_over(i, layer).empty()) return true;
  }
  return false;
}

/// The body and the first `layers`, but for what lies over the layer `under`, and all of `without`.
Collider OutfitDresser::collider_of(std::size_t layers, std::size_t under,
                                    std::size_t without) const {
  Collider collider(collider_.body(), cache_);
  for (std::size_t i = 0; i < layers; ++i) {
    if (i == without) continue;
    TriangleMesh cloth = worn_.layers[i].cloth;
    if (under < count()) {
      leave_out(outfit_.layers[i].garment, panels_over(i, under), cloth.triangles);
    }
    if (!cloth.triangles.empty()) collider.add_layer(cloth);
  }
  return collider;
}

/// Places the panels, and notes what was moved.
void OutfitDresser::put_in_place(const OutfitLayer& layer, WornLayer& worn) const {
  const StandingBody* standing = outfit_.standing;
  PlacedPanels placed = place_panels(
      standing != nullptr ? standing->collider.body() : collider_.body(),
      standing != nullptr ? &standing->skeleton : skeleton_, layer.places, worn.garment);
  if (placed.moved) worn.warnings.push_back(moved_layout_warning(*placed.moved, layer.garment));
  if (placed.is_upside_down) worn.warnings.push_back(upside_down_drawing_warning());
  std::ranges::copy(contradiction_warnings(layer.garment), std::back_inserter(worn.warnings));
  worn.moved = placed.moved;
  worn.places = std::move(placed.places);
  worn.place_reason = std::move(placed.reason);
}

/// Dresses the garment from its earlier drape, as far as that goes.
void OutfitDresser::continue_earlier(std::size_t layer, WornLayer& worn) const {
  if (!outfit_.method.continue_dress) {
    throw Error("method", "starts from flat panels only", "leave out the earlier drape");
  }
  const auto start = Clock::now();
  std::optional<Certificate>& certificate = worn.certificate;
  if (outfit_.certify) certificate.emplace(collider_.body(), layers_below());
  const FrameWatcher watcher = watcher_of(layer, certificate ? &*certificate : nullptr);
  worn.continued = outfit_.method.continue_dress(worn.garment, worn.scene,
                                                 *outfit_.layers[layer].earlier, watcher);
  worn.continued->seconds = seconds_since(start);
  if (worn.continued->result) worn.result = std::move(*worn.continued->result);
  worn.continued->result.reset();
  if (!worn.continued->refusal.empty()) {
    // What was tried does not count against the dressing that follows.
    certificate.reset();
    worn.warnings.push_back(refused_drape_warning(worn.continued->refusal));
  }
}

WornLayer OutfitDresser::dress_layer(std::size_t layer) const {
  const auto start = Clock::now();
  WornLayer worn;
  worn.garment = outfit_.layers[layer].garment;
  worn.scene = scene_of(outfit_.layers[layer]);
  put_in_place(outfit_.layers[layer], worn);
  const std::size_t known_before = collider_.grid().computed_nodes();
  if (outfit_.layers[layer].earlier) continue_earlier(layer, worn);
  {
    if (outfit_.certify && !worn.certificate) {
      worn.certificate.emplace(collider_.body(), layers_below());
    }
    const FrameWatcher watcher = watcher_of(layer, worn.certificate ? &*worn.certificate : nullptr);
    if (!worn.continued || !worn.continued->refusal.empty()) {
      worn.result = outfit_.method.dress(worn.garment, worn.scene, watcher);
    }
    // Where the panels stood decides what is judged, too.
    worn.garment.placed = worn.result.placement.initial;
    std::ranges::copy(start_warnings(worn.garment, standing_scene(worn.scene)),
                      std::back_inserter(worn.warnings));
    if (outfit_.standing != nullptr) {
      worn.garment.placed = taken_along(std::move(worn.garment.placed), worn.scene);
    }
    watcher({worn.garment, "dressed", material_points(worn.garment, worn.result), 1});
  }
  for (const Warning& warning : worn.warnings) warn(warning);
  worn.distances_computed = collider_.grid().computed_nodes() - known_before;
  worn.dress_seconds = seconds_since(start);
  return worn;
}

/// `others`: the cloth that this layer must not meet; null: none.
void OutfitDresser::write_and_judge(std::size_t layer, const TriangleMesh* others) {
  const auto start = Clock::now();
  WornLayer& worn = worn_.layers[layer];
  const DressResult& result = worn.result;
  DressedGarment dressed = as_dressed(worn.garment, result.nodes, result.triangles);
  std::ranges::replace(dressed.fabrics, std::string(), worn.scene.fabric.name);
  if (hooks_.write) dressed = hooks_.write(layer, dressed);
  DressingEnd end{result.converged, {}, result.tight_seams};
  if (result.release) end.stays = result.release->stays();
  if (worn.scene.floor) end.on_floor = *worn.scene.floor + result.body_offset;
  worn.judgement = judge(worn.garment, dressed, collider_.body(), skeleton_, end, others);
  worn.cloth = {std::move(dressed.points), std::move(dressed.triangles)};
  // A layer of several can come to rest yet, with the others.
  if (count() == 1 && worn.judgement.verdict == Verdict::unconverged) {
    const std::optional<Warning> warning = hardest_pulled_warning(worn.garment, result);
    if (warning) warn_of(*warning, worn);
  }
  if (worn.continued && worn.continued->refusal.empty() &&
      worn.judgement.verdict != Verdict::sewn) {
    warn_of(continued_drape_warning(), worn);
  }
  worn.judge_seconds += seconds_since(start);
}

/// Turns out the panels that lie over the layer that was dressed last; whether nothing meets then.
bool OutfitDresser::turn_panels_out(std::size_t over) {
  const std::size_t none = count();
  for (std::size_t i = 0; i < over; ++i) {
    const std::vector<int> panels = panels_over(i, over);
    if (panels.empty()) continue;
    WornLayer& worn = worn_.layers[i];
    // What the layer lay on, and the same with the other one on it.
    const Collider below = collider_of(i, none, none);
    Collider above = collider_of(i, none, none);
    above.add_layer(worn_.layers[over].cloth);
    const std::vector<char> moved = flip_over(worn.garment, panels, below.grid(), above.grid(),
                                              worn.result.triangles, worn.result.nodes);
    worn.result.warm_start.release_anchors(moved);
    const Collider others = collider_of(over + 1, none, i);
    write_and_judge(i, &others.cloth());
    if (is_surface(worn.judgement)) continue;
    warn(turned_out_warning(outfit_.layers[i].name, worn.judgement.verdict,
                            outfit_.layers[over].name));
    return false;
  }
  return true;
}

/// Whether all could be dressed; none is over a layer that failed.
bool OutfitDresser::dress_one_by_one() {
  const std::size_t none = count();
  double collider_seconds = 0;
  for (std::size_t i = 0; i < count(); ++i) {
    const OutfitLayer& layer = outfit_.layers[i];
    if (hooks_.begin) hooks_.begin(i);
    if (lies_under_panels(i)) collider_ = collider_of(i, i, none);
    worn_.layers.push_back(dress_layer(i));
    worn_.layers[i].collider_seconds = collider_seconds;
    if (hooks_.dressed) hooks_.dressed(i, worn_.layers[i]);
    write_and_judge(i, layers_below());
    if (hooks_.judged) hooks_.judged(i, worn_.layers[i]);
    const bool sewn = is_surface(worn_.layers[i].judgement);
    if (sewn && lies_under_panels(i)) {
      if (!turn_panels_out(i)) return false;
      collider_ = collider_of(i, none, none);
    }
    if (i + 1 == count()) return sewn;
    if (!sewn) {
      warn(last_layer_warning(layer.name, worn_.layers[i].judgement.verdict));
      return false;
    }
    const auto start = Clock::now();
    collider_.add_layer(worn_.layers[i].cloth);
    collider_seconds = seconds_since(start);
  }
  return true;
}

void OutfitDresser::relax_coupled() {
  if (hooks_.begin) hooks_.begin(count());
  const Collider bare(collider_.body(), cache_);
  Scene scene = scene_of(outfit_.layers.front());
  scene.collider = &bare;
  std::vector<WornGarment> garments;
  for (const WornLayer& worn : worn_.layers) {
    garments.push_back({&worn.garment, worn.scene.fabric, worn.result.nodes, worn.result.warm_start,
                        worn.result.body_offset, worn.result.attached});
  }
  std::optional<Certificate>& certificate = worn_.coupled_certificate;
  if (outfit_.certify) certificate.emplace(bare.body(), nullptr);
  const FrameWatcher watcher = watcher_of(count(), certificate ? &*certificate : nullptr);
  worn_.coupled = outfit_.method.relax_coupled(garments, scene, watcher);
}

/// The layers as the coupled relaxation left them.
void OutfitDresser::store_coupled() {
  const CoupledResult& coupled = *worn_.coupled;
  for (std::size_t i = 0; i < count(); ++i) {
    DressResult& result = worn_.layers[i].result;
    result.nodes = coupled.nodes[i];
    result.extra_offset = coupled.extra_offset[i];
    result.tight_seams = coupled.tight_seams[i];
    if (outfit_.strain_limit) result.tight_regions = coupled.tight_regions[i];
    result.converged = coupled.converged;
    result.residual = coupled.stages.back().residual;
    result.residual.hardest = -1;  // it is a node of all layers together
    result.release = coupled.release;
    const PanelMesh& garment = worn_.layers[i].garment;
    measure_lasting(garment, result.attached, material_points(garment, result), result.attachments);
  }
}

WornOutfit OutfitDresser::run() {
  const bool all_dressed = dress_one_by_one();
  if (outfit_.method.relax_coupled && all_dressed && count() > 1) {
    relax_coupled();
    store_coupled();
    for (std::size_t i = 0; i < count(); ++i) {
      TriangleMesh others;
      for (std::size_t j = 0; j < count(); ++j) {
        const DressResult& other = worn_.layers[j].result;
        if (j != i) append(others, {other.nodes, other.triangles});
      }
      write_and_judge(i, &others);
      if (hooks_.judged) hooks_.judged(i, worn_.layers[i]);
    }
  }
  for (WornLayer& worn : worn_.layers) {
    worn.scene.collider = nullptr;
    worn.scene.raised_distances = nullptr;
    worn.scene.standing = nullptr;
  }
  return std::move(worn_);
}

}  // namespace

OutfitMethod relaxation_method(const DressOptions& options, bool coupled) {
  DressOptions of_one = options;
  if (coupled) of_one.release_seconds = 0;
  OutfitMethod method;
  method.dress = [of_one](const PanelMesh& garment, const Scene& scene,
                          const FrameWatcher& watcher) {
    return dress(garment, scene, of_one, watcher);
  };
  method.continue_dress = [of_one](const PanelMesh& garment, const Scene& scene,
                                   const DressedGarment& earlier, const FrameWatcher& watcher) {
    return continue_dress(garment, scene, of_one, earlier, watcher);
  };
  if (!coupled) return method;
  method.relax_coupled = [options](const std::vector<WornGarment>& garments, const Scene& scene,
                                   const FrameWatcher& watcher) {
    return relax_coupled(garments, scene, options, watcher);
  };
  return method;
}

Verdict WornOutfit::verdict() const {
  for (const WornLayer& worn : layers) {
    if (worn.judgement.verdict != Verdict::sewn) return worn.judgement.verdict;
  }
  return Verdict::sewn;
}

WornOutfit dress_outfit(const Outfit& outfit, Collider& collider, const Skeleton* skeleton,
                        const OutfitHooks& hooks) {
  return OutfitDresser(outfit, collider, skeleton, hooks).run();
}

}  // namespace toile
