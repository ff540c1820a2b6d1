// The joints of a body and the segments between them: plain data.
#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/body/body_measures.h"
#include "geometry/body/body_part.h"
#include "geometry/error.h"
#include "geometry/types.h"

namespace toile {

/// A straight bone between two named joints. `part` is one of body_parts.
struct Segment {
  std::string part;
  std::string from;
  std::string to;
};

/// How clean-body brought a body into its frame. A point p of the file, in metres, came to
/// rotation * p + translation.
struct BodyMove {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vec3 translation = Vec3::Zero();  ///< metres
  double metres_per_unit = 1;       ///< of the file's unit
};

/// Joints in metres, in the body's frame: y up, feet on y = 0, facing +z, the wearer's left is +x.
///
/// The trunk's joints are pelvis (at crotch height), waist, chest (at armpit height), neck (its
/// base) and head (the top). shoulder, elbow, wrist, hip, knee and ankle have left_ or right_
/// before them. Segments run away from the pelvis:
/// - torso: pelvis, waist, chest, neck;
/// - head: neck, head;
/// - each arm: shoulder, elbow, wrist;
/// - each leg: hip, knee, ankle.
struct Skeleton {
  std::map<std::string, Vec3> joints;  ///< by name
  std::vector<Segment> segments;
  std::optional<BodyMove> cleaned = {};  ///< none: not known
  /// Of the body that had these joints when it was cleaned; standing_measures() says whether it
  /// still has. None: not measured.
  std::optional<BodyMeasures> measures = {};

  /// The joint of that name. Throws Error when there is none.
  const Vec3& joint(const std::string& name) const {
    const auto found = joints.find(name);
    if (found == joints.end()) {
      throw Error("skeleton", "has no joint '" + name + "'",
                  "let clean-body write it; a limb that the body lacks has none");
    }
    return found->second;
  }
};

inline constexpr std::array<std::string_view, 17> joint_names = {
    "pelvis",     "waist",      "chest",          "neck",        "head",        "left_shoulder",
    "left_elbow", "left_wrist", "right_shoulder", "right_elbow", "right_wrist", "left_hip",
    "left_knee",  "left_ankle", "right_hip",      "right_knee",  "right_ankle"};

/// The segments of a whole body, between joint_names.
inline std::vector<Segment> body_segments() {
  std::vector<Segment> segments;
  const auto chain = [&segments](const std::string& part, const std::vector<std::string>& names) {
    for (std::size_t i = 0; i + 1 < names.size(); ++i) {
      segments.push_back({part, names[i], names[i + 1]});
    }
  };
  chain("torso", {"pelvis", "waist", "chest", "neck"});
  chain("head", {"neck", "head"});
  for (const std::string side : {"left_", "right_"}) {
    chain(side + "arm", {side + "shoulder", side + "elbow", side + "wrist"});
    chain(side + "leg", {side + "hip", side + "knee", side + "ankle"});
  }
  return segments;
}

}  // namespace toile
