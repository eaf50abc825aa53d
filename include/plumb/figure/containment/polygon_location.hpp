// Point in polygon, winding number: is the point in the polygon?  Any chain, with holes or without, in the plane and in
// space.
//
// Laws: (1) the definition of figure/basic/polygon.hpp: whatever lies on a chain is boundary; elsewhere inside where all
// chains together wind around the point an odd number of times.  (2) The order of the chain, its start, repeated
// vertices and vertices on straight edges change nothing.  (3) In space a polygon is all boundary
// (figure/basic/relation.hpp); locate_in_plane tells its edge from its inside.  A point off its plane is outside.
// Fewer than three vertices in a chain throw InvalidShape; so do vertices that are not exactly in one plane, of which
// no surface is known.  NaN and infinity throw NonFinite.
// Source: RTCD 3.7, 5.4.1.
// Cost: linear, half a nanosecond a corner and three an edge around the point; logarithmic for convex polygons asked
// many times: query/convex/location.hpp.  Bounded by n signs, on integers as long as the exponents' span.
#pragma once

#include <optional>

#include "plumb/figure/basic/polygon.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb {

/// How often the chain winds around p, counterclockwise; nothing for a point on the chain.
std::optional<int> winding_number(const Polygon2& polygon, const Point2& p);

Location locate(const Quadrilateral2& quadrilateral, const Point2& p);
Location locate(const Polygon2& polygon, const Point2& p);
Location locate(const HoledPolygon2& polygon, const Point2& p);

/// Boundary or outside: a surface has no inside in space.
Location locate(const Quadrilateral3& quadrilateral, const Point3& p);
Location locate(const Polygon3& polygon, const Point3& p);
Location locate(const HoledPolygon3& polygon, const Point3& p);

/// As if the polygon's plane were all there is; outside for points off the plane.
Location locate_in_plane(const Quadrilateral3& quadrilateral, const Point3& p);
Location locate_in_plane(const Polygon3& polygon, const Point3& p);
Location locate_in_plane(const HoledPolygon3& polygon, const Point3& p);

bool contains(const Quadrilateral2& quadrilateral, const Point2& p);
bool contains(const Polygon2& polygon, const Point2& p);
bool contains(const HoledPolygon2& polygon, const Point2& p);
bool contains(const Quadrilateral3& quadrilateral, const Point3& p);
bool contains(const Polygon3& polygon, const Point3& p);
bool contains(const HoledPolygon3& polygon, const Point3& p);

}  // namespace plumb
