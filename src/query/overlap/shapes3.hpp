// Slab test, separating axes: how do axis-aligned boxes in space lie to what is straight, and to triangles?
//
// By the axes that can separate them: those of the box, the normal of the triangle, and their cross products.  Along a
// cross product with a box's axis one looks at both in the plane across that axis, where the corners of the box are
// doubles still; so all signs are those of oriented areas and volumes.
// Laws: a box may be flat, a segment, a point or empty, a triangle without area.
// Source: Akenine-Moller 2001; RTCD 5.2.9, 5.3.3.
// Cost: three to thirteen signs of degree 2, two of degree 3.
#pragma once

#include "query/overlap/linear3.hpp"

namespace plumb::query {

constexpr bool is_flat(const Aabb3& box) {
  return box.min.x == box.max.x || box.min.y == box.max.y || box.min.z == box.max.z;
}
constexpr Aabb2 seen(const Aabb3& box, std::size_t k) { return {seen(box.min, k), seen(box.max, k)}; }

/// The corner that lies farthest along a direction of these signs.
constexpr Point3 corner(const Aabb3& box, const std::array<Sign, 3>& along) {
  const auto pick = [](Sign s, double min, double max) { return s == Sign::positive ? max : min; };
  return {pick(along[0], box.min.x, box.max.x), pick(along[1], box.min.y, box.max.y),
          pick(along[2], box.min.z, box.max.z)};
}

Relation relate(const Linear3& a, const Aabb3& b);
Relation relate(const Triangle3& a, const Aabb3& b);

}  // namespace plumb::query
