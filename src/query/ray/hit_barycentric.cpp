// Three volumes about the line, as pairs of doubles, where the ray certainly passes through the inside of the triangle;
// else the exact point, which needs no case for rays along edges and in the plane.
#include "plumb/query/ray/hit_barycentric.hpp"

#include "arith/exact_number.hpp"
#include "query/ray/numbers.hpp"
#include "query/ray/posed_barycentric.hpp"
#include "query/ray/posed_triangle.hpp"

namespace plumb {
namespace query {
namespace {

/// Nothing where doubles leave a doubt, of whether the triangle is hit as well as of a number.
std::optional<HitBarycentric> surely(const AnyRay& ray, const PosedTriangle3& triangle) {
  const WeightedCorners<Ball> corners(triangle);
  const Vec3<Ball> from = corners.beside(vector_of<Ball>(ray.origin)), d = direction_of<Ball>(ray);
  const Vec3<Ball> a = corners.at[0] - from, b = corners.at[1] - from, c = corners.at[2] - from;
  const Ball at_a = dot(d, cross(b, c)), at_b = dot(d, cross(c, a)), at_c = dot(d, cross(a, b));
  const Ball whole = at_a + at_b + at_c;
  RaySigns ask;
  const Sign way = ask(whole);
  if (way == Sign::zero || ask(at_a) != way || ask(at_b) != way || ask(at_c) != way) return {};
  const Ball time = dot(a, cross(b, c));
  if (begins(ray) && ask(time) != way) return {};
  if (ends(ray) && ask(corners.beside(whole) - time) != way) return {};
  if (!ask.certain()) return {};
  const auto u = quotient(at_b, whole).nearest(), v = quotient(at_c, whole).nearest();
  if (!u || !v) return {};
  return HitBarycentric{*u, *v};
}

using Exact = Vec3<Rational>;

bool is_origin(const Exact& v) {
  return v.x.sign() == Sign::zero && v.y.sign() == Sign::zero && v.z.sign() == Sign::zero;
}
Rational square_of(const Exact& v) { return dot(v, v); }

/// The point is on the triangle, whose corners are on one line.
ExactHitBarycentric along_edges(const std::array<Exact, 3>& corner, const Exact& point) {
  const auto at_corners = [](std::size_t i, const Rational& share) {  // from corner i to the next
    const std::size_t next = (i + 1) % 3;
    const auto weight = [&](std::size_t k) { return k == next ? share : k == i ? Rational(1) - share : Rational(0); };
    return ExactHitBarycentric{weight(1), weight(2)};
  };
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_origin(point - corner[i])) return at_corners(i, Rational(0));
  }
  const auto share_along = [&](std::size_t i) {
    const Exact edge = corner[(i + 1) % 3] - corner[i];
    return is_origin(edge) ? Rational(0) : Rational(dot(point - corner[i], edge) / square_of(edge));
  };
  for (const std::size_t i : {0U, 1U}) {
    const Rational share = share_along(i);
    if (share > Rational(0) && share < Rational(1)) return at_corners(i, share);
  }
  return at_corners(2, share_along(2));  // what is on three points of a line is between two of them
}

ExactHitBarycentric at_parameter(const AnyRay& ray, const PosedTriangle3& triangle, const Rational& t) {
  const WeightedCorners<Rational> corners(triangle);
  const auto& [a, b, c] = corners.at;
  const Exact along =
      ends(ray) ? vector_of<Rational>(ray.end) - vector_of<Rational>(ray.origin) : vector_of<Rational>(ray.direction);
  const Exact point = corners.beside(vector_of<Rational>(ray.origin) + along * t);
  const Exact normal = cross(b - a, c - a);
  if (is_origin(normal)) return along_edges(corners.at, point);
  const Rational whole = square_of(normal);
  return {dot(cross(c - point, a - point), normal) / whole, dot(cross(a - point, b - point), normal) / whole};
}

}  // namespace

std::optional<ExactHitBarycentric> exact_hit_barycentric(const AnyRay& ray, const PosedTriangle3& triangle) {
  const auto t = first_hit_parameter(ray, triangle, HitRule::closed);
  if (!t) return {};
  return at_parameter(ray, triangle, t->base);
}
std::optional<HitBarycentric> hit_barycentric(const AnyRay& ray, const PosedTriangle3& triangle) {
  if (const auto sure = surely(ray, triangle)) return sure;
  const auto exact = exact_hit_barycentric(ray, triangle);
  if (!exact) return {};
  return HitBarycentric{exact->u.rounded() + 0.0, exact->v.rounded() + 0.0};
}

}  // namespace query

std::optional<HitBarycentric> hit_barycentric(const AnyRay& ray, const Triangle3& triangle) {
  query::require_ray("hit_barycentric", ray, triangle);
  return query::hit_barycentric(ray, query::standing(triangle));
}
std::optional<ExactHitBarycentric> exact_hit_barycentric(const AnyRay& ray, const Triangle3& triangle) {
  query::require_ray("exact_hit_barycentric", ray, triangle);
  return query::exact_hit_barycentric(ray, query::standing(triangle));
}

}  // namespace plumb
