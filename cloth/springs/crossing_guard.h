// The last word of a step: nothing passes through the surface, however long the step is.
#pragma once

#include <vector>

#include "cloth/springs/contact_detection.h"

namespace toile {

/// Cuts velocities v so that moving step.x by dt·v leaves every pair of the lists of `triangles`
/// (near, in step.cloth's order) apart by a tenth of its distance: first only the speed towards
/// the subject, and where the cuts work against each other, all of a node's speed. Two convex
/// things that are d apart stay so as long as no corner of the moving one comes d nearer along the
/// line between their nearest points. What already is behind the surface is left alone. Returns
/// whether anything was cut.
bool keep_from_crossing(const CollisionStep& step, const std::vector<int>& triangles,
                        const CollisionCandidates& near, std::vector<Vec3>& v);

}  // namespace toile
