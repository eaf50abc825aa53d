#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include "bench/rivals/ray_rival.hpp"

namespace plumb::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 of(const Point3& p) { return {p.x, p.y, p.z}; }
Kernel::Ray_3 of(const Ray3& r) {
  return {of(r.origin), Kernel::Vector_3(r.direction.x, r.direction.y, r.direction.z)};
}
Kernel::Triangle_3 of(const Triangle3& t) { return {of(t.a), of(t.b), of(t.c)}; }

}  // namespace

bool cgal_hits(const Ray3& ray, const Triangle3& t) { return CGAL::do_intersect(of(ray), of(t)); }
bool cgal_hits(const Segment3& s, const Triangle3& t) {
  return CGAL::do_intersect(Kernel::Segment_3(of(s.a), of(s.b)), of(t));
}
bool cgal_hits(const Ray3& ray, const Aabb3& b) {
  return CGAL::do_intersect(of(ray), Kernel::Iso_cuboid_3(of(b.min), of(b.max)));
}

}  // namespace plumb::bench
