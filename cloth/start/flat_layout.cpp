#include "cloth/start/flat_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "cloth/start/constants.h"
#include "geometry/border_loops.h"
#include "geometry/disjoint_sets.h"
#include "geometry/polygon.h"

namespace toile {

namespace {

using Complex = std::complex<double>;

/// A seam between two panels, sampled.
struct FlatSeam {
  int a = 0;  ///< numbers of the panels in the layout
  int b = 0;
  double length = 0;  ///< metres, of the shorter side
  std::vector<Vec2> side_a;
  std::vector<Vec2> side_b;
};

std::vector<Vec2> sampled(const PanelMesh& garment, const std::vector<int>& side, double ratio) {
  std::vector<Vec2> points;
  const double last = static_cast<double>(side.size() - 1);
  for (int i = 0; i < flat_seam_samples; ++i) {
    const double at = last * i / (flat_seam_samples - 1);
    const auto low = static_cast<std::size_t>(std::min(std::floor(at), last - 1));
    const double t = at - static_cast<double>(low);
    points.emplace_back((1 - t) * garment.flat[side[low]] + t * garment.flat[side[low + 1]]);
  }
  const Vec2 middle = points[points.size() / 2];
  for (Vec2& p : points) p = middle + ratio * (p - middle);
  return points;
}

/// The border of a panel, and points spread over it. Flat coordinates.
struct Shape {
  std::vector<Vec2> outline;
  std::vector<Vec2> samples;
  double area = 0;

  Shape(const PanelMesh& garment, const MeshedPanel& panel) {
    std::vector<Triangle> triangles(
        garment.triangles.begin() + panel.first_triangle,
        garment.triangles.begin() + panel.first_triangle + panel.triangles);
    std::size_t longest = 0;
    const auto loops = border_loops(triangles, garment.flat.size());
    for (std::size_t l = 1; l < loops.size(); ++l) {
      if (loops[l].size() > loops[longest].size()) longest = l;
    }
    if (!loops.empty()) {
      for (const int p : loops[longest]) outline.push_back(garment.flat[p]);
    }
    area = std::abs(signed_area(outline));
    const int step = std::max(1, panel.triangles / flat_overlap_samples);
    for (int t = step / 2; t < panel.triangles; t += step) {
      const auto& [a, b, c] = triangles[t];
      samples.emplace_back((garment.flat[a] + garment.flat[b] + garment.flat[c]) / 3);
    }
  }
};

class LayoutSearch {
 public:
  LayoutSearch(const PanelMesh& garment, const std::vector<int>& panels,
               const std::vector<std::optional<bool>>& is_back)
      : is_back_(is_back) {
    best_.panels = panels;
    std::map<int, int> number;
    for (std::size_t i = 0; i < panels.size(); ++i) {
      number[panels[i]] = static_cast<int>(i);
      shapes_.emplace_back(garment, garment.panels[panels[i]]);
    }
    const std::vector<int> panel_of = panel_of_points(garment);
    seams_at_.resize(panels.size());
    for (const MeshedSeam& seam : garment.seams) {
      const auto a = number.find(panel_of[seam.a[seam.a.size() / 2]]);
      const auto b = number.find(panel_of[seam.b[seam.b.size() / 2]]);
      if (a == number.end() || b == number.end() || a->second == b->second) continue;
      FlatSeam flat{a->second, b->second, std::min(seam.length_a, seam.length_b), {}, {}};
      const double ratio = seam.length_a / seam.length_b;
      flat.side_a = sampled(garment, seam.a, ratio > min_gather ? 1 / ratio : 1);
      flat.side_b = sampled(garment, seam.b, ratio < 1 / min_gather ? ratio : 1);
      for (const int end : {flat.a, flat.b}) {
        seams_at_[end].push_back(static_cast<int>(seams_.size()));
      }
      seams_.push_back(std::move(flat));
    }
    order_panels();
  }

  FlatLayout run() {
    choose_faces();
    align(best_, true, layout_final_sweeps);
    best_.misfit = misfit(best_);
    straighten(best_);
    count_layers(best_);
    return std::move(best_);
  }

 private:
  std::size_t count() const { return shapes_.size(); }

