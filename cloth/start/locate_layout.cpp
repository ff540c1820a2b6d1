#include "cloth/start/locate_layout.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "cloth/start/constants.h"
#include "cloth/start/positioning.h"
#include "geometry/angles.h"
#include "geometry/body/bones.h"
#include "geometry/body/limbs_through.h"
#include "geometry/disjoint_sets.h"
#include "io/text.h"
#include "pattern/classify/panel_class.h"

namespace toile {

namespace {

Vec3 middle_of(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : points) sum += p;
  return sum / static_cast<double>(std::max<std::size_t>(points.size(), 1));
}

Vec3 middle_of(const MeshedPanel& panel, const std::vector<Vec3>& placed) {
  Vec3 sum = Vec3::Zero();
  for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) sum += placed[p];
  return sum / std::max(panel.points, 1);
}

double highest_of(const MeshedPanel& panel, const std::vector<Vec3>& placed) {
  double highest = -std::numeric_limits<double>::infinity();
  for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
    highest = std::max(highest, placed[p].y());
  }
  return highest;
}

class Layout {
 public:
  Layout(const PanelMesh& garment, std::vector<Vec3> placed, const Skeleton& skeleton)
      : garment_(garment), placed_(std::move(placed)), skeleton_(skeleton) {
    for (const MeshedPanel& panel : garment.panels) {
      middles_.push_back(middle_of(panel, placed_));
    }
  }

  /// Radians about the vertical, by whole quarters, that bring the front before the body.
  double turn() const;
  /// Metres, of a layout that needs no turn.
  Vec3 shift() const;
  /// Metres, on average over the panels, from their middles to the bones that they belong to. A
  /// layout that is turned counts as `turned_misfit` metres farther off a quarter of a turn.
  double misfit() const;

 private:
  PanelRole kind(std::size_t p) const { return garment_.panels[p].is.worn_as; }
  /// The level direction from the panels of negative sign to those of positive ones.
  std::optional<Vec3> from_to(int (*sign_of)(const PanelClass&), bool of_sleeves) const;
  std::optional<Vec3> forward() const { return from_to(face_sign, false); }
  std::optional<Vec3> leftward() const;
  /// Metres: the heights that the top of the garment may have, and the one that it belongs at. From
  /// below it is raised to `raised`.
  struct Heights {
    double low;
    double wanted;
    double high = wanted + max_layout_height;
    double raised = wanted;
  };
  bool has(PanelRole wanted) const;
  std::set<int> shoulder_panels() const;
  bool surrounds_middle() const;
  std::optional<Heights> heights() const;
  std::optional<double> top() const;

  const PanelMesh& garment_;
  std::vector<Vec3> placed_;
  const Skeleton& skeleton_;
  std::vector<Vec3> middles_;
};

std::optional<Vec3> Layout::from_to(int (*sign_of)(const PanelClass&), bool of_sleeves) const {
  Vec3 sums[2] = {Vec3::Zero(), Vec3::Zero()};
  double counts[2] = {0, 0};
  for (std::size_t p = 0; p < middles_.size(); ++p) {
    if ((kind(p) == PanelRole::sleeve) != of_sleeves) continue;
    const int sign = sign_of(garment_.panels[p].is);
    if (sign == 0) continue;
    sums[sign > 0 ? 1 : 0] += middles_[p];
    counts[sign > 0 ? 1 : 0] += 1;
  }
  if (counts[0] == 0 || counts[1] == 0) return std::nullopt;
  Vec3 across = sums[1] / counts[1] - sums[0] / counts[0];
  across.y() = 0;
  if (across.norm() < min_layout_depth) return std::nullopt;
  return across.normalized();
}

std::optional<Vec3> Layout::leftward() const {
  const std::optional<Vec3> by_sleeves = from_to(side_sign, true);
  return by_sleeves ? by_sleeves : from_to(side_sign, false);
}

