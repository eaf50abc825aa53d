// FCL's functions by the C signatures of `plumb fuzz --list`; what they throw passes through.
#include "bench/rivals/fcl_calls.hpp"

namespace calls = plumb::bench::fcl_calls;
using calls::Vec;

extern "C" {

int fcl_box_box(const double* a, const double* b) {
  return fcl::AABBd(Vec(a), Vec(a + 3)).overlap(fcl::AABBd(Vec(b), Vec(b + 3)));
}

/// The test of FCL's hierarchies.
int fcl_obb_obb(const double* a, const double* b) { return calls::bound(a).overlap(calls::bound(b)); }

/// The test of FCL's objects.
int fcl_collide_boxes(const double* a, const double* b) { return calls::meet(calls::Box(a), calls::Box(b)); }

int fcl_triangle_triangle(const double* a, const double* b) {
  const std::array<Vec, 6> corners{Vec(a), Vec(a + 3), Vec(a + 6), Vec(b), Vec(b + 3), Vec(b + 6)};
  return calls::triangles_meet(corners.data());
}
}
