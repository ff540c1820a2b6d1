// What measure_body() says of a body whose joints are given.
#pragma once

#include "geometry/body/body_measures.h"
#include "geometry/body/skeleton.h"

namespace toile {

/// The measures of a body that stands with its joints where `skeleton` has them. Empty for a body
/// in a pose, or without limbs: measure_body() would look for them elsewhere.
///
/// Those that the skeleton brings are taken where `body` has each of their girths in its plane,
/// which costs a slice a girth. Else it costs measure_body() and its landmarks.
BodyMeasures standing_measures(const TriangleMesh& body, const Skeleton& skeleton);

}  // namespace toile
