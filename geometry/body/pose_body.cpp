#include "geometry/body/pose_body.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>

#include "geometry/body/bone_motion.h"
#include "geometry/body/limbs_through.h"
#include "geometry/body/skin_weights.h"
#include "geometry/error.h"

namespace toile {

namespace {

/// Share of the linear blend at the shoulder. With 0 the shoulder of a raised arm stands out like
/// a ball. With 0.7 more skin crosses itself under an arm raised by 150 degrees.
constexpr double linear_share = 0.5;

/// Metres: a shorter bone has no direction. No child's is shorter than some centimetres.
constexpr double min_bone_length = 0.01;

/// A sum of rigid motions: as dual quaternions, and as matrices.
class Blend {
 public:
  explicit Blend(const Vec3& point) : point_(point) {}

  /// Begins at the trunk: the next motion's quaternion takes the sign that is nearer to its.
  void begin_chain() { last_ = Eigen::Vector4d(0, 0, 0, 1); }

  void add(double weight, const RigidMotion& motion) {
    Eigen::Vector4d real = motion.turn.coeffs();
    const Eigen::Quaterniond shift(0, motion.shift.x(), motion.shift.y(), motion.shift.z());
    Eigen::Vector4d dual = (shift * motion.turn).coeffs() / 2;
    if (real.dot(last_) < 0) {
      real = -real;
      dual = -dual;
    }
    last_ = real;
    if (weight == 0) return;
    real_ += weight * real;
    dual_ += weight * dual;
    linear_ += weight * motion(point_);
  }

  Vec3 by_dual_quaternions() const {
    const double norm = real_.norm();
    const Eigen::Quaterniond turn(real_ / norm);
    const Eigen::Quaterniond dual(dual_ / norm);
    return turn * point_ + 2 * (dual * turn.conjugate()).vec();
  }
  const Vec3& linear() const { return linear_; }

 private:
  Vec3 point_;
  Eigen::Vector4d last_ = Eigen::Vector4d(0, 0, 0, 1);
  Eigen::Vector4d real_ = Eigen::Vector4d::Zero();
  Eigen::Vector4d dual_ = Eigen::Vector4d::Zero();
  Vec3 linear_ = Vec3::Zero();
};

using Row = Eigen::Matrix<double, 1, bone_count>;

Vec3 posed_point(const Vec3& p, const Row& weights, const std::array<SideMotion, 2>& sides) {
  const double of_trunk = weights[bone_index(Bone::trunk, true)];
  if (of_trunk == 1) return p;
  Blend blend(p);
  blend.add(of_trunk, RigidMotion());
  double of_arms = 0;
  for (const bool left : {true, false}) {
    const SideMotion& side = sides[left ? 0 : 1];
    const auto weight = [&](Bone bone) { return weights[bone_index(bone, left)]; };
    of_arms += weight(Bone::upper_arm);
    blend.begin_chain();
    blend.add(weight(Bone::upper_arm), side.upper_arm.at(p));
    blend.add(weight(Bone::forearm), side.forearm);
    blend.begin_chain();
    blend.add(weight(Bone::thigh), side.thigh.at(p));
    blend.add(weight(Bone::shin), side.shin);
    blend.add(weight(Bone::foot), side.foot);
    blend.add(weight(Bone::toes), side.toes);
  }
  const Vec3 curved = blend.by_dual_quaternions();
  // 1 where trunk and arm share the skin, 0 where one has none of it.
  const double at_shoulder = std::min(1.0, 20 * std::min(of_trunk, of_arms));
  return curved + linear_share * at_shoulder * (blend.linear() - curved);
}

}  // namespace

PosedBody pose_body(const TriangleMesh& body, const Skeleton& skeleton, const Pose& pose,
                    const std::string& name) {
  if (!has_all_limbs(skeleton)) {
    throw Error(name, "the skeleton lacks joints", "let clean-body find them on the standing body");
  }
  for (const Segment& bone : skeleton.segments) {
    if (!((skeleton.joint(bone.to) - skeleton.joint(bone.from)).norm() > min_bone_length)) {
      throw Error(name, "joints " + bone.from + " and " + bone.to + " are at one place",
                  "let clean-body find them");
    }
  }
  const SkinCores cores = skin_cores(body, skeleton, name);
  const SkinWeights weights = skin_weights(body, cores.bone_of);
  const std::array<SideMotion, 2> sides = {side_motion(skeleton, cores.feet[0], pose.left, true),
                                           side_motion(skeleton, cores.feet[1], pose.right, false)};
  PosedBody posed;
  posed.surface.triangles = body.triangles;
  posed.surface.points.reserve(body.points.size());
  for (std::size_t i = 0; i < body.points.size(); ++i) {
    const Row row = weights.row(static_cast<Eigen::Index>(i));
    posed.surface.points.push_back(posed_point(body.points[i], row, sides));
  }
  posed.crossings = open_crossings(posed.surface);
  posed.skeleton = moved(skeleton, sides);
  posed.skeleton.cleaned.reset();   // no rigid move brings the file's body here
  posed.skeleton.measures.reset();  // they are of the body that stood

  double floor = std::numeric_limits<double>::max();
  for (const Vec3& p : posed.surface.points) floor = std::min(floor, p.y());
  for (Vec3& p : posed.surface.points) p.y() -= floor;
  for (auto& [joint_name, joint] : posed.skeleton.joints) joint.y() -= floor;
  return posed;
}

}  // namespace toile
