#include "cloth/start/positioning.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include "cloth/start/rolling.h"
#include "geometry/body/bones.h"
#include "geometry/error.h"

namespace toile {

namespace {

constexpr double step = 0.005;  // metres between the distances tried
constexpr double farthest = 1.5;
constexpr double widest = 0.3;  // added to a radius
constexpr double draw_step = 0.01;
constexpr double draw_worth = 0.002;  // metres nearer to the arm that a step must bring
constexpr double farthest_drawn = 0.20;
constexpr double bend_worth = 0.02;    // metres of gap and of draw that bending must spare
constexpr double from_divide = 0.005;  // metres kept from the plane between the legs
constexpr int halvings = 6;            // of a step, toward the nearest place that is clear

bool runs_up(const std::string& part) { return part == "torso" || part == "head"; }

Error refused(const MeshedPanel& panel, const std::string& problem, const std::string& remedy) {
  return {"panel '" + panel.name + "'", problem, remedy};
}

/// A panel to be positioned, in the coordinates that run up its part.
struct Piece {
  const MeshedPanel& panel;
  Bones bones;
  std::vector<Vec2> points;  ///< upright
  Vec2 low = Vec2::Constant(1e300);
  Vec2 high = Vec2::Constant(-1e300);
  /// Of a leg: the plane between both, which its panels stay on their side of; else zero.
  Vec3 divide = Vec3::Zero();
  Vec3 away = Vec3::Zero();
  /// Arc length on the bones where the upright y is 0; not known yet: none.
  std::optional<double> origin;

  Piece(const PanelMesh& garment, const MeshedPanel& of, const Skeleton& skeleton)
      : panel(of), bones(skeleton, of.part) {
    if (bones.joints.empty()) {
      throw refused(panel, "belongs at part '" + panel.part + "', which the skeleton lacks",
                    "let clean-body write the skeleton, or place it by translation and rotation");
    }
    if (panel.part.ends_with("_leg")) {
      const Vec3& left = skeleton.joint("left_hip");
      const Vec3& right = skeleton.joint("right_hip");
      divide = 0.5 * (left + right);
      away = (panel.part.starts_with("left") ? left - right : right - left).normalized();
    }
    for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
      points.push_back(upright(panel.placement.axis, garment.flat[p]));
      low = low.cwiseMin(points.back());
      high = high.cwiseMax(points.back());
    }
  }

  /// Arc length on the bones grows up the torso, down a limb.
  double sign() const { return runs_up(panel.part) ? 1 : -1; }
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

/// Lays a panel's own joint, or its upper end at that of its part.
void level_by_joint(Piece& piece, const Skeleton& skeleton) {
  const PanelPlacement& placement = piece.panel.placement;
  if (!placement.at.empty()) {
    piece.level(placement.level.value_or(piece.high.y()),
                piece.bones.foot(skeleton.joint(placement.at)));
  } else if (piece.panel.part.ends_with("_leg")) {
    piece.level(piece.high.y(), piece.bones.foot(skeleton.joint("waist")));
  } else {
    piece.level(piece.high.y(), runs_up(piece.panel.part) ? piece.bones.along.back() : 0);
  }
}

/// Pieces with their level on the bones.
class Levels {
 public:
  Levels(const PanelMesh& garment, const Skeleton& skeleton)
      : garment_(garment), skeleton_(skeleton) {
    for (std::size_t i = 0; i < garment.panels.size(); ++i) {
      panel_of_.insert(panel_of_.end(), garment.panels[i].points, static_cast<int>(i));
      const MeshedPanel& panel = garment.panels[i];
      if (!panel.placement.by_part()) continue;
      piece_of_[static_cast<int>(i)] = static_cast<int>(pieces.size());
      pieces.emplace_back(garment, panel, skeleton);
      if (!panel.placement.at.empty()) level_by_joint(pieces.back(), skeleton);
    }
    while (level_one()) {
    }
  }

  std::vector<Piece> pieces;

 private:
  bool level_one() {
    Piece* first = nullptr;
    for (Piece& piece : pieces) {
      if (piece.origin) continue;
      if (first == nullptr) first = &piece;
      if (level_by_seams(piece)) return true;
    }
    if (first != nullptr) level_by_joint(*first, skeleton_);
    return first != nullptr;
  }

