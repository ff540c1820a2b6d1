// Warnings of panels whose placement looks wrong, though the garment can be dressed.
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

/// Warns of panels by where `garment.placed` puts them; names play no part.
///
/// - Other side: panels that are joined among each other on one side of the body's middle. Most of
///   their seams reach across it. With the panels mirrored, the seams would be 35 % and 15 cm
///   shorter at least. Of two such groups that are sewn together, the smaller one is named.
/// - Swapped: panels that are sewn to their mirror images, as two legs are. Their seams would be as
///   much shorter if the two changed places. Other panels that are sewn to them are judged as if
///   they had.
/// - Inside out: a panel whose right side faces the nearest skin, by facing_out() below -0.5.
///
/// They come in the garment's order, swapped ones first, then other sides. Without a collider
/// nothing is inside out; without a skeleton the middle is x = 0. Cost: some 50 queries of the skin
/// a panel.
std::vector<PlacementWarning> placement_warnings(const PanelMesh& garment, const Scene& scene);

/// Per panel, the mean cosine between its right side and the direction out of the skin, over its
/// area. It is 1 when all of the right side faces out.
std::vector<double> facing_out(const PanelMesh& garment, const SurfaceDistance& skin);

/// The word that scripts go by: "swapped", "other_side" or "inside_out".
std::string code_of(PlacementWarning::Kind kind);

/// The warning and its remedy, in a line.
std::string text_of(const PlacementWarning& warning);

}  // namespace toile
