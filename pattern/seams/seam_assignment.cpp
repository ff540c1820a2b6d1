#include "pattern/seams/seam_assignment.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "geometry/disjoint_sets.h"
#include "pattern/seams/integer_programme.h"

namespace toile {

namespace {

/// Nodes of each search at most. With 4, samples without names lose a seventh of the seams found.
constexpr int max_nodes = 40;

/// Iterations of the simplex method for one garment, at most.
constexpr int max_iterations = 100000;

/// Times that the programme is solved again because parts of the garment are sewn to nothing else,
/// or because the garment has a handle.
constexpr int max_rounds = 12;

class Assigner {
 public:
  Assigner(const SeamEvidence& evidence, const std::vector<SeamCandidate>& candidates,
           const std::vector<CornerGroup>& groups, const KnownSeams& known)
      : known_(known),
        edges_(evidence.edges),
        mirror_(evidence.mirror),
        shapes_(evidence.shapes),
        candidates_(candidates),
        groups_(groups) {}

  SeamAssignment assign() {
    mirror_candidates();
    add_seams();
    add_groups();
    for (const int c : known_.chosen) programme_.fix(variable_[c], true);
    SeamAssignment result;
    std::vector<int> chosen = known_.chosen;
    for (int round = 0;; ++round) {
      // The last answer falls into parts, or has a handle; it is better than none.
      std::optional<IntegerProgramme::Answer> answer;
      if (round < max_rounds) answer = programme_.solve(max_nodes);
      if (!answer) {
        result.proved = false;
        break;
      }
      result.worth = answer->worth;
      result.proved = answer->proved;
      chosen.clear();
      for (int c = 0; c < count(); ++c) {
        const int variable = variable_[lead_[c]];
        if (variable >= 0 && answer->values[variable]) chosen.push_back(c);
      }
      if (ask_to_join(chosen)) continue;
      if (handles(chosen) == 0) break;
      // A garment is a sheet with holes: it has no handle, as a twisted sleeve would make.
      std::set<int> variables;
      for (const int c : chosen) variables.insert(variable_[lead_[c]]);
      std::vector<LinearTerm> terms;
      terms.reserve(variables.size());
      for (const int variable : variables) terms.push_back({variable, 1});
      programme_.add_at_most(terms, static_cast<double>(variables.size()) - 1);
    }
    weigh(chosen, result);
    return result;
  }

 private:
  int count() const { return static_cast<int>(candidates_.size()); }

  std::vector<int> edges_of_both(const SeamCandidate& c) const {
    std::vector<int> all = edges_of(edges_, c.a);
    const std::vector<int> b = edges_of(edges_, c.b);
    all.insert(all.end(), b.begin(), b.end());
    return all;
  }

  std::array<int, 4> key(const SeamCandidate& c) const {
    return {c.a.first, c.a.count, c.b.first, c.b.count};
  }

  /// The candidate on the other half of the garment; `swapped`: its side a mirrors side b.
  void mirror_candidates() {
    std::map<std::array<int, 4>, int> by_key;
    for (int c = 0; c < count(); ++c) by_key[key(candidates_[c])] = c;
    lead_.resize(candidates_.size());
    image_.assign(candidates_.size(), -1);
    swapped_.assign(candidates_.size(), false);
    const std::set<int> fixed(known_.chosen.begin(), known_.chosen.end());
    for (int c = 0; c < count(); ++c) {
      lead_[c] = c;
      const SeamCandidate& own = candidates_[c];
      for (const int e : edges_of_both(own)) {
        const auto& taken = known_.taken;
        if (std::find(taken.begin(), taken.end(), e) != taken.end()) dropped_.insert(c);
      }
      // What was said of one half need not hold for the other.
      if (fixed.contains(c)) continue;
      const auto sides = {own.a, own.b};
      std::vector<SeamSide> image;
      for (const SeamSide& side : sides) {
        const int last = mirror_[edges_of(edges_, side).back()];
        if (last >= 0) image.push_back({last, side.count});
      }
      if (image.size() < 2) continue;
      auto found = by_key.find(key({image[0], image[1], 0}));
      if (found == by_key.end()) {
        found = by_key.find(key({image[1], image[0], 0}));
        swapped_[c] = true;
      }
      if (found == by_key.end()) {
        dropped_.insert(c);
        continue;
      }
      if (fixed.contains(found->second)) continue;
      image_[c] = found->second;
      lead_[c] = std::min(c, image_[c]);
      if (image_[c] == c) continue;
      const std::vector<int> mine = edges_of_both(own);
      for (const int e : edges_of_both(candidates_[image_[c]])) {
        if (std::find(mine.begin(), mine.end(), e) != mine.end()) dropped_.insert(c);
      }
    }
  }

