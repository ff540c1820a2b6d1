#include "pattern/seams/panel_symmetry.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace toile {

namespace {

constexpr double max_distance = 2e-3;                     // metres, of outlines that coincide
constexpr double max_angle = 3 * std::numbers::pi / 180;  // of corners that coincide
constexpr int samples = 48;                               // points of an outline that are compared

/// First edge and number of edges of each panel.
std::vector<std::array<int, 2>> panels_of(const std::vector<WalkedEdge>& edges) {
  std::vector<std::array<int, 2>> panels;
  for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
    if (edges[e].ref.panel == static_cast<int>(panels.size())) panels.push_back({e, 0});
    ++panels.back()[1];
  }
  return panels;
}

/// The outline of a panel by its length.
class Outline {
 public:
  Outline(const std::vector<WalkedEdge>& edges, int first, int count)
      : edges_(edges), first_(first) {
    for (int i = 0; i < count; ++i) {
      starts_.push_back(length_);
      length_ += edges[first + i].length;
    }
  }

  int count() const { return static_cast<int>(starts_.size()); }
  double length() const { return length_; }
  double start(int i) const { return starts_[i]; }

  /// The edge's place on the panel with the sharpest corner at its start.
  int sharpest() const {
    int best = 0;
    const auto bend = [&](int i) { return std::abs(edges_[first_ + i].corner - std::numbers::pi); };
    for (int i = 1; i < count(); ++i) {
      if (bend(i) > bend(best) + 1e-3) best = i;
    }
    return best;
  }
  double corner(int i) const { return edges_[first_ + i].corner; }

  /// The point at a length along the outline, which may be below zero or beyond its end.
  Vec2 at(double where) const {
    where = std::fmod(std::fmod(where, length_) + length_, length_);
    const auto next = std::upper_bound(starts_.begin(), starts_.end(), where);
    const auto i = static_cast<int>(next - starts_.begin()) - 1;
    const WalkedEdge& edge = edges_[first_ + i];
    const double step = static_cast<double>(edge.points.size() - 1);
    const double place = std::clamp((where - starts_[i]) / edge.length, 0.0, 1.0) * step;
    const auto k = std::min(static_cast<std::size_t>(place), edge.points.size() - 2);
    const double part = place - static_cast<double>(k);
    return (1 - part) * edge.points[k] + part * edge.points[k + 1];
  }

 private:
  const std::vector<WalkedEdge>& edges_;
  int first_ = 0;
  std::vector<double> starts_;
  double length_ = 0;
};

/// Whether the outlines coincide, from these places on. Distances to three points tell a shape, the
/// mirrored one included; walks in opposite directions tell which of the two it is.
bool coincide(const Outline& p, double from_p, const Outline& q, double from_q, bool mirrored) {
  std::vector<Vec2> a;
  std::vector<Vec2> b;
  for (int i = 0; i < samples; ++i) {
    const double along = p.length() * i / samples;
    a.push_back(p.at(from_p + along));
    b.push_back(q.at(mirrored ? from_q - along : from_q + along));
    for (const int anchor : {0, samples / 3, 2 * samples / 3}) {
      if (anchor > i) break;
      if (std::abs((a[i] - a[anchor]).norm() - (b[i] - b[anchor]).norm()) > max_distance)
        return false;
    }
  }
  return true;
}

}  // namespace

std::vector<PanelFit> panel_fits(const std::vector<WalkedEdge>& edges) {
  const auto panels = panels_of(edges);
  std::vector<Outline> outlines;
  outlines.reserve(panels.size());
  for (const auto& [first, count] : panels) outlines.emplace_back(edges, first, count);
  std::vector<PanelFit> fits;
  for (int p = 0; p < static_cast<int>(panels.size()); ++p) {
    const Outline& own = outlines[p];
    const int corner = own.sharpest();
    for (int q = 0; q < static_cast<int>(panels.size()); ++q) {
      const Outline& other = outlines[q];
      if (std::abs(own.length() - other.length()) > max_distance) continue;
      for (int start = 0; start < other.count(); ++start) {
        if (std::abs(own.corner(corner) - other.corner(start)) > max_angle) continue;
        for (const bool mirrored : {false, true}) {
          const bool itself = p == q && start == corner && !mirrored;
          if (!itself && !coincide(own, own.start(corner), other, other.start(start), mirrored)) {
            continue;
          }
          PanelFit fit{p, q, mirrored, {}};
          const double turn = other.start(start) + (mirrored ? 1 : -1) * own.start(corner);
          for (int i = 0; i < own.count(); ++i) {
            const double length = edges[panels[p][0] + i].length;
            const double from = mirrored ? turn - own.start(i) - length : turn + own.start(i);
            int image = -1;
            for (int k = 0; k < other.count(); ++k) {
              const double off = std::remainder(from - other.start(k), other.length());
              const double longer = length - edges[panels[q][0] + k].length;
              if (std::abs(off) < max_distance && std::abs(off + longer) < max_distance &&
                  std::abs(longer) < 0.2 * length) {
                image = panels[q][0] + k;
              }
            }
            fit.image.push_back(image);
          }
          fits.push_back(std::move(fit));
        }
      }
    }
  }
  return fits;
}

