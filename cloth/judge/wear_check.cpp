#include "cloth/judge/wear_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "cloth/ease/figure_errors.h"
#include "cloth/judge/constants.h"
#include "cloth/judge/hangs.h"
#include "cloth/judge/place_on_body.h"
#include "cloth/judge/sleeve_crown.h"
#include "cloth/judge/two_sides.h"
#include "cloth/judge/wraps.h"
#include "geometry/angles.h"
#include "geometry/body/bones.h"
#include "geometry/body/flaws.h"
#include "geometry/border_loops.h"
#include "geometry/triangle_area.h"
#include "io/text.h"
#include "pattern/classify/panel_class.h"

namespace toile {

namespace {

constexpr LimbsThrough through_left_arm{true, false, false, false};
constexpr LimbsThrough through_right_arm{false, true, false, false};
constexpr LimbsThrough through_left_leg{false, false, true, false};
constexpr LimbsThrough through_right_leg{false, false, false, true};

/// Whether the opening lets an arm through: what has it hangs from the shoulders.
bool has_arm(const Opening& opening) { return opening.limbs.left_arm || opening.limbs.right_arm; }

/// Panels and openings of one connected component of the garment, without layered panels.
struct Component {
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

class WearCheck {
 public:
  WearCheck(const PanelMesh& garment, const DressedGarment& dressed, const Skeleton& skeleton,
            const TriangleMesh* body)
      : garment_(garment),
        dressed_(dressed),
        nodes_(dressed.points),
        placed_(dressed.points),
        skeleton_(skeleton),
        body_(body),
        moments_(garment.panels.size()),
        hangs_(measure_hangs(garment, dressed, skeleton)) {
    findings_.openings = find_openings(garment, dressed, skeleton);
    if (body != nullptr) measure_passing(findings_.openings, *body, skeleton);
    const std::vector<int> component_of_node = connected_components(dressed);
    std::map<int, Component> components;
    for (std::size_t t = 0; t < dressed.triangles.size(); ++t) {
      const Triangle& corners = dressed.triangles[t];
      const int panel = dressed.panel_of_triangle[t];
      for (int i = 0; i < 3; ++i) placed_[corners[i]] = garment.placed[garment.triangles[t][i]];
      if (garment.panels[panel].layered) continue;
      components[component_of_node[corners[0]]].panels.insert(panel);
      const Vec3& a = dressed.points[corners[0]];
      const Vec3& b = dressed.points[corners[1]];
      const Vec3& c = dressed.points[corners[2]];
      const double area = triangle_area(a, b, c);
      moments_[panel].moment += area * (a + b + c) / 3;
      moments_[panel].area += area;
    }
    for (const Opening& opening : findings_.openings) {
      if (opening.is_cut_out && !opening.limbs.any()) continue;
      components[opening.component].openings.push_back(&opening);
    }
    for (auto& [number, component] : components) components_.push_back(std::move(component));
    crotch_ = skeleton.joint("pelvis").y();
    waist_ = skeleton.joint("waist").y();
    armpit_ = skeleton.joint("chest").y();
  }

  WearFindings run() {
    if (const auto seam = one_sided_seam(garment_, dressed_)) {
      misplace(BodyPart::torso,
               "its cloth has one side only; a stitch of its ring of panels '" + seam->first +
                   "' and '" + seam->second + "' runs the wrong way",
               "one side out, the other side in");
    }
    for (const Component& component : components_) check(component);
    return std::move(findings_);
  }

 private:
  PanelRole kind(int panel) const { return garment_.panels[panel].is.worn_as; }
  std::vector<int> panels_of(const Component& component, PanelRole wanted) const {
    std::vector<int> panels;
    for (const int p : component.panels) {
      if (kind(p) == wanted) panels.push_back(p);
    }
    return panels;
  }
  bool has(const Component& component, PanelRole wanted) const {
    return !panels_of(component, wanted).empty();
  }
  std::vector<int> without_sleeves(const Component& component) const {
    std::vector<int> panels;
    for (const int p : component.panels) {
      if (kind(p) != PanelRole::sleeve) panels.push_back(p);
    }
    return panels;
  }
  AreaMoment moment_of(const auto& panels) const {
    AreaMoment sum;
    for (const int p : panels) sum.add(moments_[p]);
    return sum;
  }
  /// Per panel of the garment, 1 for those given.
  std::vector<char> marked(const std::vector<int>& panels) const {
    std::vector<char> is_marked(garment_.panels.size(), 0);
    for (const int p : panels) is_marked[p] = 1;
    return is_marked;
  }
  /// Share of the directions around a part that the panels meet.
  double share_around(const std::vector<int>& panels, BodyPart part) const {
    return measure_wrap(dressed_, skeleton_, part, marked(panels)).fraction;
  }
  /// Whether a loop of the panels' border has these limbs through it.
  bool closes_around(const std::vector<int>& panels, const LimbsThrough& limbs) const {
    const std::vector<char> is_counted = marked(panels);
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
    return false;
  }
  /// Whether panels go around a part: closed, as a loop of their border tells, or as far as a
  /// cardigan does. Panels that do not reach it do not go around it.
  bool goes_around(const std::vector<int>& panels, BodyPart part, const LimbsThrough& limbs) const {
    if (closes_around(panels, limbs)) return true;
    return share_around(panels, part) >= around_share;
  }

