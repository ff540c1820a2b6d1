#include "pattern/seams/spare_panels.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/disjoint_sets.h"
#include "pattern/seams/seam_choice.h"

namespace toile {

namespace {

/// Logarithm of the odds from which on two edges are likely partners.
constexpr double likely_odds = 0;

/// The same, from which on an edge of a loose part may belong there.
constexpr double possible_odds = -1.5;

/// By how much the odds of one place are clearly better than those of another. Mirrored places have
/// the same but for rounding and names.
constexpr double clear_odds = 1;

/// Share of the length of a panel's seams that another one takes in its place. Edges that were cut
/// to fit the panel do not fit the other. Of the seams of a T-shirt's short sleeves, long ones take
/// 0.48.
constexpr double replaced_share = 1.0 / 3;

/// Metres of seams that may be lost: short edges find no partner in a short search. With a
/// twentieth of all seams instead, 2 of 90 random garments lose panels that they need.
constexpr double small_loss = 0.02;

/// The edges of a pattern, and which may be partners.
struct Likely {
  Likely(const Pattern& pattern, const FindSeamsOptions& options, const FoundSeams& found)
      : evidence(
            heeding(found.sides, seam_evidence(pattern, options.drawn_walk, found.turned_over))),
        pairs(evidence),
        partners(evidence.edges.size()) {
    const int edges = static_cast<int>(evidence.edges.size());
    for (int a = 0; a < edges; ++a) {
      for (int b = a + 1; b < edges; ++b) {
        if (!pairs.possible(a, b) || pairs.odds(a, b) < likely_odds) continue;
        partners[a].push_back(b);
        partners[b].push_back(a);
      }
    }
  }
  Likely(const Likely&) = delete;
  Likely& operator=(const Likely&) = delete;

  SeamEvidence evidence;
  SeamPairs pairs;
  std::vector<std::vector<int>> partners;  ///< per edge: its likely ones
};

/// A garment without some of its panels.
class Reduced {
 public:
  Reduced(const Pattern& pattern, const FindSeamsOptions& options, const FoundSeams& found)
      : is_over_(options.is_over),
        likely_(std::make_shared<const Likely>(pattern, options, found)),
        partners_(likely_->partners.size(), -1),
        decided_(likely_->partners.size(), 0),
        panels_(static_cast<int>(pattern.panels.size())) {
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

  const std::set<int>& without() const { return without_; }

  /// Metres of open edges that have a likely partner.
  double wanting() const {
    double sum = 0;
    for (int a = 0; a < edges(); ++a) {
      if (partners_[a] >= 0) continue;
      const bool is_out = without_.contains(panel_of(a));
      const bool wants = std::ranges::any_of(likely_->partners[a], [&](int b) {
        return !without_.contains(panel_of(b)) && (!is_out || partners_[b] < 0);
      });
      if (wants) sum += edge(a).length;
    }
    return sum;
  }

  /// Leaves out what makes it better by short searches from the seams that it has, unless a part of
  /// that has a place.
  void reduce() {
    const Reduced whole = *this;
    take_away();
    const std::vector<std::set<int>> parts = left_out_parts();
    std::set<int> rest;
    for (int panel = 0; panel < panels_; ++panel) {
      if (!without_.contains(panel)) rest.insert(panel);
    }
    // The sleeve of one side is no sleeve in place of the other.
    const auto has_place = [&](const std::set<int>& part) {
      return are_alike(part, rest) || !has_no_place(part);
    };
    if (loses_seams_of(whole) || std::ranges::any_of(parts, has_place) || !is_larger_half()) {
      *this = whole;
    }
  }

  void take_away() {
    for (double open = wanting(); open > 0;) {
      std::optional<Reduced> best;
      double least = open;
      for (const std::set<int>& pair : pairs()) {
        if (!is_attached(pair)) continue;
        Reduced other = *this;
        other.leave_out(pair);
        const double now = other.wanting();
        if (now >= least) continue;
        least = now;
        best = std::move(other);
      }
      if (!best) return;
      *this = std::move(*best);
      open = least;
    }
  }

  /// Leaves out the loose parts that have no place but could have the seams of other panels.
  void leave_out_loose() {
    for (const std::set<int>& part : loose_parts()) {
      if (!has_no_place(part)) continue;
      const std::vector<std::set<int>> others = pairs();
      const auto is_rival = [&](const std::set<int>& pair) { return may_replace(part, pair); };
      if (std::ranges::none_of(others, is_rival)) continue;
      const std::set<int> before = without_;
      without_.insert(part.begin(), part.end());
      if (!is_larger_half()) without_ = before;
    }
  }

 private:
  int edges() const { return static_cast<int>(partners_.size()); }
  const WalkedEdge& edge(int e) const { return likely_->evidence.edges[e]; }
  int panel_of(int e) const { return edge(e).ref.panel; }
  bool is_held(int edge) const { return partners_[edge] >= 0 && decided_[edge] != 0; }

  /// Whether a seam joins one of these panels to another one.
  bool is_attached(const std::set<int>& panels) const {
    for (int e = 0; e < edges(); ++e) {
      if (partners_[e] < 0 || !panels.contains(panel_of(e))) continue;
      if (!panels.contains(panel_of(partners_[e]))) return true;
    }
    return false;
  }

  /// The panels that are there, a left and a right one together.
  std::vector<std::set<int>> pairs() const {
    DisjointSets sets(static_cast<std::size_t>(panels_));
    for (int e = 0; e < edges(); ++e) {
      if (likely_->evidence.mirror[e] >= 0)
        sets.join(panel_of(e), panel_of(likely_->evidence.mirror[e]));
    }
    return grouped(sets);
  }

  std::vector<std::set<int>> grouped(DisjointSets& sets) const {
    std::map<int, std::set<int>> groups;
    for (int panel = 0; panel < panels_; ++panel) {
      if (!without_.contains(panel)) groups[sets.of(panel)].insert(panel);
    }
    std::vector<std::set<int>> all;
    for (auto& [first, group] : groups) all.push_back(std::move(group));
    return all;
  }

  void leave_out(const std::set<int>& panels) {
    without_.insert(panels.begin(), panels.end());
    KnownSeams known;
    for (int e = 0; e < edges(); ++e) {
      if (!without_.contains(panel_of(e))) continue;
      known.taken.push_back(e);
      if (partners_[e] >= 0) partners_[partners_[e]] = -1;
      partners_[e] = -1;
    }
    const SeamChooser chooser(likely_->evidence, known, partners_, is_over_);
    const Partners before = std::exchange(partners_, Partners(partners_.size(), -1));
    for (const ChosenSeam& seam : chooser.best().seams) {
      partners_[seam.a] = seam.b;
      partners_[seam.b] = seam.a;
      // Short searches tell no certainty.
      if (before[seam.a] != seam.b) decided_[seam.a] = decided_[seam.b] = 1;
    }
  }

  /// Whether edges of what is there are open here, and sewn for certain in `before`.
  bool loses_seams_of(const Reduced& before) const {
    double lost = 0;
    for (int e = 0; e < edges(); ++e) {
      if (!before.is_held(e) || without_.contains(panel_of(e))) continue;
      if (partners_[e] < 0) lost += edge(e).length;
    }
    return lost > small_loss;
  }

  /// What is left out, by likely seams.
  std::vector<std::set<int>> left_out_parts() const {
    DisjointSets sets(static_cast<std::size_t>(panels_));
    for (int a = 0; a < edges(); ++a) {
      for (const int b : likely_->partners[a]) {
        if (without_.contains(panel_of(a)) && without_.contains(panel_of(b))) {
          sets.join(panel_of(a), panel_of(b));
        }
      }
    }
    std::map<int, std::set<int>> parts;
    for (const int panel : without_) parts[sets.of(panel)].insert(panel);
    std::vector<std::set<int>> all;
    for (auto& [first, part] : parts) all.push_back(std::move(part));
    return all;
  }

  /// All parts but the largest that decided seams hold together, a left and a right one as one.
  std::vector<std::set<int>> loose_parts() const {
    DisjointSets sets(static_cast<std::size_t>(panels_));
    for (int e = 0; e < edges(); ++e) {
      if (is_held(e)) sets.join(panel_of(e), panel_of(partners_[e]));
      if (likely_->evidence.mirror[e] >= 0)
        sets.join(panel_of(e), panel_of(likely_->evidence.mirror[e]));
    }
    std::vector<std::set<int>> parts = grouped(sets);
    std::ranges::stable_sort(parts, std::ranges::greater{},
                             [&](const std::set<int>& part) { return length_of(part); });
    if (!parts.empty()) parts.erase(parts.begin());
    return parts;
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
        const int panel = panel_of(b);
        if (part.contains(panel) || without_.contains(panel)) continue;
        if (!likely_->pairs.possible(a, b)) continue;
        double& most = is_held(b) ? at_seam : at_border;
        most = std::max(most, likely_->pairs.odds(a, b));
      }
      if (at_border > possible_odds && at_border > at_seam - clear_odds) {
        free += edge(a).length;
      } else if (at_seam > possible_odds) {
        taken += edge(a).length;
      }
    }
    return taken > free;
  }