  /// The order in which panels are laid: the largest first, then what is sewn the most to them.
  void order_panels() {
    std::vector<double> sewn(count(), 0);
    std::vector<char> done(count(), 0);
    for (std::size_t k = 0; k < count(); ++k) {
      std::size_t next = count();
      for (std::size_t i = 0; i < count(); ++i) {
        if (done[i]) continue;
        const auto rank = [&](std::size_t p) {
          return k == 0 ? shapes_[p].area : sewn[p] + 1e-9 * shapes_[p].area;
        };
        if (next == count() || rank(i) > rank(next)) next = i;
      }
      done[next] = 1;
      order_.push_back(next);
      for (const int s : seams_at_[next]) {
        const FlatSeam& seam = seams_[s];
        const int other = seam.a == static_cast<int>(next) ? seam.b : seam.a;
        sewn[other] += seam.length;
      }
    }
  }

  /// Lays panel p best against those of its partners that `counts` says.
  void fit(FlatLayout& layout, std::size_t p, const std::vector<char>& counts) const {
    Complex from = 0;
    Complex to = 0;
    double weight = 0;
    double inner = 0;
    Complex product = 0;
    const int panel = static_cast<int>(p);
    for (const int s : seams_at_[p]) {
      const FlatSeam& seam = seams_[s];
      const int other = seam.a == panel ? seam.b : seam.a;
      if (!counts[other]) continue;
      const auto& mine = seam.a == panel ? seam.side_a : seam.side_b;
      const auto& theirs = seam.a == panel ? seam.side_b : seam.side_a;
      for (std::size_t i = 0; i < mine.size(); ++i) {
        const Complex m = layout.shown(p, mine[i]);
        const Complex t = layout.place(other, theirs[i]);
        from += seam.length * m;
        to += seam.length * t;
        product += seam.length * std::conj(m) * t;
        inner += seam.length * std::norm(m);
        weight += seam.length;
      }
    }
    if (weight == 0) return;
    const Complex turn = product - std::conj(from) * to / weight;
    if (std::abs(turn) > 1e-12 * inner) layout.turn[p] = turn / std::abs(turn);
    layout.at[p] = (to - layout.turn[p] * from) / weight;
  }

  void align(FlatLayout& layout, bool anew, int sweeps) const {
    if (anew) {
      layout.turn.assign(count(), 1);
      layout.at.assign(count(), 0);
      std::vector<char> counts(count(), 0);
      for (const std::size_t p : order_) {
        fit(layout, p, counts);
        counts[p] = 1;
      }
    }
    const std::vector<char> all(count(), 1);
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      for (const std::size_t p : order_) fit(layout, p, all);
    }
  }

  /// m³: the squared gap of a seam times its length, and what it counts as around the side.
  static double seam_misfit(const FlatLayout& layout, const FlatSeam& seam) {
    double gaps = 0;
    for (std::size_t i = 0; i < seam.side_a.size(); ++i) {
      gaps +=
          std::norm(layout.place(seam.a, seam.side_a[i]) - layout.place(seam.b, seam.side_b[i]));
    }
    const bool is_around = layout.back[seam.a] != layout.back[seam.b];
    return seam.length * gaps / flat_seam_samples +
           (is_around ? side_seam_gap * side_seam_gap * seam.length : 0);
  }

  double misfit(const FlatLayout& layout) const {
    double sum = 0;
    for (const FlatSeam& seam : seams_) sum += seam_misfit(layout, seam);
    return sum;
  }

  /// A round skirt of many panels lies well in one face, as a plate, and is worn in two.
  double imbalance(const FlatLayout& layout) const {
    double all = 0;
    double difference = 0;
    for (std::size_t i = 0; i < count(); ++i) {
      all += shapes_[i].area;
      difference += layout.back[i] ? -shapes_[i].area : shapes_[i].area;
    }
    return face_balance_weight * difference * difference / all;
  }

  double overlap(const FlatLayout& layout) const {
    double sum = 0;
    for (std::size_t i = 0; i < count(); ++i) {
      for (std::size_t j = 0; j < count(); ++j) {
        if (i == j || layout.back[i] != layout.back[j] || shapes_[i].area > shapes_[j].area)
          continue;
        sum += shapes_[i].area * upon(layout, i, j);
      }
    }
    return sum;
  }

