#include "pattern/seam_order.h"

#include <algorithm>
#include <map>

#include "pattern/seam_orientation.h"
#include "pattern/stitch_of_edge.h"

namespace toile {

namespace {

/// A stitch in a row of them: where its side on the other panel lies.
struct Place {
  int stitch = 0;
  int other_step = 0;    ///< step of the other panel's outline
  double length = 0;     ///< metres, of the other side
  bool against = false;  ///< the outlines run against each other
};

/// The longest part of the row whose places go up or down, as flags.
std::vector<bool> in_order(const std::vector<Place>& row, bool down) {
  std::vector<double> length(row.size());
  std::vector<int> before(row.size(), -1);
  for (std::size_t i = 0; i < row.size(); ++i) {
    length[i] = row[i].length;
    for (std::size_t k = 0; k < i; ++k) {
      if ((row[k].other_step > row[i].other_step) != down) continue;
      if (length[k] + row[i].length <= length[i]) continue;
      length[i] = length[k] + row[i].length;
      before[i] = static_cast<int>(k);
    }
  }
  std::vector<bool> kept(row.size(), false);
  for (int i = static_cast<int>(std::max_element(length.begin(), length.end()) - length.begin());
       i >= 0; i = before[static_cast<std::size_t>(i)]) {
    kept[static_cast<std::size_t>(i)] = true;
  }
  return kept;
}

/// Turns the steps of a row around a loop of `count` into a range without a jump. False when they
/// are not in a row there.
bool in_a_row(std::vector<Place>& row, int count) {
  std::vector<bool> taken(static_cast<std::size_t>(count), false);
  for (const Place& place : row) taken[static_cast<std::size_t>(place.other_step)] = true;
  int first = -1;
  for (int step = 0; step < count; ++step) {
    if (!taken[static_cast<std::size_t>(step)] ||
        taken[static_cast<std::size_t>((step + count - 1) % count)]) {
      continue;
    }
    if (first >= 0) return false;
    first = step;
  }
  if (first < 0) return false;
  for (Place& place : row) place.other_step = (place.other_step - first + count) % count;
  return true;
}

}  // namespace

void leave_out_crossed_stitches(Pattern& pattern, std::vector<Remark>& remarks) {
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
  std::vector<bool> crossed(pattern.stitches.size(), false);
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    const std::vector<OutlineStep>& outline = pattern.panels[p].outline;
    const int count = static_cast<int>(outline.size());
    const auto other_of = [&](int i) {
      const auto found = stitch_of->find({static_cast<int>(p), outline[i % count].edge});
      return found == stitch_of->end() ? -1 : found->second.other.panel;
    };
    for (int first = 0; first < count; ++first) {
      const int other = other_of(first);
      // Each pair of panels once, from the one with the lower number.
      if (other <= static_cast<int>(p) || other_of(first + count - 1) == other) continue;
      std::vector<Place> row;
      for (int i = first; other_of(i) == other && i < first + count; ++i) {
        const OutlineStep& step = outline[i % count];
        const auto& [stitch, ref] = stitch_of->at({static_cast<int>(p), step.edge});
        const PatternPanel& panel = pattern.panels[other];
        const int other_step = step_of[other].at(ref.edge);
        const bool alike = step.forward == panel.outline[other_step].forward;
        row.push_back({stitch, other_step, panel.edges[ref.edge].curve.length(),
                       alike == orientation.reversed[stitch]});
      }
      const auto against =
          std::count_if(row.begin(), row.end(), [](const Place& place) { return place.against; });
      if (row.size() < 3 ||
          !in_a_row(row, static_cast<int>(pattern.panels[other].outline.size()))) {
        continue;
      }
      const std::vector<bool> kept =
          in_order(row, 2 * static_cast<std::size_t>(against) > row.size());
      for (std::size_t i = 0; i < row.size(); ++i) crossed[row[i].stitch] = !kept[i];
    }
  }
  std::vector<Stitch> kept;
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    const Stitch& stitch = pattern.stitches[s];
    if (!crossed[s]) {
      kept.push_back(stitch);
      continue;
    }
    remarks.push_back({true, pattern.source + ": " + edge_name(pattern, stitch.a) + " and " +
                                 edge_name(pattern, stitch.b) +
                                 " are sewn out of order with the edges beside them; their stitch "
                                 "is left out"});
  }
  pattern.stitches = std::move(kept);
}

}  // namespace toile
