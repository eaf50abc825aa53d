// Ray cast at moved figures: at which parameter does a ray, a segment or a line first hit a figure under a pose?
//
//   first_hit_parameter(ray, Posed{box, pose})   nothing, or the exact t; t.rounded() is the nearest double
//   hits(ray, Posed{ball, sheared})              yes or no
//   first_hit(ray, Posed{triangle, pose})        t, point, feature and normal, of a triangle
//
// Laws: (1) the t of query/ray/ray.hpp and ray2.hpp, of the exact image, of every figure that is asked there and can be
// posed: with straight edges and flat faces under any matrix, round ones under those that are not singular, whatever they
// make of them.  The ray may be posed as well: t counts multiples of the posed direction.  (2) So a common pose that is
// not singular changes no t and no feature.  (3) What a singular matrix flattens is the flat figure that it becomes.
// (4) first_hit tells the feature by its number without the pose, and rounds the exact point and normal once.
// The normal is what the cofactors of the matrix make of that of the figure as it stands, out of a solid also where the
// pose mirrors: of flat faces the cross product of the posed edges, of a round side perpendicular to it.  In the plane it
// is perpendicular to the posed edge.  Of what is flattened it is that of the first face that is hit, or not zero; of a
// round figure without a radius, or that becomes a point, it is zero then.  Any other round figure that is flattened
// throws UnevenPose; NaN and infinity throw NonFinite, what is no shape InvalidShape, by name.
// Source: RTCD 3.2, 5.3.
// Cost: a box that a ray as given meets takes doubles where they tell the signs, else integers; all others are asked in
// rationals: some 40 us for a ball.  Bounded by n signs for n corners, on integers as long as
// the exponents' span.
#pragma once

#include <concepts>
#include <optional>

#include "plumb/query/body/posed.hpp"
#include "plumb/query/ray/ray.hpp"
#include "plumb/query/ray/ray2.hpp"

namespace plumb {

namespace query {

std::optional<Hit> posed_first_hit(const AnyRay& ray, const Posed<Triangle3>& triangle, HitRule rule);
/// Of figures of the plane in the plane z = 0.
std::optional<Hit> posed_first_hit(const PosedView& ray, const PosedView& figure);

/// The first is a line, a ray or a segment.
std::optional<RayParameter> posed_first_hit_parameter(std::string_view function, const PosedView& ray,
                                                      const PosedView& figure);

template <class Ray, class Shape>
concept PosedShot = PosedFigures<Ray, Shape> && StraightRay<UnposedType<Ray>> &&
    requires(const UnposedType<Ray>& ray, const UnposedType<Shape>& shape) {
  first_hit_parameter(ray, shape);
};

}  // namespace query

template <class Ray, class Shape>
requires query::PosedShot<Ray, Shape> std::optional<RayParameter> first_hit_parameter(const Ray& ray,
                                                                                      const Shape& shape) {
  return query::posed_first_hit_parameter("first_hit_parameter", query::posed_view(ray), query::posed_view(shape));
}

template <class Ray, class Shape>
requires query::PosedShot<Ray, Shape>
bool hits(const Ray& ray, const Shape& shape) {
  return query::posed_first_hit_parameter("hits", query::posed_view(ray), query::posed_view(shape)).has_value();
}

/// A Hit, or in the plane a Hit2.
template <class Ray, class Shape>
requires query::PosedShot<Ray, Shape>
auto first_hit(const Ray& ray, const Shape& shape) {
  const auto hit = query::posed_first_hit(query::posed_view(ray), query::posed_view(shape));
  if constexpr (figure_dimension<query::UnposedType<Shape>> == 3) {
    return hit;
  } else {
    if (!hit) return std::optional<Hit2>();
    return std::optional(Hit2{hit->t, {hit->point.x, hit->point.y}, hit->feature, {hit->normal.x, hit->normal.y}});
  }
}

/// By either rule; the normal is the cross product of the posed edges.
template <class Ray>
requires std::convertible_to<Ray, AnyRay> std::optional<Hit> first_hit(const Ray& ray, const Posed<Triangle3>& triangle,
                                                                       HitRule rule = HitRule::closed) {
  return query::posed_first_hit(ray, triangle, rule);
}

}  // namespace plumb
