#include "pattern/seams/seam_runs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "pattern/seams/seam_weights.h"

namespace toile {

namespace {

// Figures are of 43 labelled drawings: as they are, 504 seams are right and 32 wrong.

/// Edges of a run at most. A skirt's waistband meets some 12 edges, where darts reach the waist.
/// With half and double of it the same seams are found.
constexpr std::size_t longest_run = 16;

/// Logarithm of the lengths of two sides with several edges each, and of one edge to several. With
/// half and double of either the same seams are found; with double it takes a tenth longer.
constexpr double several_to_several = 0.05;
constexpr double one_to_several = 0.7;

/// Logarithm of the odds of a seam whose edges are free to be sewn otherwise. With half of it the
/// same seams are found, with double 494 and 32.
constexpr double doubtful = 1.5;

/// Logarithm of the lengths of a seam's sides: an edge of such a seam is free as well. With half
/// 494 and 32 are found, with double 510 and 32.
constexpr double poor_seam = 0.02;

/// Metres: joints of both sides that lie closer are one, and no part is shorter. With half 490 and
/// 20 are found, with double 489 and 24: of hoods some pieces are shorter.
constexpr double shortest_part = 0.005;

/// Logarithm of odds that a part must have. With half the same seams are found, with double 495 and
/// 23, which takes a third longer.
constexpr double hopeless_part = -4;

/// Score of a run by its odds alone: corners that meet may make up for what it lacks. With half and
/// double of it the same seams are found.
constexpr double least_run_gain = -4;

/// Logarithm of the odds of a dart that runs pass over. With 2, 500 and 32 are found.
constexpr double likely_dart = 0;

class RunFinder {
 public:
  /// Seams of less odds than `kept` are free to be sewn otherwise.
  RunFinder(const CutPattern& cut, bool drawn_walk, const FoundSeams& found, double kept)
      : cut_(cut),
        evidence_(seam_evidence(cut.pattern, drawn_walk, found.turned_over)),
        pairs_(evidence_),
        partner_(evidence_.edges.size(), -1),
        free_(evidence_.edges.size(), 1),
        locked_(evidence_.edges.size(), 0),
        lost_(evidence_.edges.size(), 0) {
    evidence_ = heeding(found.sides, std::move(evidence_));
    std::map<std::array<int, 2>, int> number;
    for (int e = 0; e < size(); ++e) {
      number[{evidence_.edges[e].ref.panel, evidence_.edges[e].ref.edge}] = e;
    }
    for (const FoundSeam& seam : found.seams) {
      const int a = number.at({seam.a.panel, seam.a.edge});
      const int b = number.at({seam.b.panel, seam.b.edge});
      if (seam.given) locked_[a] = locked_[b] = 1;
      const double odds = pairs_.odds(a, b);
      lost_[a] = lost_[b] = score_of(odds);
      const bool poor = std::abs(std::log(seam.length_a / seam.length_b)) > poor_seam;
      if (!seam.given && (poor || odds < kept)) continue;
      partner_[a] = b;
      partner_[b] = a;
      free_[a] = free_[b] = 0;
    }
    whole_ = size();
    // A dart that is not sewn yet ends no run.
    for (int e = 0; e < whole_; ++e) {
      const int next = evidence_.edges[e].next;
      if (partner_[e] >= 0 || partner_[next] >= 0 || locked_[e] != 0 || locked_[next] != 0)
        continue;
      if (evidence_.edges[next].corner < sharpest_dart_tip || pairs_.odds(e, next) < likely_dart)
        continue;
      partner_[e] = next;
      partner_[next] = e;
      free_[e] = free_[next] = 0;
    }
  }

  std::vector<SeamRun> all() {
    const std::vector<std::vector<Side>> onward = sides(true);
    const std::vector<std::vector<Side>> backward = sides(false);
    for (const std::vector<Side>& from_a : onward) {
      for (const std::vector<Side>& from_b : backward) {
        if (from_a.front().pieces.front().edge == from_b.front().pieces.front().edge) continue;
        for (const Side& a : from_a) {
          for (const Side& b : from_b) look_at(a, b);
        }
      }
    }
    return std::move(runs_);
  }

 private:
  struct Piece {
    int edge = 0;
    double from = 0;  // shares of the edge's walk
    double to = 1;
  };

  struct PieceCut {
    int edge = 0;
    double share = 0;  // of the edge's walk
    bool notch = false;
  };

  int size() const { return static_cast<int>(evidence_.edges.size()); }

  static double score_of(double odds) {
    return seam_weights[static_cast<int>(SeamMeasure::seam)] +
           odds * seam_weights[static_cast<int>(SeamMeasure::likely)];
  }

