#include "cloth/start/find_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "cloth/start/constants.h"
#include "cloth/start/panel_parts.h"
#include "cloth/start/sheet_landmarks.h"
#include "cloth/start/sheet_layout.h"
#include "geometry/body/bones.h"
#include "geometry/body/landmarks.h"
#include "geometry/body/limbs_through.h"
#include "geometry/disjoint_sets.h"
#include "geometry/error.h"
#include "pattern/panel_kind.h"

namespace toile {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr std::array<std::pair<const char*, PlacementSide>, 4> sides = {
    {{"front", PlacementSide::front},
     {"back", PlacementSide::back},
     {"left", PlacementSide::left},
     {"right", PlacementSide::right}}};

const char* const place_remedy = "name its place with --place, as in --place NAME=torso:front";

bool names_hood(const std::string& name) {
  return names_headwear(name) && (name.find("hood") != std::string::npos ||
                                  name.find("Hood") != std::string::npos);
}

/// Sizes of the body that tell where cloth stands.
class BodySizes {
 public:
  BodySizes(const TriangleMesh& body, const Skeleton& skeleton) : body_(body), skeleton_(skeleton) {
    middle_ = skeleton.joint("neck").x();
    shoulder_ = 0.5 * (skeleton.joint("left_shoulder") - skeleton.joint("right_shoulder")).norm();
  }

  double middle() const { return middle_; }
  double shoulder() const { return shoulder_; }

  /// Metres: z of the skin of the trunk between two heights, the smallest and the largest.
  std::pair<double, double> depth(double low, double high) const {
    std::pair<double, double> range{infinity, -infinity};
    for (const Vec3& p : body_.points) {
      if (std::abs(p.x() - middle_) > shoulder_ || p.y() < low || p.y() > high) continue;
      range.first = std::min(range.first, p.z());
      range.second = std::max(range.second, p.z());
    }
    if (range.first > range.second) range = {skeleton_.joint("waist").z(), skeleton_.joint("waist").z()};
    return range;
  }

  /// Metres: height of the shoulder beside the neck, `aside` from the middle plane.
  double shoulder_height(double aside) const {
    const double neck = skeleton_.joint("neck").y();
    double top = -infinity;
    for (const Vec3& p : body_.points) {
      const double x = std::abs(p.x() - middle_);
      if (std::abs(x - aside) < 0.015 && p.y() < neck) top = std::max(top, p.y());
    }
    return std::isfinite(top) ? top : neck;
  }

  /// Metres around the waist.
  double waist_girth() const {
    const std::optional<Section> section = torso_section(body_, skeleton_.joint("waist").y());
    return section ? section->girth : 0;
  }

 private:
  const TriangleMesh& body_;
  const Skeleton& skeleton_;
  double middle_ = 0;
  double shoulder_ = 0;
};

/// Panels that are sewn together, directly or through others.
class Piece {
 public:
  Piece(const PanelMesh& garment, const Skeleton& skeleton, const BodySizes& sizes,
        const AskedPlaces& asked, std::vector<int> panels)
      : garment_(garment),
        skeleton_(skeleton),
        sizes_(sizes),
        asked_(asked),
        panels_(std::move(panels)),
        panel_of_(panel_of_points(garment)) {}

  /// Places the panels. Returns whether the piece has an opening for each leg.
  bool place(std::vector<Vec3>& placed, std::vector<FoundPlace>& found,
             std::vector<MeshedPanel>& meshed);

 private:
  const MeshedPanel& panel(int p) const { return garment_.panels[p]; }
  PanelKind kind(int p) const { return kind_of(panel(p)); }
  const AskedPlace* asked(int p) const {
    const auto it = asked_.find(panel(p).name);
    return it == asked_.end() ? nullptr : &it->second;
  }
  bool has(PanelKind wanted) const {
    return std::ranges::any_of(panels_, [&](int p) { return kind(p) == wanted; });
  }
  double size(int p) const;
  bool closes_around(int p) const;
  std::optional<bool> named_back(int p) const;
  std::vector<std::vector<int>> connected(const std::vector<int>& panels) const;

