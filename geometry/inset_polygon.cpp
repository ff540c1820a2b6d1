#include "geometry/inset_polygon.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/create_offset_polygons_2.h>

namespace toile {

std::vector<std::vector<Vec2>> inset_polygon(const std::vector<Vec2>& outline, double distance) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Polygon_2<Kernel> polygon;
  for (const Vec2& point : outline) polygon.push_back({point.x(), point.y()});
  std::vector<std::vector<Vec2>> insets;
  for (const auto& inset :
       CGAL::create_interior_skeleton_and_offset_polygons_2(distance, polygon)) {
    insets.emplace_back();
    for (const auto& point : inset->container()) insets.back().emplace_back(point.x(), point.y());
  }
  return insets;
}

}  // namespace toile
