#include "plumb/query/certificate/certificate.hpp"

#include <cmath>

#include "plumb/query/certificate/verify.hpp"
#include "query/certificate/evidence.hpp"
#include "query/certificate/number.hpp"
#include "query/certificate/sound_bodies.hpp"
#include "query/separation/told_pair.hpp"

namespace plumb::query {
namespace {

/// The same way in integers without a common factor.
ProofDirection direction_in_integers(const Exact3& n) {
  mpz_class denominators = 1, factors = 0;
  for (const mpq_class& x : n) denominators = lcm(denominators, x.get_den());
  std::array<mpz_class, 3> whole;
  for (std::size_t k = 0; k < 3; ++k) {
    whole[k] = n[k].get_num() * (denominators / n[k].get_den());
    factors = gcd(factors, whole[k]);
  }
  const auto over = [&](const mpz_class& x) { return rational(mpq_class(mpz_class(x / factors))); };
  return {over(whole[0]), over(whole[1]), over(whole[2])};
}

/// Nearly the same way in doubles: a guess.
ProofDirection direction_in_doubles(const ProofDirection& n) {
  const auto bits = [](const Rational& x) { return static_cast<long>(mpz_sizeinbase(number(x).get_num_mpz_t(), 2)); };
  const long most = std::max({bits(n.x), bits(n.y), bits(n.z)});
  const auto rounded = [most](const Rational& x) {
    long exponent = 0;
    const double part = mpz_get_d_2exp(&exponent, number(x).get_num_mpz_t());
    return Rational(std::ldexp(part, static_cast<int>(std::max(exponent - most, -1000L))));
  };
  return {rounded(n.x), rounded(n.y), rounded(n.z)};
}

/// From a to b, of cores whose difference has this point nearest to the origin.
ProofDirection direction_of(const NearestDifference& nearest) {
  return direction_in_integers(mpq_class(-1) * nearest.at);
}

Certificate disjoint(const BodyView& a, const BodyView& b, const NearestDifference& nearest) {
  const ProofDirection exact = direction_of(nearest);
  Certificate c{Claim::disjoint, direction_in_doubles(exact), {}};
  if (!verdict_on(c, a, b)) c.direction = exact;
  return c;
}

}  // namespace

Certificate certified_relation(const BodyView& view_a, const BodyView& view_b) {
  const auto [a, b] = sound_bodies("relate_with_proof", view_a, view_b);
  const mpq_class radii = a.radius + b.radius, reach = radii * radii;
  NearestDifference nearest = nearest_difference(a.corners, b.corners);
  const int order = cmp(nearest.square, reach);
  if (order > 0) return disjoint(view_a, view_b, nearest);
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
  if (nearest.square > radii * radii) return disjoint(view_a, view_b, nearest);
  return {Claim::intersecting, {}, std::move(nearest.pairs)};
}

DistanceCertificate certified_distance(const BodyView& view_a, const BodyView& view_b) {
  const auto [a, b] = sound_bodies("distance_with_proof", view_a, view_b);
  const mpq_class radii = a.radius + b.radius;
  NearestDifference nearest = nearest_difference(a.corners, b.corners);
  DistanceCertificate c{rounded_distance(nearest.square, radii), {rational(nearest.square), rational(radii)}, {}, {}};
  if (sgn(nearest.square) > 0) c.direction = direction_of(nearest);
  c.pairs = std::move(nearest.pairs);
  return c;
}

}  // namespace plumb::query