double Layout::turn() const {
  const auto quarters = [](double x, double z) {
    return std::lround(std::atan2(x, z) / (std::numbers::pi / 2));
  };
  const std::optional<Vec3> front = forward();
  const std::optional<Vec3> left = leftward();
  // A turn by t about y takes +z to (sin t, 0, cos t) and +x to (cos t, 0, -sin t).
  std::optional<long> by_front;
  std::optional<long> by_left;
  if (front) by_front = quarters(front->x(), front->z());
  if (left) by_left = quarters(-left->z(), left->x());
  if (!by_front && !by_left) return 0;
  const auto same = [](long a, long b) { return (a - b) % 4 == 0; };
  if (by_front && by_left && !same(*by_front, *by_left)) return 0;
  if (!by_front && same(*by_left, 2)) return 0;
  const long turned = by_front ? *by_front : *by_left;
  return -static_cast<double>(turned) * std::numbers::pi / 2;
}

/// The panels with a seam that is a shoulder's. It runs sideways, and above the middles of a front
/// and a back. They are not of skirts or trousers.
std::set<int> Layout::shoulder_panels() const {
  const std::vector<int> panel_of = panel_of_points(garment_);
  const auto is_shoulder = [&](const std::vector<int>& side) {
    const int panel = panel_of[side.front()];
    if (kind(panel) != PanelRole::bodice && kind(panel) != PanelRole::unknown) return false;
    const Vec3 along = placed_[side.back()] - placed_[side.front()];
    return std::hypot(along.x(), along.z()) > std::abs(along.y()) &&
           std::ranges::all_of(side, [&](int p) {
             return placed_[p].y() > middles_[panel].y() + min_shoulder_height;
           });
  };
  const auto face = [&](const std::vector<int>& side) {
    return face_sign(garment_.panels[panel_of[side.front()]].is);
  };
  std::set<int> panels;
  for (const MeshedSeam& seam : garment_.seams) {
    if (!is_shoulder(seam.a) || !is_shoulder(seam.b) || face(seam.a) == face(seam.b)) continue;
    panels.insert({panel_of[seam.a.front()], panel_of[seam.b.front()]});
  }
  return panels;
}

bool Layout::has(PanelRole wanted) const {
  for (std::size_t p = 0; p < middles_.size(); ++p) {
    if (kind(p) == wanted) return true;
  }
  return false;
}

/// Whether panels that are sewn together reach to both sides of the layout's middle, as those of
/// two stockings do not.
bool Layout::surrounds_middle() const {
  DisjointSets sewn(middles_.size());
  const std::vector<int> panel_of = panel_of_points(garment_);
  for (const MeshedSeam& seam : garment_.seams) {
    sewn.join(panel_of[seam.a.front()], panel_of[seam.b.front()]);
  }
  Eigen::AlignedBox3d all;
  for (const Vec3& p : placed_) all.extend(p);
  const double middle = all.center().x();
  std::vector<std::array<bool, 2>> reaches(middles_.size(), {false, false});
  for (std::size_t p = 0; p < placed_.size(); ++p) {
    std::array<bool, 2>& sides = reaches[sewn.of(panel_of[p])];
    sides[0] = sides[0] || placed_[p].x() < middle - min_layout_depth;
    sides[1] = sides[1] || placed_[p].x() > middle + min_layout_depth;
  }
  return std::ranges::any_of(reaches, [](const auto& sides) { return sides[0] && sides[1]; });
}

