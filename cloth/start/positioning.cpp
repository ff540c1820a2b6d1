#include "cloth/start/positioning.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "cloth/start/constants.h"
#include "cloth/start/leg_divide.h"
#include "cloth/start/rolling.h"
#include "geometry/angles.h"
#include "geometry/body/bones.h"
#include "geometry/error.h"
#include "geometry/half_edges.h"

namespace toile {

namespace {

bool runs_up(BodyPart part) { return !is_limb(part); }

Error refused(const MeshedPanel& panel, const std::string& problem, const std::string& remedy) {
  return {"panel '" + panel.name + "'", problem, remedy};
}

/// A panel to be positioned, in coordinates that run up its body part.
struct UprightPanel {
  const MeshedPanel& panel;
  Bones bones;
  std::vector<Vec2> points;               ///< upright
  std::vector<std::array<int, 2>> edges;  ///< of its triangles, by the numbers of its points
  Vec2 low = Vec2::Constant(1e300);
  Vec2 high = Vec2::Constant(-1e300);
  /// A point of the plane between the legs. The panels of a leg stay on its side.
  Vec3 divide = Vec3::Zero();
  Vec3 away = Vec3::Zero();  ///< unit normal of that plane, to the own side; zero: no leg
  /// Metres: arc length on the bones where the upright y is 0; none: not known yet.
  std::optional<double> origin;
  std::optional<double> wrist;  ///< arc length; of an arm alone

  UprightPanel(const PanelMesh& garment, const MeshedPanel& of, const Skeleton& skeleton)
      : panel(of), bones(skeleton, of.is.part) {
    if (bones.joints.empty()) {
      throw refused(panel,
                    "belongs at part '" + name_of(panel.is.part) + "', which the skeleton lacks",
                    "let clean-body write the skeleton, or place it by translation and rotation");
    }
    if (is_arm(panel.is.part)) {
      wrist = bones.foot(skeleton.joint(side_of(panel.is.part) > 0 ? "left_wrist" : "right_wrist"));
    }
    if (is_leg(panel.is.part)) {
      const LegDivide legs = leg_divide(skeleton);
      divide = legs.at;
      away = side_of(panel.is.part) > 0 ? legs.left : Vec3(-legs.left);
    }
    for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
      points.push_back(upright(panel.placement.axis, garment.flat[p]));
      low = low.cwiseMin(points.back());
      high = high.cwiseMax(points.back());
    }
    const auto first = garment.triangles.begin() + panel.first_triangle;
    edges = unique_edges({first, first + panel.triangles});
    for (std::array<int, 2>& edge : edges) {
      for (int& p : edge) p -= panel.first_point;
    }
  }

  /// 1 where arc length on the bones grows up the part (torso), -1 where it grows down (limbs).
  double sign() const { return runs_up(panel.is.part) ? 1 : -1; }
  double arc(double y) const { return *origin + sign() * y; }
  /// Makes the upright y lie at an arc length.
  void level(double y, double s) { origin = s - sign() * y; }

  /// Metres on the panel's own side of the plane between the legs.
  double beside_divide(const Vec3& p) const {
    return away.isZero() ? std::numeric_limits<double>::max() : (p - divide).dot(away);
  }

