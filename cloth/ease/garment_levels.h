// Girths at levels of the garment itself: its top edge, its waist seam, its hem, its cuffs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/body/body_measures.h"
#include "geometry/body/skeleton.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// A line of the garment that runs once around the trunk, both legs or one limb. It need not lie
/// level. Lengths in metres.
struct GarmentLevel {
  /// "top edge", "waist seam" or "hem"; of a limb "left cuff", "left armhole" or "left leg hem";
  /// "neckline".
  std::string name;
  double height = 0;        ///< above the floor, mean
  double height_error = 0;  ///< see worn_figures.h
  double garment = 0;       ///< length as worn
  double as_cut = 0;        ///< length on the flat panels; of a gathered seam, its shorter side
  /// Girth of trunk or limb there, of a neckline that of the neck's base. None: it is not on the
  /// trunk, it is an armhole, or nobody knows.
  std::optional<double> body;
  std::vector<int> nodes;   ///< of the garment, along the line
  std::vector<int> panels;  ///< of the garment, that have an edge on it, in their order
  bool is_of_limb = false;  ///< one limb or the head alone passes through it
  /// Height at which it was drafted to lie (judge/drafted.h); none: not known.
  std::optional<double> drafted;
  std::optional<double> drafted_body;  ///< the body's girth there; none: not known
  /// By how much that changes within the error of `drafted`.
  double drafted_body_error = 0;
  std::optional<double> waist;  ///< of a waist seam, the body's girth at the waist

  /// What it is compared with. Patterns state roughly where a top edge starts, so it counts where
  /// it lacks the least: there or where it rests. Another edge counts where it was drafted to lie.
  /// None: the body has no girth there.
  struct Compared {
    double body = 0;
    double error = 0;         ///< of an ease beside it
    bool is_drafted = false;  ///< false: where it rests
  };
  std::optional<Compared> compared() const;

  /// How much higher it hangs than drafted; negative: lower.
  std::optional<double> risen() const {
    return drafted ? std::optional<double>(height - *drafted) : std::nullopt;
  }
};

/// Whether it hangs from the waist: waistband, skirt, trousers.
bool hangs_from_waist(PanelRole worn_as);

/// Per panel, what it is worn with (panel_class.h).
std::vector<PanelRole> worn_as(const PanelMesh& pattern);
/// The same by the names of the panels alone.
std::vector<PanelRole> worn_as(const std::vector<std::string>& panels);

/// The levels that the garment has, from the top down, those of limbs last. The waist seam is where
/// panels that hang from the waist are sewn to others. Empty unless the skeleton has all limbs.
/// `measures` are standing_measures(), for the neck's base.
/// Costs one pass over the body a level.
std::vector<GarmentLevel> measure_garment_levels(const DressedGarment& garment,
                                                 const TriangleMesh& body, const Skeleton& skeleton,
                                                 const std::vector<PanelRole>& worn_as,
                                                 const BodyMeasures& measures = {});

}  // namespace toile
