// What is a polygon, by CGAL's own statements?  Simple, convex, which way around, and where a point lies to it.
//
// Laws: exact for all finite doubles.  All but `simple` is asked of simple polygons alone, as CGAL wants it.
// Source: CGAL's manual, "2D Polygons".
// Cost: some 10 us a polygon.
#pragma once

#include <optional>
#include <span>

#include "plumb/arith/point.hpp"
#include "plumb/arith/sign.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb::oracle {

struct SimplePolygon {
  bool convex;
  Sign orientation;
  Location location;  // of the point
};

/// Nothing for polygons that are not simple.
std::optional<SimplePolygon> simple_polygon(std::span<const Point2> vertices, const Point2& p);

}  // namespace plumb::oracle
