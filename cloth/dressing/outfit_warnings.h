// Warnings about the garments of an outfit, as sentences for people.
#pragma once

#include <string>
#include <vector>

#include "cloth/dressing/dress.h"
#include "cloth/judge/verdict.h"
#include "cloth/start/locate_layout.h"

namespace toile {

/// All panels of `garment`, which stands as its pattern says, were moved as one piece.
std::string moved_layout_warning(const LayoutMove& move, const PanelMesh& garment);

/// Of panels that seem to be placed wrongly (placement_warnings.h), and of fabrics that count as
/// less stiff than they are. Costs placement_warnings().
std::vector<std::string> start_warnings(const PanelMesh& garment, const Scene& scene);

/// The garment could not go on from an earlier drape, as `refusal` says.
std::string refused_drape_warning(const std::string& refusal);

/// The garment went on from an earlier drape, and is not sewn.
std::string continued_drape_warning();

/// Where a garment that did not come to rest is pulled the hardest. Empty: that is not known.
std::string hardest_pulled_warning(const PanelMesh& garment, const DressResult& result);

/// Panels of `layer` were turned out over the layer `over`, and now it has this verdict.
std::string turned_out_warning(const std::string& layer, Verdict verdict, const std::string& over);

/// A layer with this verdict carries no layers over it.
std::string last_layer_warning(const std::string& layer, Verdict verdict);

}  // namespace toile