  bool is_smooth_notch(int edge) const {
    constexpr double most_turn = 20 * std::numbers::pi / 180;
    const WalkedEdge& at = evidence_.edges[edge];
    return at.notch && std::abs(at.corner - std::numbers::pi) < most_turn;
  }

  /// The next edge of a run, or the one before; -1: there is none.
  int step(int edge, bool on) const {
    const WalkedEdge& here = evidence_.edges[edge];
    int next = on ? here.next : here.previous;
    // A notch alone ends no run: the other side may have none.
    if (is_smooth_notch(on ? next : edge) && locked_[next] == 0) return next;
    for (int steps = 0; partner_[next] >= 0 && steps < whole_; ++steps) {
      const WalkedEdge& across = evidence_.edges[partner_[next]];
      next = on ? across.next : across.previous;
    }
    return free_[next] != 0 ? next : -1;
  }

  /// One side of a run, in the order in which it is sewn.
  struct Side {
    std::vector<Piece> pieces;
    double length = 0;  // metres
  };

  double length_of(const Piece& piece) const {
    return (piece.to - piece.from) * evidence_.edges[piece.edge].length;
  }

  /// A panel that is its own mirror image has a joint where its middle meets the outline.
  bool has_middle(int edge) const { return evidence_.mirror[edge] == edge && free_[edge] != 0; }

  /// All that begin at some edge, by where they begin.
  std::vector<std::vector<Side>> sides(bool on) const {
    std::vector<std::vector<Side>> all;
    const Piece first_half{0, 0, 0.5};
    const Piece second_half{0, 0.5, 1};
    for (int edge = 0; edge < whole_; ++edge) {
      if (locked_[edge] != 0) continue;
      all.push_back(sides_from({edge, 0, 1}, on));
      if (!has_middle(edge)) continue;
      Piece half = on ? second_half : first_half;
      half.edge = edge;
      all.push_back(sides_from(half, on));
    }
    return all;
  }

  std::vector<Side> sides_from(const Piece& begin, bool on) const {
    std::vector<Side> all;
    Side side;
    std::set<int> edges;
    for (Piece piece = begin; side.pieces.size() < longest_run;) {
      edges.insert(piece.edge);
      const bool is_whole = piece.from == 0 && piece.to == 1;
      if (is_whole && has_middle(piece.edge)) {
        Side other = side;
        other.pieces.push_back({piece.edge, on ? 0 : 0.5, on ? 0.5 : 1});
        other.length += length_of(other.pieces.back());
        all.push_back(std::move(other));
      }
      side.pieces.push_back(piece);
      side.length += length_of(piece);
      all.push_back(side);
      const int next = step(piece.edge, on);
      if (next < 0 || edges.contains(next)) break;
      piece = {next, 0, 1};
    }
    return all;
  }

  void look_at(const Side& a, const Side& b) {
    const bool several = a.pieces.size() > 1 && b.pieces.size() > 1;
    if (std::abs(std::log(a.length / b.length)) > (several ? several_to_several : one_to_several)) {
      return;
    }
    // Each run is met from both of its ends.
    if (a.pieces.front().edge > b.pieces.back().edge) return;
    const bool share = std::any_of(a.pieces.begin(), a.pieces.end(), [&](const Piece& one) {
      return std::any_of(b.pieces.begin(), b.pieces.end(),
                         [&](const Piece& other) { return one.edge == other.edge; });
    });
    if (!share) add(a, b);
  }

  /// Where its pieces end, as shares of its length.
  std::vector<double> joints(const Side& side) const {
    std::vector<double> at = {0};
    for (const Piece& piece : side.pieces) at.push_back(at.back() + length_of(piece) / side.length);
    at.back() = 1;
    return at;
  }

  /// The part of a piece between two shares of it, as it is walked on or back.
  static Piece part(const Piece& piece, bool on, double from, double to) {
    const auto at = [&piece](double share) {
      return share == 0   ? piece.from
             : share == 1 ? piece.to
                          : piece.from + share * (piece.to - piece.from);
    };
    return on ? Piece{piece.edge, at(from), at(to)} : Piece{piece.edge, at(1 - to), at(1 - from)};
  }

