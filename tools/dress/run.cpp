#include "tools/dress/run.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>

#include "cloth/scene/closed_body.h"
#include "cloth/scene/standing_body.h"
#include "geometry/error.h"
#include "io/checksum.h"
#include "io/output_file.h"
#include "io/skeleton_file.h"
#include "pattern/file/garment_file.h"
#include "tools/dress/kept_distances.h"
#include "tools/dress/report.h"
#include "tools/dress/say.h"
#include "tools/dress/watch.h"
#include "tools/report.h"

namespace toile {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

class DressRun {
 public:
  /// `values`: in place of the files that would be read and written; null: there are files.
  DressRun(const DressSettings& settings, const CommonSettings& common, DressValues* values)
      : settings_(settings), common_(common), values_(values), log_(common) {}

  /// Dresses and judges all layers.
  WornOutfit dress();
  /// The report of them.
  Json report(const WornOutfit& worn) const;
  /// Writes the files.
  DressEnd write(const WornOutfit& worn);
  /// Without files, the drape of the one layer.
  DressedGarment take_drape() { return std::move(drape_); }

 private:
  Outfit read_outfit();
  void read_body();
  void read_standing();
  OutfitHooks hooks();
  std::vector<std::string> names() const;
  FrameWatcher watch(std::size_t layer) const;
  void say_dressed(std::size_t layer, const WornLayer& worn);
  void say_judged(std::size_t layer, const WornLayer& worn);
  void keep_distances(std::size_t computed);
  Json layer_report(const WornOutfit& worn, std::size_t layer) const;
  Json scene_report(const WornOutfit& worn) const;

