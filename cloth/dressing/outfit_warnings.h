// Warnings about the garments of an outfit, for people and scripts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cloth/dressing/dress.h"
#include "cloth/judge/verdict.h"
#include "cloth/start/locate_layout.h"
#include "io/warning.h"

namespace toile {

/// All panels of `garment`, which stands as its pattern says, were moved as one piece.
Warning moved_layout_warning(const LayoutMove& move, const PanelMesh& garment);

/// The panels were placed by their seams, and their drawing looks upside down.
Warning upside_down_drawing_warning();

/// A line for each panel whose name, label and stated part contradict each other, with what was
/// decided (classify.h). What the user asks for beats them all.
std::vector<Warning> contradiction_warnings(const PanelMesh& garment);

/// Of panels that seem to be placed wrongly (placement_warnings.h), and of fabrics that count as
/// less stiff than they are. Costs placement_warnings().
std::vector<Warning> start_warnings(const PanelMesh& garment, const Scene& scene);

/// The garment could not go on from an earlier drape, as `refusal` says.
Warning refused_drape_warning(const std::string& refusal);

/// The garment went on from an earlier drape, and is not sewn.
Warning continued_drape_warning();

/// Where a garment that did not come to rest is pulled the hardest. None: that is not known.
std::optional<Warning> hardest_pulled_warning(const PanelMesh& garment, const DressResult& result);

/// Panels of `layer` were turned out over the layer `over`, and now it has this verdict.
Warning turned_out_warning(const std::string& layer, Verdict verdict, const std::string& over);

/// A layer with this verdict carries no layers over it.
Warning last_layer_warning(const std::string& layer, Verdict verdict);

}  // namespace toile
