#include "cloth/judge/wear_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cloth/ease/figure_errors.h"
#include "cloth/judge/constants.h"
#include "cloth/judge/place_on_body.h"
#include "cloth/judge/sleeve_crown.h"
#include "cloth/judge/two_sides.h"
#include "cloth/judge/worn_garment.h"
#include "geometry/angles.h"
#include "geometry/body/bones.h"
#include "geometry/body/flaws.h"
#include "io/text.h"

namespace toile {

namespace {

/// Whether the opening lets an arm through: what has it hangs from the shoulders.
bool has_arm(const Opening& opening) { return opening.limbs.left_arm || opening.limbs.right_arm; }

/// The rules.
class WearCheck {
 public:
  WearCheck(const PanelMesh& garment, const DressedGarment& dressed, const Skeleton& skeleton,
            const TriangleMesh* body)
      : worn_(garment, dressed, skeleton, body), body_(body) {}

  WearFindings run() {
    if (const auto seam = one_sided_seam(worn_.garment, worn_.dressed)) {
      misplace(BodyPart::torso,
               "its cloth has one side only; a stitch of its ring of panels '" + seam->first +
                   "' and '" + seam->second + "' runs the wrong way",
               "one side out, the other side in");
    }
    for (const WornComponent& component : worn_.components) check(component);
    findings_.openings = std::move(worn_.openings);
    return std::move(findings_);
  }

 private:
  void misplace(BodyPart part, const std::string& at, const std::string& should_be) {
    findings_.is_checked = true;
    if (!findings_.misplaced) findings_.misplaced = Misplaced{part, at, should_be};
  }
  /// Cloth about `at` should go around `part`: misplaced if another part is nearer.
  void fail(BodyPart part, const Vec3& at, const std::string& should_be) {
    findings_.is_checked = true;
    if (part_near(worn_.skeleton, at) != part) {
      misplace(part, place_on_body(at, worn_.skeleton), should_be);
    } else if (std::ranges::find(findings_.unwrapped, part) == findings_.unwrapped.end()) {
      findings_.unwrapped.push_back(part);
    }
  }

  /// Whether it lies at the floor without being worn. It is below all of where it was drafted to
  /// lie, or below the knees with no limb in it.
  bool has_fallen(const WornComponent& component) const {
    const auto [lowest, highest] = worn_.heights(worn_.nodes, component.panels);
    const double knee = worn_.skeleton.joint("left_knee").y();
    const bool is_worn_there = std::ranges::any_of(
        component.openings, [](const Opening* opening) { return opening->limbs.any(); });
    return lowest < max_slid && (highest < worn_.heights(worn_.placed, component.panels)[0] ||
                                 (highest < knee && !is_worn_there));
  }

  void check(const WornComponent& component) {
    const Vec3 middle = worn_.moment_of(component.panels).middle();
    const std::size_t found = findings_.unwrapped.size();
    if (middle.y() < 0 || has_fallen(component)) {
      check_fallen(component);
      misplace(BodyPart::torso, place_on_body(middle, worn_.skeleton), "on the body");
      return;
    }
    check_sleeves(component);
    check_trousers(component);
    check_trunk(component);
    check_headwear(component);
    check_hangs(component);
    if (findings_.misplaced || findings_.unwrapped.size() > found) {
      if (!findings_.slid) check_fallen(component);
      return;
    }
    check_empty_openings(component);
    check_facing(component);
  }

  void check_sleeves(const WornComponent& component) {
    const std::vector<int> rest = worn_.without_sleeves(component);
    for (const auto& group : worn_.by_limb(worn_.panels_of(component, PanelRole::sleeve), arm_of)) {
      const BodyPart arm = group.first;
      const std::vector<int>& panels = group.second;
      const LimbsThrough wanted = arm == BodyPart::left_arm ? through_left_arm : through_right_arm;
      const bool has_opening = std::ranges::any_of(component.openings, [&](const Opening* opening) {
        return opening->limbs == wanted && worn_.belongs_to(*opening, panels);
      });
      const Vec3 middle = worn_.moment_of(panels).middle();
      const bool is_there = has_opening || part_near(worn_.skeleton, middle) == arm;
      findings_.is_checked = true;
      if (!is_there || !worn_.goes_around(panels, arm, wanted)) {
        fail(arm, middle, in_words(arm));
      } else if (is_set_in_upside_down(worn_.garment, worn_.dressed, panels, rest,
                                       component.openings, wanted)) {
        misplace(arm, "the sleeve is upside down, its crown at the armpit",
                 "the sleeve's crown at the shoulder");
      }
    }
  }

