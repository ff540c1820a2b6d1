#include "pattern/mesh/short_edges.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

#include "geometry/error.h"
#include "geometry/polygon.h"
#include "pattern/check/stitch_of_edge.h"
#include "pattern/constants.h"
#include "pattern/mesh/outline_polygon.h"
#include "pattern/mesh/sewn_corners.h"

namespace toile {

namespace {

/// The steps of an outline from `first` on, `count` of them, the last may be followed by the first.
struct Run {
  std::size_t first = 0;
  std::size_t count = 0;
};

/// Per panel and edge.
using EdgeFlags = std::vector<std::vector<bool>>;

/// Per panel and edge, what took a merged edge in.
using Takers = std::map<std::array<int, 2>, int>;

const EdgeCurve& curve_of(const PatternPanel& panel, const OutlineStep& step) {
  return panel.edges[static_cast<std::size_t>(step.edge)].curve;
}

const EdgeCurve& curve_of(const Pattern& pattern, const EdgeRef& ref) {
  return pattern.panels[static_cast<std::size_t>(ref.panel)]
      .edges[static_cast<std::size_t>(ref.edge)]
      .curve;
}

const Vec2& begin_of(const PatternPanel& panel, const OutlineStep& step) {
  const EdgeCurve& curve = curve_of(panel, step);
  return step.forward ? curve.start() : curve.end();
}

const Vec2& end_of(const PatternPanel& panel, const OutlineStep& step) {
  return begin_of(panel, {step.edge, !step.forward});
}

std::vector<Run> runs_of(const std::vector<OutlineStep>& outline, const std::vector<bool>& flags) {
  const auto flagged = [&](std::size_t step) {
    return flags[static_cast<std::size_t>(outline[step % outline.size()].edge)];
  };
  std::vector<Run> runs;
  for (std::size_t step = 0; step < outline.size(); ++step) {
    if (!flagged(step) || flagged(step + outline.size() - 1)) continue;
    Run run{step, 1};
    while (flagged(step + run.count)) ++run.count;
    runs.push_back(run);
  }
  return runs;
}

class Merger {
 public:
  explicit Merger(const Pattern& pattern) : pattern_(pattern) {
    for (const PatternPanel& panel : pattern.panels) {
      std::vector<bool>& flags = flags_.emplace_back();
      for (const PatternEdge& edge : panel.edges) {
        flags.push_back(edge.curve.length() < short_edge_length && !edge.elastic);
      }
    }
    // The other side of a short edge may be twice as long.
    for (const Stitch& stitch : pattern.stitches) {
      const std::array sides = {stitch.a, stitch.b};
      for (std::size_t k = 0; k < 2; ++k) {
        if (flag(sides[1 - k]) && curve_of(pattern, sides[k]).length() < 2 * short_edge_length) {
          flag(sides[k]) = !edge_at(sides[k]).elastic;
        }
      }
    }
  }

  bool any() const {
    return std::any_of(flags_.begin(), flags_.end(), [](const std::vector<bool>& flags) {
      return std::find(flags.begin(), flags.end(), true) != flags.end();
    });
  }

  /// The pattern with short edges merged. It takes flags back until the rest can be merged.
  Pattern merged(Takers& takers) {
    while (true) {
      while (take_back_halves() || take_back_long_runs()) {
      }
      takers.clear();
      Pattern result = pattern_;
      if (merge_panels(result, takers) && keeps_joined(result, takers)) return result;
    }
  }

  bool is_merged(const EdgeRef& ref) const {
    return flags_[static_cast<std::size_t>(ref.panel)][static_cast<std::size_t>(ref.edge)];
  }

 private:
  std::vector<bool>::reference flag(const EdgeRef& ref) {
    return flags_[static_cast<std::size_t>(ref.panel)][static_cast<std::size_t>(ref.edge)];
  }
  const PatternEdge& edge_at(const EdgeRef& ref) const {
    return pattern_.panels[static_cast<std::size_t>(ref.panel)]
        .edges[static_cast<std::size_t>(ref.edge)];
  }

  /// A stitch is left out as a whole or not at all.
  bool take_back_halves() {
    bool changed = false;
    for (const Stitch& stitch : pattern_.stitches) {
      if (flag(stitch.a) == flag(stitch.b)) continue;
      flag(stitch.a) = flag(stitch.b) = false;
      changed = true;
    }
    return changed;
  }

