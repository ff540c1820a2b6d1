// Sewing: from flat panels around the body to a garment whose seams are closed.
#pragma once

#include "cloth/dressing/journal.h"
#include "cloth/dressing/level.h"
#include "cloth/start/turn_and_lift.h"

namespace toile {

/// A garment on its coarsest mesh, with its seams closed around the body.
struct Sewn {
  Placement placement;
  State state;
  /// Per material point, not 0 where its seams are left open: the body stands between their sides.
  /// Empty: all seams are sewn. The state's nodes are those of a mesh with as many open.
  std::vector<char> unsewn;
  bool is_clear = false;      ///< of itself
  bool crosses_body = false;  ///< as what closed through an arm does
};

/// Places the panels around the scene's body and closes their seams (stages.h).
///
/// Where panels stand before an arm, they are sewn around a body whose arms are raised and slim
/// (ArmRaise). Skirts and wide tops then close past the arms, and sleeves around them. The garment
/// comes down with the arms. Over layers the arms stay.
///
/// Panels that tangle are sewn again in other ways (closing_attempts), and those that cross the
/// body wider (widening.h), unless `once` is asked for. What then crosses the body in more than
/// max_hopeful_intersections places has those seams left open that were held apart. Throws what
/// find_start() and compile() throw.
Sewn sew(const PanelMesh& mesh, int depth, const Scene& scene, double resting_offset, bool once,
         Journal& journal);

}  // namespace toile
