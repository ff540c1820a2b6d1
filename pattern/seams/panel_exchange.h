// Chooses among garments that are the same but for which of several equal panels is sewn where.
#pragma once

#include <vector>

#include "pattern/pattern.h"
#include "pattern/seams/panel_symmetry.h"
#include "pattern/seams/panel_words.h"
#include "pattern/seams/walked_edges.h"

namespace toile {

/// A seam between two edges. `along`: both are walked the same way, so that one of the panels is
/// turned over.
struct EdgeSeam {
  int a = 0;
  int b = 0;
  bool along = false;
};

/// Lets panels that coincide change places, and turns over panels that are their own mirror images.
/// Each such garment is the same cloth, or its mirror image. Fewer seams join left to right by the
/// panels' names afterwards, and fewer panels are turned over. With `by_place`, the placed ends of
/// seams come nearer instead. `mirror`: see mirror_partners().
void exchange_panels(const Pattern& pattern, const std::vector<WalkedEdge>& edges,
                     const std::vector<PanelFit>& fits, const std::vector<PanelWords>& words,
                     const std::vector<int>& mirror, bool by_place, std::vector<EdgeSeam>& seams);

}  // namespace toile
