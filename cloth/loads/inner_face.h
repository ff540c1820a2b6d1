// The inner face of worn cloth: its lengths where it lies on the skin.
#pragma once

#include <array>
#include <vector>

#include "cloth/model/garment_model.h"
#include "geometry/surface_distance.h"

namespace toile {

/// Metres: cloth that rests on the skin is held at its offset, and rarely more than this off it.
inline constexpr double contact_margin = 0.001;

/// Where a garment touches the body, and how long its inner face is there.
///
/// A drape is held off the skin by an offset, and on a narrow limb by the rise of the skin between
/// two nodes, too. So around a limb its middle is longer than its inner face on the skin. Around a
/// wrist it is by 8 % at edges of 15 mm. A cuff without ease would look strained by that. Where
/// skin turns by an angle between two nodes, the inner face is shorter by that angle times their
/// gap.
///
/// A triangle that is not taut keeps the strain of its middle: it lies on the skin as long as it
/// is.
class InnerFace {
 public:
  /// `nodes`: metres, one a node of `model`. A node touches if it or the middle of one of its edges
  /// is at most `touching` metres off the skin. Costs some four queries of the skin a node, in
  /// parallel.
  InnerFace(const GarmentModel& model, const std::vector<Vec3>& nodes, const SurfaceDistance& skin,
            double touching);

  bool touches(int node) const { return touches_[node] != 0; }
  /// Unit length, away from the skin below a node.
  const Vec3& outward(int node) const { return outward_[node]; }
  /// Metres between two nodes: along the skin where both touch.
  double length(int a, int b) const;
  /// m², of a triangle of the model.
  double area(int triangle) const;
  /// A triangle's stretch term with the strain of the inner face.
  StretchTriangle strained(int triangle) const;
  /// The same, with the forces that this strain makes at the fabric's own stiffness. A yarn pulls
  /// as hard however far off the skin it is drawn.
  StretchTriangle pulling(int triangle) const;

 private:
  /// The length of the inner face over that of the cloth's middle, along a triangle's yarns.
  struct Shares {
    double weft = 1;
    double warp = 1;
  };
  Shares shares(int triangle) const;

  const GarmentModel& model_;
  const std::vector<Vec3>& nodes_;
  std::vector<char> touches_;
  std::vector<double> gap_;    // metres, to the skin
  std::vector<Vec3> outward_;  // unit length
};

}  // namespace toile
