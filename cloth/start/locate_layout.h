// Moves a layout of panels that is not where the body is, as one rigid piece.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "geometry/body/skeleton.h"
#include "pattern/panel_mesh.h"

namespace toile {

/// A rigid move of all panels together. A point p goes to rotation * p + translation.
struct LayoutMove {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vec3 translation = Vec3::Zero();  ///< metres
  /// Whether it is the move by which clean-body brought the body into its frame. Otherwise it is
  /// found from skeleton, labels, seams and names.
  bool as_body = false;
};

/// Whether the pattern places no panel on the body: `garment.has_places` is false, or all panels
/// lie in one upright plane through the body's axis. Without a waist joint that is the y axis.
/// Panels that the skeleton positions have places, and so have attached ones, unless
/// `garment.has_places` is false. False for a single panel. Linear.
bool lacks_places(const PanelMesh& garment, const Skeleton* skeleton);

/// The move that brings the layout to where it is worn. None where it is there already, as nearly
/// as starts can cope with. Moved by it, the layout has none.
///
/// - The body's own move is taken where the layout then fits the skeleton better
///   (`skeleton.cleaned`).
/// - Names of front and back, left and right tell how far the layout is turned about the vertical,
///   by whole quarters of a turn. Where a garment has both, they have to agree. Sides alone do not
///   turn it by half a turn: some name them as the viewer sees them.
/// - The top of what hangs from the shoulders belongs at the neck. Hoods and collars do not count.
/// - Shoulder seams lie on the shoulders. A top below the shoulder joints is raised half-way from
///   there to the neck. One that stands 15 cm above the neck is lowered to it.
/// - The top of a strapless bodice belongs at the armpits, that of skirts and trousers at waist
///   height. What is not known to be one of these is not moved, nor are stockings.
/// - The middle of the panels of the trunk belongs on the body's axis.
///
/// No move of a garment with panels that the skeleton positions, or with attachments to points.
/// Linear in the points.
std::optional<LayoutMove> locate_layout(const PanelMesh& garment, const Skeleton& skeleton);

/// Moves all panels.
void move_layout(const LayoutMove& move, PanelMesh& garment);

/// Such as "turned by 90 degrees, raised by 60 cm". It says where the middle of all panels goes
/// from where they stand.
std::string text_of(const LayoutMove& move, const PanelMesh& garment);

}  // namespace toile