  double upon(const FlatLayout& layout, std::size_t i, std::size_t j) const {
    int hits = 0;
    for (const Vec2& sample : shapes_[i].samples) {
      const Complex p = layout.place(i, sample);
      const Complex q = (p - layout.at[j]) / layout.turn[j];
      hits += inside(shapes_[j].outline, {layout.back[j] ? -q.real() : q.real(), q.imag()});
    }
    return hits / std::max(1.0, static_cast<double>(shapes_[i].samples.size()));
  }

  /// Larger panels lie below smaller ones.
  void count_layers(FlatLayout& layout) const {
    layout.layer.assign(count(), 0);
    std::vector<std::size_t> by_area(count());
    std::iota(by_area.begin(), by_area.end(), std::size_t{0});
    std::ranges::stable_sort(
        by_area, [&](std::size_t i, std::size_t j) { return shapes_[i].area > shapes_[j].area; });
    for (std::size_t k = 0; k < count(); ++k) {
      const std::size_t i = by_area[k];
      for (std::size_t below = 0; below < k; ++below) {
        const std::size_t j = by_area[below];
        if (layout.back[i] != layout.back[j] || upon(layout, i, j) < min_share_upon) continue;
        layout.layer[i] = std::max(layout.layer[i], layout.layer[j] + 1);
      }
    }
  }

  /// Lays the panels in these faces, and keeps the layout if it is the best so far.
  bool try_faces(const std::vector<char>& back) {
    FlatLayout layout;
    layout.panels = best_.panels;
    layout.back = back;
    align(layout, true, layout_trial_sweeps);
    layout.misfit = misfit(layout);
    const double bound =
        best_.back.empty() ? std::numeric_limits<double>::infinity() : best_.misfit;
    layout.misfit += imbalance(layout);
    if (layout.misfit >= bound) return false;
    layout.misfit += overlap_weight * overlap(layout);
    if (layout.misfit >= bound - 1e-12) return false;
    best_ = std::move(layout);
    return true;
  }

  void choose_faces() {
    std::vector<std::size_t> free;
    std::vector<char> back(count(), 0);
    bool any_known = false;
    for (const std::size_t p : order_) {
      if (is_back_[p]) {
        back[p] = *is_back_[p];
        any_known = true;
      } else {
        free.push_back(p);
      }
    }
    if (free.empty()) {
      best_.back = back;
      return;
    }
    // Which face is which does not matter when no panel is known.
    const std::size_t first = any_known ? 0 : 1;
    const std::size_t open = free.size() - first;
    if (open <= max_tried_faces) {
      for (std::size_t choice = 0; choice < (std::size_t{1} << open); ++choice) {
        for (std::size_t k = 0; k < open; ++k) back[free[first + k]] = choice >> k & 1;
        try_faces(back);
      }
      return;
    }
    lay_greedily(back);
    improve(free);
  }

  /// Gives each free panel, in the order of laying, the face in which it fits better.
  void lay_greedily(std::vector<char> back) {
    FlatLayout layout;
    layout.panels = best_.panels;
    layout.back = back;
    layout.turn.assign(count(), 1);
    layout.at.assign(count(), 0);
    std::vector<char> counts(count(), 0);
    for (const std::size_t p : order_) {
      fit(layout, p, counts);
      if (!is_back_[p] && p != order_.front()) {
        FlatLayout other = layout;
        other.back[p] = !other.back[p];
        fit(other, p, counts);
        if (cost_at(other, p, counts) < cost_at(layout, p, counts)) layout = other;
      }
      counts[p] = 1;
    }
    try_faces(layout.back);
  }

  double cost_at(const FlatLayout& layout, std::size_t p, const std::vector<char>& counts) const {
    double sum = 0;
    for (const int s : seams_at_[p]) {
      const FlatSeam& seam = seams_[s];
      if (!counts[seam.a] && !counts[seam.b]) continue;
      const std::size_t other = seam.a == static_cast<int>(p) ? seam.b : seam.a;
      if (counts[other]) sum += seam_misfit(layout, seam);
    }
    for (std::size_t j = 0; j < count(); ++j) {
      if (j == p || !counts[j] || layout.back[j] != layout.back[p]) continue;
      sum += overlap_weight * shapes_[p].area * upon(layout, p, j);
    }
    return sum;
  }

