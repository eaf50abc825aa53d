// Common sets as others construct them: CGAL's rounded (Epick) and lazily exact (Epeck) ones, and plain doubles.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb::bench {

template <class A, class B>
using Pairs = std::vector<std::pair<A, B>>;

/// Intersects all pairs once, and says how many have something in common; the figures are converted beforehand,
/// and others take the place of degenerate ones, which CGAL refuses.  None where all are degenerate.
using Run = std::function<long()>;

Run cgal_rounded(const Pairs<Segment2, Segment2>& pairs);
Run cgal_rounded(const Pairs<Triangle2, Triangle2>& pairs);
Run cgal_rounded(const Pairs<Segment3, Triangle3>& pairs);
Run cgal_rounded(const Pairs<Triangle3, Triangle3>& pairs);
Run cgal_rounded(const Pairs<Triangle3, Aabb3>& pairs);
Run cgal_rounded(const Pairs<Plane3, Triangle3>& pairs);
Run cgal_rounded(const Pairs<ThreePointPlane3, Triangle3>& pairs);
Run cgal_exact(const Pairs<Segment2, Segment2>& pairs);
Run cgal_exact(const Pairs<Triangle2, Triangle2>& pairs);
Run cgal_exact(const Pairs<Segment3, Triangle3>& pairs);
Run cgal_exact(const Pairs<Triangle3, Triangle3>& pairs);
Run cgal_exact(const Pairs<Triangle3, Aabb3>& pairs);
Run cgal_exact(const Pairs<Plane3, Triangle3>& pairs);
Run cgal_exact(const Pairs<ThreePointPlane3, Triangle3>& pairs);

/// As commonly written: signed areas or volumes compared with zero, then the parameter.
bool crossing_in_doubles(const Segment2& s, const Segment2& t, Point2& at);
bool crossing_in_doubles(const Segment3& s, const Triangle3& t, Point3& at);

}  // namespace plumb::bench
