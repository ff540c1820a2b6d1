// dress: sews meshed garments around a body, one over another, and lets them come to rest.

#include "cloth/dress.h"

#include <unistd.h>

#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cloth/judge.h"
#include "cloth/scene_file.h"
#include "cloth/subject.h"
#include "geometry/body/skeleton.h"
#include "geometry/error.h"
#include "io/output_file.h"
#include "io/skeleton_file.h"
#include "pattern/garment_file.h"
#include "tools/closed_body.h"
#include "tools/dress_fabrics.h"
#include "tools/dress_method.h"
#include "tools/dress_report.h"
#include "tools/dress_watch.h"
#include "tools/program.h"

namespace toile {

namespace {

namespace po = boost::program_options;
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// One garment that is to be dressed.
struct Layer {
  std::string name;  ///< empty: the only one, not of a scene file
  fs::path garment;
  fs::path garment_json;
  Fabric fabric;
  fs::path output;
};

struct Settings {
  std::optional<fs::path> scene;
  fs::path body;
  fs::path skeleton;
  bool needs_skeleton = false;  ///< it was asked for, not looked for
  std::vector<Layer> layers;
  FabricChoice fabrics;
  std::optional<fs::path> frames;
  bool certify_frames = false;
  std::optional<double> strain_limit;
  Vec3 gravity = Scene().gravity;
  DressMethod method;
};

/// The garment or the scene that the command line names, with the files to write for it.
void read_layers(const po::variables_map& given, const fs::path& output, Settings& settings) {
  settings.fabrics = read_fabrics(given);
  const std::string& fabric = settings.fabrics.of_garments;
  if (given.count("scene") == 0) {
    Layer only;
    only.garment = given["garment"].as<std::string>();
    if (given.count("garment-json")) only.garment_json = given["garment-json"].as<std::string>();
    only.fabric = find_fabric(fabric);
    only.output = output;
    settings.body = given["body"].as<std::string>();
    settings.layers.push_back(only);
  } else {
    settings.scene = given["scene"].as<std::string>();
    const SceneFile scene = read_scene(*settings.scene);
    settings.body = scene.body;
    if (scene.gravity) settings.gravity = *scene.gravity;
    settings.skeleton = scene.skeleton.value_or(skeleton_path(scene.body));
    settings.needs_skeleton = scene.skeleton.has_value();
    for (const SceneLayer& layer : scene.layers) {
      const std::string file = output.stem().string() + "-" + layer.name + ".obj";
      settings.layers.push_back({layer.name, layer.garment, layer.garment_json,
                                 find_fabric(layer.fabric.empty() ? fabric : layer.fabric),
                                 output.parent_path() / file});
    }
  }
  if (given.count("skeleton")) {
    settings.skeleton = given["skeleton"].as<std::string>();
    settings.needs_skeleton = true;
  } else if (settings.skeleton.empty()) {
    settings.skeleton = skeleton_path(settings.body);
  }
}

/// "x,y,z", m/s².
Vec3 parse_gravity(const std::string& text) {
  Vec3 gravity;
  std::istringstream words(text);
  char comma = ',';
  for (int i = 0; i < 3; ++i) {
    if (i > 0) words >> comma;
    if (comma != ',' || !(words >> gravity[i])) {
      throw Error("--gravity", "'" + text + "' is not three numbers",
                  "write --gravity=X,Y,Z in m/s²: 0,-9.81,0 is the default");
    }
  }
  if (words >> comma) {
    throw Error("--gravity", "'" + text + "' goes on after three numbers",
                "write --gravity=X,Y,Z in m/s²: 0,-9.81,0 is the default");
  }
  check_gravity(gravity, "--gravity");
  return gravity;
}

Settings read_settings(const po::variables_map& given, const fs::path& output) {
  Settings settings;
  read_layers(given, output, settings);
  if (given.count("frames")) settings.frames = given["frames"].as<std::string>();
  settings.certify_frames = given.count("certify-frames") != 0;
  if (given.count("gravity")) settings.gravity = parse_gravity(given["gravity"].as<std::string>());
  settings.strain_limit = read_strain_limit(given);
  settings.method = read_method(given);
  return settings;
}

/// The files that a scene writes are named by its layers: none may be one that it reads.
void refuse_overwriting(const Settings& settings, const CommonSettings& common) {
  const auto same = [](const fs::path& a, const fs::path& b) {
    return fs::weakly_canonical(a) == fs::weakly_canonical(b);
  };
  std::vector<fs::path> inputs = {settings.body, settings.skeleton};
  if (settings.scene) inputs.push_back(*settings.scene);
  for (const Layer& layer : settings.layers) {
    inputs.push_back(layer.garment);
    inputs.push_back(layer.garment_json.empty() ? fs::path(layer.garment).replace_extension("json")
                                                : layer.garment_json);
  }
  for (const Layer& layer : settings.layers) {
    if (common.report && same(layer.output, *common.report)) {
      throw Error("--report", "is the same file as a layer's", "name two files");
    }
    for (const fs::path& input : inputs) {
      if (same(layer.output, input) || (common.report && same(*common.report, input))) {
        throw Error(input.string(), "would be overwritten", "give the output another name");
      }
    }
    check_writable(layer.output);
  }
}

/// A layer that was dressed, written and judged.
struct Done {
  Json report;
  std::string verdict;
  TriangleMesh cloth;  ///< as written
};

class Outfit {
 public:
  Outfit(const Settings& settings, const CommonSettings& common)
      : settings_(settings), common_(common) {}