  void sort_panels();
  void lay_sheets();
  void choose_front();
  bool hangs() const;
  bool is_strapless(const SheetOpening& top) const;
  std::optional<double> crotch_height() const;
  Vec2 centre(std::size_t i) const;
  double height() const;
  double middle() const;
  void stand_sheets(std::vector<Vec3>& placed);
  void stand_hood(int p, std::vector<Vec3>& placed) const;
  void roll(int p, MeshedPanel& meshed) const;
  std::string rolled_part(int p) const;
  PlacementAxis up_axis(int p, bool to_partners) const;

  const PanelMesh& garment_;
  const Skeleton& skeleton_;
  const BodySizes& sizes_;
  const AskedPlaces& asked_;
  std::vector<int> panels_;
  std::vector<int> panel_of_;
  std::vector<int> flat_;    ///< that lie in sheets
  std::vector<int> hoods_;
  std::vector<int> around_;
  bool faces_known_ = false;
  SheetLayout layout_;
  std::vector<SheetOpening> openings_;
  std::vector<Vec2> shoulders_;
};

/// Metres: the larger side of the panel's bounding box.
double Piece::size(int p) const {
  Vec2 low = Vec2::Constant(infinity);
  Vec2 high = -low;
  for (int i = panel(p).first_point; i < panel(p).first_point + panel(p).points; ++i) {
    low = low.cwiseMin(garment_.flat[i]);
    high = high.cwiseMax(garment_.flat[i]);
  }
  return (high - low).maxCoeff();
}

/// Whether a seam joins two edges of the panel that lie across from each other.
bool Piece::closes_around(int p) const {
  return std::ranges::any_of(garment_.seams, [&](const MeshedSeam& seam) {
    if (panel_of_[seam.a[1]] != p || panel_of_[seam.b[1]] != p) return false;
    if (seam.a.front() == seam.b.front() || seam.a.back() == seam.b.back()) return false;
    double gap = 0;
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      gap += (garment_.flat[seam.a[i]] - garment_.flat[seam.b[i]]).norm();
    }
    return gap / static_cast<double>(seam.a.size()) > min_around_gap * size(p);
  });
}

std::optional<bool> Piece::named_back(int p) const {
  if (const AskedPlace* place = asked(p)) {
    if (place->side == PlacementSide::front) return false;
    if (place->side == PlacementSide::back) return true;
  }
  const std::string& name = panel(p).name;
  const int face = name.size() > 2 ? face_by_name(name) : 0;
  return face == 0 ? std::nullopt : std::optional(face < 0);
}

std::vector<std::vector<int>> Piece::connected(const std::vector<int>& panels) const {
  DisjointSets sets(garment_.panels.size());
  const auto is_among = [&](int p) { return std::ranges::find(panels, p) != panels.end(); };
  for (const MeshedSeam& seam : garment_.seams) {
    const int a = panel_of_[seam.a[1]];
    const int b = panel_of_[seam.b[1]];
    if (is_among(a) && is_among(b)) sets.join(a, b);
  }
  std::map<int, std::vector<int>> groups;
  for (const int p : panels) groups[sets.of(p)].push_back(p);
  std::vector<std::vector<int>> result;
  for (auto& [lowest, group] : groups) result.push_back(std::move(group));
  return result;
}

void Piece::sort_panels() {
  for (const int p : panels_) {
    const AskedPlace* place = asked(p);
    const bool says_side = place != nullptr && (place->side != PlacementSide::none || place->around);
    if (says_side ? place->around : closes_around(p)) {
      around_.push_back(p);
    } else if (says_side ? place->side == PlacementSide::left || place->side == PlacementSide::right
                         : names_hood(panel(p).name)) {
      hoods_.push_back(p);
    } else {
      flat_.push_back(p);
    }
  }
}

void Piece::lay_sheets() {
  std::vector<std::optional<bool>> back;
  bool front_named = false;
  bool back_named = false;
  for (const int p : flat_) {
    back.push_back(named_back(p));
    if (back.back()) (*back.back() ? back_named : front_named) = true;
  }
  // One face alone is no name of a face, as in panels named a, b and c.
  faces_known_ = front_named && back_named;
  const bool any_asked = std::ranges::any_of(flat_, [&](int p) { return asked(p) != nullptr; });
  if (!faces_known_ && !any_asked) back.assign(flat_.size(), std::nullopt);
  faces_known_ = faces_known_ || any_asked;
  layout_ = lay_in_sheets(garment_, flat_, back);
  openings_ = sheet_openings(garment_, layout_);
  shoulders_ = shoulder_points(garment_, layout_);
  if (!faces_known_) choose_front();
}

