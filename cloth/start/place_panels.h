// Brings a garment's panels to where the body is, whatever its pattern says of their places.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cloth/start/find_places.h"
#include "cloth/start/locate_layout.h"

namespace toile {

/// What was moved, and why. Panels that stood in their places need neither.
struct PlacedPanels {
  std::optional<LayoutMove> moved;  ///< of all panels as one piece
  std::vector<FoundPlace> places;   ///< of each panel, where it was found; empty: they were not
  std::string reason;               ///< why places were found, in words
  bool is_upside_down = false;      ///< their drawing looks so, see WornLayout::is_upside_down()
};

/// Places the panels of `garment`. Panels without places, or that are `asked` for, get them from
/// the seams (find_places.h). A layout that is not where the body is moves there as one piece
/// (locate_layout.h). If its places do not fit the body even so (places_fit.h), the panels get them
/// from the seams, and the layout's move is forgotten. Panels that the skeleton positions keep
/// their places. `body` is the skeleton's. Without a skeleton (null) the panels stay. Then Error is
/// thrown for panels without places and for asked ones. Otherwise it is thrown as find_places()
/// does. At last, the panels of a skirt hang from their seams (hang_from_seams.h).
PlacedPanels place_panels(const TriangleMesh& body, const Skeleton* skeleton,
                          const AskedPlaces& asked, PanelMesh& garment);

}  // namespace toile
