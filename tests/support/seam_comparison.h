// Compares the seams that were found for a pattern with the seams that it has.
#pragma once

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "pattern/mesh/seam_orientation.h"
#include "pattern/seams/find_seams.h"
#include "pattern/seams/panel_symmetry.h"
#include "pattern/seams/panel_words.h"
#include "pattern/seams/walked_edges.h"

namespace toile {

/// A seam as a pair of edge numbers (panel, edge), the lower first, and its direction.
struct SeamPair {
  std::array<int, 2> a{};
  std::array<int, 2> b{};
  bool reversed = true;
  auto operator<=>(const SeamPair&) const = default;
};

inline SeamPair seam_pair(const EdgeRef& a, const EdgeRef& b, bool reversed) {
  SeamPair pair{{a.panel, a.edge}, {b.panel, b.edge}, reversed};
  if (pair.b < pair.a) std::swap(pair.a, pair.b);
  return pair;
}

/// The seams that a pattern states, in the directions in which mesh-pattern would sew them.
inline std::set<SeamPair> stated_seams(const Pattern& pattern) {
  std::vector<Remark> remarks;
  const Orientation orientation = orient(pattern, remarks);
  std::set<SeamPair> seams;
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    const Stitch& stitch = pattern.stitches[s];
    seams.insert(seam_pair(stitch.a, stitch.b, orientation.reversed[s]));
  }
  return seams;
}

/// The pattern without its seams, and without all that says where a panel stands. Without names,
/// its panels are called by numbers that their order in the file does not tell.
inline Pattern stripped(Pattern pattern, bool names, bool labels) {
  pattern.stitches.clear();
  std::vector<std::size_t> shuffled(pattern.panels.size());
  std::iota(shuffled.begin(), shuffled.end(), std::size_t{1});
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(1));
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    PatternPanel& panel = pattern.panels[p];
    panel.rotation = Eigen::Matrix3d::Identity();
    panel.translation = Vec3::Zero();
    panel.placement = {};
    panel.part = BodyPart::none;
    panel.attachments.clear();
    if (!names) panel.name = "piece" + std::to_string(shuffled[p]);
    if (!labels) {
      panel.label.clear();
      for (PatternEdge& edge : panel.edges) edge.label.clear();
    }
  }
  return pattern;
}

/// The panels that the seams of a pattern show from their other side, see walked_edges(). Of each
/// part of the garment, the fewer ones.
inline std::vector<char> turned_over(const Pattern& pattern, bool drawn_walk) {
  std::map<std::array<int, 2>, bool> forward;
  for (const WalkedEdge& edge : walked_edges(pattern, drawn_walk)) {
    forward[{edge.ref.panel, edge.ref.edge}] = edge.forward;
  }
  const std::set<SeamPair> seams = stated_seams(pattern);
  const int panels = static_cast<int>(pattern.panels.size());
  std::vector<int> side(panels, -1);
  for (int first = 0; first < panels; ++first) {
    if (side[first] >= 0) continue;
    std::vector<int> part = {first};
    side[first] = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
      for (const SeamPair& seam : seams) {
        if (seam.a[0] != part[i] && seam.b[0] != part[i]) continue;
        const int other = seam.a[0] == part[i] ? seam.b[0] : seam.a[0];
        if (side[other] >= 0) continue;
        const bool along = seam.reversed != (forward.at(seam.a) == forward.at(seam.b));
        side[other] = along ? 1 - side[part[i]] : side[part[i]];
        part.push_back(other);
      }
    }
    const auto turned =
        std::count_if(part.begin(), part.end(), [&](int p) { return side[p] == 1; });
    if (turned * 2 <= static_cast<std::ptrdiff_t>(part.size())) continue;
    for (const int p : part) side[p] = 1 - side[p];
  }
  return {side.begin(), side.end()};
}

struct SeamMatches {
  int stated = 0;
  int found = 0;
  int right = 0;  ///< found, stated, and in the same direction
  bool whole() const { return stated == found && found == right; }
};

/// Counts a seam as right where it is a stated one after panels have changed places with panels
/// that they coincide with. `all`: with any such panel. Otherwise with panels whose names differ in
/// the number alone, as godets in a row: the cloth stays the same. And with itself, turned over:
/// then the two sides of a band may change places.
class SeamComparison {
 public:
  SeamComparison(const Pattern& pattern, bool drawn_walk, bool all)
      : edges_(walked_edges(pattern, drawn_walk)) {
    const std::vector<PanelFit> fits = panel_fits(edges_);
    std::set<int> own_mirrors;
    for (const PanelFit& fit : fits) {
      if (fit.from == fit.to && fit.mirrored) own_mirrors.insert(fit.from);
    }
    for (const PanelFit& fit : fits) {
      const PanelWords from = words_of(pattern.panels[fit.from]);
      const PanelWords to = words_of(pattern.panels[fit.to]);
      const bool numbered = from.number >= 0 && to.number >= 0 && from.stem == to.stem &&
                            from.face == to.face && from.side == to.side;
      const bool same_cloth = numbered && (!fit.mirrored || own_mirrors.contains(fit.from));
      if (all || fit.from == fit.to || same_cloth) fits_.push_back(fit);
    }
    panels_ = static_cast<int>(pattern.panels.size());
    first_.assign(panels_, -1);
    for (int e = 0; e < static_cast<int>(edges_.size()); ++e) {
      if (first_[edges_[e].ref.panel] < 0) first_[edges_[e].ref.panel] = e;
      number_[{edges_[e].ref.panel, edges_[e].ref.edge}] = e;
    }
  }

