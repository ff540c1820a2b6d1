#include "cloth/judge/worn.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "cloth/judge/constants.h"
#include "cloth/judge/wraps.h"
#include "geometry/body/bones.h"
#include "geometry/border_loops.h"
#include "pattern/panel_kind.h"

namespace toile {

namespace {

constexpr LimbsThrough through_left_arm{true, false, false, false};
constexpr LimbsThrough through_right_arm{false, true, false, false};
constexpr LimbsThrough through_left_leg{false, false, true, false};
constexpr LimbsThrough through_right_leg{false, false, false, true};

/// Whether the opening lets an arm through: what has it hangs from the shoulders.
bool has_arm(const Opening& opening) { return opening.limbs.left_arm || opening.limbs.right_arm; }

/// The body part whose bones are nearest.
std::string nearest_part(const Vec3& point, const Skeleton& skeleton) {
  std::string nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const std::string_view part : body_parts) {
    const Bones bones(skeleton, std::string(part));
    if (bones.joints.empty()) continue;
    const double distance = bones.distance(point);
    if (distance < least) {
      least = distance;
      nearest = part;
    }
  }
  return nearest;
}

std::string in_words(std::string part) {
  std::ranges::replace(part, '_', ' ');
  return part;
}

/// Points and panels of one connected piece of the garment.
struct Piece {
  std::set<int> panels;
  std::vector<const Opening*> openings;
};

/// Sums of area times middle, to take means of cloth.
struct Cloth {
  Vec3 moment = Vec3::Zero();
  double area = 0;

  void add(const Cloth& other) {
    moment += other.moment;
    area += other.area;
  }
  Vec3 middle() const { return area > 0 ? Vec3(moment / area) : Vec3(moment); }
};

class WornCheck {
 public:
  WornCheck(const PanelMesh& garment, const DressedGarment& dressed, const Skeleton& skeleton)
      : garment_(garment),
        dressed_(dressed),
        nodes_(dressed.points),
        placed_(dressed.points),
        skeleton_(skeleton),
        cloth_(garment.panels.size()) {
    findings_.openings = find_openings(dressed, skeleton);
    const std::vector<int> piece_of_node = connected_pieces(dressed);
    std::map<int, Piece> pieces;
    for (std::size_t t = 0; t < dressed.triangles.size(); ++t) {
      const Triangle& corners = dressed.triangles[t];
      const int panel = dressed.panel_of_triangle[t];
      pieces[piece_of_node[corners[0]]].panels.insert(panel);
      for (int i = 0; i < 3; ++i) placed_[corners[i]] = garment.placed[garment.triangles[t][i]];
      const Vec3& a = dressed.points[corners[0]];
      const Vec3& b = dressed.points[corners[1]];
      const Vec3& c = dressed.points[corners[2]];
      const double area = (b - a).cross(c - a).norm();
      cloth_[panel].moment += area * (a + b + c) / 3;
      cloth_[panel].area += area;
    }
    for (const Opening& opening : findings_.openings) {
      pieces[opening.component].openings.push_back(&opening);
    }
    for (auto& [number, piece] : pieces) pieces_.push_back(std::move(piece));
    crotch_ = skeleton.joint("pelvis").y();
    waist_ = skeleton.joint("waist").y();
    armpit_ = skeleton.joint("chest").y();
  }

  WearFindings run() {
    for (const Piece& piece : pieces_) check(piece);
    return std::move(findings_);
  }

 private:
  PanelKind kind(int panel) const { return kind_of(garment_.panels[panel]); }
  std::vector<int> panels_of(const Piece& piece, PanelKind wanted) const {
    std::vector<int> panels;
    for (const int p : piece.panels) {
      if (kind(p) == wanted) panels.push_back(p);
    }
    return panels;
  }
  bool has(const Piece& piece, PanelKind wanted) const { return !panels_of(piece, wanted).empty(); }
  Cloth cloth_of(const auto& panels) const {
    Cloth sum;
    for (const int p : panels) sum.add(cloth_[p]);
    return sum;
  }
  /// Whether panels go around a part: closed, as a loop of their border tells, or as far as a
  /// cardigan does. Panels that do not reach it have nothing to go around.
  bool goes_around(const std::vector<int>& panels, const std::string& part,
                   const LimbsThrough& limbs) const {
    std::vector<char> is_counted(garment_.panels.size(), 0);
    for (const int p : panels) is_counted[p] = 1;
    std::vector<Triangle> triangles;
    for (std::size_t t = 0; t < dressed_.triangles.size(); ++t) {
      if (is_counted[dressed_.panel_of_triangle[t]]) triangles.push_back(dressed_.triangles[t]);
    }
    for (const std::vector<int>& loop : border_loops(triangles, nodes_.size())) {
      std::vector<Vec3> curve;
      curve.reserve(loop.size());
      for (const int node : loop) curve.push_back(nodes_[node]);
      if (limbs_through(curve, skeleton_) == limbs) return true;
    }
    const WrapMeasurement wrap = measure_wrap(garment_, dressed_, skeleton_, part, is_counted);
    return wrap.from >= wrap.to || wrap.fraction >= around_share;
  }

