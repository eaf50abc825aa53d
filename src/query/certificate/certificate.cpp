#include "plumb/query/certificate/certificate.hpp"

#include <algorithm>
#include <cmath>

#include "arith/exact_number.hpp"
#include "arith/running_error.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "query/certificate/evidence.hpp"
#include "query/separation/convex_body.hpp"
#include "query/separation/told_pair.hpp"

namespace plumb::query {
namespace {

/// A ConvexPolyhedron3 is checked, whoever filled it in.
std::array<Body, 2> sound_bodies(std::string_view function, const BodyView& a, const BodyView& b) {
  std::array<Body, 2> bodies = bodies_of(function, a, b);
  const bool alike = bodies[0].corners.polyhedron() != nullptr && bodies[1].corners.polyhedron() != nullptr;
  for (std::size_t i = 0; i < 2; ++i) {
    if (const ConvexPolyhedron3* p = bodies[i].corners.polyhedron()) {
      const std::string_view name = !alike ? "polyhedron" : i == 0 ? "a" : "b";
      check_polyhedron(*p, std::string(function).append(": ").append(name));
    }
  }
  return bodies;
}

/// The same way in integers without a common factor.
ExactVector3 direction_in_integers(const Exact3& n) {
  const Exact3 whole = primitive(n);
  return {exact_number(whole[0]), exact_number(whole[1]), exact_number(whole[2])};
}

/// Nearly the same way in doubles: a guess.
ExactVector3 direction_in_doubles(const ExactVector3& n) {
  const auto bits = [](const Rational& x) {
    return static_cast<long>(mpz_sizeinbase(gmp_number(x).get_num_mpz_t(), 2));
  };
  const long most = std::max({bits(n.x), bits(n.y), bits(n.z)});
  const auto rounded = [most](const Rational& x) {
    long exponent = 0;
    const double part = mpz_get_d_2exp(&exponent, gmp_number(x).get_num_mpz_t());
    return Rational(std::ldexp(part, static_cast<int>(std::max(exponent - most, -1000L))));
  };
  return {rounded(n.x), rounded(n.y), rounded(n.z)};
}

/// From a to b, of cores whose difference has this point nearest to the origin.
ExactVector3 direction_of(const NearestDifference& nearest) {
  return direction_in_integers(mpq_class(-1) * nearest.at);
}

/// Do doubles prove that the direction leaves a gap of more than the radii?
bool leaves_gap(const ExactVector3& n, const Body& a, const Body& b, const mpq_class& radii) {
  const arith::Vec<Running> way{Running(n.x.rounded()), Running(n.y.rounded()), Running(n.z.rounded())};
  double end = -HUGE_VAL, begin = HUGE_VAL;
  for (std::size_t i = 0; i < a.corners.size(); ++i) end = std::max(end, dot(way, a.corners.at<Running>(i)).upper());
  for (std::size_t i = 0; i < b.corners.size(); ++i)
    begin = std::min(begin, dot(way, b.corners.at<Running>(i)).lower());
  if (!(begin > end) || !std::isfinite(begin) || !std::isfinite(end)) return false;
  const mpq_class gap = (mpq_class(begin) - mpq_class(end)) / gmp_number(a.corners.scale<BigDyadic>());
  const mpq_class length = gmp_number(n.x * n.x + n.y * n.y + n.z * n.z);
  return gap * gap > radii * radii * length;
}

Certificate disjoint(const Body& a, const Body& b, const NearestDifference& nearest) {
  const ExactVector3 exact = direction_of(nearest), rounded = direction_in_doubles(exact);
  return {Claim::disjoint, leaves_gap(rounded, a, b, a.radius + b.radius) ? rounded : exact, {}};
}

}  // namespace

Certificate certified_relation(const BodyView& view_a, const BodyView& view_b) {
  const auto [a, b] = sound_bodies("relate_with_proof", view_a, view_b);
  const mpq_class radii = a.radius + b.radius, reach = radii * radii;
  NearestDifference nearest = nearest_difference(a.corners, b.corners);
  const int order = cmp(nearest.square, reach);
  if (order > 0) return disjoint(a, b, nearest);
  if (sgn(reach) > 0 && order == 0) return {Claim::touching, direction_of(nearest), std::move(nearest.pairs)};
  if (sgn(reach) > 0) return {Claim::overlapping, {}, std::move(nearest.pairs)};
  SpanOrPlane s = span_or_plane(a.corners, b.corners, nearest.pairs);
  if (s.normal) return {Claim::touching, direction_in_integers(*s.normal), std::move(nearest.pairs)};
  return {Claim::overlapping, {}, std::move(s.pairs)};
}

Certificate certified_intersection(const BodyView& view_a, const BodyView& view_b) {
  const auto [a, b] = sound_bodies("intersects_with_proof", view_a, view_b);
  const mpq_class radii = a.radius + b.radius;
  NearestDifference nearest = nearest_difference(a.corners, b.corners);
  if (nearest.square > radii * radii) return disjoint(a, b, nearest);
  return {Claim::intersecting, {}, std::move(nearest.pairs)};
}

DistanceCertificate certified_distance(const BodyView& view_a, const BodyView& view_b) {
  const auto [a, b] = sound_bodies("distance_with_proof", view_a, view_b);
  const mpq_class radii = a.radius + b.radius;
  NearestDifference nearest = nearest_difference(a.corners, b.corners);
  DistanceCertificate c{
      rounded_distance(nearest.square, radii), {exact_number(nearest.square), exact_number(radii)}, {}, {}};
  if (sgn(nearest.square) > 0) c.direction = direction_of(nearest);
  c.pairs = std::move(nearest.pairs);
  return c;
}

}  // namespace plumb::query
