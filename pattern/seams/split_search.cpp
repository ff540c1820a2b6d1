#include "pattern/seams/split_search.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "pattern/check/left_out.h"
#include "pattern/file/pattern_file.h"
#include "pattern/seams/seam_pairs.h"

namespace toile {

namespace {

/// Edges that one edge is sewn to at most. More of them where lengths agree well, as those of a
/// waistband and of all that hangs on it do.
constexpr std::size_t longest_chain = 4;
constexpr std::size_t longest_exact_chain = 10;

/// Logarithm of lengths that agree well.
constexpr double exact = 0.005;

/// Logarithm of the length of an edge over that of the edges it may be sewn to: easing apart.
constexpr double most_excess = 0.1;
constexpr double most_lack = 0.1;

/// Logarithm of the lengths of a seam's sides: an edge of such a seam is free to be cut.
constexpr double poor_seam = 0.02;

/// Score by which a garment with cut edges has to be better, for each cut. With half, edges of
/// random garments are cut that are sewn to one; with double, the sleeves of Valentina's T-shirt
/// stay whole.
constexpr double cut_gain = 4;

/// The same of a cut at a notch of the other side. With four times as much, the side seams of
/// FreeSewing's Simon are not found: only its fronts have a notch at the waist.
constexpr double notched_cut_gain = 1;

/// Garments with cut edges that are looked at after each search: fewer of large garments, where
/// each takes longer. Of one with 35 edges, 12.
std::size_t trials_of(const Pattern& pattern) {
  std::size_t edges = 0;
  for (const PatternPanel& panel : pattern.panels) edges += panel.edges.size();
  constexpr std::size_t most_edges = 420;
  return std::clamp<std::size_t>(most_edges / std::max<std::size_t>(1, edges), 3, 12);
}

/// Confidence that seams of the parts of a cut edge have to have. With 0.8, the sleeves of
/// Valentina's T-shirt stay whole.
constexpr double sure_part = 0.6;

/// Cuts that are made in a row.
constexpr int most_split_rounds = 6;

/// An edge, and where its walk is cut.
struct Cut {
  int edge = 0;
  std::vector<double> shares;  // of its length, ascending
};

/// Logarithm of lengths that each edge beyond the second of a chain counts as: long chains are as
/// long as an edge by chance. With 0.05, the sleeves of Valentina's T-shirt are not cut any more.
constexpr double cost_of_edge = 0.08;
constexpr double cost_of_exact_edge = 0.02;

/// An edge and the border that it is about as long as.
struct Chain {
  std::vector<Cut> cuts;  // of the edge, and of its mirror image, in the order of edges
  double off = 0;         // logarithm of the lengths, and what the number of edges counts as
  bool notched = false;   // cut at notches of the other side
};

bool same(const Chain& a, const Chain& b) {
  constexpr double same_share = 1e-4;
  return std::equal(
      a.cuts.begin(), a.cuts.end(), b.cuts.begin(), b.cuts.end(), [](const Cut& x, const Cut& y) {
        return x.edge == y.edge &&
               std::equal(x.shares.begin(), x.shares.end(), y.shares.begin(), y.shares.end(),
                          [](double s, double t) { return std::abs(s - t) < same_share; });
      });
}

class Chains {
 public:
  Chains(const Pattern& pattern, const FindSeamsOptions& options, const FoundSeams& found)
      : evidence_(seam_evidence(pattern, options.drawn_walk)),
        partner_(evidence_.edges.size(), -1),
        free_(evidence_.edges.size(), 1),
        locked_(evidence_.edges.size(), 0) {
    std::map<std::array<int, 2>, int> number;
    for (int e = 0; e < size(); ++e) {
      number[{evidence_.edges[e].ref.panel, evidence_.edges[e].ref.edge}] = e;
    }
    for (const FoundSeam& seam : found.seams) {
      const int a = number.at({seam.a.panel, seam.a.edge});
      const int b = number.at({seam.b.panel, seam.b.edge});
      const bool poor = std::abs(std::log(seam.length_a / seam.length_b)) > poor_seam;
      if (poor && !seam.given) continue;
      partner_[a] = b;
      partner_[b] = a;
      if (seam.given) locked_[a] = locked_[b] = 1;
      free_[a] = free_[b] = 0;
    }
  }

