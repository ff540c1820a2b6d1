#include "pattern/seams/seam_search.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/disjoint_sets.h"
#include "pattern/seams/splitmix.h"

namespace toile {

namespace {

/// Partners of an edge that the search tries by themselves.
constexpr std::size_t most_partners = 16;

/// Partners of an edge that climbed() tries: all in most garments. It keeps the time of patterns of
/// hundreds of edges.
constexpr std::size_t climbing_partners = 64;

/// Score by which a partner is e times as likely to be tried.
constexpr double trial_scale = 0.7;

/// Scores at which a search begins and ends to take what is worse.
constexpr double hot = 6;
constexpr double warm = 1;
constexpr double cold = 0.2;

/// Garments that a search looks at, for each edge of the pattern.
constexpr int looks_of_search = 300;

/// Garments between two looks at the clock. Half and double were not measured.
constexpr int looks_between_clocks = 1000;

/// Scores that differ by less are the same.
constexpr double same_score = 1e-6;

constexpr double impossible = -1e9;

/// Seams that climbed() sews on from a new one at once, at each end.
constexpr int most_steps_on = 3;

/// Blocks of seams that two garments differ in: all choices are tried of so many, single ones and
/// pairs of more.
constexpr std::size_t few_blocks = 8;

}  // namespace

SeamSearch::SeamSearch(const SeamEvidence& evidence, const SeamPairs& pairs,
                       const SeamMeasures& weights, const KnownSeams& known,
                       const std::vector<double>& extra, IsOver is_over)
    : pairs_(pairs),
      weights_(weights),
      is_over_(std::move(is_over)),
      surface_(evidence),
      edges_(static_cast<int>(evidence.edges.size())),
      mirror_(evidence.mirror),
      locked_(evidence.edges.size(), 0) {
  for (const WalkedEdge& edge : evidence.edges) {
    next_.push_back(edge.next);
    previous_.push_back(edge.previous);
  }
  const std::size_t all = evidence.edges.size() * evidence.edges.size();
  scores_.assign(all, impossible);
  kind_.assign(all, -1);
  std::map<std::array<int, 3>, int> kinds;
  const EdgeShapes& shapes = evidence.shapes;
  for (int a = 0; a < edges_; ++a) {
    for (int b = a + 1; b < edges_; ++b) {
      const std::array<int, 3> key = {std::min(shapes.shape[a], shapes.shape[b]),
                                      std::max(shapes.shape[a], shapes.shape[b]),
                                      shapes.hand[a] * shapes.hand[b]};
      const int kind = kinds.emplace(key, static_cast<int>(kinds.size())).first->second;
      kind_[static_cast<std::size_t>(a) * edges_ + b] = kind;
      kind_[static_cast<std::size_t>(b) * edges_ + a] = kind;
      if (!pairs.possible(a, b)) continue;
      // A little more for what comes first, so that equal garments have one best.
      double score = toile::score_of(pairs.measures(a, b), weights) - 1e-9 * (a * edges_ + b);
      if (!extra.empty()) score += extra[static_cast<std::size_t>(a) * edges_ + b];
      pair_score(a, b) = pair_score(b, a) = score;
    }
  }
  shortlist_.resize(edges_);
  for (int a = 0; a < edges_; ++a) {
    std::vector<int> order;
    for (int b = 0; b < edges_; ++b) {
      if (b != a && pair_score(a, b) > impossible / 2) order.push_back(b);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](int x, int y) { return pair_score(a, x) > pair_score(a, y); });
    climbing_.push_back({order.begin(), order.begin() + std::min(order.size(), climbing_partners)});
    if (order.size() > most_partners) order.resize(most_partners);
    double sum = 0;
    for (const int b : order) {
      sum += std::exp((pair_score(a, b) - pair_score(a, order.front())) / trial_scale);
      shortlist_[a].push_back({b, sum});
    }
    for (Partner& partner : shortlist_[a]) partner.chance /= sum;
  }
  begin_.assign(edges_, -1);
  for (const auto& [a, b] : known.chosen) {
    if (pair_score(a, b) < impossible / 2) pair_score(a, b) = pair_score(b, a) = 0;
    begin_[a] = b;
    begin_[b] = a;
    locked_[a] = locked_[b] = 1;
  }
  for (const int e : known.taken) locked_[e] = 1;
}

std::uint32_t SeamSearch::random(std::uint32_t below) {
  seed_ += golden_step;
  return static_cast<std::uint32_t>(((mixed(seed_) >> 32) * below) >> 32);
}

double SeamSearch::random_part() { return random(1U << 24) / static_cast<double>(1U << 24); }

bool SeamSearch::allowed(int a, int b) const {
  return a != b && locked_[a] == 0 && locked_[b] == 0 && pair_score(a, b) > impossible / 2;
}

