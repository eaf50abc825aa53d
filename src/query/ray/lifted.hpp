// Which ray of space is a ray of the plane?  The one in z = 0.
//
// Law: exact.
// Source: RTCD 3.2.
// Cost: none.
#pragma once

#include "figure/basic/in_space.hpp"
#include "plumb/query/ray/ray2.hpp"
#include "query/ray/numbers.hpp"

namespace plumb::query {

inline AnyRay in_space(const AnyRay2& r) {
  if (r.kind == AnyRay::Kind::segment) return Segment3{plumb::in_space(r.origin), plumb::in_space(r.end)};
  const Vector3 direction{r.direction.x, r.direction.y, 0};
  if (r.kind == AnyRay::Kind::line) return Line3{plumb::in_space(r.origin), direction};
  return Ray3{plumb::in_space(r.origin), direction};
}

/// Throws as query/body/figure_input.hpp says.
template <class Shape>
void require_ray2(std::string_view function, const AnyRay2& ray, const Shape& s) {
  switch (ray.kind) {
    case AnyRay::Kind::ray:
      return require_figures(function, Ray2{ray.origin, ray.direction}, s);
    case AnyRay::Kind::segment:
      return require_figures(function, Segment2{ray.origin, ray.end}, s);
    default:
      return require_figures(function, Line2{ray.origin, ray.direction}, s);
  }
}

}  // namespace plumb::query