  bool level_by_seams(Piece& piece) {
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

  /// Where another panel of the same part has a point, if that is known.
  std::optional<double> arc_of(int point, const Piece& piece) const {
    const MeshedPanel& panel = garment_.panels[panel_of_[point]];
    if (&panel == &piece.panel || panel.part != piece.panel.part) return std::nullopt;
    const auto found = piece_of_.find(panel_of_[point]);
    if (found == piece_of_.end()) return piece.bones.foot(garment_.placed[point]);
    const Piece& there = pieces[found->second];
    if (!there.origin) return std::nullopt;
    return there.arc(there.points[point - panel.first_point].y());
  }

  const PanelMesh& garment_;
  const Skeleton& skeleton_;
  std::vector<int> panel_of_;
  std::map<int, int> piece_of_;
};

/// The panel's axis laid along the bones: what is left open is the distance from them.
class Stand {
 public:
  /// `drawn_out`: metres farther along the bones. `bent`: a rolled panel follows their bends.
  Stand(const Piece& piece, double drawn_out, bool bent = false)
      : piece_(piece), drawn_out_(drawn_out), bent_(bent) {
    const double angle =
        degrees_around(piece.panel.placement, piece.panel.part) * std::numbers::pi / 180;
    turned_ = Eigen::AngleAxisd(angle, Vec3::UnitY()).toRotationMatrix();
    const double a = piece.arc(piece.low.y()) + drawn_out;
    const double b = piece.arc(piece.high.y()) + drawn_out;
    std::tie(middle_, frame_) = along_bones(std::min(a, b), std::max(a, b));
    drawn_middle_ = 0.5 * (piece.low + piece.high);
    drawn_middle_.x() -= piece.panel.placement.shift;
    if (piece.panel.placement.around == 0) clear_divide();
  }