  std::vector<Chain> all() const {
    std::vector<Chain> chains;
    for (int edge = 0; edge < size(); ++edge) {
      if (free_[edge] == 0) continue;
      add_notched(edge, chains);
      for (int first = 0; first < size(); ++first) {
        if (free_[first] == 0 || first == edge) continue;
        add(edge, first, chains);
      }
    }
    std::stable_sort(chains.begin(), chains.end(),
                     [](const Chain& a, const Chain& b) { return a.off < b.off; });
    // Mirror images give the same cuts.
    std::vector<Chain> others;
    for (Chain& chain : chains) {
      const bool known = std::any_of(others.begin(), others.end(),
                                     [&](const Chain& other) { return same(chain, other); });
      if (!known) others.push_back(std::move(chain));
    }
    return others;
  }

  const WalkedEdge& edge(int e) const { return evidence_.edges[e]; }

 private:
  int size() const { return static_cast<int>(evidence_.edges.size()); }

  /// The next open edge of the border.
  int after(int edge) const {
    int next = evidence_.edges[edge].next;
    for (int steps = 0; partner_[next] >= 0 && steps < size(); ++steps) {
      next = evidence_.edges[partner_[next]].next;
    }
    return next;
  }

  void add(int edge, int first, std::vector<Chain>& chains) const {
    const double length = evidence_.edges[edge].length;
    std::vector<int> border = {first};
    double sum = evidence_.edges[first].length;
    while (border.size() < longest_exact_chain && sum < length * (1 + most_lack)) {
      const int next = after(border.back());
      if (next == edge || next == first || free_[next] == 0) return;
      border.push_back(next);
      sum += evidence_.edges[next].length;
      const double excess = std::log(length / sum);
      if (excess > most_excess || excess < -most_lack) continue;
      const bool is_exact = std::abs(excess) < exact;
      if (border.size() > longest_chain && !is_exact) continue;
      Chain chain;
      chain.off = std::abs(excess) + (is_exact ? cost_of_exact_edge : cost_of_edge) *
                                         static_cast<double>(border.size() - 2);
      add_cuts(edge, border, sum, chain);
      chains.push_back(std::move(chain));
    }
  }

  /// Notches that the other side of a seam lacks: the edge is as long as several that they part.
  void add_notched(int edge, std::vector<Chain>& chains) const {
    // Metres: shorter ones agree by chance. Without it, Simon's button placket is cut first.
    constexpr double shortest = 0.05;
    const double length = evidence_.edges[edge].length;
    if (length < shortest) return;
    for (int first = 0; first < size(); ++first) {
      if (first == edge || locked_[first] != 0 || are_halves(edge, first)) continue;
      std::vector<int> run = {first};
      double sum = evidence_.edges[first].length;
      while (run.size() < longest_exact_chain && sum < length * (1 + exact)) {
        const int next = evidence_.edges[run.back()].next;
        if (next == first || next == edge || locked_[next] != 0 || !is_smooth_notch(next)) break;
        run.push_back(next);
        sum += evidence_.edges[next].length;
        if (std::abs(std::log(length / sum)) > exact) continue;
        Chain chain;
        chain.off = std::abs(std::log(length / sum));
        chain.notched = true;
        add_cuts(edge, run, sum, chain);
        chains.push_back(std::move(chain));
      }
    }
  }

  /// Whether they are of the left and the right half of one piece, whose notches differ by chance.
  bool are_halves(int a, int b) const {
    const PanelWords& first = evidence_.words[evidence_.edges[a].ref.panel];
    const PanelWords& second = evidence_.words[evidence_.edges[b].ref.panel];
    return first.side * second.side < 0 && first.whole == second.whole;
  }

  bool is_smooth_notch(int edge) const {
    constexpr double most_turn = 20 * std::numbers::pi / 180;
    const WalkedEdge& at = evidence_.edges[edge];
    return at.notch && std::abs(at.corner - std::numbers::pi) < most_turn;
  }

  void add_cuts(int edge, const std::vector<int>& border, double sum, Chain& chain) const {
    chain.cuts.push_back({edge, {}});
    // The walk of the edge meets that of the border the other way round.
    double at = 0;
    for (std::size_t i = border.size(); i-- > 1;) {
      at += evidence_.edges[border[i]].length / sum;
      chain.cuts[0].shares.push_back(at);
    }
    add_mirror(chain);
  }

