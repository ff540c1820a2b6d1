#include "pattern/seams/seam_pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "pattern/classify/classify.h"

namespace toile {

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Longer over shorter side: no seam is gathered more.
constexpr double max_fullness = 4;

/// Metres: what is shorter is not meant to be sewn. mesh-pattern merges it with its neighbour.
constexpr double shortest_seam = 5e-4;

/// Places in the file: pieces that stand farther from each other are as rarely sewn together.
constexpr int farthest_in_file = 8;

/// Metres: front and back may meet in a seam that is shorter, as where a sleeve is set in askew.
constexpr double short_seam = 0.03;

/// Cosine between the warp and the way out of an edge: from here on it is a neckline, no middle
/// seam.
constexpr double neck_slant = 0.3;

/// Metres: a longer cut into a skirt or trousers is a slit, whichever way it points.
constexpr double longest_dart = 0.25;

/// Radians that the hem of a circle skirt turns outwards at least. Its waist turns inwards.
constexpr double least_hem_turn = 0.2;

/// Of the face of a hood: share of the panel's longest edge, and radians that it turns outwards.
constexpr double long_edge = 0.6;
/// The same of its crown.
constexpr double crown_edge = 0.3;
constexpr double straight = 10 * degree;

/// How much the curves of two sides speak for a seam, 0 to 1. Straight sides say nothing.
double curve_match(const std::array<double, 4>& a, const std::array<double, 4>& b) {
  double size = 0;
  double alike = 0;
  double into = 0;
  for (int k = 0; k < 4; ++k) {
    size += std::abs(a[k]) + std::abs(b[3 - k]);
    alike += std::abs(a[k] - b[3 - k]);
    into += std::abs(a[k] + b[3 - k]);
  }
  if (size < 4 * degree) return 0;
  return 1 - 2 * std::min(alike, into) / size;
}

/// Whether an edge of a skirt faces down, or is the outer one of a circle.
bool is_hem(const WalkedEdge& edge) {
  return edge.upwards < -0.5 || turning_of(edge) > least_hem_turn;
}

/// Whether a piece hangs from another by its upper edge: a skirt from its waistband, a flounce from
/// a cuff or a sleeve.
bool hangs_from(const PanelWords& hung, const PanelWords& held_by) {
  using enum PanelRole;
  if (held_by.role == waistband) return hung.role == skirt || hung.role == trousers;
  const bool is_flounce = hung.role == cuff && hung.says(skirt);
  return is_flounce && hung.stem != held_by.stem;
}

}  // namespace

SeamEvidence seam_evidence(const Pattern& pattern, bool drawn_walk,
                           const std::vector<char>& turned_over) {
  SeamEvidence evidence;
  evidence.edges = walked_edges(pattern, drawn_walk, turned_over);
  evidence.turned_over = turned_over;
  evidence.turned_over.resize(pattern.panels.size(), 0);
  for (const PatternPanel& panel : pattern.panels) evidence.words.push_back(words_of(panel));
  evidence.fits = panel_fits(evidence.edges);
  evidence.shapes = edge_shapes(evidence.edges, evidence.fits);
  evidence.mirror = mirror_partners(evidence.edges, evidence.fits, evidence.words);
  return evidence;
}

double turning_of(const WalkedEdge& edge) {
  return edge.turning[0] + edge.turning[1] + edge.turning[2] + edge.turning[3];
}

int edge_across(const std::vector<WalkedEdge>& edges, int edge) {
  const int across = edges[edges[edge].next].next;
  return across != edge && edges[edges[across].next].next == edge ? across : -1;
}

SeamPairs::SeamPairs(const SeamEvidence& evidence, bool heed_sides)
    : edges_(evidence.edges),
      words_(evidence.words),
      mirror_(evidence.mirror),
      shape_(evidence.shapes.shape),
      turned_over_(evidence.turned_over),
      heed_sides_(heed_sides) {}

