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
  double lean = 0;          ///< radians to the front, of what is rolled around the neck
};

struct Positioning {
  std::vector<Vec3> placed;             ///< metres, per material point of the garment
  std::vector<PositionedPanel> panels;  ///< those that were positioned, in the garment's order
};

/// Whether any panel of the garment is to be positioned by the skeleton.
bool asks_for_skeleton(const PanelMesh& garment);

/// The frame of a body part whose bones run along the unit vector `up`, to the neck, the shoulder
/// or the hip. Its columns are the part's left, up and front. The shortest turn that takes y to
/// `up` makes them of x, y and z. A part upside down is turned by half a turn about z.
Eigen::Matrix3d part_frame(const Vec3& up);

/// Positions every panel whose placement asks for it; the others stay where they are `placed`. An
/// affine transform takes the flat panel to the body [Zhong & Xu 2009, fig. 1].
///
/// - The panel's main axis is the one of its bounding box that the pattern names. It is laid along
///   the bones, in their mean direction where there are several.
/// - A flat panel stands square to its side of the part, its right side out. It stands as near to
///   the bones as keeps every point the offset from the skin.
/// - A panel that goes around the part is rolled about that line (rolling.h). It takes the least
///   radius on which it covers no more than its share and keeps the offset. What it then lacks is
///   its gap. If no radius within 30 cm keeps the offset, the one with the fewest points too near
///   is taken.
/// - Where bends of the part obstruct a straight line, as an elbow does, the panel is rolled about
///   the bones as they bend. That must spare 2 cm of gap and draw.
/// - What is rolled at the neck leans to the front by up to 30 degrees. It may if fewer of its
///   points are too near then, or its gap is less.
/// - A sleeve whose pattern names no joint is drawn down its arm by up to 20 cm, if that brings
///   it nearer to the arm. The armpit obstructs it. Panels of one arm are drawn alike.
/// - Panels of a leg stay on its side of the plane between both legs. Rolled ones keep clear by
///   their radius, flat ones move sideways.
/// - A panel that names no joint lies level with panels of its part that it is sewn to, by the mean
///   of its seam points. Others come first that are sewn to another part. The first one's upper end
///   is level with the neck, the head's top, the
///   shoulder, or on a leg the waist.
///
/// Uses the flat coordinates only, so positioning twice is positioning once. Throws Error, naming
/// the panel, when the skeleton, its part or its joint is missing. Throws it too when no distance
/// up to 1.5 m clears the body. Linear in the points, times some hundred distances tried.
Positioning position_panels(const PanelMesh& garment, const DistanceGrid& body,
                            const Skeleton* skeleton);

}  // namespace toile