  void add_mirror(Chain& chain) const {
    const Cut& cut = chain.cuts.front();
    const int twin = evidence_.mirror[cut.edge];
    if (twin < 0 || twin == cut.edge || free_[twin] == 0) return;
    const int cut_edge = cut.edge;
    Cut mirrored{twin, {}};
    for (auto share = cut.shares.rbegin(); share != cut.shares.rend(); ++share) {
      mirrored.shares.push_back(1 - *share);
    }
    chain.cuts.push_back(std::move(mirrored));
    if (twin < cut_edge) std::swap(chain.cuts[0], chain.cuts[1]);
  }

  SeamEvidence evidence_;
  std::vector<int> partner_;
  std::vector<char> free_;
  std::vector<char> locked_;  ///< of given seams
};

/// Makes the cuts of a chain, one after the other.
void make_cuts(const Chains& chains, const Chain& chain, const std::string& name,
               SplitSeams& result) {
  for (const Cut& cut : chain.cuts) {
    const WalkedEdge& walked = chains.edge(cut.edge);
    std::vector<double> shares = cut.shares;
    if (!walked.forward) {
      std::reverse(shares.begin(), shares.end());
      for (double& share : shares) share = 1 - share;
    }
    EdgeSplit split;
    split.edge = walked.ref;
    double done = 0;
    for (const double share : shares) {
      split.share = (share - done) / (1 - done);
      split.rest = static_cast<int>(result.pattern.panels[split.edge.panel].edges.size());
      result.text = with_split_edge(result.text, result.pattern, split);
      std::vector<Remark> again;
      Pattern cut_pattern = without_left_out(parse_drawn_pattern(result.text, name, again), again);
      for (std::size_t p = 0; p < cut_pattern.panels.size(); ++p) {
        cut_pattern.panels[p].notches = std::move(result.pattern.panels[p].notches);
      }
      result.pattern = std::move(cut_pattern);
      if (chain.notched) {
        PatternPanel& panel = result.pattern.panels[split.edge.panel];
        panel.notches.push_back({0, panel.edges[split.rest].curve.start(), {}});
      }
      result.splits.push_back(split);
      split.edge.edge = split.rest;
      done = share;
    }
  }
}

/// Whether all parts of cut edges are sewn, and likely so.
bool are_likely(const SplitSeams& split) {
  std::set<std::array<int, 2>> sure;
  for (const FoundSeam& seam : split.found.seams) {
    if (seam.confidence < sure_part) continue;
    for (const EdgeRef& side : {seam.a, seam.b}) sure.insert({side.panel, side.edge});
  }
  return std::all_of(split.splits.begin(), split.splits.end(), [&](const EdgeSplit& cut) {
    return sure.contains({cut.edge.panel, cut.edge.edge}) &&
           sure.contains({cut.edge.panel, cut.rest});
  });
}

}  // namespace

SplitSeams find_split_seams(const std::string& text, const std::string& name,
                            const Pattern& pattern, const FindSeamsOptions& options) {
  SplitSeams whole{text, pattern, {}, find_seams(pattern, options)};
  SplitSeams best = whole;
  FindSeamsOptions quick = options;
  quick.certain = false;
  std::vector<SplitSeams> rounds_made;
  for (int round = 0; round < most_split_rounds; ++round) {
    const Chains chains(best.pattern, options, best.found);
    const std::vector<Chain> all = chains.all();
    std::optional<SplitSeams> better;
    double most = 0;
    const std::size_t trials = trials_of(best.pattern);
    for (std::size_t i = 0; i < all.size() && i < trials; ++i) {
      SplitSeams trial{best.text, best.pattern, best.splits, {}};
      make_cuts(chains, all[i], name, trial);
      const double cuts = static_cast<double>(trial.splits.size() - best.splits.size()) *
                          (all[i].notched ? notched_cut_gain : cut_gain);
      quick.before = &best.found;
      trial.found = find_seams(trial.pattern, quick);
      const double gain = trial.found.score - best.found.score - cuts;
      if (gain <= most) continue;
      most = gain;
      better = std::move(trial);
    }
    if (!better) break;
    best = std::move(*better);
    rounds_made.push_back(best);
  }
  // The last cuts are taken back until all are likely.
  for (auto made = rounds_made.rbegin(); made != rounds_made.rend(); ++made) {
    made->found = find_seams(made->pattern, options);
    if (are_likely(*made)) return std::move(*made);
  }
  return whole;
}

}  // namespace toile
