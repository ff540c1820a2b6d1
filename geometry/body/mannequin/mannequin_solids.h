// The solids that the mannequin is joined of.
#pragma once

#include <array>

#include "geometry/body/mannequin/loft.h"

namespace toile {

/// The main lofts of the mannequin. Arm and leg stand for both sides.
enum class MannequinPart { torso, neck, arm, leg };

/// Lofts and ellipsoids of a mannequin that stands on y = 0 and faces +z, metres. Those of arm and
/// leg, breast and buttock are of the left side; the right side is its mirror image.
struct MannequinSolids {
  std::array<Loft, 4> parts;  ///< in the order of MannequinPart
  Loft yoke;
  Loft thumb;
  Loft foot;
  Ellipsoid breast;
  Ellipsoid buttock;
  Ellipsoid cranium;
  Ellipsoid jaw;
  Ellipsoid nose;
  double size = 1;  ///< of the fillets between them, 1 for the sample

  const Loft& part(MannequinPart which) const { return parts[static_cast<std::size_t>(which)]; }
  Loft& part(MannequinPart which) { return parts[static_cast<std::size_t>(which)]; }
};

/// The tables of a woman 1.70 m tall, not yet scaled to girths.
MannequinSolids mannequin_tables();

}  // namespace toile