void SeamSearch::join(int a, int b) {
  part(a);
  part(b);
  now_[a] = b;
  now_[b] = a;
}

void SeamSearch::part(int a) {
  const int b = now_[a];
  if (b < 0) return;
  now_[a] = -1;
  now_[b] = -1;
}

bool SeamSearch::sew(int a, int b) {
  if (!allowed(a, b)) return false;
  unsew(a);
  unsew(b);
  join(a, b);
  const int c = mirror_[a];
  const int d = mirror_[b];
  if (c < 0 || d < 0 || c == a || c == b || d == a || d == b || !allowed(c, d)) return true;
  unsew(c);
  unsew(d);
  if (now_[a] < 0) return true;
  join(c, d);
  return true;
}

void SeamSearch::unsew(int a) {
  const int b = now_[a];
  if (b < 0 || locked_[a] != 0) return;
  part(a);
  const int c = mirror_[a];
  const int d = mirror_[b];
  if (c >= 0 && d >= 0 && now_[c] == d && locked_[c] == 0) part(c);
}

/// Sews the open edges that meet where the seam of a ends and that of b starts, and goes on to
/// them.
bool SeamSearch::sew_next(int& a, int& b) {
  int x = next_[a];
  while (now_[x] >= 0 && x != b) x = next_[now_[x]];
  if (x == b) return false;
  int y = previous_[b];
  while (now_[y] >= 0) y = previous_[now_[y]];
  if (x == y || !sew(x, y)) return false;
  a = x;
  b = y;
  return true;
}

void SeamSearch::sew_on(int a, int b, bool forward) {
  // From the end of a and the start of b, or the other way round.
  if (!forward) std::swap(a, b);
  while (now_[a] == b && random(3) != 0) {
    if (!sew_next(a, b)) return;
  }
}

void SeamSearch::move() {
  const std::uint32_t way = random(100);
  if (way < 40 && !border_.empty()) {
    const BorderStep step = border_[random(static_cast<std::uint32_t>(border_.size()))];
    // The walk goes against `from`: its end meets the start of `to`.
    if (sew(step.from, step.to)) sew_on(step.to, step.from, true);
    return;
  }
  const int a = static_cast<int>(random(static_cast<std::uint32_t>(edges_)));
  if (locked_[a] != 0) return;
  if (way < 55) {
    int e = a;
    do {
      unsew(e);
      e = next_[e];
    } while (random(3) == 0);
    return;
  }
  if (shortlist_[a].empty()) return;
  const double place = random_part();
  const auto& list = shortlist_[a];
  std::size_t i = 0;
  while (i + 1 < list.size() && list[i].chance < place) ++i;
  const int b = list[i].edge;
  if (now_[a] == b) {
    unsew(a);
    return;
  }
  const int old_a = now_[a];
  const int old_b = now_[b];
  if (!sew(a, b)) return;
  if (way < 70) {
    if (old_a >= 0 && old_b >= 0 && now_[old_a] < 0 && now_[old_b] < 0) sew(old_a, old_b);
    return;
  }
  sew_on(a, b, true);
  sew_on(a, b, false);
}

double SeamSearch::score_of_partners() {
  SeamMeasures sum{};
  surface_.measure(now_, sum);
  double score = toile::score_of(sum, weights_);
  for (int a = 0; a < edges_; ++a) {
    if (now_[a] > a) score += pair_score(a, now_[a]);
  }
  return score;
}

SeamMeasures SeamSearch::measures(const Partners& partners) {
  SeamMeasures sum{};
  surface_.measure(partners, sum);
  for (int a = 0; a < edges_; ++a) {
    if (partners[a] <= a) continue;
    const SeamMeasures one = pairs_.measures(a, partners[a]);
    for (int i = 0; i < seam_measures; ++i) sum[i] += one[i];
  }
  return sum;
}

void SeamSearch::anneal(Garment& best, double from, double to, int looks) {
  now_ = best.partners;
  double score = score_of_partners();
  best.score = score;
  border_ = surface_.border();
  Partners before = now_;
  for (int look = 0; look < looks; ++look) {
    if (look % looks_between_clocks == 0 && is_over()) return;
    const double heat = from * std::pow(to / from, static_cast<double>(look) / looks);
    move();
    if (now_ == before) continue;
    const double trial = score_of_partners();
    if (trial >= score || random_part() < std::exp((trial - score) / heat)) {
      score = trial;
      before = now_;
      border_ = surface_.border();
      if (score > best.score + same_score) {
        best.score = score;
        best.partners = now_;
      }
    } else {
      now_ = before;
    }
  }
}

