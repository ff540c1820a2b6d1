// Holes that are cut into a panel: which of them a mesh can show, and their edges.
#pragma once

#include <string>
#include <vector>

#include "pattern/pattern.h"

namespace toile {

/// A hole, by its edge from corner to corner, in the drawing. Each curve starts where the one
/// before it ends, and the first where the last ends.
struct CutOut {
  int index = 0;  ///< into PatternPanel::cut_outs
  std::vector<EdgeCurve> curves;
};

/// The panel's cut-outs that triangles of about `edge_length` metres can show. A warning names each
/// other one and says why: it crosses itself, the outline or another one, or lies outside. Or it is
/// smaller than a triangle, or narrower than a quarter of an edge. `place` names the panel in
/// warnings. O(n m) for n points of cut-outs and m of the outline.
std::vector<CutOut> cut_outs_to_mesh(const PatternPanel& panel, double edge_length,
                                     const std::string& place, std::vector<Remark>& remarks);

}  // namespace toile