  SeamMatches compare(const std::set<SeamPair>& stated, const std::set<SeamPair>& found) {
    SeamMatches matched;
    matched.stated = static_cast<int>(stated.size());
    matched.found = static_cast<int>(found.size());
    stated_ = walks(stated);
    found_ = walks(found);
    best_.clear();
    int plain = 0;
    for (const Walk& walk : found_) plain += matches(walk, {}) ? 1 : 0;
    matched.right = lay();
    if (plain >= matched.right) {
      matched.right = plain;
      best_.clear();
    }
    return matched;
  }

  /// Whether a seam of the last compare() was right.
  bool right(const SeamPair& seam) const { return matches(*walks({seam}).begin(), best_); }

  /// The found seams that are not right, and the stated ones that were not found, after compare().
  std::vector<std::string> mistakes(const Pattern& pattern) const;

 private:
  /// A seam by the walks of both panels: whether the walk of one runs against the other's.
  struct Walk {
    int a = 0;
    int b = 0;
    bool against = true;
    auto operator<=>(const Walk&) const = default;
  };

  std::set<Walk> walks(const std::set<SeamPair>& seams) const {
    std::set<Walk> result;
    for (const SeamPair& seam : seams) {
      const int a = number_.at(seam.a);
      const int b = number_.at(seam.b);
      const bool same = edges_[a].forward == edges_[b].forward;
      result.insert({std::min(a, b), std::max(a, b), seam.reversed == same});
    }
    return result;
  }

  int panel(int e) const { return edges_[e].ref.panel; }

  Walk image(const Walk& walk, const std::map<int, const PanelFit*>& laid) const {
    int a = walk.a;
    int b = walk.b;
    bool against = walk.against;
    for (int* e : {&a, &b}) {
      const auto fit = laid.find(panel(*e));
      if (fit == laid.end()) continue;
      if (fit->second->mirrored) against = !against;
      *e = fit->second->image[*e - first_[panel(*e)]];
      if (*e < 0) return {-1, -1, false};
    }
    return {std::min(a, b), std::max(a, b), against};
  }

  bool matches(const Walk& walk, const std::map<int, const PanelFit*>& laid) const {
    return stated_.contains(image(walk, laid));
  }

  /// Lays panels one after the other along the found seams, from each way to lay a first one.
  int lay() {
    std::map<int, const PanelFit*> laid;
    std::set<int> taken;
    int right = 0;
    std::vector<std::vector<Walk>> at_panel(panels_);
    for (const Walk& walk : found_) {
      at_panel[panel(walk.a)].push_back(walk);
      if (panel(walk.b) != panel(walk.a)) at_panel[panel(walk.b)].push_back(walk);
    }
    for (int seed = 0; seed < panels_; ++seed) {
      if (laid.contains(seed)) continue;
      auto best = laid;
      auto best_taken = taken;
      int best_count = -1;
      for (const PanelFit& fit : fits_) {
        if (fit.from != seed || taken.contains(fit.to)) continue;
        auto trial = laid;
        auto trial_taken = taken;
        trial[seed] = &fit;
        trial_taken.insert(fit.to);
        std::vector<int> queue = {seed};
        for (std::size_t i = 0; i < queue.size(); ++i) {
          for (const Walk& walk : at_panel[queue[i]]) {
            const int other = panel(walk.a) == queue[i] ? panel(walk.b) : panel(walk.a);
            if (trial.contains(other)) continue;
            for (const PanelFit& next : fits_) {
              if (next.from != other || trial_taken.contains(next.to)) continue;
              trial[other] = &next;
              if (matches(walk, trial)) break;
              trial.erase(other);
            }
            if (!trial.contains(other)) continue;
            trial_taken.insert(trial[other]->to);
            queue.push_back(other);
          }
        }
        int count = 0;
        for (const Walk& walk : found_) {
          const bool whole = trial.contains(panel(walk.a)) && trial.contains(panel(walk.b));
          if (whole && matches(walk, trial)) ++count;
        }
        if (count > best_count) {
          best_count = count;
          best = trial;
          best_taken = trial_taken;
        }
      }
      laid = best;
      taken = best_taken;
      right = std::max(right, best_count);
    }
    best_ = laid;
    return right;
  }

  std::vector<WalkedEdge> edges_;
  std::vector<PanelFit> fits_;
  int panels_ = 0;
  std::vector<int> first_;
  std::map<std::array<int, 2>, int> number_;
  std::set<Walk> stated_;
  std::set<Walk> found_;
  std::map<int, const PanelFit*> best_;
};

inline std::vector<std::string> SeamComparison::mistakes(const Pattern& pattern) const {
  std::vector<std::string> lines;
  const auto name = [&](int e) {
    return pattern.panels[panel(e)].name + ":" + std::to_string(edges_[e].ref.edge);
  };
  const auto line = [&](const char* what, const Walk& walk) {
    char lengths[64];
    std::snprintf(lengths, sizeof lengths, " %.2f %.2f cm", edges_[walk.a].length * 100,
                  edges_[walk.b].length * 100);
    lines.push_back(what + name(walk.a) + " " + name(walk.b) + (walk.against ? "" : " (along)") +
                    lengths);
  };
  std::set<Walk> images;
  for (const Walk& walk : found_) {
    const Walk laid = image(walk, best_);
    images.insert(laid);
    if (laid.a < 0) {
      line("wrong? ", walk);
    } else if (!stated_.contains(laid)) {
      line("wrong  ", laid);
    }
  }
  for (const Walk& walk : stated_) {
    if (!images.contains(walk)) line("missed ", walk);
  }
  return lines;
}

}  // namespace toile
