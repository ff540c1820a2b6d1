// Where the legs part, by the width of the gap below.
#pragma once

#include <optional>

#include "geometry/types.h"

namespace toile {

/// Where to look for the crotch, in metres, in a frame with left at +x, front at +z and up at +y.
struct CrotchSearch {
  Vec3 left;          ///< in the middle of the left thigh
  Vec3 right;         ///< in the middle of the right thigh
  Vec3 near;          ///< in the middle of the trunk, where the legs' sections touch the lowest
  double height = 0;  ///< of the body
};

/// The lowest point of the trunk between the legs.
///
/// Level lines from thigh to thigh measure the air between them. From above, the first air that
/// lasts ends at the crotch. So a film between the thighs and thighs that touch below don't move
/// it. The perineum is nearly flat, so its depth is the mean of what is lowest. Nothing where no
/// air is seen. Costs some 50 slices.
std::optional<Vec3> find_crotch(const TriangleMesh& body, const CrotchSearch& search);

}  // namespace toile
