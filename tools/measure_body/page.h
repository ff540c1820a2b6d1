// The measured body to look at.
#pragma once

#include <string>

#include "geometry/types.h"
#include "tools/measure_body/files.h"

namespace toile {

/// A page on which a click on a measure's row lights it on the body.
std::string measures_page(const TriangleMesh& body, const MeasuredBody& measures);

/// Front, left and back of the body with all lines and landmarks, PNG.
std::string measures_picture(const TriangleMesh& body, const MeasuredBody& measures);

}  // namespace toile