  int run();

 private:
  void read();
  Done dress_layer(const Layer& layer, PanelMesh garment);
  /// Of a scene: each layer's entry, and what became of the whole.
  Json whole_report() const;

  const Settings& settings_;
  const CommonSettings& common_;
  const Clock::time_point start_ = Clock::now();
  std::vector<PanelMesh> garments_;        // one a layer: all are read before the first is dressed
  std::map<std::string, Fabric> fabrics_;  // by the names that panels give
  std::optional<Subject> subject_;
  std::optional<Skeleton> skeleton_;
  double read_seconds_ = 0;
  double grid_seconds_ = 0;
  std::vector<Json> reports_;
  std::string verdict_ = "sewn";  // the first that is another
};

void Outfit::read() {
  for (const Layer& layer : settings_.layers) {
    garments_.push_back(read_garment(layer.garment, layer.garment_json));
  }
  fabrics_ = panel_fabrics(garments_, settings_.fabrics);
  const TriangleMesh body = read_closed_body(settings_.body);
  if (fs::exists(settings_.skeleton) || settings_.needs_skeleton) {
    skeleton_ = read_skeleton(settings_.skeleton);
  } else {
    CommonSettings::warn(
        settings_.skeleton.string() +
        " is missing: what the garment wraps is not measured; clean-body makes it");
  }
  read_seconds_ = seconds_since(start_);
  const auto grid_start = Clock::now();
  subject_.emplace(body);
  grid_seconds_ = seconds_since(grid_start);
}

Done Outfit::dress_layer(const Layer& layer, PanelMesh garment) {
  const auto start = Clock::now();
  Scene scene;
  scene.fabric = layer.fabric;
  scene.fabrics = fabrics_;
  scene.body = &subject_->grid();
  scene.subject = &subject_->surface();
  scene.layers = subject_->cloth().triangles.empty() ? nullptr : &subject_->cloth();
  scene.skeleton = skeleton_ ? &*skeleton_ : nullptr;
  scene.gravity = settings_.gravity;
  scene.strain_limit = settings_.strain_limit;
  // What is judged needs to know where the panels stood as much as what is dressed.
  garment.placed = position_panels(garment, *scene.body, scene.skeleton).placed;
  std::optional<Certificate> certificate;
  if (settings_.certify_frames) certificate.emplace(subject_->body(), scene.layers);
  const DressResult result = [&] {
    std::optional<fs::path> frames = settings_.frames;
    if (frames && settings_.scene) *frames /= layer.name;
    DressWatch watch(frames, !common_.quiet && isatty(STDERR_FILENO) != 0,
                     certificate ? &*certificate : nullptr);
    DressResult dressed =
        settings_.method.dress(garment, scene, [&](const DressFrame& frame) { watch(frame); });
    watch({garment, "dressed", material_points(garment, dressed), 1});
    return dressed;
  }();
  say_positions(result.placement, common_);
  say_terms(result, common_);

  const auto judge_start = Clock::now();
  write_dressed(layer.output, as_dressed(garment, result.nodes, result.triangles));
  // Judged as anybody will read it, not as it is in memory.
  const DressedGarment written = read_dressed(layer.output);
  const bool rests = result.converged && (!result.release || result.release->stays());
  const Judgement judgement = judge(garment, written, subject_->body(), scene.skeleton, rests,
                                    scene.layers, result.tight_seams);
  const double judge_seconds = seconds_since(judge_start);
  Done done;
  done.report = report_of(garment, scene, settings_.method.name, result, judgement,
                          seconds_since(start) + read_seconds_ + grid_seconds_);
  done.report["other_seconds"] = {
      {"read", read_seconds_}, {"body_grid", grid_seconds_}, {"write_and_judge", judge_seconds}};
  if (certificate) {
    done.report["certified"] = certified_json(*certificate);
    say_certificate(*certificate, common_);
  }
  read_seconds_ = 0;
  done.verdict = judgement.verdict;
  done.cloth = {written.points, written.triangles};
  say_result(result, judgement, common_);
  return done;
}

Json Outfit::whole_report() const {
  Json report;
  report["scene_file"] = settings_.scene->string();
  report["body"] = settings_.body.string();
  report["layers"] = reports_;
  report["not_dressed"] = Json::array();
  for (std::size_t i = reports_.size(); i < settings_.layers.size(); ++i) {
    report["not_dressed"].push_back(settings_.layers[i].name);
  }
  report["seconds"] = seconds_since(start_);
  report["verdict"] = verdict_;
  return report;
}

int Outfit::run() {
  read();
  for (std::size_t i = 0; i < garments_.size(); ++i) {
    const Layer& layer = settings_.layers[i];
    if (settings_.scene) common_.say("layer " + layer.name + ":");
    Done done = dress_layer(layer, garments_[i]);
    if (settings_.scene) {
      Json named = {{"name", layer.name}, {"dressed", layer.output.string()}};
      named.update(done.report);
      done.report = named;
    }
    reports_.push_back(done.report);
    if (verdict_ == "sewn") verdict_ = done.verdict;
    if (i + 1 == garments_.size()) break;
    // What is not at rest is a surface still; what is open or meets something is none.
    if (done.verdict != "sewn" && done.verdict != "unconverged") {
      CommonSettings::warn("layer " + layer.name + " is " + done.verdict +
                           ": the layers over it are not dressed");
      break;
    }
    const auto grid_start = Clock::now();
    subject_->add_layer(done.cloth);
    grid_seconds_ = seconds_since(grid_start);
  }
  if (common_.report) {
    const Json report = settings_.scene ? whole_report() : reports_.front();
    write_file(*common_.report, report.dump(2) + "\n");
  }
  if (settings_.scene) common_.say("outfit: " + verdict_);
  return verdict_ == "sewn" ? exit_done : exit_negative;
}

int work(const po::variables_map& given, const CommonSettings& common) {
  const Settings settings = read_settings(given, common.output);
  refuse_overwriting(settings, common);
  return Outfit(settings, common).run();
}

/// A garment on a body, or a scene that names them: one of the two.
void check_usage(const po::variables_map& given) {
  const bool has_scene = given.count("scene") != 0;
  for (const char* name : {"body", "garment", "garment-json"}) {
    const bool is_given = given.count(name) != 0;
    if (has_scene && is_given) {
      throw po::error("--scene names the body and the garments: leave out the " +
                      std::string(name));
    }
    if (!has_scene && !is_given && name != std::string("garment-json")) {
      throw po::required_option(name);
    }
  }
  check_method_options(given);
}

}  // namespace

}  // namespace toile

