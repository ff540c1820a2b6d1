#include "cloth/model/attachments.h"

#include <algorithm>

#include "cloth/scene/collider.h"
#include "geometry/body/bones.h"
#include "geometry/body/skeleton.h"
#include "geometry/body/trunk_levels.h"
#include "geometry/distance_grid.h"
#include "geometry/error.h"
#include "geometry/surface_distance.h"

namespace toile {

namespace {

/// Per point, its share of the attachment: the part of the edge's length that is nearest to it.
std::vector<double> shares_along(const PanelMesh& garment, const std::vector<int>& points) {
  if (points.size() == 1) return {1};
  std::vector<double> shares(points.size(), 0);
  double whole = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double length = (garment.flat[points[i]] - garment.flat[points[i + 1]]).norm();
    shares[i] += length / 2;
    shares[i + 1] += length / 2;
    whole += length;
  }
  for (double& share : shares) share /= whole;
  return shares;
}

/// A plane at a height of the body.
struct TargetLevel {
  Vec3 point;  ///< metres, on the plane
  Vec3 axis;   ///< unit vector, square to the plane
};

class Anchors {
 public:
  Anchors(const Scene& scene, double body_offset) : scene_(scene), offset_(body_offset) {}

  TargetLevel level(const MeshedAttachment& attached) {
    const std::string& landmark = attached.how.landmark;
    if (scene_.skeleton == nullptr) {
      throw refused(attached, "there is no skeleton",
                    "let clean-body write it beside the body, or name it with --skeleton");
    }
    for (const std::string side : {"left_", "right_"}) {
      if (landmark.starts_with(side)) return limb_level(attached, side.starts_with("left"));
    }
    const Vec3 up = Vec3::UnitY();
    if (landmark == "bust" || landmark == "hip") {
      return {(girth_height(attached) + attached.how.above) * up, up};
    }
    return {scene_.skeleton->joint(landmark) + attached.how.above * up, up};
  }

  Vec3 place(const MeshedAttachment& attached, const Vec3& placed) const {
    Vec3 anchor = attached.how.to == AttachedTo::point ? attached.how.point : placed;
    if (attached.how.to == AttachedTo::skin) {
      if (scene_.collider == nullptr)
        throw refused(attached, "there is no body", "give one to dress");
      anchor = scene_.collider->skin().closest_point(placed).point;
    }
    return touches_body(scene_) ? off_the_body(anchor) : anchor;
  }

 private:
  static Error refused(const MeshedAttachment& attached, const std::string& why,
                       const std::string& remedy) {
    return {"attachment '" + attached.name + "'",
            "is held at '" + attached.how.landmark + "', but " + why, remedy};
  }

  TargetLevel limb_level(const MeshedAttachment& attached, bool left) const {
    const std::string& joint = attached.how.landmark;
    const bool of_arm =
        joint.ends_with("shoulder") || joint.ends_with("elbow") || joint.ends_with("wrist");
    const Bones bones(*scene_.skeleton, of_arm ? arm_of(left) : leg_of(left));
    if (bones.joints.empty()) {
      throw refused(attached, "the skeleton lacks that limb", "let clean-body write the skeleton");
    }
    // Bones of a limb run away from the body. So a level above a joint lies nearer to the body.
    const double along = bones.foot(scene_.skeleton->joint(joint)) - attached.how.above;
    const auto [point, direction] = bones.at(along);
    return {point, direction};
  }

  double girth_height(const MeshedAttachment& attached) {
    if (scene_.collider == nullptr)
      throw refused(attached, "there is no body", "give one to dress");
    if (girths_.empty()) girths_ = girth_levels(scene_.collider->body(), *scene_.skeleton);
    for (const NamedLevel& level : girths_) {
      if (level.name == attached.how.landmark) return level.height;
    }
    throw refused(attached, "the body shows none", "name a joint, with 'above'");
  }

