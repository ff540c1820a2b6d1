// The verdict on a dressed garment, from figures measured on the garment as written.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cloth/judge/measures.h"
#include "cloth/judge/tight_seams.h"
#include "cloth/judge/wraps.h"

namespace toile {

/// What a dressing came to. When several apply, the verdict is the first in this order. A program
/// that dresses ends with exit code 0 for `sewn` and 3 for every other verdict.
enum class Verdict : std::uint8_t {
  unsewable,     ///< a seam is open, or closed against more than a hand's pull
  intersecting,  ///< the cloth meets the body, a lower layer or itself
  unwrapped,     ///< a tube does not go around its body part
  unconverged,   ///< the garment did not come to rest
  sewn,          ///< none of these: the garment is dressed
};

/// The verdict's word, as reports and messages have it.
std::string to_string(Verdict verdict);

struct Judgement {
  GarmentFigures garment;
  std::vector<WrapFigure> wraps;
  int body_intersections = 0;   ///< pairs of a garment's and a body's triangle
  int self_intersections = 0;   ///< pairs of the garment's triangles
  int layer_intersections = 0;  ///< pairs of a garment's and a lower layer's triangle
  /// Seams that are open, or closed against more than a hand's pull, with the centimetres that are
  /// missing.
  std::vector<OpenSeam> unsewable_seams;
  std::vector<std::string> unwrapped;  ///< body parts that a tube should go around and does not
  Verdict verdict = Verdict::sewn;
};

/// Measures the dressed garment against its pattern and the body, with exact predicates for
/// intersections. `layers` is the cloth below it; null: none. Without a `skeleton` (null) no wraps
/// are measured. `tight` are the seams that were closed by force. Throws Error when garment and
/// pattern have different faces. About O(n log n) in the triangles of cloth and body.
Judgement judge(const PanelMesh& pattern, const DressedGarment& dressed, const TriangleMesh& body,
                const Skeleton* skeleton, bool converged, const TriangleMesh* layers = nullptr,
                const std::vector<TightSeam>& tight = {});

}  // namespace toile
