// Fits the weights of find-seams to patterns that have seams. By hand:
//
//   cmake --build build/release --target bench_fit_seam_weights
//   build/release/tests/bench_fit_seam_weights --epochs 8 FILE...
//
// fuse_panels makes more FILEs, with sleeves and bodices of one piece. The weights were fitted to
// the random garments of `--part fit`, to every second one of these fused, and to the samples.
//
// Passive-aggressive updates (Crammer et al. 2006), averaged over each round. Measures of the
// stated garment are compared with those of the one that is found. That one gains something for
// each wrong seam. Each file is used with and without its names. After each round the rows of
// pattern/seams/seam_weights.cpp are printed, and how many garments were found.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <thread>

#include "geometry/error.h"
#include "io/output_file.h"
#include "pattern/pattern_file.h"
#include "pattern/seams/seam_search.h"
#include "pattern/seams/sewn_file.h"
#include "tests/support/seam_comparison.h"

namespace {

using namespace toile;

/// Worth that a wrong seam gains while weights are fitted.
double wrong_seam = 0.5;
/// The largest step of one update.
double largest_step = 0.03;

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
  const SeamPairs pairs(made.evidence, true);
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

SeamSearch::Garment best_of_two(SeamSearch& search) {
  SeamSearch::Garment first = search.search(0);
  SeamSearch::Garment second = search.search(1);
  return second.worth > first.worth ? second : first;
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

}  // namespace

int main(int argc, char** argv) {
  int epochs = 8;
  std::size_t batch = 4;
  std::vector<Example> examples;
  SeamMeasures weights = seam_weights;
  try {
    std::vector<std::string> files;
    for (int i = 1; i < argc; ++i) {
      const std::string word = argv[i];
      if (word == "--epochs")
        epochs = std::stoi(argv[++i]);
      else if (word == "--wrong")
        wrong_seam = std::stod(argv[++i]);
      else if (word == "--step")
        largest_step = std::stod(argv[++i]);
      else if (word == "--from") {
        std::ifstream in(argv[++i]);
        for (std::string line; std::getline(in, line);) {
          char name[64];
          double value = 0;
          if (std::sscanf(line.c_str(), "    {\"%63[a-z_]\", %lf},", name, &value) != 2) continue;
          for (int m = 0; m < seam_measures; ++m) {
            if (std::strcmp(name_of(static_cast<SeamMeasure>(m)), name) == 0) weights[m] = value;
          }
        }
      } else
        files.push_back(word);
    }
    for (const std::string& file : files) {
      for (const bool names : {true, false}) examples.push_back(example(file, names));
    }
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  SeamMeasures sum{};
  double updates = 0;
  std::uint64_t seed = 1;
  for (int epoch = 0; epoch < epochs; ++epoch) {
    std::vector<std::size_t> order(examples.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    for (std::size_t i = order.size(); i > 1; --i) {
      seed = seed * 6364136223846793005U + 1442695040888963407U;
      std::swap(order[i - 1], order[(seed >> 33) % i]);
    }
    int exact = 0;
    std::atomic<int> unfound = 0;
    double wrong = 0;
    double seams = 0;
    for (std::size_t begin = 0; begin < order.size(); begin += batch) {
      const std::size_t end = std::min(order.size(), begin + batch);
      std::vector<Partners> found(end - begin);
      std::vector<SeamMeasures> measures(end - begin);
      std::atomic<std::size_t> next{begin};
      const auto work = [&] {
        for (std::size_t i = next++; i < end; i = next++) {
          const Example& ex = examples[order[i]];
          const SeamPairs pairs(ex.evidence, true);
          SeamSearch search(ex.evidence, pairs, weights, {}, ex.extra);
          found[i - begin] = best_of_two(search).partners;
          measures[i - begin] = search.measures(found[i - begin]);
          // Where the search fails, a garment like the stated one is looked for.
          if (worth_of(measures[i - begin], weights) + extra_of(ex, found[i - begin]) <
              worth_of(ex.measures, weights) + extra_of(ex, ex.stated) - 1e-6) {
            ++unfound;
            found[i - begin] = search.best_near(ex.stated, 1).partners;
            measures[i - begin] = search.measures(found[i - begin]);
          }
        }
      };
      std::thread other(work);
      work();
      other.join();
      for (std::size_t i = begin; i < end; ++i) {
        const Example& ex = examples[order[i]];
        const SeamMeasures& is = measures[i - begin];
        // A wrong seam counts 1, as does a stated one that is missing.
        const double loss = extra_of(ex, found[i - begin]) - extra_of(ex, ex.stated);
        const double gain = worth_of(is, weights) - worth_of(ex.measures, weights) + loss;
        double square = 0;
        for (int m = 0; m < seam_measures; ++m) square += std::pow(ex.measures[m] - is[m], 2);
        wrong += loss / wrong_seam;
        seams += ex.seams - ex.lost;
        if (square < 1e-9) ++exact;
        if (square > 1e-9 && gain > 0) {
          const double step = std::min(largest_step, gain / square);
          for (int m = 0; m < seam_measures; ++m) {
            weights[m] += step * (ex.measures[m] - is[m]);
          }
        }
        for (int m = 0; m < seam_measures; ++m) sum[m] += weights[m];
        ++updates;
      }
    }
    std::printf("# round %d: %d of %zu garments, %.0f errors of %.0f seams, %d not found\n", epoch,
                exact, order.size(), wrong, seams, unfound.load());
    for (int m = 0; m < seam_measures; ++m) {
      std::printf("    {\"%s\", %.3f},\n", name_of(static_cast<SeamMeasure>(m)), sum[m] / updates);
    }
    std::fflush(stdout);
    // The average of this round alone goes on.
    if (epoch + 1 < epochs) {
      sum = {};
      updates = 0;
    }
  }
  return 0;
}
