#include <CGAL/Polygon_2.h>

#include "oracle/cgal_kernel.hpp"
#include "oracle/polygons.hpp"

namespace plumb::oracle {

std::optional<SimplePolygon> simple_polygon(std::span<const Point2> vertices, const Point2& p) {
  CGAL::Polygon_2<Kernel> polygon;
  for (const Point2& v : vertices) polygon.push_back({Number(v.x), Number(v.y)});
  if (!polygon.is_simple()) return {};
  const auto side = polygon.bounded_side({Number(p.x), Number(p.y)});
  return SimplePolygon{polygon.is_convex(), of(polygon.orientation()), static_cast<Location>(of(side))};
}

}  // namespace plumb::oracle