  double asked_offset() const {
    return panel.placement.offset.value_or(panel.placement.around > 0 ? rolled_offset
                                                                      : flat_offset);
  }
};

/// How far a panel is stretched in width where it is narrower than above, so that all of it goes
/// around its part. Otherwise the thumb is beside a sleeve that is closed over the hand. The calf
/// is beside a leg that is rolled around the hip, too.
class EvenWidth {
 public:
  explicit EvenWidth(const UprightPanel& piece)
      : low_(piece.low.y()), step_((piece.high.y() - piece.low.y()) / levels) {
    // Edges tell the width: of a coarse mesh, a level may have no point of the border.
    std::array<std::array<double, 2>, levels> ends;
    ends.fill({0, 0});
    for (const auto& [p, q] : piece.edges) {
      Vec2 a = piece.points[p];
      Vec2 b = piece.points[q];
      if (a.y() > b.y()) std::swap(a, b);
      for (std::size_t i = 0; i < levels; ++i) {
        const double y = low_ + (static_cast<double>(i) + 0.5) * step_;
        if (y < a.y() || y > b.y() || a.y() == b.y()) continue;
        const double x = a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()) -
                         0.5 * (piece.low.x() + piece.high.x());
        ends[i] = {std::min(ends[i][0], x), std::max(ends[i][1], x)};
      }
    }
    // From the widest level down; what lies above, as the cap of a sleeve, keeps its width.
    std::size_t widest = 0;
    const auto width = [&](std::size_t i) { return ends[i][1] - ends[i][0]; };
    for (std::size_t i = 1; i < levels; ++i) {
      if (width(i) > width(widest)) widest = i;
    }
    stretch_.fill({1, 1});
    for (std::size_t i = 0; i < widest; ++i) {
      for (std::size_t side = 0; side < 2; ++side) {
        const double own = std::abs(ends[i][side]);
        // A level that does not reach so far is as the one below it.
        const double least = 0.2 * std::abs(ends[widest][side]);
        stretch_[i][side] = own > least ? std::max(1.0, std::abs(ends[widest][side]) / own)
                            : i > 0     ? stretch_[i - 1][side]
                                        : 1;
      }
    }
  }

  /// The factor of x at a height, on the left (x below 0) or the right side.
  double at(double y, bool right) const {
    const double place = std::clamp((y - low_) / step_ - 0.5, 0.0, levels - 1.0);
    const auto i = std::min(static_cast<std::size_t>(place), levels - 2);
    const std::size_t side = right ? 1 : 0;
    return stretch_[i][side] +
           (place - static_cast<double>(i)) * (stretch_[i + 1][side] - stretch_[i][side]);
  }

 private:
  static constexpr std::size_t levels = 16;

  double low_;
  double step_;
  std::array<std::array<double, 2>, levels> stretch_;
};

/// Levels a panel by the joint that it names, else its upper end by that of its body part.
void level_by_joint(UprightPanel& piece, const Skeleton& skeleton) {
  const PanelPlacement& placement = piece.panel.placement;
  if (!placement.at.empty()) {
    piece.level(placement.level.value_or(piece.high.y()),
                piece.bones.foot(skeleton.joint(placement.at)));
  } else if (is_leg(piece.panel.is.part)) {
    piece.level(piece.high.y(), piece.bones.foot(skeleton.joint("waist")));
  } else {
    piece.level(piece.high.y(), runs_up(piece.panel.is.part) ? piece.bones.along.back() : 0);
  }
}

/// The panels to be positioned, with their levels on the bones.
class PanelLevels {
 public:
  PanelLevels(const PanelMesh& garment, const Skeleton& skeleton)
      : garment_(garment), skeleton_(skeleton), panel_of_(panel_of_points(garment)) {
    for (std::size_t i = 0; i < garment.panels.size(); ++i) {
      const MeshedPanel& panel = garment.panels[i];
      if (!panel.placement.by_part()) continue;
      piece_of_[static_cast<int>(i)] = static_cast<int>(pieces.size());
      pieces.emplace_back(garment, panel, skeleton);
      if (!panel.placement.at.empty()) level_by_joint(pieces.back(), skeleton);
    }
    while (level_one()) {
    }
  }

  std::vector<UprightPanel> pieces;

 private:
  bool level_one() {
    UprightPanel* first = nullptr;
    for (UprightPanel& piece : pieces) {
      if (piece.origin) continue;
      // A cuff hangs on its sleeve, which is sewn to the torso.
      if (first == nullptr || (!meets_another_part(*first) && meets_another_part(piece))) {
        first = &piece;
      }
      if (level_by_seams(piece)) return true;
    }
    if (first != nullptr) level_by_joint(*first, skeleton_);
    return first != nullptr;
  }

  bool meets_another_part(const UprightPanel& piece) const {
    const auto meets = [&](int mine, int other) {
      const MeshedPanel& there = garment_.panels[panel_of_[other]];
      return &garment_.panels[panel_of_[mine]] == &piece.panel &&
             there.is.part != piece.panel.is.part;
    };
    return std::any_of(garment_.seams.begin(), garment_.seams.end(), [&](const MeshedSeam& seam) {
      return !seam.a.empty() && (meets(seam.a[0], seam.b[0]) || meets(seam.b[0], seam.a[0]));
    });
  }

