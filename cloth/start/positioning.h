// Initial positioning: panels beside or around the bones that their pattern names.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "geometry/body/skeleton.h"
#include "geometry/distance_grid.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// How a panel was positioned.
struct PositionedPanel {
  std::string panel;
  bool rolled = false;
  bool bent = false;        ///< rolled about the bones as they bend
  double distance = 0;      ///< metres from the bones to the flat panel; a rolled one's radius
  double gap = 0;           ///< metres missing to the share of the tube that a rolled panel covers
  double drawn_out = 0;     ///< metres that a sleeve was drawn down the arm to clear the body
  int points_too_near = 0;  ///< nearer to the skin than asked, where nothing helped
};

struct Positioning {
  std::vector<Vec3> placed;             ///< metres, per material point of the garment
  std::vector<PositionedPanel> panels;  ///< those that were positioned, in the garment's order
};

/// Least distance from the skin where the pattern does not state it, metres. Kept as the grid tells
/// distances: exactly within its segment, to a centimetre or so beyond.
inline constexpr double flat_offset = 0.04;
inline constexpr double rolled_offset = 0.005;

/// Whether any panel of the garment is to be positioned by the skeleton.
bool asks_for_skeleton(const PanelMesh& garment);

/// The directions of a body part whose bones run `up` (a unit vector: to the neck, the shoulder or
/// the hip), in columns: its left, up, and its front. It is what an upright part's (x, y, z) become
/// by the shortest turn that takes y to `up`; of a part upside down, by half a turn about z.
Eigen::Matrix3d part_frame(const Vec3& up);

/// Positions every panel whose placement asks for it; the others stay where they are `placed`.
/// Affine transform of the flat panel [Zhong & Xu 2009, fig. 1]: the panel's main axis, that of its
/// bounding box which the pattern names, is laid along the bones in front of the panel, along their
/// mean orientation where they are several. A flat panel stands square to its side of the part, as
/// near to the bones as keeps every point the offset from the skin, its right side out. A panel
/// that goes around the part is rolled about that line (rolling.h), on the least radius on which it
/// covers no more than its share and keeps the offset; what it then lacks is its gap. Where bends
/// of the part, as an elbow's, are in the way of a straight line, it is rolled about the bones as
/// they bend, if that spares 2 cm of gap and way along them. A sleeve that the pattern puts at no
/// joint is drawn down its arm, by up to 20 cm, where that brings it nearer to the arm: the armpit
/// is in its way. Panels of one arm are drawn out alike. If no radius within 30 cm keeps the
/// offset, the one with fewest points too near is taken.
///
/// Panels of a leg stay on its side of the plane between both legs: rolled ones by their radius,
/// flat ones by being moved sideways.
///
/// A panel that names no joint lies level with panels of its part that it is sewn to, in the mean
/// of its seam points; the first one has its upper end level with the neck, the head's top, the
/// shoulder, or on a leg the waist.
///
/// Uses the flat coordinates only, so positioning twice is positioning once. Throws Error, naming
/// the panel, when there is no skeleton, or none of the part or joint, or when no distance up to
/// 1.5 m clears the body. Linear in the points times some hundred distances tried.
Positioning position_panels(const PanelMesh& garment, const DistanceGrid& body,
                            const Skeleton* skeleton);

}  // namespace toile
