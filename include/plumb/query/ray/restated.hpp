// Ray cast at slabs and at boxes by width or by center: where does a ray, a segment or a line first hit one?
//
//   first_hit(ray, Slab3{normal, 1, 2})              nothing, or { t, point, feature, normal }
//   first_hit_parameter(ray, AabbWidths3{...})       the exact t
//
// Laws: those of query/ray/ray.hpp and ray2.hpp, of the sets that the numbers say: a box has the features and normals of an
// Aabb3, a slab those of the k-DOP of its one direction.  A box by its widths whose ends are no doubles has no first_hit:
// it is asked for its parameter.
// NaN and infinity throw NonFinite, by name.
// Source: RTCD 5.3.3, 4.6.1.
// Cost: that of an Aabb3 or a k-DOP; where an end is no double that of an Obb3, or rationals, some 120 us.  Nothing
// is searched but what first_hit of that figure searches (query/ray/posed.hpp).
#pragma once

#include "plumb/query/body/restated.hpp"
#include "plumb/query/ray/posed.hpp"

namespace plumb {

namespace query {

inline KDop2 k_dop_of(const Vector2& normal, double min, double max) { return {Directions2({normal}), {min}, {max}}; }
inline KDop3 k_dop_of(const Vector3& normal, double min, double max) { return {Directions3({normal}), {min}, {max}}; }

/// `ask` of the k-DOP of the slab's direction; without one the slab is all, in which `start` is the answer, or nothing.
template <class Slab, class Answer, class Ask>
auto at_slab(std::string_view function, const Slab& s, const Answer& start, const Ask& ask) {
  require_slab(function, s);
  auto normal = s.normal;
  const bool has_direction = normal != decltype(normal){};
  if (has_direction) return ask(k_dop_of(normal, s.min, s.max));
  normal.x = 1;
  auto answer = ask(k_dop_of(normal, 0, 0));  // looks at the ray
  answer.reset();
  if (s.min <= 0 && 0 <= s.max) answer = start;
  return answer;
}

template <class Ray>
auto start_of_ray(const Ray& ray) {
  if constexpr (requires { ray.origin; }) {
    return ray.origin;
  } else if constexpr (requires { ray.point; }) {
    return ray.point;
  } else {
    return ray.a;
  }
}

template <class Ray, class Shape>
concept ShotAtRestated = StraightRay<Ray> && RestatedPair<Ray, Shape> && figure_dimension<Ray>
== figure_dimension<UnposedType<SaidType<Shape>>>;

template <class Ray, class Shape>
std::optional<RayParameter> restated_parameter(std::string_view function, const Ray& ray, const Shape& shape) {
  const auto ask = [&](const auto& s) { return first_hit_parameter(ray, s); };
  if constexpr (AnySlab<Shape>) {
    return at_slab(function, shape, RayParameter{}, ask);
  } else {
    return restated(function, shape, ask);
  }
}

}  // namespace query

template <class Ray, class Shape>
requires query::ShotAtRestated<Ray, Shape> std::optional<RayParameter> first_hit_parameter(const Ray& ray,
                                                                                           const Shape& shape) {
  return query::restated_parameter("first_hit_parameter", ray, shape);
}

template <class Ray, class Shape>
requires query::ShotAtRestated<Ray, Shape>
bool hits(const Ray& ray, const Shape& shape) { return query::restated_parameter("hits", ray, shape).has_value(); }

template <class Ray>
requires query::ShotAtRestated<Ray, AabbCenter3> std::optional<Hit> first_hit(const Ray& ray, const AabbCenter3& box) {
  return query::restated("first_hit", box, [&](const auto& s) { return first_hit(ray, s); });
}
template <class Ray>
requires query::ShotAtRestated<Ray, Slab3> std::optional<Hit> first_hit(const Ray& ray, const Slab3& slab) {
  const Hit start{0, query::start_of_ray(ray), {FeatureKind::interior, 0}, {0, 0, 0}};
  return query::at_slab("first_hit", slab, start, [&](const KDop3& s) { return first_hit(ray, s); });
}
template <class Ray>
requires query::ShotAtRestated<Ray, Slab2> std::optional<Hit2> first_hit(const Ray& ray, const Slab2& slab) {
  const Hit2 start{0, query::start_of_ray(ray), {FeatureKind::face, 0}, {0, 0}};
  return query::at_slab("first_hit", slab, start, [&](const KDop2& s) { return first_hit(ray, s); });
}

}  // namespace plumb
