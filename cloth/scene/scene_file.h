// A scene on disk: a body and the garments that it puts on, one after another.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// One garment of a scene.
struct SceneLayer {
  std::string name;                    ///< can be part of a file's name
  std::filesystem::path garment;       ///< as mesh-pattern writes it
  std::filesystem::path garment_json;  ///< empty: beside the garment
  std::string fabric;                  ///< a fabric's name or a file; empty: not stated
  /// Panels of this garment that lie over later layers. Keys are names of later layers, values
  /// names of this garment's panels; `*` stands for any letters.
  std::map<std::string, std::vector<std::string>> panels_over;
};

/// A scene as read from its file.
struct SceneFile {
  std::filesystem::path body;
  std::optional<std::filesystem::path> skeleton;  ///< none: beside the body
  std::optional<Vec3> gravity;                    ///< m/s²; none: the default
  bool coupled = false;                           ///< "layering": the layers move together
  std::vector<SceneLayer> layers;                 ///< at least one, the innermost first
};

/// Reads {"body", "skeleton", "gravity": [x, y, z], "layering", "layers": [{"name", "garment",
/// "garment_json", "fabric", "panels_over"}]}, as docs/scene.schema.json states it. Relative paths
/// count from the folder of the scene file.
///
/// Throws Error, naming the file and the key, for unknown keys, missing files, and a scene without
/// layers. Throws it for layer names that are equal but for capitals, or cannot be part of a file's
/// name.
SceneFile read_scene(const std::filesystem::path& path);

}  // namespace toile
