#include "pattern/check/left_out.h"

#include "geometry/error.h"

namespace toile {

Pattern without_left_out(Pattern pattern, std::vector<Remark>& remarks) {
  std::vector<int> number(pattern.panels.size(), -1);  // of a panel among those that stay
  std::vector<PatternPanel> kept;
  std::string names;
  for (std::size_t p = 0; p < pattern.panels.size(); ++p) {
    PatternPanel& panel = pattern.panels[p];
    if (panel.left_out.empty()) {
      number[p] = static_cast<int>(kept.size());
      kept.push_back(std::move(panel));
    } else {
      names += (names.empty() ? " " : ", ") + panel.name + " (" + panel.left_out + ")";
    }
  }
  if (kept.empty()) {
    throw Error(pattern.source, "leaves out all of its panels",
                "remove 'left_out' from those that the garment is sewn of");
  }
  if (!names.empty()) remarks.push_back({false, pattern.source + ": left out:" + names});
  std::vector<Stitch> stitches;
  for (Stitch& stitch : pattern.stitches) {
    stitch.a.panel = number[static_cast<std::size_t>(stitch.a.panel)];
    stitch.b.panel = number[static_cast<std::size_t>(stitch.b.panel)];
    if (stitch.a.panel >= 0 && stitch.b.panel >= 0) stitches.push_back(std::move(stitch));
  }
  const std::size_t lost = pattern.stitches.size() - stitches.size();
  if (lost > 0) {
    remarks.push_back({true, pattern.source + ": " + std::to_string(lost) +
                                 (lost == 1 ? " stitch holds a panel" : " stitches hold panels") +
                                 " that is left out; " + (lost == 1 ? "it is" : "they are") +
                                 " not sewn"});
  }
  pattern.panels = std::move(kept);
  pattern.stitches = std::move(stitches);
  return pattern;
}

}  // namespace toile
