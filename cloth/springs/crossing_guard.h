// The last word of a step: nothing passes through the surface, however long the step is.
#pragma once

#include <vector>

#include "cloth/springs/contact_detection.h"

namespace toile {

/// Cuts velocities v so that no pair of the lists of `triangles` crosses when step.x moves by dt·v.
/// The lists `near` are in step.cloth's order. A tenth of the distance of each pair stays.
/// First it cuts only the speed towards the subject. Where cuts work against each other, it cuts
/// all of a node's speed. Two convex things stay apart as long as no corner of the moving one
/// covers their distance along the line between their nearest points.
/// Points that already are behind the surface are left alone. Returns whether it cut any velocity.
bool keep_from_crossing(const CollisionStep& step, const std::vector<int>& triangles,
                        const CollisionCandidates& near, std::vector<Vec3>& v);

}  // namespace toile
