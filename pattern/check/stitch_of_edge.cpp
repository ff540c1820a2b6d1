#include "pattern/check/stitch_of_edge.h"

namespace toile {

std::optional<std::map<std::array<int, 2>, EdgeStitch>> stitch_of_edge(const Pattern& pattern) {
  std::map<std::array<int, 2>, EdgeStitch> stitch_of;
  for (std::size_t s = 0; s < pattern.stitches.size(); ++s) {
    const Stitch& stitch = pattern.stitches[s];
    const int number = static_cast<int>(s);
    const auto add = [&](const EdgeRef& ref, const EdgeRef& other) {
      return stitch_of.try_emplace({ref.panel, ref.edge}, EdgeStitch{number, other}).second;
    };
    if (!add(stitch.a, stitch.b) || !add(stitch.b, stitch.a)) return {};
  }
  return stitch_of;
}

}  // namespace toile