std::optional<Layout::Heights> Layout::heights() const {
  const double waist = skeleton_.joint("waist").y();
  const double armpit = skeleton_.joint("chest").y();
  const bool has_bottom =
      has(PanelRole::skirt) || has(PanelRole::trousers) || has(PanelRole::waistband);
  const double neck = skeleton_.joint("neck").y();
  if (!shoulder_panels().empty()) {
    // Raised half-way to the neck: the start lifts it on, as far as the shoulders want.
    const double left = skeleton_.joint("left_shoulder").y();
    const double shoulders = std::min(left, skeleton_.joint("right_shoulder").y());
    return Heights{shoulders, neck, neck + max_shoulder_rise, (shoulders + neck) / 2};
  }
  const auto is_worn_high = [](const MeshedPanel& panel) {
    return panel.is.worn_as == PanelRole::sleeve || panel.is.is_headwear();
  };
  if (std::ranges::any_of(garment_.panels, is_worn_high)) {
    return Heights{armpit - layout_slack, neck};
  }
  if (has(PanelRole::bodice)) return Heights{waist - layout_slack, armpit};
  if (has(PanelRole::unknown) || !has_bottom || !surrounds_middle()) return std::nullopt;
  return Heights{waist - max_low_rise, waist};
}

/// Metres: the highest point of the panels with shoulder seams. Without those, of the trunk's
/// panels, hoods and collars apart; none: there are none.
std::optional<double> Layout::top() const {
  const std::set<int> shoulders = shoulder_panels();
  double highest = -std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < middles_.size(); ++p) {
    const bool counts = shoulders.empty()
                            ? kind(p) != PanelRole::sleeve && !garment_.panels[p].is.is_headwear()
                            : shoulders.contains(static_cast<int>(p));
    if (counts) highest = std::max(highest, highest_of(garment_.panels[p], placed_));
  }
  return std::isfinite(highest) ? std::optional(highest) : std::nullopt;
}

Vec3 Layout::shift() const {
  Vec3 shift = Vec3::Zero();
  const std::optional<Heights> belongs = heights();
  const std::optional<double> highest = top();
  if (!highest || !belongs) return shift;
  // Below by rounding is not below: a layout is moved once.
  if (*highest < belongs->low - 1e-9) shift.y() = belongs->raised - *highest;
  if (*highest > belongs->high) shift.y() = belongs->wanted - *highest;
  Eigen::AlignedBox3d box;
  for (std::size_t p = 0; p < middles_.size(); ++p) {
    if (kind(p) == PanelRole::sleeve) continue;
    const MeshedPanel& panel = garment_.panels[p];
    for (int i = panel.first_point; i < panel.first_point + panel.points; ++i) {
      box.extend(placed_[i]);
    }
  }
  Vec3 off = skeleton_.joint("waist") - box.center();
  off.y() = 0;
  if (off.norm() > max_layout_offset) shift += off;
  return shift;
}

double Layout::misfit() const {
  double sum = 0;
  for (std::size_t p = 0; p < middles_.size(); ++p) {
    using enum BodyPart;
    std::vector<BodyPart> parts = {torso};
    if (kind(p) == PanelRole::sleeve) parts = {left_arm, right_arm};
    if (kind(p) == PanelRole::trousers || kind(p) == PanelRole::skirt) {
      parts = {left_leg, right_leg, torso};
    }
    if (garment_.panels[p].is.is_headwear()) parts = {head};
    double least = std::numeric_limits<double>::infinity();
    for (const BodyPart part : parts) {
      const Bones bones(skeleton_, part);
      if (!bones.joints.empty()) least = std::min(least, bones.distance(middles_[p]));
    }
    if (std::isfinite(least)) sum += least;
  }
  sum /= static_cast<double>(std::max<std::size_t>(middles_.size(), 1));
  if (const auto front = forward()) sum += turned_misfit * (1 - front->z());
  return sum;
}

/// Whether something other than the cloth says where panels belong.
bool is_attached(const PanelMesh& garment) {
  return std::ranges::any_of(garment.attachments, [](const MeshedAttachment& attachment) {
    return attachment.how.to != AttachedTo::side && attachment.how.to != AttachedTo::height;
  });
}

std::vector<Vec3> moved(const LayoutMove& move, std::vector<Vec3> points) {
  for (Vec3& p : points) p = move.rotation * p + move.translation;
  return points;
}

}  // namespace