  void check_trousers(const WornComponent& component) {
    const std::vector<int> panels = worn_.panels_of(component, PanelRole::trousers);
    if (panels.empty()) return;
    findings_.is_checked = true;
    for (const auto& [leg, half] : worn_.by_limb(panels, leg_of)) {
      const LimbsThrough wanted = leg == BodyPart::left_leg ? through_left_leg : through_right_leg;
      if (std::ranges::any_of(component.openings,
                              [&](const Opening* o) { return o->limbs == wanted; })) {
        continue;
      }
      fail(leg, worn_.moment_of(half).middle(), in_words(leg));
    }
  }

  /// A collar or a hood reaches the shoulders, wherever the rest of it hangs.
  void check_headwear(const WornComponent& component) {
    for (const int panel : component.panels) {
      if (!worn_.garment.panels[panel].is.is_headwear()) continue;
      findings_.is_checked = true;
      if (worn_.heights(worn_.nodes, {panel})[1] > worn_.armpit) continue;
      misplace(BodyPart::torso,
               "panel '" + worn_.garment.panels[panel].name + "' is at the " +
                   place_on_body(worn_.moments[panel].middle(), worn_.skeleton),
               "neck or head");
    }
  }

  void check_trunk(const WornComponent& component) {
    const bool is_top = worn_.has(component, PanelRole::bodice);
    const bool is_bottom =
        worn_.has(component, PanelRole::skirt) || worn_.has(component, PanelRole::trousers);
    const Opening* highest = worn_.highest_around_trunk(component);
    check_skirt(component);
    if (std::ranges::any_of(component.openings, [](const Opening* o) { return has_arm(*o); })) {
      findings_.is_checked = true;
      for (const Opening* opening : component.openings) {
        if (opening->limbs == through_neckline) check_shoulders(*opening);
      }
      check_open_front(component, highest != nullptr);
      return;
    }
    const Vec3 middle = worn_.moment_of(component.panels).middle();
    const std::string belongs = is_top ? "chest or shoulders" : "waist or hips";
    if (highest == nullptr) {
      if (!is_top && !is_bottom) return;
      // Of a stocking, leg openings were checked.
      if (std::ranges::any_of(component.openings,
                              [](const Opening* o) { return o->limbs.any(); })) {
        return;
      }
      findings_.is_checked = true;
      if (is_apron(component)) return;
      const bool is_sheet = component.openings.size() == 1;
      const double height = middle.y();
      const bool is_near = height > (is_top ? worn_.waist : min_sheet_share * worn_.crotch) &&
                           height < worn_.armpit + max_sheet_rise;
      const std::vector<int> panels(component.panels.begin(), component.panels.end());
      if (is_sheet && is_near && worn_.goes_around(panels, BodyPart::torso, through_hem)) return;
      fail(BodyPart::torso, middle, belongs);
      return;
    }
    const double height = highest->middle.y();
    findings_.is_checked = true;
    double low = worn_.crotch;
    double high = std::numeric_limits<double>::infinity();
    if (is_top) {
      low = worn_.waist + strapless_share * (worn_.armpit - worn_.waist);
    } else if (is_bottom) {
      high = worn_.waist + max_skirt_top_share * (worn_.armpit - worn_.waist);
    }
    const bool is_on_thighs = !is_top && is_bottom && down_the_thighs(highest->middle) > 0;
    check_slid(*highest, is_top ? belongs : "its top edge where it was drafted to lie", is_top);
    if (height < low || height > high || is_on_thighs) {
      misplace(BodyPart::torso, place_on_body(highest->middle, worn_.skeleton), belongs);
    }
  }

