// Writes the features of pairs of edges, and whether they are sewn, for fit_seam_trees.py. By hand:
//
//   cmake --build build/release --target bench_seam_pairs
//   build/release/tests/bench_seam_pairs --varied 1 PAIRS FILE...
//
// The first float is the number of features. Then comes a row for each pair:
//
// - the file's number;
// - 0 without names, 1 with them, 2 with them but for left and right;
// - 1 for a seam;
// - the number of pairs that the row stands for: of pairs whose lengths differ, some are kept;
// - the features of pattern/seams/pair_features.h.
//
// Pairs that differ in which of equal pieces they join count as one.
//
// `--varied N`: N times more, each time varied as drawings by hand vary. Pieces are larger or
// smaller by some 1 %, or upside down. Of five names one is lost. Edges are eased by some 0.6 %.
// Seams are cut in two at notches. With `--miscut`, some edges are cut where they are sewn to
// nothing instead. `--not-plain`: not as they are.
#include "pattern/seams/seam_pairs.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>
#include <set>
#include <tuple>
#include <utility>

#include "geometry/error.h"
#include "io/output_file.h"
#include "pattern/file/pattern_file.h"
#include "pattern/seams/seam_runs.h"
#include "pattern/seams/sewn_file.h"
#include "pattern/seams/splitmix.h"
#include "tests/support/seam_comparison.h"

namespace {

using namespace toile;

struct Garment {
  std::string file;
  bool drawn_walk = false;
  Pattern pattern;
  std::set<SeamPair> seams;
  std::vector<char> turned;
};

Garment read(const std::string& file) {
  Garment garment;
  garment.file = file;
  const std::string text = read_file(file);
  std::vector<Remark> remarks;
  garment.pattern = parse_drawn_pattern(text, file, remarks);
  garment.drawn_walk = has_drawn_walk(text, file);
  garment.seams = stated_seams(garment.pattern);
  garment.turned = turned_over(garment.pattern, garment.drawn_walk);
  return garment;
}

using Random = std::mt19937;

double normal(Random& random) { return std::normal_distribution<double>()(random); }
double part(Random& random) { return std::uniform_real_distribution<double>()(random); }

/// Cuts some seams in two, with a notch on either side. Mirror images are cut alike.
void notch_seams(Garment& garment, Random& random) {
  constexpr double chance = 0.2;
  constexpr double shortest = 0.06;  // metres
  const std::vector<WalkedEdge> edges = walked_edges(garment.pattern, garment.drawn_walk);
  std::map<std::array<int, 2>, int> place;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    place[{edges[e].ref.panel, edges[e].ref.edge}] = static_cast<int>(e);
  }
  std::map<std::array<int, 2>, double> cuts;        // by the lengths, millimetres
  std::vector<std::pair<SeamPair, double>> chosen;  // and the share of its first edge
  for (const SeamPair& seam : garment.seams) {
    const WalkedEdge& a = edges[place.at(seam.a)];
    const WalkedEdge& b = edges[place.at(seam.b)];
    const std::array key = {static_cast<int>(std::lround(1000 * std::min(a.length, b.length))),
                            static_cast<int>(std::lround(1000 * std::max(a.length, b.length)))};
    const auto [cut, is_new] = cuts.emplace(key, 0);
    if (is_new && part(random) < chance) cut->second = 0.25 + 0.5 * part(random);
    if (cut->second == 0 || seam.a[0] == seam.b[0] || a.length < shortest || b.length < shortest) {
      continue;
    }
    // From the end with the wider corner.
    const double share = edges[a.next].corner > a.corner ? 1 - cut->second : cut->second;
    chosen.push_back({seam, a.forward ? share : 1 - share});
  }
  EdgeCuts places;
  for (const auto& [seam, share] : chosen) {
    places[seam.a] = {{share, true}};
    places[seam.b] = {{seam.reversed ? 1 - share : share, true}};
  }
  CutPattern cut = with_cuts(garment.pattern, places);
  std::map<std::array<int, 2>, int> rest;
  for (const EdgeSplit& split : cut.splits) {
    rest[{split.edge.panel, split.edge.edge}] = split.rest;
  }
  garment.pattern = std::move(cut.pattern);
  for (const auto& [seam, share] : chosen) {
    garment.seams.erase(seam);
    const EdgeRef a{seam.a[0], seam.a[1]};
    const EdgeRef b{seam.b[0], seam.b[1]};
    const EdgeRef rest_a{seam.a[0], rest.at(seam.a)};
    const EdgeRef rest_b{seam.b[0], rest.at(seam.b)};
    garment.seams.insert(seam_pair(a, seam.reversed ? rest_b : b, seam.reversed));
    garment.seams.insert(seam_pair(rest_a, seam.reversed ? b : rest_b, seam.reversed));
  }
}

