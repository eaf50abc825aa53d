// How is FCL asked?  Its shapes from plain numbers, and the functions that its meshes and objects ask in turn.
//
// Laws: none; it is on trial.
// Source: FCL 0.7's headers.
// Cost: FCL's.
#pragma once

#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/detail/primitive_shape_algorithm/sphere_triangle.h>
#include <fcl/narrowphase/detail/primitive_shape_algorithm/triangle_distance.h>
#include <fcl/narrowphase/detail/traversal/collision/intersect.h>

namespace plumb::bench::fcl_calls {

using Vec = fcl::Vector3d;
using OfMeshes = fcl::detail::Intersect<double>;

inline bool triangles_meet(const Vec* p) { return OfMeshes::intersect_Triangle(p[0], p[1], p[2], p[3], p[4], p[5]); }

inline fcl::OBBd bound(const double* x) {
  fcl::Matrix3d axes;
  axes << Vec(x + 3), Vec(x + 6), Vec(x + 9);
  return {axes, Vec(x), Vec(x + 12)};
}

struct Box {
  explicit Box(const double* x) : shape(2 * x[12], 2 * x[13], 2 * x[14]), place(fcl::Transform3d::Identity()) {
    place.linear() << Vec(x + 3), Vec(x + 6), Vec(x + 9);
    place.translation() = Vec(x);
  }
  fcl::Boxd shape;
  fcl::Transform3d place;
};

inline bool meet(const Box& a, const Box& b) {
  const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  return fcl::collide(&a.shape, a.place, &b.shape, b.place, request, result) != 0;
}

}  // namespace plumb::bench::fcl_calls
