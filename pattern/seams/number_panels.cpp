#include "pattern/seams/number_panels.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <tuple>

namespace toile {

namespace {

/// Cosine between an edge and the warp: an edge that rises more is a panel's right side.
constexpr double steep = 0.5;

class Numbering {
 public:
  Numbering(const Pattern& pattern, const std::vector<WalkedEdge>& edges,
            const std::vector<PanelFit>& fits, const std::vector<PanelWords>& words,
            std::vector<EdgeSeam>& seams)
      : pattern_(pattern), edges_(edges), fits_(fits), words_(words), seams_(seams) {
    first_.assign(pattern.panels.size(), -1);
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
      if (first_[panel(e)] < 0) first_[panel(e)] = e;
    }
  }

  void run() {
    std::map<std::tuple<std::string, int, int>, std::vector<int>> families;
    for (int p = 0; p < static_cast<int>(words_.size()); ++p) {
      const PanelWords& words = words_[p];
      if (words.number >= 0) families[{words.stem, words.face, words.side}].push_back(p);
    }
    for (auto& [stem, panels] : families) {
      std::stable_sort(panels.begin(), panels.end(),
                       [&](int a, int b) { return words_[a].number < words_[b].number; });
      for (const std::vector<int>& alike : shapes_of(panels)) {
        if (alike.size() > 1) number(alike);
      }
    }
  }

 private:
  /// Where a slot of the garment is, in the order of slots.
  using Key = std::tuple<int, int, int, double>;

  int panel(int e) const { return edges_[e].ref.panel; }

  const PanelFit* fit_of(int from, int to) const {
    for (const PanelFit& fit : fits_) {
      if (fit.from == from && fit.to == to && !fit.mirrored) return &fit;
    }
    return nullptr;
  }

  std::vector<std::vector<int>> shapes_of(const std::vector<int>& panels) const {
    std::vector<std::vector<int>> shapes;
    for (const int p : panels) {
      const auto same = std::find_if(shapes.begin(), shapes.end(), [&](const auto& shape) {
        return fit_of(shape.front(), p) != nullptr && fit_of(p, shape.front()) != nullptr;
      });
      if (same != shapes.end()) {
        same->push_back(p);
      } else {
        shapes.push_back({p});
      }
    }
    return shapes;
  }

  /// The place of the panel by what it is sewn to, beyond its family.
  Key key_of(int member, const std::vector<int>& family) const {
    Key least = {2, 2, 0, std::numeric_limits<double>::max()};
    for (const EdgeSeam& seam : seams_) {
      for (const auto& [own, other] : {std::pair{seam.a, seam.b}, std::pair{seam.b, seam.a}}) {
        if (panel(own) != member) continue;
        if (std::find(family.begin(), family.end(), panel(other)) != family.end()) continue;
        const PanelWords& words = words_[panel(other)];
        const EdgeCurve& curve = pattern_.panels[panel(other)].edges[edges_[other].ref.edge].curve;
        const Key key = {-words.face, words.side, panel(other),
                         (curve.start().x() + curve.end().x()) / 2};
        least = std::min(least, key);
      }
    }
    return least;
  }

  /// The panel of the family that is sewn to the right side of this one; -1: there is none.
  int right_of(int member, const std::vector<int>& family) const {
    for (const EdgeSeam& seam : seams_) {
      for (const auto& [own, other] : {std::pair{seam.a, seam.b}, std::pair{seam.b, seam.a}}) {
        if (panel(own) != member || edges_[own].rise < steep || panel(other) == member) continue;
        if (std::find(family.begin(), family.end(), panel(other)) != family.end()) {
          return panel(other);
        }
      }
    }
    return -1;
  }

  /// The slots in the order in which they should be numbered, each by the panel in it.
  std::vector<int> slots(const std::vector<int>& family) const {
    std::map<int, Key> keys;
    std::map<int, int> right;
    std::map<int, int> left;
    for (const int p : family) {
      keys[p] = key_of(p, family);
      const int next = right_of(p, family);
      if (next < 0 || left.contains(next)) continue;
      right[p] = next;
      left[next] = p;
    }
    std::vector<int> order = family;
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return keys[a] < keys[b]; });
    std::vector<int> slots;
    const auto taken = [&](int p) {
      return std::find(slots.begin(), slots.end(), p) != slots.end();
    };
    // Rows begin at their left end, rings at their first slot.
    for (const bool rows : {true, false}) {
      for (const int p : order) {
        if (taken(p) || (rows && left.contains(p))) continue;
        for (int next = p; !taken(next);) {
          slots.push_back(next);
          const auto beside = right.find(next);
          if (beside == right.end()) break;
          next = beside->second;
        }
      }
    }
    return slots;
  }

  void number(const std::vector<int>& family) {
    const std::vector<int> order = slots(family);
    std::map<int, int> now;  // per panel whose slot it was: the panel that takes it
    for (std::size_t i = 0; i < order.size(); ++i) now[order[i]] = family[i];
    std::vector<EdgeSeam> trial = seams_;
    for (EdgeSeam& seam : trial) {
      for (int* e : {&seam.a, &seam.b}) {
        const auto moved = now.find(panel(*e));
        if (moved == now.end() || moved->first == moved->second) continue;
        const PanelFit* fit = fit_of(moved->first, moved->second);
        // Of a hem that is split elsewhere, no part has a counterpart.
        *e = fit == nullptr ? -1 : fit->image[*e - first_[moved->first]];
        if (*e < 0) return;
      }
    }
    seams_ = std::move(trial);
  }

  const Pattern& pattern_;
  const std::vector<WalkedEdge>& edges_;
  const std::vector<PanelFit>& fits_;
  const std::vector<PanelWords>& words_;
  std::vector<EdgeSeam>& seams_;
  std::vector<int> first_;
};

}  // namespace

void number_panels(const Pattern& pattern, const std::vector<WalkedEdge>& edges,
                   const std::vector<PanelFit>& fits, const std::vector<PanelWords>& words,
                   std::vector<EdgeSeam>& seams) {
  Numbering(pattern, edges, fits, words, seams).run();
}

}  // namespace toile
