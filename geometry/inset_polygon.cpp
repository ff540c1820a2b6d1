#include "geometry/inset_polygon.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/create_offset_polygons_2.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>

#include "geometry/polygon.h"

namespace toile {

namespace {

/// Metres by which points may be left out. The straight skeleton takes time and memory with the
/// square of the points.
constexpr double max_thinning = 1e-5;

std::vector<Vec2> thinned(const std::vector<Vec2>& outline) {
  namespace bg = boost::geometry;
  using Point = bg::model::d2::point_xy<double>;
  bg::model::ring<Point, false> ring;
  for (const Vec2& point : outline) ring.emplace_back(point.x(), point.y());
  if (!ring.empty()) ring.push_back(ring.front());
  bg::model::ring<Point, false> simple;
  bg::simplify(ring, simple, max_thinning);
  std::vector<Vec2> points;
  for (const Point& point : simple) points.emplace_back(point.x(), point.y());
  if (points.size() > 1 && points.front() == points.back()) points.pop_back();
  // Sides that nearly touch may cross without some of their points: the skeleton would not end.
  return points.size() < 3 || first_crossing(points) ? outline : points;
}

}  // namespace

std::vector<std::vector<Vec2>> inset_polygon(const std::vector<Vec2>& outline, double distance) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Polygon_2<Kernel> polygon;
  for (const Vec2& point : thinned(outline)) polygon.push_back({point.x(), point.y()});
  std::vector<std::vector<Vec2>> insets;
  for (const auto& inset :
       CGAL::create_interior_skeleton_and_offset_polygons_2(distance, polygon)) {
    insets.emplace_back();
    for (const auto& point : inset->container()) insets.back().emplace_back(point.x(), point.y());
  }
  return insets;
}

}  // namespace toile
