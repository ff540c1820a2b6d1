#include "pattern/seams/sewn_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/disjoint_sets.h"

namespace toile {

namespace {

constexpr double one_degree = std::numbers::pi / 180;
constexpr double right_angle = 90 * one_degree;

/// Units of 90 degrees: by how much corners are counted as missing what closes flat, at most.
constexpr double most_off = 1.5;

/// Change of the fullness that counts as 1.
constexpr double full_jump = 0.2;

/// Metres: a change of fullness counts less beside an edge that is shorter.
constexpr double short_edge = 0.03;

/// Logarithms of lengths: a seam is gathered; two seams are gathered alike.
constexpr double gathered = 0.03;
constexpr double alike = 0.004;

/// Of two edges that are one curve cut in two: the corner between them, less 180 degrees, and the
/// change of curvature, 1/m. Of 160 random garments no other edges come near both.
constexpr double most_kink = 0.15 * one_degree;
constexpr double curvature_change = 0.1;

/// Metres: borders of a garment that are shorter are holes, or small.
constexpr double hole = 0.08;
constexpr double small_border = 0.16;

/// Whether one curve, without a notch, was cut in two where this edge starts.
bool cuts_a_curve(const WalkedEdge& before, const WalkedEdge& edge) {
  const double curvature = 4 * edge.turning.front() / edge.length;
  const double curvature_before = 4 * before.turning.back() / before.length;
  return !edge.notch && std::abs(edge.corner - 2 * right_angle) < most_kink &&
         std::abs(curvature - curvature_before) < curvature_change;
}

/// Borders that a garment of these pieces has at least, by their names. Each sleeve and each leg
/// has one, and a neck or waist.
int least_borders(const std::vector<PanelWords>& words) {
  bool arms[2] = {};
  bool legs[2] = {};
  bool named = false;
  for (const PanelWords& panel : words) {
    named = named || panel.role != PanelRole::unknown;
    if (panel.side == 0) continue;
    const bool is_leg = panel.says(PanelRole::trousers);
    const bool is_arm =
        !is_leg && (panel.role == PanelRole::sleeve || panel.role == PanelRole::cuff);
    arms[panel.side > 0] |= is_arm;
    legs[panel.side > 0] |= is_leg;
  }
  return (named ? 1 : 0) + arms[0] + arms[1] + legs[0] + legs[1];
}

}  // namespace

SewnSurface::SewnSurface(const SeamEvidence& evidence)
    : edges_(static_cast<int>(evidence.edges.size())),
      mirror_(evidence.mirror),
      turned_over_(evidence.turned_over) {
  for (const WalkedEdge& edge : evidence.edges) {
    next_.push_back(edge.next);
    previous_.push_back(edge.previous);
    panel_.push_back(edge.ref.panel);
    length_.push_back(edge.length);
    log_length_.push_back(std::log(edge.length));
    angle_.push_back(edge.corner);
    notch_.push_back(edge.notch ? 1 : 0);
    cut_curve_.push_back(cuts_a_curve(evidence.edges[edge.previous], edge) ? 1 : 0);
    turning_.push_back(turning_of(edge));
    rise_.push_back(edge.rise);
  }
  panels_ = panel_.back() + 1;
  least_borders_ = least_borders(evidence.words);
  for (int e = 0; e < edges_; ++e) across_.push_back(edge_across(evidence.edges, e));
}

void SewnSurface::measure(const Partners& partners, SeamMeasures& sum) {
  partners_ = &partners;
  seen_.assign(edges_, 0);
  after_.assign(edges_, -1);
  border_.clear();
  int points = 0;
  for (int e = 0; e < edges_; ++e) {
    if (partners[previous_[e]] >= 0) continue;
    corners_.clear();
    int corner = e;
    for (;;) {
      corners_.push_back(corner);
      seen_[corner] = 1;
      if (partners[corner] < 0) break;
      corner = next_[partners[corner]];
    }
    ++points;
    after_[previous_[e]] = corner;
    border_.push_back({previous_[e], corner});
    measure_at_border(sum);
  }
  for (int e = 0; e < edges_; ++e) {
    if (seen_[e] != 0) continue;
    corners_.clear();
    for (int corner = e; seen_[corner] == 0; corner = next_[partners[corner]]) {
      corners_.push_back(corner);
      seen_[corner] = 1;
    }
    ++points;
    measure_inside(sum);
  }
  measure_borders(sum);
  for (int e = 0; e < edges_; ++e) {
    if (partners[e] >= 0 || across_[e] < 0 || partners[across_[e]] < 0) continue;
    const double wider = log_length_[across_[e]] - log_length_[e];
    sum[static_cast<int>(SeamMeasure::narrow_open)] += std::clamp(wider, 0.0, 1.0);
  }

  DisjointSets sewn(panels_);
  int seams = 0;
  int lopsided = 0;
  for (int a = 0; a < edges_; ++a) {
    const int b = partners[a];
    if (b < a) continue;
    ++seams;
    sewn.join(panel_[a], panel_[b]);
    if (mirror_[a] >= 0 && mirror_[b] >= 0 && partners[mirror_[a]] != mirror_[b]) ++lopsided;
  }
  int parts = 0;
  for (int p = 0; p < panels_; ++p) parts += sewn.of(p) == p ? 1 : 0;
  int borders = 0;
  for (int e = 0; e < edges_; ++e) borders += after_[e] == -2 ? 1 : 0;
  const int handles = (2 * parts - borders - (points - (edges_ - seams) + panels_)) / 2;
  using enum SeamMeasure;
  const auto at = [&](SeamMeasure measure) -> double& { return sum[static_cast<int>(measure)]; };
  at(part_left_over) += parts - 1;
  at(handle) += handles;
  at(lopsided_seam) += lopsided;
  if (borders <= 1) at(one_border) += 1;
  if (borders == 2) at(two_borders) += 1;
  at(borders_missing) += std::max(0, least_borders_ - borders);
  if (borders > 4) at(many_borders) += std::min(borders - 4, 6);
}

void SewnSurface::measure_borders(SeamMeasures& sum) {
  using enum SeamMeasure;
  const auto at = [&](SeamMeasure measure) -> double& { return sum[static_cast<int>(measure)]; };
  for (int e = 0; e < edges_; ++e) {
    if (after_[e] < 0) continue;
    double length = 0;
    for (int on = e; after_[on] >= 0;) {
      length += length_[on];
      const int next = after_[on];
      after_[on] = on == e ? -2 : -3;
      on = next;
    }
    if (length < hole) {
      at(border_hole) += 1;
    } else if (length < small_border) {
      at(border_small) += 1;
    }
  }
}

void SewnSurface::measure_inside(SeamMeasures& sum) const {
  using enum SeamMeasure;
  const auto at = [&](SeamMeasure measure) -> double& { return sum[static_cast<int>(measure)]; };
  double angle = 0;
  for (const int corner : corners_) angle += angle_[corner];
  const double off =
      weight_of_point() * std::min(std::abs(angle - 4 * right_angle) / right_angle, most_off);
  const std::size_t corners = corners_.size();
  if (is_fold()) {
    at(fold) += 1;
    return;
  }
  if (corners == 1) {
    at(angle > sharpest_dart_tip ? dart_tip : cone) += 1;
    return;
  }
  int notches = 0;
  for (const int corner : corners_) notches += notch_[corner];
  // Mirror images meet notch for notch, wherever their notches are.
  const bool says_nothing = (*partners_)[corners_.front()] == mirror_[corners_.front()];
  if (notches > 1 && !says_nothing) at(notches_meet) += notches - 1;
  if (notches == 1 && corners == 2) at(notch_alone) += 1;
  if (corners == 2 && is_filled_slit()) {
    // A godet adds its own angle to the full turn of the slit.
    at(filled_slit) += 1;
    if (angle < 4 * right_angle) at(two_inside_off) += off;
  } else if (corners == 2) {
    if (is_needless_cut()) at(needless_cut) += 1;
    at(two_inside) += 1;
    at(two_inside_off) += off;
  } else if (corners == 3) {
    at(three_inside) += 1;
    at(three_inside_off) += off;
  } else if (corners == 4) {
    at(four_inside) += 1;
    at(four_inside_off) += off;
  } else {
    at(more_inside) += 1;
    at(more_inside_off) += off;
  }
  if (corners > 2) at(junction_off) += weight_of_point() * off_junction();
  measure_fullness(true, sum);
  at(unlike) += unlikeness(true);
}

void SewnSurface::measure_at_border(SeamMeasures& sum) const {
  using enum SeamMeasure;
  const auto at = [&](SeamMeasure measure) -> double& { return sum[static_cast<int>(measure)]; };
  double angle = 0;
  for (const int corner : corners_) angle += angle_[corner];
  const double off = std::min(std::abs(angle - 2 * right_angle) / right_angle, most_off);
  const std::size_t corners = corners_.size();
  if (corners == 1) {
    if (off * right_angle < 20 * one_degree) {
      at(smooth_border) += 1;
    } else {
      at(angle < 2 * right_angle ? lone_corner : notch_in_border) += 1;
    }
    return;
  }
  if (is_fold()) {
    at(fold) += 1;
    return;
  }
  if (corners == 2) at(slit_above) += slit_above_here();
  at(corners == 2 ? two_at_border : more_at_border) += 1;
  at(corners == 2 ? two_at_border_off : more_at_border_off) += off;
  measure_fullness(false, sum);
  at(unlike) += unlikeness(false);
}

/// Whether a piece that is turned over meets one that is not, as a collar the bodice it lies on.
bool SewnSurface::is_fold() const {
  return std::any_of(corners_.begin(), corners_.end(), [&](int corner) {
    return turned_over_[panel_[corner]] != turned_over_[panel_[corners_.front()]];
  });
}

/// Whether one corner is the tip of a slit, and a corner of another panel is sewn into it.
bool SewnSurface::is_filled_slit() const {
  const auto [corner, tip] = std::minmax(angle_[corners_[0]], angle_[corners_[1]]);
  return tip > sharpest_dart_tip && corner < 2 * right_angle &&
         panel_[corners_[0]] != panel_[corners_[1]];
}

/// Whether two seams of two panels continue each other, and nothing tells why they are two.
bool SewnSurface::is_needless_cut() const {
  const auto [a, b] = std::pair(corners_[0], corners_[1]);
  return panel_[a] != panel_[b] && cut_curve_[a] != 0 && cut_curve_[b] != 0 &&
         std::abs(fullness(a, false) - fullness(a, true)) < gathered;
}

/// Whether two panels are sewn up to here, and open upwards from here on: the lesser sine.
double SewnSurface::slit_above_here() const {
  const auto [a, b] = std::pair(corners_[0], corners_[1]);
  if (panel_[a] == panel_[b] || cut_curve_[a] == 0 || cut_curve_[b] == 0) return 0;
  return std::max(0.0, std::min(-rise_[previous_[a]], rise_[b]));
}

/// Less than 1 beside a short edge, whose direction says little.
double SewnSurface::weight_of_point() const {
  double shortest = short_edge;
  for (const int corner : corners_) {
    shortest = std::min({shortest, length_[corner], length_[previous_[corner]]});
  }
  return shortest / short_edge;
}

double SewnSurface::off_junction() const {
  double least = 1;
  const std::size_t count = corners_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double one = angle_[corners_[i]];
    const double two = one + angle_[corners_[(i + 1) % count]];
    least = std::min({least, std::abs(one - 2 * right_angle) / right_angle,
                      std::abs(two - 2 * right_angle) / right_angle});
  }
  return least;
}

