#include "pattern/seams/find_seams.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "geometry/error.h"
#include "pattern/seams/number_panels.h"
#include "pattern/seams/panel_exchange.h"
#include "pattern/seams/seam_choice.h"

namespace toile {

namespace {

/// Scores by which a garment has to be better whose names of left and right are exchanged, or are
/// not heeded. A drawing may show the wrong side of all panels, or of some. With 6 for the latter,
/// the mirrored sample bodice_dress loses a third of its seams. Other values were not measured.
constexpr double exchanged_sides = 2;
constexpr double ignored_sides = 4;

/// Score by which a garment has to be better whose collar shows its wrong side.
constexpr double turned_collar = 2;

class SeamFinder {
 public:
  SeamFinder(const Pattern& pattern, const FindSeamsOptions& options)
      : pattern_(pattern), options_(options) {
    look_at({});
  }

  /// Without the seams that lower the score. Pairs are scored as they come up: SeamSearch would
  /// score all of them first, for each of many garments.
  FoundSeams opened(const FoundSeams& found) {
    Partners partners = partners_of(found);
    std::vector<char> is_given(partners.size(), 0);
    for (const auto& [a, b] : take_given().chosen) is_given[a] = is_given[b] = 1;
    const SeamPairs pairs(evidence_);
    std::map<std::array<int, 2>, double> scores;
    SewnSurface surface(evidence_);
    const auto score_of_partners = [&] {
      SeamMeasures sum{};
      surface.measure(partners, sum);
      double score = score_of(sum, seam_weights);
      for (int a = 0; a < static_cast<int>(partners.size()); ++a) {
        if (partners[a] <= a) continue;
        const auto [at, is_new] = scores.try_emplace({a, partners[a]});
        if (is_new) at->second = score_of(pairs.measures(a, partners[a]), seam_weights);
        score += at->second;
      }
      return score;
    };
    double best = score_of_partners();
    for (bool again = true; again;) {
      again = false;
      for (int a = 0; a < static_cast<int>(partners.size()); ++a) {
        const int b = partners[a];
        if (b < a || is_given[a] != 0) continue;
        const Partners before = partners;
        partners[a] = partners[b] = -1;
        const int c = evidence_.mirror[a];
        const int d = evidence_.mirror[b];
        if (c >= 0 && d >= 0 && partners[c] == d && is_given[c] == 0) {
          partners[c] = partners[d] = -1;
        }
        const double score = score_of_partners();
        if (score > best) {
          best = score;
          again = true;
        } else {
          partners = before;
        }
      }
    }
    FoundSeams without = found;
    without.score = best;
    std::erase_if(without.seams, [&](const FoundSeam& seam) {
      if (seam.given) return false;
      return partners[number_.at({seam.a.panel, seam.a.edge})] < 0;
    });
    return without;
  }

  FoundSeams run() {
    if (options_.before != nullptr) return near(*options_.before);
    // A collar that is turned down shows the side that was inside.
    std::vector<char> best;
    double most = 0;
    const std::vector<std::vector<char>> collars = turned_collars();
    for (std::size_t i = 0; i <= collars.size() && !collars.empty(); ++i) {
      const std::vector<char> turned = i == 0 ? std::vector<char>{} : collars[i - 1];
      look_at(turned);
      const KnownSeams known = take_given();
      const double score =
          SeamChooser(evidence_, known, options_.is_over).score() - (i == 0 ? 0 : turned_collar);
      if (i > 0 && score <= most) continue;
      most = score;
      best = turned;
    }
    if (!collars.empty()) look_at(best);
    const KnownSeams known = take_given();
    SeamChooser chooser(evidence_, known, options_.is_over);
    if (names_sides()) {
      const SeamEvidence exchanged = heeding(SideNames::exchanged, evidence_);
      const SeamEvidence ignored = heeding(SideNames::ignored, evidence_);
      SeamChooser as_exchanged(exchanged, known, options_.is_over);
      SeamChooser as_ignored(ignored, known, options_.is_over);
      const double by_exchange = as_exchanged.score() - exchanged_sides;
      const double by_ignoring = as_ignored.score() - ignored_sides;
      const double by_other = std::max(by_exchange, by_ignoring);
      // A search that failed is no reason to turn panels.
      if (options_.certain && by_other > chooser.score()) chooser.settle();
      if (by_other > chooser.score()) {
        sides_ = by_exchange == by_other ? SideNames::exchanged : SideNames::ignored;
        return found(chosen(by_exchange == by_other ? as_exchanged : as_ignored), known);
      }
    }
    return found(chosen(chooser), known);
  }

 private:
  /// What is found from these seams on.
  FoundSeams near(const FoundSeams& before) {
    const Partners partners = partners_of(before);
    const KnownSeams known = take_given();
    return found(SeamChooser(evidence_, known, partners, options_.is_over).best(), known);
  }

