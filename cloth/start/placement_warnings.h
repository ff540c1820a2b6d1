// What looks wrong about where a pattern places its panels, though it can be dressed.
#pragma once

#include <string>
#include <vector>

#include "cloth/scene/scene.h"
#include "pattern/panel_mesh.h"

namespace toile {

class SurfaceDistance;

/// A panel that its pattern seems to place wrongly.
struct PlacementWarning {
  enum class Kind {
    swapped,     ///< with its mirror image
    other_side,  ///< of the body from what it is sewn to
    inside_out,  ///< its right side toward the body
  };
  std::string panel;
  Kind kind;
};

/// Looks at the panels where `garment.placed` says; names play no part. On the other side stand
/// panels, joined among each other on one side of the body's middle, most of whose seams reach
/// across it, and would be half as long and shorter by 15 cm at least if the panels stood mirrored;
/// of two such groups that are sewn together the smaller one. Swapped are panels that are sewn to
/// their mirror images, as two legs are, by seams that would be as much shorter if the two changed
/// places; what else is sewn to them is judged as if they had. Inside out is a panel whose right
/// side faces the skin that is nearest to it, by more than half of its area weighed by how
/// squarely. In the garment's order, swapped ones first, then other sides. The scene's `skin`, if
/// any, tells what is inside out; `skeleton`, if any, where the middle is (x = 0). Cost is some 50
/// queries of the skin a panel.
std::vector<PlacementWarning> placement_warnings(const PanelMesh& garment, const Scene& scene);

/// Of each panel, how its right side faces away from the skin: the mean cosine over its area, 1
/// when all of it does.
std::vector<double> facing_out(const PanelMesh& garment, const SurfaceDistance& skin);

/// What is warning and what to do, in a line.
std::string text_of(const PlacementWarning& warning);

}  // namespace toile
