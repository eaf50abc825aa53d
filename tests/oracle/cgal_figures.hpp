// What are our figures in CGAL's terms?
//
// Law: the same set, over rationals; CGAL may refuse what is degenerate, and orders the corners of a box itself.
// For the .cpp files of this folder alone: it includes CGAL.
#pragma once

#include "oracle/cgal_kernel.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb::oracle {

inline Kernel::Point_2 of(const Point2& p) { return {Number(p.x), Number(p.y)}; }
inline Kernel::Point_3 of(const Point3& p) { return {Number(p.x), Number(p.y), Number(p.z)}; }
inline Kernel::Vector_2 of(const Vector2& v) { return {Number(v.x), Number(v.y)}; }
inline Kernel::Vector_3 of(const Vector3& v) { return {Number(v.x), Number(v.y), Number(v.z)}; }
inline Kernel::Line_2 of(const Line2& l) { return {of(l.point), of(l.direction)}; }
inline Kernel::Line_3 of(const Line3& l) { return {of(l.point), of(l.direction)}; }
inline Kernel::Ray_2 of(const Ray2& r) { return {of(r.origin), of(r.direction)}; }
inline Kernel::Ray_3 of(const Ray3& r) { return {of(r.origin), of(r.direction)}; }
inline Kernel::Segment_2 of(const Segment2& s) { return {of(s.a), of(s.b)}; }
inline Kernel::Segment_3 of(const Segment3& s) { return {of(s.a), of(s.b)}; }
inline Kernel::Plane_3 of(const Plane3& p) {
  return {Number(p.normal.x), Number(p.normal.y), Number(p.normal.z), -Number(p.offset)};
}
inline Kernel::Triangle_2 of(const Triangle2& t) { return {of(t.a), of(t.b), of(t.c)}; }
inline Kernel::Triangle_3 of(const Triangle3& t) { return {of(t.a), of(t.b), of(t.c)}; }
inline Kernel::Tetrahedron_3 of(const Tetrahedron3& t) { return {of(t.a), of(t.b), of(t.c), of(t.d)}; }
inline Kernel::Circle_2 of(const Circle2& c) { return {of(c.center), Number(c.radius) * Number(c.radius)}; }
inline Kernel::Sphere_3 of(const Sphere3& s) { return {of(s.center), Number(s.radius) * Number(s.radius)}; }
inline Kernel::Iso_rectangle_2 of(const Aabb2& b) { return {of(b.min), of(b.max)}; }
inline Kernel::Iso_cuboid_3 of(const Aabb3& b) { return {of(b.min), of(b.max)}; }

}  // namespace plumb::oracle