  void misplace(const std::string& part, const std::string& at, const std::string& should_be) {
    findings_.is_checked = true;
    if (!findings_.misplaced) findings_.misplaced = Misplaced{part, at, should_be};
  }
  /// Cloth about `at` should go around `part`: misplaced if another part is nearer.
  void fail(const std::string& part, const Vec3& at, const std::string& should_be) {
    findings_.is_checked = true;
    if (nearest_part(at, skeleton_) != part) {
      misplace(part, place_on_body(at, skeleton_), should_be);
    } else if (std::ranges::find(findings_.unwrapped, part) == findings_.unwrapped.end()) {
      findings_.unwrapped.push_back(part);
    }
  }

  void check(const Piece& piece) {
    const Vec3 middle = cloth_of(piece.panels).middle();
    const std::size_t found = findings_.unwrapped.size();
    if (middle.y() < 0) {
      misplace("torso", place_on_body(middle, skeleton_), "on the body");
      return;
    }
    check_sleeves(piece);
    check_trousers(piece);
    check_trunk(piece);
    if (findings_.misplaced || findings_.unwrapped.size() > found) return;
    check_empty_openings(piece);
    check_facing(piece);
  }

  /// Panels of one kind, grouped by the side of the body that part or name says.
  std::map<std::string, std::vector<int>> by_side(const std::vector<int>& panels,
                                                  const std::string& limb) const {
    std::map<std::string, std::vector<int>> groups;
    for (const int p : panels) {
      const MeshedPanel& panel = garment_.panels[p];
      int side = side_by_name(panel.name);
      if (!panel.part.empty()) side = panel.part.starts_with("left") ? 1 : -1;
      if (side == 0) side = placed_side(panel);
      groups[(side > 0 ? "left_" : "right_") + limb].push_back(p);
    }
    return groups;
  }
  /// +1: most of the panel starts on the left.
  int placed_side(const MeshedPanel& panel) const {
    double sum = 0;
    for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
      sum += garment_.placed[p].x() - skeleton_.joint("pelvis").x();
    }
    return sum >= 0 ? 1 : -1;
  }

  /// Whether most of the opening's border is of the panels.
  static bool belongs_to(const Opening& opening, const std::vector<int>& panels) {
    const auto count = std::ranges::count_if(
        opening.panels, [&](int p) { return std::ranges::find(panels, p) != panels.end(); });
    return 2 * count > static_cast<std::ptrdiff_t>(opening.panels.size());
  }

  void check_sleeves(const Piece& piece) {
    for (const auto& group : by_side(panels_of(piece, PanelKind::sleeve), "arm")) {
      const std::string& arm = group.first;
      const std::vector<int>& panels = group.second;
      const LimbsThrough wanted = arm == "left_arm" ? through_left_arm : through_right_arm;
      const bool has_opening = std::ranges::any_of(piece.openings, [&](const Opening* opening) {
        return opening->limbs == wanted && belongs_to(*opening, panels);
      });
      const Vec3 middle = cloth_of(panels).middle();
      const bool is_there = has_opening || nearest_part(middle, skeleton_) == arm;
      findings_.is_checked = true;
      if (is_there && goes_around(panels, arm, wanted)) continue;
      fail(arm, middle, in_words(arm));
    }
  }

  void check_trousers(const Piece& piece) {
    const std::vector<int> panels = panels_of(piece, PanelKind::trousers);
    if (panels.empty()) return;
    findings_.is_checked = true;
    for (const auto& [leg, half] : by_side(panels, "leg")) {
      const LimbsThrough wanted = leg == "left_leg" ? through_left_leg : through_right_leg;
      if (std::ranges::any_of(piece.openings,
                              [&](const Opening* o) { return o->limbs == wanted; })) {
        continue;
      }
      fail(leg, cloth_of(half).middle(), in_words(leg));
    }
  }

