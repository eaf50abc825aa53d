// What two exact sets have in common: all that bounds either, and its generators.
#include "plumb/query/section/posed.hpp"
#include "query/body/posed_input.hpp"
#include "query/convex/posed_set.hpp"
#include "query/convex/set.hpp"
#include "query/overlap/polygon_relation.hpp"
#include "query/section/meet_halfspaces.hpp"

namespace plumb::query {
namespace {

FlatSet convex_image(const PosedView& v) {
  PosedSet s = posed_set(v);
  if (v.figure.kind == FigureKind::polygon) {
    // Throws where it is not convex.
    if (v.figure.dimension == 2) {
      static_cast<void>(meeting::convex_set2(v.figure));
    } else {
      static_cast<void>(meeting::convex_set3(v.figure));
    }
    s.core.points = exact_chains("intersection", v.figure)[0];
  }
  return image(s);
}

bool is_a_double(const Rational& x) {
  const double d = x.rounded();
  return d - d == 0 && Rational(d) == x;
}

/// A point as given where its numbers are doubles.
ExactPoint3 shortest(const ExactPoint3& p) {
  const RationalPoint3 r = rational_point(p);
  if (!is_a_double(r.x) || !is_a_double(r.y) || !is_a_double(r.z)) return r;
  return Point3{r.x.rounded(), r.y.rounded(), r.z.rounded()};
}
ExactPoint2 in_plane(const ExactPoint3& p) {
  const RationalPoint3 r = rational_point(p);
  if (!is_a_double(r.x) || !is_a_double(r.y)) return RationalPoint2{r.x, r.y};
  return Point2{r.x.rounded(), r.y.rounded()};
}

}  // namespace

Intersection2 posed_intersection2(const PosedView& a, const PosedView& b) {
  const SolidIntersection3 common = posed_solid(a, b);
  Intersection2 r{common.kind, {}};
  for (const ExactPoint3& p : common.vertices) r.vertices.push_back(in_plane(p));
  return r;
}
Intersection3 posed_intersection3(const PosedView& a, const PosedView& b) {
  const SolidIntersection3 common = posed_solid(a, b);
  Intersection3 r{common.kind, {}};
  for (const ExactPoint3& p : common.vertices) r.vertices.push_back(shortest(p));
  return r;
}

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
