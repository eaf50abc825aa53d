#include "plumb/query/penetration/penetration.hpp"

#include "arith/rounded_radical.hpp"
#include "plumb/arith/ball.hpp"
#include "query/penetration/flush_feature.hpp"
#include "query/penetration/parted.hpp"

namespace plumb::query {
namespace {

using namespace parting;  // NOLINT: all of it is of this question

/// What is told of a parting: numbers are of a way v, the squared length w of it, and how far along it the cores'
/// planes overlap, times its length: h, below zero where they are apart.
template <class T>
struct Lengths {
  Vec<T> way;
  T square, overlap;

  Lengths(const Difference& d, const Way& along, const Ends& in_plane)
      : way(along.along<T>(d)), square(dot(way, way)), overlap(T(0.0) - dot(way, d.at<T>(in_plane))) {}
};

struct Told {
  std::array<Body, 2> bodies;
  Parting parting;
  Feature feature_a, feature_b;
  Ends in_plane;

  [[nodiscard]] Difference difference() const { return {bodies[0].corners, bodies[1].corners}; }
  [[nodiscard]] bool is_round() const { return sgn(bodies[0].radius) != 0 || sgn(bodies[1].radius) != 0; }
  [[nodiscard]] mpq_class radii() const { return bodies[0].radius + bodies[1].radius; }
};

std::optional<Told> told_of(std::string_view function, const BodyView& a, const BodyView& b) {
  const std::array<Body, 2> bodies = bodies_of(function, a, b);
  const auto parting = parted(bodies[0], bodies[1]);
  if (!parting) return {};
  const FlushPair flush = flush_pair(a, b, {bodies[0].corners, bodies[1].corners}, parting->way);
  return Told{bodies, *parting, flush.a, flush.b, flush.in_plane};
}

/// Numbers by pairs of doubles; nothing where these leave one open.
std::optional<Penetration> quick_numbers(const Told& t) {
  const Lengths<Ball> n(t.difference(), t.parting.way, t.in_plane);
  double radius = 0;
  if (t.is_round()) {
    const mpq_class radii = t.radii();
    radius = radii.get_d();
    if (radius != radii) return {};
  }
  const Ball length = root(n.square), both = Ball(radius);
  const auto unit = [&](const Ball& x) { return quotient(x, length); };
  const Ball depth = both + unit(n.overlap);
  const Ball share = radius == 0 ? quotient(n.overlap, n.square) : quotient(depth, length);
  Penetration p{0, {}, {}, t.feature_a, t.feature_b, t.parting.is_unique};
  bool is_told = true;
  const auto tell = [&](double& to, const Ball& from) {
    const auto nearest = from.nearest();
    is_told = is_told && nearest;
    to = nearest.value_or(0);
  };
  tell(p.depth, depth);
  tell(p.direction.x, unit(n.way.x)), tell(p.direction.y, unit(n.way.y)), tell(p.direction.z, unit(n.way.z));
  tell(p.translation.x, n.way.x * share), tell(p.translation.y, n.way.y * share),
      tell(p.translation.z, n.way.z * share);
  if (!is_told) return {};
  return p;
}

Penetration exact_numbers(const Told& t) {
  const Lengths<BigDyadic> n(t.difference(), t.parting.way, t.in_plane);
  const mpq_class radii = t.radii();
  const BigDyadic over{mpz_class(radii.get_num())}, under{mpz_class(radii.get_den())}, none(0.0);
  constexpr Rounding nearest = Rounding::nearest;
  const bool is_round = sgn(radii) != 0;
  Penetration p{0, {}, {}, t.feature_a, t.feature_b, t.parting.is_unique};
  // over / under + h / root(w), which is (over w + under h root(w)) / (under w).
  p.depth = is_round ? rounded_radical(nearest, over * n.square, under * n.overlap, n.square, under * n.square)
                     : rounded_root(nearest, n.overlap * n.overlap, n.square);
  const auto unit = [&](const BigDyadic& x) { return rounded_radical(nearest, none, x, n.square, n.square) + 0.0; };
  p.direction = {unit(n.way.x), unit(n.way.y), unit(n.way.z)};
  const auto move = [&](const BigDyadic& x) {
    return is_round ? rounded_radical(nearest, x * under * n.overlap, x * over, n.square, under * n.square) + 0.0
                    : rounded_quotient(nearest, x * n.overlap, n.square) + 0.0;
  };
  p.translation = {move(n.way.x), move(n.way.y), move(n.way.z)};
  return p;
}

Rational rational(const mpq_class& x) { return Rational(BigRational{x}); }

ExactVector3 primitive(const Vec<mpq_class>& v) {
  const std::array all{v.x, v.y, v.z};
  mpz_class denominators = 1, divisor = 0;
  for (const mpq_class& x : all) denominators = lcm(denominators, x.get_den());
  for (const mpq_class& x : all) divisor = gcd(divisor, mpz_class(x.get_num() * (denominators / x.get_den())));
  mpq_class factor(denominators, divisor);
  factor.canonicalize();
  return {rational(v.x * factor), rational(v.y * factor), rational(v.z * factor)};
}

}  // namespace

std::optional<Penetration> penetration_of(const BodyView& a, const BodyView& b) {
  const auto told = told_of("penetration", a, b);
  if (!told) return {};
  if (const auto quick = quick_numbers(*told)) return quick;
  return exact_numbers(*told);
}

std::optional<ExactPenetration> exact_penetration_of(const BodyView& a, const BodyView& b) {
  const auto told = told_of("exact_penetration", a, b);
  if (!told) return {};
  const Lengths<mpq_class> n(told->difference(), told->parting.way, told->in_plane);
  const mpq_class share = n.overlap / n.square, square = n.overlap * share;
  return ExactPenetration{
      primitive(n.way),        {rational(n.way.x * share), rational(n.way.y * share), rational(n.way.z * share)},
      rational(square),        told->parting.cores_are_apart,
      rational(told->radii()), told->feature_a,
      told->feature_b,         told->parting.is_unique};
}

}  // namespace plumb::query
