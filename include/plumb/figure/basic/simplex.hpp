// What do three or four points span?  Triangles and tetrahedra: the smallest convex sets that hold their corners.
//
// Laws: any corners will do; a triangle may be a segment or a point, a tetrahedron flat.
// Source: RTCD 3.4, 3.8 (figure 3.20).
// Cost: none.
#pragma once

#include "plumb/figure/basic/body.hpp"

namespace plumb {

struct Triangle2 {
  Point2 a, b, c;
  friend bool operator==(const Triangle2&, const Triangle2&) = default;
};
struct Triangle3 {
  Point3 a, b, c;
  friend bool operator==(const Triangle3&, const Triangle3&) = default;
};
struct Tetrahedron3 {
  Point3 a, b, c, d;
  friend bool operator==(const Tetrahedron3&, const Tetrahedron3&) = default;
};

template <class Take>
constexpr auto body(const Triangle2& s, Take take) {
  return take("triangle", part::place("a", s.a), part::place("b", s.b), part::place("c", s.c));
}
template <class Take>
constexpr auto body(const Triangle3& s, Take take) {
  return take("triangle", part::place("a", s.a), part::place("b", s.b), part::place("c", s.c));
}
template <class Take>
constexpr auto body(const Tetrahedron3& s, Take take) {
  return take("tetrahedron", part::place("a", s.a), part::place("b", s.b), part::place("c", s.c),
              part::place("d", s.d));
}

}  // namespace plumb
