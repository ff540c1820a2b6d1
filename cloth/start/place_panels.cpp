#include "cloth/start/place_panels.h"

#include <algorithm>
#include <utility>

#include "cloth/start/hang_from_seams.h"
#include "cloth/start/places_fit.h"
#include "cloth/start/positioning.h"
#include "geometry/error.h"

namespace toile {

namespace {

/// Without a skeleton there is nothing to place panels by.
void check_needs_no_skeleton(const PanelMesh& garment, const AskedPlaces& asked) {
  if (!asked.empty()) {
    throw Error("--place", "needs the body's joints, and there is no skeleton",
                "let clean-body write the joints beside the body");
  }
  if (lacks_places(garment, nullptr)) {
    throw Error("panel '" + garment.panels.front().name + "'",
                "has no place in the pattern, and there is no skeleton that tells one",
                "let clean-body write the body's joints beside it");
  }
}

/// Of a layout whose places do not fit the body: places from its seams, where they tell better.
/// Whether `garment` was placed anew.
bool place_unfit(const TriangleMesh& body, const Skeleton& skeleton, PanelMesh& garment,
                 PlacedPanels& placed) {
  PanelMesh anew = garment;
  std::vector<FoundPlace> places;
  try {
    places = find_places(body, skeleton, {}, anew);
  } catch (const Error&) {
    return false;  // Nothing tells more than the pattern does.
  }
  const std::string unfit = unfit_place(garment, anew, places);
  if (unfit.empty()) return false;
  placed.places = std::move(places);
  placed.reason = "the pattern's places do not fit the body: " + unfit;
  garment = std::move(anew);
  return true;
}

PlacedPanels place_as_worn(const TriangleMesh& body, const Skeleton* skeleton,
                           const AskedPlaces& asked, PanelMesh& garment) {
  PlacedPanels placed;
  if (skeleton == nullptr) {
    check_needs_no_skeleton(garment, asked);
    return placed;
  }
  const bool lacks = lacks_places(garment, skeleton);
  if (!asked.empty() || lacks) {
    placed.places = find_places(body, *skeleton, asked, garment);
    placed.reason = asked.empty() ? "the pattern places no panel on the body"
                                  : "panels are placed as --place asks";
    placed.is_upside_down = std::ranges::any_of(placed.places, &FoundPlace::upside_down);
    return placed;
  }
  placed.moved = locate_layout(garment, *skeleton);
  if (placed.moved) move_layout(*placed.moved, garment);
  if (asks_for_skeleton(garment) || stands_as_drawn(garment)) return placed;
  // What the seams tell takes the place of the layout's move.
  if (place_unfit(body, *skeleton, garment, placed)) placed.moved.reset();
  return placed;
}

}  // namespace

PlacedPanels place_panels(const TriangleMesh& body, const Skeleton* skeleton,
                          const AskedPlaces& asked, PanelMesh& garment) {
  PlacedPanels placed = place_as_worn(body, skeleton, asked, garment);
  hang_from_seams(body, garment);
  return placed;
}

}  // namespace toile
