// Nearest points by CGAL's inexact constructions.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>

#include "bench/rivals/closest_rival.hpp"

namespace plumb::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
Kernel::Point_3 of(const Point3& p) { return {p.x, p.y, p.z}; }

template <class Shape>
NearestFound found(const Shape& shape, const Kernel::Point_3& p) {
  const Kernel::Point_3 q = Kernel().construct_projected_point_3_object()(shape, p);
  return {{q.x(), q.y(), q.z()}, std::sqrt(CGAL::squared_distance(p, q))};
}

}  // namespace

NearestFound nearest_by_cgal(const Segment3& s, const Point3& p) {
  return found(Kernel::Segment_3(of(s.a), of(s.b)), of(p));
}
NearestFound nearest_by_cgal(const Triangle3& t, const Point3& p) {
  return found(Kernel::Triangle_3(of(t.a), of(t.b), of(t.c)), of(p));
}

}  // namespace plumb::bench
