// Overlap tests as others do them: in plain doubles, and CGAL's do_intersect over Epick.
#pragma once

#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb::bench {

template <class A, class B>
using Pairs = std::vector<std::pair<A, B>>;

/// As commonly written: no error is looked at, zero is what rounds to it.
namespace bare {
bool intersects(const Triangle3& a, const Triangle3& b);
bool intersects(const Segment3& s, const Triangle3& t);
bool intersects(const Ray3& r, const Triangle3& t);
bool intersects(const Triangle3& t, const Aabb3& box);
bool intersects(const Triangle3& t, const Obb3& box);
bool intersects(const Segment3& s, const Aabb3& box);
bool intersects(const Ray3& r, const Aabb3& box);
bool intersects(const Segment3& s, const Obb3& box);
bool intersects(const Aabb3& a, const Aabb3& b);
bool intersects(const Aabb3& a, const Obb3& b);
bool intersects(const Plane3& plane, const Aabb3& box);
bool intersects(const Plane3& plane, const Triangle3& t);
bool intersects(const Tetrahedron3& a, const Tetrahedron3& b);
bool intersects(const Triangle3& a, const Tetrahedron3& b);
bool intersects(const Segment2& a, const Segment2& b);
bool intersects(const Triangle2& a, const Triangle2& b);
bool intersects(const Segment2& a, const Triangle2& b);
bool intersects(const Triangle2& a, const Aabb2& b);
}  // namespace bare

/// A run through all pairs, converted beforehand, which returns how many meet.
std::function<long()> epick_run(const Pairs<Triangle3, Triangle3>& pairs);
std::function<long()> epick_run(const Pairs<Segment3, Triangle3>& pairs);
std::function<long()> epick_run(const Pairs<Triangle3, Aabb3>& pairs);
std::function<long()> epick_run(const Pairs<Segment3, Aabb3>& pairs);
std::function<long()> epick_run(const Pairs<Segment2, Segment2>& pairs);
std::function<long()> epick_run(const Pairs<Triangle2, Triangle2>& pairs);

}  // namespace plumb::bench
