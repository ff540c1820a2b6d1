#include "cloth/scene/scene_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

#include "cloth/scene/fabric.h"
#include "cloth/scene/scene.h"
#include "geometry/error.h"
#include "io/json_value.h"
#include "io/json_words.h"
#include "io/output_file.h"
#include "io/text.h"

namespace toile {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_name_length = 64;  // bytes
constexpr std::size_t max_layers = 100;
constexpr std::size_t max_panels = 1000;

/// The path that `value` states, relative to `folder`. Throws Error when the file is not there.
fs::path file_named(const JsonValue& value, const fs::path& folder) {
  const std::string text = value.text();
  if (text.empty()) value.fail("is empty", "name a file");
  const fs::path path = (folder / text).lexically_normal();
  std::error_code unreachable;
  if (!fs::is_regular_file(path, unreachable)) {
    value.fail(in_quotes(path.string()) + " is no file", "paths count from the scene file");
  }
  return path;
}

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string layer_name(const JsonValue& value) {
  const std::string name = value.text();
  const auto is_bad = [](unsigned char c) {
    return c < 0x20 || c == 0x7f ||
           std::string_view("/\\:*?\"<>|").find(static_cast<char>(c)) != std::string_view::npos;
  };
  if (name.empty() || name.size() > max_name_length) {
    value.fail("is not 1 to " + std::to_string(max_name_length) + " bytes long",
               "the name becomes part of a file's name");
  }
  if (std::any_of(name.begin(), name.end(), is_bad) || valid_utf8(name) != name ||
      name.front() == '.' || name.front() == ' ' || name.back() == '.' || name.back() == ' ') {
    value.fail(in_quotes(name) + " can't be part of a file's name", "use letters, digits, - and _");
  }
  return name;
}

SceneLayer layer_of(const JsonValue& value, const fs::path& folder) {
  refuse_other_keys(value, std::array<std::string_view, 5>{"name", "garment", "garment_json",
                                                           "fabric", "panels_over"});
  SceneLayer layer;
  layer.name = layer_name(value.get("name"));
  layer.garment = file_named(value.get("garment"), folder);
  if (const auto json = value.find("garment_json")) layer.garment_json = file_named(*json, folder);
  if (const auto fabric = value.find("fabric")) {
    const std::string text = fabric->text();
    const std::vector<std::string> known = fabric_names();
    const bool is_name = std::find(known.begin(), known.end(), text) != known.end();
    layer.fabric = is_name ? text : file_named(*fabric, folder).string();
  }
  if (const auto over = value.find("panels_over")) {
    for (const std::string& other : over->keys()) {
      const JsonValue panels = over->get(other);
      const std::size_t count = panels.size(1, max_panels);
      for (std::size_t i = 0; i < count; ++i) {
        layer.panels_over[other].push_back(panels.item(i).text());
      }
    }
  }
  return layer;
}

/// Throws Error unless `panels_over` names later layers of a coupled scene. Panels lie over
/// garments that are dressed later, and come to rest together with them.
void check_panels_over(const JsonValue& layers, const SceneFile& scene) {
  for (std::size_t i = 0; i < scene.layers.size(); ++i) {
    for (const auto& [other, panels] : scene.layers[i].panels_over) {
      const JsonValue over = layers.item(i).get("panels_over");
      const auto later = std::find_if(
          scene.layers.begin() + static_cast<std::ptrdiff_t>(i) + 1, scene.layers.end(),
          [&name = other](const SceneLayer& layer) { return layer.name == name; });
      if (later == scene.layers.end()) {
        over.get(other).fail("belongs to no later layer",
                             "name a layer that is dressed over this one");
      }
      if (!scene.coupled) {
        over.fail("needs layers that move together", "add \"layering\": \"coupled\"");
      }
    }
  }
}

}  // namespace

SceneFile read_scene(const fs::path& path) {
  const JsonDocument document(read_file(path), path.string());
  const JsonValue root = document.root();
  const fs::path folder = path.parent_path();
  refuse_other_keys(
      root, std::array<std::string_view, 5>{"body", "skeleton", "gravity", "layering", "layers"});
  SceneFile scene;
  scene.body = file_named(root.get("body"), folder);
  if (const auto skeleton = root.find("skeleton")) scene.skeleton = file_named(*skeleton, folder);
  if (const auto gravity = root.find("gravity")) {
    gravity->size(3, 3);
    scene.gravity.emplace(gravity->item(0).number(), gravity->item(1).number(),
                          gravity->item(2).number());
    check_gravity(*scene.gravity, gravity->place());
  }
  if (const auto layering = root.find("layering")) {
    scene.coupled = layering->text() == "coupled";
    if (!scene.coupled && layering->text() != "frozen") {
      layering->fail(in_quotes(layering->text()) + " is neither 'frozen' nor 'coupled'",
                     "leave it out for frozen");
    }
  }
  const JsonValue layers = root.get("layers");
  const std::size_t count = layers.size(1, max_layers);
  std::set<std::string> names;
  for (std::size_t i = 0; i < count; ++i) {
    const JsonValue item = layers.item(i);
    scene.layers.push_back(layer_of(item, folder));
    const std::string& name = scene.layers.back().name;
    if (!names.insert(lower_case(name)).second) {
      item.get("name").fail("'" + name + "' is the name of an earlier layer",
                            "give each layer a name of its own, capitals aside");
    }
  }
  check_panels_over(layers, scene);
  return scene;
}

}  // namespace toile