SeamSearch::Garment SeamSearch::search(int run, int patience) {
  seed_ = static_cast<std::uint64_t>(run);
  Garment garment{begin_, 0};
  anneal(garment, hot, cold, patience * looks_of_search * edges_);
  return garment;
}

SeamSearch::Garment SeamSearch::near(const Partners& partners) {
  seed_ = 0;
  Garment garment{partners, 0};
  for (int a = 0; a < edges_; ++a) {
    const int b = garment.partners[a];
    if (b < a || locked_[a] != 0 || allowed(a, b)) continue;
    garment.partners[a] = garment.partners[b] = -1;
  }
  anneal(garment, warm, cold, looks_of_search * edges_ / 4);
  return garment;
}

SeamSearch::Garment SeamSearch::best_near(const Partners& partners, int run) {
  Garment best = search(run);
  Garment other = near(partners);
  return other.score > best.score ? other : best;
}

/// Sews a and b in the ways of climbed(), and asks after each whether to keep it.
void SeamSearch::try_seam(int a, int b, const std::function<bool()>& take) {
  const Partners before = now_;
  const int old_a = now_[a];
  const int old_b = now_[b];
  if (!sew(a, b) || take()) return;
  if (old_a >= 0 && old_b >= 0 && now_[old_a] < 0 && now_[old_b] < 0) {
    if (sew(old_a, old_b) && take()) return;
  }
  for (auto [from, to] : {std::pair(a, b), std::pair(b, a)}) {
    now_ = before;
    if (!sew(a, b)) continue;
    for (int steps = 0; steps < most_steps_on && now_[from] == to; ++steps) {
      if (!sew_next(from, to)) break;
      if (take()) return;
    }
  }
  now_ = before;
}

SeamSearch::Garment SeamSearch::climbed(const Garment& from) {
  Garment best = from;
  now_ = best.partners;
  const auto take = [&] {
    const double score = score_of_partners();
    if (score <= best.score + same_score) return false;
    best = {now_, score};
    return true;
  };
  // Once over all edges, whatever the time, so that a short search finds something.
  for (double before = best.score - 1; best.score > before + same_score;) {
    before = best.score;
    for (int a = 0; a < edges_; ++a) {
      if (locked_[a] != 0) continue;
      unsew(a);
      if (!take()) now_ = best.partners;
      for (const int b : climbing_[a]) {
        if (now_[a] != b && allowed(a, b)) try_seam(a, b, take);
        now_ = best.partners;
      }
    }
    if (is_over()) break;
  }
  return best;
}

/// Edges that change partners together, and their mirror images.
std::vector<std::vector<int>> SeamSearch::blocks(const Partners& a, const Partners& b) const {
  DisjointSets together(edges_);
  for (int e = 0; e < edges_; ++e) {
    if (a[e] == b[e]) continue;
    if (a[e] >= 0) together.join(e, a[e]);
    if (b[e] >= 0) together.join(e, b[e]);
    if (mirror_[e] >= 0 && a[mirror_[e]] != b[mirror_[e]]) together.join(e, mirror_[e]);
  }
  std::map<int, std::vector<int>> found;
  for (int e = 0; e < edges_; ++e) {
    if (a[e] != b[e]) found[together.of(e)].push_back(e);
  }
  std::vector<std::vector<int>> all;
  all.reserve(found.size());
  for (auto& [first, edges] : found) all.push_back(std::move(edges));
  return all;
}

SeamSearch::Garment SeamSearch::recombined(const Garment& best, const Garment& other) {
  Garment better = best;
  for (bool again = true; again;) {
    again = false;
    const std::vector<std::vector<int>> all = blocks(better.partners, other.partners);
    const Partners from = better.partners;
    const auto try_out = [&](const std::vector<std::size_t>& chosen) {
      now_ = from;
      for (const std::size_t block : chosen) {
        for (const int e : all[block]) now_[e] = other.partners[e];
      }
      const double score = score_of_partners();
      if (score <= better.score + same_score) return;
      better.score = score;
      better.partners = now_;
      again = true;
    };
    if (all.size() <= few_blocks) {
      for (std::size_t choice = 1; choice < std::size_t{1} << all.size(); ++choice) {
        std::vector<std::size_t> chosen;
        for (std::size_t i = 0; i < all.size(); ++i) {
          if ((choice >> i & 1) != 0) chosen.push_back(i);
        }
        try_out(chosen);
      }
      break;
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      try_out({i});
      for (std::size_t k = 0; k < i; ++k) try_out({k, i});
    }
  }
  return better;
}

void SeamSearch::forbid(int kind) {
  for (std::size_t pair = 0; pair < kind_.size(); ++pair) {
    if (kind_[pair] == kind) scores_[pair] = impossible;
  }
}

}  // namespace toile