  void add_seams() {
    variable_.assign(candidates_.size(), -1);
    uses_.resize(edges_.size());
    for (int c = 0; c < count(); ++c) {
      if (lead_[c] != c || dropped_.contains(c)) continue;
      double worth = candidates_[c].worth;
      if (image_[c] >= 0 && image_[c] != c) worth += candidates_[image_[c]].worth;
      // A little more for what comes first, so that equal garments have one best.
      variable_[c] = programme_.add_variable(worth - 1e-6 * c);
      std::set<int> used;
      for (const int e : edges_of_both(candidates_[c])) used.insert(e);
      if (image_[c] >= 0) {
        for (const int e : edges_of_both(candidates_[image_[c]])) used.insert(e);
      }
      for (const int e : used) uses_[e].push_back(variable_[c]);
    }
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      std::vector<LinearTerm> terms;
      for (const int variable : uses_[e]) terms.push_back({variable, 1});
      if (terms.size() > 1) programme_.add_at_most(terms, 1);
    }
  }

  /// The end of a seam by the leading candidate of its pair of mirror images.
  std::array<int, 2> lead_end(const SeamEnd& end) const {
    std::array<int, 2> own = {end.candidate, end.end};
    if (image_[end.candidate] < 0) return own;
    const std::array<int, 2> image = {image_[end.candidate],
                                      swapped_[end.candidate] ? end.end : 1 - end.end};
    return std::min(own, image);
  }

  std::array<int, 2> lead_end(const EdgeEnd& end) const {
    std::array<int, 2> own = {end.edge, end.end};
    if (mirror_[end.edge] < 0) return own;
    return std::min(own, {mirror_[end.edge], 1 - end.end});
  }

  int panel(const SeamSide& side) const { return edges_[side.first].ref.panel; }

  /// Takes something off where a part of the garment is sewn to nothing else. False: no part is, or
  /// that is counted already.
  bool ask_to_join(const std::vector<int>& chosen) {
    const int panels = edges_.back().ref.panel + 1;
    DisjointSets parts(static_cast<std::size_t>(panels));
    for (const int c : chosen) {
      parts.join(panel(candidates_[c].a), panel(candidates_[c].b));
    }
    bool added = false;
    for (int first = 0; first < panels; ++first) {
      if (parts.of(first) != first) continue;
      std::vector<int> part;
      for (int p = 0; p < panels; ++p) {
        if (parts.of(p) == first) part.push_back(p);
      }
      if (static_cast<int>(part.size()) == panels || !joined_.insert(part).second) continue;
      std::set<int> joins;
      for (int c = 0; c < count(); ++c) {
        const bool a = std::binary_search(part.begin(), part.end(), panel(candidates_[c].a));
        const bool b = std::binary_search(part.begin(), part.end(), panel(candidates_[c].b));
        if (a != b && variable_[lead_[c]] >= 0) joins.insert(variable_[lead_[c]]);
      }
      if (joins.empty()) continue;
      std::vector<LinearTerm> terms;
      terms.reserve(joins.size() + 1);
      for (const int variable : joins) terms.push_back({variable, -1});
      terms.push_back({programme_.add_variable(-part_left_over), -1});
      programme_.add_at_most(terms, -1);
      added = true;
    }
    return added;
  }

  /// Handles of the surface that these seams make, by its Euler characteristic.
  int handles(const std::vector<int>& chosen) const {
    const int edges = static_cast<int>(edges_.size());
    const int panels = edges_.back().ref.panel + 1;
    DisjointSets corners(edges_.size());
    DisjointSets parts(static_cast<std::size_t>(panels));
    std::vector<int> partner(edges_.size(), -1);
    for (const int c : chosen) {
      const int a = candidates_[c].a.first;
      const int b = candidates_[c].b.first;
      partner[a] = b;
      partner[b] = a;
      corners.join(a, edges_[b].next);
      corners.join(edges_[a].next, b);
      parts.join(edges_[a].ref.panel, edges_[b].ref.panel);
    }
    int points = 0;
    int borders = 0;
    int pieces = 0;
    std::vector<bool> walked(edges_.size(), false);
    for (int e = 0; e < edges; ++e) {
      if (corners.of(e) == e) ++points;
      if (partner[e] >= 0 || walked[e]) continue;
      ++borders;
      for (int at = e; !walked[at];) {
        walked[at] = true;
        at = edges_[at].next;
        while (partner[at] >= 0) at = edges_[partner[at]].next;
      }
    }
    for (int p = 0; p < panels; ++p) pieces += parts.of(p) == p ? 1 : 0;
    const int lines = edges - static_cast<int>(chosen.size());
    return (2 * pieces - borders - (points - lines + panels)) / 2;
  }

