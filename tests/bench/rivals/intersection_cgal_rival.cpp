#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <memory>

#include "bench/rivals/intersection_rival.hpp"

namespace plumb::bench {
namespace {

template <class K>
struct In {
  static typename K::Point_2 of(const Point2& p) { return {p.x, p.y}; }
  static typename K::Point_3 of(const Point3& p) { return {p.x, p.y, p.z}; }
  static typename K::Segment_2 of(const Segment2& s) { return {of(s.a), of(s.b)}; }
  static typename K::Segment_3 of(const Segment3& s) { return {of(s.a), of(s.b)}; }
  static typename K::Triangle_2 of(const Triangle2& t) { return {of(t.a), of(t.b), of(t.c)}; }
  static typename K::Triangle_3 of(const Triangle3& t) { return {of(t.a), of(t.b), of(t.c)}; }
  static typename K::Plane_3 of(const Plane3& p) { return {p.normal.x, p.normal.y, p.normal.z, -p.offset}; }
  static typename K::Plane_3 of(const ThreePointPlane3& p) { return {of(p.a), of(p.b), of(p.c)}; }
  static typename K::Iso_cuboid_3 of(const Aabb3& b) { return {of(b.min), of(b.max)}; }
};

/// CGAL clips counterclockwise triangles.
const Pairs<Triangle2, Triangle2> counterclockwise(Pairs<Triangle2, Triangle2> pairs) {
  const auto turn = [](Triangle2& t) {
    if (In<CGAL::Exact_predicates_inexact_constructions_kernel>::of(t).orientation() == CGAL::CLOCKWISE)
      std::swap(t.b, t.c);
  };
  for (auto& [a, b] : pairs) turn(a), turn(b);
  return pairs;
}

template <class K, class A, class B>
Run run(const Pairs<A, B>& pairs) {
  using Both = std::pair<decltype(In<K>::of(std::declval<A>())), decltype(In<K>::of(std::declval<B>()))>;
  auto all = std::make_shared<std::vector<Both>>();
  for (const auto& [a, b] : pairs) all->emplace_back(In<K>::of(a), In<K>::of(b));
  std::erase_if(*all, [](const Both& p) { return p.first.is_degenerate() || p.second.is_degenerate(); });
  if (all->empty()) return {};
  for (std::size_t i = 0; all->size() < pairs.size(); ++i) all->push_back((*all)[i]);
  return [all] {
    long met = 0;
    for (const auto& [a, b] : *all) met += CGAL::intersection(a, b) ? 1 : 0;
    return met;
  };
}

using Rounded = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

}  // namespace

Run cgal_rounded(const Pairs<Segment2, Segment2>& pairs) { return run<Rounded>(pairs); }
Run cgal_rounded(const Pairs<Triangle2, Triangle2>& pairs) { return run<Rounded>(counterclockwise(pairs)); }
Run cgal_rounded(const Pairs<Segment3, Triangle3>& pairs) { return run<Rounded>(pairs); }
Run cgal_rounded(const Pairs<Triangle3, Triangle3>& pairs) { return run<Rounded>(pairs); }
Run cgal_rounded(const Pairs<Triangle3, Aabb3>& pairs) { return run<Rounded>(pairs); }
Run cgal_rounded(const Pairs<Plane3, Triangle3>& pairs) { return run<Rounded>(pairs); }
Run cgal_rounded(const Pairs<ThreePointPlane3, Triangle3>& pairs) { return run<Rounded>(pairs); }
Run cgal_exact(const Pairs<Segment2, Segment2>& pairs) { return run<Exact>(pairs); }
Run cgal_exact(const Pairs<Triangle2, Triangle2>& pairs) { return run<Exact>(counterclockwise(pairs)); }
Run cgal_exact(const Pairs<Segment3, Triangle3>& pairs) { return run<Exact>(pairs); }
Run cgal_exact(const Pairs<Triangle3, Triangle3>& pairs) { return run<Exact>(pairs); }
Run cgal_exact(const Pairs<Triangle3, Aabb3>& pairs) { return run<Exact>(pairs); }
Run cgal_exact(const Pairs<Plane3, Triangle3>& pairs) { return run<Exact>(pairs); }
Run cgal_exact(const Pairs<ThreePointPlane3, Triangle3>& pairs) { return run<Exact>(pairs); }

}  // namespace plumb::bench
