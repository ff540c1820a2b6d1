#include "pattern/classify/classify.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "pattern/classify/panel_name.h"
#include "pattern/constants.h"
#include "pattern/pattern.h"

namespace toile {

namespace {

/// A set of what a panel may be worn as.
using Pieces = unsigned;
constexpr Pieces set_of(PanelRole role) { return 1U << static_cast<unsigned>(role); }
constexpr Pieces set_of(PanelRole a, PanelRole b) { return set_of(a) | set_of(b); }
constexpr Pieces any_piece = ~0U;

/// In the order in which names tell: a cuff of trousers is of trousers, and a skirt's band is of
/// the skirt.
constexpr std::array<PanelRole, 5> pieces = {PanelRole::trousers, PanelRole::sleeve,
                                             PanelRole::skirt, PanelRole::waistband,
                                             PanelRole::bodice};

/// What one witness says of how a panel is worn.
struct Testimony {
  PanelSource by = PanelSource::none;
  Pieces may_be = any_piece;
  PanelRole says = PanelRole::unknown;  ///< the likeliest; unknown: it names none
  std::string words = {};               ///< "its name says a skirt"
};

std::string words_for(PanelRole piece) {
  switch (piece) {
    case PanelRole::sleeve:
      return "a sleeve";
    case PanelRole::trousers:
      return "trousers";
    case PanelRole::skirt:
      return "a skirt";
    case PanelRole::waistband:
      return "a waistband";
    default:
      return "a top";
  }
}

Testimony stated_part(BodyPart part) {
  using enum PanelRole;
  Testimony stated{PanelSource::stated};
  if (part == BodyPart::none) return stated;
  stated.words = "the pattern states the part '" + name_of(part) + "'";
  if (is_arm(part)) stated.says = sleeve;
  if (is_leg(part)) stated.says = trousers;
  if (part == BodyPart::head) stated.says = bodice;
  stated.may_be = part == BodyPart::torso ? set_of(bodice, waistband) | set_of(skirt, trousers)
                                          : set_of(stated.says);
  return stated;
}

Testimony labelled(const std::string& label) {
  using enum PanelRole;
  Testimony said{PanelSource::label};
  if (label == "arm") said = {said.by, set_of(sleeve), sleeve};
  if (label == "leg") said = {said.by, set_of(skirt, trousers), skirt};
  if (label == "body") said = {said.by, set_of(bodice, waistband), bodice};
  said.words = "its label is '" + label + "'";
  return said;
}

Testimony named(const PanelName& name) {
  using enum PanelRole;
  Testimony said{PanelSource::name};
  for (const PanelRole piece : pieces) {
    if (!name.says(piece)) continue;
    said.says = piece;
    said.may_be = set_of(piece);
    if (piece == waistband) said.may_be |= set_of(skirt);
    break;
  }
  if (name.says(cuff) && !name.says(trousers)) {
    said.says = sleeve;
    // A skirt may hang from a cuff as a flounce: it is the arm's.
    said.may_be = name.says(sleeve) ? set_of(sleeve) : set_of(sleeve, trousers);
  }
  if (said.says == unknown && (name.says(collar) || name.says(hood))) {
    said.says = bodice;
    said.may_be = set_of(bodice);
  }
  if (said.says == unknown && name.says(yoke)) {
    said.says = bodice;
    said.may_be = set_of(bodice) | set_of(skirt, trousers);
  }
  said.words = "its name says " + words_for(said.says);
  return said;
}

/// What else than the witnesses decides where these contradict each other.
struct Verdict {
  Told<PanelRole> worn_as;
  Told<PanelSide> side;
};

/// A panel as its witnesses tell.
class Hearing {
 public:
  explicit Hearing(const PanelWitnesses& told)
      : told_(told),
        name_(read_panel_name(told.name)),
        testimonies_{stated_part(told.part), labelled(told.label), named(name_)} {
    for (const Testimony& said : testimonies_) allowed_ &= said.may_be;
    if (told.name.size() <= most_letters_of_no_side) name_.side = name_.face = 0;
  }

  bool has_two_pieces() const { return allowed_ == 0; }
  /// Whether the stated limb is of another side than the name says.
  bool has_two_sides() const { return side_of(told_.part) * name_.side < 0; }
  Pieces options() const {
    Pieces all = 0;
    for (const Testimony& said : testimonies_) {
      if (said.may_be != any_piece) all |= said.may_be;
    }
    return all;
  }

