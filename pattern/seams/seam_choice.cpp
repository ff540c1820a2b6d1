#include "pattern/seams/seam_choice.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/parallel.h"

namespace toile {

namespace {

/// Searches: to know the score, and to be certain.
constexpr int first_searches = 4;
constexpr int all_searches = 8;
constexpr int patience = 2;  // times as many garments as usual in each of them

/// Searches, and their patience, where the others do not agree. Of three random skirts whose tiers
/// are sewn in a wrong order with 16 of the usual patience, one is right with these.
constexpr int long_searches = 8;
constexpr int long_patience = 6;

/// How often what is better than the best garment is taken.
constexpr int most_rounds = 3;

/// Score: a garment that lacks more is no rival.
constexpr double widest_gap = 6;

const SeamSearch::Garment& better_of(const std::vector<SeamSearch::Garment>& garments,
                                     const SeamSearch::Garment& best) {
  const SeamSearch::Garment* better = &best;
  for (const SeamSearch::Garment& garment : garments) {
    if (garment.partners.empty()) continue;
    if (garment.score > better->score + same_garment) better = &garment;
  }
  return *better;
}

}  // namespace

SeamChooser::SeamChooser(const SeamEvidence& evidence, const KnownSeams& known,
                         const IsOver& is_over)
    : evidence_(evidence),
      known_(known),
      is_over_(is_over),
      pairs_(evidence),
      weights_(seam_weights),
      search_(evidence, pairs_, weights_, known, {}, is_over),
      found_(searched(0, first_searches, patience)) {
  best_ = found_.front();
  take_best_of(found_);
}

SeamChooser::SeamChooser(const SeamEvidence& evidence, const KnownSeams& known,
                         const Partners& begin, const IsOver& is_over)
    : evidence_(evidence),
      known_(known),
      is_over_(is_over),
      pairs_(evidence),
      weights_(seam_weights),
      search_(evidence, pairs_, weights_, known, {}, is_over),
      found_{search_.near(begin)} {
  best_ = search_.climbed(found_.front());
}

std::vector<SeamSearch::Garment> SeamChooser::found_without() const {
  const int edges = static_cast<int>(evidence_.edges.size());
  std::map<int, int> first;  // per kind of seam: the edge that names it first
  for (int a = 0; a < edges; ++a) {
    if (best_.partners[a] > a && !search_.locked(a)) {
      first.emplace(search_.kind(a, best_.partners[a]), a);
    }
  }
  const std::vector<std::pair<int, int>> kinds(first.begin(), first.end());
  std::vector<SeamSearch::Garment> of_kind(kinds.size());
  parallel_for(kinds.size(), [&](std::size_t i) {
    SeamSearch search = search_;
    search.forbid(kinds[i].first);
    of_kind[i] = search.near(best_.partners);
  });
  std::vector<SeamSearch::Garment> found(edges);
  for (int a = 0; a < edges; ++a) {
    if (best_.partners[a] < 0 || search_.locked(a)) continue;
    const int kind = search_.kind(a, best_.partners[a]);
    const auto at = std::lower_bound(kinds.begin(), kinds.end(), std::pair{kind, 0});
    found[a] = of_kind[at - kinds.begin()];
  }
  return found;
}

void SeamChooser::take_best_of(const std::vector<SeamSearch::Garment>& garments) {
  best_ = SeamSearch::Garment(better_of(garments, best_));
  for (int round = 0; round < most_rounds; ++round) {
    const double before = best_.score;
    for (const SeamSearch::Garment& garment : garments) {
      best_ = search_.recombined(best_, garment);
    }
    best_ = search_.climbed(best_);
    if (best_.score < before + same_garment || (is_over_ && is_over_())) return;
    best_ = better_of({search_.near(best_.partners)}, best_);
  }
}

/// How many of the searches found the best garment.
int SeamChooser::times_found() const {
  return static_cast<int>(
      std::count_if(found_.begin(), found_.end(), [&](const SeamSearch::Garment& garment) {
        return std::abs(garment.score - best_.score) < same_garment;
      }));
}

/// Searches numbered from `first` on, of `times` the usual length.
std::vector<SeamSearch::Garment> SeamChooser::searched(int first, int count, int times) const {
  std::vector<SeamSearch::Garment> found(count);
  parallel_for(count, [&](std::size_t run) {
    SeamSearch search = search_;
    found[run] = search.search(first + static_cast<int>(run), times);
  });
  return found;
}

void SeamChooser::settle() {
  if (found_.size() == all_searches) return;
  const std::vector<SeamSearch::Garment> others =
      searched(first_searches, all_searches - first_searches, patience);
  found_.insert(found_.end(), others.begin(), others.end());
  take_best_of(found_);
  if (times_found() < 2) take_best_of(searched(all_searches, long_searches, long_patience));
}

SeamChoice SeamChooser::choose() {
  settle();
  std::vector<SeamSearch::Garment> without = found_without();
  for (int round = 1; round < most_rounds; ++round) {
    const SeamSearch::Garment& better = better_of(without, best_);
    if (&better == &best_) break;
    best_ = SeamSearch::Garment(better);
    without = found_without();
  }
  SeamChoice choice;
  choice.score = best_.score;
  const int edges = static_cast<int>(evidence_.edges.size());
  for (int a = 0; a < edges; ++a) {
    const int b = best_.partners[a];
    if (b < a) continue;
    choice.seams.push_back({a, b, {}, {-1, -1}});
    if (without[a].partners.empty()) continue;
    for (const int e : {a, b}) {
      const int other = without[a].partners[e];
      if (other < 0 || choice.seams.back().alternative[0] >= 0) continue;
      choice.seams.back().alternative = {std::min(e, other), std::max(e, other)};
    }
  }
  tell_features(without, choice);
  return choice;
}

SeamChoice SeamChooser::best() const {
  SeamChoice choice;
  choice.score = best_.score;
  for (int a = 0; a < static_cast<int>(best_.partners.size()); ++a) {
    const int b = best_.partners[a];
    if (b > a) choice.seams.push_back({a, b, {}, {-1, -1}});
  }
  return choice;
}

/// The share of garments that have a seam of this kind.
double SeamChooser::share(const std::vector<SeamSearch::Garment>& garments, int a, int b) const {
  const int kind = search_.kind(a, b);
  int count = 0;
  for (const SeamSearch::Garment& garment : garments) {
    for (int e = 0; e < static_cast<int>(garment.partners.size()); ++e) {
      const int other = garment.partners[e];
      if (other < e || search_.kind(e, other) != kind) continue;
      ++count;
      break;
    }
  }
  return static_cast<double>(count) / static_cast<double>(garments.size());
}

void SeamChooser::tell_features(const std::vector<SeamSearch::Garment>& without,
                                SeamChoice& choice) const {
  const auto at = [](SeamFeatures& features, SeamFeature feature) -> double& {
    return features[static_cast<int>(feature)];
  };
  const int times = times_found();
  choice.settled = times > 1;
  const bool is_early = is_over_ && is_over_();
  const std::vector<WalkedEdge>& edges = evidence_.edges;
  const bool names_tell =
      std::any_of(evidence_.words.begin(), evidence_.words.end(), [](const PanelWords& words) {
        return words.role != PanelRole::unknown || words.face != 0 || words.side != 0;
      });
  double gap_sum = 0;
  for (ChosenSeam& seam : choice.seams) {
    SeamFeatures& features = seam.features;
    at(features, SeamFeature::one) = 1;
    at(features, SeamFeature::found) = share(found_, seam.a, seam.b);
    const double lacks = is_early                           ? 0
                         : without[seam.a].partners.empty() ? widest_gap
                                                            : best_.score - without[seam.a].score;
    at(features, SeamFeature::gap) = std::log1p(std::clamp(lacks, 0.0, widest_gap));
    at(features, SeamFeature::settled) = static_cast<double>(times) / all_searches;
    at(features, SeamFeature::edges) = std::log(static_cast<double>(edges.size()));
    at(features, SeamFeature::named) = names_tell ? 1 : 0;
    const double ratio = std::abs(std::log(edges[seam.a].length / edges[seam.b].length));
    at(features, SeamFeature::equal_length) = std::exp(-ratio / 0.005);
    at(features, SeamFeature::gathered) = ratio;
    const std::vector<int>& shape = evidence_.shapes.shape;
    at(features, SeamFeature::coincide) = shape[seam.a] == shape[seam.b] ? 1 : 0;
    const SeamMeasures pair = pairs_.measures(seam.a, seam.b);
    const double likely = pair[static_cast<int>(SeamMeasure::likely)];
    at(features, SeamFeature::likely) = std::clamp(likely / 10, -1.0, 1.0);
    gap_sum += at(features, SeamFeature::gap);
  }
  const double count = static_cast<double>(std::max<std::size_t>(1, choice.seams.size()));
  for (ChosenSeam& seam : choice.seams) {
    SeamFeatures& features = seam.features;
    at(features, SeamFeature::garment_gap) = gap_sum / count;
  }
}

}  // namespace toile