bool SeamPairs::possible(int a, int b) const {
  if (a == b) return false;
  if (std::min(edges_[a].length, edges_[b].length) < shortest_seam) return false;
  const PanelWords& first = words_[edges_[a].ref.panel];
  const PanelWords& second = words_[edges_[b].ref.panel];
  if (!may_meet(first.role, second.role)) return false;
  if (heed_sides_ && first.side * second.side < 0 && first.stem != second.stem) return false;
  const bool arms = first.role == PanelRole::sleeve || first.role == PanelRole::cuff;
  if (arms && first.side * second.side < 0) return false;
  // Neighbours on an outline are sewn as darts alone.
  if (edges_[a].next == b && edges_[b].corner < sharpest_dart_tip) return false;
  if (edges_[b].next == a && edges_[a].corner < sharpest_dart_tip) return false;
  const double ratio = edges_[a].length / edges_[b].length;
  return ratio < max_fullness && ratio > 1 / max_fullness;
}

SeamMeasures SeamPairs::measures(int a, int b) const {
  SeamMeasures measures{};
  measure_shapes(a, b, measures);
  if (edges_[a].ref.panel != edges_[b].ref.panel) {
    measure_names(a, b, measures);
    if (heed_sides_) measure_halves(a, b, measures);
  }
  return measures;
}

void SeamPairs::measure_shapes(int a, int b, SeamMeasures& measures) const {
  const auto at = [&](SeamMeasure measure) -> double& {
    return measures[static_cast<int>(measure)];
  };
  using enum SeamMeasure;
  const WalkedEdge& first = edges_[a];
  const WalkedEdge& second = edges_[b];
  at(seam) = 1;
  const double ratio =
      std::max(first.length, second.length) / std::min(first.length, second.length);
  const bool are_halves = mirror_[a] == b && first.ref.panel != second.ref.panel;
  const double turn_a = turning_of(first);
  const double turn_b = turning_of(second);
  const bool folded = turned_over_[first.ref.panel] != turned_over_[second.ref.panel];
  if (folded) at(folded_over) = 1;
  // Halves that turn inwards meet at the crotch. Those of a hood frame the face, and stay open.
  const bool frames_face = words_[first.ref.panel].role == PanelRole::hood;
  const bool at_crotch = are_halves && !frames_face;
  if (at_crotch) at(halves_concave) = std::clamp(-turn_a, 0.0, 1.0);
  // A collar that lies on the bodice has the curve of its neckline.
  if (!at_crotch && !folded) at(concave) = std::max(0.0, std::min(-turn_a, -turn_b));
  const bool tip = (first.next == b && edges_[b].corner > sharpest_dart_tip) ||
                   (second.next == a && edges_[a].corner > sharpest_dart_tip);
  if (tip && ratio < 1.05) {
    at(dart) = 1;
    // From the opening to the tip, by the warp as drawn.
    const bool leads = first.next == b && edges_[b].corner > sharpest_dart_tip;
    const double up = (leads ? first.rise - second.rise : second.rise - first.rise) / 2;
    at(dart_upwards) = std::max(0.0, up);
    const PanelRole role = words_[first.ref.panel].role;
    if (role == PanelRole::skirt || role == PanelRole::trousers) {
      const int opening = leads ? first.previous : second.previous;
      const int closing = leads ? second.next : first.next;
      const bool cuts_hem = is_hem(edges_[opening]) && is_hem(edges_[closing]);
      at(slit) = cuts_hem || first.length > longest_dart ? 1 : std::max(0.0, up);
    }
    return;
  }
  const double up = first.upwards * second.upwards;
  at(up_and_down) = std::max(0.0, -up);
  if (first.upwards > 0 && second.upwards > 0) at(both_up) = up;
  // A sleeve is drawn along the arm or across it.
  const bool sleeves = role(a) == PanelRole::sleeve && role(b) == PanelRole::sleeve;
  if (first.upwards < 0 && second.upwards < 0 && !sleeves) at(both_down) = up;
  // The end of one meets the start of the other.
  const double rise = -first.rise * second.rise;
  at(rise_together) = std::max(0.0, rise);
  at(rise_apart) = std::max(0.0, -rise);
  at(same_panel) = first.ref.panel == second.ref.panel ? 1 : 0;
  const int places = std::abs(first.ref.panel - second.ref.panel);
  if (places > 0 && !are_named_halves(a, b)) {
    at(far_in_file) = std::log(std::min(places, farthest_in_file));
  }
  if (shape_[a] == shape_[b]) {
    at(coincide) = 1;
    const bool crotch = at_crotch && words_[first.ref.panel].role == PanelRole::trousers;
    if (!crotch || turn_a > 0) {
      at(coincide_curved) = std::min(std::abs(turn_a) + std::abs(turn_b), std::numbers::pi);
    }
    const bool at_crown =
        are_halves && frames_face && first.length > crown_edge * longest_of_panel(a);
    at(across_grain) = up > -0.5 && !at_crown ? first.across_grain : 0;
    if (are_halves) at(halves) = first.length / longest_of_panel(a);
    return;
  }
  if (std::abs(first.length - second.length) < 1e-4) {
    at(equal_length) = 1;
    at(rare_length) = is_rare(first.length, a, b) ? 1 : 0;
  }
  const double end_a = narrowing(a);
  const double end_b = narrowing(b);
  at(ends_differ) = std::sqrt(std::max(0.0, -end_a * end_b));
  at(ends_alike) = std::sqrt(std::max(0.0, end_a * end_b));
  at(close_length) = std::exp(-(ratio - 1) / 0.005);
  at(near_length) = std::exp(-(ratio - 1) / 0.03);
  at(log_ratio) = std::log(ratio);
  if (ratio < 1.3)
    at(curve) = curve_match(first.turning, second.turning);
  else
    at(curve_gathered) = curve_match(first.turning, second.turning);
  at(grains_differ) = std::abs(first.across_grain - second.across_grain);
}