/// Whether the piece hangs from the shoulders. `shoulders_` are known.
bool Piece::hangs() const {
  const bool is_bottom = !has(PanelKind::top) && !has(PanelKind::sleeve) && !has(PanelKind::unknown);
  if (is_bottom || shoulders_.empty()) return false;
  if (has(PanelKind::sleeve)) return true;
  return openings_.size() + around_.size() > 2;
}

/// Metres: x of the piece's middle in the picture.
double Piece::middle() const {
  double moment = 0;
  double area = 0;
  for (std::size_t i = 0; i < flat_.size(); ++i) {
    if (kind(flat_[i]) == PanelKind::sleeve) continue;
    const MeshedPanel& of = panel(flat_[i]);
    for (int t = of.first_triangle; t < of.first_triangle + of.triangles; ++t) {
      const auto& [a, b, c] = garment_.triangles[t];
      const Vec2 pa = layout_.picture(i, garment_.flat[a]);
      const Vec2 ab = layout_.picture(i, garment_.flat[b]) - pa;
      const Vec2 ac = layout_.picture(i, garment_.flat[c]) - pa;
      const double twice = std::abs(ab.x() * ac.y() - ab.y() * ac.x());
      moment += twice * (pa.x() + (ab.x() + ac.x()) / 3);
      area += twice;
    }
  }
  return area > 0 ? moment / area : 0;
}

void Piece::choose_front() {
  const double x = middle();
  if (hangs()) {
    const double front = sheet_top(garment_, layout_, false, x);
    const double back = sheet_top(garment_, layout_, true, x);
    if (std::abs(front - back) > min_neck_difference) {
      if (front > back) layout_.change_faces();
    }
  } else {
    std::array<double, 2> areas{};
    for (std::size_t i = 0; i < flat_.size(); ++i) {
      const MeshedPanel& of = panel(flat_[i]);
      for (int t = of.first_triangle; t < of.first_triangle + of.triangles; ++t) {
        const auto& [a, b, c] = garment_.triangles[t];
        const Vec2 ab = garment_.flat[b] - garment_.flat[a];
        const Vec2 ac = garment_.flat[c] - garment_.flat[a];
        areas[layout_.back[i] ? 1 : 0] += std::abs(ab.x() * ac.y() - ab.y() * ac.x());
      }
    }
    if (areas[0] > areas[1]) layout_.change_faces();
  }
  openings_ = sheet_openings(garment_, layout_);
  shoulders_ = shoulder_points(garment_, layout_);
}

/// Metres: how far the picture has to be raised.
double Piece::height() const {
  if (hangs()) {
    // What lies beside the neck counts; of a garment with none, the nearest to it.
    const double x = middle();
    double sum = 0;
    int count = 0;
    double nearest = infinity;
    double nearest_rise = 0;
    for (const Vec2& p : shoulders_) {
      const double aside = std::abs(p.x() - x);
      const double share = aside / sizes_.shoulder();
      const double rise = sizes_.shoulder_height(std::min(aside, sizes_.shoulder())) - p.y();
      if (share >= inner_shoulder && share <= outer_shoulder) {
        sum += rise;
        ++count;
      }
      if (aside < nearest) {
        nearest = aside;
        nearest_rise = rise;
      }
    }
    return (count > 0 ? sum / count : nearest_rise) + shoulder_seam_gap;
  }
  const auto around = std::ranges::find_if(openings_, &SheetOpening::both_sheets);
  if (around == openings_.end()) {
    double top = -infinity;
    for (const SheetOpening& opening : openings_) top = std::max(top, opening.high);
    return skeleton_.joint("waist").y() - (std::isfinite(top) ? top : 0);
  }
  if (is_strapless(*around)) return skeleton_.joint("chest").y() - around->mean_height;
  const double rise = skeleton_.joint("waist").y() - waist_border_depth - around->mean_height;
  const std::optional<double> crotch = crotch_height();
  if (!crotch) return rise;
  return std::min(rise, skeleton_.joint("pelvis").y() + crotch_slack - *crotch);
}

