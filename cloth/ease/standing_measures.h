// What measure_body() says of a body whose joints are given.
#pragma once

#include <vector>

#include "geometry/body/measures.h"
#include "geometry/body/skeleton.h"

namespace toile {

/// The measures of a body that stands with its joints where `skeleton` has them. Empty for a body
/// in a pose, or without limbs: measure_body() would look for them elsewhere. Costs measure_body()
/// and its landmarks.
std::vector<Measure> standing_measures(const TriangleMesh& body, const Skeleton& skeleton);
/// The girths among them. Takes half as long, for geodesics cost the most.
std::vector<Measure> standing_girths(const TriangleMesh& body, const Skeleton& skeleton);

}  // namespace toile
