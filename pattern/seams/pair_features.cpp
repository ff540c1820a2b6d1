#include "pattern/seams/pair_features.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/polygon.h"

namespace toile {

namespace {

double log_ratio(double a, double b) { return std::abs(std::log(a / b)); }

/// Rounded, so that the last bits of a drawing that is turned or mirrored take no other branch.
float rounded(double value) { return static_cast<float>(std::round(value * 1e4) / 1e4 + 0.0); }

/// Whether a name says what the panel is. Codes and their numbers tell no more than the order of
/// the file.
bool tells(const PanelWords& words) { return words.role != PanelRole::unknown || words.face != 0; }

/// Logarithm of the lengths of edges that are about as long as each other. The trees learned from
/// it: another value needs another fit.
constexpr double as_long = 0.01;

/// Words that both names have, over the words of the one that has fewer. Each word is kept with a
/// blank after it.
double words_shared(const std::string& a, const std::string& b) {
  const auto list = [](const std::string& words) {
    std::vector<std::string> all;
    for (std::size_t at = 0; at < words.size();) {
      const std::size_t end = words.find(' ', at);
      all.push_back(words.substr(at, end - at));
      at = end + 1;
    }
    return all;
  };
  const std::vector<std::string> first = list(a);
  const std::vector<std::string> second = list(b);
  if (first.empty() || second.empty()) return 0;
  int shared = 0;
  for (const std::string& word : first) {
    shared += std::find(second.begin(), second.end(), word) != second.end() ? 1 : 0;
  }
  return static_cast<double>(shared) / static_cast<double>(std::min(first.size(), second.size()));
}

}  // namespace

PairFeatures::PairFeatures(const SeamEvidence& evidence) : evidence_(evidence) {
  const std::vector<WalkedEdge>& edges = evidence.edges;
  const int count = static_cast<int>(edges.size());
  for (int e = 0; e < count; ++e) {
    if (edges[e].ref.panel == static_cast<int>(panels_.size())) {
      panels_.push_back({});
      panels_.back().first = e;
    }
    Panel& panel = panels_.back();
    ++panel.count;
    panel.perimeter += edges[e].length;
    panel.longest = std::max(panel.longest, edges[e].length);
  }
  for (Panel& panel : panels_) {
    std::vector<Vec2> outline;
    for (int e = panel.first; e < panel.first + panel.count; ++e) {
      outline.insert(outline.end(), edges[e].points.begin(), edges[e].points.end() - 1);
    }
    panel.area = std::abs(signed_area(outline));
    Vec2 low = outline.front();
    Vec2 high = outline.front();
    for (const Vec2& point : outline) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    panel.low = low;
    panel.width = high.x() - low.x();
    panel.height = high.y() - low.y();
    largest_area_ = std::max(largest_area_, panel.area);
  }
  for (const PanelFit& fit : evidence.fits) {
    if (fit.from == fit.to && fit.mirrored) panels_[fit.from].is_own_mirror = true;
  }
  for (std::size_t p = 0; p < panels_.size(); ++p) {
    std::vector<int> alike;
    for (const PanelFit& fit : evidence.fits) {
      if (fit.from == static_cast<int>(p)) alike.push_back(fit.to);
    }
    std::sort(alike.begin(), alike.end());
    panels_[p].alike = static_cast<int>(std::unique(alike.begin(), alike.end()) - alike.begin());
  }
  whole_edges_ = count;
  for (const Panel& a : panels_) {
    for (const Panel& b : panels_) matching_.push_back(matching_length(a, b));
  }
  follow();
}

void PairFeatures::follow() {
  const std::size_t count = evidence_.edges.size();
  const std::size_t before = std::min(count, rows_.size());
  near_.resize(before);
  nearest_.resize(before);
  rows_.resize(before);
  for (std::size_t e = before; e < count; ++e) add_rivals(static_cast<int>(e));
  for (std::size_t e = before; e < count; ++e) {
    rows_.push_back({described(static_cast<int>(e), false), described(static_cast<int>(e), true)});
  }
}

void PairFeatures::add_rivals(int edge) {
  const std::vector<int>& shape = evidence_.shapes.shape;
  int near = 0;
  double nearest = 1;
  for (int other = 0; other < whole_edges_; ++other) {
    if (shape[edge] == shape[other]) continue;
    const double ratio = log_ratio(evidence_.edges[edge].length, evidence_.edges[other].length);
    nearest = std::min(nearest, ratio);
    near += ratio < as_long ? 1 : 0;
  }
  near_.push_back(near);
  nearest_.push_back(nearest);
}

/// Share of the outline of `a` whose edges have one of about their length on `b`.
double PairFeatures::matching_length(const Panel& a, const Panel& b) const {
  double sum = 0;
  for (int e = a.first; e < a.first + a.count; ++e) {
    double least = 1;
    for (int f = b.first; f < b.first + b.count; ++f) {
      if (f == e) continue;
      least = std::min(least, log_ratio(evidence_.edges[e].length, evidence_.edges[f].length));
    }
    sum += evidence_.edges[e].length * std::exp(-least / 0.02);
  }
  return sum / a.perimeter;
}

/// `against`: from the end of the edge's walk to its start.
PairFeatures::EdgeRow PairFeatures::described(int e, bool against) const {
  const std::vector<WalkedEdge>& edges = evidence_.edges;
  const WalkedEdge& edge = edges[e];
  const Panel& panel = panels_[edge.ref.panel];
  const Vec2& middle = edge.points[edge.points.size() / 2];
  const int mirror = evidence_.mirror[e];
  const double corner_before = edge.corner;
  const double corner_behind = edges[edge.next].corner;
  const WalkedEdge& before = edges[against ? edge.next : edge.previous];
  const WalkedEdge& behind = edges[against ? edge.previous : edge.next];
  const PanelWords& words = evidence_.words[edge.ref.panel];
  const auto& t = edge.turning;
  const double turn = t[0] + t[1] + t[2] + t[3];
  return {
      rounded(std::log(edge.length)),
      rounded(edge.length / panel.perimeter),
      rounded(edge.length / panel.longest),
      rounded(turn),
      rounded(against ? t[2] + t[3] : t[0] + t[1]),
      rounded(against ? corner_behind : corner_before),
      rounded(against ? corner_before : corner_behind),
      rounded(edge.upwards),
      rounded(against ? -edge.rise : edge.rise),
      rounded(edge.across_grain),
      rounded(edges[against ? edge.next : e].notch ? 1 : 0),
      rounded(edges[against ? e : edge.next].notch ? 1 : 0),
      rounded(panel.count),
      rounded(std::log(panel.area / largest_area_)),
      rounded(std::log(panel.height / panel.width)),
      rounded(panel.is_own_mirror ? 1 : 0),
      rounded(mirror < 0                                  ? 0
              : mirror == e                               ? 1
              : edges[mirror].ref.panel == edge.ref.panel ? 2
                                                          : 3),
      rounded(panel.alike),
      rounded(std::log(before.length / edge.length)),
      rounded(std::log(behind.length / edge.length)),
      rounded((middle.y() - panel.low.y()) / panel.height),
      rounded(std::abs((middle.x() - panel.low.x()) / panel.width - 0.5)),
      rounded(near_[e]),
      rounded(nearest_[e]),
      rounded(static_cast<int>(words.role)),
      rounded(tells(words) ? std::min(words.number, 10) : -1),
  };
}

PairRow PairFeatures::of(int a, int b, bool mirrored) const {
  const std::vector<WalkedEdge>& edges = evidence_.edges;
  const WalkedEdge& first = edges[a];
  const WalkedEdge& second = edges[b];
  const PanelWords& words_a = evidence_.words[first.ref.panel];
  const PanelWords& words_b = evidence_.words[second.ref.panel];
  const Panel& panel_a = panels_[first.ref.panel];
  const Panel& panel_b = panels_[second.ref.panel];
  const std::vector<int>& shape = evidence_.shapes.shape;
  const std::vector<int>& hand = evidence_.shapes.hand;
  const bool same_panel = first.ref.panel == second.ref.panel;
  const bool dart = first.next == b || second.next == a;
  const double ratio = log_ratio(first.length, second.length);
  double into = 0;
  double alike = 0;
  for (int k = 0; k < 4; ++k) {
    into += std::abs(first.turning[k] + second.turning[3 - k]);
    alike += std::abs(first.turning[k] - second.turning[3 - k]);
  }
  // The end of a meets the start of b.
  double corners_end = edges[first.next].corner + second.corner;
  double corners_start = first.corner + edges[second.next].corner;
  double next_ratio = log_ratio(edges[first.next].length, edges[second.previous].length);
  double before_ratio = log_ratio(edges[first.previous].length, edges[second.next].length);
  if (mirrored) {
    std::swap(corners_start, corners_end);
    std::swap(before_ratio, next_ratio);
  }
  // Edges that are likelier by their length.
  int better_a = 0;
  int better_b = 0;
  for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
    if (shape[e] != shape[a] && shape[e] != shape[b]) {
      better_a += log_ratio(edges[e].length, first.length) < ratio - 1e-4 ? 1 : 0;
      better_b += log_ratio(edges[e].length, second.length) < ratio - 1e-4 ? 1 : 0;
    }
  }
  const bool same_shape = shape[a] == shape[b];
  bool panels_alike = false;
  for (int e = panel_b.first; e < panel_b.first + panel_b.count; ++e) {
    panels_alike = panels_alike || shape[e] == shape[panel_a.first];
  }
  double tip = 0;
  double opening = 0;
  double dart_up = 0;
  if (dart) {
    const bool leads = first.next == b;
    tip = leads ? second.corner : first.corner;
    opening = ((leads ? first.points.front() : second.points.front()) -
               (leads ? second.points.back() : first.points.back()))
                  .norm() /
              std::max(first.length, second.length);
    dart_up = (leads ? first.rise - second.rise : second.rise - first.rise) / 2;
  }
  const bool named = words_a.role != PanelRole::unknown && words_b.role != PanelRole::unknown;
  const bool tell = tells(words_a) && tells(words_b);
  const bool same_stem = tell && !words_a.stem.empty() && words_a.stem == words_b.stem;
  const auto inwards = [&](const WalkedEdge& edge) {  // towards the body's middle
    const int panel = edge.ref.panel;
    return -evidence_.side[panel] * evidence_.words[panel].face * edge.rise;
  };
  const std::size_t panels = panels_.size();
  const std::array<float, joint_features> joint = {
      rounded(ratio),
      rounded(std::log(first.length / second.length)),
      rounded(100 * std::abs(first.length - second.length)),
      rounded(into),
      rounded(alike),
      rounded(same_shape ? (hand[a] * hand[b] == 0  ? 3
                            : hand[a] * hand[b] > 0 ? 1
                                                    : 2)
                         : 0),
      rounded(evidence_.mirror[a] == b ? 1 : 0),
      rounded(dart         ? 2
              : same_panel ? 1
                           : 0),
      rounded(tip),
      rounded(opening),
      rounded(dart_up),
      rounded(corners_start),
      rounded(corners_end),
      rounded(before_ratio),
      rounded(next_ratio),
      rounded(first.upwards * second.upwards),
      rounded(first.rise * second.rise),
      rounded(std::abs(first.across_grain - second.across_grain)),
      rounded(better_a),
      rounded(better_b),
      rounded(panels_alike ? 1 : 0),
      rounded(matching_[first.ref.panel * panels + second.ref.panel]),
      rounded(matching_[second.ref.panel * panels + first.ref.panel]),
      rounded(std::log(panel_a.area / panel_b.area)),
      rounded(evidence_.turned_over[first.ref.panel] != evidence_.turned_over[second.ref.panel]
                  ? 1
                  : 0),
      rounded(static_cast<double>(panels)),
      rounded(words_a.face * words_b.face),
      rounded(evidence_.side[first.ref.panel] * evidence_.side[second.ref.panel]),
      rounded(same_stem ? 1 : 0),
      rounded(same_stem ? std::min(3, std::abs(words_a.number - words_b.number)) : -1),
      rounded(named ? std::min(inwards(first), inwards(second)) : 0),
      rounded(named && words_a.role == words_b.role ? 1 : 0),
      rounded(words_a.says(words_b.role) ? 1 : 0),
      rounded(words_b.says(words_a.role) ? 1 : 0),
      rounded(tell ? words_shared(words_a.stem, words_b.stem) : 0),
      rounded(tell && words_a.whole == words_b.whole ? 1 : 0),
  };
  PairRow row{};
  const EdgeRow& row_a = rows_[a][mirrored ? 1 : 0];
  const EdgeRow& row_b = rows_[b][mirrored ? 0 : 1];
  auto* const behind_a = std::copy(row_a.begin(), row_a.end(), row.begin());
  auto* const behind_b = std::copy(row_b.begin(), row_b.end(), behind_a);
  std::copy(joint.begin(), joint.end(), behind_b);
  return row;
}

}  // namespace toile