  /// The highest opening that both legs pass through, and no arm; null: none.
  const Opening* highest_around_trunk(const Piece& piece) const {
    const Opening* highest = nullptr;
    for (const Opening* opening : piece.openings) {
      if (opening->limbs != through_hem) continue;
      if (highest == nullptr || opening->middle.y() > highest->middle.y()) highest = opening;
    }
    return highest;
  }

  void check_trunk(const Piece& piece) {
    const bool is_top = has(piece, PanelKind::top);
    const bool is_bottom = has(piece, PanelKind::skirt) || has(piece, PanelKind::trousers);
    const Opening* highest = highest_around_trunk(piece);
    check_skirt(piece);
    if (std::ranges::any_of(piece.openings, [](const Opening* o) { return has_arm(*o); })) {
      findings_.is_checked = true;
      for (const Opening* opening : piece.openings) {
        if (opening->limbs == through_neckline) check_shoulders(*opening);
      }
      check_open_front(piece, highest != nullptr);
      return;
    }
    const Vec3 middle = cloth_of(piece.panels).middle();
    const std::string belongs = is_top ? "chest or shoulders" : "waist or hips";
    if (highest == nullptr) {
      if (!is_top && !is_bottom) return;
      // Of a stocking, leg openings were checked.
      if (std::ranges::any_of(piece.openings, [](const Opening* o) { return o->limbs.any(); })) {
        return;
      }
      findings_.is_checked = true;
      const bool is_sheet = piece.openings.size() == 1;
      const double height = middle.y();
      const bool is_near = height > (is_top ? waist_ : 0.5 * crotch_) && height < armpit_ + 0.3;
      const std::vector<int> panels(piece.panels.begin(), piece.panels.end());
      if (is_sheet && is_near && goes_around(panels, "torso", through_hem)) return;
      fail("torso", middle, belongs);
      return;
    }
    const double height = highest->middle.y();
    findings_.is_checked = true;
    double low = crotch_;
    double high = std::numeric_limits<double>::infinity();
    if (is_top) {
      low = waist_ + strapless_share * (armpit_ - waist_);
    } else if (is_bottom) {
      high = waist_ + max_skirt_top_share * (armpit_ - waist_);
    }
    if (height < low || height > high) {
      misplace("torso", place_on_body(highest->middle, skeleton_), belongs);
    }
  }

  void check_skirt(const Piece& piece) {
    const std::vector<int> panels = panels_of(piece, PanelKind::skirt);
    if (panels.empty() || goes_around(panels, "torso", through_hem)) return;
    fail("torso", cloth_of(panels).middle(), "waist or hips");
  }

  /// What hangs from the shoulders and has no hem around the trunk, as a cardigan has none.
  void check_open_front(const Piece& piece, bool has_hem) {
    const bool has_legs = std::ranges::any_of(
        piece.openings, [](const Opening* o) { return o->limbs == through_left_leg; });
    std::vector<int> panels;
    for (const int p : piece.panels) {
      if (kind(p) != PanelKind::sleeve) panels.push_back(p);
    }
    if (has_hem || has_legs || panels.empty()) return;
    if (goes_around(panels, "torso", through_hem)) return;
    fail("torso", cloth_of(panels).middle(), "chest or shoulders");
  }

  /// On each side the neckline's highest point is where the garment hangs. Straps that started
  /// within the shoulders and lie beyond them have slid off.
  void check_shoulders(const Opening& neckline) {
    for (const std::string side : {"left", "right"}) {
      const Vec3& shoulder = skeleton_.joint(side + "_shoulder");
      const double middle = skeleton_.joint("neck").x();
      const double reach = std::abs(shoulder.x() - middle);
      const double sign = side == "left" ? 1 : -1;
      int highest = -1;
      for (const int node : neckline.nodes) {
        if (sign * (nodes_[node].x() - middle) < 0) continue;
        if (highest < 0 || nodes_[node].y() > nodes_[highest].y()) highest = node;
      }
      if (highest < 0) continue;
      const double started = sign * (placed_[highest].x() - middle);
      const double lies = sign * (nodes_[highest].x() - middle);
      if (started > reach || lies < reach + slid_off_shoulder) continue;
      misplace(side + "_arm", place_on_body(nodes_[highest], skeleton_), side + " shoulder");
    }
  }

