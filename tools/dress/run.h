// What dress does once it knows what is asked: reads, dresses layer by layer, writes and judges.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cloth/scene/scene.h"
#include "tools/dress/fabrics.h"
#include "tools/dress/method.h"
#include "tools/program.h"

namespace toile {

/// One garment that is to be dressed.
struct OutfitLayer {
  std::string name;  ///< empty: the only one, not of a scene file
  std::filesystem::path garment;
  std::filesystem::path garment_json;
  Fabric fabric;
  std::filesystem::path output;
  /// See SceneLayer.
  std::map<std::string, std::vector<std::string>> panels_over = {};
};

struct OutfitSettings {
  std::optional<std::filesystem::path> scene;
  std::filesystem::path body;
  std::filesystem::path skeleton;
  bool needs_skeleton = false;  ///< it was asked for, not looked for
  std::vector<OutfitLayer> layers;
  bool coupled = false;  ///< the layers move together once all are dressed
  FabricChoice fabrics;
  std::optional<std::filesystem::path> frames;
  bool certify_frames = false;
  /// Where the body's distances are kept from run to run; none: they are not.
  std::optional<std::filesystem::path> cache;
  std::optional<double> strain_limit;
  std::optional<double> shear_limit;
  Vec3 gravity = Scene().gravity;
  DressMethod method;
};

/// Dresses all layers, writes their files and the report, and gives the exit code. Throws Error for
/// what can't be read or dressed.
int dress_outfit(const OutfitSettings& settings, const CommonSettings& common);

}  // namespace toile