  /// Looks at the pattern as these seams were found.
  Partners partners_of(const FoundSeams& seams) {
    look_at(seams.turned_over);
    sides_ = seams.sides;
    evidence_ = heeding(sides_, std::move(evidence_));
    Partners partners(evidence_.edges.size(), -1);
    const auto join = [&partners](int a, int b) {
      partners[a] = b;
      partners[b] = a;
    };
    for (const FoundSeam& seam : seams.seams) {
      // Of those that were given, some turn a panel over or lie upon another.
      if (seam.given) continue;
      join(number_.at({seam.a.panel, seam.a.edge}), number_.at({seam.b.panel, seam.b.edge}));
    }
    for (const auto& [a, b] : take_given().chosen) join(a, b);
    return partners;
  }

  /// `turned_over`: see walked_edges().
  void look_at(const std::vector<char>& turned_over) {
    evidence_ = seam_evidence(pattern_, options_.drawn_walk, turned_over);
    for (int e = 0; e < static_cast<int>(evidence_.edges.size()); ++e) {
      number_[{evidence_.edges[e].ref.panel, evidence_.edges[e].ref.edge}] = e;
    }
  }

  /// The pieces of a collar by their names: all, those of the front, those of the back.
  std::vector<std::vector<char>> turned_collars() const {
    std::set<std::vector<char>> all;
    for (const int face : {0, 1, -1}) {
      std::vector<char> turned;
      for (const PanelWords& words : evidence_.words) {
        const bool chosen = words.role == PanelRole::collar && (face == 0 || words.face == face);
        turned.push_back(chosen ? 1 : 0);
      }
      if (std::find(turned.begin(), turned.end(), 1) != turned.end()) all.insert(turned);
    }
    return {all.begin(), all.end()};
  }

  SeamChoice chosen(SeamChooser& chooser) const {
    return options_.certain ? chooser.choose() : chooser.best();
  }

  FoundSeams found(const SeamChoice& choice, const KnownSeams& known) const {
    std::vector<EdgeSeam> seams;
    for (const ChosenSeam& chosen : choice.seams) seams.push_back({chosen.a, chosen.b, false});
    const std::vector<EdgeSeam> before = seams;
    if (options_.given.empty()) {
      std::vector<PanelWords> words = evidence_.words;
      // A piece that is called left where the garment has its right would be turned inside out.
      for (std::size_t p = 0; p < words.size(); ++p) {
        if (pattern_.panels[p].side_unknown) words[p].side = 0;
      }
      exchange_panels(pattern_, evidence_.edges, evidence_.fits, words, evidence_.mirror,
                      options_.by_place, seams);
      if (!options_.by_place) {
        number_panels(pattern_, evidence_.edges, evidence_.fits, words, seams);
      }
    }
    FoundSeams found;
    found.settled = choice.settled;
    found.score = choice.score;
    found.turned_over = evidence_.turned_over;
    found.sides = sides_;
    for (std::size_t i = 0; i < seams.size(); ++i) {
      const ChosenSeam& chosen = choice.seams[i];
      FoundSeam seam = made(seams[i]);
      seam.given = std::find(known.chosen.begin(), known.chosen.end(),
                             std::array{chosen.a, chosen.b}) != known.chosen.end();
      seam.features = chosen.features;
      seam.confidence = seam.given ? 1 : certainty_of(chosen.features);
      // The alternative is of the panels that were chosen before equal ones changed places.
      const bool stayed = seams[i].a == before[i].a && seams[i].b == before[i].b;
      if (chosen.alternative[0] >= 0 && stayed) {
        seam.alternative = {evidence_.edges[chosen.alternative[0]].ref,
                            evidence_.edges[chosen.alternative[1]].ref};
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
    return std::any_of(evidence_.side.begin(), evidence_.side.end(),
                       [](int side) { return side != 0; });
  }

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

  KnownSeams take_given() {
    KnownSeams known;
    turned_.clear();
    std::set<int> used;
    for (const Stitch& stitch : options_.given) {
      int a = number_.at({stitch.a.panel, stitch.a.edge});
      int b = number_.at({stitch.b.panel, stitch.b.edge});
      if (stitch.layered) {
        const bool alike = evidence_.edges[a].forward == evidence_.edges[b].forward;
        turned_.push_back({a, b, alike != (stitch.direction == StitchDirection::end_to_start)});
        // What else of such a panel is sewn, and to which layer, nothing tells.
        for (std::size_t e = 0; e < evidence_.edges.size(); ++e) {
          if (evidence_.edges[e].ref.panel != stitch.b.panel) continue;
          known.taken.push_back(static_cast<int>(e));
        }
        continue;
      }
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
      known.chosen.push_back({a, b});
    }
    return known;
  }

  const Pattern& pattern_;
  const FindSeamsOptions& options_;
  SeamEvidence evidence_;
  std::map<std::array<int, 2>, int> number_;
  SideNames sides_ = SideNames::heeded;
  std::vector<EdgeSeam> turned_;  ///< given seams that turn a panel over, or lay it upon another
};

}  // namespace

FoundSeams find_seams(const Pattern& pattern, const FindSeamsOptions& options) {
  return SeamFinder(pattern, options).run();
}

FoundSeams opened(const Pattern& pattern, const FindSeamsOptions& options,
                  const FoundSeams& found) {
  return SeamFinder(pattern, options).opened(found);
}

}  // namespace toile