  /// Two cuts between free panels take an arc out of a ring, as half of a skirt's gores.
  void add_arcs(const std::vector<char>& is_free,
                std::vector<std::vector<std::size_t>>& flips) const {
    std::set<std::pair<int, int>> pairs;
    for (const FlatSeam& seam : seams_) {
      if (is_free[seam.a] && is_free[seam.b]) pairs.insert(std::minmax(seam.a, seam.b));
    }
    if (pairs.size() > max_arc_seams) return;
    for (auto first = pairs.begin(); first != pairs.end(); ++first) {
      for (auto second = std::next(first); second != pairs.end(); ++second) {
        DisjointSets arcs(count());
        for (auto pair = pairs.begin(); pair != pairs.end(); ++pair) {
          if (pair != first && pair != second) arcs.join(pair->first, pair->second);
        }
        if (arcs.of(first->first) == arcs.of(first->second)) continue;
        if (arcs.of(second->first) == arcs.of(second->second)) continue;
        std::vector<std::size_t> arc;
        for (std::size_t p = 0; p < count(); ++p) {
          if (is_free[p] && arcs.of(static_cast<int>(p)) == arcs.of(first->first)) arc.push_back(p);
        }
        if (arc.size() > 1) flips.push_back(std::move(arc));
      }
    }
  }

  void improve(const std::vector<std::size_t>& free) {
    std::vector<std::vector<std::size_t>> flips;
    std::vector<char> is_free(count(), 0);
    for (const std::size_t p : free) is_free[p] = 1;
    for (const std::size_t p : free) flips.push_back({p});
    for (const FlatSeam& seam : seams_) {
      if (is_free[seam.a] && is_free[seam.b]) {
        flips.push_back({static_cast<std::size_t>(seam.a), static_cast<std::size_t>(seam.b)});
      }
    }
    // What a panel cuts off from the largest one is a branch, such as a cuff and its frill.
    for (const std::size_t cut : free) {
      std::vector<char> reached(count(), 0);
      std::vector<std::size_t> open = {order_.front() == cut ? order_.back() : order_.front()};
      reached[open.front()] = 1;
      while (!open.empty()) {
        const std::size_t p = open.back();
        open.pop_back();
        for (const int s : seams_at_[p]) {
          for (const int end : {seams_[s].a, seams_[s].b}) {
            if (reached[end] || static_cast<std::size_t>(end) == cut) continue;
            reached[end] = 1;
            open.push_back(static_cast<std::size_t>(end));
          }
        }
      }
      std::vector<std::size_t> branch;
      for (const std::size_t p : free) {
        if (!reached[p]) branch.push_back(p);
      }
      if (branch.size() > 1) flips.push_back(branch);
    }
    add_arcs(is_free, flips);
    for (int round = 0; round < max_face_rounds; ++round) {
      bool better = false;
      for (const auto& flip : flips) {
        std::vector<char> back = best_.back;
        for (const std::size_t p : flip) back[p] = !back[p];
        better = try_faces(back) || better;
      }
      if (!better) return;
    }
  }

  /// Turns the picture so that what is drawn upright stands upright, on average.
  void straighten(FlatLayout& layout) const {
    Complex sum = 0;
    for (std::size_t i = 0; i < count(); ++i) sum += shapes_[i].area * layout.turn[i];
    if (std::abs(sum) < 1e-9) return;
    layout.move(std::conj(sum) / std::abs(sum), 0);
  }

  const std::vector<std::optional<bool>>& is_back_;
  std::vector<Shape> shapes_;
  std::vector<FlatSeam> seams_;
  std::vector<std::vector<int>> seams_at_;  // per panel
  std::vector<std::size_t> order_;
  FlatLayout best_;
};

}  // namespace

void FlatLayout::move(Complex by_turn, Complex by) {
  for (std::size_t i = 0; i < panels.size(); ++i) {
    turn[i] *= by_turn;
    at[i] = by_turn * at[i] + by;
  }
}

void FlatLayout::change_faces() {
  // -conj(turn * z + at) = conj(turn) * -conj(z) - conj(at).
  for (std::size_t i = 0; i < panels.size(); ++i) {
    back[i] = !back[i];
    turn[i] = std::conj(turn[i]);
    at[i] = -std::conj(at[i]);
  }
}

FlatLayout lay_flat(const PanelMesh& garment, const std::vector<int>& panels,
                    const std::vector<std::optional<bool>>& is_back) {
  return LayoutSearch(garment, panels, is_back).run();
}

}  // namespace toile