  /// What hangs from waist, hips or chest is misplaced where its top edge left its level by more
  /// than the bound.
  void check_slid(const Opening& top, const std::string& belongs, bool is_top) {
    const Slid slid = slid_of(top, is_top);
    if (findings_.slid && findings_.slid->down >= slid.down) return;
    findings_.slid = slid;
    if (slid.down <= max_slid) return;
    misplace(BodyPart::torso, place_on_body(top.middle, worn_.skeleton) + ": it " + text_of(slid),
             belongs);
  }
  /// Cloth at the feet may have no edge around the trunk any more. It slid all the same: by what
  /// the edge came down that was drafted to lie highest.
  void check_fallen(const WornComponent& component) {
    if (std::ranges::any_of(component.openings, [](const Opening* o) { return has_arm(*o); })) {
      return;
    }
    const auto top = std::ranges::max_element(component.openings, {}, &Opening::drafted);
    if (top == component.openings.end()) return;
    const Slid slid = slid_of(**top, worn_.has(component, PanelRole::bodice));
    if (slid.down > max_slid) findings_.slid = slid;
  }
  Slid slid_of(const Opening& top, bool is_top) const {
    Slid slid;
    slid.down = (is_top ? top.drafted : std::min(top.drafted, worn_.waist)) - top.middle.y();
    slid.length = top.length;
    slid.error = height_error(worn_.garment.edge_length);
    if (slid.down > 0 && slid.is_far()) slid.hip = hip();
    return slid;
  }
  /// Metres: the body's largest girth between crotch and waist; 0 without a body.
  double hip() const {
    if (body_ == nullptr) return 0;
    return largest_girth(*body_, worn_.crotch + (worn_.waist - worn_.crotch) / trunk_stations,
                         worn_.waist);
  }

  /// Of a body that sits: metres that a point lies farther down the thighs than the crotch. What
  /// lies on level thighs is as high as the hips. 0 unless both thighs are nearer to level than to
  /// upright.
  double down_the_thighs(const Vec3& point) const {
    const auto thigh = [&](const std::string& side) {
      return Vec3(
          (worn_.skeleton.joint(side + "knee") - worn_.skeleton.joint(side + "hip")).normalized());
    };
    const Vec3 left = thigh("left_");
    const Vec3 right = thigh("right_");
    if (std::max(-left.y(), -right.y()) > std::sqrt(0.5)) return 0;
    const Vec3 hips = (worn_.skeleton.joint("left_hip") + worn_.skeleton.joint("right_hip")) / 2;
    return (left + right).normalized().dot(point - hips) - (hips.y() - worn_.crotch);
  }

  void check_skirt(const WornComponent& component) {
    const std::vector<int> panels = worn_.panels_of(component, PanelRole::skirt);
    if (panels.empty() || worn_.goes_around(panels, BodyPart::torso, through_hem)) return;
    if (!is_apron(component))
      fail(BodyPart::torso, worn_.moment_of(panels).middle(), "waist or hips");
  }

  /// Whether a garment covers one side of the trunk, as an apron does. No arm passes through an
  /// opening of its own. Its edges lie where they were drafted to, so something holds them there.
  bool is_apron(const WornComponent& component) const {
    for (const Opening* opening : component.openings) {
      if (opening->limbs.left_arm != opening->limbs.right_arm) return false;
      // What closes around the trunk somewhere is a skirt that lacks a panel.
      if (opening->limbs == through_hem) return false;
      if (std::abs(opening->drafted - opening->middle.y()) > max_slid) return false;
    }
    const std::vector<int> panels(component.panels.begin(), component.panels.end());
    return worn_.share_around(panels, BodyPart::torso) >= open_front_share;
  }

  /// Whether a garment that hangs from both shoulders is open by its seams, in front or at the
  /// back. The trunk closes around each arm then. A shirt that lacks a panel at one shoulder does
  /// not close there, though its sleeve does.
  bool is_open_by_its_seams(const std::vector<int>& panels) const {
    for (const LimbsThrough& arm : {through_left_arm, through_right_arm}) {
      if (!worn_.closes_around(panels, arm)) return false;
    }
    return worn_.share_around(panels, BodyPart::torso) >= open_front_share;
  }

