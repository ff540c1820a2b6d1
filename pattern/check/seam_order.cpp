#include "pattern/check/seam_order.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "pattern/check/stitch_of_edge.h"
#include "pattern/mesh/seam_orientation.h"

namespace toile {

namespace {

/// A stitch in a row of them.
struct Place {
  int stitch = 0;
  EdgeRef here;
  EdgeRef other;
  int other_step = 0;    ///< step of the other panel's outline
  bool against = false;  ///< the outlines run against each other
};

double edge_length_of(const Pattern& pattern, const EdgeRef& ref) {
  return pattern.panels[ref.panel].edges[ref.edge].curve.length();
}

/// The first of the row's steps on the other panel, whose outline has `count`; -1 when they are not
/// in a row there.
int first_of_row(const std::vector<Place>& row, int count) {
  std::set<int> taken;
  for (const Place& place : row) taken.insert(place.other_step);
  int first = -1;
  for (const int step : taken) {
    if (taken.contains((step + count - 1) % count)) continue;
    if (first >= 0) return -1;
    first = step;
  }
  return first;
}

/// Whether the places on the other panel pass along its outline one by one, from its step `first`.
bool in_order(const std::vector<Place>& row, int first, int count) {
  const auto against = std::ranges::count_if(row, &Place::against);
  const bool down = 2 * static_cast<std::size_t>(against) > row.size();
  const int size = static_cast<int>(row.size());
  for (int i = 0; i < size; ++i) {
    const int along = (row[i].other_step - first + count) % count;
    if (along != (down ? size - 1 - i : i)) return false;
  }
  return true;
}

bool is_plain(const PatternPanel& panel, int edge) {
  return !panel.edges[edge].elastic &&
         std::ranges::none_of(panel.attachments, [&](const PanelAttachment& attached) {
           return attached.edge == edge;
         });
}

/// "edges 1, 2, 3 of panel 'front'", in the order of the outline.
std::string text_of_row(const PatternPanel& panel, int first, int count) {
  std::string text = "edges ";
  for (int i = 0; i < count; ++i) {
    if (i > 0) text += ", ";
    text += std::to_string(panel.outline[(first + i) % panel.outline.size()].edge);
  }
  return text + " of panel '" + panel.name + "'";
}

/// A row of an outline's steps that one edge takes in.
struct TakenRow {
  int panel = 0;
  int first = 0;  ///< step of the outline
  int count = 0;
  int taker = 0;  ///< index of the edge
};

void take_in(const TakenRow& row, PatternPanel& panel) {
  std::vector<EdgeCurve> parts;
  bool forward = true;
  for (int i = 0; i < row.count; ++i) {
    const OutlineStep& step = panel.outline[(row.first + i) % panel.outline.size()];
    const EdgeCurve& curve = panel.edges[step.edge].curve;
    parts.push_back(step.forward ? curve : curve.reversed());
    if (step.edge == row.taker) forward = step.forward;
  }
  const EdgeCurve whole = EdgeCurve::chain(std::move(parts));
  panel.edges[row.taker].curve = forward ? whole : whole.reversed();
}

}  // namespace

void sew_crossed_rows_as_one(Pattern& pattern, std::vector<Remark>& remarks) {
  const auto stitch_of = stitch_of_edge(pattern);
  if (!stitch_of) return;
  std::vector<Remark> said_elsewhere;
  const Orientation orientation = orient(pattern, said_elsewhere);
  std::vector<std::map<int, int>> step_of(pattern.panels.size());  // per panel: of an edge
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    const std::vector<OutlineStep>& outline = pattern.panels[p].outline;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      step_of[p][outline[i].edge] = static_cast<int>(i);
    }
  }
  std::vector<TakenRow> taken;
  std::set<int> left_out;                // stitches
  std::set<std::array<int, 2>> dropped;  // panel and edge
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    const PatternPanel& panel = pattern.panels[p];
    const int count = static_cast<int>(panel.outline.size());
    const auto other_of = [&](int i) {
      const auto found = stitch_of->find({static_cast<int>(p), panel.outline[i % count].edge});
      return found == stitch_of->end() ? -1 : found->second.other.panel;
    };
    for (int first = 0; first < count; ++first) {
      const int other = other_of(first);
      // Each pair of panels once, from the one with the lower number.
      if (other <= static_cast<int>(p) || other_of(first + count - 1) == other) continue;
      const PatternPanel& beside = pattern.panels[other];
      std::vector<Place> row;
      for (int i = first; other_of(i) == other && i < first + count; ++i) {
        const OutlineStep& step = panel.outline[i % count];
        const EdgeRef here{static_cast<int>(p), step.edge};
        const auto& [stitch, ref] = stitch_of->at({here.panel, here.edge});
        const int other_step = step_of[other].at(ref.edge);
        const bool alike = step.forward == beside.outline[other_step].forward;
        row.push_back({stitch, here, ref, other_step, alike == orientation.reversed[stitch]});
      }
      const int other_count = static_cast<int>(beside.outline.size());
      const int other_first = first_of_row(row, other_count);
      if (row.size() < 3 || other_first < 0 || in_order(row, other_first, other_count)) continue;
      if (!std::ranges::all_of(row, [&](const Place& place) {
            return is_plain(panel, place.here.edge) && is_plain(beside, place.other.edge);
          })) {
        continue;
      }
      const Place& longest = *std::ranges::max_element(row, {}, [&](const Place& place) {
        return std::min(edge_length_of(pattern, place.here), edge_length_of(pattern, place.other));
      });
      const int size = static_cast<int>(row.size());
      taken.push_back({static_cast<int>(p), first, size, longest.here.edge});
      taken.push_back({other, other_first, size, longest.other.edge});
      for (const Place& place : row) {
        if (place.stitch == longest.stitch) continue;
        left_out.insert(place.stitch);
        dropped.insert({place.here.panel, place.here.edge});
        dropped.insert({place.other.panel, place.other.edge});
      }
      remarks.push_back({true, pattern.source + ": " + text_of_row(panel, first, size) + " and " +
                                   text_of_row(beside, other_first, size) +
                                   " are sewn to each other out of order; each row is sewn as one "
                                   "edge, as " +
                                   std::to_string(longest.here.edge) + " to " +
                                   std::to_string(longest.other.edge)});
    }
  }
  for (const TakenRow& row : taken) take_in(row, pattern.panels[row.panel]);
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    std::erase_if(pattern.panels[p].outline, [&](const OutlineStep& step) {
      return dropped.contains({static_cast<int>(p), step.edge});
    });
  }
  std::vector<Stitch> kept;
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    if (!left_out.contains(static_cast<int>(s))) kept.push_back(pattern.stitches[s]);
  }
  pattern.stitches = std::move(kept);
}

}  // namespace toile
