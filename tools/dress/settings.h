// What dress is asked for: garments and their files, fabrics, method.
#pragma once

#include <boost/program_options.hpp>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cloth/scene/scene.h"
#include "cloth/start/find_places.h"
#include "tools/dress/fabrics.h"
#include "tools/dress/method.h"
#include "tools/program_files.h"

namespace toile {

/// One garment that is to be dressed.
struct LayerFiles {
  std::string name;  ///< empty: the only one, not of a scene file
  std::filesystem::path garment;
  std::filesystem::path garment_json;  ///< empty: beside the garment
  Fabric fabric;
  std::filesystem::path output;
  /// See OutfitLayer.
  std::map<std::string, std::vector<std::string>> panels_over = {};
  AskedPlaces places = {};  ///< see OutfitLayer
  /// A drape that dress wrote before, to go on from; none: from flat panels.
  std::optional<std::filesystem::path> earlier = {};
};

struct DressSettings {
  std::optional<std::filesystem::path> scene;
  std::filesystem::path body;
  std::filesystem::path skeleton;
  /// The body as it stood before it came into its pose, its joints beside it; none: the garment is
  /// put on as the body is.
  std::optional<std::filesystem::path> standing;
  bool needs_skeleton = false;  ///< it was asked for, not looked for
  std::vector<LayerFiles> layers;
  bool coupled = false;  ///< the layers move together once all are dressed
  FabricChoice fabrics;
  std::optional<std::filesystem::path> frames;
  bool certify_frames = false;
  /// Where the body's distances are kept from run to run (KeptDistances); none: they are not.
  std::optional<std::filesystem::path> cache;
  std::optional<double> strain_limit;
  std::optional<double> shear_limit;
  Vec3 gravity = Scene().gravity;
  bool has_floor = true;
  std::vector<Warning> earlier_warnings;  ///< of body and garment, said already
  DressMethod method;
};

/// `usual` is the quality of who asks for none.
void add_dress_options(boost::program_options::options_description& options,
                       const Quality& usual = standard_quality);

/// Those of them that are of the drape itself, and of no file but fabrics'.
void add_drape_options(boost::program_options::options_description& options, const Quality& usual);
/// The standing body, gravity, limits and the method. `settings` says whether layers are coupled.
/// Throws UsageError for a value that an option can't take.
void read_drape_settings(const boost::program_options::variables_map& given,
                         DressSettings& settings);
/// What --place asks for. Throws UsageError for a panel with two places.
AskedPlaces read_places(const boost::program_options::variables_map& given);

/// Throws boost::program_options::error unless the options are of a garment on a body or of a
/// scene, and of the method.
void check_dress_options(const boost::program_options::variables_map& given);

/// The settings of one garment, written to `output`, or of a scene, whose layers' files are named
/// after `output`. Throws Error for values that can't be used and scenes that can't be read.
DressSettings read_dress_settings(const boost::program_options::variables_map& given,
                                  const std::filesystem::path& output);

/// All files that dress reads and writes, but for the report.
ProgramFiles files_of(const DressSettings& settings);

}  // namespace toile