/// Whether the piece, which does not hang from the shoulders, is worn about the chest.
bool Piece::is_strapless(const SheetOpening& top) const {
  if (has(PanelKind::top)) return true;
  if (has(PanelKind::skirt) || has(PanelKind::trousers) || has(PanelKind::band)) return false;
  const bool has_elastic = std::ranges::any_of(garment_.elastics, [&](const MeshedElastic& elastic) {
    return std::ranges::find(panels_, panel_of_[elastic.points.front()]) != panels_.end();
  });
  if (has_elastic || openings_.size() != 2) return false;
  return top.length > wide_tube_ratio * sizes_.waist_girth() &&
         top.mean_height - openings_.back().mean_height < short_tube_height;
}

/// Metres, in the picture: the lowest point of the seams that join a left half to a right one, if
/// an opening for each leg lies below.
std::optional<double> Piece::crotch_height() const {
  const double x = middle();
  bool left_leg = false;
  bool right_leg = false;
  for (const SheetOpening& opening : openings_) {
    left_leg = left_leg || opening.left > x - leg_overlap;
    right_leg = right_leg || opening.right < x + leg_overlap;
  }
  if (!left_leg || !right_leg) return std::nullopt;
  std::optional<double> lowest;
  for (const MeshedSeam& seam : garment_.seams) {
    const auto a = std::ranges::find(flat_, panel_of_[seam.a[1]]);
    const auto b = std::ranges::find(flat_, panel_of_[seam.b[1]]);
    if (a == flat_.end() || b == flat_.end() || a == b) continue;
    const auto i = static_cast<std::size_t>(a - flat_.begin());
    const auto j = static_cast<std::size_t>(b - flat_.begin());
    if (layout_.back[i] != layout_.back[j]) continue;
    if ((centre(i).x() > x) == (centre(j).x() > x)) continue;
    for (const int p : seam.a) {
      const double y = layout_.picture(i, garment_.flat[p]).y();
      if (!lowest || y < *lowest) lowest = y;
    }
  }
  return lowest;
}

/// Metres, in the picture: the mean of a panel's points.
Vec2 Piece::centre(std::size_t i) const {
  const MeshedPanel& of = panel(flat_[i]);
  Vec2 sum = Vec2::Zero();
  for (int p = of.first_point; p < of.first_point + of.points; ++p) {
    sum += layout_.picture(i, garment_.flat[p]);
  }
  return sum / of.points;
}

void Piece::stand_sheets(std::vector<Vec3>& placed) {
  layout_.move(1, {sizes_.middle() - middle(), height()});
  double low = infinity;
  double high = -infinity;
  const auto each = [&](std::size_t i, const auto& use) {
    const MeshedPanel& of = panel(flat_[i]);
    for (int p = of.first_point; p < of.first_point + of.points; ++p) {
      use(p, layout_.picture(i, garment_.flat[p]));
    }
  };
  for (std::size_t i = 0; i < flat_.size(); ++i) {
    if (kind(flat_[i]) == PanelKind::sleeve) continue;
    each(i, [&](int, const Vec2& at) {
      low = std::min(low, at.y());
      high = std::max(high, at.y());
    });
  }
  const auto [rear, fore] = sizes_.depth(low, std::min(high, skeleton_.joint("neck").y()));
  for (std::size_t i = 0; i < flat_.size(); ++i) {
    const double outward = layout_.back[i] ? -1 : 1;
    double depth = layout_.back[i] ? rear - sheet_distance : fore + sheet_distance;
    // A sleeve stands nearer to its arm than the front does.
    const Vec2 at_centre = centre(i);
    const std::string arm = at_centre.x() > sizes_.middle() ? "left_arm" : "right_arm";
    const Bones bones(skeleton_, arm);
    const AskedPlace* place = asked(flat_[i]);
    const bool is_sleeve =
        kind(flat_[i]) == PanelKind::sleeve || (place != nullptr && place->part.ends_with("_arm"));
    if (is_sleeve) {
      const Vec3 bone = bones.at(bones.foot({at_centre.x(), at_centre.y(), bones.joints.front().z()})).first;
      depth = bone.z() + outward * sleeve_sheet_distance;
    }
    depth += outward * layout_.layer[i] * sheet_layer_distance;
    each(i, [&](int p, const Vec2& at) { placed[p] = {at.x(), at.y(), depth}; });
  }
}

