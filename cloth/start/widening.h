// Panels widened across what they go around, so that they can be sewn around it.
#pragma once

#include <array>
#include <vector>

#include "geometry/body/skeleton.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// A panel that is wider while its seams close. A point moves along `across`, by `factor - 1` times
/// its distance from `middle` in that direction.
struct WidePanel {
  Vec3 across = Vec3::Zero();  ///< unit vector in the panel, square to the bones it goes around
  Vec3 middle = Vec3::Zero();  ///< metres, what stays
  double factor = 1;
  std::array<bool, 2> held = {false, false};  ///< a seam on this side of it, against `across` first

  Vec3 moved(const Vec3& p) const { return p + (factor - 1) * across.dot(p - middle) * across; }
};

/// Widens panels by `factor` times what they were widened before. `panels`: empty, or as from an
/// earlier call. `placed`: metres, per material point, where they start, not widened. `held`: per
/// material point, not 0 where its seam was held apart, or where its panel crosses the body. A seam
/// counts that runs along the bones, between a panel before and one behind them. Rolled panels
/// stay. Returns whether any panel was widened. Linear.
bool widen(const PanelMesh& garment, const std::vector<Vec3>& placed, const Skeleton& skeleton,
           const std::vector<char>& held, double factor, std::vector<WidePanel>& panels);

}  // namespace toile