  /// Moves an anchor out of the body. The smooth distance is not exact, so it takes several steps.
  Vec3 off_the_body(Vec3 anchor) const {
    constexpr int steps = 5;
    for (int i = 0; i < steps; ++i) {
      const DistanceGrid::Sample at = scene_.collider->grid().at(anchor);
      if (at.distance >= offset_) break;
      anchor += (offset_ - at.distance) * at.gradient;
    }
    return anchor;
  }

  const Scene& scene_;
  double offset_;                   // metres that the cloth keeps from the skin
  std::vector<NamedLevel> girths_;  // empty until one is needed
};

std::string target_of(const Attachment& how) {
  switch (how.to) {
    case AttachedTo::level:
      return how.landmark;
    case AttachedTo::place:
      return "place";
    case AttachedTo::skin:
      return "skin";
    case AttachedTo::point:
      return "point";
    case AttachedTo::side:
      return "side";
    case AttachedTo::height:
      return "height";
  }
  return "";
}

}  // namespace

std::vector<AttachedPoint> attached_points(const PanelMesh& garment, const Scene& scene,
                                           const std::vector<Vec3>& placed, double body_offset) {
  std::vector<AttachedPoint> all;
  if (garment.attachments.empty()) return all;
  Anchors anchors(scene, body_offset);
  for (std::size_t a = 0; a < garment.attachments.size(); ++a) {
    const MeshedAttachment& attached = garment.attachments[a];
    const Attachment& how = attached.how;
    if (how.only_if_it_slips) continue;
    TargetLevel level{Vec3::Zero(), Vec3::Zero()};
    if (how.to == AttachedTo::level) level = anchors.level(attached);
    const std::vector<double> shares = shares_along(garment, attached.points);
    for (std::size_t i = 0; i < shares.size(); ++i) {
      const int point = attached.points[i];
      if (how.to == AttachedTo::side) level = {placed[point], Vec3::UnitX()};
      if (how.to == AttachedTo::height) level = {placed[point], Vec3::UnitY()};
      all.push_back({point, static_cast<int>(a),
                     level.axis.isZero() ? anchors.place(attached, placed[point]) : level.point,
                     level.axis, shares[i] * how.stiffness, shares[i] * how.max_pull, how.always});
    }
  }
  return all;
}

std::optional<PanelMesh> hold_what_slips(const PanelMesh& garment) {
  const auto slips = [](const MeshedAttachment& each) { return each.how.only_if_it_slips; };
  if (std::ranges::none_of(garment.attachments, slips)) return std::nullopt;
  PanelMesh held = garment;
  for (MeshedAttachment& each : held.attachments) each.how.only_if_it_slips = false;
  return held;
}

std::vector<AttachedPoint> lasting(std::vector<AttachedPoint> attachments) {
  std::erase_if(attachments, [](const AttachedPoint& each) { return !each.always; });
  return attachments;
}

std::vector<AttachmentMeasurement> measure_attachments(
    const PanelMesh& garment, const std::vector<AttachedPoint>& attachments,
    const std::vector<Vec3>& points) {
  std::vector<AttachmentMeasurement> all;
  for (const MeshedAttachment& each : garment.attachments) {
    all.push_back({each.name, target_of(each.how), each.how.always, !each.how.only_if_it_slips});
  }
  for (const AttachedPoint& attached : attachments) {
    AttachmentMeasurement& measured = all[attached.attachment];
    const double off = displacement_to_anchor(attached, points[attached.point]).norm();
    const auto count = static_cast<double>(garment.attachments[attached.attachment].points.size());
    measured.off_mean += off / count;
    measured.off_max = std::max(measured.off_max, off);
    measured.pull += attachment_pull(attached, points[attached.point]);
  }
  return all;
}

void measure_lasting(const PanelMesh& garment, const std::vector<AttachedPoint>& attachments,
                     const std::vector<Vec3>& points,
                     std::vector<AttachmentMeasurement>& measured) {
  const std::vector<AttachmentMeasurement> now = measure_attachments(garment, attachments, points);
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (now[i].always) measured[i] = now[i];
  }
}

}  // namespace toile
