// A body by its mesh, with all that cloth asks of it.
#pragma once

#include <utility>

#include "cloth/contact/body_bounds.h"
#include "geometry/distance_grid.h"
#include "geometry/surface_distance.h"

namespace toile::test {

/// Its parts refer to each other, so it stays where it is.
struct SolidBody {
  explicit SolidBody(TriangleMesh of) : mesh(std::move(of)) {}
  SolidBody(const SolidBody&) = delete;

  const TriangleMesh mesh;  ///< closed, facets outward
  const SurfaceDistance exact{mesh};
  const DistanceGrid distance{exact};
  const BodySurface surface{exact, distance};
};

}  // namespace toile::test
