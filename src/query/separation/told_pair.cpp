#include "query/separation/told_pair.hpp"

#include "arith/rounded_radical.hpp"
#include "query/body/vectors.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/convex/features.hpp"

namespace plumb::query {
namespace {

/// The way between both points over one denominator.
struct Way {
  BigDyadic whole, square;  // of the numerators
  std::array<BigDyadic, 3> from, to;

  explicit Way(const NearestPair& pair) {
    mpz_class common = 1;
    for (const Exact3* p : {&pair.on_a, &pair.on_b}) {
      for (const mpq_class& x : *p) common = lcm(common, x.get_den());
    }
    const auto numerator = [&](const mpq_class& x) {
      return BigDyadic(mpz_class(x.get_num() * mpz_class(common / x.get_den())));
    };
    square = BigDyadic(0.0);
    for (std::size_t k = 0; k < 3; ++k) {
      from[k] = numerator(pair.on_a[k]), to[k] = numerator(pair.on_b[k]);
      const BigDyadic way = to[k] - from[k];
      square = square + way * way;
    }
    whole = BigDyadic(std::move(common));
  }
};

/// `from`, moved by the radius n / m toward `to`: p / w + v n / (m sqrt(s)) with p, v integers over the whole w, s the
/// square of v.
Point3 moved(const Way& w, const std::array<BigDyadic, 3>& from, const std::array<BigDyadic, 3>& to,
             const mpq_class& radius) {
  const BigDyadic over{mpz_class(radius.get_num())}, under{mpz_class(radius.get_den())};
  const auto coordinate = [&](std::size_t k) {
    if (sgn(radius) == 0) return rounded_quotient(Rounding::nearest, from[k], w.whole);
    return rounded_radical(Rounding::nearest, from[k] * w.square * under, (to[k] - from[k]) * over * w.whole, w.square,
                           w.square * w.whole * under);
  };
  return told(Point3{coordinate(0), coordinate(1), coordinate(2)});
}

Point3 rounded_point(const Exact3& p) {
  const auto r = [](const mpq_class& x) { return plumb::rounded(Rounding::nearest, x); };
  return told(Point3{r(p[0]), r(p[1]), r(p[2])});
}

}  // namespace

double rounded_distance(const mpq_class& square, const mpq_class& radii) {
  if (square <= radii * radii) return 0;
  const BigDyadic n{mpz_class(square.get_num())}, d{mpz_class(square.get_den())};
  if (sgn(radii) == 0) return rounded_root(Rounding::nearest, n, d);
  // sqrt(n / d) - p / q = (-p d + q sqrt(n d)) / (q d).
  const BigDyadic p{mpz_class(radii.get_num())}, q{mpz_class(radii.get_den())};
  return rounded_radical(Rounding::nearest, BigDyadic(0.0) - p * d, q, n * d, q * d);
}

Closest told_places(const NearestPair& pair, const mpq_class& radius_a, const mpq_class& radius_b) {
  constexpr Feature interior{FeatureKind::interior, 0};
  const mpq_class radii = radius_a + radius_b;
  Closest c{{}, {}, rounded_distance(pair.square, radii), interior, interior};
  if (pair.square > radii * radii) {
    const Way way(pair);
    c.on_a = moved(way, way.from, way.to, radius_a), c.on_b = moved(way, way.to, way.from, radius_b);
  } else if (sgn(radii) == 0) {
    c.on_a = c.on_b = rounded_point(pair.on_a);
  } else {
    const mpq_class part = radius_a / radii;
    c.on_a = c.on_b = rounded_point(pair.on_a + part * (pair.on_b - pair.on_a));
  }
  return c;
}

Closest told_pair(const NearestPair& pair, const SeenFigure& a, const SeenFigure& b) {
  const mpq_class radii = a.radius + b.radius;
  const bool overlap = pair.square < radii * radii;
  Closest c = told_places(pair, a.radius, b.radius);
  c.feature_a = feature_at(a.figure, pair.on_a, overlap && sgn(a.radius) > 0, a.map);
  c.feature_b = feature_at(b.figure, pair.on_b, overlap && sgn(b.radius) > 0, b.map);
  return c;
}

}  // namespace plumb::query