  /// Short edges in a row are a curve that is drawn so.
  bool take_back_long_runs() {
    bool changed = false;
    for (std::size_t p = 0; p < pattern_.panels.size(); ++p) {
      const PatternPanel& panel = pattern_.panels[p];
      const std::vector<Run> runs = runs_of(panel.outline, flags_[p]);
      const auto flagged = std::count(flags_[p].begin(), flags_[p].end(), true);
      if (flagged > 0 && static_cast<std::size_t>(flagged) + 3 > panel.outline.size()) {
        flags_[p].assign(flags_[p].size(), false);
        changed = true;
        continue;
      }
      for (const Run& run : runs) {
        double length = 0;
        for (std::size_t k = 0; k < run.count; ++k) length += curve_at(panel, run, k).length();
        if (length <= 2 * short_edge_length) continue;
        take_back(p, run);
        changed = true;
      }
    }
    return changed;
  }

  static const OutlineStep& step_at(const PatternPanel& panel, const Run& run, std::size_t k) {
    return panel.outline[(run.first + k) % panel.outline.size()];
  }
  static const EdgeCurve& curve_at(const PatternPanel& panel, const Run& run, std::size_t k) {
    return curve_of(panel, step_at(panel, run, k));
  }

  void take_back(std::size_t panel, const Run& run) {
    for (std::size_t k = 0; k < run.count; ++k) {
      flags_[panel][static_cast<std::size_t>(step_at(pattern_.panels[panel], run, k).edge)] = false;
    }
  }

  /// False when some runs cannot be merged: their flags are taken back.
  bool merge_panels(Pattern& result, Takers& takers) {
    bool all_merged = true;
    for (std::size_t p = 0; p < result.panels.size(); ++p) {
      PatternPanel& panel = result.panels[p];
      const std::vector<Run> runs = runs_of(panel.outline, flags_[p]);
      const std::vector<bool> flags = flags_[p];
      for (const Run& run : runs) {
        if (merge_run(p, run, panel, takers)) continue;
        take_back(p, run);
        all_merged = false;
      }
      std::erase_if(panel.outline, [&](const OutlineStep& step) {
        return flags[static_cast<std::size_t>(step.edge)];
      });
      if (all_merged && !runs.empty() && first_crossing(outline_polygon(panel).points)) {
        for (const Run& run : runs) take_back(p, run);
        all_merged = false;
      }
    }
    std::erase_if(result.stitches, [&](const Stitch& stitch) { return is_merged(stitch.a); });
    return all_merged;
  }

  /// Moves the end of a neighbour over a run. False when both would move the outline too far.
  bool merge_run(std::size_t p, const Run& run, PatternPanel& panel, Takers& takers) const {
    const std::size_t count = panel.outline.size();
    const OutlineStep before = panel.outline[(run.first + count - 1) % count];
    const OutlineStep after = panel.outline[(run.first + run.count) % count];
    std::vector<Vec2> drawn;
    for (std::size_t k = 0; k < run.count; ++k) {
      drawn.push_back(begin_of(panel, step_at(panel, run, k)));
    }
    drawn.push_back(begin_of(panel, after));
    const auto sewn = [&](int edge) {
      return std::any_of(pattern_.stitches.begin(), pattern_.stitches.end(), [&](const Stitch& s) {
        const auto here = [&](const EdgeRef& ref) {
          return ref.panel == static_cast<int>(p) && ref.edge == edge;
        };
        return here(s.a) || here(s.b);
      });
    };
    std::optional<EdgeCurve> best;
    OutlineStep taker;
    double least = std::numeric_limits<double>::infinity();
    for (const OutlineStep& step : {after, before}) {
      const bool is_after = step.edge == after.edge;
      Vec2 from = is_after ? drawn.front() : begin_of(panel, step);
      Vec2 to = is_after ? end_of(panel, step) : drawn.back();
      if (!step.forward) std::swap(from, to);
      const EdgeCurve& curve = curve_of(panel, step);
      if ((curve.end() - curve.start()).norm() < short_edge_length) continue;
      const EdgeCurve moved = curve.moved_to(from, to);
      double shift = shift_between(drawn, curve, moved);
      if (shift > max_outline_shift) continue;
      // Of two that shift alike, the one that is sewn as the short edge is.
      if (sewn(step.edge) != sewn(step_at(panel, run, 0).edge)) {
        shift += 0.1 * (drawn.back() - drawn.front()).norm();
      }
      if (shift >= least) continue;
      least = shift;
      best = moved;
      taker = step;
    }
    if (!best) return false;
    panel.edges[static_cast<std::size_t>(taker.edge)].curve = *best;
    const bool at_start = (taker.edge == after.edge) == taker.forward;
    for (std::size_t k = 0; k < run.count; ++k) {
      const int edge = step_at(panel, run, k).edge;
      takers[{static_cast<int>(p), edge}] = taker.edge;
      for (PanelAttachment& attached : panel.attachments) {
        if (attached.edge != edge) continue;
        attached.edge = taker.edge;
        attached.share = at_start ? PanelAttachment::Share::start : PanelAttachment::Share::end;
      }
    }
    return true;
  }

