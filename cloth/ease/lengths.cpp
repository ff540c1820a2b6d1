#include "cloth/ease/lengths.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>

#include "cloth/ease/garment_levels.h"
#include "geometry/body/limbs_through.h"

namespace toile {

namespace {

/// Metres from a limb's line within which cloth is of that limb. Half and double were not tried.
constexpr double beside_limb = 0.2;

class LengthTaker {
 public:
  LengthTaker(const DressedGarment& garment, const Skeleton& skeleton,
              const std::vector<Measure>& measures, const std::vector<PanelRole>& worn_as)
      : garment_(garment), skeleton_(skeleton), measures_(measures), worn_as_(worn_as) {}

  std::vector<GarmentLength> taken() {
    for (const std::string side : {"left", "right"}) take_sleeve(side);
    take_centre();
    for (const std::string side : {"left", "right"}) take_leg(side);
    return std::move(lengths_);
  }

 private:
  PanelRole role(const PathStep& step) const { return worn_as_[step.panel]; }
  std::optional<double> body(const std::string& measure) const {
    const Measure* found = find_measure(measures_, measure);
    return found == nullptr ? std::nullopt : found->value;
  }
  void add(const std::string& name, const ClothPath& path, std::optional<double> body,
           std::vector<EndsBeyond> ends) {
    // A slit parts a path: the first part counts.
    const bool is_taken = std::ranges::find(lengths_, name, &GarmentLength::name) != lengths_.end();
    if (path.empty() || is_taken) return;
    lengths_.push_back({name, flat_length(path), worn_length(path), body, std::move(ends)});
  }

  /// The paths of a plane, each from both of its ends.
  std::vector<ClothPath> both_ways(const CuttingPlane& plane) const {
    std::vector<ClothPath> paths = paths_on_plane(garment_, plane);
    const std::size_t count = paths.size();
    for (std::size_t i = 0; i < count; ++i) paths.push_back(reversed(paths[i]));
    return paths;
  }

  void take_sleeve(const std::string& side) {
    const Vec3& shoulder = skeleton_.joint(side + "_shoulder");
    const Vec3& elbow = skeleton_.joint(side + "_elbow");
    const Vec3& wrist = skeleton_.joint(side + "_wrist");
    const Vec3 arm = (wrist - shoulder).normalized();
    // Over the arm: up from it, or outward from one that hangs straight down.
    Vec3 over = Vec3::UnitY() + Vec3(side == "left" ? 0.2 : -0.2, 0, 0);
    over = (over - over.dot(arm) * arm).normalized();
    const auto along = [&](const Vec3& p) { return (p - shoulder).dot(arm); };
    for (const ClothPath& path : both_ways({shoulder, arm.cross(over)})) {
      const Vec3& end = path.front().worn_from;
      const Vec3 off = end - shoulder - along(end) * arm;
      if (role(path.front()) != PanelRole::sleeve || along(end) <= 0 || off.dot(over) <= 0 ||
          off.norm() > beside_limb) {
        continue;
      }
      const auto armhole = std::ranges::find_if(
          path, [&](const PathStep& step) { return role(step) != PanelRole::sleeve; });
      add(side + " sleeve", {path.begin(), armhole}, body(side + "_arm_length"),
          {{side + " elbow", along(end) - along(elbow)},
           {side + " wrist", along(end) - along(wrist)}});
      // Up to the neck. A path to the other sleeve shows no end of the shoulder.
      const ClothPath rest(armhole, path.end());
      const auto other = std::ranges::find_if(
          rest, [&](const PathStep& step) { return role(step) == PanelRole::sleeve; });
      if (rest.empty() || other != rest.end()) return;
      const Measure* length = find_measure(measures_, side + "_shoulder_length");
      std::vector<EndsBeyond> ends;
      if (length != nullptr && length->value) {
        const Vec3& point = length->lines.front().back();
        ends.push_back({side + " shoulder point",
                        (rest.front().worn_from - point).dot(Vec3(arm.x(), 0, arm.z())) /
                            Vec3(arm.x(), 0, arm.z()).norm()});
      }
      add(side + " shoulder", rest, body(side + "_shoulder_length"), std::move(ends));
      return;
    }
  }

  void take_centre() {
    const Vec3& neck = skeleton_.joint("neck");
    std::vector<ClothPath> paths = paths_on_plane(garment_, {neck, Vec3::UnitX()});
    std::erase_if(paths, [](const ClothPath& path) { return path.empty(); });
    if (paths.size() != 2) return;
    const auto depth = [](const ClothPath& path) {
      return path.front().worn_from.z() + path.back().worn_to.z();
    };
    if (depth(paths[0]) < depth(paths[1])) std::swap(paths[0], paths[1]);
    for (const bool is_front : {true, false}) {
      ClothPath& path = paths[is_front ? 0 : 1];
      if (path.front().worn_from.y() < path.back().worn_to.y()) path = reversed(path);
      const std::string name = is_front ? "centre front" : "centre back";
      const auto seam = std::ranges::find_if(
          path, [&](const PathStep& step) { return hangs_from_waist(role(step)); });
      if (seam != path.begin() && seam != path.end()) {
        add(name + " to waist seam", {path.begin(), seam},
            body(is_front ? "front_centre_length" : "back_centre_length"), {});
      }
      add(name, path, {}, {{"floor", path.back().worn_to.y()}});
    }
  }

  void take_leg(const std::string& side) {
    const Vec3& hip = skeleton_.joint(side + "_hip");
    const Vec3& ankle = skeleton_.joint(side + "_ankle");
    const Vec3 leg = (ankle - hip).normalized();
    const double outward = side == "left" ? 1 : -1;
    for (const ClothPath& path : both_ways({hip, leg.cross(Vec3::UnitX()).normalized()})) {
      const Vec3& hem = path.front().worn_from;
      const Vec3 off = hem - hip - (hem - hip).dot(leg) * leg;
      const bool is_this_leg = outward * (hem.x() - skeleton_.joint("pelvis").x()) > 0;
      if (role(path.front()) != PanelRole::trousers || hem.y() > hip.y() || !is_this_leg ||
          off.norm() > beside_limb) {
        continue;
      }
      if (outward * off.x() > 0) {
        add(side + " outseam", path, {}, {{"floor", hem.y()}});
        continue;
      }
      const auto crotch =
          std::ranges::max_element(path, {}, [](const PathStep& step) { return step.worn_to.y(); });
      add(side + " inseam", {path.begin(), std::next(crotch)}, body("inside_leg"),
          {{"floor", hem.y()}});
    }
  }

  const DressedGarment& garment_;
  const Skeleton& skeleton_;
  const std::vector<Measure>& measures_;
  const std::vector<PanelRole>& worn_as_;
  std::vector<GarmentLength> lengths_;
};

}  // namespace

std::vector<GarmentLength> measure_lengths(const DressedGarment& garment, const Skeleton& skeleton,
                                           const std::vector<Measure>& measures,
                                           const std::vector<PanelRole>& worn_as) {
  if (!has_all_limbs(skeleton)) return {};
  return LengthTaker(garment, skeleton, measures, worn_as).taken();
}

}  // namespace toile
