// Where are the corners of a posed triangle, over any number type?
//
// Law: exact over numbers that are; a dyadic number holds every posed coordinate.
// Source: RTCD 3.2.
// Cost: nine products a corner.
#pragma once

#include "plumb/arith/pose.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "query/body/vectors.hpp"

namespace plumb::query {

using PosedTriangle3 = Posed<Triangle3>;

/// As given.
constexpr PosedTriangle3 standing(const Triangle3& t) { return {t, identity_pose}; }
constexpr PosedTriangle3 standing(const Segment3& s) { return {{s.a, s.b, s.b}, identity_pose}; }

/// matrix * p + translation.
template <class T>
Vec3<T> posed(const Point3& p, const Pose& pose) {
  const auto& [c, t] = pose;
  return vector_of<T>(c[0]) * T(p.x) + vector_of<T>(c[1]) * T(p.y) + vector_of<T>(c[2]) * T(p.z) + vector_of<T>(t);
}

template <class T>
std::array<Vec3<T>, 3> posed_corners(const PosedTriangle3& t) {
  return {posed<T>(t.shape.a, t.pose), posed<T>(t.shape.b, t.pose), posed<T>(t.shape.c, t.pose)};
}

}  // namespace plumb::query
