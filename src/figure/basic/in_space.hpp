// Figures of the plane as figures of space: in z = 0.
//
// Law: exact.
// Source: RTCD 3.2.
// Cost: none.
#pragma once

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb {

constexpr Point3 in_space(const Point2& p) { return {p.x, p.y, 0}; }
constexpr Point3 in_space(const Point3& p) { return p; }
constexpr Vector3 in_space(const Vector2& v) { return {v.x, v.y, 0}; }
constexpr Vector3 in_space(const Vector3& v) { return v; }

inline Line3 in_space(const Line2& l) { return {in_space(l.point), in_space(l.direction)}; }
inline Ray3 in_space(const Ray2& r) { return {in_space(r.origin), in_space(r.direction)}; }
inline Segment3 in_space(const Segment2& s) { return {in_space(s.a), in_space(s.b)}; }
inline Triangle3 in_space(const Triangle2& t) { return {in_space(t.a), in_space(t.b), in_space(t.c)}; }
inline Aabb3 in_space(const Aabb2& b) { return {in_space(b.min), in_space(b.max)}; }
inline Sphere3 in_space(const Circle2& c) { return {in_space(c.center), c.radius}; }
inline Capsule3 in_space(const Capsule2& c) { return {in_space(c.a), in_space(c.b), c.radius}; }

}  // namespace plumb
