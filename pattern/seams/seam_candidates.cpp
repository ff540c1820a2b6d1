#include "pattern/seams/seam_candidates.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace toile {

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Candidates of the whole garment, about, and of an edge at least and at most.
constexpr std::size_t all_candidates = 900;
constexpr std::size_t fewest_candidates = 9;
constexpr std::size_t most_candidates = 20;

/// Longer over shorter side: no seam is gathered more.
constexpr double max_fullness = 4;

/// Radians: the inner angle at the tip of a dart is larger.
constexpr double sharpest_dart_tip = 285 * degree;

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

class Finder {
 public:
  Finder(const SeamEvidence& evidence, const SeamMeasures& weights)
      : edges_(evidence.edges),
        words_(evidence.words),
        mirror_(evidence.mirror),
        shape_(evidence.shapes.shape),
        w_(weights) {}

  std::vector<SeamCandidate> find() {
    const int count = static_cast<int>(edges_.size());
    std::vector<std::vector<SeamCandidate>> of_edge(count);
    for (int a = 0; a < count; ++a) {
      for (int b = a + 1; b < count; ++b) {
        if (!possible(a, b)) continue;
        const SeamCandidate pair = candidate(a, b);
        of_edge[a].push_back(pair);
        of_edge[b].push_back(pair);
      }
    }
    for (auto& list : of_edge) {
      std::stable_sort(list.begin(), list.end(),
                       [](const auto& x, const auto& y) { return x.worth > y.worth; });
      const std::size_t kept =
          std::clamp(all_candidates / of_edge.size(), fewest_candidates, most_candidates);
      if (list.size() > kept) list.resize(kept);
      for (const SeamCandidate& pair : list) add(pair.a.first, pair.b.first);
    }
    // What continues a good candidate at a corner on both outlines.
    for (int round = 0; round < 2; ++round) {
      std::vector<std::array<int, 2>> more;
      for (const auto& [key, pair] : found_) {
        if (pair.worth < 0) continue;
        more.push_back({edges_[key[0]].next, edges_[key[1]].previous});
        more.push_back({edges_[key[0]].previous, edges_[key[1]].next});
      }
      for (const auto& [a, b] : more) add(a, b);
    }
    // Both halves of the garment have the same candidates.
    std::vector<std::array<int, 2>> mirrored;
    for (const auto& [key, pair] : found_) {
      if (mirror_[key[0]] >= 0 && mirror_[key[1]] >= 0) {
        mirrored.push_back({mirror_[key[0]], mirror_[key[1]]});
      }
    }
    for (const auto& [a, b] : mirrored) add(a, b);
    std::vector<SeamCandidate> all;
    for (const auto& [key, pair] : found_) all.push_back(pair);
    return all;
  }

 private:
  bool possible(int a, int b) const {
    if (a == b) return false;
    const PanelWords& first = words_[edges_[a].ref.panel];
    const PanelWords& second = words_[edges_[b].ref.panel];
    if (!may_meet(first.role, second.role)) return false;
    const bool sides_count = w_[static_cast<int>(SeamMeasure::sides_differ)] != 0;
    if (sides_count && first.side * second.side < 0 && first.stem != second.stem) return false;
    const bool arms = first.role == PanelRole::sleeve || first.role == PanelRole::cuff;
    if (arms && first.side * second.side < 0) return false;
    // Neighbours on an outline are sewn as darts alone.
    if (edges_[a].next == b && edges_[b].corner < sharpest_dart_tip) return false;
    if (edges_[b].next == a && edges_[a].corner < sharpest_dart_tip) return false;
    const double ratio = edges_[a].length / edges_[b].length;
    return ratio < max_fullness && ratio > 1 / max_fullness;
  }

  void add(int a, int b) {
    if (a > b) std::swap(a, b);
    if (!possible(a, b)) return;
    if (!found_.contains({a, b})) found_[{a, b}] = candidate(a, b);
  }