  /// How far the old outline lies from the new one, metres.
  static double shift_between(std::vector<Vec2> drawn, const EdgeCurve& before,
                              const EdgeCurve& after) {
    constexpr int segments = 64;
    const std::vector<Vec2> old_points = before.sample(segments);
    const std::vector<Vec2> new_points = after.sample(segments);
    drawn.insert(drawn.end(), old_points.begin(), old_points.end());
    double farthest = 0;
    for (const Vec2& point : drawn) {
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < segments; ++i) {
        nearest = std::min(nearest, distance_to_segment(point, new_points[i], new_points[i + 1]));
      }
      farthest = std::max(farthest, nearest);
    }
    return farthest;
  }

  /// Whether what the left out stitches joined is still joined. If not, their flags are taken back.
  bool keeps_joined(const Pattern& result, const Takers& takers) {
    if (result.stitches.size() == pattern_.stitches.size()) return true;
    SewnCorners corners(result);
    const auto corner = [&](const EdgeRef& ref) {
      const int taker = takers.at({ref.panel, ref.edge});
      // The short edge is now the end of its taker that is nearer.
      const EdgeCurve& curve = curve_of(result, {ref.panel, taker});
      const Vec2 point = curve_of(pattern_, ref).start();
      const std::array<int, 2> ends = corners.ends({ref.panel, taker});
      return (curve.start() - point).norm() < (curve.end() - point).norm() ? ends[0] : ends[1];
    };
    bool all_joined = true;
    for (const Stitch& stitch : pattern_.stitches) {
      if (!is_merged(stitch.a) || corner(stitch.a) == corner(stitch.b)) continue;
      flag(stitch.a) = flag(stitch.b) = false;
      all_joined = false;
    }
    return all_joined;
  }

  const Pattern& pattern_;
  EdgeFlags flags_;
};

}  // namespace

void merge_short_edges(Pattern& pattern, std::vector<Remark>& remarks) {
  const auto stitch_of = stitch_of_edge(pattern);
  if (!stitch_of) return;
  Merger merger(pattern);
  if (!merger.any()) return;
  Takers takers;
  Pattern result = merger.merged(takers);
  const auto named = [&](const EdgeRef& ref) {
    return edge_name(pattern, ref) + " (" + number_text(curve_of(pattern, ref).length() * 1000, 2) +
           " mm)";
  };
  const auto taker = [&](const EdgeRef& ref) {
    return std::to_string(takers.at({ref.panel, ref.edge}));
  };
  for (const auto& [key, taken_by] : takers) {
    const EdgeRef ref{key[0], key[1]};
    const auto sewn = stitch_of->find(key);
    std::string text = pattern.source + ": " + named(ref);
    if (sewn == stitch_of->end()) {
      text += " is too short to mesh; it is merged with edge " + std::to_string(taken_by);
    } else {
      const EdgeRef& other = sewn->second.other;
      if (std::array{other.panel, other.edge} < key) continue;
      text += " and " + named(other) + ", sewn together, are too short to mesh; they are " +
              "merged with edges " + std::to_string(taken_by) + " and " + taker(other);
    }
    remarks.push_back({true, text});
  }
  pattern = std::move(result);
}

}  // namespace toile
