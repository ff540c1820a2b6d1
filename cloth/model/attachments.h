// What holds points of a garment while it is dressed, or for good: springs to places.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "cloth/scene/scene.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// A material point that something holds, d off its anchor: E = ½ stiffness |d|² until the pull
/// would be larger than `most`, from where on that is all it pulls with. Held at a level, d is what
/// is missing along the axis alone.
struct AttachedPoint {
  int point;
  int attachment;    ///< of the garment's, by index
  Vec3 anchor;       ///< metres
  Vec3 axis;         ///< of unit length; zero: held in every direction
  double stiffness;  ///< N/m
  double max_pull;   ///< N
  bool always;       ///< for good; else while it is dressed
};

/// Metres from the point at `p` to where it is held.
inline Vec3 displacement_to_anchor(const AttachedPoint& attached, const Vec3& p) {
  const Vec3 displacement = attached.anchor - p;
  return attached.axis.isZero() ? displacement
                                : Vec3(attached.axis.dot(displacement) * attached.axis);
}

/// The force (N) on the point at `p`.
inline Vec3 attachment_pull(const AttachedPoint& attached, const Vec3& p) {
  const Vec3 displacement = displacement_to_anchor(attached, p);
  const double distance = displacement.norm();
  if (attached.stiffness * distance <= attached.max_pull) return attached.stiffness * displacement;
  return attached.max_pull / distance * displacement;
}

/// All attached points, in the order of the garment's attachments, with panels placed at `placed`
/// (metres, per material point). A level of torso or head is horizontal, one of a limb square to
/// its bones. A place that is nearer to the scene's body than `body_offset` metres is moved out to
/// there. Throws Error, naming the attachment, when the scene lacks what it is held at. Cost is
/// that of the points; 50 slices of the body where a girth is named.
std::vector<AttachedPoint> attached_points(const PanelMesh& garment, const Scene& scene,
                                           const std::vector<Vec3>& placed, double body_offset);

/// Those that hold for good.
std::vector<AttachedPoint> lasting(std::vector<AttachedPoint> attachments);

/// An attachment as it is measured.
struct AttachmentFigures {
  std::string name;
  std::string to;  ///< the landmark, "place", "skin" or "point"
  bool always = false;
  double off_mean = 0;       ///< metres off what holds it
  double off_max = 0;        ///< likewise
  Vec3 pull = Vec3::Zero();  ///< N: its force on the cloth
};

/// One for each of the garment's attachments, as they hold material points at `points`.
std::vector<AttachmentFigures> measure_attachments(const PanelMesh& garment,
                                                   const std::vector<AttachedPoint>& attachments,
                                                   const std::vector<Vec3>& points);

/// Measures those anew that hold for good.
void measure_lasting(const PanelMesh& garment, const std::vector<AttachedPoint>& attachments,
                     const std::vector<Vec3>& points, std::vector<AttachmentFigures>& figures);

}  // namespace toile
