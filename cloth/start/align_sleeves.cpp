#include "cloth/start/align_sleeves.h"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "cloth/start/constants.h"
#include "geometry/body/bones.h"

namespace toile {

namespace {

class Sleeve {
 public:
  Sleeve(const PanelMesh& garment, const std::vector<BodyPart>& part_of_point, BodyPart part)
      : garment_(garment), part_of_point_(part_of_point), part_(part) {
    for (const MeshedPanel& panel : garment.panels) {
      if (is_mine(panel.first_point) && !panel.placement.by_part()) panels_.push_back(&panel);
    }
  }

  bool empty() const { return panels_.empty(); }

  /// Metres: the mean vector of its seams from armhole to cuff; zero if no seam runs along the arm.
  Vec3 run(const std::vector<Vec3>& placed, const Vec3& down_arm) const {
    Vec3 sum = Vec3::Zero();
    int sides = 0;
    for (const MeshedSeam& seam : garment_.seams) {
      if (!is_mine(seam.a.front()) || !is_mine(seam.b.front())) continue;
      for (const std::vector<int>* side : {&seam.a, &seam.b}) {
        const Vec3 side_run = placed[side->back()] - placed[side->front()];
        const double down = side_run.dot(down_arm);
        if (std::abs(down) < along_sleeve_cosine * side_run.norm()) continue;
        sum += down > 0 ? side_run : Vec3(-side_run);
        ++sides;
      }
    }
    return sides > 0 ? Vec3(sum / sides) : sum;
  }

  /// The middle of the points that are sewn to the torso, if any are.
  std::optional<Vec3> armhole(const std::vector<Vec3>& placed) const {
    Vec3 sum = Vec3::Zero();
    int points = 0;
    for (const MeshedSeam& seam : garment_.seams) {
      for (const auto& [side, other] : {std::pair(&seam.a, &seam.b), std::pair(&seam.b, &seam.a)}) {
        if (!is_mine(side->front()) || part_of_point_[other->front()] != BodyPart::torso) continue;
        for (const int p : *side) sum += placed[p];
        points += static_cast<int>(side->size());
      }
    }
    if (points == 0) return std::nullopt;
    return sum / points;
  }

  void turn(const Eigen::Matrix3d& rotation, Vec3 middle, std::vector<Vec3>& placed) const {
    for (const MeshedPanel* panel : panels_) {
      const std::span<Vec3> points(&placed[panel->first_point], panel->points);
      middle.z() = 0;
      for (const Vec3& p : points) middle.z() += p.z() / panel->points;
      for (Vec3& p : points) p = middle + rotation * (p - middle);
    }
  }

 private:
  bool is_mine(int point) const { return part_of_point_[point] == part_; }

  const PanelMesh& garment_;
  const std::vector<BodyPart>& part_of_point_;
  BodyPart part_;
  std::vector<const MeshedPanel*> panels_;  // that the pattern itself places
};

}  // namespace

std::map<BodyPart, double> turn_sleeves(const PanelMesh& garment,
                                        const std::vector<BodyPart>& part_of_point,
                                        const Skeleton& skeleton, std::vector<Vec3>& placed) {
  std::map<BodyPart, double> turned;
  for (const BodyPart part : {BodyPart::left_arm, BodyPart::right_arm}) {
    const Bones arm(skeleton, part);
    const Sleeve sleeve(garment, part_of_point, part);
    if (arm.joints.empty() || sleeve.empty()) continue;
    const Vec3 run = sleeve.run(placed, (arm.joints.back() - arm.joints.front()).normalized());
    const std::optional<Vec3> armhole = sleeve.armhole(placed);
    if (run.isZero() || !armhole) continue;
    const auto turn = Eigen::Quaterniond::FromTwoVectors(run, arm.average(0, run.norm()).second);
    const double angle = turn.angularDistance(Eigen::Quaterniond::Identity());
    if (angle < min_sleeve_turn) continue;
    sleeve.turn(turn.toRotationMatrix(), *armhole, placed);
    turned[part] = angle;
  }
  return turned;
}

}  // namespace toile
