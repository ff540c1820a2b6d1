#include "pattern/seams/corner_groups.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile {

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Radians by which groups of one, two, three, four corners may miss what closes flat.
/// GarmentCode's garments give these: a twentieth of them lie outside.
constexpr std::array<double, 5> inner_tolerance = {0, 75 * degree, 80 * degree, 75 * degree,
                                                   110 * degree};
constexpr std::array<double, 5> border_tolerance = {0, 180 * degree, 130 * degree, 60 * degree,
                                                    100 * degree};
constexpr double sharpest_dart_tip = 285 * degree;

/// Groups that are kept at each end of a candidate or an open edge.
constexpr int kept_groups = 4;

/// Groups that are worth less, with half of their seams, are left out.
constexpr double least_with_seams = -0.2;

/// Units of 90 degrees: where three and four corners meet, one seam runs on as straight as this.
constexpr double max_off_junction = 0.6;

class Search {
 public:
  Search(const SeamEvidence& evidence, const std::vector<SeamCandidate>& candidates,
         const SeamMeasures& weights)
      : edges_(evidence.edges), candidates_(candidates), w_(weights), across_(edges_.size()) {
    for (int c = 0; c < static_cast<int>(candidates.size()); ++c) {
      const int a_last = edges_of(edges_, candidates[c].a).back();
      const int b_last = edges_of(edges_, candidates[c].b).back();
      link({c, 0}, {candidates[c].a.first, 0}, {b_last, 1});
      link({c, 1}, {a_last, 1}, {candidates[c].b.first, 0});
    }
  }

  std::vector<CornerGroup> find() {
    for (int corner = 0; corner < static_cast<int>(edges_.size()); ++corner) {
      start_ = corner;
      corners_ = {corner};
      seams_.clear();
      sum_ = edges_[corner].corner;
      open_first_ = false;
      go({corner, 0});
      // Groups on the border, from one open edge to the other.
      open_first_ = true;
      first_open_ = {corner, 0};
      go({edges_[corner].previous, 1});
      first_open_ = {edges_[corner].previous, 1};
      go({corner, 0});
    }
    return std::move(groups_);
  }

 private:
  struct Crossing {
    SeamEnd seam;
    EdgeEnd to;
  };

  void link(const SeamEnd& seam, const EdgeEnd& x, const EdgeEnd& y) {
    across_[x.edge][x.end].push_back({seam, y});
    across_[y.edge][y.end].push_back({seam, x});
  }

  /// The corner at an end of an edge is numbered by the edge that starts there.
  int corner_at(const EdgeEnd& end) const {
    return end.end == 0 ? end.edge : edges_[end.edge].next;
  }
  EdgeEnd other_at_corner(const EdgeEnd& end) const {
    return end.end == 0 ? EdgeEnd{edges_[end.edge].previous, 1} : EdgeEnd{edges_[end.edge].next, 0};
  }

  bool agrees(int candidate) const {
    const SeamCandidate& c = candidates_[candidate];
    return std::all_of(seams_.begin(), seams_.end(), [&](const SeamEnd& seam) {
      if (seam.candidate == candidate) return true;
      const SeamCandidate& d = candidates_[seam.candidate];
      for (const SeamSide& x : {c.a, c.b}) {
        for (const SeamSide& y : {d.a, d.b}) {
          if (overlap(x, y)) return false;
        }
      }
      return true;
    });
  }

  bool overlap(const SeamSide& x, const SeamSide& y) const {
    if (x.count == 1 && y.count == 1) return x.first == y.first;
    const std::vector<int> a = edges_of(edges_, x);
    for (const int e : edges_of(edges_, y)) {
      if (std::find(a.begin(), a.end(), e) != a.end()) return true;
    }
    return false;
  }

