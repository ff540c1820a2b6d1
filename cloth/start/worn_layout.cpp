#include "cloth/start/worn_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <string>
#include <utility>

#include "cloth/start/constants.h"

namespace toile {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

WornLayout::WornLayout(const PanelMesh& garment, FlatLayout layout, std::size_t around)
    : garment_(garment),
      panel_of_(panel_of_points(garment)),
      layout_(std::move(layout)),
      around_(around) {
  find_landmarks();
}

void WornLayout::find_landmarks() {
  openings_ = flat_openings(garment_, layout_);
  shoulders_ = shoulder_points(garment_, layout_);
  // Where a frill is sewn on, cloth has an upper border too.
  double low = infinity;
  double high = -infinity;
  for (const FlatOpening& opening : openings_) {
    low = std::min(low, opening.low);
    high = std::max(high, opening.high);
  }
  std::erase_if(shoulders_,
                [&](const Vec2& p) { return p.y() < high - max_shoulder_drop * (high - low); });
}

void WornLayout::shift(const Vec2& by) {
  layout_.move(1, {by.x(), by.y()});
  find_landmarks();
}

bool WornLayout::has(PanelRole wanted) const {
  return std::ranges::any_of(layout_.panels, [&](int p) { return panel(p).is.worn_as == wanted; });
}

/// Whether the garment hangs from the shoulders.
bool WornLayout::hangs() const {
  const bool is_bottom =
      !has(PanelRole::bodice) && !has(PanelRole::sleeve) && !has(PanelRole::unknown);
  if (is_bottom || shoulders_.empty()) return false;
  return has(PanelRole::sleeve) || openings_.size() + around_ > 2;
}

/// Metres: x of the garment's middle in the picture.
double WornLayout::middle() const {
  double moment = 0;
  double area = 0;
  for (std::size_t i = 0; i < layout_.panels.size(); ++i) {
    if (panel(layout_.panels[i]).is.worn_as == PanelRole::sleeve) continue;
    const MeshedPanel& of = panel(layout_.panels[i]);
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

bool WornLayout::is_upside_down() const {
  // The sample's hem is 2.3 times its neckline. Half of this doubts garments with wide necks,
  // double doubts none.
  constexpr double widest_neck = 1.5;  // of the hem
  if (!has(PanelRole::sleeve)) return false;
  const double x = middle();
  std::vector<double> lengths;  // of the openings about the trunk, the highest first
  for (const FlatOpening& opening : openings_) {
    if (opening.both_faces && opening.left < x && x < opening.right) {
      lengths.push_back(opening.length);
    }
  }
  return lengths.size() == 2 && lengths[0] > widest_neck * lengths[1];
}

void WornLayout::choose_front() {
  const double x = middle();
  if (hangs()) {
    const double front = face_top(garment_, layout_, false, x);
    const double back = face_top(garment_, layout_, true, x);
    if (std::abs(front - back) > min_neck_difference) {
      if (front > back) layout_.change_faces();
    }
  } else {
    std::array<double, 2> areas{};
    for (std::size_t i = 0; i < layout_.panels.size(); ++i) {
      const MeshedPanel& of = panel(layout_.panels[i]);
      for (int t = of.first_triangle; t < of.first_triangle + of.triangles; ++t) {
        const auto& [a, b, c] = garment_.triangles[t];
        const Vec2 ab = garment_.flat[b] - garment_.flat[a];
        const Vec2 ac = garment_.flat[c] - garment_.flat[a];
        areas[layout_.back[i] ? 1 : 0] += std::abs(ab.x() * ac.y() - ab.y() * ac.x());
      }
    }
    if (areas[0] > areas[1]) layout_.change_faces();
  }
  find_landmarks();
}

/// Metres: how far the picture has to be raised.
double WornLayout::rise(const BodySizes& sizes, const Skeleton& skeleton) const {
  if (hangs()) {
    // What lies beside the neck counts; of a garment with none, the nearest to it.
    const double x = middle();
    double sum = 0;
    int count = 0;
    double nearest = infinity;
    double nearest_rise = 0;
    for (const Vec2& p : shoulders_) {
      const double aside = std::abs(p.x() - x);
      const double share = aside / sizes.shoulder();
      const double rise = sizes.shoulder_height(std::min(aside, sizes.shoulder())) - p.y();
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
  const auto around = std::ranges::find_if(openings_, &FlatOpening::both_faces);
  if (around == openings_.end()) {
    double top = -infinity;
    for (const FlatOpening& opening : openings_) top = std::max(top, opening.high);
    return skeleton.joint("waist").y() - (std::isfinite(top) ? top : 0);
  }
  if (is_strapless(*around, sizes.waist_girth()))
    return skeleton.joint("chest").y() - around->mean_height;
  const double rise = skeleton.joint("waist").y() - waist_border_depth - around->mean_height;
  const std::optional<double> crotch = crotch_height();
  if (!crotch) return rise;
  return std::min(rise, skeleton.joint("pelvis").y() - crotch_depth - *crotch);
}

/// Whether the garment, which does not hang from the shoulders, is worn about the chest.
bool WornLayout::is_strapless(const FlatOpening& top, double waist_girth) const {
  if (has(PanelRole::bodice)) return true;
  if (has(PanelRole::skirt) || has(PanelRole::trousers) || has(PanelRole::waistband)) return false;
  const bool has_elastic =
      std::ranges::any_of(garment_.elastics, [&](const MeshedElastic& elastic) {
        return std::ranges::find(layout_.panels, panel_of_[elastic.points.front()]) !=
               layout_.panels.end();
      });
  if (has_elastic || openings_.size() != 2) return false;
  return top.length > wide_tube_ratio * waist_girth &&
         top.mean_height - openings_.back().mean_height < short_tube_height;
}

std::optional<double> WornLayout::crotch_height() const {
  const double x = middle();
  std::optional<double> lowest;
  for (const MeshedSeam& seam : garment_.seams) {
    const auto a = std::ranges::find(layout_.panels, panel_of_[seam.a[1]]);
    const auto b = std::ranges::find(layout_.panels, panel_of_[seam.b[1]]);
    if (a == layout_.panels.end() || b == layout_.panels.end() || a == b) continue;
    const auto i = static_cast<std::size_t>(a - layout_.panels.begin());
    const auto j = static_cast<std::size_t>(b - layout_.panels.begin());
    if (layout_.back[i] != layout_.back[j]) continue;
    if ((centre(i).x() > x) == (centre(j).x() > x)) continue;
    for (const int p : seam.a) {
      const double y = layout_.picture(i, garment_.flat[p]).y();
      if (!lowest || y < *lowest) lowest = y;
    }
  }
  if (!lowest || !leg_opening(*lowest, true) || !leg_opening(*lowest, false)) return std::nullopt;
  return lowest;
}

/// The opening of a leg below the crotch; null: there is none.
const FlatOpening* WornLayout::leg_opening(double crotch, bool left) const {
  const double x = middle();
  const auto found = std::ranges::find_if(openings_, [&](const FlatOpening& opening) {
    const double aside = 0.5 * (opening.left + opening.right) - x;
    return opening.high < crotch && (left ? aside > min_leg_offset : aside < -min_leg_offset);
  });
  return found == openings_.end() ? nullptr : &*found;
}

std::vector<std::size_t> WornLayout::leg_panels(bool left) const {
  std::vector<std::size_t> leg;
  const std::optional<double> crotch = crotch_height();
  if (!crotch) return leg;
  const double x = middle();
  for (std::size_t i = 0; i < layout_.panels.size(); ++i) {
    const MeshedPanel& of = panel(layout_.panels[i]);
    double low = infinity;
    double across = -infinity;  // how far it reaches beyond the middle
    for (int p = of.first_point; p < of.first_point + of.points; ++p) {
      const Vec2 at = layout_.picture(i, garment_.flat[p]);
      low = std::min(low, at.y());
      across = std::max(across, left ? x - at.x() : at.x() - x);
    }
    // A back reaches across the middle with the tip of its crotch.
    const double aside = left ? centre(i).x() - x : x - centre(i).x();
    if (low < *crotch - crotch_strip && across < aside) leg.push_back(i);
  }
  return leg;
}

void WornLayout::straighten_legs(const Skeleton& skeleton) {
  const std::optional<double> crotch = crotch_height();
  if (!crotch) return;
  const double x = middle();
  for (const bool left : {true, false}) {
    const std::vector<std::size_t> leg = leg_panels(left);
    double inner = infinity;
    double outer = -infinity;
    for (const std::size_t i : leg) {
      const MeshedPanel& of = panel(layout_.panels[i]);
      for (int p = of.first_point; p < of.first_point + of.points; ++p) {
        const Vec2 at = layout_.picture(i, garment_.flat[p]);
        const double aside = left ? at.x() - x : x - at.x();
        if (std::abs(at.y() - *crotch) > crotch_strip || aside < 0) continue;
        inner = std::min(inner, aside);
        outer = std::max(outer, aside);
      }
    }
    if (!(inner < outer)) continue;
    const double aside = 0.5 * (inner + outer);
    const FlatOpening* opening = leg_opening(*crotch, left);
    const std::complex<double> top(x + (left ? aside : -aside), *crotch);
    const std::complex<double> end(0.5 * (opening->left + opening->right), opening->mean_height);
    const std::string side = left ? "left_" : "right_";
    const Vec3 bone = skeleton.joint(side + "ankle") - skeleton.joint(side + "hip");
    std::complex<double> turn = std::complex<double>(bone.x(), bone.y()) / (end - top);
    turn /= std::abs(turn);
    for (const std::size_t i : leg) {
      layout_.turn[i] *= turn;
      layout_.at[i] = top + turn * (layout_.at[i] - top);
    }
  }
  find_landmarks();
}

/// Metres, in the picture: the mean of a panel's points.
Vec2 WornLayout::centre(std::size_t i) const {
  const MeshedPanel& of = panel(layout_.panels[i]);
  Vec2 sum = Vec2::Zero();
  for (int p = of.first_point; p < of.first_point + of.points; ++p) {
    sum += layout_.picture(i, garment_.flat[p]);
  }
  return sum / of.points;
}

}  // namespace toile
