// A dressed garment by its connected components: which panels and openings each has, and what goes
// around which part of the body.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "cloth/judge/hangs.h"
#include "cloth/judge/openings.h"
#include "cloth/judge/wraps.h"
#include "pattern/classify/panel_class.h"

namespace toile {

/// Panels and openings of one connected component of the garment, without layered panels.
struct WornComponent {
  std::set<int> panels;
  std::vector<const Opening*> openings;
};

/// Of some cloth: its area, and the sum of area times place, whose quotient is the cloth's middle.
struct AreaMoment {
  Vec3 moment = Vec3::Zero();
  double area = 0;

  void add(const AreaMoment& other) {
    moment += other.moment;
    area += other.area;
  }
  Vec3 middle() const { return area > 0 ? Vec3(moment / area) : Vec3(moment); }
};

inline constexpr LimbsThrough through_left_arm{true, false, false, false};
inline constexpr LimbsThrough through_right_arm{false, true, false, false};
inline constexpr LimbsThrough through_left_leg{false, false, true, false};
inline constexpr LimbsThrough through_right_leg{false, false, false, true};

/// What the check of wear asks of a dressed garment. It refers to what it was made of. Panels are
/// numbers below garment.panels.size(), nodes below dressed.points.size().
class WornGarment {
 public:
  /// What the openings have to pass is measured on `body`; null: it is not. About O(n log n) in the
  /// triangles.
  WornGarment(const PanelMesh& meshed, const DressedGarment& worn, const Skeleton& joints,
              const TriangleMesh* body);
  WornGarment(const WornGarment&) = delete;  // components point to its openings
  WornGarment& operator=(const WornGarment&) = delete;

  PanelRole kind(int panel) const { return garment.panels[panel].is.worn_as; }
  std::vector<int> panels_of(const WornComponent& component, PanelRole wanted) const;
  bool has(const WornComponent& component, PanelRole wanted) const;
  std::vector<int> without_sleeves(const WornComponent& component) const;
  AreaMoment moment_of(const auto& panels) const {
    AreaMoment sum;
    for (const int p : panels) sum.add(moments[p]);
    return sum;
  }
  /// Per panel of the garment, 1 for those given.
  std::vector<char> marked(const std::vector<int>& panels) const;
  /// Share of the directions around a part that the panels meet.
  double share_around(const std::vector<int>& panels, BodyPart part) const;
  /// Whether a loop of the panels' border has these limbs through it.
  bool closes_around(const std::vector<int>& panels, const LimbsThrough& limbs) const;
  /// Whether panels go around a part: closed, as a loop of their border tells, or as far as a
  /// cardigan does. Panels that do not reach it do not go around it.
  bool goes_around(const std::vector<int>& panels, BodyPart part, const LimbsThrough& limbs) const;
  /// The lowest and the highest height of panels, by places of all nodes. Metres.
  std::array<double, 2> heights(const std::vector<Vec3>& places, const std::set<int>& panels) const;
  /// Panels of sleeves or trousers, grouped by the limb that they are for. A part that was found by
  /// seams, or that the user asked for, beats the side that the pattern says. The sleeve's shape
  /// tells whether it is right there: names of mirrored pieces are often exchanged in drawings.
  std::map<BodyPart, std::vector<int>> by_limb(const std::vector<int>& panels,
                                               BodyPart (*limb_of)(bool)) const;
  /// Whether most of the opening's border is of the panels.
  static bool belongs_to(const Opening& opening, const std::vector<int>& panels);
  /// The highest opening that both legs pass through, and no arm; null: none.
  const Opening* highest_around_trunk(const WornComponent& component) const;
  /// The level direction from the middle of the panels that `sign_of` counts negative to that of
  /// the positive ones. None: one kind is missing, or the middles are too near.
  std::optional<Vec3> level_direction(const WornComponent& component,
                                      int (*sign_of)(const PanelClass&)) const;

  const PanelMesh& garment;
  const DressedGarment& dressed;
  const Skeleton& skeleton;
  const std::vector<Vec3>& nodes;  ///< dressed.points
  std::vector<Vec3> placed;        ///< of each node, where one of its material points started
  std::vector<Opening> openings;
  std::vector<WornComponent> components;
  std::vector<AreaMoment> moments;  ///< per panel
  std::vector<PanelHang> hangs;     ///< per panel
  double crotch = 0;                ///< heights, metres
  double waist = 0;
  double armpit = 0;

 private:
  /// +1: most of the panel starts on the left.
  int placed_side(const MeshedPanel& panel) const;
};

}  // namespace toile
