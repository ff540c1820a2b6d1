// A state of a garment while it is dressed, for observers.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "geometry/types.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// A state of a dressing. It is reported when the panels are placed, every 200 steps, and at the
/// end of each stage.
struct DressFrame {
  const PanelMesh& mesh;  ///< may be coarser than the garment
  const std::string& stage;
  const std::vector<Vec3>& points;  ///< metres, per material point of `mesh`
  double progress;                  ///< roughly, of the whole dressing, from 0 to 1
  double seconds = 0;               ///< of simulated time so far; 0 for a method without time
};
using FrameWatcher = std::function<void(const DressFrame&)>;

}  // namespace toile