  void add(const Side& side_a, const Side& side_b) {
    const std::vector<Piece>& a = side_a.pieces;
    const std::vector<Piece>& b = side_b.pieces;
    const std::vector<double> joints_a = joints(side_a);
    const std::vector<double> joints_b = joints(side_b);
    const double nearest = shortest_part / std::min(side_a.length, side_b.length);
    // Pieces of both sides, from joint to joint of either.
    std::vector<std::array<Piece, 2>> pieces;
    std::vector<PieceCut> cuts;
    for (const Piece* end : {&a.front(), &a.back(), &b.front(), &b.back()}) {
      if (end->from != 0) cuts.push_back({end->edge, end->from, false});
      if (end->to != 1) cuts.push_back({end->edge, end->to, false});
    }
    std::size_t i = 0;
    std::size_t k = 0;
    double from_a = 0;
    double from_b = 0;
    const auto share = [](const std::vector<double>& joints, std::size_t at, double place) {
      return (place - joints[at]) / (joints[at + 1] - joints[at]);
    };
    while (i < a.size() && k < b.size()) {
      const double end_a = joints_a[i + 1];
      const double end_b = joints_b[k + 1];
      const bool meet = std::abs(end_a - end_b) < nearest;
      const bool by_a = meet || end_a < end_b;
      const bool by_b = meet || end_b < end_a;
      if ((!by_a && free_[a[i].edge] == 0) || (!by_b && free_[b[k].edge] == 0)) return;
      const double end = std::min(end_a, end_b);
      if (!meet && end - std::max(from_a, from_b) < nearest) return;
      const Piece of_a =
          part(a[i], true, share(joints_a, i, from_a), by_a ? 1 : share(joints_a, i, end));
      const Piece of_b =
          part(b[k], false, share(joints_b, k, from_b), by_b ? 1 : share(joints_b, k, end));
      if (!by_a) cuts.push_back({of_a.edge, of_a.to, is_smooth_notch(b[k].edge)});
      if (!by_b) {
        cuts.push_back({of_b.edge, of_b.from, is_smooth_notch(evidence_.edges[a[i].edge].next)});
      }
      pieces.push_back({of_a, of_b});
      from_a = meet ? end_a : end;
      from_b = meet ? end_b : end;
      if (by_a) ++i;
      if (by_b) ++k;
    }
    if (i < a.size() || k < b.size() || cuts.empty()) return;
    SeamRun run{{}, {}, gain_of(pieces)};
    if (run.gain <= least_run_gain) return;
    add_seams(pieces, cuts, run);
    add_mirror_image(std::move(pieces), std::move(cuts), run);
    // Cuts that are one place leave nothing between them.
    const auto is_empty = [](const PanelPart& side) { return side.part.from >= side.part.to; };
    if (std::ranges::any_of(run.seams, [&](const std::array<PanelPart, 2>& seam) {
          return is_empty(seam[0]) || is_empty(seam[1]);
        })) {
      return;
    }
    for (auto& [edge, shares] : run.cuts) {
      std::sort(shares.begin(), shares.end(),
                [](const EdgeCut& x, const EdgeCut& y) { return x.share < y.share; });
    }
    runs_.push_back(std::move(run));
  }

  const EdgePart& whole(int edge) const {
    const EdgeRef& ref = evidence_.edges[edge].ref;
    return cut_.parts[ref.panel][ref.edge];
  }

  /// From a share of an edge's walk to one of the edge as drawn.
  double drawn(int edge, double share) const {
    const double along = evidence_.edges[edge].forward ? share : 1 - share;
    const EdgePart& part = whole(edge);
    return along == 0   ? part.from
           : along == 1 ? part.to
                        : part.from + along * (part.to - part.from);
  }

  /// A share of an edge's walk as one of the edge as drawn. A cut of the run that lies closer than
  /// a part may be long is the same place.
  double drawn(const SeamRun& run, int edge, double share) const {
    const double at = drawn(edge, share);
    const EdgePart& part = whole(edge);
    const auto cuts = run.cuts.find({evidence_.edges[edge].ref.panel, part.edge});
    if (cuts == run.cuts.end()) return at;
    const double nearest = shortest_part / evidence_.edges[edge].length * (part.to - part.from);
    for (const EdgeCut& cut : cuts->second) {
      if (std::abs(cut.share - at) < nearest) return cut.share;
    }
    return at;
  }

  void add_seams(const std::vector<std::array<Piece, 2>>& pieces, const std::vector<PieceCut>& cuts,
                 SeamRun& run) const {
    for (const PieceCut& cut : cuts) {
      const double at = drawn(run, cut.edge, cut.share);
      std::vector<EdgeCut>& of_edge =
          run.cuts[{evidence_.edges[cut.edge].ref.panel, whole(cut.edge).edge}];
      const bool is_known = std::any_of(of_edge.begin(), of_edge.end(),
                                        [at](const EdgeCut& other) { return other.share == at; });
      if (!is_known) of_edge.push_back({at, cut.notch});
    }
    const auto part = [&](const Piece& piece) -> PanelPart {
      const double from = drawn(run, piece.edge, piece.from);
      const double to = drawn(run, piece.edge, piece.to);
      return {evidence_.edges[piece.edge].ref.panel,
              {whole(piece.edge).edge, std::min(from, to), std::max(from, to)}};
    };
    for (const auto& [a, b] : pieces) run.seams.push_back({part(a), part(b)});
  }

