// Triangles, by both rules.
#include <cmath>

#include "plumb/certify/ray_order.hpp"
#include "plumb/query/ray/hits.hpp"
#include "query/overlap/filters.hpp"
#include "query/ray/half_open.hpp"
#include "query/ray/triangle_hit.hpp"
#include "query/ray/whole_shot.hpp"

namespace plumb {
namespace query {
namespace {

struct TriangleModel : FacetModel<TriangleModel> {
  explicit TriangleModel(const Triangle3& t) : triangle(t) {}
  const Triangle3& triangle;

  static std::size_t facets() { return 1; }
  template <class T>
  Facet<T> facet(const ShotLine<T>& line, std::uint32_t) const {
    const Vec3<T> a = line.from_origin(triangle.a);
    return {3, {a, line.from_origin(triangle.b), line.from_origin(triangle.c), a}, {0, 1, 2, 0}, {0, 1, 2, 0}, 0};
  }
  [[nodiscard]] QuickHit quick(const AnyRay& ray, const Decided& decided) const {
    if (decided.when.at != When::At::quotient || meeting_of(decided.when) != Meeting::plane) return {};
    return quick_hit(ray, triangle);
  }
  void know(const Decided& decided, Known& known) const {
    const auto& [a, b, c] = triangle;
    if (a.x == b.x && b.x == c.x) known[0] = a.x;
    if (a.y == b.y && b.y == c.y) known[1] = a.y;
    if (a.z == b.z && b.z == c.z) known[2] = a.z;
    if (decided.feature.kind != FeatureKind::vertex) return;
    const Point3& p = decided.feature.index == 0 ? a : decided.feature.index == 1 ? b : c;
    known = {p.x, p.y, p.z};
  }
};

template <class Answer>
std::optional<Answer> of(const AnyRay& ray, const Triangle3& triangle, HitRule rule) {
  require_ray(function_of<Answer>, ray, triangle);
  return answer_by<Answer, RayWorldsByStack>(rule, ray, TriangleModel(triangle));
}

using Corners = std::array<Point3, 3>;
Corners corners_of(const Triangle3& t) { return {t.a, t.b, t.c}; }

/// Is the point on the line?  This is a guess, which is right where no number is rounded.
bool is_likely_on(const AnyRay& ray, const Point3& p) {
  const Point3 &o = ray.origin, &e = ray.end;
  const Vector3 d = ends(ray) ? Vector3{e.x - o.x, e.y - o.y, e.z - o.z} : ray.direction,
                w{p.x - o.x, p.y - o.y, p.z - o.z};
  return w.x * d.y == w.y * d.x && w.y * d.z == w.z * d.y && w.z * d.x == w.x * d.z;
}

/// Decides of a triangle whose plane the line crosses, if the line is proved to pass this corner of it.
std::optional<std::optional<Decided>> decided_at(std::uint32_t corner, const AnyRay& ray, const Point3& p) {
  const auto hit_there = [&](When::At at) {
    return Decided{{at, 0, part_of(Meeting::plane, 0)}, {FeatureKind::vertex, corner}, true, 0};
  };
  if (p == ray.origin) return hit_there(When::At::zero);
  if (ends(ray) && p == ray.end) return hit_there(When::At::quotient);
  const ShotLine<Ball> line(ray);
  const Vec3<Ball> from = line.from_origin(p);
  RaySigns ask;
  if (!is_zero(cross(from, line.direction), ask)) return {};
  const Time<Ball> time = point_time(from, line.direction);
  std::optional<Decided> decided;
  if (in_range(ray, time, ask)) decided = hit_there(When::At::quotient);
  if (!ask.certain()) return {};
  return decided;
}

/// Do doubles tell, along one of the axes, that the line passes all corners on one side?  Most triangles that a ray comes
/// near to in their plane are passed so.
bool is_surely_beside(const AnyRay& ray, const Triangle3& triangle) {
  const ShotLine<Approximate> line(ray);
  const auto a = line.from_origin(triangle.a), b = line.from_origin(triangle.b), c = line.from_origin(triangle.c);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto side = [&](const Vec3<Approximate>& p) { return cross_along(axis, line.direction, p).certain_sign(); };
    const int way = side(a);
    if (way != 0 && side(b) == way && side(c) == way) return true;
  }
  return false;
}

Interval range_around(const Approximate& x) { return Interval{x.value} + Interval{-x.reach(), x.reach()}; }

bool are_crossed(const Decided& d) { return d.when.at == When::At::quotient && meeting_of(d.when) == Meeting::plane; }

/// Are both hit at one corner, or inside of one edge?  Along an edge that is where the ray begins.
bool are_at_one_place(const DecidedTriangle& first, const DecidedTriangle& second) {
  const auto [kind, i] = first.decided.feature;
  const auto [other, j] = second.decided.feature;
  if (kind != other || kind == FeatureKind::face) return false;
  const Corners p = corners_of(first.triangle), q = corners_of(second.triangle);
  if (kind == FeatureKind::vertex) return p[i] == q[j];
  const Point3 &a = p[i], &b = p[(i + 1) % 3], &c = q[j], &d = q[(j + 1) % 3];
  return (a == c && b == d) || (a == d && b == c);
}

/// What doubles tell for certain is so for every ray nearby.
template <class A>
bool hits_moved(const A& ray, const Triangle3& triangle) {
  if (const auto told = by_doubles(ray, triangle)) [[likely]]
    return *told != Relation::disjoint;
  return of<Decided>(ray, triangle, HitRule::half_open).has_value();
}

}  // namespace

bool hits_half_open(const Ray3& ray, const Triangle3& triangle) { return hits_moved(ray, triangle); }
bool hits_half_open(const Segment3& segment, const Triangle3& triangle) { return hits_moved(segment, triangle); }
bool hits_half_open(const Line3& line, const Triangle3& triangle) { return hits_moved(line, triangle); }

std::optional<Decided> decide_hit(const AnyRay& ray, const Triangle3& triangle, HitRule rule) {
  if (is_surely_beside(ray, triangle)) return {};
  if (const auto whole = whole_shot(ray, triangle))
    return answer_by<Decided, RayIntegers>(rule, whole->ray, TriangleModel(whole->triangle));
  // A ray nearly in the plane of many triangles misses most of them, which signs by themselves tell for less.
  if (!hits(ray, triangle, rule)) return {};
  return answer_by<Decided, RayWorldsByStack>(rule, ray, TriangleModel(triangle));
}
std::optional<Decided> decide_crossing(const AnyRay& ray, const Triangle3& triangle) {
  const Corners corners = corners_of(triangle);
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (!is_likely_on(ray, corners[i])) continue;
    if (const auto decided = decided_at(i, ray, corners[i])) return *decided;
  }
  return decide_hit(ray, triangle, HitRule::closed);
}

