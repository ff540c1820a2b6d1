// The verdict on a dressed garment, measured on the garment as written.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cloth/judge/asymmetry.h"
#include "cloth/judge/fit.h"
#include "cloth/judge/measures.h"
#include "cloth/judge/slits.h"
#include "cloth/judge/tight_seams.h"
#include "cloth/judge/wear_check.h"
#include "cloth/judge/wraps.h"

namespace toile {

/// What a dressing came to. When several apply, the verdict is the first in this order. A program
/// that dresses ends with exit code 0 for `sewn` and 3 for every other verdict.
enum class Verdict : std::uint8_t {
  unsewable,     ///< a seam stands open
  intersecting,  ///< the cloth meets the body, a lower layer or itself
  misplaced,     ///< worn where it does not belong
  unwrapped,     ///< it does not go around a body part at which it lies
  unconverged,   ///< the garment did not come to rest
  unstable,      ///< it came to rest, and did not stay when it was let go
  too_tight,     ///< a seam is closed against more than a hand's pull, or cloth is overstretched
  sewn,          ///< none of these: the garment is dressed
};

/// The verdict's word, as reports and messages have it.
std::string to_string(Verdict verdict);

struct Judgement {
  GarmentMeasurements garment;
  std::vector<WrapMeasurement> wraps;
  WearFindings worn;
  std::vector<Slit> slits;
  std::vector<BandEnd> band_ends;
  std::optional<Asymmetry> asymmetry;  ///< none: the pattern is not symmetric, or no skeleton
  std::vector<std::string> on_floor;   ///< names of panels that lie on the floor
  Fit fit;                             ///< apart from the verdict
  std::vector<GarmentLevel> levels;    ///< of the garment; empty: no skeleton
  double height_error = 0;             ///< metres, of their heights
  int body_intersections = 0;          ///< pairs of a garment's and a body's triangle
  int self_intersections = 0;          ///< pairs of the garment's triangles
  int layer_intersections = 0;         ///< pairs of a garment's and a lower layer's triangle
  Verdict verdict = Verdict::sewn;
};

/// What a dressing says about its end.
struct DressingEnd {
  bool converged = true;                    ///< by the static criterion
  std::optional<bool> stays = {};           ///< when let go; none: not asked for
  std::vector<TightSeam> tight_seams = {};  ///< closed against more than a hand's pull
  /// Metres: cloth that is no higher lies on the floor; none: there is no floor.
  std::optional<double> on_floor = {};
};

/// Measures the dressed garment against its pattern and the body, with exact predicates for
/// intersections. `layers` is the cloth below it; null: none. Without a `skeleton` (null) neither
/// wraps, where the garment is worn nor its fit are measured. Throws Error when garment and pattern
/// have different faces. About O(n log n) in the triangles of cloth and body.
Judgement judge(const PanelMesh& pattern, const DressedGarment& dressed, const TriangleMesh& body,
                const Skeleton* skeleton, const DressingEnd& end,
                const TriangleMesh* layers = nullptr);

}  // namespace toile