  /// The same on the other half of the garment, if none of its edges is in the run.
  void add_mirror_image(std::vector<std::array<Piece, 2>> pieces, std::vector<PieceCut> cuts,
                        SeamRun& run) const {
    const std::vector<std::array<Piece, 2>> drawn = pieces;
    for (auto& [a, b] : pieces) {
      for (Piece* side : {&a, &b}) {
        const int twin = evidence_.mirror[side->edge];
        if (twin < 0 || locked_[twin] != 0) return;
        *side = {twin, 1 - side->to, 1 - side->from};
        const bool is_in_run = std::any_of(drawn.begin(), drawn.end(), [side](const auto& pair) {
          return std::any_of(pair.begin(), pair.end(), [side](const Piece& other) {
            return other.edge == side->edge && other.from < side->to && side->from < other.to;
          });
        });
        if (is_in_run) return;
      }
    }
    for (PieceCut& cut : cuts) {
      cut = {evidence_.mirror[cut.edge], 1 - cut.share, cut.notch};
      if (free_[cut.edge] == 0) return;
    }
    add_seams(pieces, cuts, run);
  }

  /// By the odds of all pieces, less those of the seams that their edges are in.
  double gain_of(const std::vector<std::array<Piece, 2>>& pieces) {
    double gain = 0;
    std::vector<std::array<int, 2>> pairs;
    std::array<int, 2> before = {-1, -1};
    for (const std::array<Piece, 2>& piece : pieces) {
      std::array<int, 2> pair{};
      for (int side = 0; side < 2; ++side) {
        const Piece& part = piece[side];
        pair[side] = part.edge;
        if (before[side] != part.edge) gain -= lost_[part.edge];
        if (part.from != 0 || part.to != 1) pair[side] = add_part(part);
        before[side] = part.edge;
      }
      pairs.push_back(pair);
    }
    // Parts of an edge are neighbours of each other.
    for (std::size_t i = 0; i + 1 < pairs.size(); ++i) {
      if (pieces[i][0].edge == pieces[i + 1][0].edge) link(pairs[i][0], pairs[i + 1][0]);
      if (pieces[i][1].edge == pieces[i + 1][1].edge) link(pairs[i + 1][1], pairs[i][1]);
    }
    pairs_.follow();
    for (const auto& [a, b] : pairs) {
      const double odds = pairs_.odds(a, b);
      gain += score_of(odds);
      if (odds < hopeless_part) {
        gain = -std::numeric_limits<double>::infinity();
        break;
      }
    }
    evidence_.edges.resize(whole_);
    evidence_.mirror.resize(whole_);
    evidence_.shapes.shape.resize(whole_);
    evidence_.shapes.hand.resize(whole_);
    pairs_.follow();
    return gain;
  }

  int add_part(const Piece& part) {
    const int number = size();
    evidence_.edges.push_back(part_of(evidence_.edges[part.edge], part.from, part.to));
    evidence_.mirror.push_back(-1);
    evidence_.shapes.shape.push_back(number);
    evidence_.shapes.hand.push_back(0);
    return number;
  }

  void link(int before, int after) {
    evidence_.edges[before].next = after;
    evidence_.edges[after].previous = before;
  }

  const CutPattern& cut_;
  SeamEvidence evidence_;
  SeamPairs pairs_;
  int whole_ = 0;  ///< edges that are no parts
  std::vector<int> partner_;
  std::vector<char> free_;
  std::vector<char> locked_;  ///< of given seams
  std::vector<double> lost_;  ///< score of the seam that the edge is in
  std::vector<SeamRun> runs_;
};

}  // namespace

std::vector<SeamRun> seam_runs(const CutPattern& cut, bool drawn_walk, const FoundSeams& found) {
  std::map<std::vector<std::array<PanelPart, 2>>, SeamRun> all;
  for (const double kept : {doubtful, hopeless_part}) {
    for (SeamRun& run : RunFinder(cut, drawn_walk, found, kept).all()) {
      std::vector<std::array<PanelPart, 2>> seams = run.seams;
      for (auto& [a, b] : seams) {
        if (b < a) std::swap(a, b);
      }
      std::sort(seams.begin(), seams.end());
      all.try_emplace(std::move(seams), std::move(run));
    }
  }
  std::vector<SeamRun> runs;
  runs.reserve(all.size());
  for (auto& [seams, run] : all) runs.push_back(std::move(run));
  std::stable_sort(runs.begin(), runs.end(),
                   [](const SeamRun& x, const SeamRun& y) { return x.gain > y.gain; });
  return runs;
}

}  // namespace toile
