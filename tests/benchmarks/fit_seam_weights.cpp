// Fits the weights of find-seams to patterns that have seams. By hand:
//
//   cmake --build build/release --target bench_fit_seam_weights
//   build/release/tests/bench_fit_seam_weights --rounds 5 FILE...
//
// fuse_panels makes more FILEs, with sleeves and bodices of one piece. What the weights in use were
// fitted to is told in pattern/seams/seam_weights.cpp.
//
// Begins with the weights in use. Measures of the stated garment are compared with those of rivals
// that short searches find near it; a rival gains something for each wrong seam. Each file is used
// with and without its names. After each round the rows of pattern/seams/seam_weights.cpp are
// printed.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <thread>

#include "geometry/error.h"
#include "io/output_file.h"
#include "pattern/file/pattern_file.h"
#include "pattern/seams/seam_search.h"
#include "pattern/seams/sewn_file.h"
#include "tests/support/seam_comparison.h"

namespace {

using namespace toile;

/// Score that a wrong seam gains while weights are fitted.
double wrong_seam = 0.5;

struct Example {
  std::string name;
  SeamEvidence evidence;
  Partners stated;
  std::vector<double> extra;
  int seams = 0;
  int lost = 0;
  SeamMeasures measures{};
};

Example example(const std::string& file, bool names) {
  const std::string text = read_file(file);
  std::vector<Remark> remarks;
  const Pattern pattern = parse_drawn_pattern(text, file, remarks);
  const bool drawn_walk = has_drawn_walk(text, file);
  Example made;
  made.name = file.substr(file.rfind('/') + 1) + (names ? "" : " nameless");
  made.evidence =
      seam_evidence(stripped(pattern, names, false), drawn_walk, turned_over(pattern, drawn_walk));
  const auto& edges = made.evidence.edges;
  const SeamPairs pairs(made.evidence);
  std::map<std::array<int, 2>, int> number;
  for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
    number[{edges[e].ref.panel, edges[e].ref.edge}] = e;
  }
  made.stated.assign(edges.size(), -1);
  std::set<std::array<int, 3>> kinds;
  const EdgeShapes& shapes = made.evidence.shapes;
  const auto kind = [&](int a, int b) {
    return std::array{std::min(shapes.shape[a], shapes.shape[b]),
                      std::max(shapes.shape[a], shapes.shape[b]), shapes.hand[a] * shapes.hand[b]};
  };
  for (const SeamPair& seam : stated_seams(pattern)) {
    const int a = number.at(seam.a);
    const int b = number.at(seam.b);
    ++made.seams;
    if (seam.reversed != (edges[a].forward == edges[b].forward) || !pairs.possible(a, b) ||
        made.stated[a] >= 0 || made.stated[b] >= 0) {
      ++made.lost;
      std::printf("# %s: %d:%d %d:%d cannot be found%s\n", made.name.c_str(), seam.a[0], seam.a[1],
                  seam.b[0], seam.b[1], pairs.possible(a, b) ? "" : ", impossible");
      continue;
    }
    made.stated[a] = b;
    made.stated[b] = a;
    kinds.insert(kind(a, b));
  }
  const std::size_t count = edges.size();
  made.extra.assign(count * count, wrong_seam);
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = 0; b < count; ++b) {
      if (kinds.contains(kind(static_cast<int>(a), static_cast<int>(b)))) {
        made.extra[a * count + b] = -wrong_seam;
      }
    }
  }
  SeamSearch search(made.evidence, pairs, seam_weights, {});
  made.measures = search.measures(made.stated);
  return made;
}

double extra_of(const Example& example, const Partners& partners) {
  double sum = 0;
  for (std::size_t a = 0; a < partners.size(); ++a) {
    if (partners[a] > static_cast<int>(a)) {
      sum += example.extra[a * partners.size() + partners[a]];
    }
  }
  return sum;
}

/// A garment that was found for an example. The stated one has `more` of each measure. The found
/// one gains `loss` for its wrong seams.
struct Rival {
  SeamMeasures more{};
  double loss = 0;
  double step = 0;  // share of `more` in the weights
};