  /// A shirt around the waist has two armholes with nothing in them.
  void check_empty_openings(const Piece& piece) {
    const bool hangs =
        std::ranges::any_of(piece.openings, [](const Opening* o) { return has_arm(*o); });
    const bool has_neck = std::ranges::any_of(
        piece.openings, [](const Opening* o) { return o->limbs.left_arm && o->limbs.right_arm; });
    int empty = 0;
    double longest = 0;
    Vec3 at = Vec3::Zero();
    for (const Opening* opening : piece.openings) {
      if (opening->limbs.any() || opening->length < min_limb_opening) continue;
      ++empty;
      if (opening->length > longest) {
        longest = opening->length;
        at = opening->middle;
      }
    }
    if (empty == 0 || (hangs && has_neck)) return;
    if (piece.openings.size() == 1) return;  // a sheet
    if (empty == 1 && longest < min_neck_opening) return;
    if (empty == 1 && has(piece, PanelKind::skirt)) return;  // a cut-out
    fail(hangs ? "head" : "torso", at, hangs ? "neck" : "shoulders, with the arms in the armholes");
  }

  /// Middles of the panels that the sign of `side` sorts, from the negative to the positive ones.
  std::optional<Vec3> from_to(const Piece& piece, int (*side)(const std::string&)) const {
    Cloth negative;
    Cloth positive;
    for (const int p : piece.panels) {
      if (kind(p) == PanelKind::sleeve) continue;
      const int sign = side(garment_.panels[p].name);
      if (sign < 0) negative.add(cloth_[p]);
      if (sign > 0) positive.add(cloth_[p]);
    }
    if (negative.area == 0 || positive.area == 0) return std::nullopt;
    Vec3 across = positive.middle() - negative.middle();
    across.y() = 0;
    if (across.norm() < min_face_distance) return std::nullopt;
    return across.normalized();
  }

  void check_facing(const Piece& piece) {
    const auto check = [&](const std::optional<Vec3>& across, const Vec3& wanted,
                           const std::string& what) {
      if (!across || across->dot(wanted) >= min_facing_cosine) return;
      const double degrees = std::acos(std::clamp(across->dot(wanted), -1.0, 1.0)) * 180 / 3.14159;
      misplace("torso",
               "turned about the vertical by " + std::to_string(std::lround(degrees)) + " degrees",
               what);
    };
    check(from_to(piece, face_by_name), Vec3::UnitZ(), "its front before the body");
    check(from_to(piece, side_by_name), Vec3::UnitX(), "its left side at the wearer's left");
  }

  const PanelMesh& garment_;
  const DressedGarment& dressed_;
  const std::vector<Vec3>& nodes_;
  std::vector<Vec3> placed_;  // of each node, where one of its material points started
  const Skeleton& skeleton_;
  std::vector<Cloth> cloth_;  // per panel
  std::vector<Piece> pieces_;
  double crotch_ = 0;  // heights, metres
  double waist_ = 0;
  double armpit_ = 0;
  WearFindings findings_;
};

}  // namespace

std::string place_on_body(const Vec3& point, const Skeleton& skeleton) {
  const double height = point.y();
  const auto centimetres = [](double metres) {
    return std::to_string(std::lround(100 * metres)) + " cm";
  };
  if (height < 0) return "below the floor by " + centimetres(-height);
  const std::string part = nearest_part(point, skeleton);
  std::string name = in_words(part);
  const double waist = skeleton.joint("waist").y();
  if (part == "torso") {
    const double crotch = skeleton.joint("pelvis").y();
    const double armpit = skeleton.joint("chest").y();
    name = height < crotch                   ? "thighs"
           : height < 0.5 * (crotch + waist) ? "hips"
           : height < 0.5 * (waist + armpit) ? "waist"
           : height < armpit                 ? "chest"
                                             : "shoulders";
  } else if (part.ends_with("_leg")) {
    name = height < skeleton.joint("left_knee").y() ? "shins"
           : height < skeleton.joint("pelvis").y()  ? "thighs"
                                                    : "hips";
  }
  if (Bones(skeleton, part).distance(point) > beside_body) name = "beside the body";
  return name + ", " + centimetres(height) + " above the floor";
}

WearFindings check_worn(const PanelMesh& garment, const DressedGarment& dressed,
                        const Skeleton& skeleton) {
  if (!has_all_limbs(skeleton)) return {};
  return WornCheck(garment, dressed, skeleton).run();
}

}  // namespace toile