  PanelClass judge(const Verdict& verdict = {}) const {
    PanelClass is;
    is.worn_as = has_two_pieces() && verdict.worn_as.by != PanelSource::none ? verdict.worn_as
                                                                             : by_witnesses();
    is.side =
        has_two_sides() && verdict.side.by != PanelSource::none ? verdict.side : side(is.worn_as);
    if (name_.face != 0) is.face = {static_cast<PanelFace>(name_.face), PanelSource::name};
    is.role = role(is.worn_as);
    is.part = part(is);
    is.contradiction = contradiction();
    return is;
  }

 private:
  bool is_of_stated_part(const Told<PanelRole>& worn_as) const {
    return worn_as == PanelRole::unknown || (testimonies_.front().may_be & set_of(worn_as)) != 0;
  }

  Told<PanelSide> side(const Told<PanelRole>& worn_as) const {
    const int stated = is_of_stated_part(worn_as) ? side_of(told_.part) : 0;
    if (stated != 0 && !has_two_sides()) {
      return {static_cast<PanelSide>(stated), PanelSource::stated};
    }
    if (name_.side == 0) return {};
    return {static_cast<PanelSide>(name_.side), PanelSource::name};
  }

  Told<PanelRole> by_witnesses() const {
    for (const Testimony& said : testimonies_) {
      const bool is_allowed = allowed_ == 0 || (set_of(said.says) & allowed_) != 0;
      if (said.says != PanelRole::unknown && is_allowed) return {said.says, said.by};
    }
    // Together they leave one that none of them names: a cuff labelled `leg` is of trousers.
    for (const PanelRole piece : pieces) {
      if (allowed_ == set_of(piece)) return {piece, testimonies_.back().by};
    }
    return {};
  }

  /// The name tells the most, if it is of the piece.
  Told<PanelRole> role(const Told<PanelRole>& worn_as) const {
    const PanelRole first = name_.first_role();
    const Pieces may_be = testimonies_.back().may_be;
    if (first != PanelRole::unknown && (!has_two_pieces() || (may_be & set_of(worn_as)) != 0)) {
      return {first, PanelSource::name};
    }
    if (told_.part == BodyPart::head && worn_as == PanelRole::bodice) {
      return {PanelRole::hood, PanelSource::stated};
    }
    // GarmentCode's `leg` and `body` tell no more than where a panel is worn.
    if (worn_as == PanelRole::sleeve || worn_as == PanelRole::trousers || has_two_pieces()) {
      return worn_as;
    }
    return {};
  }

  Told<BodyPart> part(const PanelClass& is) const {
    const bool is_left = is.side == PanelSide::left;
    const bool is_of_limb = is.worn_as == PanelRole::sleeve || is.worn_as == PanelRole::trousers;
    const bool is_stated_side = side_of(told_.part) == 0 || side_of(told_.part) == side_sign(is);
    if (told_.part != BodyPart::none && is_of_stated_part(is.worn_as) && is_stated_side) {
      return {told_.part, PanelSource::stated};
    }
    if (is_of_limb) {
      if (is.side == PanelSide::none) {
        return {told_.part, told_.part == BodyPart::none ? PanelSource::none : PanelSource::stated};
      }
      return {is.worn_as == PanelRole::sleeve ? arm_of(is_left) : leg_of(is_left), is.side.by};
    }
    if (is.worn_as == PanelRole::unknown || is.is_headwear()) return {};
    return {BodyPart::torso, is.worn_as.by};
  }

  std::string contradiction() const {
    std::string words;
    const auto add = [&words](const std::string& more) {
      words += (words.empty() ? "" : ", but ") + more;
    };
    if (has_two_pieces()) {
      for (const Testimony& said : testimonies_) {
        if (said.may_be != any_piece) add(said.words);
      }
    } else if (has_two_sides()) {
      add(testimonies_.front().words);
      add(std::string("its name says ") + (name_.side > 0 ? "left" : "right"));
    }
    return words;
  }

