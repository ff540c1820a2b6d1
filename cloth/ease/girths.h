// Girths of a worn garment, around trunk and limbs, beside those of the body.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cloth/ease/cloth_line.h"
#include "geometry/body/body_measures.h"
#include "geometry/body/skeleton.h"
#include "geometry/surface_distance.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// The garment's section over the perimeter of its own hull, from which on there is no girth. The
/// plane runs through a fold that lies nearly level then. Of 175 levels of seven garments the
/// median is 1.00, the largest that means a girth 1.14, and folds have 1.5 to 2.2. Half of what is
/// above 1 refuses one level of 210 more; double passes three folds of six.
inline constexpr double fold_share = 1.3;

/// The girths of body and garment in one plane. Lengths in metres.
struct Girth {
  /// "bust", "left wrist", a name of measure_body() with blanks; empty for heights between. A
  /// skirt's thigh or knee has no side: it goes around both legs.
  std::string name;
  CuttingPlane plane;
  bool is_of_trunk = false;  ///< level, around the trunk between crotch and armpits
  /// Around both legs as they stand. Their girth depends on how far apart that is.
  bool is_of_both_legs = false;
  double height = 0;   ///< of the plane's origin above the floor
  double body = 0;     ///< of the convex hull of the section: what a tape reads
  double garment = 0;  ///< length along the cloth, folds included
  double hull = 0;     ///< perimeter of the garment's convex hull
  /// By how much the cloth's line is longer than that of its inner face where it touches. The drape
  /// is held off the skin.
  double offset = 0;
  double error = 0;                ///< of ease(), see worn_figures.h
  double as_cut = 0;               ///< ClothLine::as_cut
  double on_the_line = 0;          ///< ClothLine::on_the_line
  std::vector<PanelWidth> panels;  ///< those that the plane cuts
  std::vector<int> triangles;      ///< of the garment, that the plane cuts
  /// The body's girth where this cloth was drafted to lie (drafted.h); none: not known.
  std::optional<double> drafted_body;

  bool is_girth() const { return garment < fold_share * hull; }
  double ease() const { return garment - offset - body; }
  double ease_as_cut() const { return as_cut - body; }
};

/// The panels that a girth's plane cuts.
std::vector<int> panels_of(const Girth& girth);

/// A named girth of the trunk that the garment does not have.
struct GirthLeftOut {
  std::string name;
  std::string why;
  bool is_open = false;  ///< the garment reaches it and does not close there
  double height = 0;     ///< metres above the floor; 0: the body has no such level
};

struct Girths {
  /// From the top down; those of the trunk before those of the limbs. Some may be none: is_girth().
  std::vector<Girth> rows;
  std::vector<GirthLeftOut> left_out;
};

/// What girths are measured with.
struct GirthOptions {
  double step = 0.05;             ///< metres between further levels of the trunk; 0: none
  std::vector<double> heights{};  ///< metres above the floor: levels of the trunk to add
  std::vector<double> grains{};   ///< MeshedPanel::grain of each panel; empty: along y
  const SurfaceDistance* skin{};  ///< of the body, for Girth::offset; null: it stays 0
  double touching = 0;            ///< metres off the skin up to which cloth touches
};

/// The girths that measure_body() takes of neck, trunk, arms and legs, where the garment is closed
/// around them. Between crotch and armpits those at level planes every `step` come with them.
///
/// - `measures` are standing_measures(). Where they are empty, bust, waist and hip alone have
/// names.
/// - Where trousers' crotch hangs below the thigh's plane, the thigh is taken below it. So is the
///   bust below the armholes, where sleeves hang lower than it.
/// - Cloth that is too small stretches until it goes around. Its ease is positive, and `as_cut` is
///   less than the body's girth.
/// - A section of cloth that hangs in slanting folds is longer than the cloth is wide. So `garment`
///   of a loose garment reads up to a few per cent high; `as_cut` does not.
/// - Where layers of one garment lie over each other, the outermost counts.
///
/// `skeleton` has to have the joints pelvis, waist and chest. Costs a pass over both meshes a row,
/// and without measures 100 passes over the body.
Girths measure_girths(const DressedGarment& garment, const TriangleMesh& body,
                      const Skeleton& skeleton, const BodyMeasures& measures,
                      const GirthOptions& options = {});

}  // namespace toile
