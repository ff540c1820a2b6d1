#include "cloth/start/find_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "cloth/start/around_panels.h"
#include "cloth/start/body_sizes.h"
#include "cloth/start/constants.h"
#include "cloth/start/flat_layout.h"
#include "cloth/start/worn_layout.h"
#include "geometry/angles.h"
#include "geometry/body/bones.h"
#include "geometry/body/limbs_through.h"
#include "geometry/disjoint_sets.h"
#include "geometry/error.h"
#include "pattern/classify/panel_class.h"

namespace toile {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Whether a part is more than a guess by words. Those of mirrored pieces are often exchanged in
/// drawings, so that seams tell better.
bool is_told(const Told<BodyPart>& part) {
  return part.by != PanelSource::none && part.by != PanelSource::name &&
         part.by != PanelSource::label;
}

/// Panels that are sewn together, directly or through others.
class Component {
 public:
  Component(const PanelMesh& garment, const Skeleton& skeleton, const BodySizes& sizes,
            const AskedPlaces& asked, std::vector<int> panels)
      : garment_(garment),
        skeleton_(skeleton),
        sizes_(sizes),
        asked_(asked),
        panels_(std::move(panels)),
        panel_of_(panel_of_points(garment)) {}

  /// Places the panels. Returns those of the legs of trousers.
  std::vector<int> place(std::vector<Vec3>& placed, std::vector<FoundPlace>& found,
                         std::vector<MeshedPanel>& meshed);

 private:
  const MeshedPanel& panel(int p) const { return garment_.panels[p]; }
  bool is_sleeve(int p) const { return panel(p).is.worn_as == PanelRole::sleeve; }
  bool is_hood(int p) const { return panel(p).is.role == PanelRole::hood; }
  const AskedPlace* asked(int p) const {
    const auto it = asked_.find(panel(p).name);
    return it == asked_.end() ? nullptr : &it->second;
  }
  /// The number of a panel in the layout; none: it is not there.
  std::optional<std::size_t> in_layout(int p) const {
    const auto found = std::ranges::find(flat_, p);
    if (found == flat_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - flat_.begin());
  }
  std::optional<bool> named_back(int p) const;
  void sort_panels();
  void take_strips();
  DisjointSets joined(const std::vector<int>& panels) const;
  void check_sewn() const;
  void lay_panels();
  void stand_panels(std::vector<Vec3>& placed);
  double panel_depth(std::size_t i, const std::pair<double, double>& trunk) const;
  void stand_hoods(std::vector<Vec3>& placed) const;
  void stand_hood(int p, const std::vector<char>& stands, std::vector<Vec3>& placed) const;
  TubeFit fit_around(int p, BodyPart part, const std::vector<MeshedPanel>& meshed) const;
  void roll_all(const std::vector<Vec3>& placed, std::vector<MeshedPanel>& meshed) const;
  void roll(int p, const std::vector<Vec3>& placed, std::vector<MeshedPanel>& meshed) const;
  void level(int p, const std::vector<Vec3>& placed, const std::vector<MeshedPanel>& meshed,
             PanelPlacement& placement) const;
  BodyPart rolled_part(int p, const std::vector<MeshedPanel>& meshed) const;
  bool are_sewn(int p, int q) const;
  int twin_leg(int p) const;
  BodyPart leg_part(int p, int twin) const;
  std::optional<double> crotch_of(int p) const;
  void level_by_crotch(int p, PanelPlacement& placement) const;
  /// Calls use(point of p, point of another panel) for each pair of sewn points.
  void each_partner(int p, const auto& use) const {
    for (const MeshedSeam& seam : garment_.seams) {
      for (std::size_t i = 0; i < seam.a.size(); ++i) {
        if (panel_of_[seam.a[i]] == p) use(seam.a[i], seam.b[i]);
        if (panel_of_[seam.b[i]] == p) use(seam.b[i], seam.a[i]);
      }
    }
  }
  Error refused(int p, const std::string& problem) const {
    return {"panel '" + panel(p).name + "'", problem,
            "say its place, as in --place \"" + panel(p).name + "=torso:front\""};
  }