/// Cuts edges where find-seams would try it, beside the garment's own seams, which are left out
/// where one of their edges is cut. Some seams are not known then.
void miscut(Garment& garment, Random& random) {
  constexpr double known = 0.7;
  constexpr std::size_t looked_at = 12;
  constexpr std::size_t most_runs = 3;
  FoundSeams found;
  const std::vector<WalkedEdge> edges = walked_edges(garment.pattern, garment.drawn_walk);
  std::map<std::array<int, 2>, double> length;
  for (const WalkedEdge& edge : edges) length[{edge.ref.panel, edge.ref.edge}] = edge.length;
  for (const SeamPair& seam : garment.seams) {
    if (part(random) > known) continue;
    FoundSeam one;
    one.a = {seam.a[0], seam.a[1]};
    one.b = {seam.b[0], seam.b[1]};
    one.length_a = length.at(seam.a);
    one.length_b = length.at(seam.b);
    found.seams.push_back(one);
  }
  const Pattern bare = stripped(garment.pattern, part(random) < 0.5, false);
  std::vector<SeamRun> runs = seam_runs(with_cuts(bare, {}), garment.drawn_walk, found);
  runs.resize(std::min(runs.size(), looked_at));
  std::shuffle(runs.begin(), runs.end(), random);
  EdgeCuts cuts;
  for (std::size_t i = 0; i < runs.size() && i < most_runs; ++i) {
    const bool apart = std::none_of(runs[i].cuts.begin(), runs[i].cuts.end(),
                                    [&](const auto& cut) { return cuts.contains(cut.first); });
    if (apart) cuts.insert(runs[i].cuts.begin(), runs[i].cuts.end());
  }
  garment.pattern = with_cuts(garment.pattern, cuts).pattern;
  std::erase_if(garment.seams, [&](const SeamPair& seam) {
    return cuts.contains(seam.a) || cuts.contains(seam.b);
  });
}

/// Pieces of another size, some upside down, and edges that are eased; equal ones alike.
void vary(SeamEvidence& evidence, Random& random) {
  constexpr double size = 0.012;
  constexpr double ease = 0.006;
  constexpr double upside_down = 0.1;
  const std::size_t panels = evidence.words.size();
  std::vector<int> alike(panels);
  for (std::size_t p = 0; p < panels; ++p) alike[p] = static_cast<int>(p);
  for (const PanelFit& fit : evidence.fits) {
    alike[fit.from] = std::min(alike[fit.from], fit.to);
  }
  std::vector<double> scale(panels);
  std::vector<double> up(panels);
  for (std::size_t p = 0; p < panels; ++p) {
    scale[p] = std::exp(size * normal(random));
    up[p] = part(random) < upside_down ? -1 : 1;
  }
  std::vector<double> eased(evidence.edges.size());
  const double least = part(random) < 0.5 ? 0 : ease;
  for (double& one : eased) one = std::exp(least * normal(random));
  for (std::size_t e = 0; e < evidence.edges.size(); ++e) {
    WalkedEdge& edge = evidence.edges[e];
    const int like = alike[edge.ref.panel];
    edge.length *= scale[like] * eased[evidence.shapes.shape[e]];
    for (Vec2& point : edge.points) point *= scale[like] * up[like];
    edge.upwards *= up[like];
    edge.rise *= up[like];
  }
}

