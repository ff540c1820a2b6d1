#include "geometry/outset_polygon.h"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>

namespace toile {

std::vector<Vec2> outset_polygon(const std::vector<Vec2>& outline, double distance) {
  namespace bg = boost::geometry;
  namespace buffer = bg::strategy::buffer;
  using Polygon = bg::model::polygon<bg::model::d2::point_xy<double>, false>;
  Polygon polygon;
  for (const Vec2& point : outline)
    bg::append(polygon, bg::make<bg::model::d2::point_xy<double>>(point.x(), point.y()));
  bg::correct(polygon);
  bg::model::multi_polygon<Polygon> grown;
  bg::buffer(polygon, grown, buffer::distance_symmetric<double>(distance), buffer::side_straight(),
             buffer::join_miter(3), buffer::end_flat(), buffer::point_square());
  std::vector<Vec2> points;
  const auto largest =
      std::max_element(grown.begin(), grown.end(), [](const Polygon& a, const Polygon& b) {
        return std::abs(bg::area(a)) < std::abs(bg::area(b));
      });
  if (largest == grown.end()) return {};
  for (const auto& point : largest->outer()) points.emplace_back(point.x(), point.y());
  if (points.size() > 1 && points.front() == points.back()) points.pop_back();
  return points;
}

}  // namespace toile
