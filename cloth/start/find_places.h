// Places on the body for a pattern that states none: found from its seams, names and sizes.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "geometry/body/skeleton.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// What is asked of the place of one panel.
struct AskedPlace {
  std::string part;                          ///< one of body_parts; empty: not asked
  PlacementSide side = PlacementSide::none;  ///< none: not asked
  bool around = false;                       ///< rolled around its part
};

/// By the names of panels.
using AskedPlaces = std::map<std::string, AskedPlace>;

/// Reads "front=torso:front". The side is one of front, back, left, right and around; it or the
/// part may be left out. Throws Error, naming `text`, for anything else. Returns the panel's name
/// and what is asked.
std::pair<std::string, AskedPlace> parse_asked_place(const std::string& text);

/// Where a panel was placed.
struct FoundPlace {
  std::string panel;
  std::string part;  ///< one of body_parts
  PlacementSide side = PlacementSide::front;
  bool around = false;  ///< rolled around its part
  bool asked = false;   ///< as asked, not found
};

/// "front", "back", "left" or "right".
std::string side_name(PlacementSide side);

/// "front: torso, front"
std::string text_of(const FoundPlace& place);

/// Places all panels, whatever places they have. Sets `garment.placed`, and the `placement` of
/// panels that are to be rolled around their part.
///
/// - A panel that is sewn to itself across its width goes around its part: an arm, or the torso,
///   or of two that are sewn together each a leg. So does one that is asked to.
/// - All others lie in two sheets (sheet_layout.h), by their names (face_by_name()) or by what fits.
///   The sheets stand before and behind the body. Panels named as hoods stand at the head's sides.
/// - Without names the front has the deeper neckline, else, below the waist, the smaller area.
/// - A piece with seams over the shoulders stands with these on the body's shoulders. A strapless
///   top reaches the armpits. Anything else has its upper border where the body is as wide, between
///   waist and hips.
///
/// Throws Error, naming a panel, where the skeleton lacks joints, where panels are not sewn to
/// others, and for asked panels that are not there. `body` has the skeleton's joints.
std::vector<FoundPlace> find_places(const TriangleMesh& body, const Skeleton& skeleton,
                                    const AskedPlaces& asked, PanelMesh& garment);

}  // namespace toile
