// Corners of panels that come together in one point of the garment.
#pragma once

#include <array>
#include <vector>

#include "pattern/seams/seam_candidates.h"

namespace toile {

/// One end of a candidate: 0 is where side a starts and side b ends, 1 is the other.
struct SeamEnd {
  int candidate = 0;
  int end = 0;
};

/// One end of an edge: 0 is its start on the walk, 1 its end.
struct EdgeEnd {
  int edge = 0;
  int end = 0;
};

/// Corners that meet where these candidates are sewn, and these edges stay open. Inside the garment
/// nothing is open; on its border two edges are.
struct CornerGroup {
  std::vector<SeamEnd> seams;
  std::vector<EdgeEnd> open;
  double worth = 0;
};

/// The groups of up to four corners that close about flat: to 360 degrees inside the garment, to
/// 180 on its border. A dart's tip is a group of its own. Cost grows with the fourth power of the
/// candidates that an edge has.
std::vector<CornerGroup> corner_groups(const SeamEvidence& evidence,
                                       const std::vector<SeamCandidate>& candidates,
                                       const SeamMeasures& weights);

}  // namespace toile