  /// Leaves the last corner by `end`.
  void go(const EdgeEnd& end) {
    const std::size_t count = corners_.size();
    if (open_first_) finish_border(end);
    for (const Crossing& crossing : across_[end.edge][end.end]) {
      if (!agrees(crossing.seam.candidate)) continue;
      const int corner = corner_at(crossing.to);
      if (corner == start_ && !open_first_) {
        const EdgeEnd back = {edges_[start_].previous, 1};
        if (crossing.to.edge != back.edge || crossing.to.end != back.end) continue;
        seams_.push_back(crossing.seam);
        finish_inner();
        seams_.pop_back();
        continue;
      }
      if (count == 4 || (!open_first_ && corner < start_)) continue;
      if (std::find(corners_.begin(), corners_.end(), corner) != corners_.end()) continue;
      const double limit = open_first_ ? 310 * degree : 500 * degree;
      if (sum_ + edges_[corner].corner > limit) continue;
      corners_.push_back(corner);
      seams_.push_back(crossing.seam);
      sum_ += edges_[corner].corner;
      go(other_at_corner(crossing.to));
      sum_ -= edges_[corner].corner;
      seams_.pop_back();
      corners_.pop_back();
    }
  }

  void finish_inner() {
    using enum SeamMeasure;
    SeamMeasures measures{};
    const auto at = [&](SeamMeasure measure) -> double& {
      return measures[static_cast<int>(measure)];
    };
    const std::size_t corners = corners_.size();
    const double off = std::abs(sum_ - 360 * degree) / (90 * degree);
    if (corners == 1) {
      if (sum_ < sharpest_dart_tip) return;
      at(dart_tip) = 1;
    } else if (off * 90 * degree > inner_tolerance[corners]) {
      return;
    } else if (corners == 2) {
      at(two_inside) = 1;
      at(two_inside_off) = off;
    } else {
      at(corners == 3 ? three_inside : four_inside) = 1;
      at(corners == 3 ? three_inside_off : four_inside_off) = off;
      at(junction_off) = off_junction();
      if (at(junction_off) > max_off_junction) return;
    }
    at(jump) = unsteadiness(true);
    at(unlike) = unlikeness(true);
    add(measures, {});
  }

  /// By how much the flattest corner, or pair of corners side by side, misses 180 degrees. Units of
  /// 90 degrees.
  double off_junction() const {
    double least = 2;
    const std::size_t count = corners_.size();
    for (std::size_t i = 0; i < count; ++i) {
      const double one = edges_[corners_[i]].corner;
      const double two = one + edges_[corners_[(i + 1) % count]].corner;
      least = std::min({least, std::abs(one - std::numbers::pi), std::abs(two - std::numbers::pi)});
    }
    return least / (90 * degree);
  }

  void finish_border(const EdgeEnd& end) {
    // Each group is found from both its ends.
    if (std::array{first_open_.edge, first_open_.end} > std::array{end.edge, end.end}) return;
    using enum SeamMeasure;
    SeamMeasures measures{};
    const auto at = [&](SeamMeasure measure) -> double& {
      return measures[static_cast<int>(measure)];
    };
    const std::size_t corners = corners_.size();
    const double off = std::abs(sum_ - 180 * degree);
    if (off > border_tolerance[corners]) return;
    if (corners == 1) {
      at(off < 20 * degree ? smooth_border : lone_corner) = 1;
    } else {
      at(corners == 2 ? two_at_border : more_at_border) = 1;
      at(corners == 2 ? two_at_border_off : more_at_border_off) = off / (90 * degree);
      at(jump) = unsteadiness(false);
      at(unlike) = unlikeness(false);
    }
    add(measures, {first_open_, end});
  }

  /// Radians, at most pi: two corners that lie side by side at a seam and make 180 degrees together
  /// continue a line. It should turn alike on both.
  double unlikeness(bool closed) const {
    double sum = 0;
    const std::size_t count = corners_.size();
    for (std::size_t i = 0; i < seams_.size() && count > 1; ++i) {
      const int a = corners_[i];
      const int b = corners_[(i + 1) % count];
      if (!closed && i + 1 >= count) break;
      if (std::abs(edges_[a].corner + edges_[b].corner - std::numbers::pi) > 45 * degree) continue;
      sum += std::abs(turning(outer_edge(a, seams_[i])) - turning(outer_edge(b, seams_[i])));
    }
    return std::min(sum, std::numbers::pi);
  }