  /// Whether a panel of the one has the shape of one of the others, or is its mirror image.
  bool are_alike(const std::set<int>& part, const std::set<int>& others) const {
    return std::ranges::any_of(likely_->evidence.fits, [&](const PanelFit& fit) {
      return part.contains(fit.from) && others.contains(fit.to);
    });
  }

  double length_of(const std::set<int>& panels) const {
    double length = 0;
    for (const WalkedEdge& edge : likely_->evidence.edges) {
      if (panels.contains(edge.ref.panel)) length += edge.length;
    }
    return length;
  }

  /// Whether more is there than is left out, by the lengths of outlines.
  bool is_larger_half() const {
    double all = 0;
    for (const WalkedEdge& edge : likely_->evidence.edges) all += edge.length;
    return length_of(without_) < all / 2;
  }

  /// Whether what is sewn to `others` would be sewn to the part if they were not there.
  bool may_replace(const std::set<int>& part, const std::set<int>& others) const {
    if (are_alike(part, others)) return false;
    const auto is_other = [&](int e) { return others.contains(panel_of(e)); };
    Reduced exchanged = *this;
    exchanged.leave_out(others);
    double freed = 0;
    double taken = 0;
    for (int e = 0; e < edges(); ++e) {
      if (!is_held(e) || is_other(e) || !is_other(partners_[e])) continue;
      freed += edge(e).length;
      const int now = exchanged.partners_[e];
      if (now >= 0 && part.contains(panel_of(now))) taken += edge(e).length;
    }
    return taken > replaced_share * freed;
  }

  IsOver is_over_;
  std::shared_ptr<const Likely> likely_;
  Partners partners_;
  std::vector<char> decided_;  // per edge: its seam is
  int panels_ = 0;
  std::set<int> without_;
};

}  // namespace

std::set<int> spare_panels(const Pattern& pattern, const FindSeamsOptions& options,
                           const FoundSeams& found) {
  Reduced garment(pattern, options, found);
  garment.reduce();
  garment.leave_out_loose();
  // Where seams are wanted still, the garment is not understood.
  return garment.wanting() > 0 ? std::set<int>() : garment.without();
}

}  // namespace toile