  const PanelMesh& garment_;
  const Skeleton& skeleton_;
  const BodySizes& sizes_;
  const AskedPlaces& asked_;
  std::vector<int> panels_;
  std::vector<int> panel_of_;
  std::vector<int> flat_;  ///< that lie in the layout
  std::vector<int> hoods_;
  std::vector<int> around_;
  std::vector<int> strips_;  ///< of around_, those that no seam of their own closes
  std::optional<WornLayout> worn_;
};

std::optional<bool> Component::named_back(int p) const {
  if (const AskedPlace* place = asked(p)) {
    if (place->side == PlacementSide::front) return false;
    if (place->side == PlacementSide::back) return true;
  }
  const PanelFace face = panel(p).is.face;
  return face == PanelFace::none ? std::nullopt : std::optional(face == PanelFace::back);
}

void Component::sort_panels() {
  for (const int p : panels_) {
    const AskedPlace* place = asked(p);
    const PlacementSide side = place == nullptr ? PlacementSide::none : place->side;
    const bool is_around = place != nullptr && place->around;
    const bool is_asked = is_around || side != PlacementSide::none;
    const bool is_aside = side == PlacementSide::left || side == PlacementSide::right;
    if (is_aside && !is_around && place->part != BodyPart::head && !is_hood(p)) {
      throw Error("--place, panel '" + panel(p).name + "'",
                  "left and right are sides of the head only, where hoods stand",
                  "say front, back or around");
    }
    if (is_asked ? is_around : panel(p).is.around) {
      around_.push_back(p);
    } else if (is_asked ? is_aside : is_hood(p)) {
      hoods_.push_back(p);
    } else {
      flat_.push_back(p);
    }
  }
}

/// Of all panels: sets of these that seams between them join.
DisjointSets Component::joined(const std::vector<int>& panels) const {
  DisjointSets sets(garment_.panels.size());
  for (const MeshedSeam& seam : garment_.seams) {
    const int a = panel_of_[seam.a[1]];
    const int b = panel_of_[seam.b[1]];
    if (std::ranges::count(panels, a) > 0 && std::ranges::count(panels, b) > 0) sets.join(a, b);
  }
  return sets;
}

/// A strip goes around if what it is sewn to does, once that lies flat. Collars do, cuffs, and
/// waistbands that are left open.
void Component::take_strips() {
  std::vector<int> strips;
  std::vector<int> rest;
  for (const int p : flat_) {
    const bool may_be = asked(p) == nullptr && !is_sleeve(p) && may_be_strip(garment_, p);
    (may_be ? strips : rest).push_back(p);
  }
  DisjointSets sets = joined(rest);
  const auto is_apart = [&](int p) { return sets.of(p) != sets.of(rest.front()); };
  if (strips.empty() || rest.empty() || std::ranges::any_of(rest, is_apart)) return;
  flat_ = std::move(rest);
  lay_panels();
  // A cuff of a leg lies with the leg.
  std::vector<char> is_of_leg(garment_.panels.size(), 0);
  for (const bool left : {true, false}) {
    for (const std::size_t i : worn_->leg_panels(left)) is_of_leg[flat_[i]] = 1;
  }
  std::vector<MeshedPanel> meshed = garment_.panels;
  for (MeshedPanel& panel : meshed) panel.placement = {};
  for (const int p : around_) {
    meshed[p].placement.around = 1;
    meshed[p].placement.axis = up_axis(garment_, p, false);
  }
  // What is sewn to a strip may be one, too.
  for (bool is_new = true; is_new;) {
    is_new = std::erase_if(strips, [&](int p) {
               bool is_at_leg = false;
               each_partner(p, [&](int, int other) {
                 is_at_leg = is_at_leg || is_of_leg[panel_of_[other]] != 0;
               });
               const TubeFit fit = fit_around(p, BodyPart::none, meshed);
               if (is_at_leg || !(fit.share >= min_tube_fit)) return false;
               meshed[p].placement.around = 1;
               meshed[p].placement.axis = fit.axis;
               meshed[p].placement.turn_degrees = to_degrees(fit.turn);
               strips_.push_back(p);
               return true;
             }) > 0;
  }
  flat_.insert(flat_.end(), strips.begin(), strips.end());
  // What a strip alone holds has no place without it.
  DisjointSets held = joined(flat_);
  if (std::ranges::any_of(flat_, [&](int p) { return held.of(p) != held.of(flat_.front()); })) {
    flat_.insert(flat_.end(), strips_.begin(), strips_.end());
    strips_.clear();
  }
  around_.insert(around_.end(), strips_.begin(), strips_.end());
  std::ranges::sort(flat_);
}

/// How a panel fits around what it is sewn to. Of that counts what lies in the layout, and what is
/// rolled around the same part. `part` none: around any one.
TubeFit Component::fit_around(int p, BodyPart part, const std::vector<MeshedPanel>& meshed) const {
  double least = infinity;
  double most = -infinity;
  const auto in_picture = [&](int point) -> std::optional<Vec2> {
    const auto partner = in_layout(panel_of_[point]);
    if (!partner || is_limb(part)) return std::nullopt;
    return worn_->layout().picture(*partner, garment_.flat[point]);
  };
  each_partner(p, [&](int, int other) {
    if (const auto at = in_picture(other)) {
      least = std::min(least, at->x());
      most = std::max(most, at->x());
    }
  });
  return tube_fit(garment_, p, [&](int point) -> std::optional<double> {
    const int q = panel_of_[point];
    if (const auto at = in_picture(point)) {
      const double share = (at->x() - least) / (most - least) - 0.5;
      const bool is_back = worn_->layout().back[*in_layout(q)] != 0;
      return std::numbers::pi * (is_back ? 1 - share : share);
    }
    const PanelPlacement& placement = meshed[q].placement;
    if (placement.around == 0 || (part != BodyPart::none && meshed[q].is.part != part)) {
      return std::nullopt;
    }
    double low = infinity;
    double high = -infinity;
    for (int i = panel(q).first_point; i < panel(q).first_point + panel(q).points; ++i) {
      const double x = upright(placement.axis, garment_.flat[i]).x();
      low = std::min(low, x);
      high = std::max(high, x);
    }
    const double x = upright(placement.axis, garment_.flat[point]).x();
    return 2 * std::numbers::pi * ((x - low) / (high - low) - 0.5) +
           to_radians(placement.turn_degrees);
  });
}

/// Throws Error when seams do not tell where the flat panels belong.
void Component::check_sewn() const {
  if (flat_.size() == 1 && panels_.size() == 1 && asked(flat_.front()) == nullptr) {
    throw refused(flat_.front(), "is sewn to no other panel, so nothing tells its place");
  }
  DisjointSets sets = joined(flat_);
  for (const int p : flat_) {
    if (sets.of(p) == sets.of(flat_.front())) continue;
    throw refused(p, "is sewn to '" + panel(flat_.front()).name +
                         "' only through panels that go around a part");
  }
}

void Component::lay_panels() {
  std::vector<std::optional<bool>> back;
  bool faces[2] = {false, false};
  bool is_asked = false;
  for (const int p : flat_) {
    back.push_back(named_back(p));
    if (back.back()) faces[*back.back() ? 1 : 0] = true;
    is_asked = is_asked || (asked(p) != nullptr && asked(p)->side != PlacementSide::none);
  }
  // One face alone is no name of a face, as in panels named a, b and c.
  const bool are_named = (faces[0] && faces[1]) || is_asked;
  if (!are_named) back.assign(flat_.size(), std::nullopt);
  worn_.emplace(garment_, lay_flat(garment_, flat_, back), around_.size() - strips_.size());
  if (!are_named) worn_->choose_front();
  worn_->straighten_legs(skeleton_);
}

/// Metres: z of a panel. `trunk`: z of the skin of the trunk behind and in front.
double Component::panel_depth(std::size_t i, const std::pair<double, double>& trunk) const {
  const double outward = worn_->layout().back[i] ? -1 : 1;
  const AskedPlace* place = asked(flat_[i]);
  const bool is_at_arm =
      place != nullptr && place->part != BodyPart::none ? is_arm(place->part) : is_sleeve(flat_[i]);
  double depth = outward > 0 ? trunk.second + face_distance : trunk.first - face_distance;
  if (is_at_arm) {
    // Nearer to its arm than the front is.
    const Vec2 centre = worn_->centre(i);
    const Bones bones(skeleton_, arm_of(centre.x() > sizes_.middle()));
    const double arc = bones.foot({centre.x(), centre.y(), bones.joints.front().z()});
    depth = bones.at(arc).first.z() + outward * sleeve_face_distance;
  }
  return depth + outward * worn_->layout().layer[i] * face_layer_distance;
}

void Component::stand_panels(std::vector<Vec3>& placed) {
  worn_->shift({sizes_.middle() - worn_->middle(), worn_->rise(sizes_, skeleton_)});
  double low = infinity;
  double high = -infinity;
  for (std::size_t i = 0; i < flat_.size(); ++i) {
    const MeshedPanel& of = panel(flat_[i]);
    for (int p = of.first_point; p < of.first_point + of.points; ++p) {
      const Vec2 at = worn_->layout().picture(i, garment_.flat[p]);
      placed[p] = {at.x(), at.y(), 0};
      if (is_sleeve(flat_[i])) continue;
      low = std::min(low, at.y());
      high = std::max(high, at.y());
    }
  }
  const auto trunk = sizes_.depth(low, std::min(high, skeleton_.joint("neck").y()));
  for (std::size_t i = 0; i < flat_.size(); ++i) {
    const MeshedPanel& of = panel(flat_[i]);
    const double depth = panel_depth(i, trunk);
    for (int p = of.first_point; p < of.first_point + of.points; ++p) placed[p].z() = depth;
  }
}

/// What is sewn to the neckline stands first, then what is sewn to that.
void Component::stand_hoods(std::vector<Vec3>& placed) const {
  std::vector<char> stands(garment_.panels.size(), 0);
  for (const int p : flat_) stands[p] = 1;
  std::vector<int> waiting = hoods_;
  while (!waiting.empty()) {
    const auto next = std::ranges::find_if(waiting, [&](int p) {
      bool tells = false;
      each_partner(p, [&](int, int other) { tells = tells || stands[panel_of_[other]] != 0; });
      return tells;
    });
    const auto at = next == waiting.end() ? waiting.begin() : next;
    stand_hood(*at, stands, placed);
    stands[*at] = 1;
    waiting.erase(at);
  }
}

/// A hood's half stands beside the head, its seams to the rest at the height of the neck. One that
/// only another piece of the hood holds stands as high as that, a left one across from a right one.
void Component::stand_hood(int p, const std::vector<char>& stands,
                           std::vector<Vec3>& placed) const {
  const MeshedPanel& of = panel(p);
  Vec2 sewn = Vec2::Zero();
  Vec2 there = Vec2::Zero();
  int count = 0;
  // The back of the neck tells the height, for a front may be cut low.
  bool at_back = false;
  each_partner(p, [&](int mine, int other) {
    const auto partner = in_layout(panel_of_[other]);
    if (!partner) return;
    const bool is_back = worn_->layout().back[*partner] != 0;
    if (at_back && !is_back) return;
    if (is_back && !at_back) {
      sewn = there = Vec2::Zero();
      count = 0;
      at_back = true;
    }
    sewn += garment_.flat[mine];
    there += placed[other].head<2>();
    ++count;
  });
  if (count == 0) {
    each_partner(p, [&](int mine, int other) {
      if (stands[panel_of_[other]] == 0) return;
      sewn += garment_.flat[mine];
      there += placed[other].head<2>();
      ++count;
    });
    if (count == 0) throw refused(p, "is a hood's and sewn to no front or back");
    for (const int q : hoods_) {
      if (stands[q] == 0 || side_sign(panel(q).is) * side_sign(panel(p).is) >= 0) continue;
      there.x() = count * (2 * sizes_.middle() - placed[panel(q).first_point].x());
    }
  }
  sewn /= count;
  there /= count;
  const AskedPlace* place = asked(p);
  const bool is_asked = place != nullptr && place->side != PlacementSide::none;
  const bool left = is_asked ? place->side == PlacementSide::left : there.x() > sizes_.middle();
  const auto [rear, fore] = sizes_.depth(skeleton_.joint("neck").y(), skeleton_.joint("head").y());
  const double aside = sizes_.shoulder() * hood_distance;
  Vec2 centre = Vec2::Zero();
  for (int i = of.first_point; i < of.first_point + of.points; ++i) {
    centre += garment_.flat[i] / of.points;
  }
  for (int i = of.first_point; i < of.first_point + of.points; ++i) {
    // Seen from the left, the wearer's back is to the right.
    const Vec2 at = garment_.flat[i] - Vec2(centre.x(), sewn.y());
    placed[i] = {sizes_.middle() + (left ? aside : -aside), there.y() + at.y(),
                 0.5 * (rear + fore) + (left ? -at.x() : at.x())};
  }
}

bool Component::are_sewn(int p, int q) const {
  bool sewn = false;
  each_partner(p, [&](int, int other) { sewn = sewn || panel_of_[other] == q; });
  return sewn;
}

/// The other of two legs of one piece each, or -1. They are alike and sewn to each other, as no
/// sleeves are.
int Component::twin_leg(int p) const {
  const auto is_strip = [&](int q) { return std::ranges::count(strips_, q) > 0; };
  if (is_strip(p)) return -1;
  for (const int q : around_) {
    const double points = std::max(panel(p).points, panel(q).points);
    const bool are_alike = std::abs(panel(p).points - panel(q).points) < leg_likeness * points;
    if (q != p && !is_strip(q) && are_alike && are_sewn(p, q)) return q;
  }
  return -1;
}

/// Left or right by the half of a waistband that it hangs on, else by its name. Else the later one
/// is the left one.
BodyPart Component::leg_part(int p, int twin) const {
  for (const int band : around_) {
    if (band == p || band == twin || !are_sewn(band, p) || !are_sewn(band, twin)) continue;
    // A waistband's right side is out, and its middle in front.
    const PlacementAxis up = up_axis(garment_, band, false);
    const auto hangs_at = [&](int leg) {
      double x = 0;
      int count = 0;
      each_partner(band, [&](int mine, int other) {
        if (panel_of_[other] != leg) return;
        x += upright(up, garment_.flat[mine]).x();
        ++count;
      });
      return x / count;
    };
    return leg_of(hangs_at(p) > hangs_at(twin));
  }
  const int named = side_sign(panel(p).is);
  return leg_of(named != 0 ? named > 0 : p > twin);
}

/// The part that a panel goes around: an arm beside what it is sewn to, a leg beside its twin, or
/// the torso. A cuff goes around what its sleeve or leg does, a waistband around the torso.
BodyPart Component::rolled_part(int p, const std::vector<MeshedPanel>& meshed) const {
  const AskedPlace* place = asked(p);
  if (place != nullptr && place->part != BodyPart::none) return place->part;
  if (is_told(panel(p).is.part)) return panel(p).is.part;
  if (const int twin = twin_leg(p); twin >= 0) return leg_part(p, twin);
  if (flat_.empty()) {
    for (const int q : around_) {
      const int twin = twin_leg(q);
      if (twin < 0 || !are_sewn(p, q)) continue;
      return are_sewn(p, twin) ? BodyPart::torso : leg_part(q, twin);
    }
  }
  if (flat_.empty()) return BodyPart::torso;
  double x = 0;
  int count = 0;
  BodyPart of_rolled = BodyPart::none;
  each_partner(p, [&](int, int other) {
    const int q = panel_of_[other];
    if (q != p && meshed[q].placement.around > 0) of_rolled = meshed[q].is.part;
    const auto partner = in_layout(q);
    if (!partner) return;
    x += worn_->layout().picture(*partner, garment_.flat[other]).x();
    ++count;
  });
  if (count == 0 && of_rolled != BodyPart::none) return of_rolled;
  if (count == 0) throw refused(p, "goes around a part that its seams do not tell");
  const double aside = x / count - sizes_.middle();
  // A skirt of one panel under a bodice goes around the torso.
  if (!is_sleeve(p) && std::abs(aside) < inner_shoulder * sizes_.shoulder()) {
    return BodyPart::torso;
  }
  return arm_of(aside > 0);
}

/// Metres: upright() y of a leg's crotch, where the seams to its twin end below; none: it is no
/// leg.
std::optional<double> Component::crotch_of(int p) const {
  const int twin = twin_leg(p);
  if (twin < 0) return std::nullopt;
  const PlacementAxis up = up_axis(garment_, p, false);
  double lowest = infinity;
  each_partner(p, [&](int mine, int other) {
    if (panel_of_[other] == twin) lowest = std::min(lowest, upright(up, garment_.flat[mine]).y());
  });
  return lowest;
}

/// The crotch of trousers belongs at the body's. So does a waistband as far above it as they reach.
void Component::level_by_crotch(int p, PanelPlacement& placement) const {
  placement.at = "pelvis";
  placement.level = crotch_of(p);
  if (placement.level) return;
  double above = 0;
  int count = 0;
  each_partner(p, [&](int mine, int other) {
    const int leg = panel_of_[other];
    const std::optional<double> crotch = crotch_of(leg);
    if (!crotch) return;
    const PlacementAxis up = up_axis(garment_, leg, false);
    above += upright(placement.axis, garment_.flat[mine]).y() -
             (upright(up, garment_.flat[other]).y() - *crotch);
    ++count;
  });
  if (count > 0) placement.level = above / count;
  if (count == 0) placement.at = "waist";
}

/// What is sewn to a flat panel is rolled first, then what is sewn to that.
void Component::roll_all(const std::vector<Vec3>& placed, std::vector<MeshedPanel>& meshed) const {
  std::vector<int> waiting = around_;
  while (!waiting.empty()) {
    const auto next = std::find_if(waiting.begin(), waiting.end(), [&](int p) {
      bool tells = false;
      each_partner(p, [&](int, int other) {
        const int q = panel_of_[other];
        tells = tells || in_layout(q) || (q != p && meshed[q].placement.around > 0);
      });
      return tells;
    });
    const auto at = next == waiting.end() ? waiting.begin() : next;
    roll(*at, placed, meshed);
    waiting.erase(at);
  }
}

/// A band at the neck goes around the neck, its seam at the base. What is sewn to a flat panel or
/// to another one around the same part lies level with that; positioning sees to it.
void Component::level(int p, const std::vector<Vec3>& placed,
                      const std::vector<MeshedPanel>& meshed, PanelPlacement& placement) const {
  double highest = -infinity;
  double seam = 0;
  int count = 0;
  bool has_neighbour = false;
  each_partner(p, [&](int mine, int other) {
    const int q = panel_of_[other];
    has_neighbour = has_neighbour || (q != p && meshed[q].placement.around > 0 &&
                                      meshed[q].is.part == meshed[p].is.part);
    if (!in_layout(q)) return;
    highest = std::max(highest, placed[other].y());
    seam += upright(placement.axis, garment_.flat[mine]).y();
    ++count;
  });
  if (is_leg(meshed[p].is.part) || (count == 0 && !has_neighbour)) {
    return level_by_crotch(p, placement);
  }
  const double neck = skeleton_.joint("neck").y();
  if (highest < 0.5 * (neck + skeleton_.joint("chest").y())) return;
  placement.at = "neck";
  placement.level = seam / count;
}

void Component::roll(int p, const std::vector<Vec3>& placed,
                     std::vector<MeshedPanel>& meshed) const {
  MeshedPanel& rolled = meshed[p];
  const BodyPart part = rolled_part(p, meshed);
  if (!is_told(rolled.is.part) || rolled.is.part != part) {
    rolled.is.part = {part, PanelSource::seams};
  }
  const bool goes_around_arm = is_arm(rolled.is.part);
  rolled.placement = {};
  rolled.placement.around = 1;
  rolled.placement.axis = up_axis(garment_, p, goes_around_arm);
  const TubeFit fit = fit_around(p, rolled.is.part, meshed);
  if (fit.share >= min_tube_fit) {
    rolled.placement.axis = fit.axis;
    rolled.placement.turn_degrees = to_degrees(fit.turn);
  }
  if (!goes_around_arm) level(p, placed, meshed, rolled.placement);
}

std::vector<int> Component::place(std::vector<Vec3>& placed, std::vector<FoundPlace>& found,
                                  std::vector<MeshedPanel>& meshed) {
  sort_panels();
  take_strips();
  if (!flat_.empty()) {
    check_sewn();
    lay_panels();
    stand_panels(placed);
  }
  stand_hoods(placed);
  roll_all(placed, meshed);
  for (std::size_t i = 0; i < flat_.size(); ++i) {
    found[flat_[i]].side = worn_->layout().back[i] ? PlacementSide::back : PlacementSide::front;
    found[flat_[i]].upside_down = worn_->is_upside_down();
  }
  for (const int p : hoods_) {
    const double x = placed[panel(p).first_point].x();
    found[p].side = x > sizes_.middle() ? PlacementSide::left : PlacementSide::right;
  }
  for (const int p : around_) {
    found[p].around = true;
    found[p].side = side_or_default(meshed[p].placement, meshed[p].is.part);
  }
  std::vector<int> legs;
  for (const bool left : {true, false}) {
    if (!worn_) continue;
    for (const std::size_t i : worn_->leg_panels(left)) legs.push_back(flat_[i]);
  }
  return legs;
}

/// The part of a panel that stands flat. `reaches_down`: below the crotch. Where nothing
/// else tells, what lies beyond the shoulder is a sleeve.
BodyPart part_of(const PanelMesh& garment, const MeshedPanel& panel, const BodySizes& sizes,
                 const Skeleton& skeleton, bool reaches_down) {
  Vec3 centre = Vec3::Zero();
  double innermost = infinity;
  double highest = -infinity;
  for (int i = panel.first_point; i < panel.first_point + panel.points; ++i) {
    centre += garment.placed[i] / panel.points;
    innermost = std::min(innermost, std::abs(garment.placed[i].x() - sizes.middle()));
    highest = std::max(highest, garment.placed[i].y());
  }
  const double x = centre.x() - sizes.middle();
  const bool is_left = x > 0;
  if (panel.is.role == PanelRole::hood) return BodyPart::head;
  switch (panel.is.worn_as) {
    case PanelRole::sleeve:
      return arm_of(is_left);
    case PanelRole::trousers:
      return leg_of(is_left);
    case PanelRole::unknown: {
      if (reaches_down) return leg_of(is_left);
      // A cuff lies far out; a gore at the waist neither begins at the armhole nor lies so far out.
      const bool is_cuff =
          std::abs(x) > sizes.shoulder() && centre.y() > skeleton.joint("pelvis").y() &&
          innermost > (highest > skeleton.joint("chest").y() ? inner_shoulder : cuff_shoulders) *
                          sizes.shoulder();
      return is_cuff ? arm_of(is_left) : BodyPart::torso;
    }
    default:
      return BodyPart::torso;
  }
}

}  // namespace

