#include "pattern/seams/panel_exchange.h"

#include <algorithm>
#include <array>

namespace toile {

namespace {

/// Metres that a seam between left and right counts as.
constexpr double wrong_side = 10;

/// Metres that a seam between a front and a back of other names counts as.
constexpr double wrong_face = 3;

/// Metres that a seam counts as that turns a panel over.
constexpr double turned_over = 0.05;

/// Metres by which an exchange has to bring seams nearer.
constexpr double least_gain = 0.01;

class Exchange {
 public:
  Exchange(const Pattern& pattern, const std::vector<WalkedEdge>& edges,
           const std::vector<PanelFit>& fits, const std::vector<PanelWords>& words, bool by_place)
      : pattern_(pattern), edges_(edges), fits_(fits), words_(words), by_place_(by_place) {
    first_.assign(pattern.panels.size(), -1);
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
      if (first_[edges[e].ref.panel] < 0) first_[edges[e].ref.panel] = e;
    }
  }

  void run(const std::vector<int>& mirror, std::vector<EdgeSeam>& seams) const {
    double cost = sum(seams);
    if (auto image = mirror_image(mirror, seams); !image.empty()) {
      const double image_cost = sum(image);
      if (image_cost < cost - least_gain) {
        seams = std::move(image);
        cost = image_cost;
      }
    }
    // Each exchange makes the sum smaller, so this ends; the bound is for safety.
    for (std::size_t round = 0; round < 4 * pattern_.panels.size(); ++round) {
      std::vector<EdgeSeam> best = seams;
      double least = cost - least_gain;
      for (const PanelFit& fit : fits_) {
        for (const PanelFit& back : fits_) {
          if (back.from != fit.to || back.to != fit.from) continue;
          if (fit.from > fit.to || (fit.from == fit.to && &fit != &back)) continue;
          std::vector<EdgeSeam> trial = seams;
          if (!exchange(fit, back, trial)) continue;
          const double trial_cost = sum(trial);
          if (trial_cost < least) {
            least = trial_cost;
            best = std::move(trial);
          }
        }
      }
      if (least >= cost - least_gain) return;
      seams = std::move(best);
      cost = least;
    }
  }

 private:
  int panel(int e) const { return edges_[e].ref.panel; }

  /// The whole garment mirrored; empty: a sewn edge has no mirror partner.
  static std::vector<EdgeSeam> mirror_image(const std::vector<int>& mirror,
                                            std::vector<EdgeSeam> seams) {
    for (EdgeSeam& seam : seams) {
      seam.a = mirror[seam.a];
      seam.b = mirror[seam.b];
      if (seam.a < 0 || seam.b < 0) return {};
    }
    return seams;
  }

  /// False: an edge has no counterpart.
  bool exchange(const PanelFit& fit, const PanelFit& back, std::vector<EdgeSeam>& seams) const {
    for (EdgeSeam& seam : seams) {
      for (int* e : {&seam.a, &seam.b}) {
        const PanelFit* used = panel(*e) == fit.from ? &fit : panel(*e) == fit.to ? &back : nullptr;
        if (used == nullptr) continue;
        const int image = used->image[*e - first_[used->from]];
        if (image < 0) return false;
        *e = image;
        seam.along = seam.along != used->mirrored;
      }
    }
    return true;
  }

  double sum(const std::vector<EdgeSeam>& seams) const {
    double total = 0;
    for (const EdgeSeam& seam : seams) {
      const PanelWords& a = words_[panel(seam.a)];
      const PanelWords& b = words_[panel(seam.b)];
      if (a.side * b.side < 0 && a.whole != b.whole) total += wrong_side;
      if (a.face * b.face < 0 && a.stem != b.stem) total += wrong_face;
      if (by_place_) total += distance(seam);
      if (!by_place_ && seam.along) total += turned_over;
    }
    return total;
  }

  double distance(const EdgeSeam& seam) const {
    const auto ends = [&](int e) {
      const WalkedEdge& edge = edges_[e];
      const PatternPanel& owner = pattern_.panels[edge.ref.panel];
      const EdgeCurve& curve = owner.edges[edge.ref.edge].curve;
      return std::array{owner.place(edge.forward ? curve.start() : curve.end()),
                        owner.place(edge.forward ? curve.end() : curve.start())};
    };
    const auto a = ends(seam.a);
    auto b = ends(seam.b);
    if (!seam.along) std::swap(b[0], b[1]);
    return (a[0] - b[0]).norm() + (a[1] - b[1]).norm();
  }

  const Pattern& pattern_;
  const std::vector<WalkedEdge>& edges_;
  const std::vector<PanelFit>& fits_;
  const std::vector<PanelWords>& words_;
  bool by_place_ = false;
  std::vector<int> first_;
};

}  // namespace

void exchange_panels(const Pattern& pattern, const std::vector<WalkedEdge>& edges,
                     const std::vector<PanelFit>& fits, const std::vector<PanelWords>& words,
                     const std::vector<int>& mirror, bool by_place, std::vector<EdgeSeam>& seams) {
  Exchange(pattern, edges, fits, words, by_place).run(mirror, seams);
}

}  // namespace toile
