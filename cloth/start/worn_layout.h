// A garment that lies flat, and how it is worn: its front, its middle, and its height.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cloth/start/body_sizes.h"
#include "cloth/start/flat_landmarks.h"
#include "cloth/start/flat_layout.h"
#include "pattern/classify/panel_class.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// What hangs together in a FlatLayout. Lengths and heights are metres, in the picture.
class WornLayout {
 public:
  /// `around`: how many panels that are sewn to these go around a part by themselves, and are not
  /// in the layout. `garment` has to live as long.
  WornLayout(const PanelMesh& garment, FlatLayout layout, std::size_t around);

  const FlatLayout& layout() const { return layout_; }

  /// Lets the face be the front that is more like one. It has the deeper neckline. Of what does
  /// not hang from the shoulders it has the smaller area.
  void choose_front();

  /// Whether its drawing seems to be upside down: it has sleeves, and its neckline is far wider
  /// than its hem.
  bool is_upside_down() const;

  double middle() const;  ///< x of the middle of the cloth, sleeves apart

  /// The lowest point of the seams that join a left half to a right one, if an opening for each leg
  /// lies below.
  std::optional<double> crotch_height() const;

  /// How far the picture has to be raised. What hangs from the shoulders has its shoulder seams on
  /// the body's. A strapless top reaches the armpits. Anything else reaches the waist, trousers as
  /// far as their crotch allows.
  double rise(const BodySizes& sizes, const Skeleton& skeleton) const;

  /// The numbers in layout().panels of those that reach below the crotch on one side. Empty where
  /// there is no crotch.
  std::vector<std::size_t> leg_panels(bool left) const;

  /// Turns the legs of trousers to run down the legs of the body. Pressed flat, with the seam
  /// between them straight, they spread.
  void straighten_legs(const Skeleton& skeleton);

  Vec2 centre(std::size_t i) const;  ///< mean of the points of layout().panels[i]

  void shift(const Vec2& by);

 private:
  const MeshedPanel& panel(int p) const { return garment_.panels[p]; }
  bool has(PanelRole wanted) const;
  bool hangs() const;
  bool is_strapless(const FlatOpening& top, double waist_girth) const;
  const FlatOpening* leg_opening(double crotch, bool left) const;
  void find_landmarks();

  const PanelMesh& garment_;
  std::vector<int> panel_of_;
  FlatLayout layout_;
  std::size_t around_;
  std::vector<FlatOpening> openings_;
  std::vector<Vec2> shoulders_;
};

}  // namespace toile
