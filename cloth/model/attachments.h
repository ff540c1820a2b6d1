// Attachments: springs that hold points of a garment, while it is dressed or for good.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "cloth/scene/scene.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// A material point on a spring to its anchor, with E = ½ stiffness |d|². d is the displacement to
/// the anchor, for a level only its part along the axis. Once the pull reaches `max_pull` it stays
/// there.
struct AttachedPoint {
  int point;         ///< index of the material point
  int attachment;    ///< index into PanelMesh::attachments
  Vec3 anchor;       ///< metres
  Vec3 axis;         ///< unit vector of a level; zero: held in every direction
  double stiffness;  ///< N/m
  double max_pull;   ///< N
  bool always;       ///< for good; else while the garment is dressed
};

/// Metres: the displacement from the point at `p` to its anchor.
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

/// All attached points, in the order of the garment's attachments. Those that hold only what slips
/// have none, see hold_what_slips(). `placed` are the places of the
/// panels (metres, one per material point). A level of torso or head is horizontal, one of a limb
/// is square to its bones. An anchor nearer to the scene's body than `body_offset` metres is moved
/// out to that distance.
///
/// Throws Error, naming the attachment, when the scene lacks its target. Linear in the points, plus
/// 50 slices of the body where a girth is named.
std::vector<AttachedPoint> attached_points(const PanelMesh& garment, const Scene& scene,
                                           const std::vector<Vec3>& placed, double body_offset);

/// The garment with the attachments that hold only what slips as ones that hold while it is
/// dressed. Nothing when it has none.
std::optional<PanelMesh> hold_what_slips(const PanelMesh& garment);

/// The attachments that hold for good.
std::vector<AttachedPoint> lasting(std::vector<AttachedPoint> attachments);

/// An attachment as it is measured.
struct AttachmentMeasurement {
  std::string name;
  std::string to;  ///< the landmark, "place", "skin" or "point"
  bool always = false;
  bool used = true;          ///< false: held only if the garment slips, and it did not
  double off_mean = 0;       ///< metres from the points to their anchors, the mean
  double off_max = 0;        ///< metres, the largest
  Vec3 pull = Vec3::Zero();  ///< N: the force of the whole attachment on the cloth
};

/// Measures each of the garment's attachments on the material points `points` (metres). Those
/// without points in `attachments` measure 0.
std::vector<AttachmentMeasurement> measure_attachments(
    const PanelMesh& garment, const std::vector<AttachedPoint>& attachments,
    const std::vector<Vec3>& points);

/// Measures the attachments that hold for good again, and overwrites what `measured` has of them.
void measure_lasting(const PanelMesh& garment, const std::vector<AttachedPoint>& attachments,
                     const std::vector<Vec3>& points, std::vector<AttachmentMeasurement>& measured);

}  // namespace toile