ParameterRange range_of(const AnyRay& ray, const Triangle3& triangle, const Decided& decided) {
  if (decided.when.at == When::At::zero) return {0, 0};
  const TriangleModel model(triangle);
  RaySigns ask;
  const Time<Approximate> t = time_of<Approximate>(ShotLine<Approximate>(ray), model, decided.when, ask);
  if (ask.certain() && t.denominator.certain_sign() != 0) {
    const Interval around = quotient(range_around(t.numerator), range_around(t.denominator));
    if (around.lower > -Ball::infinity && around.upper < Ball::infinity) return {around.lower, around.upper};
  }
  if (const auto range = QuickNumbers(ray, model, decided).range()) return {range->lower, range->upper};
  const double nearest = parameter_of(ray, model, decided).base.rounded();
  return {std::nextafter(nearest, -Ball::infinity), std::nextafter(nearest, Ball::infinity)};
}

Hit hit_of(const AnyRay& ray, const Triangle3& triangle, const Decided& decided) {
  return numbers_of(ray, TriangleModel(triangle), decided);
}

std::optional<Sign> compare_crossings(const AnyRay& ray, const Triangle3& first, const Triangle3& second) {
  const Corners p = corners_of(first), q = corners_of(second);
  return ends(ray) ? compare_segment_parameters(ray.origin, ray.end, p, q)
                   : compare_ray_parameters(ray.origin, ray.direction, p, q);
}

Sign compare_hits(const AnyRay& ray, const DecidedTriangle& first, const DecidedTriangle& second) {
  if (are_at_one_place(first, second)) return Sign::zero;
  if (are_crossed(first.decided) && are_crossed(second.decided))
    return *compare_crossings(ray, first.triangle, second.triangle);
  return certainly<RayWorldsByStack>([&]<class T>(RayWorld<T>& ask) {
    const ShotLine<T> line(ray);
    const auto time = [&](const DecidedTriangle& d) {
      const Time<T> t = time_of<T>(line, TriangleModel(d.triangle), d.decided.when, ask);
      return with_positive_denominator(t.numerator, t.denominator, ask(t.denominator));
    };
    return compare(time(first), time(second), ask);
  });
}

}  // namespace query

std::optional<Hit> first_hit(const AnyRay& ray, const Triangle3& triangle, HitRule rule) {
  return query::of<Hit>(ray, triangle, rule);
}
std::optional<RayParameter> first_hit_parameter(const AnyRay& ray, const Triangle3& triangle, HitRule rule) {
  return query::of<RayParameter>(ray, triangle, rule);
}

}  // namespace plumb