/// A hood's half stands beside the head, its seams to the rest at the height of the neck.
void Piece::stand_hood(int p, std::vector<Vec3>& placed) const {
  const MeshedPanel& of = panel(p);
  Vec2 sewn = Vec2::Zero();
  double x = 0;
  double y = 0;
  int count = 0;
  // The back of the neck tells the height: a front may be cut low.
  bool at_back = false;
  for (const MeshedSeam& seam : garment_.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      for (const auto& [mine, other] :
           {std::pair(seam.a[i], seam.b[i]), std::pair(seam.b[i], seam.a[i])}) {
        const auto partner = std::ranges::find(flat_, panel_of_[other]);
        if (panel_of_[mine] != p || partner == flat_.end()) continue;
        const bool is_back = layout_.back[static_cast<std::size_t>(partner - flat_.begin())] != 0;
        if (at_back && !is_back) continue;
        if (is_back && !at_back) {
          sewn = Vec2::Zero();
          x = y = count = 0;
          at_back = true;
        }
        sewn += garment_.flat[mine];
        x += placed[other].x();
        y += placed[other].y();
        ++count;
      }
    }
  }
  if (count == 0) throw Error("panel '" + of.name + "'", "is sewn to no front or back", place_remedy);
  sewn /= count;
  const AskedPlace* place = asked(p);
  bool left = x / count > sizes_.middle();
  if (place != nullptr && place->side != PlacementSide::none) left = place->side == PlacementSide::left;
  const auto [rear, fore] = sizes_.depth(skeleton_.joint("neck").y(), skeleton_.joint("head").y());
  const double aside = sizes_.shoulder() * hood_distance;
  Vec2 centre = Vec2::Zero();
  for (int i = of.first_point; i < of.first_point + of.points; ++i) {
    centre += garment_.flat[i] / of.points;
  }
  for (int i = of.first_point; i < of.first_point + of.points; ++i) {
    // Seen from the left, the wearer's back is to the right.
    const Vec2 at = garment_.flat[i] - Vec2(centre.x(), sewn.y());
    placed[i] = {sizes_.middle() + (left ? aside : -aside), y / count + at.y(),
                 0.5 * (rear + fore) + (left ? -at.x() : at.x())};
  }
}

/// The direction of the flat panel that points up its part. It runs along the seam that closes the
/// panel: toward the seams to other panels, or to the drawing's +y.
PlacementAxis Piece::up_axis(int p, bool to_partners) const {
  Vec2 along(0, 1);
  for (const MeshedSeam& seam : garment_.seams) {
    if (panel_of_[seam.a[1]] != p || panel_of_[seam.b[1]] != p) continue;
    const Vec2 run = garment_.flat[seam.a.back()] - garment_.flat[seam.a.front()];
    along = std::abs(run.x()) > std::abs(run.y()) ? Vec2(1, 0) : Vec2(0, 1);
    break;
  }
  Vec2 sewn = Vec2::Zero();
  Vec2 centre = Vec2::Zero();
  int count = 0;
  for (int i = panel(p).first_point; i < panel(p).first_point + panel(p).points; ++i) {
    centre += garment_.flat[i] / panel(p).points;
  }
  for (const MeshedSeam& seam : garment_.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      const bool a_mine = panel_of_[seam.a[i]] == p;
      if (a_mine == (panel_of_[seam.b[i]] == p)) continue;
      sewn += garment_.flat[a_mine ? seam.a[i] : seam.b[i]] - centre;
      ++count;
    }
  }
  const double up = to_partners && count > 0 ? sewn.dot(along) : 1;
  if (along.x() > 0) return up < 0 ? PlacementAxis::minus_x : PlacementAxis::plus_x;
  return up < 0 ? PlacementAxis::minus_y : PlacementAxis::plus_y;
}

