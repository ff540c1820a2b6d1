// Springs that hold an edge or a corner of a panel, while it is dressed or for good: plain data.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// The target of an attachment. At a level, which is a height of the body, the cloth may slide
/// around the body part. Otherwise each of its points has a place.
enum class AttachedTo : std::uint8_t {
  level,   ///< a plane at a height of the body part
  place,   ///< where the point is as the panel is placed
  skin,    ///< the place on the skin that is nearest to that
  point,   ///< Attachment::point, the same for all
  side,    ///< as far to the side as the point is placed; it may move up, down and in depth
  height,  ///< as high as the point is placed; it may move level
};

/// A spring between a panel and what holds it. It never pulls harder than `max_pull`: beyond that
/// it gives way.
struct Attachment {
  AttachedTo to = AttachedTo::place;
  std::string landmark;       ///< of a level: a joint of the skeleton, or one of girth_names
  double above = 0;           ///< metres from the landmark to the level, up the body part
  Vec3 point = Vec3::Zero();  ///< metres, of AttachedTo::point
  bool always = false;        ///< for good; else until the garment is sewn and friction holds it
  double stiffness = 5000;    ///< N/m, of the whole attachment; spread evenly along an edge
  double max_pull = 20;       ///< N, of the whole attachment; spread evenly along an edge
  /// Only where the garment ends up where it does not belong without it; then until it is sewn.
  bool only_if_it_slips = false;

  bool operator==(const Attachment&) const = default;
};

/// An attachment of a meshed panel: the points along an edge, or one point.
struct MeshedAttachment {
  std::string name;         ///< "panel.edge", or "panel.vVERTEX"
  std::vector<int> points;  ///< material points of the garment
  Attachment how;
};

}  // namespace toile
