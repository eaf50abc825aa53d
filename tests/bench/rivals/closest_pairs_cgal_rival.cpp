// Squared distances by CGAL's kernel of doubles.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/squared_distance_3.h>

#include <cmath>

#include "bench/rivals/closest_pairs_rival.hpp"

namespace plumb::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 cgal(const Point3& p) { return {p.x, p.y, p.z}; }
Kernel::Segment_3 cgal(const Segment3& s) { return {cgal(s.a), cgal(s.b)}; }
Kernel::Triangle_3 cgal(const Triangle3& t) { return {cgal(t.a), cgal(t.b), cgal(t.c)}; }
Kernel::Line_3 cgal(const Line3& l) {
  return {cgal(l.point), Kernel::Vector_3(l.direction.x, l.direction.y, l.direction.z)};
}

}  // namespace

double segments_in_cgal(const Segment3& p, const Segment3& q) {
  return std::sqrt(CGAL::squared_distance(cgal(p), cgal(q)));
}
double lines_in_cgal(const Line3& p, const Line3& q) { return std::sqrt(CGAL::squared_distance(cgal(p), cgal(q))); }
double triangles_in_cgal(const Triangle3& p, const Triangle3& q) {
  return std::sqrt(CGAL::squared_distance(cgal(p), cgal(q)));
}

}  // namespace plumb::bench
