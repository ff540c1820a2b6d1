// Places on the body, in words.
#pragma once

#include <string>

#include "geometry/body/skeleton.h"
#include "geometry/types.h"

namespace toile {

/// Where on the body a point is, such as "shins, 25 cm above the floor".
std::string place_on_body(const Vec3& point, const Skeleton& skeleton);

/// A part of the body as people write it: "left arm".
std::string in_words(BodyPart part);

}  // namespace toile
