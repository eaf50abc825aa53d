// First contacts in straight motion as they are commonly written in plain doubles; a time of -1 where there is none.
#pragma once

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb::bench {

double plain_sphere_plane(const Sphere3& s, const Vector3& v, const Plane3& p);
double plain_sphere_sphere(const Sphere3& a, const Vector3& v, const Sphere3& b);
double plain_sphere_triangle(const Sphere3& s, const Vector3& v, const Triangle3& t);
double plain_box_box(const Aabb3& a, const Vector3& v, const Aabb3& b);
double plain_oriented(const Obb3& a, const Vector3& v, const Obb3& b);

}  // namespace plumb::bench
