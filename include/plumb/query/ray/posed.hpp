// Ray cast at moved figures: at which parameter does a ray, a segment or a line first hit a figure under a pose?
//
//   first_hit_parameter(ray, Posed{box, pose})   nothing, or the exact t; t.rounded() is the nearest double
//   hits(ray, Posed{ball, sheared})              yes or no
//   first_hit(ray, Posed{triangle, pose})        t, point, feature and normal, of a triangle
//
// Laws: (1) the t of query/ray/ray.hpp and ray2.hpp, of the exact image: of every figure with straight edges and flat faces
// that is asked there, under any matrix, and of balls, disks, capsules and lozenges under those that are not singular,
// whatever they make of them.  The ray may be posed as well: t counts multiples of the posed direction.  (2) So a common pose that is not
// singular changes no t.  (3) What a singular matrix flattens is the flat figure that it becomes.
// Cylinders and cones are refused by the compiler, a round figure that is flattened throws UnevenPose; NaN and
// infinity throw NonFinite, what is no shape InvalidShape, by name.
// Source: RTCD 3.2, 5.3.
// Cost: rationals: some 40 us for a ball, 120 us for a box.
#pragma once

#include <concepts>
#include <optional>

#include "plumb/query/body/posed.hpp"
#include "plumb/query/ray/ray.hpp"
#include "plumb/query/ray/ray2.hpp"

namespace plumb {

namespace query {

std::optional<Hit> posed_first_hit(const AnyRay& ray, const Posed<Triangle3>& triangle, HitRule rule);

/// The first is a line, a ray or a segment.
std::optional<RayParameter> posed_first_hit_parameter(std::string_view function, const PosedView& ray,
                                                      const PosedView& figure);

template <class Ray, class Shape>
concept PosedShot = PosedFigures<Ray, Shape> && is_one_of(figure_kind<UnposedType<Ray>>,
                                                          {FigureKind::line, FigureKind::ray, FigureKind::segment}) &&
                    !is_one_of(figure_kind<UnposedType<Shape>>, {FigureKind::cylinder, FigureKind::cone}) &&
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

/// By either rule; the normal is the cross product of the posed edges.
template <class Ray>
requires std::convertible_to<Ray, AnyRay> std::optional<Hit> first_hit(const Ray& ray, const Posed<Triangle3>& triangle,
                                                                       HitRule rule = HitRule::closed) {
  return query::posed_first_hit(ray, triangle, rule);
}

}  // namespace plumb
