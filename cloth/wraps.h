// What each tube of a garment encloses: the figure that tells a shirt from a scarf.
#pragma once

#include <string>
#include <vector>

#include "geometry/body/skeleton.h"
#include "pattern/garment_file.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// The body part that each panel belongs to: what the pattern says, else the part whose bones lie
/// nearest to the middle of the panel as placed. A panel in front of both legs belongs to the
/// torso, which a skirt hangs from.
std::vector<std::string> panel_parts(const PanelMesh& garment, const Skeleton& skeleton);

/// Of the directions square to a part's bones, the share that meets the panels of that part.
struct WrapFigure {
  std::string part;
  double from = 0;  ///< metres along the bones from the part's first joint; negative before it
  double to = 0;
  double fraction = 0;
};

/// Measures every part that panels belong to, over the stretch of bone that they are meant to
/// cover: along arms and legs where all their lengthwise seams run as placed, along the torso from
/// the hem up to the chest; less a tenth at both ends, for a garment settles by some
/// centimetres. Linear in the triangles times 32 stations.
std::vector<WrapFigure> measure_wraps(const PanelMesh& garment, const DressedGarment& dressed,
                                      const Skeleton& skeleton);

}  // namespace toile