bool lacks_places(const PanelMesh& garment, const Skeleton* skeleton) {
  if (garment.panels.size() < 2) return false;
  if (!garment.has_places) return true;
  if (garment.seams.empty() || asks_for_skeleton(garment)) return false;
  if (is_attached(garment)) return false;
  const Vec3 middle = middle_of(garment.placed);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& p : garment.placed) spread += (p - middle) * (p - middle).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  const Vec3 normal = axes.eigenvectors().col(0);
  if (std::abs(normal.y()) > max_upright_normal) return false;
  Vec3 axis = Vec3::Zero();
  if (skeleton != nullptr && skeleton->joints.contains("waist")) axis = skeleton->joint("waist");
  axis.y() = middle.y();
  if (std::abs((axis - middle).dot(normal)) > max_plane_offset) return false;
  return std::ranges::all_of(garment.placed, [&](const Vec3& p) {
    return std::abs((p - middle).dot(normal)) < min_layout_depth / 2;
  });
}

std::optional<LayoutMove> locate_layout(const PanelMesh& garment, const Skeleton& skeleton) {
  if (garment.placed.empty() || !has_all_limbs(skeleton)) return std::nullopt;
  if (asks_for_skeleton(garment) || is_attached(garment)) return std::nullopt;
  LayoutMove move;
  std::vector<Vec3> placed = garment.placed;
  if (skeleton.cleaned) {
    const LayoutMove body{skeleton.cleaned->rotation, skeleton.cleaned->translation, true};
    const std::vector<Vec3> with_body = moved(body, placed);
    const double here = Layout(garment, placed, skeleton).misfit();
    if (Layout(garment, with_body, skeleton).misfit() < here - min_better_fit) {
      move = body;
      placed = with_body;
    }
  }
  LayoutMove own;
  const Layout layout(garment, placed, skeleton);
  const double turn = layout.turn();
  if (turn != 0) {
    own.rotation = Eigen::AngleAxisd(turn, Vec3::UnitY()).toRotationMatrix();
    // About the body's axis, or the layout's middle where that is far from it.
    Vec3 axis = middle_of(placed);
    axis.y() = skeleton.joint("waist").y();
    if ((axis - skeleton.joint("waist")).norm() < max_layout_offset) axis = skeleton.joint("waist");
    own.translation = axis - own.rotation * axis;
  }
  own.translation += Layout(garment, moved(own, placed), skeleton).shift();
  const bool moves = turn != 0 || !own.translation.isZero(0);
  if (moves) {
    move.rotation = own.rotation * move.rotation;
    move.translation = own.rotation * move.translation + own.translation;
    move.as_body = false;
  }
  if (!moves && !move.as_body) return std::nullopt;
  return move;
}

void move_layout(const LayoutMove& move, PanelMesh& garment) {
  garment.placed = moved(move, std::move(garment.placed));
}

std::string text_of(const LayoutMove& move, const PanelMesh& garment) {
  const Vec3 middle = middle_of(garment.placed);
  const Vec3 by = move.rotation * middle + move.translation - middle;
  std::string text;
  const auto add = [&](const std::string& what) { text += (text.empty() ? "" : ", ") + what; };
  const double angle = to_degrees(Eigen::AngleAxisd(move.rotation).angle());
  if (std::lround(angle) != 0) add("turned by " + std::to_string(std::lround(angle)) + " degrees");
  if (std::lround(100 * by.y()) != 0) {
    add(std::string(by.y() > 0 ? "raised" : "lowered") + " by " + centimetres(std::abs(by.y()), 0));
  }
  const double level = std::hypot(by.x(), by.z());
  if (std::lround(100 * level) != 0) add("moved level by " + centimetres(level, 0));
  return text.empty() ? "moved by less than 1 cm" : text;
}

}  // namespace toile
