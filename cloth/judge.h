// The verdict on a dressed garment: every figure of the report, measured on what was written.
#pragma once

#include <string>
#include <vector>

#include "cloth/measures.h"
#include "cloth/wraps.h"

namespace toile {

struct Judgement {
  GarmentFigures garment;
  std::vector<WrapFigure> wraps;
  int body_intersections = 0;   ///< pairs of a garment's and a body's triangle
  int self_intersections = 0;   ///< pairs of the garment's triangles
  int layer_intersections = 0;  ///< pairs of a garment's and a lower layer's triangle
  std::string verdict;          ///< sewn, unsewable, unconverged or intersecting
};

/// Measures the dressed garment against its pattern and the body, intersections with exact
/// predicates; `layers` is the cloth below it, null: none. `skeleton` may be null: then nothing is
/// said of wraps. Of several things that are wrong the verdict names the first of: seams open,
/// intersections, no rest.
Judgement judge(const PanelMesh& pattern, const DressedGarment& dressed, const TriangleMesh& body,
                const Skeleton* skeleton, bool converged, const TriangleMesh* layers = nullptr);

}  // namespace toile
