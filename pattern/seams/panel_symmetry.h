// Which panels have the same shape, and which are mirror images of each other.
#pragma once

#include <vector>

#include "pattern/seams/panel_words.h"
#include "pattern/seams/walked_edges.h"

namespace toile {

/// A panel laid onto another one, or onto itself, so that they coincide.
struct PanelFit {
  int from = 0;  ///< panel
  int to = 0;    ///< panel
  bool mirrored = false;
  /// Per edge of `from`, in the order of its outline: the edge that it lies on. -1: the other
  /// outline is split elsewhere.
  std::vector<int> image;
};

/// All ways to lay panels onto panels. Outlines lie within two millimetres of each other, wherever
/// they are split into edges. A panel lies on itself in one way at least. O(edges^2).
std::vector<PanelFit> panel_fits(const std::vector<WalkedEdge>& edges);

/// What the fits say of single edges.
struct EdgeShapes {
  /// Per edge: the lowest edge that some fits lay it onto. Edges of one shape are told apart by
  /// their neighbours alone.
  std::vector<int> shape;
  /// Per edge: +1 or -1, whether it lies on the edge `shape` as drawn or mirrored; 0: both.
  std::vector<int> hand;
};
EdgeShapes edge_shapes(const std::vector<WalkedEdge>& edges, const std::vector<PanelFit>& fits);

/// Per edge: its partner on the other half of the garment, the edge itself included; -1: not known.
/// Pairs are told by the names of left and right, or where two panels alone are mirror images. A
/// panel that names no side lies on itself where it is its own mirror image.
std::vector<int> mirror_partners(const std::vector<WalkedEdge>& edges,
                                 const std::vector<PanelFit>& fits,
                                 const std::vector<PanelWords>& words);

}  // namespace toile
