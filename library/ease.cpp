#include "toile/ease.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "cloth/ease/ease.h"
#include "io/mesh_file.h"
#include "io/output_file.h"
#include "io/skeleton_file.h"
#include "library/rooms.h"
#include "pattern/file/garment_file.h"
#include "tools/ease_map/run.h"

namespace toile {
inline namespace library {

namespace {

namespace fs = std::filesystem;

/// A folder for the files that ease-map reads and writes. It is gone at the end of the scope.
class PrivateFolder {
 public:
  PrivateFolder() {
    std::string name = (fs::temp_directory_path() / "toile-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
      throw Error(name, "can't be made", "let TMPDIR name a folder that can be written");
    }
    path_ = name;
  }
  ~PrivateFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;

  fs::path at(const std::string& name) const { return path_ / name; }
  /// The text without the folder's name.
  std::string without_name(std::string text) const {
    const std::string name = (path_ / "").string();
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at)) {
      text.erase(at, name.size());
    }
    return text;
  }

 private:
  fs::path path_;
};

}  // namespace

std::string ease(const Drape& drape, const Body& body, const EaseChoices& choices) {
  return guarded([&] {
    const PrivateFolder folder;
    EaseMapSettings settings;
    settings.garment = folder.at("dressed.obj");
    settings.body = folder.at("body.ply");
    settings.meshed = folder.at("garment.obj");
    settings.contact = choices.contact;
    settings.heights = choices.heights;
    if (!choices.target.empty()) settings.targets = read_ease_targets(choices.target);
    write_dressed(settings.garment, drape_in(drape));
    write_garment(*settings.meshed, garment_in(drape.garment));
    if (!drape.report.empty()) write_file(folder.at("dressed.json"), drape.report);
    write_mesh(settings.body, skin_in(body));
    if (!body.joints.empty()) write_file(skeleton_path(settings.body), body.joints);
    CommonSettings common = settings_of("ease-map");
    common.report = folder.at("ease.json");
    try {
      run_ease_map(settings, common);
      return folder.without_name(read_file(*common.report));
    } catch (const Error& error) {
      const std::string text = folder.without_name(error.what());
      const std::size_t colon = std::min(text.find(": "), text.size());
      throw Error(text.substr(0, colon), text.substr(std::min(colon + 2, text.size())), "");
    }
  });
}

std::vector<double> gaps(const Drape& drape, const Body& body) {
  return guarded(
      [&] { return measure_ease(drape_in(drape), SurfaceDistance(skin_in(body))).node_gaps; });
}

}  // namespace library
}  // namespace toile
