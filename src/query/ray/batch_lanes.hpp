// Ray cast: what do lanes of doubles say of one ray against many triangles?
//
// What the tests prove is said in query/ray/triangle_passed.hpp.
#pragma once

#include <cstddef>
#include <cstdint>

#include "plumb/query/ray/ray.hpp"

namespace plumb::query {

/// Of a line from the origin along a direction.
struct BatchRay {
  double origin[3], direction[3];
  bool begins, ends;
};

/// Of a ray that stands for another one nearby: how far what is computed of it, with any triangle that is asked about,
/// may be from what is exact of the other.  Of the side of an edge, the sum of the three, the plane's numerator, and
/// that minus the sum.
struct RayDoubts {
  double edge, sum, plane, end;
  bool are_given = false;  // else a ray is what it is
};

inline void put_batch_ray(const AnyRay& ray, BatchRay& to) {
  const auto& [x, y, z] = ray.origin;
  const auto& [dx, dy, dz] = ray.direction;
  const bool ends = ray.kind == AnyRay::Kind::segment;
  to.origin[0] = x, to.origin[1] = y, to.origin[2] = z;
  to.direction[0] = ends ? ray.end.x - x : dx;
  to.direction[1] = ends ? ray.end.y - y : dy;
  to.direction[2] = ends ? ray.end.z - z : dz;
  to.begins = ray.kind != AnyRay::Kind::line;
  to.ends = ends;
}
inline BatchRay batch_ray(const AnyRay& ray) {
  BatchRay to{};
  put_batch_ray(ray, to);
  return to;
}

/// What is told of each triangle: 0 no, 1 yes, 2 nothing; and between which parameters it is hit where it is: between
/// infinities where nothing is known of that.
struct BatchTold {
  std::uint8_t* told;
  double *least, *most;
};

/// Of n triangles, whose numbers are at[0][i] to at[8][i]; of a segment with its rounded direction.  Whole lanes are
/// read and told: there is room up to the next multiple of eight.
void ask_lanes(const BatchRay& ray, const double* const* at, std::size_t n, const BatchTold& out);

}  // namespace plumb::query