  const DressSettings& settings_;
  const CommonSettings& common_;
  DressValues* values_;
  DressedGarment drape_;
  const Clock::time_point start_ = Clock::now();
  DressLog log_;
  OutputFiles files_;  // but for the states on the way and the cache
  std::optional<KeptDistances> distances_;
  std::optional<KeptDistances> standing_distances_;
  std::optional<Collider> collider_;
  std::optional<Skeleton> skeleton_;
  std::optional<StandingBody> standing_;
  double read_seconds_ = 0;
  double grid_seconds_ = 0;
  std::optional<double> cache_seconds_;  // to write it
  std::vector<Warning> warnings_;        // of the whole
  std::vector<std::vector<Warning>> layer_warnings_;
  bool together_ = false;  // the layers are dressed and move as one
};

std::vector<std::string> DressRun::names() const {
  std::vector<std::string> names;
  for (const LayerFiles& layer : settings_.layers) names.push_back(layer.name);
  return names;
}

Outfit DressRun::read_outfit() {
  Outfit outfit;
  std::vector<PanelMesh> garments;
  for (const LayerFiles& layer : settings_.layers) {
    std::vector<std::string> warnings;
    garments.push_back(values_ != nullptr
                           ? std::move(values_->garment)
                           : read_garment(layer.garment, layer.garment_json, &warnings));
    for (const std::string& warning : warnings) log_.warn({"empty_attachment", "", warning});
    if (settings_.method.name != "paper") continue;
    if (!garments.back().elastics.empty()) {
      log_.warn(
          {"elastics_left_out", "", "elastics are left out: --method paper does not know them"});
    }
    if (!garments.back().attachments.empty()) {
      log_.warn({"attachments_left_out", "",
                 "attachments are left out: --method paper does not know them"});
    }
  }
  outfit.fabrics = panel_fabrics(garments, settings_.fabrics);
  for (std::size_t i = 0; i < garments.size(); ++i) {
    const LayerFiles& layer = settings_.layers[i];
    outfit.layers.push_back(
        {layer.name, std::move(garments[i]), layer.fabric, layer.panels_over, layer.places});
    if (layer.earlier) outfit.layers.back().earlier = read_dressed(*layer.earlier);
    if (values_ != nullptr) outfit.layers.back().earlier = std::move(values_->earlier);
  }
  outfit.gravity = settings_.gravity;
  outfit.has_floor = settings_.has_floor && settings_.method.name != "paper";
  outfit.strain_limit = settings_.strain_limit;
  outfit.shear_limit = settings_.shear_limit;
  outfit.certify = settings_.certify_frames;
  outfit.method = settings_.method.outfit;
  return outfit;
}

void DressRun::read_body() {
  const TriangleMesh body = values_ != nullptr
                                ? closed_body(std::move(values_->body), settings_.body.string())
                                : read_closed_body(settings_.body);
  read_seconds_ = seconds_since(start_);
  const auto grid_start = Clock::now();
  if (settings_.cache) distances_.emplace(*settings_.cache, log_);
  collider_.emplace(body, distances_ ? distances_->of_body(body) : DistanceCache());
  grid_seconds_ = seconds_since(grid_start);
  if (values_ != nullptr && values_->skeleton) {
    skeleton_ = skeleton_of(collider_->skin(), *values_->skeleton, settings_.skeleton.string());
  } else if (values_ == nullptr && (fs::exists(settings_.skeleton) || settings_.needs_skeleton)) {
    skeleton_ = read_skeleton_of(collider_->skin(), settings_.skeleton);
  } else {
    log_.warn({"no_joints", "",
               settings_.skeleton.string() +
                   " is missing: what the garment wraps is not measured; clean-body makes it"});
  }
}

/// The body before its pose; read_body() has read the posed one.
void DressRun::read_standing() {
  const fs::path& path = *settings_.standing;
  const auto start = Clock::now();
  const TriangleMesh body = read_closed_body(path);
  SurfaceMorph motion(body, collider_->body(), path.string());
  if (settings_.cache) standing_distances_.emplace(distances_path(path), log_);
  Collider collider(body,
                    standing_distances_ ? standing_distances_->of_body(body) : DistanceCache());
  Skeleton skeleton = read_skeleton_of(collider.skin(), skeleton_beside(path));
  standing_.emplace(StandingBody{std::move(collider), std::move(skeleton), std::move(motion)});
  read_seconds_ += seconds_since(start);
}

FrameWatcher DressRun::watch(std::size_t layer) const {
  std::optional<fs::path> frames = settings_.frames;
  const bool is_whole = layer == settings_.layers.size();
  if (frames && settings_.scene) *frames /= is_whole ? "coupled" : settings_.layers[layer].name;
  const bool shows_progress = !common_.quiet && isatty(STDERR_FILENO) != 0;
  const auto watcher = std::make_shared<DressWatch>(frames, shows_progress);
  return [watcher](const DressFrame& frame) { (*watcher)(frame); };
}

void DressRun::say_dressed(std::size_t layer, const WornLayer& worn) {
  say_places(worn, log_);
  say_positions(worn.result.placement, log_);
  if (layer == 0) keep_distances(worn.distances_computed);
}

/// Of the body alone, so before a layer lies on it.
void DressRun::keep_distances(std::size_t computed) {
  const auto start = Clock::now();
  if (distances_ && distances_->keep_body(*collider_, computed)) {
    cache_seconds_ = seconds_since(start);
  }
  if (standing_distances_) {
    const Collider& standing = standing_->collider;
    standing_distances_->keep_body(standing, standing.grid().computed_nodes());
  }
}

void DressRun::say_judged(std::size_t layer, const WornLayer& worn) {
  if (together_) {
    log_.say("layer " + settings_.layers[layer].name + ", moved together:");
  } else {
    if (worn.certificate) say_certificate(*worn.certificate, log_);
    layer_warnings_.emplace_back();
  }
  say_result(worn.result, worn.judgement, log_);
  std::ranges::move(log_.take_warnings(), std::back_inserter(layer_warnings_[layer]));
}

OutfitHooks DressRun::hooks() {
  OutfitHooks hooks;
  hooks.begin = [this](std::size_t layer) {
    together_ = layer == settings_.layers.size();
    if (together_) {
      log_.say("together:");
    } else if (settings_.scene) {
      log_.say("layer " + settings_.layers[layer].name + ":");
    }
  };
  hooks.watch = [this](std::size_t layer) { return watch(layer); };
  hooks.warn = [this](const Warning& warning) { log_.warn(warning); };
  hooks.dressed = [this](std::size_t layer, const WornLayer& worn) { say_dressed(layer, worn); };
  hooks.write = [this](std::size_t layer, const DressedGarment& garment) {
    const fs::path& output = settings_.layers[layer].output;
    if (values_ != nullptr) return drape_ = garment;  // files keep all bits
    write_dressed(files_.at(output), garment);
    return read_dressed(files_.written(output));
  };
  hooks.judged = [this](std::size_t layer, const WornLayer& worn) { say_judged(layer, worn); };
  return hooks;
}

Json DressRun::layer_report(const WornOutfit& worn, std::size_t layer) const {
  const WornLayer& one = worn.layers[layer];
  LayerNotes notes;
  notes.body = settings_.body.string();
  if (settings_.standing) notes.standing = settings_.standing->string();
  notes.garment = settings_.layers[layer].garment.string();
  if (settings_.layers[layer].earlier) notes.earlier = settings_.layers[layer].earlier->string();
  notes.dressed_sha256 = values_ != nullptr
                             ? sha256(format_dressed(drape_))
                             : sha256_of_file(files_.written(settings_.layers[layer].output));
  notes.warnings = layer_warnings_[layer];
  if (!settings_.scene) {
    notes.warnings.insert(notes.warnings.begin(), warnings_.begin(), warnings_.end());
  }
  const bool first = layer == 0;
  notes.other_seconds = {{"read", first ? read_seconds_ : 0},
                         {"body_grid", first ? grid_seconds_ : one.collider_seconds}};
  if (first && cache_seconds_) notes.other_seconds.emplace_back("write_cache", *cache_seconds_);
  notes.other_seconds.emplace_back("write_and_judge", one.judge_seconds);
  notes.seconds = one.dress_seconds;
  for (const auto& [what, seconds] : notes.other_seconds) notes.seconds += seconds;
  Json report = layer_json(one, settings_.method, notes);
  if (worn.coupled) report["moved_coupled_mm"] = moved_json(worn.coupled->moved[layer]);
  if (!settings_.scene) return report;
  Json named = {{"name", settings_.layers[layer].name},
                {"dressed", settings_.layers[layer].output.string()}};
  named.update(report);
  return named;
}

/// Each layer's entry, and what became of the whole.
Json DressRun::scene_report(const WornOutfit& worn) const {
  Json report;
  report["scene_file"] = settings_.scene->string();
  report["body"] = settings_.body.string();
  report["layering"] = settings_.coupled ? "coupled" : "frozen";
  report["layers"] = Json::array();
  for (std::size_t i = 0; i < worn.layers.size(); ++i) {
    report["layers"].push_back(layer_report(worn, i));
  }
  report["not_dressed"] = Json::array();
  for (std::size_t i = worn.layers.size(); i < settings_.layers.size(); ++i) {
    report["not_dressed"].push_back(settings_.layers[i].name);
  }
  if (worn.coupled) report["coupled"] = coupled_json(worn, names());
  report["warnings"] = warnings_json(warnings_);
  report["seconds"] = seconds_since(start_);
  report["verdict"] = to_string(worn.verdict());
  return report;
}

/// Whether all that was to be certified became free of intersections and stayed so.
bool is_certified(const WornOutfit& worn) {
  const auto is_clean = [](const std::optional<Certificate>& certificate) {
    return !certificate || certificate->stayed_clean();
  };
  return is_clean(worn.coupled_certificate) &&
         std::ranges::all_of(worn.layers, is_clean, &WornLayer::certificate);
}

WornOutfit DressRun::dress() {
  Outfit outfit = read_outfit();
  read_body();
  if (settings_.standing) read_standing();
  if (standing_) outfit.standing = &*standing_;
  // Arms are raised where the garment is put on.
  if (distances_) outfit.raised_distances = standing_ ? &*standing_distances_ : &*distances_;
  warnings_ = settings_.earlier_warnings;
  std::ranges::move(log_.take_warnings(), std::back_inserter(warnings_));
  WornOutfit worn = dress_outfit(outfit, *collider_, skeleton_ ? &*skeleton_ : nullptr, hooks());
  if (worn.coupled) {
    if (worn.coupled_certificate) say_certificate(*worn.coupled_certificate, log_);
    say_pressing(*worn.coupled, names(), log_);
  }
  std::ranges::move(log_.take_warnings(), std::back_inserter(warnings_));
  return worn;
}

Json DressRun::report(const WornOutfit& worn) const {
  return settings_.scene ? scene_report(worn) : layer_report(worn, 0);
}

DressEnd DressRun::write(const WornOutfit& worn) {
  write_report(files_, common_, report(worn));
  files_.commit();
  if (settings_.scene) log_.say("outfit: " + to_string(worn.verdict()));
  return {worn.verdict(), is_certified(worn)};
}

}  // namespace

DressEnd run_dress(const DressSettings& settings, const CommonSettings& common) {
  DressRun run(settings, common, nullptr);
  return run.write(run.dress());
}

DressedValues dress_values(DressValues values, const DressSettings& settings,
                           const CommonSettings& common) {
  DressRun run(settings, common, &values);
  WornOutfit worn = run.dress();
  nlohmann::ordered_json report = run.report(worn);
  return {run.take_drape(),
          std::move(worn.layers.front().garment.placed),
          std::move(report),
          {worn.verdict(), is_certified(worn)}};
}

ExitCode exit_code_of(const DressEnd& end) {
  return end.verdict == Verdict::sewn && end.is_certified ? exit_done : exit_negative;
}

}  // namespace toile