  Vec3 at(const Vec2& point, double distance) const {
    const Vec2 drawn = point - drawn_middle_;
    if (bent_) {
      // Over two radii of the bones: the inner side of a bend stays in order up to 115 degrees.
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
    double least = from_divide;
    for (const Vec2& point : piece_.points) {
      least = std::min(least, piece_.beside_divide(at(point, farthest)));
    }
    const Vec3 right = frame_.col(0);
    const double toward = right.dot(piece_.away);
    // Of a panel at the side of its leg it is the distance that has to do it.
    if (std::abs(toward) > 0.5) middle_ += (from_divide - least) / toward * right;
  }

  /// Points that are nearer to the skin than they should be; no more are counted than `most`.
  int too_near(const DistanceGrid& body, double distance, int most) const {
    const double offset = piece_.asked_offset();
    int count = 0;
    for (const Vec2& point : piece_.points) {
      const Vec3 p = at(point, distance);
      count += body.at(p).distance < offset || piece_.beside_divide(p) < from_divide;
      if (count >= most) break;
    }
    return count;
  }
  bool clear(const DistanceGrid& body, double distance) const {
    return too_near(body, distance, 1) == 0;
  }

  /// The least distance that is clear between one that is not and one that is.
  double min_clear(const DistanceGrid& body, double near, double far) const {
    for (int i = 0; i < halvings; ++i) {
      const double between = 0.5 * (near + far);
      (clear(body, between) ? far : near) = between;
    }
    return far;
  }

 private:
  const Piece& piece_;
  double drawn_out_;
  bool bent_;
  Eigen::Matrix3d turned_;  // to the panel's side of its part
  Vec3 middle_;
  Eigen::Matrix3d frame_;
  Vec2 drawn_middle_;
};

/// Whether the panel may be drawn down its part to clear the body. Only sleeves may whose place the
/// pattern leaves open, since the armpit obstructs their upper ends.
bool may_be_drawn_out(const Piece& piece) {
  return piece.panel.part.ends_with("_arm") && piece.panel.placement.at.empty();
}

/// Drawn out by whole steps, `least` first and no more than `most`.
std::vector<double> draws(double least, double most) {
  std::vector<double> all;
  for (int i = 0; least + i * draw_step <= most + draw_step / 2; ++i) {
    all.push_back(least + i * draw_step);
  }
  return all;
}

/// The least distance at which the flat panel is clear of the body; none below `farther`: that.
double clear_distance(const Piece& piece, const DistanceGrid& body, double drawn, double farther) {
  // From the bones outward, not from afar inward: beside the torso there is room behind the arm.
  const Stand stand(piece, drawn);
  const double first = piece.asked_offset();
  double distance = first;
  while (!stand.clear(body, distance)) {
    distance += step;
    if (distance >= farther) return farther;
  }
  return distance > first ? stand.min_clear(body, distance - step, distance) : first;
}

PositionedPanel stand_flat(const Piece& piece, const DistanceGrid& body,
                           const std::vector<double>& drawn_out) {
  PositionedPanel best{piece.panel.name, false, false, farthest, 0, 0, 0};
  for (const double drawn : drawn_out) {
    const double distance = clear_distance(piece, body, drawn, best.distance);
    // A centimetre down the arm has to bring more than its slope does.
    if (distance > best.distance - draw_worth) continue;
    best.distance = distance;
    best.drawn_out = drawn;
  }
  if (best.distance >= farthest) {
    throw refused(piece.panel, "finds no place clear of the body",
                  "check its size and 'placement'");
  }
  return best;
}

PositionedPanel roll_around(const Piece& piece, const DistanceGrid& body,
                            const std::vector<double>& drawn_out, bool bent) {
  const double around = piece.panel.placement.around;
  const double width = piece.high.x() - piece.low.x();
  const double tightest = rolling_radius(width, around, 0);
  PositionedPanel best{piece.panel.name, true, bent, tightest, 0, 0, piece.panel.points + 1};
  for (double radius = tightest; best.points_too_near > 0 && radius <= tightest + widest;
       radius += step) {
    for (const double drawn : drawn_out) {
      const Stand stand(piece, drawn, bent);
      const int count = stand.too_near(body, radius, best.points_too_near);
      if (count >= best.points_too_near) continue;
      best.distance = radius;
      best.drawn_out = drawn;
      best.points_too_near = count;
      if (count > 0) continue;
      if (radius > tightest) best.distance = stand.min_clear(body, radius - step, radius);
      break;
    }
  }
  best.gap = seam_gap(width, around, best.distance);
  return best;
}

/// About a straight line, unless the bends of the part are in the way of that.
PositionedPanel roll_around(const Piece& piece, const DistanceGrid& body,
                            const std::vector<double>& drawn_out) {
  const PositionedPanel straight = roll_around(piece, body, drawn_out, false);
  const PositionedPanel bent = roll_around(piece, body, drawn_out, true);
  if (bent.points_too_near != straight.points_too_near) {
    return bent.points_too_near < straight.points_too_near ? bent : straight;
  }
  const double brings = straight.drawn_out + straight.gap - bent.drawn_out - bent.gap;
  return brings > bend_worth ? bent : straight;
}

PositionedPanel position(const Piece& piece, const DistanceGrid& body, double least, double most) {
  const std::vector<double> drawn_out = draws(least, most);
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
  const Levels levels(garment, *skeleton);
  std::map<std::string, double> drawn_out;  // by part: the panels of one sleeve stay together
  for (const Piece& piece : levels.pieces) {
    if (!may_be_drawn_out(piece)) continue;
    double& drawn = drawn_out[piece.panel.part];
    drawn = std::max(drawn, position(piece, body, 0, farthest_drawn).drawn_out);
  }
  for (const Piece& piece : levels.pieces) {
    const double drawn = may_be_drawn_out(piece) ? drawn_out.at(piece.panel.part) : 0;
    const PositionedPanel how = position(piece, body, drawn, drawn);
    const Stand stand(piece, how.drawn_out, how.bent);
    for (int i = 0; i < piece.panel.points; ++i) {
      result.placed[piece.panel.first_point + i] = stand.at(piece.points[i], how.distance);
    }
    result.panels.push_back(how);
  }
  return result;
}

}  // namespace toile