  PanelWitnesses told_;
  PanelName name_;
  std::array<Testimony, 3> testimonies_;
  Pieces allowed_ = any_piece;
};

/// What tells panels of one shape, turned or mirrored: their area, m^2, and its two moments, m^4.
std::array<double, 3> shape_of(const PanelMesh& garment, const MeshedPanel& panel) {
  double area = 0;
  Vec2 middle = Vec2::Zero();
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (int t = panel.first_triangle; t < panel.first_triangle + panel.triangles; ++t) {
    const Vec2& a = garment.flat[garment.triangles[t][0]];
    const Vec2& b = garment.flat[garment.triangles[t][1]];
    const Vec2& c = garment.flat[garment.triangles[t][2]];
    const Vec2 u = b - a;
    const Vec2 v = c - a;
    const double share = 0.5 * (u.x() * v.y() - u.y() * v.x());
    area += share;
    middle += share * (a + b + c) / 3;
    // The integral of x x^T over a triangle.
    const Vec2 sum = a + b + c;
    spread += share / 12 *
              (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  spread -= middle * middle.transpose() / area;
  const double mean = spread.trace() / 2;
  const double apart = std::sqrt(std::max(0.0, mean * mean - spread.determinant()));
  return {area, mean + apart, mean - apart};
}

/// What the seams and shapes of a garment tell of panels that contradict themselves.
class Evidence {
 public:
  Evidence(const PanelMesh& garment, const std::vector<Hearing>& hearings)
      : garment_(garment), hearings_(hearings), panel_of_(panel_of_points(garment)) {}

  Verdict decide(int panel) const {
    Verdict verdict;
    if (hearings_[panel].has_two_pieces()) verdict.worn_as = piece(panel);
    if (hearings_[panel].has_two_sides()) verdict.side = side(panel);
    return verdict;
  }

 private:
  const PanelClass& is(int panel) const { return garment_.panels[panel].is; }
  bool is_sure(int panel) const {
    return is(panel).contradiction.empty() && is(panel).worn_as != PanelRole::unknown;
  }

  Told<PanelRole> piece(int panel) const {
    const Pieces options = hearings_[panel].options();
    Pieces twins = 0;
    const std::array<double, 3> shape = shape_of(garment_, garment_.panels[panel]);
    for (int p = 0; p < static_cast<int>(garment_.panels.size()); ++p) {
      if (!is_sure(p) || p == panel) continue;
      const std::array<double, 3> other = shape_of(garment_, garment_.panels[p]);
      const bool is_twin = std::ranges::equal(shape, other, [](double a, double b) {
        return std::abs(a - b) < twin_tolerance * std::max(a, b);
      });
      if (is_twin) twins |= set_of(is(p).worn_as);
    }
    if (const auto one = only(twins & options)) return {*one, PanelSource::shape};
    std::map<int, int> seams_to;
    Pieces met = options;
    for (const MeshedSeam& seam : garment_.seams) {
      const int other = partner(seam, panel);
      if (other < 0 || !is_sure(other)) continue;
      ++seams_to[other];
      for (const PanelRole option : pieces) {
        if (!may_meet(option, is(other).worn_as)) met &= ~set_of(option);
      }
    }
    Pieces tubes = 0;
    for (const auto& [other, seams] : seams_to) {
      if (seams > 1) tubes |= set_of(is(other).worn_as);
    }
    if (const auto one = only(tubes & options)) return {*one, PanelSource::seams};
    if (const auto one = only(met)) return {*one, PanelSource::seams};
    return {};
  }

  /// The side where most of its seams to others are. Those to a front or back lie left or right of
  /// its middle. A drawing may be upside down: seams to an arm are in its upper half then as well.
  Told<PanelSide> side(int panel) const {
    double sum = 0;
    for (const MeshedSeam& seam : garment_.seams) {
      const int other = partner(seam, panel);
      if (other < 0 || !is(other).contradiction.empty()) continue;
      const double length = seam.length_a;
      if (is(other).side != PanelSide::none) {
        sum += length * side_sign(is(other));
      } else if (is(other).face != PanelFace::none) {
        const Vec2 from_middle = middle_of(panel_of_[seam.a[1]] == other ? seam.a : seam.b) -
                                 middle_of(garment_.panels[other]);
        const bool is_low = is_leg(is(panel).part) != (from_middle.y() < 0);
        sum += (is_low ? -1 : 1) * (from_middle.x() > 0 ? 1 : -1) * face_sign(is(other)) * length;
      }
    }
    if (sum == 0) return {};
    return {sum > 0 ? PanelSide::left : PanelSide::right, PanelSource::seams};
  }

  /// The panel that the seam joins to this one; -1: none.
  int partner(const MeshedSeam& seam, int panel) const {
    const int a = panel_of_[seam.a[1]];
    const int b = panel_of_[seam.b[1]];
    if (a == b || (a != panel && b != panel)) return -1;
    return a == panel ? b : a;
  }
  Vec2 middle_of(const std::vector<int>& points) const {
    Vec2 sum = Vec2::Zero();
    for (const int p : points) sum += garment_.flat[p];
    return sum / static_cast<double>(points.size());
  }
  Vec2 middle_of(const MeshedPanel& panel) const {
    Vec2 sum = Vec2::Zero();
    for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
      sum += garment_.flat[p];
    }
    return sum / panel.points;
  }
  static std::optional<PanelRole> only(Pieces of) {
    for (const PanelRole piece : pieces) {
      if (of == set_of(piece)) return piece;
    }
    return std::nullopt;
  }

  const PanelMesh& garment_;
  const std::vector<Hearing>& hearings_;
  std::vector<int> panel_of_;
};

/// Metres: how wide the panel is in the mean across a seam of this length, and at most its size.
double width_across(const PanelMesh& garment, const MeshedPanel& panel, double length) {
  Vec2 low = Vec2::Constant(1e300);
  Vec2 high = -low;
  for (int i = panel.first_point; i < panel.first_point + panel.points; ++i) {
    low = low.cwiseMin(garment.flat[i]);
    high = high.cwiseMax(garment.flat[i]);
  }
  return std::min((high - low).maxCoeff(), shape_of(garment, panel)[0] / std::max(length, 1e-9));
}

/// Whether a panel stands on the side of a limb, left or right of the garment's middle.
bool stands_at(BodyPart limb, const PanelMesh& garment, const MeshedPanel& panel) {
  double middle = 0;
  double own = 0;
  for (const Vec3& p : garment.placed) middle += p.x() / static_cast<double>(garment.placed.size());
  for (int p = panel.first_point; p < panel.first_point + panel.points; ++p) {
    own += garment.placed[p].x() / panel.points;
  }
  return side_of(limb) * (own - middle) > 0;
}

/// Of a panel that has the place of a part which is not its own. Where its seams tell the other arm
/// or leg, a placement takes that one's joint. Else it has no place, and seams place the garment.
void settle_place(BodyPart stated, PanelMesh& garment, MeshedPanel& panel) {
  const BodyPart part = panel.is.part;
  const bool is_other_limb =
      is_limb(part) && side_of(part) == -side_of(stated) && is_arm(part) == is_arm(stated);
  if (!panel.placement.by_part()) {
    if (is_other_limb && stands_at(stated, garment, panel)) garment.has_places = false;
    return;
  }
  if (part == stated) return;
  if (!is_other_limb) {
    panel.placement = {};
    garment.has_places = false;
    return;
  }
  std::string& joint = panel.placement.at;
  const std::size_t end = joint.find('_');
  if (end != std::string::npos) joint.replace(0, end, side_of(part) > 0 ? "left" : "right");
}

}  // namespace

PanelWitnesses witnesses_of(const PatternPanel& panel) {
  return {panel.name, panel.part, panel.label};
}

PanelClass classify(const PanelWitnesses& told) { return Hearing(told).judge(); }

void classify(PanelMesh& garment, const std::vector<PanelWitnesses>& told) {
  const std::vector<Hearing> hearings(told.begin(), told.end());
  for (std::size_t p = 0; p < hearings.size(); ++p) garment.panels[p].is = hearings[p].judge();
  const Evidence evidence(garment, hearings);
  std::vector<PanelClass> judged;
  judged.reserve(hearings.size());
  for (std::size_t p = 0; p < hearings.size(); ++p) {
    const int panel = static_cast<int>(p);
    judged.push_back(hearings[p].judge(evidence.decide(panel)));
    if (closes_around(garment, panel)) judged.back().around = {true, PanelSource::seams};
  }
  for (std::size_t p = 0; p < judged.size(); ++p) {
    garment.panels[p].is = std::move(judged[p]);
    settle_place(told[p].part, garment, garment.panels[p]);
  }
}

bool may_meet(PanelRole a, PanelRole b) {
  using enum PanelRole;
  if (a > b) std::swap(a, b);
  if (a == unknown || b == unknown || a == b) return true;
  if (b == facing || b == pocket || b == yoke) return true;
  switch (a) {
    case bodice:
      return b != cuff;
    case skirt:
      return b == waistband;
    case trousers:
      return b == waistband || b == cuff;
    case sleeve:
      return b == cuff || b == hood || b == collar;
    case collar:
      return b == hood;
    default:
      return false;
  }
}

bool closes_around(const PanelMesh& garment, int panel) {
  const std::vector<int> panel_of = panel_of_points(garment);
  const MeshedPanel& of = garment.panels[panel];
  double gaps = 0;  // times length
  double lengths = 0;
  for (const MeshedSeam& seam : garment.seams) {
    if (panel_of[seam.a[1]] != panel || panel_of[seam.b[1]] != panel) continue;
    if (seam.a.front() == seam.b.front() || seam.a.back() == seam.b.back()) continue;
    double gap = 0;
    double length = 0;
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      gap += (garment.flat[seam.a[i]] - garment.flat[seam.b[i]]).norm() /
             static_cast<double>(seam.a.size());
      if (i > 0) length += (garment.flat[seam.a[i]] - garment.flat[seam.a[i - 1]]).norm();
    }
    if (gap > min_around_gap * width_across(garment, of, length)) return true;
    gaps += gap * length;
    lengths += length;
  }
  // A long seam may be in parts, as of a leg that has notches.
  return lengths > 0 && gaps / lengths > min_around_gap * width_across(garment, of, lengths);
}

}  // namespace toile