/// The part that a panel goes around: an arm beside what it is sewn to, a leg beside its twin, or
/// the torso.
std::string Piece::rolled_part(int p) const {
  const AskedPlace* place = asked(p);
  if (place != nullptr && !place->part.empty()) return place->part;
  if (!panel(p).part.empty()) return panel(p).part;
  if (flat_.empty()) {
    if (around_.size() == 1) return "torso";
    if (around_.size() == 2) {
      const int named = side_by_name(panel(p).name);
      const bool left = named != 0 ? named > 0 : p == around_.back();
      return left ? "left_leg" : "right_leg";
    }
    throw Error("panel '" + panel(p).name + "'", "has no place that its seams tell", place_remedy);
  }
  double x = 0;
  int count = 0;
  for (const MeshedSeam& seam : garment_.seams) {
    for (std::size_t i = 0; i < seam.a.size(); ++i) {
      for (const auto& [mine, other] :
           {std::pair(seam.a[i], seam.b[i]), std::pair(seam.b[i], seam.a[i])}) {
        const auto in = std::ranges::find(flat_, panel_of_[other]);
        if (panel_of_[mine] != p || in == flat_.end()) continue;
        x += layout_.picture(static_cast<std::size_t>(in - flat_.begin()), garment_.flat[other]).x();
        ++count;
      }
    }
  }
  if (count == 0) throw Error("panel '" + panel(p).name + "'", "has no place that its seams tell", place_remedy);
  const double aside = x / count - sizes_.middle();
  // A skirt of one panel under a bodice goes around the torso.
  if (kind(p) != PanelKind::sleeve && std::abs(aside) < inner_shoulder * sizes_.shoulder()) {
    return "torso";
  }
  return aside > 0 ? "left_arm" : "right_arm";
}

void Piece::roll(int p, MeshedPanel& meshed) const {
  const std::string part = rolled_part(p);
  meshed.part = part;
  meshed.placement = {};
  meshed.placement.around = 1;
  const bool is_arm = part.ends_with("_arm");
  meshed.placement.axis = up_axis(p, is_arm);
  if (!is_arm) meshed.placement.at = "waist";
}

bool Piece::place(std::vector<Vec3>& placed, std::vector<FoundPlace>& found,
                  std::vector<MeshedPanel>& meshed) {
  sort_panels();
  const auto groups = connected(flat_);
  if (groups.size() > 1) {
    const auto smallest = std::ranges::min_element(
        groups, {}, [&](const auto& group) { return size(group.front()); });
    throw Error("panel '" + panel(smallest->front()).name + "'",
                "is sewn to panels that go around a part only", place_remedy);
  }
  if (!flat_.empty()) {
    if (flat_.size() == 1 && around_.empty()) {
      throw Error("panel '" + panel(flat_.front()).name + "'",
                  "is sewn to no other panel, so that nothing tells its place", place_remedy);
    }
    lay_sheets();
    stand_sheets(placed);
  }
  for (const int p : hoods_) stand_hood(p, placed);
  for (const int p : around_) roll(p, meshed[p]);
  for (std::size_t i = 0; i < flat_.size(); ++i) {
    found[flat_[i]].side = layout_.back[i] ? PlacementSide::back : PlacementSide::front;
  }
  for (const int p : hoods_) {
    const double x = placed[panel(p).first_point].x();
    found[p].side = x > sizes_.middle() ? PlacementSide::left : PlacementSide::right;
  }
  for (const int p : around_) {
    found[p].around = true;
    found[p].side = side_or_default(meshed[p].placement, meshed[p].part);
  }
  return !flat_.empty() && crotch_height().has_value();
}

/// The part of a panel that stands in a sheet. `nearest`: the one with the nearest bones.
std::string part_of(const PanelMesh& garment, int p, const std::string& nearest, bool has_legs) {
  const MeshedPanel& panel = garment.panels[p];
  double x = 0;
  for (int i = panel.first_point; i < panel.first_point + panel.points; ++i) {
    x += garment.placed[i].x();
  }
  const std::string side = x > 0 ? "left_" : "right_";
  if (names_hood(panel.name)) return "head";
  switch (kind_of(panel)) {
    case PanelKind::sleeve:
      return side + "arm";
    case PanelKind::trousers:
      return side + "leg";
    case PanelKind::unknown:
      return nearest.ends_with("_leg") && !has_legs ? "torso" : nearest;
    default:
      return "torso";
  }
}

}  // namespace