std::vector<FoundPlace> find_places(const TriangleMesh& body, const Skeleton& skeleton,
                                    const AskedPlaces& asked, PanelMesh& garment) {
  for (const auto& [name, place] : asked) {
    if (std::ranges::find(garment.panels, name, &MeshedPanel::name) == garment.panels.end()) {
      std::string names;
      for (const MeshedPanel& panel : garment.panels) {
        names += names.empty() ? "" : ", ";
        names += panel.name;
      }
      throw Error("--place", "there is no panel '" + name + "'", "the panels are: " + names);
    }
  }
  if (!has_all_limbs(skeleton)) {
    throw Error(
        "panel '" + garment.panels.front().name + "'",
        "states no place, and the skeleton lacks joints that would tell it",
        "place the panels in the pattern if the body lacks limbs; else let clean-body write "
        "the skeleton");
  }
  const BodySizes sizes(body, skeleton);
  const std::vector<int> panel_of = panel_of_points(garment);
  DisjointSets sewn(garment.panels.size());
  for (const MeshedSeam& seam : garment.seams) sewn.join(panel_of[seam.a[1]], panel_of[seam.b[1]]);
  std::vector<FoundPlace> found(garment.panels.size());
  std::map<int, std::vector<int>> components;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    found[p].panel = garment.panels[p].name;
    found[p].asked = asked.contains(garment.panels[p].name);
    components[sewn.of(static_cast<int>(p))].push_back(static_cast<int>(p));
  }
  std::vector<char> reaches_down(garment.panels.size(), 0);
  std::vector<Vec3> placed = garment.placed;
  std::vector<MeshedPanel> meshed = garment.panels;
  for (MeshedPanel& panel : meshed) panel.placement = {};
  for (const auto& [lowest, panels] : components) {
    for (const int p :
         Component(garment, skeleton, sizes, asked, panels).place(placed, found, meshed)) {
      reaches_down[p] = 1;
    }
  }
  garment.placed = std::move(placed);
  garment.panels = std::move(meshed);
  garment.has_places = true;
  for (std::size_t p = 0; p < found.size(); ++p) {
    MeshedPanel& panel = garment.panels[p];
    const auto place = asked.find(panel.name);
    if (place != asked.end() && place->second.part != BodyPart::none) {
      panel.is.part = {place->second.part, PanelSource::asked};
    }
    found[p].part = panel.is.part;
    if (is_told(panel.is.part)) continue;
    found[p].part = part_of(garment, panel, sizes, skeleton, reaches_down[p] != 0);
    // What a garment wraps, and whether it is worn where it belongs, goes by parts.
    panel.is.part = {};
    if (found[p].part != BodyPart::head) panel.is.part = {found[p].part, PanelSource::seams};
  }
  return found;
}

}  // namespace toile
