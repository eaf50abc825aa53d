#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include "bench/rivals/exact_points_rival.hpp"

namespace plumb::bench {
namespace {

using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

Epeck::Point_2 of(const Point2& p) { return {p.x, p.y}; }
Epeck::Point_3 of(const Point3& p) { return {p.x, p.y, p.z}; }
Epeck::Segment_2 of(const Segment2& s) { return {of(s.a), of(s.b)}; }
Epeck::Segment_3 of(const Segment3& s) { return {of(s.a), of(s.b)}; }
Epeck::Triangle_3 of(const Triangle3& t) { return {of(t.a), of(t.b), of(t.c)}; }

struct Lazy {
  template <class A, class B>
  static auto taken(const Pairs<A, B>& pairs) {
    std::vector<std::pair<decltype(of(pairs[0].first)), decltype(of(pairs[0].second))>> all;
    for (const auto& [a, b] : pairs) all.emplace_back(of(a), of(b));
    return all;
  }
  static Epeck::Point_2 point(const Epeck::Segment_2& s, const Epeck::Segment_2& t) {
    return boost::get<Epeck::Point_2>(*CGAL::intersection(s, t));
  }
  static Epeck::Point_3 point(const Epeck::Segment_3& s, const Epeck::Triangle_3& t) {
    return boost::get<Epeck::Point_3>(*CGAL::intersection(s, t));
  }
  static bool before(const Epeck::Point_2& p, const Epeck::Point_2& q) {
    return CGAL::compare_xy(p, q) == CGAL::SMALLER;
  }
  static bool before(const Epeck::Point_3& p, const Epeck::Point_3& q) {
    return CGAL::compare_xyz(p, q) == CGAL::SMALLER;
  }
  static int turn(const Epeck::Point_2& p, const Epeck::Point_2& q, const Epeck::Point_2& r, const Epeck::Point_2&) {
    return CGAL::orientation(p, q, r);
  }
  static int turn(const Epeck::Point_3& p, const Epeck::Point_3& q, const Epeck::Point_3& r, const Epeck::Point_3& s) {
    return CGAL::orientation(p, q, r, s);
  }
};

}  // namespace

Run cgal_points(PointQuestion question, const Pairs<Segment2, Segment2>& pairs) {
  return point_run<Lazy>(question, pairs);
}
Run cgal_points(PointQuestion question, const Pairs<Segment3, Triangle3>& pairs) {
  return point_run<Lazy>(question, pairs);
}

}  // namespace plumb::bench
