#include "pattern/seams/spare_panels.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "geometry/disjoint_sets.h"
#include "pattern/seams/seam_choice.h"

namespace toile {

namespace {

/// Logarithm of the odds from which on an edge of a loose part may belong there.
constexpr double possible_odds = -1.5;

/// By how much the odds of one place are clearly better than those of another. Mirrored places have
/// the same but for rounding and names.
constexpr double clear_odds = 1;

/// Share of the length of a panel's seams that another one takes in its place. Edges that were cut
/// to fit the panel do not fit the other. Of the seams of a T-shirt's short sleeves, long ones take
/// 0.48.
constexpr double replaced_share = 1.0 / 3;

class SpareFinder {
 public:
  SpareFinder(const Pattern& pattern, const FindSeamsOptions& options, const FoundSeams& found)
      : is_over_(options.is_over),
        evidence_(
            heeding(found.sides, seam_evidence(pattern, options.drawn_walk, found.turned_over))),
        odds_(evidence_),
        partners_(evidence_.edges.size(), -1),
        decided_(evidence_.edges.size(), 0),
        panels_(pattern.panels.size()) {
    std::map<std::array<int, 2>, int> number;
    for (int e = 0; e < edges(); ++e) number[{edge(e).ref.panel, edge(e).ref.edge}] = e;
    for (const FoundSeam& seam : found.seams) {
      const int a = number.at({seam.a.panel, seam.a.edge});
      const int b = number.at({seam.b.panel, seam.b.edge});
      partners_[a] = b;
      partners_[b] = a;
      decided_[a] = decided_[b] = seam.confidence >= decided_confidence ? 1 : 0;
    }
  }

  std::set<int> found() const {
    std::vector<std::set<int>> parts = grouped(true);
    std::ranges::stable_sort(parts, std::ranges::greater{},
                             [&](const std::set<int>& part) { return length_of(part); });
    const std::vector<std::set<int>> pairs = grouped(false);
    std::set<int> spare;
    for (std::size_t i = 1; i < parts.size(); ++i) {
      const std::set<int>& part = parts[i];
      if (!has_no_place(part)) continue;
      const auto is_rival = [&](const std::set<int>& pair) { return may_replace(part, pair); };
      if (std::ranges::any_of(pairs, is_rival)) spare.insert(part.begin(), part.end());
    }
    return spare;
  }

 private:
  int edges() const { return static_cast<int>(partners_.size()); }
  const WalkedEdge& edge(int e) const { return evidence_.edges[e]; }
  int panel_of(int e) const { return edge(e).ref.panel; }
  bool is_held(int e) const { return partners_[e] >= 0 && decided_[e] != 0; }

  /// Panels, a left and a right one together; `by_seams`: with all that decided seams join to them.
  std::vector<std::set<int>> grouped(bool by_seams) const {
    DisjointSets sets(panels_);
    for (int e = 0; e < edges(); ++e) {
      if (by_seams && is_held(e)) sets.join(panel_of(e), panel_of(partners_[e]));
      if (evidence_.mirror[e] >= 0) sets.join(panel_of(e), panel_of(evidence_.mirror[e]));
    }
    std::map<int, std::set<int>> groups;
    for (int panel = 0; panel < static_cast<int>(panels_); ++panel) {
      groups[sets.of(panel)].insert(panel);
    }
    std::vector<std::set<int>> all;
    for (auto& [first, group] : groups) all.push_back(std::move(group));
    return all;
  }

  /// Whether its open edges would rather be sewn where the rest has a seam than where it is open.
  /// Those that fit neither, and those that fit each other, do not count.
  bool has_no_place(const std::set<int>& part) const {
    double taken = 0;
    double free = 0;
    for (int a = 0; a < edges(); ++a) {
      if (is_held(a) || !part.contains(panel_of(a))) continue;
      double at_seam = possible_odds;
      double at_border = possible_odds;
      for (int b = 0; b < edges(); ++b) {
        if (part.contains(panel_of(b)) || !odds_.possible(a, b)) continue;
        double& most = is_held(b) ? at_seam : at_border;
        most = std::max(most, odds_.odds(a, b));
      }
      if (at_border > possible_odds && at_border > at_seam - clear_odds) {
        free += edge(a).length;
      } else if (at_seam > possible_odds) {
        taken += edge(a).length;
      }
    }
    return taken > free;
  }

  /// Whether what is sewn to `others` would be sewn to the part if they were not there.
  bool may_replace(const std::set<int>& part, const std::set<int>& others) const {
    const auto is_other = [&](int e) { return others.contains(panel_of(e)); };
    const bool are_alike = std::ranges::any_of(evidence_.fits, [&](const PanelFit& fit) {
      return part.contains(fit.from) && others.contains(fit.to);
    });
    if (are_alike) return false;
    KnownSeams known;
    Partners begin = partners_;
    double freed = 0;
    for (int e = 0; e < edges(); ++e) {
      if (is_other(e)) known.taken.push_back(e);
      if (partners_[e] < 0 || !(is_other(e) || is_other(partners_[e]))) continue;
      begin[e] = -1;
      if (is_held(e) && !is_other(e)) freed += edge(e).length;
    }
    double taken = 0;
    for (const ChosenSeam& seam : SeamChooser(evidence_, known, begin, is_over_).best().seams) {
      for (const auto& [e, now] : {std::pair(seam.a, seam.b), std::pair(seam.b, seam.a)}) {
        const bool is_freed = is_held(e) && !is_other(e) && is_other(partners_[e]);
        if (is_freed && part.contains(panel_of(now))) taken += edge(e).length;
      }
    }
    return taken > replaced_share * freed;
  }

  double length_of(const std::set<int>& panels) const {
    double length = 0;
    for (const WalkedEdge& edge : evidence_.edges) {
      if (panels.contains(edge.ref.panel)) length += edge.length;
    }
    return length;
  }

  const IsOver& is_over_;
  SeamEvidence evidence_;
  SeamPairs odds_;
  Partners partners_;
  std::vector<char> decided_;  // per edge: its seam is
  std::size_t panels_ = 0;
};

}  // namespace

std::set<int> spare_panels(const Pattern& pattern, const FindSeamsOptions& options,
                           const FoundSeams& found) {
  return SpareFinder(pattern, options, found).found();
}

}  // namespace toile