double SewnSurface::unlikeness(bool closed) const {
  double sum = 0;
  const std::size_t count = corners_.size();
  for (std::size_t i = 0; i < (closed ? count : count - 1); ++i) {
    const int a = corners_[i];
    const int b = corners_[(i + 1) % count];
    if (std::abs(angle_[a] + angle_[b] - 2 * right_angle) > 45 * one_degree) continue;
    sum += std::abs(turning_[previous_[a]] - turning_[b]);
  }
  return std::min(sum, std::numbers::pi);
}

double SewnSurface::fullness(int corner, bool leaving) const {
  const int own = leaving ? corner : previous_[corner];
  return log_length_[own] - log_length_[(*partners_)[own]];
}

/// Metres: the shorter side of the seam that leaves the corner or comes to it.
double SewnSurface::shorter(int corner, bool leaving) const {
  const int own = leaving ? corner : previous_[corner];
  return std::min(length_[own], length_[(*partners_)[own]]);
}

/// Whether two seams cross where four corners meet: two beside each other make a straight line.
bool SewnSurface::is_crossing() const {
  if (corners_.size() != 4) return false;
  const auto off = [&](int i) {
    return std::abs(angle_[corners_[i]] + angle_[corners_[i + 1]] - 2 * right_angle) +
           std::abs(angle_[corners_[i + 2]] + angle_[corners_[(i + 3) % 4]] - 2 * right_angle);
  };
  return std::min(off(0), off(1)) < 70 * one_degree;
}

