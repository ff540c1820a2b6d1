#include "tools/dress/settings.h"

#include <algorithm>
#include <iterator>
#include <sstream>

#include "cloth/scene/scene_file.h"
#include "geometry/error.h"
#include "io/skeleton_file.h"
#include "pattern/file/garment_file.h"
#include "tools/dress/kept_distances.h"

namespace toile {

namespace {

namespace po = boost::program_options;
namespace fs = std::filesystem;

/// The garment or the scene that the command line names, with the files to write for it.
void read_layers(const po::variables_map& given, const fs::path& output, DressSettings& settings) {
  settings.fabrics = read_fabrics(given);
  const std::string& fabric = settings.fabrics.of_garments;
  if (given.count("scene") == 0) {
    LayerFiles only;
    only.garment = given["garment"].as<std::string>();
    if (given.count("garment-json")) only.garment_json = given["garment-json"].as<std::string>();
    only.fabric = find_fabric(fabric);
    only.output = output;
    only.places = read_places(given);
    if (given.count("continue")) only.earlier = given["continue"].as<std::string>();
    settings.body = given["body"].as<std::string>();
    settings.layers.push_back(only);
  } else {
    settings.scene = given["scene"].as<std::string>();
    const SceneFile scene = read_scene(*settings.scene);
    settings.body = scene.body;
    settings.coupled = scene.coupled;
    if (scene.gravity) settings.gravity = *scene.gravity;
    settings.skeleton = scene.skeleton.value_or(skeleton_beside(scene.body));
    settings.needs_skeleton = scene.skeleton.has_value();
    for (const SceneLayer& layer : scene.layers) {
      const std::string file = output.stem().string() + "-" + layer.name + ".obj";
      if (!layer.fabric.empty()) settings.fabrics.files.emplace_back(layer.fabric);
      settings.layers.push_back({layer.name, layer.garment, layer.garment_json,
                                 find_fabric(layer.fabric.empty() ? fabric : layer.fabric),
                                 output.parent_path() / file, layer.panels_over});
    }
  }
  if (given.count("skeleton")) {
    settings.skeleton = given["skeleton"].as<std::string>();
    settings.needs_skeleton = true;
  } else if (settings.skeleton.empty()) {
    settings.skeleton = skeleton_beside(settings.body);
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
      throw UsageError("--gravity", "'" + text + "' is not three numbers",
                       "write --gravity=X,Y,Z in m/s²: 0,-9.81,0 is the default");
    }
  }
  if (words >> comma) {
    throw UsageError("--gravity", "'" + text + "' goes on after three numbers",
                     "write --gravity=X,Y,Z in m/s²: 0,-9.81,0 is the default");
  }
  try {
    check_gravity(gravity, "--gravity");
  } catch (const Error& wrong) {
    throw UsageError(wrong);
  }
  return gravity;
}

}  // namespace

AskedPlaces read_places(const po::variables_map& given) {
  AskedPlaces places;
  if (given.count("place") == 0) return places;
  for (const std::string& text : given["place"].as<std::vector<std::string>>()) {
    const auto asked = parse_asked_place(text);
    if (!places.insert(asked).second) {
      throw UsageError("--place '" + text + "'",
                       "is the second place for panel '" + asked.first + "'",
                       "say one place for each panel");
    }
  }
  return places;
}

void add_dress_options(po::options_description& options, const Quality& usual) {
  using po::value;
  using std::string;
  options.add_options()("body", value<string>(), "the body, as clean-body writes it")(
      "garment", value<string>(), "the garment, as mesh-pattern writes it")(
      "garment-json", value<string>(),
      "its panels and seams; default: garment.garment.json beside it")(
      "scene", value<string>(),
      "instead of these: a body and its layers of garments, the innermost first; -o outfit.obj "
      "then gives outfit-NAME.obj for each")(
      "skeleton", value<string>(), "the body's joints; default: body.body.json beside the body")(
      "continue", value<string>(),
      "an earlier dressed.obj of this garment, before its pattern was changed a little: go on from "
      "there, and not from flat panels")(
      "frames", value<string>(), "write the states on the way as OBJ files into this folder")(
      "certify-frames",
      "check every state on the way, as --frames writes them, with exact predicates: when it "
      "became "
      "free of intersections, and whether it stayed so")(
      "cache",
      "keep the body's distances beside it, body.distances for body.ply: later garments on this "
      "body are dressed the same, sooner");
  add_drape_options(options, usual);
}