/// Cosine between the way out of the panel and the way to the body's middle, as the names of side
/// and face tell it. 0: they do not.
double SeamPairs::inwards(int edge) const {
  const PanelWords& words = words_[edges_[edge].ref.panel];
  return -words.side * words.face * edges_[edge].rise;
}

/// What left and right, front and back say of the edges of a half, as its right side is drawn.
void SeamPairs::measure_halves(int a, int b, SeamMeasures& measures) const {
  const auto at = [&](SeamMeasure measure) -> double& {
    return measures[static_cast<int>(measure)];
  };
  using enum SeamMeasure;
  const PanelWords& first = words_[edges_[a].ref.panel];
  const PanelWords& second = words_[edges_[b].ref.panel];
  const bool bodice = first.role == PanelRole::bodice && second.role == PanelRole::bodice;
  const bool trousers = first.role == PanelRole::trousers && second.role == PanelRole::trousers;
  if (!bodice && !trousers) return;
  const double middle = std::max(0.0, std::min(inwards(a), inwards(b)));
  if (first.side == second.side && first.face * second.face < 0 && bodice) {
    at(centres_apart) = middle;
  }
  if (first.side * second.side < 0 && first.face == second.face) {
    // A V-neck runs to the middle, but goes on upwards.
    const double up = std::max({0.0, edges_[a].upwards, edges_[b].upwards});
    at(centre_seam) = middle * std::max(0.0, 1 - up / neck_slant);
    at(outsides_meet) = std::max(0.0, std::min(-inwards(a), -inwards(b)));
  }
}

/// Whether names say that the edges' pieces are the left and the right half of one.
bool SeamPairs::are_named_halves(int a, int b) const {
  const PanelWords& first = words_[edges_[a].ref.panel];
  const PanelWords& second = words_[edges_[b].ref.panel];
  return first.stem == second.stem && first.face == second.face && first.side * second.side < 0;
}

PanelRole SeamPairs::role(int edge) const { return words_[edges_[edge].ref.panel].role; }

/// Logarithm of the length of the edge across a panel of four edges over that of this one.
double SeamPairs::narrowing(int edge) const {
  const int across = edge_across(edges_, edge);
  if (across < 0) return 0;
  return std::clamp(std::log(edges_[across].length / edges_[edge].length), -1.0, 1.0);
}

double SeamPairs::longest_of_panel(int edge) const {
  double longest = edges_[edge].length;
  for (int e = edges_[edge].next; e != edge; e = edges_[e].next) {
    longest = std::max(longest, edges_[e].length);
  }
  return longest;
}

/// Whether all edges of this length have the shape of one of the two.
bool SeamPairs::is_rare(double length, int a, int b) const {
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    if (std::abs(edges_[e].length - length) < 1e-4 && shape_[e] != shape_[a] &&
        shape_[e] != shape_[b]) {
      return false;
    }
  }
  return true;
}