  /// What seams have in common that differ in which of equal pieces they join.
  std::array<int, 3> kind(const SeamCandidate& c) const {
    const std::array<int, 2> shapes = {shapes_.shape[c.a.first], shapes_.shape[c.b.first]};
    return {std::min(shapes[0], shapes[1]), std::max(shapes[0], shapes[1]),
            shapes_.hand[c.a.first] * shapes_.hand[c.b.first]};
  }

  void weigh(const std::vector<int>& chosen, SeamAssignment& result) {
    std::map<std::array<int, 3>, std::vector<int>> of_kind;
    // A seam that was given says nothing of others of its kind.
    std::set<int> given;
    for (const int c : known_.chosen) given.insert(variable_[lead_[c]]);
    for (int c = 0; c < count(); ++c) {
      const int variable = variable_[lead_[c]];
      if (variable >= 0 && !given.contains(variable)) {
        of_kind[kind(candidates_[c])].push_back(variable);
      }
    }
    std::map<std::array<int, 3>, IntegerProgramme::Relaxed> without;
    for (const int c : chosen) {
      const auto key = kind(candidates_[c]);
      if (!without.contains(key)) without[key] = programme_.relaxed_without(of_kind[key]);
      const IntegerProgramme::Relaxed& other = without[key];
      ChosenSeam seam{c, result.worth - other.worth, -1};
      double most = 0.3;
      for (int d = 0; d < count() && !other.values.empty(); ++d) {
        const int variable = variable_[lead_[d]];
        if (variable < 0 || other.values[variable] <= most) continue;
        for (const int e : edges_of_both(candidates_[d])) {
          if (e != candidates_[c].a.first && e != candidates_[c].b.first) continue;
          most = other.values[variable];
          seam.alternative = d;
        }
      }
      result.chosen.push_back(seam);
    }
  }

  void add_groups() {
    using Ends = std::set<std::array<int, 2>>;
    std::map<std::pair<Ends, Ends>, double>
        worths;  // of the seams that end there, and what is open
    for (const CornerGroup& group : groups_) {
      Ends seams;
      Ends open;
      bool possible = true;
      for (const SeamEnd& end : group.seams) {
        possible = possible && variable_[lead_[end.candidate]] >= 0;
        seams.insert(lead_end(end));
      }
      for (const EdgeEnd& end : group.open) open.insert(lead_end(end));
      if (possible) worths[{seams, open}] += group.worth;
    }
    std::map<std::array<int, 2>, std::vector<LinearTerm>> at_seam;
    std::map<std::array<int, 2>, std::vector<LinearTerm>> at_open;
    for (const auto& [key, worth] : worths) {
      const int variable = programme_.add_variable(worth, true);
      for (const auto& end : key.first) at_seam[end].push_back({variable, 1});
      for (const auto& end : key.second) at_open[end].push_back({variable, 1});
    }
    for (auto& [end, terms] : at_seam) {
      terms.push_back({variable_[lead_[end[0]]], -1});
      programme_.add_at_most(terms, 0);
    }
    for (auto& [end, terms] : at_open) {
      for (const int variable : uses_[end[0]]) terms.push_back({variable, 1});
      programme_.add_at_most(terms, 1);
    }
  }

  const KnownSeams& known_;
  const std::vector<WalkedEdge>& edges_;
  const std::vector<int>& mirror_;
  const EdgeShapes& shapes_;
  const std::vector<SeamCandidate>& candidates_;
  const std::vector<CornerGroup>& groups_;
  IntegerProgramme programme_{max_iterations};
  std::set<std::vector<int>> joined_;  ///< parts that ask_to_join() knows
  std::vector<int> lead_;
  std::vector<int> image_;
  std::vector<bool> swapped_;
  std::set<int> dropped_;
  std::vector<int> variable_;           // of leading candidates; -1: none
  std::vector<std::vector<int>> uses_;  // per edge: variables
};

}  // namespace

SeamAssignment assign_seams(const SeamEvidence& evidence,
                            const std::vector<SeamCandidate>& candidates,
                            const std::vector<CornerGroup>& groups, const KnownSeams& known) {
  return Assigner(evidence, candidates, groups, known).assign();
}

}  // namespace toile