  bool level_by_seams(UprightPanel& piece) {
    const int first = piece.panel.first_point;
    double sum = 0;
    int count = 0;
    for (const MeshedSeam& seam : garment_.seams) {
      for (std::size_t i = 0; i < seam.a.size(); ++i) {
        for (const auto& [mine, other] :
             {std::pair(seam.a[i], seam.b[i]), std::pair(seam.b[i], seam.a[i])}) {
          if (mine < first || mine >= first + piece.panel.points) continue;
          const std::optional<double> there = arc_of(other, piece);
          if (!there) continue;
          sum += *there - piece.sign() * piece.points[mine - first].y();
          ++count;
        }
      }
    }
    if (count > 0) piece.origin = sum / count;
    return count > 0;
  }

  /// Metres: arc length on the bones of a point of another panel of the same part, if it is known.
  std::optional<double> arc_of(int point, const UprightPanel& piece) const {
    const MeshedPanel& panel = garment_.panels[panel_of_[point]];
    if (&panel == &piece.panel || panel.is.part != piece.panel.is.part) return std::nullopt;
    const auto found = piece_of_.find(panel_of_[point]);
    if (found == piece_of_.end()) return piece.bones.foot(garment_.placed[point]);
    const UprightPanel& there = pieces[found->second];
    if (!there.origin) return std::nullopt;
    return there.arc(there.points[point - panel.first_point].y());
  }

  const PanelMesh& garment_;
  const Skeleton& skeleton_;
  std::vector<int> panel_of_;
  std::map<int, int> piece_of_;
};

/// A panel whose axis is laid along the bones. Its distance from them is left open.
class PanelPose {
 public:
  /// `drawn_out`: metres farther along the bones. `bent`: a rolled panel follows their bends.
  /// `lean`: radians by which it leans to the front.
  PanelPose(const UprightPanel& piece, double drawn_out, bool bent = false, double lean = 0)
      : piece_(piece), drawn_out_(drawn_out), bent_(bent) {
    const double angle = to_radians(degrees_around(piece.panel.placement, piece.panel.is.part));
    turned_ = Eigen::AngleAxisd(lean, Vec3::UnitX()).toRotationMatrix() *
              Eigen::AngleAxisd(angle, Vec3::UnitY()).toRotationMatrix();
    const double a = piece.arc(piece.low.y()) + drawn_out;
    const double b = piece.arc(piece.high.y()) + drawn_out;
    std::tie(middle_, frame_) = along_bones(std::min(a, b), std::max(a, b));
    drawn_middle_ = 0.5 * (piece.low + piece.high);
    drawn_middle_.x() -= piece.panel.placement.shift;
    if (piece.panel.placement.around == 0) clear_divide();
    const bool is_over_end =
        piece.wrist ? std::max(a, b) > *piece.wrist : is_leg(piece.panel.is.part);
    if (piece.panel.placement.around == 1 && is_over_end) even_.emplace(piece);
  }

  Vec3 at(const Vec2& point, double distance) const {
    Vec2 drawn = point - drawn_middle_;
    if (even_) drawn.x() *= even_->at(point.y(), drawn.x() > 0);
    if (bent_) {
      // The bones' direction is averaged over two radii. So the inner side of a bend stays in order
      // up to 115 degrees.
      const double s = piece_.arc(point.y()) + drawn_out_;
      const auto [middle, frame] = along_bones(s - distance, s + distance);
      return middle + frame * roll({drawn.x(), 0}, 0, distance);
    }
    const Vec3 local = piece_.panel.placement.around > 0 ? roll(drawn, 0, distance)
                                                         : Vec3(drawn.x(), drawn.y(), distance);
    return middle_ + frame_ * local;
  }

  /// The middle of a stretch of the bones, and the panel's directions there.
  std::pair<Vec3, Eigen::Matrix3d> along_bones(double low, double high) const {
    const auto [middle, direction] = piece_.bones.average(low, high);
    return {middle, part_frame(piece_.sign() * direction) * turned_};
  }

  /// Moves a flat panel of a leg sideways, to its side of the plane between the legs.
  void clear_divide() {
    double nearest = leg_plane_clearance;
    for (const Vec2& point : piece_.points) {
      nearest = std::min(nearest, piece_.beside_divide(at(point, max_panel_distance)));
    }
    const Vec3 right = frame_.col(0);
    const double toward = right.dot(piece_.away);
    // A panel at the side of its leg clears the plane by its distance.
    if (std::abs(toward) > min_sideways_cosine)
      middle_ += (leg_plane_clearance - nearest) / toward * right;
  }

