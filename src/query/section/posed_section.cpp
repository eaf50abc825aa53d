// What two exact sets have in common: all that bounds either, and its generators.
#include <algorithm>

#include "arith/exact_number.hpp"
#include "plumb/query/section/posed.hpp"
#include "query/body/posed_input.hpp"
#include "query/convex/posed_set.hpp"
#include "query/convex/set.hpp"
#include "query/section/exact_section.hpp"
#include "query/section/meet_halfspaces.hpp"

namespace plumb::query {
namespace {

/// As the kinds of query/section/intersection_result.hpp tell it.
struct CommonPart {
  IntersectionKind kind = IntersectionKind::nothing;
  std::vector<Exact3> vertices = {};
};

/// Of ascending points, the extreme ones counterclockwise as seen along an axis, from the first (Andrew 1979).
std::vector<Exact3> around(const std::vector<Exact3>& points, std::size_t axis) {
  const std::size_t right = meeting::looks[axis].right, up = meeting::looks[axis].up;
  const auto turns_left = [&](const Exact3& a, const Exact3& b, const Exact3& c) {
    return sgn(mpq_class((b[right] - a[right]) * (c[up] - a[up]) - (b[up] - a[up]) * (c[right] - a[right]))) > 0;
  };
  std::vector<Exact3> chain;
  const auto add = [&](const Exact3& p, std::size_t keep) {
    while (chain.size() > keep && !turns_left(chain[chain.size() - 2], chain.back(), p)) chain.pop_back();
    chain.push_back(p);
  };
  for (const Exact3& p : points) add(p, 1);
  const std::size_t lower = chain.size();
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
  chain.pop_back();
  return chain;
}

CommonPart bounded_part(std::vector<Exact3> points) {
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() == 1) return {IntersectionKind::point, std::move(points)};
  if (points.size() == 2) return {IntersectionKind::segment, std::move(points)};
  // Each is extreme: no three are on one line.
  const Exact3 normal = cross(points[1] - points[0], points[2] - points[0]);
  for (const Exact3& p : points) {
    if (sgn(dot(normal, p - points[0])) != 0) return {IntersectionKind::solid, std::move(points)};
  }
  return {IntersectionKind::polygon, around(points, sgn(normal[2]) != 0 ? 2 : sgn(normal[0]) != 0 ? 0 : 1)};
}

CommonPart common_part(const FlatSet& a, const FlatSet& b) {
  if (a.points.empty() || b.points.empty()) return {};
  std::vector<ExactHalfspace> all = halfspaces_of(a);
  for (ExactHalfspace& h : halfspaces_of(b)) all.push_back(std::move(h));
  const FlatSet s = flat_set(all);
  if (s.points.empty()) return {};
  if (!s.lines.empty()) return {IntersectionKind::line, {s.points[0], s.points[0] + s.lines[0]}};
  if (!s.directions.empty()) return {IntersectionKind::ray, {s.points[0], s.points[0] + s.directions[0]}};
  return bounded_part(s.points);
}

FlatSet convex_image(const PosedView& v) {
  PosedSet s = posed_set(v);
  if (v.figure.kind == FigureKind::polygon) {
    const auto take = [&](const auto& polygon, const auto& exact) {
      (void)meeting::convex_set(polygon);  // throws where it is not convex
      for (const auto& p : polygon.vertices) s.core.points.push_back(exact(p));
    };
    if (v.figure.dimension == 2) {
      take(*static_cast<const Polygon2*>(v.figure.shape), [](const Point2& p) { return Exact3{p.x, p.y, 0}; });
    } else {
      take(*static_cast<const Polygon3*>(v.figure.shape), [](const Point3& p) { return Exact3{p.x, p.y, p.z}; });
    }
  }
  return image(s);
}

CommonPart common_part(const PosedView& a, const PosedView& b) {
  require_posed("intersection", a, b);
  return common_part(convex_image(a), convex_image(b));
}

bool is_a_double(const mpq_class& x) {
  const double d = x.get_d();
  return d - d == 0 && mpq_class(d) == x;
}
ExactPoint2 exact_point2(const Exact3& p) {
  if (is_a_double(p[0]) && is_a_double(p[1])) return Point2{p[0].get_d(), p[1].get_d()};
  return RationalPoint2{exact_number(p[0]), exact_number(p[1])};
}
Intersection3 told3(const CommonPart& part) {
  Intersection3 r{part.kind, {}};
  for (const Exact3& p : part.vertices) r.vertices.push_back(exact_point3(p));
  return r;
}

}  // namespace

ExactPoint3 exact_point3(const Exact3& p) {
  if (is_a_double(p[0]) && is_a_double(p[1]) && is_a_double(p[2]))
    return Point3{p[0].get_d(), p[1].get_d(), p[2].get_d()};
  return RationalPoint3{exact_number(p[0]), exact_number(p[1]), exact_number(p[2])};
}

Intersection3 common_part3(const FlatSet& a, const FlatSet& b) { return told3(common_part(a, b)); }

Intersection2 posed_intersection2(const PosedView& a, const PosedView& b) {
  const CommonPart part = common_part(a, b);
  Intersection2 r{part.kind, {}};
  for (const Exact3& p : part.vertices) r.vertices.push_back(exact_point2(p));
  return r;
}
Intersection3 posed_intersection3(const PosedView& a, const PosedView& b) { return told3(common_part(a, b)); }

SolidIntersection3 posed_solid(const PosedView& a, const PosedView& b) {
  require_posed("intersection", a, b);
  std::vector<ExactHalfspace> all;
  for (const PosedView* v : {&a, &b}) {
    const FlatSet s = convex_image(*v);
    if (s.points.empty()) return {};
    for (ExactHalfspace& h : halfspaces_of(s)) all.push_back(std::move(h));
  }
  return meeting::meet_halfspaces(all);
}

}  // namespace plumb::query
