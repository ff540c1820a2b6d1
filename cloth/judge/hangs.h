// Which way up the panels of a dressed garment hang, and whether their cloth is folded upon itself.
#pragma once

#include <vector>

#include "geometry/body/skeleton.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// How a panel hangs.
struct PanelHang {
  double area = 0;    ///< m², flat
  double folded = 0;  ///< m² that hang upside down and turn their outside to the body
  /// Mean slope of the height over the flat panel: of length 1 where it hangs straight, 0 where it
  /// lies level.
  Vec2 worn{0, 0};
  Vec2 placed{0, 0};  ///< the same of where the panel started

  /// Whether it hangs upside down, compared with how it started.
  bool is_turned() const;
};

/// The hang of each panel. Cloth of a fold lies in three layers. The middle one runs down where its
/// panel runs up, and faces the bones where the other layers face away. The back of a poncho runs
/// down, too, and faces away. Half of the garment's cloth and more counts as facing away.
/// `skeleton` has all limbs. Linear in the triangles.
std::vector<PanelHang> measure_hangs(const PanelMesh& garment, const DressedGarment& dressed,
                                     const Skeleton& skeleton);

}  // namespace toile
