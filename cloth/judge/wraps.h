// How far the panels of a body part go around it.
#pragma once

#include <string>
#include <vector>

#include "geometry/body/skeleton.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// The share of the directions square to a part's bones that meets the panels of that part. It is
/// taken over the stretch of bone at which they lie as worn.
struct WrapMeasurement {
  BodyPart part = BodyPart::none;
  double from = 0;  ///< metres along the bones from the part's first joint; negative before it
  double to = 0;    ///< metres along the bones from the first joint
  double fraction = 0;
};

/// Measures how far some panels go around a part. `is_counted` has an entry for each panel, 0 for
/// those that play no part. The stretch is the middle half of where the panels
/// lie. Cloth above the armpits plays no part, nor cloth of limbs nearer than armpit or crotch.
/// Where nothing is left, `fraction` is 0. Linear in the triangles times 32 stations.
WrapMeasurement measure_wrap(const DressedGarment& dressed, const Skeleton& skeleton, BodyPart part,
                             const std::vector<char>& is_counted);

/// The same of every part that panels belong to (panel_parts.h).
std::vector<WrapMeasurement> measure_wraps(const PanelMesh& garment, const DressedGarment& dressed,
                                           const Skeleton& skeleton);

/// A level of the trunk, and the share of the directions around it that meet some panels.
struct BareLevel {
  double height = 0;  ///< metres above the floor
  double share = 1;
};

/// The level at which some panels go the least way around the trunk. Heights `low` and `high` are
/// in metres; the middle half of what lies between them counts. Costs as measure_wrap().
BareLevel barest_level(const DressedGarment& dressed, const Skeleton& skeleton,
                       const std::vector<char>& is_counted, double low, double high);

}  // namespace toile
