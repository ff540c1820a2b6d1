// The paper's dressing: position, wrap, sew, drape, on masses and springs.
#pragma once

#include "cloth/dressing/dress.h"
#include "cloth/springs/constants.h"
#include "cloth/springs/spring_motion.h"

namespace toile {

struct SpringDressOptions {
  SpringOptions motion;
  /// Residual at rest, in mean node weights, as DressOptions.
  double stop_median = spring_resting_residual;
  double stop_rms = rms_over_median * spring_resting_residual;
  double longest_wrap = 0.7;  ///< seconds simulated
  double longest_sew = 3;
  double longest_drape = 3;
  /// N per metre of seam: the hand that pulls a seam together. Seams that stay open against it are
  /// not sewable. Beyond the strain limit the cloth resists with all it has. So this stretches only
  /// the elastic part.
  double hand_pull = toile::hand_pull;
};

/// Dresses the scene's body by the method of Zhong & Xu 2009, on the garment's own mesh:
///
/// - *position*: the panels are placed as by find_start(). A garment of the shoulders starts 5 cm
///   above them.
/// - *wrap*: without gravity or friction, every particle is attracted to its nearest facet, less
///   the nearer it is. The points of each seam are attracted to each other, all seams in step,
///   until 95 % of the pairs are within 2 cm. The attraction to the body grows from nothing as the
///   seams close. Otherwise panels that come near the body before their shoulders have met slide
///   down on it and catch.
/// - *sew*: the same, but the sewing force grows until all pairs are merged. It gives up when no
///   pair has merged for 0.3 s at the greatest force and the gaps do not shrink. Then the open
///   seams are not sewable, and the garment is not draped. Neighbours in the mesh may pass each
///   other until the sewn cloth is found free of intersections. From then on nothing may.
/// - *drape*: gravity, at first without friction, as a tailor lets a garment fall into place. Then
///   with friction, until the residual is below `stop_*`.
///
/// The residual is the force left on a node without air resistance, as a mean over 5 ms: single
/// steps hold the impulses of contact. Throws Error when the scene has no body.
DressResult dress_springs(const PanelMesh& garment, const Scene& scene,
                          const SpringDressOptions& options, const FrameWatcher& watcher = {});

}  // namespace toile
