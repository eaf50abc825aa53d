// Circles and capsules of the plane as the balls and capsules about them, oriented boxes as rectangles, k-DOPs as those
// of space: the plane z = 0 rounds nothing.
#include <cmath>
#include <vector>

#include "plumb/figure/containment/contains.hpp"
#include "plumb/query/ray/hits.hpp"
#include "query/ray/lifted.hpp"

namespace plumb {
namespace query {
namespace {

using query::in_space;

KDop3 in_space(const KDop2& k_dop) {
  std::vector<Vector3> directions;
  for (const Vector2& d : k_dop.directions.all()) directions.push_back(plumb::in_space(d));
  return {Directions3(directions), k_dop.min, k_dop.max};
}
template <class T>
T flat_turn(const Vec3<T>& u, const Vec3<T>& v) {
  return u.x * v.y - u.y * v.x;
}

/// Of what has faces in space where it has edges in the plane.
template <class Shape>
std::optional<Hit2> hit_round(const AnyRay2& ray, const Shape& s) {
  require_ray2("first_hit", ray, s);
  const std::optional<Hit> hit = first_hit(in_space(ray), in_space(s));
  if (!hit) return {};
  const bool inside = hit->feature.kind == FeatureKind::interior;
  return Hit2{hit->t,
              {hit->point.x, hit->point.y},
              {inside ? FeatureKind::face : FeatureKind::edge, hit->feature.index},
              {hit->normal.x, hit->normal.y}};
}
template <class Shape>
std::optional<RayParameter> parameter_round(const AnyRay2& ray, const Shape& s) {
  require_ray2("first_hit_parameter", ray, s);
  return first_hit_parameter(in_space(ray), in_space(s));
}

/// As a rectangle of the plane z = 0.
Rectangle3 in_space(const Obb2& b) {
  return {plumb::in_space(b.center), {plumb::in_space(b.axes[0]), plumb::in_space(b.axes[1])}, b.half};
}
template <class Shape>
bool hits_lifted(const AnyRay2& ray, const Shape& s) {
  require_ray2("hits", ray, s);
  return hits(in_space(ray), in_space(s));
}

/// Rounded once: doubling is exact, before or after.
double twice_product(double half, double x) {
  const double h = std::fabs(half);
  return h < 1 ? h * 2 * x : h * x * 2;
}

/// Perpendicular to the first edge that holds the point and that the ray does not run along: only its axis matters.
Vector2 normal_of(const AnyRay& ray, const Obb2& box, const Feature& at) {
  const bool corner = at.kind == FeatureKind::vertex;
  for (const std::uint32_t axis : {0u, 1u}) {
    if (!corner && at.index / 2 != axis) continue;
    const double half = axis == 0 ? box.half.x : box.half.y;
    const Vector2& along = box.axes[axis];
    const Sign across = certainly<RayWorlds>([&]<class T>(RayWorld<T>& ask) {
      return ask(flat_turn(direction_of<T>(ray), vector_of<T>(plumb::in_space(along))));
    });
    if (half == 0 || across == Sign::zero) continue;
    const double way = across == Sign::positive ? -1 : 1;
    return {way * twice_product(half, along.y) + 0.0, -way * twice_product(half, along.x) + 0.0};
  }
  return {0, 0};
}

bool begins_in(const AnyRay2& ray, const Obb2& box) {
  const AnyRay lifted = in_space(ray);
  return (begins(lifted) || has_no_direction(lifted)) && locate(box, ray.origin) == Location::inside;
}

std::optional<Hit2> hit_oriented(const AnyRay2& ray, const Obb2& box) {
  require_ray2("first_hit", ray, box);
  if (begins_in(ray, box)) return Hit2{0, {ray.origin.x + 0.0, ray.origin.y + 0.0}, {FeatureKind::face, 0}, {0, 0}};
  const AnyRay lifted = in_space(ray);
  const auto hit = first_hit(lifted, in_space(box));
  if (!hit) return {};
  return Hit2{hit->t, {hit->point.x, hit->point.y}, hit->feature, normal_of(lifted, box, hit->feature)};
}
std::optional<RayParameter> parameter_oriented(const AnyRay2& ray, const Obb2& box) {
  require_ray2("first_hit_parameter", ray, box);
  return first_hit_parameter(in_space(ray), in_space(box));
}

}  // namespace
}  // namespace query

using query::hit_round, query::parameter_round, query::hits_lifted;

std::optional<Hit2> first_hit(const AnyRay2& r, const Circle2& s) { return hit_round(r, s); }
std::optional<Hit2> first_hit(const AnyRay2& r, const Capsule2& s) { return hit_round(r, s); }
std::optional<Hit2> first_hit(const AnyRay2& r, const Obb2& s) { return query::hit_oriented(r, s); }
std::optional<Hit2> first_hit(const AnyRay2& r, const KDop2& s) { return query::hit_round(r, s); }

using Parameter = std::optional<RayParameter>;
Parameter first_hit_parameter(const AnyRay2& r, const Circle2& s) { return parameter_round(r, s); }
Parameter first_hit_parameter(const AnyRay2& r, const Capsule2& s) { return parameter_round(r, s); }
Parameter first_hit_parameter(const AnyRay2& r, const Obb2& s) { return query::parameter_oriented(r, s); }
Parameter first_hit_parameter(const AnyRay2& r, const KDop2& s) { return query::parameter_round(r, s); }

bool hits(const AnyRay2& r, const Circle2& s) { return hits_lifted(r, s); }
bool hits(const AnyRay2& r, const Capsule2& s) { return hits_lifted(r, s); }
bool hits(const AnyRay2& r, const Obb2& s) { return hits_lifted(r, s); }
bool hits(const AnyRay2& r, const KDop2& s) { return hits_lifted(r, s); }

}  // namespace plumb