EdgeShapes edge_shapes(const std::vector<WalkedEdge>& edges, const std::vector<PanelFit>& fits) {
  const auto panels = panels_of(edges);
  EdgeShapes shapes;
  shapes.shape.resize(edges.size());
  std::iota(shapes.shape.begin(), shapes.shape.end(), 0);
  shapes.hand.assign(edges.size(), 1);
  std::vector<bool> reached(edges.size(), false);
  // Fits compose, so the lowest edge of a shape is one fit away.
  for (const PanelFit& fit : fits) {
    for (std::size_t i = 0; i < fit.image.size(); ++i) {
      const int e = panels[fit.from][0] + static_cast<int>(i);
      const int image = fit.image[i];
      if (image < 0) continue;
      const int hand = fit.mirrored ? -1 : 1;
      if (image < shapes.shape[e] || (image == shapes.shape[e] && !reached[e])) {
        shapes.shape[e] = image;
        shapes.hand[e] = hand;
        reached[e] = true;
      } else if (image == shapes.shape[e] && shapes.hand[e] != hand) {
        shapes.hand[e] = 0;
      }
    }
  }
  return shapes;
}

std::vector<int> mirror_partners(const std::vector<WalkedEdge>& edges,
                                 const std::vector<PanelFit>& fits,
                                 const std::vector<PanelWords>& words) {
  const auto panels = panels_of(edges);
  const int count = static_cast<int>(panels.size());
  // Panels of the shape of each panel.
  std::vector<std::vector<int>> alike(count);
  for (const PanelFit& fit : fits) {
    auto& list = alike[fit.from];
    if (std::find(list.begin(), list.end(), fit.to) == list.end()) list.push_back(fit.to);
  }
  // Halves as drawn: what goes up goes up on the other half, and left and right change places.
  const auto mirrored_as_drawn = [&](int from, int to) -> const PanelFit* {
    const PanelFit* best = nullptr;
    double most = 0;
    for (const PanelFit& fit : fits) {
      if (fit.from != from || fit.to != to || !fit.mirrored) continue;
      double like = 0;
      for (std::size_t i = 0; i < fit.image.size(); ++i) {
        if (fit.image[i] < 0) continue;
        const WalkedEdge& own = edges[panels[from][0] + i];
        const WalkedEdge& other = edges[fit.image[i]];
        like += own.length * (own.upwards * other.upwards - own.rise * other.rise);
      }
      if (best == nullptr || like > most) {
        most = like;
        best = &fit;
      }
    }
    return best;
  };
  const auto middle = [&](int e) { return edges[e].points[edges[e].points.size() / 2]; };
  // Of several ways, the one that moves an edge farthest: a band's ends change places.
  const auto mirror_fit = [&](int from, int to, bool only) -> const PanelFit* {
    const PanelFit* best = nullptr;
    int ways = 0;
    double farthest = -1;  // metres
    for (const PanelFit& fit : fits) {
      if (fit.from != from || fit.to != to || !fit.mirrored) continue;
      ++ways;
      double moved = 0;
      for (std::size_t i = 0; i < fit.image.size(); ++i) {
        const int e = panels[from][0] + static_cast<int>(i);
        if (fit.image[i] >= 0) moved = std::max(moved, (middle(fit.image[i]) - middle(e)).norm());
      }
      if (moved > farthest) {
        farthest = moved;
        best = &fit;
      }
    }
    return only && ways != 1 ? nullptr : best;
  };
  // Of numbered pieces, the one of the front or the back that has no other like it there.
  const auto is_in_the_middle = [&](int p) {
    if (words[p].number < 0) return alike[p].size() <= 2;
    return words[p].face != 0 && std::none_of(alike[p].begin(), alike[p].end(), [&](int q) {
             return q != p && words[q].face != -words[p].face;
           });
  };
  std::vector<int> partner(edges.size(), -1);
  for (int p = 0; p < count; ++p) {
    const PanelWords& name = words[p];
    const PanelFit* fit = nullptr;
    if (name.side != 0) {
      for (const int q : alike[p]) {
        if (words[q].side == -name.side && words[q].whole == name.whole) {
          fit = mirrored_as_drawn(p, q);
          break;
        }
      }
    } else if (name.role != PanelRole::unknown && is_in_the_middle(p)) {
      fit = mirror_fit(p, p, false);
    } else if (name.role == PanelRole::unknown) {
      const bool own_mirror = mirror_fit(p, p, false) != nullptr;
      if (alike[p].size() == 1) fit = mirror_fit(p, p, true);
      if (alike[p].size() == 2 && !own_mirror) {
        fit = mirror_fit(p, alike[p][0] == p ? alike[p][1] : alike[p][0], true);
      }
    }
    if (fit == nullptr) continue;
    for (std::size_t i = 0; i < fit->image.size(); ++i) {
      partner[panels[p][0] + i] = fit->image[i];
    }
  }
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (partner[e] >= 0 && partner[partner[e]] != static_cast<int>(e)) partner[e] = -1;
  }
  return partner;
}

}  // namespace toile