  /// The number of points that are nearer to the skin than asked for. Stops counting at
  /// `max_count`.
  int too_near(const DistanceGrid& body, double distance, int max_count) const {
    const double offset = piece_.asked_offset();
    int count = 0;
    for (const Vec2& point : piece_.points) {
      const Vec3 p = at(point, distance);
      count += body.at(p).distance < offset || piece_.beside_divide(p) < leg_plane_clearance;
      if (count >= max_count) break;
    }
    return count;
  }
  bool clear(const DistanceGrid& body, double distance) const {
    return too_near(body, distance, 1) == 0;
  }

  /// Metres: the smallest clear distance between `near`, which is not clear, and `far`, which is.
  double min_clear(const DistanceGrid& body, double near, double far) const {
    for (int i = 0; i < clearance_halvings; ++i) {
      const double between = 0.5 * (near + far);
      (clear(body, between) ? far : near) = between;
    }
    return far;
  }

 private:
  const UprightPanel& piece_;
  double drawn_out_;
  bool bent_;
  Eigen::Matrix3d turned_;  // to the panel's side of its part
  Vec3 middle_;
  Eigen::Matrix3d frame_;
  Vec2 drawn_middle_;
  std::optional<EvenWidth> even_;
};

/// Whether the panel may be drawn down its part to clear the body. Only sleeves may whose place the
/// pattern leaves open, since the armpit obstructs their upper ends.
bool may_be_drawn_out(const UprightPanel& piece) {
  return is_arm(piece.panel.is.part) && piece.panel.placement.at.empty();
}

/// Metres: lengths to draw out by, from `min_drawn` to `max_drawn` in steps of `draw_step`.
std::vector<double> draws(double min_drawn, double max_drawn) {
  std::vector<double> all;
  for (int i = 0; min_drawn + i * draw_step <= max_drawn + draw_step / 2; ++i) {
    all.push_back(min_drawn + i * draw_step);
  }
  return all;
}

/// Metres: the smallest distance at which the flat panel is clear of the body, at most `farther`.
double clear_distance(const UprightPanel& piece, const DistanceGrid& body, double drawn,
                      double farther) {
  // From the bones outward, not from afar inward: beside the torso there is room behind the arm.
  const PanelPose pose(piece, drawn);
  const double first = piece.asked_offset();
  double distance = first;
  while (!pose.clear(body, distance)) {
    distance += positioning_step;
    if (distance >= farther) return farther;
  }
  return distance > first ? pose.min_clear(body, distance - positioning_step, distance) : first;
}

PositionedPanel stand_flat(const UprightPanel& piece, const DistanceGrid& body,
                           const std::vector<double>& drawn_out) {
  PositionedPanel best{piece.panel.name, false, false, max_panel_distance, 0, 0, 0, 0};
  for (const double drawn : drawn_out) {
    const double distance = clear_distance(piece, body, drawn, best.distance);
    // A centimetre down the arm has to bring more than its slope does.
    if (distance > best.distance - min_draw_gain) continue;
    best.distance = distance;
    best.drawn_out = drawn;
  }
  if (best.distance >= max_panel_distance) {
    throw refused(piece.panel, "finds no place clear of the body",
                  "check its size and 'placement'");
  }
  return best;
}

PositionedPanel roll_around(const UprightPanel& piece, const DistanceGrid& body,
                            const std::vector<double>& drawn_out, bool bent, double lean = 0) {
  const double around = piece.panel.placement.around;
  const double width = piece.high.x() - piece.low.x();
  const double tightest = rolling_radius(width, around, 0);
  PositionedPanel best{piece.panel.name, true, bent, tightest, 0, 0, piece.panel.points + 1, lean};
  for (double radius = tightest; best.points_too_near > 0 && radius <= tightest + max_radius_growth;
       radius += positioning_step) {
    for (const double drawn : drawn_out) {
      const PanelPose pose(piece, drawn, bent, lean);
      const int count = pose.too_near(body, radius, best.points_too_near);
      if (count >= best.points_too_near) continue;
      best.distance = radius;
      best.drawn_out = drawn;
      best.points_too_near = count;
      if (count > 0) continue;
      if (radius > tightest)
        best.distance = pose.min_clear(body, radius - positioning_step, radius);
      break;
    }
  }
  best.gap = seam_gap(width, around, best.distance);
  return best;
}