/// The weights nearest to `from` by which stated garments score higher than their rivals, by the
/// rivals' losses. Dual coordinate ascent (Hsieh et al. 2008): `steps` of one example's rivals add
/// up to `cap` at most.
SeamMeasures fit(const SeamMeasures& from, std::vector<std::vector<Rival>>& rivals, double cap) {
  SeamMeasures weights = from;
  for (const auto& list : rivals) {
    for (const Rival& rival : list) {
      for (int m = 0; m < seam_measures; ++m) weights[m] += rival.step * rival.more[m];
    }
  }
  constexpr int sweeps = 400;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (auto& list : rivals) {
      double used = 0;
      for (const Rival& rival : list) used += rival.step;
      for (Rival& rival : list) {
        double square = 0;
        for (const double value : rival.more) square += value * value;
        if (square < 1e-9) continue;
        const double lack = rival.loss - score_of(rival.more, weights);
        const double most = std::max(0.0, cap - used + rival.step);
        const double step = std::clamp(rival.step + lack / square, 0.0, most);
        for (int m = 0; m < seam_measures; ++m) {
          weights[m] += (step - rival.step) * rival.more[m];
        }
        used += step - rival.step;
        rival.step = step;
      }
    }
  }
  return weights;
}

}  // namespace

int main(int argc, char** argv) {
  int rounds = 6;
  int wide = 0;
  double cap = 0.05;
  std::vector<Example> examples;
  try {
    std::vector<std::string> files;
    for (int i = 1; i < argc; ++i) {
      const std::string word = argv[i];
      if (word == "--rounds") {
        rounds = std::stoi(argv[++i]);
      } else if (word == "--wrong") {
        wrong_seam = std::stod(argv[++i]);
      } else if (word == "--cap") {
        cap = std::stod(argv[++i]);
      } else if (word == "--wide") {
        wide = std::stoi(argv[++i]);
      } else {
        files.push_back(word);
      }
    }
    for (const std::string& file : files) {
      for (const bool names : {true, false}) examples.push_back(example(file, names));
    }
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  SeamMeasures weights = seam_weights;
  std::vector<std::vector<Rival>> rivals(examples.size());
  for (int round = 0; round < rounds; ++round) {
    std::vector<Rival> found(examples.size());
    std::atomic<std::size_t> next{0};
    const bool far = round >= rounds - wide;
    const auto work = [&] {
      for (std::size_t i = next++; i < examples.size(); i = next++) {
        const Example& ex = examples[i];
        const SeamPairs pairs(ex.evidence);
        SeamSearch search(ex.evidence, pairs, weights, {}, ex.extra);
        const Partners partners =
            far ? search.best_near(ex.stated, round).partners : search.near(ex.stated).partners;
        const SeamMeasures is = search.measures(partners);
        for (int m = 0; m < seam_measures; ++m) found[i].more[m] = ex.measures[m] - is[m];
        found[i].loss = extra_of(ex, partners) - extra_of(ex, ex.stated);
      }
    };
    std::thread other(work);
    work();
    other.join();
    double lack = 0;
    int beaten = 0;
    double wrong = 0;
    for (std::size_t i = 0; i < examples.size(); ++i) {
      const double score = score_of(found[i].more, weights);
      wrong += found[i].loss / wrong_seam;
      if (score < -1e-6) {
        ++beaten;
        std::printf("# %s scores %.2f less\n", examples[i].name.c_str(), -score);
      }
      if (found[i].loss - score <= 1e-6) continue;
      lack += found[i].loss - score;
      rivals[i].push_back(found[i]);
    }
    weights = fit(seam_weights, rivals, cap);
    std::printf("# round %d: %d of %zu garments score less than a rival, lack %.1f, %.0f errors\n",
                round, beaten, examples.size(), lack, wrong);
    for (int m = 0; m < seam_measures; ++m) {
      std::printf("    {\"%s\", %.3f},\n", name_of(static_cast<SeamMeasure>(m)), weights[m]);
    }
    std::fflush(stdout);
  }
  return 0;
}