/// Whether the panels of two edges coincide.
bool SeamPairs::are_alike(int a, int b) const {
  for (int e = edges_[b].next;; e = edges_[e].next) {
    if (shape_[e] == shape_[a]) return true;
    if (e == b) return false;
  }
}

/// The lowest number of the pieces of one name.
int SeamPairs::lowest_number(const std::string& stem) const {
  int lowest = std::numeric_limits<int>::max();
  for (const PanelWords& words : words_) {
    if (words.stem == stem && words.number >= 0) lowest = std::min(lowest, words.number);
  }
  return lowest;
}

namespace {

/// Words that both names have, over the words of the one that has fewer. Each word is kept with a
/// blank after it.
double words_shared(const std::string& a, const std::string& b) {
  const auto list = [](const std::string& words) {
    std::vector<std::string> all;
    for (std::size_t at = 0; at < words.size();) {
      const std::size_t end = words.find(' ', at);
      all.push_back(words.substr(at, end - at));
      at = end + 1;
    }
    return all;
  };
  const std::vector<std::string> first = list(a);
  const std::vector<std::string> second = list(b);
  if (first.empty() || second.empty()) return 0;
  int shared = 0;
  for (const std::string& word : first) {
    shared += std::find(second.begin(), second.end(), word) != second.end() ? 1 : 0;
  }
  return static_cast<double>(shared) / static_cast<double>(std::min(first.size(), second.size()));
}

}  // namespace

void SeamPairs::measure_names(int a, int b, SeamMeasures& measures) const {
  const auto at = [&](SeamMeasure measure) -> double& {
    return measures[static_cast<int>(measure)];
  };
  using enum SeamMeasure;
  const PanelWords& first = words_[edges_[a].ref.panel];
  const PanelWords& second = words_[edges_[b].ref.panel];
  const bool named = first.role != PanelRole::unknown && second.role != PanelRole::unknown;
  if (named && first.role != second.role) at(roles_agree) = 1;
  if (first.side * second.side < 0 && mirror_[a] != b) at(sides_differ) = 1;
  for (const auto& [holds, hung] : {std::pair(a, b), std::pair(b, a)}) {
    if (hangs_from(words_[edges_[hung].ref.panel], words_[edges_[holds].ref.panel])) {
      at(hangs_turned) = 1 - edges_[hung].upwards;
      if (role(holds) == PanelRole::waistband) at(hangs_turned) += 1 + edges_[holds].upwards;
    }
  }
  if (first.stem != second.stem) {
    if (first.face * second.face < 0) {
      const double shorter = std::min(edges_[a].length, edges_[b].length);
      at(faces_differ) = std::min(1.0, shorter / short_seam);
    }
    if (first.face * second.face > 0) at(faces_agree) = 1;
    if (named) at(words_alike) = words_shared(first.stem, second.stem);
  } else {
    const bool faces = first.face * second.face < 0;
    const bool both = first.number >= 0 && second.number >= 0;
    if (are_named_halves(a, b) && mirror_[a] == b) {
      at(named_halves) = 1;
      const double part = edges_[a].length / longest_of_panel(a);
      if (first.role == PanelRole::collar) at(collar_halves) = part;
      if (first.role == PanelRole::hood && part > long_edge && turning_of(edges_[a]) < straight) {
        at(hood_face) = 1;
      }
    }
    if (faces) {
      const double up = edges_[a].upwards * edges_[b].upwards;
      const bool hems = first.role == PanelRole::skirt && edges_[a].upwards < 0 && up > 0;
      at(end_to_end) = hems ? up : std::max(0.0, -up);
    }
    if (first.face * second.face > 0 && first.side == second.side &&
        first.number != second.number) {
      at(numbered_sides) = std::min(std::abs(edges_[a].rise), std::abs(edges_[b].rise));
    }
    if (faces && first.number != second.number) {
      at(numbers_differ) = 1;
    } else if (named && faces) {
      at(front_and_back) = 1;
    }
    if (faces || first.number == second.number) return;
    if (!both) {
      at(std::max(first.number, second.number) == lowest_number(first.stem) ? first_number
                                                                            : later_number) = 1;
    } else if (named && !are_alike(a, b)) {
      at(std::abs(first.number - second.number) == 1 ? numbers_follow : numbers_apart) = 1;
    }
  }
}

}  // namespace toile