  /// What hangs from the shoulders and has no hem around the trunk, as a cardigan has none.
  void check_open_front(const WornComponent& component, bool has_hem) {
    const bool has_legs = std::ranges::any_of(
        component.openings, [](const Opening* o) { return o->limbs == through_left_leg; });
    const std::vector<int> panels = worn_.without_sleeves(component);
    if (panels.empty()) return;
    if (has_hem || has_legs) {
      if (const Opening* hem = hem_at_armhole(component)) {
        fail(BodyPart::torso, hem->middle, "chest or shoulders");
      }
      find_bare_level(component);
      return;
    }
    if (is_open_by_its_seams(panels) || is_apron(component)) return;
    if (worn_.goes_around(panels, BodyPart::torso, through_hem)) return;
    fail(BodyPart::torso, worn_.moment_of(panels).middle(), "chest or shoulders");
  }

  /// The hem that climbs to a sleeve, or null. Front and back are not sewn at the sides then: only
  /// the sleeve's seam holds them together below the arm. A tabard has no sleeves.
  const Opening* hem_at_armhole(const WornComponent& component) const {
    std::vector<char> at_sleeve(worn_.nodes.size(), 0);
    for (std::size_t t = 0; t < worn_.dressed.triangles.size(); ++t) {
      if (worn_.kind(worn_.dressed.panel_of_triangle[t]) != PanelRole::sleeve) continue;
      for (const int node : worn_.dressed.triangles[t]) at_sleeve[node] = 1;
    }
    for (const Opening* opening : component.openings) {
      if (opening->limbs != through_hem) continue;
      double low = std::numeric_limits<double>::infinity();
      double sleeve = -low;
      for (const int node : opening->nodes) {
        low = std::min(low, worn_.nodes[node].y());
        if (at_sleeve[node] != 0) sleeve = std::max(sleeve, worn_.nodes[node].y());
      }
      if (sleeve > low + min_slit) return opening;
    }
    return nullptr;
  }

  /// What is closed about the hips and reaches the shoulders covers the trunk between waist and
  /// armpits, above its hem.
  void find_bare_level(const WornComponent& component) {
    double low = worn_.waist;
    for (const Opening* opening : component.openings) {
      if (opening->limbs != through_hem) continue;
      for (const int node : opening->nodes) low = std::max(low, worn_.nodes[node].y());
    }
    const std::vector<int> panels(component.panels.begin(), component.panels.end());
    const BareLevel barest =
        barest_level(worn_.dressed, worn_.skeleton, worn_.marked(panels), low, worn_.armpit);
    if (barest.share < around_share) findings_.bare = barest;
  }

  /// Cloth that is folded upon itself, and panels that hang the other way up than they are placed.
  /// Sleeves hang as their arms do.
  void check_hangs(const WornComponent& component) {
    PanelHang all;
    int most = -1;
    const std::vector<int> panels = worn_.without_sleeves(component);
    for (const int p : panels) {
      all.area += worn_.hangs[p].area;
      all.folded += worn_.hangs[p].folded;
      if (most < 0 || worn_.hangs[p].folded > worn_.hangs[most].folded) most = p;
    }
    if (all.folded > max_folded * all.area) {
      misplace(BodyPart::torso,
               std::to_string(std::lround(100 * all.folded / all.area)) +
                   " % of its cloth hangs upside down in a fold, of panel '" +
                   worn_.garment.panels[most].name + "' the most",
               "its cloth without a fold all around");
    }
    for (const int p : panels) {
      const bool is_stated =
          worn_.garment.has_places || worn_.garment.panels[p].placement.by_part();
      if (is_stated && worn_.hangs[p].is_turned())
        findings_.turned.push_back(worn_.garment.panels[p].name);
    }
  }