void add_drape_options(po::options_description& options, const Quality& usual) {
  using po::value;
  using std::string;
  options.add_options()(
      "from", value<string>(),
      "the body as it stood before pose-body: the garment is put on there, and goes with the body "
      "into its pose; its joints are beside it")(
      "place", value<std::vector<string>>()->composing(),
      "PANEL=PART:SIDE, as in front=torso:front or sleeve=left_arm:around: where a panel stands; "
      "all others are found anew, whatever places the pattern states; may be repeated")(
      "gravity", value<string>(),
      "x,y,z in m/s²; default: the scene's, or 0,-9.81,0; write --gravity=-9.81,0,0");
  options.add_options()(
      "no-floor",
      "let cloth hang through the floor that the body stands on; the paper's method has no floor");
  add_fabric_option(options);
  add_method_options(options, usual);
}

void check_dress_options(const po::variables_map& given) {
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
  if (has_scene && given.count("place") != 0) {
    throw po::error("--place is for one garment: dress the garments of a scene without it");
  }
  if (has_scene && given.count("continue") != 0) {
    throw po::error("--continue is for one garment: dress the garments of a scene without it");
  }
  if (given.count("continue") != 0 && given.count("place") != 0) {
    throw po::error(
        "--place says where panels start, and --continue goes on from a drape: give one");
  }
  if (has_scene && given.count("from") != 0) {
    throw po::error("--from is for one garment: dress the garments of a scene without it");
  }
  if (given.count("certify-frames") != 0 && given.count("from") != 0) {
    throw po::error("--certify-frames checks against a body that does not move: leave out --from");
  }
  if (given.count("continue") != 0 && given.count("from") != 0) {
    throw po::error(
        "--from puts the garment on anew, and --continue goes on from a drape: give one");
  }
  if (given.count("continue") != 0 && given["method"].as<std::string>() == "paper") {
    throw po::error("--continue: the paper's method starts from flat panels only");
  }
  check_method_options(given);
}

DressSettings read_dress_settings(const po::variables_map& given, const fs::path& output) {
  DressSettings settings;
  read_layers(given, output, settings);
  if (given.count("frames")) settings.frames = given["frames"].as<std::string>();
  if (given.count("cache")) settings.cache = distances_path(settings.body);
  settings.certify_frames = given.count("certify-frames") != 0;
  read_drape_settings(given, settings);
  return settings;
}

void read_drape_settings(const po::variables_map& given, DressSettings& settings) {
  if (given.count("from") != 0) {
    if (given["method"].as<std::string>() == "paper") {
      throw UsageError("--from", "asks the paper's method to dress a body that moves",
                       "leave out --method paper, or --from");
    }
    settings.standing = given["from"].as<std::string>();
    settings.needs_skeleton = true;
  }
  settings.has_floor = given.count("no-floor") == 0;
  if (given.count("gravity")) settings.gravity = parse_gravity(given["gravity"].as<std::string>());
  settings.strain_limit = read_strain_limit(given);
  settings.shear_limit = read_shear_limit(given);
  settings.method = read_method(given, settings.coupled);
}

ProgramFiles files_of(const DressSettings& settings) {
  ProgramFiles files;
  files.reads = settings.fabrics.files;
  files.reads.push_back(settings.body);
  files.reads.push_back(settings.skeleton);
  if (settings.scene) files.reads.push_back(*settings.scene);
  std::vector<fs::path> bodies = {settings.body};
  if (settings.standing) {
    bodies.push_back(*settings.standing);
    files.reads.push_back(*settings.standing);
    files.reads.push_back(skeleton_beside(*settings.standing));
  }
  for (const fs::path& body : bodies) {
    if (settings.cache) std::ranges::copy(kept_distances_of(body), std::back_inserter(files.keeps));
  }
  for (const LayerFiles& layer : settings.layers) {
    files.reads.push_back(layer.garment);
    files.reads.push_back(layer.garment_json.empty() ? garment_json_beside(layer.garment)
                                                     : layer.garment_json);
    if (layer.earlier) files.reads.push_back(*layer.earlier);
    files.writes.push_back(layer.output);
    if (settings.frames && settings.scene) files.folders.push_back(*settings.frames / layer.name);
  }
  if (settings.frames) files.folders.push_back(*settings.frames);
  if (settings.frames && settings.coupled) files.folders.push_back(*settings.frames / "coupled");
  return files;
}

}  // namespace toile
