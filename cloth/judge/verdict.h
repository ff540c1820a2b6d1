// The verdict on a dressed garment: every figure of the report, measured on what was written.
#pragma once

#include <string>
#include <vector>

#include "cloth/judge/measures.h"
#include "cloth/judge/tight_seams.h"
#include "cloth/judge/wraps.h"

namespace toile {

struct Judgement {
  GarmentFigures garment;
  std::vector<WrapFigure> wraps;
  int body_intersections = 0;   ///< pairs of a garment's and a body's triangle
  int self_intersections = 0;   ///< pairs of the garment's triangles
  int layer_intersections = 0;  ///< pairs of a garment's and a lower layer's triangle
  /// Seams that are open, or closed against more than a hand's pull; with what is missing.
  std::vector<OpenSeam> unsewable_seams;
  std::vector<std::string> unwrapped;  ///< parts that a tube should go around and doesn't
  std::string verdict;                 ///< sewn, unsewable, intersecting, unwrapped or unconverged
};

/// A tube goes around a part when it meets that share of the directions square to its bones; cloth
/// that only lies on one side of it meets half of them at most.
inline constexpr double around_share = 0.5;

/// Measures the dressed garment against its pattern and the body, intersections with exact
/// predicates; `layers` is the cloth below it, null: none. `skeleton` may be null: then nothing is
/// said of wraps. `tight` are the seams that were closed by force. Of several things that are wrong
/// the verdict names the first of: seams open or tight, intersections, parts not wrapped, no rest.
Judgement judge(const PanelMesh& pattern, const DressedGarment& dressed, const TriangleMesh& body,
                const Skeleton* skeleton, bool converged, const TriangleMesh* layers = nullptr,
                const std::vector<TightSeam>& tight = {});

}  // namespace toile
