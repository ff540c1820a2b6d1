// A drape beside another: of another size, fabric, body or method, or of an edited pattern.
#pragma once

#include <string>
#include <vector>

#include "io/view/viewer_page.h"
#include "tools/ease_map/report.h"

namespace toile {

/// A girth, an edge or a length that both drapes have. Metres.
struct FigureDifference {
  std::string what;  ///< "ease", "height" or "length"
  std::string name;  ///< of the figure, "hip"
  double here = 0;
  double there = 0;
  double error = 0;  ///< of the difference: both errors together, as of independent figures

  double difference() const { return here - there; }
  bool is_sure() const { return std::abs(difference()) > error; }
};

/// Eases of girths, heights of edges and lengths as worn, in the order of `here`.
std::vector<FigureDifference> differences(const EaseReport& here, const EaseReport& there);

/// The differences as a table. Those within their error are grey.
PageTable difference_table(const std::vector<FigureDifference>& differences,
                           const std::string& other);

/// What the gap, tension and pressure of each material point is more than at the same place of the
/// other drape. A place is the same where its panel has that name, at the same share of the panel's
/// width and height; sizes differ in those. Tension and pressure that differ within their error are
/// grey. Points of panels that the other garment lacks are grey, too. Empty where no panel has the
/// name of another's. Costs a search of the other panel's triangles a point.
std::vector<PageMap> difference_maps(const EaseReport& here, const EaseReport& there);

}  // namespace toile