std::size_t write(const Garment& garment, int number, int kept, Random* random, std::FILE* out) {
  const bool names = kept > 0;
  Pattern bare = stripped(garment.pattern, names, false);
  for (PatternPanel& panel : bare.panels) {
    constexpr double nameless = 0.2;
    if (names && random != nullptr && part(*random) < nameless) panel.name.assign(1, 'k');
  }
  SeamEvidence evidence = seam_evidence(bare, garment.drawn_walk, garment.turned);
  if (kept == 2) evidence = heeding(SideNames::ignored, std::move(evidence));
  if (random != nullptr) vary(evidence, *random);
  const auto& edges = evidence.edges;
  const int count = static_cast<int>(edges.size());
  const SeamPairs pairs(evidence);
  const PairFeatures features(evidence);
  std::map<std::array<int, 2>, int> place;
  for (int e = 0; e < count; ++e) place[{edges[e].ref.panel, edges[e].ref.edge}] = e;
  // Equal pieces are told apart by their names, but not by their numbers, nor left from right.
  const EdgeShapes& shapes = evidence.shapes;
  const auto side = [&](int e) {
    const int panel = edges[e].ref.panel;
    const PanelWords& words = evidence.words[panel];
    const std::string called = names ? words.stem + "/" + std::to_string(words.face) : "";
    return std::tuple(shapes.shape[e], called, evidence.side[panel]);
  };
  using Kind = std::tuple<decltype(side(0)), decltype(side(0)), int>;
  const auto kind = [&](int a, int b) {
    const auto first = side(a);
    const auto second = side(b);
    return Kind(std::min(first, second), std::max(first, second), shapes.hand[a] * shapes.hand[b]);
  };
  std::set<Kind> sewn;
  for (const SeamPair& seam : garment.seams) {
    const int a = place.at(seam.a);
    const int b = place.at(seam.b);
    if (seam.reversed != (edges[a].forward == edges[b].forward)) continue;
    sewn.insert(kind(a, b));
  }
  std::size_t rows = 0;
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      if (!pairs.possible(a, b)) continue;
      const bool right = sewn.contains(kind(a, b));
      const double ratio = std::abs(std::log(edges[a].length / edges[b].length));
      const int of = right || ratio < 0.02 ? 1 : ratio < 0.3 ? 3 : 16;
      if ((a * 31 + b * 17) % of != 0) continue;
      // Which comes first says nothing, nor does left from right.
      const std::uint64_t chance = mixed(static_cast<std::uint64_t>(a) * count + b);
      const bool swap = chance % 2 == 0;
      const bool mirrored = chance / 2 % 2 == 0;
      const PairRow row = features.of(swap ? b : a, swap ? a : b, mirrored);
      const float head[] = {static_cast<float>(number), static_cast<float>(kept), right ? 1.F : 0.F,
                            static_cast<float>(of)};
      std::fwrite(head, std::size(head) * sizeof(float), 1, out);
      std::fwrite(row.data(), sizeof(float), row.size(), out);
      ++rows;
    }
  }
  return rows;
}

}  // namespace

int main(int argc, char** argv) {
  int varied = 0;
  bool plain = true;
  bool is_miscut = false;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--varied" && i + 1 < argc) {
      varied = std::stoi(argv[++i]);
    } else if (word == "--miscut") {
      is_miscut = true;
    } else if (word == "--not-plain") {
      plain = false;
    } else {
      files.push_back(word);
    }
  }
  std::FILE* out = files.size() < 2 ? nullptr : std::fopen(files[0].c_str(), "wb");
  if (out == nullptr) {
    std::fprintf(stderr, "bench_seam_pairs [--varied N [--miscut]] [--not-plain] PAIRS FILE...\n");
    return 1;
  }
  std::size_t rows = 0;
  const float width = pair_features;
  std::fwrite(&width, sizeof width, 1, out);
  Random random(1);
  for (std::size_t i = 1; i < files.size(); ++i) {
    try {
      const Garment garment = read(files[i]);
      for (int v = plain ? 0 : 1; v <= varied; ++v) {
        Garment one = garment;
        if (v > 0 && is_miscut) {
          miscut(one, random);
        } else if (v > 0) {
          notch_seams(one, random);
        }
        for (const int kept : {0, 1, 2}) {
          rows +=
              write(one, static_cast<int>(i), kept, v > 0 && !is_miscut ? &random : nullptr, out);
        }
      }
    } catch (const Error& error) {
      std::fprintf(stderr, "%s\n", error.what());
    }
  }
  std::fclose(out);
  std::printf("%zu pairs of %d features\n", rows, pair_features);
  return 0;
}