  void misplace(BodyPart part, const std::string& at, const std::string& should_be) {
    findings_.is_checked = true;
    if (!findings_.misplaced) findings_.misplaced = Misplaced{part, at, should_be};
  }
  /// AreaMoment about `at` should go around `part`: misplaced if another part is nearer.
  void fail(BodyPart part, const Vec3& at, const std::string& should_be) {
    findings_.is_checked = true;
    if (part_near(skeleton_, at) != part) {
      misplace(part, place_on_body(at, skeleton_), should_be);
    } else if (std::ranges::find(findings_.unwrapped, part) == findings_.unwrapped.end()) {
      findings_.unwrapped.push_back(part);
    }
  }

  /// The lowest and the highest height of panels, by the given places of all nodes. Metres.
  std::array<double, 2> heights(const std::vector<Vec3>& nodes, const std::set<int>& panels) const {
    std::array<double, 2> found = {std::numeric_limits<double>::infinity(),
                                   -std::numeric_limits<double>::infinity()};
    for (std::size_t t = 0; t < dressed_.triangles.size(); ++t) {
      if (!panels.contains(dressed_.panel_of_triangle[t])) continue;
      for (const int node : dressed_.triangles[t]) {
        found = {std::min(found[0], nodes[node].y()), std::max(found[1], nodes[node].y())};
      }
    }
    return found;
  }

  /// Whether it lies at the floor without being worn. It is below all of where it was drafted to
  /// lie, or below the knees with no limb in it.
  bool has_fallen(const Component& component) const {
    const auto [lowest, highest] = heights(nodes_, component.panels);
    const double knee = skeleton_.joint("left_knee").y();
    const bool is_worn_there = std::ranges::any_of(
        component.openings, [](const Opening* opening) { return opening->limbs.any(); });
    return lowest < max_slid &&
           (highest < heights(placed_, component.panels)[0] || (highest < knee && !is_worn_there));
  }

