// Points that lie in a sheet: no body has them.
#pragma once

#include <string>
#include <vector>

#include "geometry/types.h"

namespace toile {

/// Throws Error, with the place `name`, where the points' extent across the plane that fits them
/// best is a small share of their greatest extent. Extents are standard deviations.
void refuse_sheet(const std::vector<Vec3>& points, const std::string& name);

}  // namespace toile
