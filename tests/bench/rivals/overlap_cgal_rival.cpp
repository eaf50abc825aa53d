// CGAL's do_intersect over Epick.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <memory>

#include "bench/rivals/overlap_rival.hpp"

namespace plumb::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 point(const Point3& p) { return {p.x, p.y, p.z}; }
Kernel::Point_2 point(const Point2& p) { return {p.x, p.y}; }
Kernel::Triangle_3 convert(const Triangle3& t) { return {point(t.a), point(t.b), point(t.c)}; }
Kernel::Triangle_2 convert(const Triangle2& t) { return {point(t.a), point(t.b), point(t.c)}; }
Kernel::Segment_3 convert(const Segment3& s) { return {point(s.a), point(s.b)}; }
Kernel::Segment_2 convert(const Segment2& s) { return {point(s.a), point(s.b)}; }
CGAL::Bbox_3 convert(const Aabb3& b) { return {b.min.x, b.min.y, b.min.z, b.max.x, b.max.y, b.max.z}; }

template <class A, class B>
std::function<long()> run(const Pairs<A, B>& pairs) {
  using P = decltype(convert(pairs[0].first));
  using Q = decltype(convert(pairs[0].second));
  auto all = std::make_shared<std::vector<std::pair<P, Q>>>();
  for (const auto& [a, b] : pairs) all->emplace_back(convert(a), convert(b));
  return [all] {
    long sum = 0;
    for (const auto& [a, b] : *all) sum += CGAL::do_intersect(a, b);
    return sum;
  };
}

}  // namespace

std::function<long()> epick_run(const Pairs<Triangle3, Triangle3>& pairs) { return run(pairs); }
std::function<long()> epick_run(const Pairs<Segment3, Triangle3>& pairs) { return run(pairs); }
std::function<long()> epick_run(const Pairs<Triangle3, Aabb3>& pairs) { return run(pairs); }
std::function<long()> epick_run(const Pairs<Segment3, Aabb3>& pairs) { return run(pairs); }
std::function<long()> epick_run(const Pairs<Segment2, Segment2>& pairs) { return run(pairs); }
std::function<long()> epick_run(const Pairs<Triangle2, Triangle2>& pairs) { return run(pairs); }

}  // namespace plumb::bench