  /// On each side the neckline's highest point is where the garment hangs. Straps that started
  /// within the shoulders and lie beyond them have slid off.
  void check_shoulders(const Opening& neckline) {
    for (const std::string side : {"left", "right"}) {
      const Vec3& shoulder = worn_.skeleton.joint(side + "_shoulder");
      const double middle = worn_.skeleton.joint("neck").x();
      const double reach = std::abs(shoulder.x() - middle);
      const double sign = side == "left" ? 1 : -1;
      int highest = -1;
      for (const int node : neckline.nodes) {
        if (sign * (worn_.nodes[node].x() - middle) < 0) continue;
        if (highest < 0 || worn_.nodes[node].y() > worn_.nodes[highest].y()) highest = node;
      }
      if (highest < 0) continue;
      const double started = sign * (worn_.placed[highest].x() - middle);
      const double lies = sign * (worn_.nodes[highest].x() - middle);
      if (started > reach || lies < reach + slid_off_shoulder) continue;
      misplace(arm_of(side == "left"), place_on_body(worn_.nodes[highest], worn_.skeleton),
               side + " shoulder");
    }
  }

  /// A shirt around the waist has two armholes with nothing in them.
  void check_empty_openings(const WornComponent& component) {
    const bool hangs =
        std::ranges::any_of(component.openings, [](const Opening* o) { return has_arm(*o); });
    const bool has_neck = std::ranges::any_of(component.openings, [](const Opening* o) {
      return o->limbs.left_arm && o->limbs.right_arm;
    });
    int empty = 0;
    double longest = 0;
    Vec3 at = Vec3::Zero();
    for (const Opening* opening : component.openings) {
      if (opening->limbs.any() || opening->length < min_limb_opening) continue;
      ++empty;
      if (opening->length > longest) {
        longest = opening->length;
        at = opening->middle;
      }
    }
    if (empty == 0 || (hangs && has_neck)) return;
    if (component.openings.size() == 1) return;  // a sheet
    if (empty == 1 && longest < min_neck_opening) return;
    if (empty == 1 && worn_.has(component, PanelRole::skirt)) return;  // a cut-out
    fail(hangs ? BodyPart::head : BodyPart::torso, at,
         hangs ? "neck" : "shoulders, with the arms in the armholes");
  }

  /// Sides tell a quarter of a turn. A drawing shows one of a pair, and names say as often what the
  /// viewer sees: so nobody knows which is the left one.
  void check_facing(const WornComponent& component) {
    const auto check = [&](const std::optional<Vec3>& across, const Vec3& wanted, bool either,
                           const std::string& what) {
      if (!across) return;
      const double along = across->dot(wanted);
      if ((either ? std::abs(along) : along) >= min_facing_cosine) return;
      const double degrees = to_degrees(std::acos(std::clamp(along, -1.0, 1.0)));
      misplace(BodyPart::torso,
               "turned about the vertical by " + std::to_string(std::lround(degrees)) + " degrees",
               what);
    };
    check(worn_.level_direction(component, face_sign), Vec3::UnitZ(), false,
          "its front before the body");
    check(worn_.level_direction(component, side_sign), Vec3::UnitX(), true,
          "its left and right at the sides");
  }

  WornGarment worn_;
  const TriangleMesh* body_;
  WearFindings findings_;
};

}  // namespace

bool Slid::is_far() const { return std::abs(down) >= std::max(worth_saying_slid, error); }

std::string text_of(const Slid& slid) {
  std::string text = std::string(slid.down > 0 ? "slid down by " : "rode up by ") +
                     centimetres(std::abs(slid.down), 0);
  if (slid.down > 0) text += ": its top edge is cut " + centimetres(slid.length, 0) + " long";
  if (slid.hip > 0) text += ", the hips are " + centimetres(slid.hip, 0);
  return text;
}

WearFindings check_worn(const PanelMesh& garment, const DressedGarment& dressed,
                        const Skeleton& skeleton, const TriangleMesh* body) {
  if (!has_all_limbs(skeleton)) return {};
  return WearCheck(garment, dressed, skeleton, body).run();
}

}  // namespace toile