int main(int argc, char** argv) {
  using boost::program_options::value;
  using std::string;
  toile::CommandLineProgram program;
  program.name = "dress";
  program.summary = "sews meshed garments around a body and lets them come to rest";
  program.usage =
      "--body body.ply garment.obj -o dressed.obj [options]\n"
      "       dress --scene outfit.json -o outfit.obj [options]";
  program.options.add_options()("body", value<string>(), "the body, as clean-body writes it")(
      "garment", value<string>(), "the garment, as mesh-pattern writes it")(
      "garment-json", value<string>(), "its panels and seams; default: garment.json beside it")(
      "scene", value<string>(),
      "instead of these: a body and its layers of garments, the innermost first; -o outfit.obj "
      "then gives outfit-NAME.obj for each")(
      "skeleton", value<string>(), "the body's joints; default: body.json beside the body")(
      "gravity", value<string>(),
      "x,y,z in m/s²; default: the scene's, or 0,-9.81,0; write --gravity=-9.81,0,0")(
      "frames", value<string>(), "write the states on the way as OBJ files into this folder")(
      "certify-frames",
      "check every state on the way, as --frames writes them, with exact predicates: when it "
      "became "
      "free of intersections, and whether it stayed so");
  toile::add_fabric_option(program.options);
  toile::add_method_options(program.options);
  program.positional.add("garment", 1);
  program.check = toile::check_usage;
  program.work = toile::work;
  return toile::run_program(argc, argv, program);
}
