// The stages of a dressing, each a function from a state to the next.
#pragma once

#include "cloth/dressing/constants.h"
#include "cloth/dressing/dress_options.h"
#include "cloth/dressing/journal.h"
#include "cloth/dressing/level.h"
#include "cloth/start/turn_and_lift.h"
#include "cloth/start/widening.h"

namespace toile {

/// A state, and how the stage that led to it ended; the journal has the same report.
struct Staged {
  State state;
  StageReport report;
  HeldSeams held = {};            ///< of close_seams()
  std::vector<double> open = {};  ///< RelaxReport's
};

/// The scene in which seams close. No cloth is softer than closing_stretch and closing_shear, for
/// closing seams would draw it into strings. Strain limits are left out; they are for the drape.
Scene closing_scene(Scene scene);

/// Panels that stand where they start, and the level on which their seams close.
struct Positioned {
  Placement placement;
  Level level;  ///< compiled for closing_scene()
};

/// `position`: where the panels start, found once, on the coarsest mesh; finer ones follow it.
Positioned position(const PanelMesh& mesh, int depth, const Scene& scene, double resting_offset,
                    Journal& journal);

/// `close_seams`: closes the seams of panels that start at `state`, without gravity or friction,
/// drawn to the skin. Cloth keeps off the body, with the gaps of open seams. It keeps off cloth,
/// too, until no seam closes any more. Seams then close through the cloth that holds them apart,
/// and with `closing.through_body` through the body. `converged` says whether they closed. Unless
/// the cloth `heeds_body`, only pushes keep it off the body: on a very coarse mesh bounds leave
/// seams too little way. `level` is that of position(), maybe widened.
Staged close_seams(const Level& level, State state, const Closing& closing, bool heeds_body,
                   Journal& journal);

/// `untangle`: draws cloth that has come through cloth back out of it, then gives the cloth its own
/// bending stiffness. It is drawn to the skin as while its seams closed. The report's `converged`
/// says whether the cloth is clear of itself.
Staged untangle(const Level& level, State state, double pull, Journal& journal);

/// A triangle that is `factor` times as wide at rest along a direction of its plane.
struct WideTriangle {
  double factor = 1;
  double weft = 0;  ///< the direction, a unit vector of its yarns
  double warp = 0;
};

/// Per triangle of a level, how wide its panel is while its seams close. Empty: as it is cut.
using Widening = std::vector<WideTriangle>;

/// The triangles of panels that stand where the level starts, before they are widened.
Widening widening_of(const Level& level, const std::vector<WidePanel>& panels);

Level widened(Level level, const Widening& wide);

/// `shrink`: lets the cloth that closed as widened() shrink to its own width, drawn to the skin by
/// `pull` of its weights. It is clear of the body and of itself, and stays so, whatever the strain.
Staged shrink(const Level& level, Staged staged, Widening wide, double pull, Journal& journal);

/// `untangle` of a garment that hangs as it is worn: crossing cloth is drawn apart under its
/// weight. The report's `converged` says whether the cloth is clear of itself.
Staged untangle_worn(const Level& level, State state, Journal& journal);

/// `settle`: lets the cloth fall until it may go on to the next mesh; it gives way to compression.
/// `bounded`: the cloth is clear of itself, and stays so. Without `friction` it finds its way down.
Staged settle(const Level& level, State state, bool bounded, bool friction, Journal& journal);

/// Lets the floor rise to its height under cloth that hangs below it, as hems that are too long do
/// once their seams are closed. Pushed up at once, they would be pressed under the soles.
State lifted(const Level& level, State state, bool bounded, Journal& journal);

/// `follow`: lets the cloth give way to a body that has moved a little, and fall. The same options
/// as settle()'s. It ends after following_iterations, not at rest.
Staged follow(const Level& level, State state, bool bounded, bool friction, Journal& journal);

/// `release_attachments`: brings the finest mesh to its full stiffness while attachments hold it,
/// since what is released before friction holds it would slide off. `max_iterations` at most.
Staged release_attachments(const Level& level, State state, bool bounded, int max_iterations,
                           Journal& journal);

/// `rest`: brings the finest mesh to the rest that the options ask for. `stiffens`: the cloth comes
/// from settle(), and gets its full stiffness over the first iterations; else it goes on from its
/// state's friction.
Staged rest(const Level& level, State state, bool bounded, bool stiffens,
            const DressOptions& options, Journal& journal);

/// Makes a run go on until the rest that is asked for, or until it comes no nearer to it.
void ask_for_rest(const DressOptions& wanted, RelaxOptions& options);

/// Whether a run that ask_for_rest() set up ended at the rest that is asked for. A garment that is
/// to be released goes on from there, and need not come as near to rest as it then tries to.
bool is_at_rest(const StageReport& report, const DressOptions& wanted);

/// Metres within which a mesh looks for cloth. Coarser cloth moves farther between two searches,
/// and has no more neighbours for it; fine cloth would have too many.
double search_radius(const Level& level);

}  // namespace toile
