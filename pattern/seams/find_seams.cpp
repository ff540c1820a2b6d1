#include "pattern/seams/find_seams.h"

#include <cmath>
#include <map>
#include <set>

#include "geometry/error.h"
#include "pattern/seams/panel_exchange.h"
#include "pattern/seams/seam_assignment.h"

namespace toile {

namespace {

/// Worth at which a seam is as likely to be right as 63 in a hundred.
constexpr double margin_scale = 1;

/// Worth by which a garment has to be better that does not heed the names of left and right.
constexpr double turned_panels = 2;

class SeamSearch {
 public:
  SeamSearch(const Pattern& pattern, const FindSeamsOptions& options)
      : pattern_(pattern), options_(options) {
    evidence_.edges = walked_edges(pattern, options.drawn_walk);
    for (const PatternPanel& panel : pattern.panels) evidence_.words.push_back(words_of(panel));
    fits_ = panel_fits(evidence_.edges);
    evidence_.shapes = edge_shapes(evidence_.edges, fits_);
    evidence_.mirror = mirror_partners(evidence_.edges, fits_, evidence_.words);
    for (int e = 0; e < static_cast<int>(evidence_.edges.size()); ++e) {
      number_[{evidence_.edges[e].ref.panel, evidence_.edges[e].ref.edge}] = e;
    }
  }

  FoundSeams run(const SeamMeasures& weights) {
    turned_.clear();
    std::vector<SeamCandidate> candidates = seam_candidates(evidence_, weights);
    const KnownSeams known = take_given(candidates);
    const std::vector<CornerGroup> groups = corner_groups(evidence_, candidates, weights);
    const SeamAssignment assigned = assign_seams(evidence_, candidates, groups, known);

    std::vector<EdgeSeam> seams;
    for (const ChosenSeam& chosen : assigned.chosen) {
      const SeamCandidate& candidate = candidates[chosen.candidate];
      seams.push_back({candidate.a.first, candidate.b.first, false});
    }
    const std::vector<EdgeSeam> before = seams;
    if (options_.given.empty()) {
      exchange_panels(pattern_, evidence_.edges, fits_, evidence_.words, options_.by_place, seams);
    }
    FoundSeams found;
    found.proved = assigned.proved;
    found.worth = assigned.worth;
    for (std::size_t i = 0; i < seams.size(); ++i) {
      const ChosenSeam& chosen = assigned.chosen[i];
      FoundSeam seam = made(seams[i]);
      seam.given = std::find(known.chosen.begin(), known.chosen.end(), chosen.candidate) !=
                   known.chosen.end();
      seam.confidence = seam.given ? 1 : std::max(0.0, 1 - std::exp(-chosen.margin / margin_scale));
      // The alternative is of the panels that were chosen before equal ones changed places.
      const bool stayed = seams[i].a == before[i].a && seams[i].b == before[i].b;
      if (chosen.alternative >= 0 && stayed) {
        const SeamCandidate& other = candidates[chosen.alternative];
        seam.alternative = {evidence_.edges[other.a.first].ref, evidence_.edges[other.b.first].ref};
      }
      found.seams.push_back(seam);
    }
    for (const EdgeSeam& seam : turned_) {
      found.seams.push_back(made(seam));
      found.seams.back().given = true;
      found.seams.back().confidence = 1;
    }
    return found;
  }

  bool names_sides() const {
    return std::any_of(evidence_.words.begin(), evidence_.words.end(),
                       [](const PanelWords& words) { return words.side != 0; });
  }

 private:
  FoundSeam made(const EdgeSeam& seam) const {
    const WalkedEdge& a = evidence_.edges[seam.a];
    const WalkedEdge& b = evidence_.edges[seam.b];
    FoundSeam made;
    made.a = a.ref;
    made.b = b.ref;
    made.reversed = (a.forward == b.forward) != seam.along;
    made.length_a = a.length;
    made.length_b = b.length;
    return made;
  }

  KnownSeams take_given(std::vector<SeamCandidate>& candidates) {
    KnownSeams known;
    std::set<int> used;
    for (const Stitch& stitch : options_.given) {
      int a = number_.at({stitch.a.panel, stitch.a.edge});
      int b = number_.at({stitch.b.panel, stitch.b.edge});
      for (const auto& [e, ref] : {std::pair{a, stitch.a}, std::pair{b, stitch.b}}) {
        if (!used.insert(e).second) {
          throw Error(pattern_.source + ": " + edge_name(pattern_, ref), "is given in two seams",
                      "remove one of the two");
        }
      }
      const bool same = evidence_.edges[a].forward == evidence_.edges[b].forward;
      const bool along = stitch.direction != StitchDirection::by_position &&
                         (stitch.direction == StitchDirection::end_to_start) != same;
      if (along) {
        turned_.push_back({a, b, true});
        known.taken.push_back(a);
        known.taken.push_back(b);
        continue;
      }
      if (a > b) std::swap(a, b);
      const auto found = std::find_if(candidates.begin(), candidates.end(), [&](const auto& c) {
        return c.a.first == a && c.b.first == b;
      });
      known.chosen.push_back(static_cast<int>(found - candidates.begin()));
      if (found == candidates.end()) candidates.push_back({{a, 1}, {b, 1}, 0});
    }
    return known;
  }

  const Pattern& pattern_;
  const FindSeamsOptions& options_;
  SeamEvidence evidence_;
  std::vector<PanelFit> fits_;
  std::map<std::array<int, 2>, int> number_;
  std::vector<EdgeSeam> turned_;  ///< given seams that turn a panel over
};

}  // namespace

FoundSeams find_seams(const Pattern& pattern, const FindSeamsOptions& options) {
  SeamSearch search(pattern, options);
  FoundSeams found = search.run(seam_weights);
  if (!search.names_sides()) return found;
  // Where drawings show the wrong side, left and right change places: then a garment that does not
  // heed them is worth much more.
  SeamMeasures sideless = seam_weights;
  sideless[static_cast<int>(SeamMeasure::sides_differ)] = 0;
  FoundSeams other = search.run(sideless);
  return other.worth > found.worth + turned_panels ? other : found;
}

}  // namespace toile