/// Whether less of the panel is too near to the skin, or as much of it with less of a gap.
bool is_better(const PositionedPanel& a, const PositionedPanel& b) {
  if (a.points_too_near != b.points_too_near) return a.points_too_near < b.points_too_near;
  return a.gap < b.gap;
}

/// Rolls the panel about a straight line, or about the bent bones where that is better. At the
/// neck, which leans to the front as bones do not tell, it leans as far as brings it the nearest.
PositionedPanel roll_around(const UprightPanel& piece, const DistanceGrid& body,
                            const std::vector<double>& drawn_out) {
  if (piece.panel.placement.at == "neck") {
    PositionedPanel best = roll_around(piece, body, drawn_out, false);
    for (const double degrees : neck_leans) {
      best = std::min(best, roll_around(piece, body, drawn_out, false, to_radians(degrees)),
                      is_better);
    }
    return best;
  }
  const PositionedPanel straight = roll_around(piece, body, drawn_out, false);
  const PositionedPanel bent = roll_around(piece, body, drawn_out, true);
  if (bent.points_too_near != straight.points_too_near) {
    return std::min(straight, bent, is_better);
  }
  const double brings = straight.drawn_out + straight.gap - bent.drawn_out - bent.gap;
  return brings > min_bend_gain ? bent : straight;
}

PositionedPanel position(const UprightPanel& piece, const DistanceGrid& body, double min_drawn,
                         double max_drawn) {
  const std::vector<double> drawn_out = draws(min_drawn, max_drawn);
  return piece.panel.placement.around > 0 ? roll_around(piece, body, drawn_out)
                                          : stand_flat(piece, body, drawn_out);
}

}  // namespace

bool asks_for_skeleton(const PanelMesh& garment) {
  return std::any_of(garment.panels.begin(), garment.panels.end(),
                     [](const MeshedPanel& panel) { return panel.placement.by_part(); });
}

Eigen::Matrix3d part_frame(const Vec3& up) {
  // Rodrigues' formula for the turn about y × up; its 1/(1 + cos) has no limit upside down.
  constexpr double upside_down = -1 + 1e-12;
  if (up.y() < upside_down) return Vec3(-1, -1, 1).asDiagonal();
  const Vec3 axis = Vec3::UnitY().cross(up);
  Eigen::Matrix3d cross;
  cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  return Eigen::Matrix3d::Identity() + cross + cross * cross / (1 + up.y());
}

Positioning position_panels(const PanelMesh& garment, const DistanceGrid& body,
                            const Skeleton* skeleton) {
  Positioning result;
  result.placed = garment.placed;
  if (!asks_for_skeleton(garment)) return result;
  if (skeleton == nullptr) {
    const auto panel = std::find_if(garment.panels.begin(), garment.panels.end(),
                                    [](const MeshedPanel& p) { return p.placement.by_part(); });
    throw refused(*panel, "is to be positioned by the body's skeleton, and there is none",
                  "let clean-body write it beside the body, or name it with --skeleton");
  }
  const PanelLevels levels(garment, *skeleton);
  std::map<BodyPart, double> drawn_out;  // by part: the panels of one sleeve stay together
  for (const UprightPanel& piece : levels.pieces) {
    if (!may_be_drawn_out(piece)) continue;
    double& drawn = drawn_out[piece.panel.is.part];
    drawn = std::max(drawn, position(piece, body, 0, max_drawn_out).drawn_out);
  }
  for (const UprightPanel& piece : levels.pieces) {
    const double drawn = may_be_drawn_out(piece) ? drawn_out.at(piece.panel.is.part) : 0;
    const PositionedPanel how = position(piece, body, drawn, drawn);
    const PanelPose pose(piece, how.drawn_out, how.bent, how.lean);
    for (int i = 0; i < piece.panel.points; ++i) {
      result.placed[piece.panel.first_point + i] = pose.at(piece.points[i], how.distance);
    }
    result.panels.push_back(how);
  }
  return result;
}

}  // namespace toile