std::pair<std::string, AskedPlace> parse_asked_place(const std::string& text) {
  const auto refuse = [&](const std::string& problem) {
    return Error("--place '" + text + "'", problem,
                 "say PANEL=PART:SIDE, as in front=torso:front; PART is torso, head, left_arm, "
                 "right_arm, left_leg or right_leg, SIDE is front, back, left, right or around");
  };
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos || equals == 0) throw refuse("names no panel");
  AskedPlace place;
  std::string rest = text.substr(equals + 1);
  if (rest.empty()) throw refuse("says no place");
  while (!rest.empty()) {
    const std::size_t colon = rest.find(':');
    const std::string word = rest.substr(0, colon);
    rest = colon == std::string::npos ? "" : rest.substr(colon + 1);
    const auto side = std::ranges::find(sides, word, [](const auto& s) { return s.first; });
    if (std::ranges::find(body_parts, word) != body_parts.end() && place.part.empty()) {
      place.part = word;
    } else if (word == "around") {
      place.around = true;
    } else if (side != sides.end() && place.side == PlacementSide::none) {
      place.side = side->second;
    } else {
      throw refuse("has an unknown word '" + word + "'");
    }
  }
  return {text.substr(0, equals), place};
}

std::string side_name(PlacementSide side) {
  const auto found = std::ranges::find(sides, side, [](const auto& s) { return s.second; });
  return found == sides.end() ? "" : found->first;
}

std::string text_of(const FoundPlace& place) {
  std::string part = place.part;
  std::ranges::replace(part, '_', ' ');
  std::string text = place.panel + ": " + part + ", ";
  text += place.around ? "around" : side_name(place.side);
  return place.asked ? text + " (as asked)" : text;
}

std::vector<FoundPlace> find_places(const TriangleMesh& body, const Skeleton& skeleton,
                                    const AskedPlaces& asked, PanelMesh& garment) {
  for (const auto& [name, place] : asked) {
    if (std::ranges::find(garment.panels, name, &MeshedPanel::name) == garment.panels.end()) {
      throw Error("--place", "there is no panel '" + name + "'", "the garment's file names its panels");
    }
  }
  if (!has_all_limbs(skeleton)) {
    throw Error("panel '" + garment.panels.front().name + "'",
                "states no place, and the skeleton lacks joints that would tell it",
                "let clean-body write the skeleton, or place the panels in the pattern");
  }
  const BodySizes sizes(body, skeleton);
  const std::vector<int> panel_of = panel_of_points(garment);
  DisjointSets sewn(garment.panels.size());
  for (const MeshedSeam& seam : garment.seams) sewn.join(panel_of[seam.a[1]], panel_of[seam.b[1]]);
  std::vector<FoundPlace> found(garment.panels.size());
  std::map<int, std::vector<int>> pieces;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    found[p].panel = garment.panels[p].name;
    found[p].asked = asked.contains(garment.panels[p].name);
    pieces[sewn.of(static_cast<int>(p))].push_back(static_cast<int>(p));
  }
  std::vector<char> has_legs(garment.panels.size(), 0);  // per panel: its piece has
  std::vector<Vec3> placed = garment.placed;
  std::vector<MeshedPanel> meshed = garment.panels;
  for (MeshedPanel& panel : meshed) panel.placement = {};
  for (const auto& [lowest, panels] : pieces) {
    const bool legs = Piece(garment, skeleton, sizes, asked, panels).place(placed, found, meshed);
    for (const int p : panels) has_legs[p] = legs;
  }
  garment.placed = std::move(placed);
  garment.panels = std::move(meshed);
  garment.has_places = true;
  const std::vector<std::string> parts = panel_parts(garment, skeleton);
  for (std::size_t p = 0; p < found.size(); ++p) {
    MeshedPanel& panel = garment.panels[p];
    const auto place = asked.find(panel.name);
    if (place != asked.end() && !place->second.part.empty()) panel.part = place->second.part;
    if (panel.part.empty()) {
      found[p].part = part_of(garment, static_cast<int>(p), parts[p], has_legs[p] != 0);
      // What a garment wraps, and whether it is worn where it belongs, goes by parts.
      if (found[p].part != "head") panel.part = found[p].part;
    } else {
      found[p].part = panel.part;
    }
  }
  return found;
}

}  // namespace toile