  void check(const Component& component) {
    const Vec3 middle = moment_of(component.panels).middle();
    const std::size_t found = findings_.unwrapped.size();
    if (middle.y() < 0 || has_fallen(component)) {
      check_fallen(component);
      misplace(BodyPart::torso, place_on_body(middle, skeleton_), "on the body");
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

  /// Panels of sleeves or trousers, grouped by the limb that they are for. A part that was found by
  /// seams, or that the user asked for, beats the side that the pattern says. The sleeve's shape
  /// tells whether it is right there: names of mirrored pieces are often exchanged in drawings.
  std::map<BodyPart, std::vector<int>> by_limb(const std::vector<int>& panels,
                                               BodyPart (*limb_of)(bool)) const {
    std::map<BodyPart, std::vector<int>> groups;
    for (const int p : panels) {
      const PanelClass& is = garment_.panels[p].is;
      const bool is_found = is.part.by == PanelSource::seams || is.part.by == PanelSource::asked;
      int side = is_found ? side_of(is.part) : 0;
      if (side == 0) side = side_sign(is);
      if (side == 0) side = placed_side(garment_.panels[p]);
      groups[limb_of(side > 0)].push_back(p);
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

  void check_sleeves(const Component& component) {
    const std::vector<int> rest = without_sleeves(component);
    for (const auto& group : by_limb(panels_of(component, PanelRole::sleeve), arm_of)) {
      const BodyPart arm = group.first;
      const std::vector<int>& panels = group.second;
      const LimbsThrough wanted = arm == BodyPart::left_arm ? through_left_arm : through_right_arm;
      const bool has_opening = std::ranges::any_of(component.openings, [&](const Opening* opening) {
        return opening->limbs == wanted && belongs_to(*opening, panels);
      });
      const Vec3 middle = moment_of(panels).middle();
      const bool is_there = has_opening || part_near(skeleton_, middle) == arm;
      findings_.is_checked = true;
      if (!is_there || !goes_around(panels, arm, wanted)) {
        fail(arm, middle, in_words(arm));
      } else if (is_set_in_upside_down(garment_, dressed_, panels, rest, component.openings,
                                       wanted)) {
        misplace(arm, "the sleeve is upside down, its crown at the armpit",
                 "the sleeve's crown at the shoulder");
      }
    }
  }

  void check_trousers(const Component& component) {
    const std::vector<int> panels = panels_of(component, PanelRole::trousers);
    if (panels.empty()) return;
    findings_.is_checked = true;
    for (const auto& [leg, half] : by_limb(panels, leg_of)) {
      const LimbsThrough wanted = leg == BodyPart::left_leg ? through_left_leg : through_right_leg;
      if (std::ranges::any_of(component.openings,
                              [&](const Opening* o) { return o->limbs == wanted; })) {
        continue;
      }
      fail(leg, moment_of(half).middle(), in_words(leg));
    }
  }

  /// The highest opening that both legs pass through, and no arm; null: none.
  const Opening* highest_around_trunk(const Component& component) const {
    const Opening* highest = nullptr;
    for (const Opening* opening : component.openings) {
      if (opening->limbs != through_hem) continue;
      if (highest == nullptr || opening->middle.y() > highest->middle.y()) highest = opening;
    }
    return highest;
  }

  /// A collar or a hood reaches the shoulders, wherever the rest of it hangs.
  void check_headwear(const Component& component) {
    for (const int panel : component.panels) {
      if (!garment_.panels[panel].is.is_headwear()) continue;
      findings_.is_checked = true;
      if (heights(nodes_, {panel})[1] > armpit_) continue;
      misplace(BodyPart::torso,
               "panel '" + garment_.panels[panel].name + "' is at the " +
                   place_on_body(moments_[panel].middle(), skeleton_),
               "neck or head");
    }
  }

  void check_trunk(const Component& component) {
    const bool is_top = has(component, PanelRole::bodice);
    const bool is_bottom = has(component, PanelRole::skirt) || has(component, PanelRole::trousers);
    const Opening* highest = highest_around_trunk(component);
    check_skirt(component);
    if (std::ranges::any_of(component.openings, [](const Opening* o) { return has_arm(*o); })) {
      findings_.is_checked = true;
      for (const Opening* opening : component.openings) {
        if (opening->limbs == through_neckline) check_shoulders(*opening);
      }
      check_open_front(component, highest != nullptr);
      return;
    }
    const Vec3 middle = moment_of(component.panels).middle();
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
      const bool is_near = height > (is_top ? waist_ : min_sheet_share * crotch_) &&
                           height < armpit_ + max_sheet_rise;
      const std::vector<int> panels(component.panels.begin(), component.panels.end());
      if (is_sheet && is_near && goes_around(panels, BodyPart::torso, through_hem)) return;
      fail(BodyPart::torso, middle, belongs);
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
    const bool is_on_thighs = !is_top && is_bottom && down_the_thighs(highest->middle) > 0;
    check_slid(*highest, is_top ? belongs : "its top edge where it was drafted to lie", is_top);
    if (height < low || height > high || is_on_thighs) {
      misplace(BodyPart::torso, place_on_body(highest->middle, skeleton_), belongs);
    }
  }

  /// What hangs from waist, hips or chest is misplaced where its top edge left its level by more
  /// than the bound.
  void check_slid(const Opening& top, const std::string& belongs, bool is_top) {
    const Slid slid = slid_of(top, is_top);
    if (findings_.slid && findings_.slid->down >= slid.down) return;
    findings_.slid = slid;
    if (slid.down <= max_slid) return;
    misplace(BodyPart::torso, place_on_body(top.middle, skeleton_) + ": it " + text_of(slid),
             belongs);
  }
  /// Cloth at the feet may have no edge around the trunk any more. It slid all the same: by what
  /// the edge came down that was drafted to lie highest.
  void check_fallen(const Component& component) {
    if (std::ranges::any_of(component.openings, [](const Opening* o) { return has_arm(*o); })) {
      return;
    }
    const auto top = std::ranges::max_element(component.openings, {}, &Opening::drafted);
    if (top == component.openings.end()) return;
    const Slid slid = slid_of(**top, has(component, PanelRole::bodice));
    if (slid.down > max_slid) findings_.slid = slid;
  }
  Slid slid_of(const Opening& top, bool is_top) const {
    Slid slid;
    slid.down = (is_top ? top.drafted : std::min(top.drafted, waist_)) - top.middle.y();
    slid.length = top.length;
    slid.error = height_error(garment_.edge_length);
    if (slid.down > 0 && slid.is_far()) slid.hip = hip();
    return slid;
  }
  /// Metres: the body's largest girth between crotch and waist; 0 without a body.
  double hip() const {
    if (body_ == nullptr) return 0;
    return largest_girth(*body_, crotch_ + (waist_ - crotch_) / trunk_stations, waist_);
  }

  /// Of a body that sits: metres that a point lies farther down the thighs than the crotch. What
  /// lies on level thighs is as high as the hips. 0 unless both thighs are nearer to level than to
  /// upright.
  double down_the_thighs(const Vec3& point) const {
    const auto thigh = [&](const std::string& side) {
      return Vec3((skeleton_.joint(side + "knee") - skeleton_.joint(side + "hip")).normalized());
    };
    const Vec3 left = thigh("left_");
    const Vec3 right = thigh("right_");
    if (std::max(-left.y(), -right.y()) > std::sqrt(0.5)) return 0;
    const Vec3 hips = (skeleton_.joint("left_hip") + skeleton_.joint("right_hip")) / 2;
    return (left + right).normalized().dot(point - hips) - (hips.y() - crotch_);
  }

  void check_skirt(const Component& component) {
    const std::vector<int> panels = panels_of(component, PanelRole::skirt);
    if (panels.empty() || goes_around(panels, BodyPart::torso, through_hem)) return;
    if (!is_apron(component)) fail(BodyPart::torso, moment_of(panels).middle(), "waist or hips");
  }

  /// Whether a garment covers one side of the trunk, as an apron does. No arm passes through an
  /// opening of its own. Its edges lie where they were drafted to, so something holds them there.
  bool is_apron(const Component& component) const {
    for (const Opening* opening : component.openings) {
      if (opening->limbs.left_arm != opening->limbs.right_arm) return false;
      // What closes around the trunk somewhere is a skirt that lacks a panel.
      if (opening->limbs == through_hem) return false;
      if (std::abs(opening->drafted - opening->middle.y()) > max_slid) return false;
    }
    const std::vector<int> panels(component.panels.begin(), component.panels.end());
    return share_around(panels, BodyPart::torso) >= open_front_share;
  }

  /// Whether a garment that hangs from both shoulders is open by its seams, in front or at the
  /// back. The trunk closes around each arm then. A shirt that lacks a panel at one shoulder does
  /// not close there, though its sleeve does.
  bool is_open_by_its_seams(const std::vector<int>& panels) const {
    for (const LimbsThrough& arm : {through_left_arm, through_right_arm}) {
      if (!closes_around(panels, arm)) return false;
    }
    return share_around(panels, BodyPart::torso) >= open_front_share;
  }

  /// What hangs from the shoulders and has no hem around the trunk, as a cardigan has none.
  void check_open_front(const Component& component, bool has_hem) {
    const bool has_legs = std::ranges::any_of(
        component.openings, [](const Opening* o) { return o->limbs == through_left_leg; });
    const std::vector<int> panels = without_sleeves(component);
    if (panels.empty()) return;
    if (has_hem || has_legs) {
      if (const Opening* hem = hem_at_armhole(component)) {
        fail(BodyPart::torso, hem->middle, "chest or shoulders");
      }
      find_bare_level(component);
      return;
    }
    if (is_open_by_its_seams(panels) || is_apron(component)) return;
    if (goes_around(panels, BodyPart::torso, through_hem)) return;
    fail(BodyPart::torso, moment_of(panels).middle(), "chest or shoulders");
  }

  /// The hem that climbs to a sleeve, or null. Front and back are not sewn at the sides then: only
  /// the sleeve's seam holds them together below the arm. A tabard has no sleeves.
  const Opening* hem_at_armhole(const Component& component) const {
    std::vector<char> at_sleeve(nodes_.size(), 0);
    for (std::size_t t = 0; t < dressed_.triangles.size(); ++t) {
      if (kind(dressed_.panel_of_triangle[t]) != PanelRole::sleeve) continue;
      for (const int node : dressed_.triangles[t]) at_sleeve[node] = 1;
    }
    for (const Opening* opening : component.openings) {
      if (opening->limbs != through_hem) continue;
      double low = std::numeric_limits<double>::infinity();
      double sleeve = -low;
      for (const int node : opening->nodes) {
        low = std::min(low, nodes_[node].y());
        if (at_sleeve[node] != 0) sleeve = std::max(sleeve, nodes_[node].y());
      }
      if (sleeve > low + min_slit) return opening;
    }
    return nullptr;
  }

  /// What is closed about the hips and reaches the shoulders covers the trunk between waist and
  /// armpits, above its hem.
  void find_bare_level(const Component& component) {
    double low = waist_;
    for (const Opening* opening : component.openings) {
      if (opening->limbs != through_hem) continue;
      for (const int node : opening->nodes) low = std::max(low, nodes_[node].y());
    }
    const std::vector<int> panels(component.panels.begin(), component.panels.end());
    const BareLevel barest = barest_level(dressed_, skeleton_, marked(panels), low, armpit_);
    if (barest.share < around_share) findings_.bare = barest;
  }

  /// Cloth that is folded upon itself, and panels that hang the other way up than they are placed.
  /// Sleeves hang as their arms do.
  void check_hangs(const Component& component) {
    PanelHang all;
    int most = -1;
    const std::vector<int> panels = without_sleeves(component);
    for (const int p : panels) {
      all.area += hangs_[p].area;
      all.folded += hangs_[p].folded;
      if (most < 0 || hangs_[p].folded > hangs_[most].folded) most = p;
    }
    if (all.folded > max_folded * all.area) {
      misplace(BodyPart::torso,
               std::to_string(std::lround(100 * all.folded / all.area)) +
                   " % of its cloth hangs upside down in a fold, of panel '" +
                   garment_.panels[most].name + "' the most",
               "its cloth without a fold all around");
    }
    for (const int p : panels) {
      const bool is_stated = garment_.has_places || garment_.panels[p].placement.by_part();
      if (is_stated && hangs_[p].is_turned()) findings_.turned.push_back(garment_.panels[p].name);
    }
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
      misplace(arm_of(side == "left"), place_on_body(nodes_[highest], skeleton_),
               side + " shoulder");
    }
  }

  /// A shirt around the waist has two armholes with nothing in them.
  void check_empty_openings(const Component& component) {
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
    if (empty == 1 && has(component, PanelRole::skirt)) return;  // a cut-out
    fail(hangs ? BodyPart::head : BodyPart::torso, at,
         hangs ? "neck" : "shoulders, with the arms in the armholes");
  }

  /// Middles of the panels that `sign_of` sorts, from the negative to the positive ones.
  std::optional<Vec3> from_to(const Component& component, int (*sign_of)(const PanelClass&)) const {
    AreaMoment negative;
    AreaMoment positive;
    for (const int p : component.panels) {
      if (kind(p) == PanelRole::sleeve) continue;
      const int sign = sign_of(garment_.panels[p].is);
      if (sign < 0) negative.add(moments_[p]);
      if (sign > 0) positive.add(moments_[p]);
    }
    if (negative.area == 0 || positive.area == 0) return std::nullopt;
    Vec3 across = positive.middle() - negative.middle();
    across.y() = 0;
    if (across.norm() < min_face_distance) return std::nullopt;
    return across.normalized();
  }

  /// Sides tell a quarter of a turn. A drawing shows one of a pair, and names say as often what the
  /// viewer sees: so nobody knows which is the left one.
  void check_facing(const Component& component) {
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
    check(from_to(component, face_sign), Vec3::UnitZ(), false, "its front before the body");
    check(from_to(component, side_sign), Vec3::UnitX(), true, "its left and right at the sides");
  }

  const PanelMesh& garment_;
  const DressedGarment& dressed_;
  const std::vector<Vec3>& nodes_;
  std::vector<Vec3> placed_;  // of each node, where one of its material points started
  const Skeleton& skeleton_;
  const TriangleMesh* body_;
  std::vector<AreaMoment> moments_;  // per panel
  std::vector<PanelHang> hangs_;     // per panel
  std::vector<Component> components_;
  double crotch_ = 0;  // heights, metres
  double waist_ = 0;
  double armpit_ = 0;
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
