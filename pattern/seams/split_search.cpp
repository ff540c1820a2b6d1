#include "pattern/seams/split_search.h"

#include <algorithm>
#include <set>

#include "pattern/check/left_out.h"
#include "pattern/file/pattern_file.h"
#include "pattern/seams/seam_runs.h"

namespace toile {

namespace {

/// Score by which a garment with cut edges has to be better, for each cut. Of 29 drawings, half of
/// it finds 336 seams and 67 wrong ones, double 311 and 4; as it is, 363 and 11.
constexpr double cut_gain = 6;

/// Runs that are looked at after each search, the likeliest by their odds. With half 359 seams and
/// 2 wrong ones are found, with double the same.
constexpr std::size_t most_runs = 40;

/// Confidence that seams of the parts of a cut edge have to have. With half of it the same drawings
/// of 43 are right; with double no edge stays cut.
constexpr double sure_part = 0.5;

/// Cuts that are made in a row.
constexpr int most_split_rounds = 12;

EdgeCuts with_more(EdgeCuts cuts, const EdgeCuts& more) {
  for (const auto& [place, shares] : more) {
    std::vector<EdgeCut>& of_edge = cuts[place];
    of_edge.insert(of_edge.end(), shares.begin(), shares.end());
    std::sort(of_edge.begin(), of_edge.end(),
              [](const EdgeCut& a, const EdgeCut& b) { return a.share < b.share; });
  }
  return cuts;
}

/// Score by which a garment has to be better that has these cuts.
double cost_of(const EdgeCuts& cuts) {
  std::size_t count = 0;
  for (const auto& [place, shares] : cuts) count += shares.size();
  return cut_gain * static_cast<double>(count);
}

/// A garment with some of its edges cut.
struct CutGarment {
  EdgeCuts cuts;
  CutPattern cut;
  FoundSeams found;
};

/// The garment with one more run, for which seams open that no longer pay.
CutGarment sewn(const CutGarment& garment, const SeamRun& run, const Pattern& pattern,
                const FindSeamsOptions& options) {
  CutGarment more;
  more.cuts = with_more(garment.cuts, run.cuts);
  more.cut = with_cuts(pattern, more.cuts);
  more.found =
      opened(more.cut.pattern, options, moved_to(garment.found, garment.cut, more.cut, run.seams));
  return more;
}

/// A seam of a cut edge is less certain than it looks: its sides were made to match.
void tell_cuts(CutGarment& garment) {
  const auto is_part = [&garment](const EdgeRef& side) {
    const EdgePart& part = garment.cut.parts[side.panel][side.edge];
    return part.from != 0 || part.to != 1;
  };
  for (FoundSeam& seam : garment.found.seams) {
    if (seam.given || (!is_part(seam.a) && !is_part(seam.b))) continue;
    seam.features[static_cast<int>(SeamFeature::cut)] = 1;
    seam.confidence = certainty_of(seam.features);
  }
}

/// Edges as drawn of which a part is not sewn, or not likely so.
std::set<std::array<int, 2>> unlikely_cuts(const CutGarment& garment) {
  std::set<std::array<int, 2>> sure;
  for (const FoundSeam& seam : garment.found.seams) {
    if (seam.confidence < sure_part) continue;
    for (const EdgeRef& side : {seam.a, seam.b}) sure.insert({side.panel, side.edge});
  }
  std::set<std::array<int, 2>> unlikely;
  for (std::size_t p = 0; p < garment.cut.parts.size(); ++p) {
    for (std::size_t e = 0; e < garment.cut.parts[p].size(); ++e) {
      const EdgePart& part = garment.cut.parts[p][e];
      if (part.from == 0 && part.to == 1) continue;
      const int panel = static_cast<int>(p);
      if (!sure.contains({panel, static_cast<int>(e)})) unlikely.insert({panel, part.edge});
    }
  }
  return unlikely;
}

}  // namespace

SplitSeams find_split_seams(const std::string& text, const std::string& name,
                            const Pattern& pattern, const FindSeamsOptions& options) {
  FindSeamsOptions quick = options;
  quick.certain = false;
  const auto is_over = [&options] { return options.is_over && options.is_over(); };
  CutGarment best{{}, with_cuts(pattern, {}), find_seams(pattern, quick)};
  for (int round = 0; round < most_split_rounds && !is_over(); ++round) {
    if (options.heard) options.heard(best.found.seams.size(), best.cut.splits.size());
    std::vector<SeamRun> runs = seam_runs(best.cut, options.drawn_walk, best.found);
    runs.resize(std::min(runs.size(), most_runs));
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < runs.size() && !is_over(); ++i) {
      const double gain = sewn(best, runs[i], pattern, options).found.score - best.found.score -
                          cost_of(runs[i].cuts);
      if (gain > 0) order.push_back({gain, i});
    }
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    CutGarment better = best;
    std::set<std::array<int, 2>> touched;
    for (const auto& [gain, i] : order) {
      std::set<std::array<int, 2>> edges;
      for (const auto& [a, b] : runs[i].seams) {
        edges.insert({{a.panel, a.part.edge}, {b.panel, b.part.edge}});
      }
      if (std::any_of(edges.begin(), edges.end(),
                      [&](const std::array<int, 2>& edge) { return touched.contains(edge); })) {
        continue;
      }
      CutGarment trial = sewn(better, runs[i], pattern, options);
      if (trial.found.score - better.found.score < cost_of(runs[i].cuts)) continue;
      better = std::move(trial);
      touched.insert(edges.begin(), edges.end());
    }
    if (touched.empty()) break;
    const FoundSeams before = better.found;
    quick.before = &before;
    better.found = find_seams(better.cut.pattern, quick);
    best = std::move(better);
  }
  // Edges stay whole whose parts are not all likely.
  for (;;) {
    best.found = find_seams(best.cut.pattern, options);
    tell_cuts(best);
    const std::set<std::array<int, 2>> unlikely = unlikely_cuts(best);
    if (unlikely.empty()) break;
    for (const std::array<int, 2>& edge : unlikely) best.cuts.erase(edge);
    best.cut = with_cuts(pattern, best.cuts);
  }
  SplitSeams result{text, pattern, {}, std::move(best.found)};
  for (const EdgeSplit& split : best.cut.splits) {
    result.text = with_split_edge(result.text, result.pattern, split);
    result.splits.push_back(split);
    std::vector<Remark> again;
    result.pattern = without_left_out(parse_drawn_pattern(result.text, name, again), again);
  }
  return result;
}

}  // namespace toile
