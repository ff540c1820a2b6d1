// Takes a garment along with a body that moves from standing into a pose.
#pragma once

#include <vector>

#include "cloth/dressing/journal.h"
#include "cloth/dressing/level.h"

namespace toile {

/// Where points near the standing body are once it is in the scene's pose, metres. Each turns and
/// moves with the skin that is nearest to it. The scene has a standing body. O(n log n).
std::vector<Vec3> taken_along(std::vector<Vec3> points, const Scene& scene);

/// `follow`: moves the standing body into the scene's pose by small steps, and the garment with it.
///
/// In each step cloth moves with the nearest skin. Then it gives way to the body, and falls. Where
/// it would cross itself the step is cut. Where it still would, it stays, and the body pushes it.
/// So cloth that is clear of itself stays so.
///
/// `level` is one of the standing body, and becomes the scene's. `state` has settled on it.
/// `bounded`: the cloth is clear of itself. Returns whether it is at the end. A step costs a
/// body's tree and distances, 0.1 s for 24k points and 900 nodes; one that is cut, up to eight.
bool follow_body(Level& level, State& state, const Scene& scene, double resting_offset,
                 bool bounded, bool friction, Journal& journal);

/// The same at once, as taken_along() does it: of a garment that is lost anyway.
void take_along(Level& level, State& state, const Scene& scene, double resting_offset);

}  // namespace toile
