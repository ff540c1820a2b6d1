// Why find-seams errs, for each garment whose seams are not all found. Where the stated garment
// scores higher than the found one, the search failed. Where it scores lower, the weights did.
// Lists the measures that speak for the found one, and those that speak for the stated one. By
// hand:
//
//   cmake --build build/release --target bench_seam_causes
//   build/release/tests/bench_seam_causes FILE...
//
// Confidences are not looked at: all that is listed counts. Ends with a table of causes.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include "geometry/error.h"
#include "io/output_file.h"
#include "pattern/file/pattern_file.h"
#include "pattern/seams/seam_choice.h"
#include "pattern/seams/sewn_file.h"
#include "tests/support/seam_comparison.h"

namespace {

using namespace toile;

struct Causes {
  int garments = 0;
  int whole = 0;
  int search = 0;  // garments, and so on
  int weights = 0;
  int impossible = 0;
  int stated = 0;
  int found = 0;
  int right = 0;
};

void look(const std::string& file, bool names, Causes& causes) {
  const std::string text = read_file(file);
  std::vector<Remark> remarks;
  const Pattern pattern = parse_drawn_pattern(text, file, remarks);
  FindSeamsOptions options;
  options.drawn_walk = has_drawn_walk(text, file);
  options.certain = false;
  const Pattern bare = stripped(pattern, names, false);
  const FoundSeams found = find_seams(bare, options);
  std::set<SeamPair> listed;
  for (const FoundSeam& seam : found.seams) {
    listed.insert(seam_pair(seam.a, seam.b, seam.reversed));
  }
  SeamComparison comparison(pattern, options.drawn_walk, !names);
  const SeamMatches figures = comparison.compare(stated_seams(pattern), listed);
  ++causes.garments;
  causes.stated += figures.stated;
  causes.found += figures.found;
  causes.right += figures.right;
  if (figures.whole()) {
    ++causes.whole;
    return;
  }
  const SeamEvidence evidence =
      seam_evidence(bare, options.drawn_walk, turned_over(pattern, options.drawn_walk));
  const SeamPairs pairs(evidence);
  std::map<std::array<int, 2>, int> number;
  for (int e = 0; e < static_cast<int>(evidence.edges.size()); ++e) {
    number[{evidence.edges[e].ref.panel, evidence.edges[e].ref.edge}] = e;
  }
  Partners stated(evidence.edges.size(), -1);
  std::string lost;
  for (const SeamPair& seam : stated_seams(pattern)) {
    const int a = number.at(seam.a);
    const int b = number.at(seam.b);
    const bool along = seam.reversed != (evidence.edges[a].forward == evidence.edges[b].forward);
    if (along || !pairs.possible(a, b) || stated[a] >= 0 || stated[b] >= 0) {
      lost.append(edge_name(pattern, EdgeRef{seam.a[0], seam.a[1]})).append(" and ");
      lost.append(edge_name(pattern, EdgeRef{seam.b[0], seam.b[1]}));
      lost.append(along ? ", along; " : "; ");
      continue;
    }
    stated[a] = b;
    stated[b] = a;
  }
  SeamChooser chooser(evidence, {});
  Partners best(evidence.edges.size(), -1);
  for (const ChosenSeam& seam : chooser.best().seams) {
    best[seam.a] = seam.b;
    best[seam.b] = seam.a;
  }
  SeamSearch search(evidence, pairs, seam_weights, {});
  const SeamMeasures is = search.measures(best);
  const SeamMeasures should = search.measures(stated);
  const double lack = score_of(is, seam_weights) - score_of(should, seam_weights);
  const char* cause = !lost.empty() ? "impossible" : lack < -1e-3 ? "search" : "weights";
  ++(!lost.empty() ? causes.impossible : lack < -1e-3 ? causes.search : causes.weights);
  std::printf(
      "%s%s: %s, %d edges, score %.2f, of the stated one %.2f, sides %s; %d stated, %d found, %d "
      "right\n",
      file.substr(file.rfind('/') + 1).c_str(), names ? "" : " nameless", cause,
      static_cast<int>(evidence.edges.size()), score_of(is, seam_weights),
      score_of(should, seam_weights),
      std::abs(found.score - score_of(is, seam_weights)) < 0.01 ? "heeded" : "turned",
      figures.stated, figures.found, figures.right);
  if (!lost.empty()) std::printf("  lost: %s\n", lost.c_str());
  for (const std::string& line : comparison.mistakes(pattern)) std::printf("  %s\n", line.c_str());
  std::vector<std::pair<double, int>> terms;
  for (int m = 0; m < seam_measures; ++m) {
    const double term = (is[m] - should[m]) * seam_weights[m];
    if (std::abs(term) > 0.05) terms.push_back({term, m});
  }
  std::sort(terms.rbegin(), terms.rend());
  std::printf("  :");
  for (const auto& [term, m] : terms) {
    std::printf(" %s %+.2f;", name_of(static_cast<SeamMeasure>(m)), term);
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  std::array<Causes, 2> causes;
  try {
    for (int i = 1; i < argc; ++i) {
      for (const bool names : {true, false}) look(argv[i], names, causes[names ? 0 : 1]);
    }
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  std::printf(
      "\n| names | garments | wholly right | search | weights | impossible | precision | recall |\n"
      "|---|---|---|---|---|---|---|---|\n");
  for (const bool names : {true, false}) {
    const Causes& c = causes[names ? 0 : 1];
    std::printf("| %s | %d | %d | %d | %d | %d | %.3f | %.3f |\n", names ? "kept" : "gone",
                c.garments, c.whole, c.search, c.weights, c.impossible,
                c.right / std::max(1.0, c.found * 1.0), c.right / std::max(1.0, c.stated * 1.0));
  }
  return 0;
}