  SeamCandidate candidate(int a, int b) const {
    SeamCandidate made{{a, 1}, {b, 1}, 0};
    SeamMeasures measures{};
    measure(a, b, measures);
    if (edges_[a].ref.panel != edges_[b].ref.panel) measure_names(a, b, measures);
    made.worth = worth_of(measures, w_);
    return made;
  }

  void measure(int a, int b, SeamMeasures& measures) const {
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
    if (!are_halves) at(concave) = std::max(0.0, std::min(-turning(first), -turning(second)));
    const bool tip = (first.next == b && edges_[b].corner > sharpest_dart_tip) ||
                     (second.next == a && edges_[a].corner > sharpest_dart_tip);
    if (tip && ratio < 1.05) {
      at(dart) = 1;
      return;
    }
    at(same_panel) = first.ref.panel == second.ref.panel ? 1 : 0;
    if (shape_[a] == shape_[b]) {
      at(coincide) = 1;
      at(coincide_curved) =
          std::min(std::abs(turning(first)) + std::abs(turning(second)), std::numbers::pi);
      at(across_grain) = first.across_grain;
      if (are_halves) at(halves) = first.length / longest_of_panel(a);
      return;
    }
    if (std::abs(first.length - second.length) < 1e-4) {
      at(equal_length) = 1;
      at(rare_length) = is_rare(first.length, a, b) ? 1 : 0;
    }
    at(close_length) = std::exp(-(ratio - 1) / 0.005);
    at(near_length) = std::exp(-(ratio - 1) / 0.03);
    at(log_ratio) = std::log(ratio);
    if (ratio < 1.3) at(curve) = curve_match(first.turning, second.turning);
  }

  static double turning(const WalkedEdge& edge) {
    return edge.turning[0] + edge.turning[1] + edge.turning[2] + edge.turning[3];
  }

  double longest_of_panel(int edge) const {
    double longest = edges_[edge].length;
    for (int e = edges_[edge].next; e != edge; e = edges_[e].next) {
      longest = std::max(longest, edges_[e].length);
    }
    return longest;
  }

  /// Whether all edges of this length have the shape of one of the two.
  bool is_rare(double length, int a, int b) const {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (std::abs(edges_[e].length - length) < 1e-4 && shape_[e] != shape_[a] &&
          shape_[e] != shape_[b]) {
        return false;
      }
    }
    return true;
  }

  void measure_names(int a, int b, SeamMeasures& measures) const {
    const auto at = [&](SeamMeasure measure) -> double& {
      return measures[static_cast<int>(measure)];
    };
    using enum SeamMeasure;
    const PanelWords& first = words_[edges_[a].ref.panel];
    const PanelWords& second = words_[edges_[b].ref.panel];
    const bool named = first.role != PanelRole::unknown && second.role != PanelRole::unknown;
    if (named && first.role != second.role) at(roles_agree) = 1;
    if (first.side * second.side < 0 && mirror_[a] != b) at(sides_differ) = 1;
    if (first.stem != second.stem) {
      if (first.face * second.face < 0) at(faces_differ) = 1;
      if (first.face * second.face > 0) at(faces_agree) = 1;
    } else if (first.number >= 0 && second.number >= 0) {
      const int apart = std::abs(first.number - second.number);
      if (apart == 1) at(numbers_follow) = 1;
      if (apart > 1 && first.face == second.face) at(numbers_apart) = 1;
    }
  }

  const std::vector<WalkedEdge>& edges_;
  const std::vector<PanelWords>& words_;
  const std::vector<int>& mirror_;
  const std::vector<int>& shape_;
  const SeamMeasures& w_;
  std::map<std::array<int, 2>, SeamCandidate> found_;
};

}  // namespace

std::vector<SeamCandidate> seam_candidates(const SeamEvidence& evidence,
                                           const SeamMeasures& weights) {
  return Finder(evidence, weights).find();
}

std::vector<int> edges_of(const std::vector<WalkedEdge>& edges, const SeamSide& side) {
  std::vector<int> list;
  for (int i = 0, e = side.first; i < side.count; ++i, e = edges[e].next) list.push_back(e);
  return list;
}

}  // namespace toile
