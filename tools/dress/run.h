// What dress does once it knows what is asked: reads, dresses, writes and says.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "cloth/dressing/outfit.h"
#include "geometry/body/skeleton.h"
#include "geometry/types.h"
#include "pattern/panel_mesh.h"
#include "tools/dress/settings.h"
#include "tools/program.h"

namespace toile {

/// What became of all layers.
struct DressEnd {
  Verdict verdict;           ///< of the first layer that is not sewn, else sewn
  bool is_certified = true;  ///< false: it was to be certified, and is not
};

/// Dresses all layers, and writes their files and the report. Throws Error for what can't be read,
/// dressed or written.
DressEnd run_dress(const DressSettings& settings, const CommonSettings& common);

/// What one garment is dressed from where it does not lie in files.
struct DressValues {
  TriangleMesh body;
  std::optional<Skeleton> skeleton;  ///< none: see dress_outfit()
  PanelMesh garment;
  std::optional<DressedGarment> earlier = {};  ///< a drape to go on from; none: from flat panels
};

/// A drape as its file would hold it, and its report.
struct DressedValues {
  DressedGarment drape;
  std::vector<Vec3> started;  ///< metres, per material point: where the panels were put at first
  nlohmann::ordered_json report;
  DressEnd end;
};

/// Dresses one garment as run_dress() does, without a file. `settings` have its layer; their files
/// are names in messages and in the report. Throws Error for what can't be dressed.
DressedValues dress_values(DressValues values, const DressSettings& settings,
                           const CommonSettings& common);

/// exit_done for a sewn garment whose states are certified where that was asked, else
/// exit_negative.
ExitCode exit_code_of(const DressEnd& end);

}  // namespace toile
