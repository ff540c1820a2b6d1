// What holds an edge or a corner of a panel while it is dressed, or for good: plain data.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// `level`: a height of the body, along which it may slide around the body part; the others: a
/// place for each of its points.
enum class AttachedTo : std::uint8_t {
  level,
  place,  ///< where the panel is placed
  skin,   ///< the place on the skin that is nearest to there
  point,
};

/// A spring between a panel and a place, which gives way where it would pull harder than `most`.
struct Attachment {
  AttachedTo to = AttachedTo::place;
  std::string landmark;  ///< of a level: a joint, or one of girth_names
  double above = 0;      ///< metres that a level lies above that, up the body part
  Vec3 point = Vec3::Zero();
  bool always = false;      ///< for good; else until friction takes over, when all is sewn
  double stiffness = 5000;  ///< N/m, of the whole; spread evenly along an edge
  double max_pull = 20;     ///< N, likewise

  bool operator==(const Attachment&) const = default;
};

/// What is attached of a meshed panel: the points along an edge, or one.
struct MeshedAttachment {
  std::string name;  ///< "panel.edge", or "panel.vVERTEX"
  std::vector<int> points;
  Attachment how;
};

}  // namespace toile
