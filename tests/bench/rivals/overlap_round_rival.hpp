// Round shapes as others do them: in plain doubles, for planes of unit normals and orthonormal boxes.
#pragma once

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb::bench::plain {

bool meet(const Plane3& plane, const Sphere3& ball);
bool meet(const Segment3& segment, const Sphere3& ball);
bool meet(const Ray3& ray, const Sphere3& ball);
bool meet(const Triangle3& triangle, const Sphere3& ball);
bool meet(const Aabb3& box, const Sphere3& ball);
bool meet(const Obb3& box, const Sphere3& ball);
bool meet(const Segment3& segment, const Capsule3& capsule);
bool meet(const Triangle3& triangle, const Capsule3& capsule);
bool meet(const Aabb3& box, const Capsule3& capsule);
bool meet(const Capsule3& a, const Capsule3& b);
bool meet(const Segment3& segment, const Cylinder3& cylinder);
bool meet(const Halfspace3& halfspace, const Cone3& cone);

}  // namespace plumb::bench::plain