  /// The edge at a corner that is not in the seam.
  int outer_edge(int corner, const SeamEnd& seam) const {
    const SeamCandidate& c = candidates_[seam.candidate];
    for (const SeamSide& side : {c.a, c.b}) {
      for (const int e : edges_of(edges_, side)) {
        if (e == corner) return edges_[corner].previous;
      }
    }
    return corner;
  }

  double turning(int e) const {
    const auto& turning = edges_[e].turning;
    return turning[0] + turning[1] + turning[2] + turning[3];
  }

  /// 0 to 1: how much the fullness jumps where a seam runs on straight over a corner.
  double unsteadiness(bool closed) const {
    double most = 0;
    const std::size_t count = seams_.size();
    for (std::size_t i = closed ? 0 : 1; i < count; ++i) {
      const std::size_t before = (i + count - 1) % count;
      if (count < 2) break;
      // Corner i lies between seam i - 1, by which it was entered, and seam i.
      const double angle = edges_[corners_[i]].corner;
      if (std::abs(angle - std::numbers::pi) > 35 * degree) continue;
      const double jump = fullness(seams_[before], corners_[i]) - fullness(seams_[i], corners_[i]);
      most = std::max(most, std::min(1.0, std::abs(jump) / 0.2));
    }
    return most;
  }

  double length(const SeamSide& side) const {
    double sum = 0;
    for (const int e : edges_of(edges_, side)) sum += edges_[e].length;
    return sum;
  }

  /// Logarithm of the length on the corner's panel over the length on the other side.
  double fullness(const SeamEnd& seam, int corner) const {
    const SeamCandidate& c = candidates_[seam.candidate];
    const double ratio = std::log(length(c.a) / length(c.b));
    const int at_a = seam.end == 0 ? c.a.first : edges_[edges_of(edges_, c.a).back()].next;
    return at_a == corner ? ratio : -ratio;
  }

  void add(const SeamMeasures& measures, std::vector<EdgeEnd> open) {
    const double worth = worth_of(measures, w_);
    if (worth <= 0) return;
    // Each seam counts half here and half at its other end.
    double whole = worth;
    for (const SeamEnd& seam : seams_) whole += candidates_[seam.candidate].worth / 2;
    if (whole < least_with_seams) return;
    groups_.push_back({seams_, std::move(open), worth});
  }

  const std::vector<WalkedEdge>& edges_;
  const std::vector<SeamCandidate>& candidates_;
  const SeamMeasures& w_;
  std::vector<std::array<std::vector<Crossing>, 2>> across_;
  std::vector<CornerGroup> groups_;
  int start_ = 0;
  bool open_first_ = false;
  EdgeEnd first_open_;
  std::vector<int> corners_;
  std::vector<SeamEnd> seams_;
  double sum_ = 0;
};

/// Keeps the groups that are among the best at one of their ends.
std::vector<CornerGroup> best_at_each_end(const SeamEvidence& evidence,
                                          const std::vector<SeamCandidate>& candidates,
                                          std::vector<CornerGroup> groups) {
  const auto whole = [&](const CornerGroup& group) {
    double sum = group.worth;
    for (const SeamEnd& seam : group.seams) sum += candidates[seam.candidate].worth / 2;
    return sum;
  };
  std::stable_sort(groups.begin(), groups.end(),
                   [&](const CornerGroup& a, const CornerGroup& b) { return whole(a) > whole(b); });
  std::vector<std::array<int, 2>> at_seam(candidates.size());
  std::vector<std::array<int, 2>> at_open(evidence.edges.size());
  std::vector<CornerGroup> kept;
  for (CornerGroup& group : groups) {
    int rank = kept_groups + 1;
    for (const SeamEnd& seam : group.seams) {
      rank = std::min(rank, ++at_seam[seam.candidate][seam.end]);
    }
    for (const EdgeEnd& end : group.open) rank = std::min(rank, ++at_open[end.edge][end.end]);
    if (rank <= kept_groups) kept.push_back(std::move(group));
  }
  return kept;
}

}  // namespace

std::vector<CornerGroup> corner_groups(const SeamEvidence& evidence,
                                       const std::vector<SeamCandidate>& candidates,
                                       const SeamMeasures& weights) {
  return best_at_each_end(evidence, candidates, Search(evidence, candidates, weights).find());
}

}  // namespace toile
