// Spherical caps against flat convex sets and balls: is each relation that of the sets?  Held against sets cut by their
// generators in rationals, and against the lowest point of two balls' common part in numbers of many bits.
#include <gtest/gtest.h>

#include "plumb/figure.hpp"
#include "query/overlap/cut_set.hpp"

namespace plumb {
namespace {

using oracle::RationalPoint, oracle::Spanned;
using pair_cases::Answers;
using shape_cases::Material, shape_cases::on_shapes;

enum class CapForm { nothing, point, solid };
struct FormOfCap {
  explicit FormOfCap(const SphericalCap3& cap) {
    const auto& [n, o] = cap.halfspace;
    const RationalPoint c = oracle::rational(cap.sphere.center), normal = oracle::rational(n);
    const mpq_class square = oracle::dot(normal, normal), r = cap.sphere.radius;
    const mpq_class beyond = oracle::dot(normal, c) - mpq_class(o), rest = r * r * square - beyond * beyond;
    if (sgn(beyond) > 0 && sgn(rest) < 0) return;
    form = sgn(r) == 0 || (sgn(beyond) > 0 && sgn(rest) == 0) ? CapForm::point : CapForm::solid;
    at = c;
    if (form == CapForm::point && sgn(r) > 0) at = oracle::sum(c, mpq_class(-beyond / square), normal);
  }
  CapForm form = CapForm::nothing;
  RationalPoint at;
};

template <class Flat>
Relation expected_relation(const Flat& flat, const SphericalCap3& cap) {
  const FormOfCap which(cap);
  const oracle::Pieces pieces = oracle::pieces(flat);
  if (which.form == CapForm::nothing) return Relation::disjoint;
  const Spanned middle{{which.at}, {}};
  if (which.form == CapForm::point) return oracle::RoundOracle(middle, pieces).relation(0);
  Relation most = Relation::disjoint;
  for (const Spanned& piece : pieces.inner) {  // one, of a convex set
    const oracle::CutSet cut(piece, oracle::rational(cap.halfspace.normal), cap.halfspace.offset);
    if (cut.within.points.empty()) continue;
    const Relation near = oracle::RoundOracle(middle, {{cut.within}, {}}).relation(cap.sphere.radius);
    most = near == Relation::overlapping && !cut.reaches_inside ? Relation::touching : near;
  }
  return most;
}

template <class Flat>
Answers expect_flat(std::uint64_t start) {
  Answers answers;
  constexpr std::uint64_t cases = pair_cases::is_costly(figure_kind<Flat>) ? 24 : 96;
  on_shapes(start, battery::sanitized ? 8 : cases, [&](Material& m) {
    auto cap = m.shape<SphericalCap3>();
    const auto flat = pair_cases::near_figure<Flat>(m);
    if (m.below(2) == 0) {  // so that the ball touches it
      const oracle::RoundOracle of_ball(oracle::core(cap.sphere), oracle::pieces(flat));
      if (of_ball.square()) {
        if (const auto root = oracle::exact_root(*of_ball.square())) cap.sphere.radius = *root;
      }
    }
    const Relation expected = expected_relation(flat, cap);
    answers.add(expected);
    expect_relation(flat, cap, expected, m.about(flat, cap));
    if constexpr (std::is_same_v<Flat, Point3>) {
      EXPECT_EQ(contains(cap, flat), expected != Relation::disjoint) << m.about(flat, cap);
      const bool solid = FormOfCap(cap).form == CapForm::solid;
      EXPECT_EQ(locate(cap, flat), solid                            ? static_cast<Location>(expected)
                                   : expected == Relation::disjoint ? Location::outside
                                                                    : Location::boundary)
          << m.about(flat, cap);
    }
  });
  return answers;
}

TEST(OverlapCap, FlatSetsAsBruteForce) {
  Answers all;
  std::uint64_t start = 900;
  const auto of = [&]<class... Flats>(pair_cases::Types<Flats...>) { (all.add(expect_flat<Flats>(start++)), ...); };
  of(pair_cases::Types<Point3, Line3, Ray3, Segment3, Plane3, ThreePointPlane3, Halfspace3, Triangle3, Rectangle3,
                       Tetrahedron3, Aabb3, Obb3, KDop3, HalfspaceIntersection3, ConvexPolyhedron3>{});
  std::printf("disjoint %d, touching %d, overlapping %d\n", all.of(Relation::disjoint), all.of(Relation::touching),
              all.of(Relation::overlapping));
  if (!battery::reaches_rare) return;
  for (const Relation r : {Relation::disjoint, Relation::touching, Relation::overlapping})
    EXPECT_GE(all.of(r) * 20, all.all());
}

/// Numbers of many bits, and what is all but zero.
constexpr unsigned cap_precision = 3000;
using Wide = mpf_class;
Wide wide(double x) { return Wide(x, cap_precision); }
int wide_sign(const Wide& x) {
  Wide least(1, cap_precision);
  mpf_div_2exp(least.get_mpf_t(), least.get_mpf_t(), 1000);
  return abs(x) < least ? 0 : sgn(x);
}
struct WideVector {
  Wide x, y, z;
  friend WideVector operator+(const WideVector& a, const WideVector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend WideVector operator*(const Wide& t, const WideVector& a) { return {t * a.x, t * a.y, t * a.z}; }
};
Wide product(const WideVector& a, const WideVector& b) { return {a.x * b.x + a.y * b.y + a.z * b.z, cap_precision}; }
WideVector wide(const auto& p) { return {wide(p.x), wide(p.y), wide(p.z)}; }
Wide root_of(const Wide& x) { return sgn(x) <= 0 ? wide(0.0) : Wide(sqrt(x), cap_precision); }

/// By the lowest place along the normal that both balls hold.
Relation expected_of_balls(const Sphere3& ball, const SphericalCap3& cap) {
  const WideVector c = wide(cap.sphere.center), q = wide(ball.center), n = wide(cap.halfspace.normal),
                   way = q + Wide(-1) * c;
  const Wide r = wide(cap.sphere.radius), s = wide(ball.radius), length = root_of(product(n, n)),
             d = root_of(product(way, way)), apart = d - r - s;
  if (wide_sign(apart) > 0) return Relation::disjoint;
  const auto lowest_of = [&](const WideVector& middle, const Wide& radius) {
    return middle + Wide(-radius / length) * n;
  };
  const auto holds = [](const WideVector& middle, const Wide& radius, const WideVector& p) {
    const WideVector to_p = p + Wide(-1) * middle;
    return wide_sign(product(to_p, to_p) - radius * radius) <= 0;
  };
  Wide low(0, cap_precision);
  if (const WideVector p = lowest_of(c, r); holds(q, s, p)) {
    low = product(n, p);
  } else if (const WideVector p2 = lowest_of(q, s); holds(c, r, p2)) {
    low = product(n, p2);
  } else {
    const Wide along = (d * d + r * r - s * s) / (2 * d), rim = root_of(r * r - along * along);
    const WideVector across = n + Wide(-product(n, way) / (d * d)) * way;
    low = product(n, c + Wide(along / d) * way) - rim * root_of(product(across, across));
  }
  const int above = wide_sign(low - wide(cap.halfspace.offset));
  if (above > 0) return Relation::disjoint;
  return above == 0 || wide_sign(apart) == 0 ? Relation::touching : Relation::overlapping;
}

TEST(OverlapCap, BallsAsTheLowestPlaceOfTwo) {
  Answers all;
  for (std::uint64_t i = 0; i < (battery::sanitized ? 300u : 3000u); ++i) {
    Entropy e(31, i);
    const auto number = [&e] { return static_cast<double>(e.within(4)); };
    const auto point = [&number] { return Point3{number(), number(), number()}; };
    const auto radius = [&e] { return static_cast<double>(e.below(6)) * (e.below(3) == 0 ? 0.5 : 1); };
    SphericalCap3 cap{{point(), radius()}, {{number(), number(), number()}, number()}};
    if (e.below(3) == 0) cap.halfspace.normal = {0, 0, e.coin() ? 2.0 : -1.0};
    Sphere3 ball{point(), radius()};
    if (e.below(3) == 0) {  // so that they touch, where a whole number is how far the disk or its rim is
      cap = {{{0, 0, 0}, 5}, {{0, 0, 1}, e.coin() ? -3.0 : 3.0}};
      const double x = number() * 2, y = e.coin() ? 0 : number(), z = number() + cap.halfspace.offset,
                   beside = std::fmax(std::hypot(x, y) - 4, 0), up = z - cap.halfspace.offset;
      ball = {{x, y, z}, std::fmax(1, std::rint(std::hypot(beside, up)))};
    }
    if (cap.halfspace.normal == Vector3{0, 0, 0}) continue;
    const FormOfCap which(cap);
    Relation expected = Relation::disjoint;
    if (which.form == CapForm::point || (which.form == CapForm::solid && ball.radius == 0)) {
      expected = which.form == CapForm::point
                     ? oracle::RoundOracle({{which.at}, {}}, {{oracle::core(ball)}, {}}).relation(ball.radius)
                     : expected_relation(ball.center, cap);
    } else if (which.form == CapForm::solid) {
      expected = expected_of_balls(ball, cap);
    }
    all.add(expected);
    expect_relation(ball, cap, expected, "replay: " + std::to_string(i));
  }
  std::printf("disjoint %d, touching %d, overlapping %d\n", all.of(Relation::disjoint), all.of(Relation::touching),
              all.of(Relation::overlapping));
  for (const Relation r : {Relation::disjoint, Relation::touching, Relation::overlapping})
    EXPECT_GE(all.of(r) * 40, all.all());
}

TEST(OverlapCap, FiguresInTheHalfspaceBehindTheBall) {
  // The ball's nearest point to these is cut off: the circle is nearest.
  const SphericalCap3 cap{{{0, 0, 0}, 5}, {{0, 0, 1}, -3}};  // a circle of radius 4
  EXPECT_EQ(relate(Sphere3{{10, 0, -3}, 6}, cap), Relation::touching);
  EXPECT_EQ(relate(Sphere3{{10, 0, -3}, 5.9375}, cap), Relation::disjoint);
  EXPECT_EQ(relate(Sphere3{{0, 0, 9}, 12}, cap), Relation::touching);
  EXPECT_EQ(relate(Sphere3{{0, 0, 9}, 11.9375}, cap), Relation::disjoint);
  EXPECT_EQ(relate(Sphere3{{7, 0, 1}, 5}, cap), Relation::touching);
  EXPECT_EQ(relate(Aabb3{{-1, -1, -3}, {1, 1, 4}}, cap), Relation::touching);
  EXPECT_EQ(relate(Plane3{{0, 0, 1}, -3}, cap), Relation::touching);
  EXPECT_EQ(relate(Halfspace3{{0, 0, -1}, 3}, cap), Relation::touching);
  EXPECT_EQ(relate(Halfspace3{{0, 0, 1}, -5}, cap), Relation::touching);
}

}  // namespace
}  // namespace plumb
