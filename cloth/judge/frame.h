// A state of a garment on its way to rest, for whoever watches.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "geometry/types.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// A state on the way: places of the material points of `mesh`, which may be coarser than the
/// garment. Called where the panels are placed, every 200 steps and at the end of each stage.
struct DressFrame {
  const PanelMesh& mesh;
  const std::string& stage;
  const std::vector<Vec3>& points;
  double progress;     ///< of the whole dressing, 0 to 1, roughly
  double seconds = 0;  ///< of the cloth's own time so far; 0 for a method that has none
};
using FrameWatcher = std::function<void(const DressFrame&)>;

}  // namespace toile
