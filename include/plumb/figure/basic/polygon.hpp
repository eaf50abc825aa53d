// What is bounded by a chain of points?  Polygons in the plane and in space, with holes, and those of four corners.
//
// Laws: the last vertex is joined to the first.  A point lies inside where the chain winds around it an odd number of
// times (the holes' chains counted with the outer one); whatever lies on a chain is boundary.  So any chain is a shape:
// self-intersecting, with repeated and collinear vertices, of zero area.  Fewer than three vertices are none, and who
// is asked about them throws InvalidShape.  A polygon in space is planar where its vertices are, exactly.
// Source: RTCD 3.7 (figures 3.13 to 3.18).
// Cost: none.
#pragma once

#include <vector>

#include "plumb/figure/basic/body.hpp"

namespace plumb {

struct Quadrilateral2 {
  Point2 a, b, c, d;
  friend bool operator==(const Quadrilateral2&, const Quadrilateral2&) = default;
};
struct Quadrilateral3 {
  Point3 a, b, c, d;
  friend bool operator==(const Quadrilateral3&, const Quadrilateral3&) = default;
};

struct Polygon2 {
  std::vector<Point2> vertices;
  friend bool operator==(const Polygon2&, const Polygon2&) = default;
};
struct Polygon3 {
  std::vector<Point3> vertices;
  friend bool operator==(const Polygon3&, const Polygon3&) = default;
};

struct HoledPolygon2 {
  Polygon2 outer;
  std::vector<Polygon2> holes;
  friend bool operator==(const HoledPolygon2&, const HoledPolygon2&) = default;
};
struct HoledPolygon3 {
  Polygon3 outer;
  std::vector<Polygon3> holes;
  friend bool operator==(const HoledPolygon3&, const HoledPolygon3&) = default;
};

template <class Take>
constexpr auto body(const Quadrilateral2& s, Take take) {
  return take("quadrilateral", part::place("a", s.a), part::place("b", s.b), part::place("c", s.c),
              part::place("d", s.d));
}
template <class Take>
constexpr auto body(const Quadrilateral3& s, Take take) {
  return take("quadrilateral", part::place("a", s.a), part::place("b", s.b), part::place("c", s.c),
              part::place("d", s.d));
}
template <class Take>
constexpr auto body(const Polygon2& s, Take take) {
  return take("polygon", part::place("vertices", s.vertices));
}
template <class Take>
constexpr auto body(const Polygon3& s, Take take) {
  return take("polygon", part::place("vertices", s.vertices));
}
template <class Take>
constexpr auto body(const HoledPolygon2& s, Take take) {
  return take("holed_polygon", part::figure("outer", s.outer), part::figure("holes", s.holes));
}
template <class Take>
constexpr auto body(const HoledPolygon3& s, Take take) {
  return take("holed_polygon", part::figure("outer", s.outer), part::figure("holes", s.holes));
}

}  // namespace plumb
