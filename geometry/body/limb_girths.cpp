#include "geometry/body/limb_girths.h"

#include <cmath>

#include "geometry/body/mannequin/mannequin.h"

namespace toile {

namespace {

struct MeasuredBone {
  const char* name;
  const char* from;
  const char* to;
  std::vector<double> shares;  // of the length
  const char* next;            // the joint after `to`; none: `to` has no girth
};

const std::vector<MeasuredBone>& bones() {
  static const std::vector<MeasuredBone> all = {
      {"upper arm", "shoulder", "elbow", {0.5, 0.7}, "wrist"},
      {"forearm", "elbow", "wrist", {0.3, 0.6, 0.9}, nullptr},
      {"thigh", "hip", "knee", {0.4, 0.6, 0.8}, "ankle"},
      {"shin", "knee", "ankle", {0.2, 0.4, 0.6, 0.8}, nullptr},
  };
  return all;
}

/// The girth at a share of a bone's length.
double girth_at(const TriangleMesh& body, const Vec3& from, const Vec3& to, double share) {
  return girth_around(body, from + share * (to - from), to - from);
}

/// The girth at a joint, in the plane that halves the bones' angle.
double girth_of_joint(const TriangleMesh& body, const Vec3& before, const Vec3& joint,
                      const Vec3& after) {
  return girth_around(body, joint, (joint - before).normalized() + (after - joint).normalized());
}

}  // namespace

std::vector<LimbGirth> limb_girths(const TriangleMesh& standing, const Skeleton& standing_joints,
                                   const TriangleMesh& posed, const Skeleton& posed_joints) {
  std::vector<LimbGirth> girths;
  for (const std::string side : {"left", "right"}) {
    for (const MeasuredBone& bone : bones()) {
      const auto at = [&side](const Skeleton& skeleton, const std::string& joint) {
        return skeleton.joint(side + "_" + joint);
      };
      for (const double share : bone.shares) {
        LimbGirth girth;
        girth.name = side + " " + bone.name + " " + std::to_string(std::lround(100 * share)) + " %";
        girth.standing =
            girth_at(standing, at(standing_joints, bone.from), at(standing_joints, bone.to), share);
        girth.posed =
            girth_at(posed, at(posed_joints, bone.from), at(posed_joints, bone.to), share);
        girths.push_back(girth);
      }
      if (bone.next == nullptr) continue;
      girths.push_back(
          {side + " " + bone.to,
           girth_of_joint(standing, at(standing_joints, bone.from), at(standing_joints, bone.to),
                          at(standing_joints, bone.next)),
           girth_of_joint(posed, at(posed_joints, bone.from), at(posed_joints, bone.to),
                          at(posed_joints, bone.next))});
    }
  }
  return girths;
}

}  // namespace toile