void SewnSurface::measure_fullness(bool closed, SeamMeasures& sum) const {
  double most = 0;
  int same = 0;
  // The seam that comes to corner a runs on in the one that leaves b.
  const auto compare = [&](int a, int b) {
    const double before = fullness(a, false);
    const double behind = fullness(b, true);
    const double change = std::abs(before - behind);
    const double part = std::min(1.0, std::min(shorter(a, false), shorter(b, true)) / short_edge);
    most = std::max(most, part * change);
    const double least = std::min(std::abs(before), std::abs(behind));
    if (least > gathered && change < alike && part == 1) ++same;
  };
  const std::size_t count = corners_.size();
  if (closed && is_crossing()) {
    compare(corners_[0], corners_[1]);
    compare(corners_[1], corners_[2]);
  } else {
    for (std::size_t i = 0; i < count; ++i) {
      if (!closed && (i == 0 || i + 1 == count)) continue;
      const int corner = corners_[i];
      if (std::abs(angle_[corner] - 2 * right_angle) > 35 * one_degree) continue;
      compare(corner, corner);
    }
  }
  sum[static_cast<int>(SeamMeasure::jump)] += std::min(1.0, most / full_jump);
  sum[static_cast<int>(SeamMeasure::same_fullness)] += same;
}

}  // namespace toile
