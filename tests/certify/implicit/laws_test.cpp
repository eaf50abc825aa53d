// The laws of certify/implicit.hpp, and what it says of input that has no point.
#include <gmock/gmock.h>

#include <limits>

#include "certify/implicit/cases.hpp"
#include "plumb/arith/degree.hpp"

namespace plumb::implicit_cases {
namespace {

using namespace predicates;

// For points as given the formula is the classic one, operation for operation.
template <class Classic, class General>
constexpr bool same_work =
    certify::tape::program<Classic>().instructions.size() == certify::tape::program<General>().instructions.size() &&
    filter_constant<Classic>() == filter_constant<General>();
static_assert(same_work<Orient2d, Mixed<HomogeneousOrient2d, ExplicitKind2, ExplicitKind2, ExplicitKind2>>);
static_assert(
    same_work<Orient3d, Mixed<HomogeneousOrient3d, ExplicitKind3, ExplicitKind3, ExplicitKind3, ExplicitKind3>>);
static_assert(
    same_work<InCircle, Mixed<HomogeneousInCircle, ExplicitKind2, ExplicitKind2, ExplicitKind2, ExplicitKind2>>);
static_assert(filter_constant<InSphere>() == filter_constant<Mixed<HomogeneousInSphere, ExplicitKind3, ExplicitKind3,
                                                                   ExplicitKind3, ExplicitKind3, ExplicitKind3>>());

// Without parameters and poses all terms have one degree: scaling keeps the sign.
static_assert(degree<Mixed<HomogeneousOrient2d, LineLineKind2, LineLineKind2, LineLineKind2>>() == 8);
static_assert(degree<Mixed<HomogeneousOrient2d, LineLineKind2, ExplicitKind2, ExplicitKind2>>() == 4);
static_assert(degree<Mixed<HomogeneousOrient3d, LinePlaneKind3, LinePlaneKind3, LinePlaneKind3, LinePlaneKind3>>() ==
              15);
static_assert(degree<Mixed<HomogeneousOrient3d, ThreePlaneKind3, ExplicitKind3, ExplicitKind3, ExplicitKind3>>() == 9);
static_assert(degree<Mixed<HomogeneousInCircle, LineLineKind2, LineLineKind2, LineLineKind2, LineLineKind2>>() == 20);
static_assert(degree<Mixed<HomogeneousInSphere, ThreePlaneKind3, ThreePlaneKind3, ThreePlaneKind3, ThreePlaneKind3,
                           ThreePlaneKind3>>() == 65);

// In general position floating point decides, whatever the mix; a promise about speed.
template <class F>
int sure_in_a_thousand() {
  int sure = 0;
  for (std::uint64_t index = 0; index < 5'000; ++index) {
    Entropy entropy(13, index);
    Coordinates<F> p;
    for (double& x : p) x = signed_unit_coordinate(entropy);
    sure += filter<F>(p) != 0;
  }
  return sure / 5;
}

TEST(ImplicitFilters, DecideGeneralPosition) {
  using E = ExplicitKind3;
  using L = LinePlaneKind3;
  using T = ThreePlaneKind3;
  using C = LineLineKind2;
  EXPECT_GE((sure_in_a_thousand<Mixed<HomogeneousOrient2d, C, C, C>>()), 999);
  EXPECT_GE((sure_in_a_thousand<Mixed<HomogeneousInCircle, C, C, C, C>>()), 998);
  EXPECT_GE((sure_in_a_thousand<Mixed<HomogeneousOrient3d, E, E, E, L>>()), 999);
  EXPECT_GE((sure_in_a_thousand<Mixed<HomogeneousOrient3d, T, T, T, T>>()), 999);
  EXPECT_GE((sure_in_a_thousand<Mixed<HomogeneousOrient3d, PosedKind3, PosedKind3, PosedKind3, PosedKind3>>()), 999);
  EXPECT_GE((sure_in_a_thousand<Mixed<HomogeneousInSphere, L, L, L, L, L>>()), 998);
  EXPECT_GE((sure_in_a_thousand<Mixed<HomogeneousInSphere, T, T, T, T, T>>()), 700);  // of degree 65
}

const std::uint64_t cases = battery::fitting<std::uint64_t>(3'000);

/// Calls check(pool, entropy) for small numbers and for every family.
template <class Check>
void for_cases(int dimension, Check check) {
  const auto run = [&](Numbers numbers, std::uint64_t count) {
    for (std::uint64_t index = 0; index < count && !testing::Test::HasFailure(); ++index) {
      SCOPED_TRACE(testing::Message() << numbers.name() << " case " << index);
      Entropy entropy(11, index);
      Pool pool(numbers, dimension, entropy);
      check(pool);
    }
  };
  run({}, cases);
  for (const FamilyInfo& info : families) run({false, info.family}, cases / 20);
}

template <class Point>
Point made(Pool& pool) {
  Point p;
  pool.make(p);
  return p;
}

constexpr auto ask2 = [](const auto&... p) { return orient2d(p...); };
constexpr auto ask3 = [](const auto&... p) { return orient3d(p...); };
constexpr auto ask_circle = [](const auto&... p) { return incircle(p...); };
constexpr auto ask_sphere = [](const auto&... p) { return insphere(p...); };

std::optional<Sign> flipped(std::optional<Sign> s) { return s ? std::optional(-*s) : s; }

TEST(ImplicitLaws, SwappingFlipsAndCirclingKeeps) {
  for_cases(2, [](Pool& pool) {
    const auto a = made<LineLinePoint2>(pool);
    const auto b = made<SegmentPoint2>(pool);
    const auto c = made<Point2>(pool);
    const auto d = made<Posed<Point2, Pose2>>(pool);
    const auto turn = answer(ask2, a, b, c);
    EXPECT_EQ(answer(ask2, b, a, c), flipped(turn));
    EXPECT_EQ(answer(ask2, a, c, b), flipped(turn));
    EXPECT_EQ(answer(ask2, b, c, a), turn);
    const auto circle = answer(ask_circle, a, b, c, d);
    EXPECT_EQ(answer(ask_circle, b, a, c, d), flipped(circle));
    EXPECT_EQ(answer(ask_circle, b, c, a, d), circle);
    EXPECT_EQ(answer(ask_circle, d, b, c, a), flipped(circle));
  });
  for_cases(3, [](Pool& pool) {
    const auto a = made<LinePlanePoint3>(pool);
    const auto b = made<ThreePlanePoint3>(pool);
    const auto c = made<Point3>(pool);
    const auto d = made<SegmentPoint3>(pool);
    const auto e = made<LinePlanePoint3>(pool);
    const auto side = answer(ask3, a, b, c, d);
    EXPECT_EQ(answer(ask3, b, a, c, d), flipped(side));
    EXPECT_EQ(answer(ask3, c, b, a, d), flipped(side));
    EXPECT_EQ(answer(ask3, b, c, d, a), flipped(side));
    const auto sphere = answer(ask_sphere, a, b, c, d, e);
    EXPECT_EQ(answer(ask_sphere, b, a, c, d, e), flipped(sphere));
    EXPECT_EQ(answer(ask_sphere, b, c, d, e, a), sphere);
  });
}

TEST(ImplicitLaws, AnEqualPointMayStandIn) {
  int zeros = 0, all = 0;
  for (std::uint64_t index = 0; index < 2'000; ++index) {
    SCOPED_TRACE(index);
    Entropy entropy(12, index);
    const auto whole = [&] { return static_cast<double>(entropy.within(2)); };
    const Point3 z{whole(), whole(), whole()}, b{whole(), whole(), whole()}, c{whole(), whole(), whole()},
        d{whole(), whole(), whole()}, e{whole(), whole(), whole()};
    // A line through z and a plane through z: both from integer steps away from it.
    const auto step = [&] { return Vector3{whole(), whole(), whole()}; };
    const auto beyond = [&](const Vector3& v, double t) { return Point3{z.x + t * v.x, z.y + t * v.y, z.z + t * v.z}; };
    const Vector3 along = step();
    const LinePlanePoint3 crossing{beyond(along, 2), beyond(along, -3), z, beyond(step(), 1), beyond(step(), 1)};
    const auto plane = [&] { return std::array{beyond(step(), 1), z, beyond(step(), 2)}; };
    const ThreePlanePoint3 corner{plane(), plane(), plane()};
    const SegmentPoint3 middle{beyond(along, -1), beyond(along, 3), 0.25};
    const Posed<Point3> turned{{-z.y + 1, z.x + 2, -z.z}, {{{{0, -1, 0}, {1, 0, 0}, {0, 0, -1}}}, {-2, 1, 0}}};
    const Sign exact = orient3d(z, b, c, d), sphere = insphere(z, b, c, d, e);
    const auto stands_in = [&](const auto& p) {
      const auto said = answer(ask3, p, b, c, d);
      if (!said) return false;
      EXPECT_EQ(*said, exact);
      EXPECT_EQ(insphere(p, b, c, d, e), sphere);
      EXPECT_EQ(insphere(e, b, c, d, p), insphere(e, b, c, d, z));
      EXPECT_EQ(compare_xyz(p, z), Sign::zero);
      EXPECT_EQ(compare_xyz(b, p), compare_xyz(b, z));
      EXPECT_EQ(approximate(p), z);
      return true;
    };
    all += stands_in(crossing) + stands_in(corner);
    EXPECT_TRUE(stands_in(middle));
    EXPECT_TRUE(stands_in(turned));
    zeros += exact == Sign::zero;
    if (HasFailure()) return;
  }
  EXPECT_GT(all, 2'000);
  EXPECT_GT(zeros, 50);
}

TEST(ImplicitLaws, ConstructedOnAPlaneIsOnIt) {
  int points = 0;
  for_cases(3, [&](Pool& pool) {
    const auto p = made<LinePlanePoint3>(pool);
    const auto q = made<ThreePlanePoint3>(pool);
    if (const auto side = answer(ask3, p, p.a, p.b, p.c)) {
      EXPECT_EQ(*side, Sign::zero);
      EXPECT_EQ(orient3d(p.a, p.c, p, p.b), Sign::zero);
      EXPECT_EQ(orient3d(p.p, p.q, p, p.a), Sign::zero);  // and on its line, in a plane with any point
      ++points;
    }
    for (const auto* plane : {&q.first, &q.second, &q.third}) {
      const auto side = answer(ask3, (*plane)[0], (*plane)[1], (*plane)[2], q);
      if (side) {
        EXPECT_EQ(*side, Sign::zero);
        ++points;
      }
    }
  });
  for_cases(2, [&](Pool& pool) {
    const auto p = made<LineLinePoint2>(pool);
    const auto s = made<SegmentPoint2>(pool);
    EXPECT_EQ(orient2d(s.a, s, s.b), Sign::zero);
    if (const auto turn = answer(ask2, p.a, p.b, p)) {
      EXPECT_EQ(*turn, Sign::zero);
      EXPECT_EQ(orient2d(p, p.c, p.d), Sign::zero);
      ++points;
    }
  });
  EXPECT_GT(points, battery::fitting(5'000));
}

TEST(ImplicitLaws, ACommonPoseMultipliesByTheSignOfItsDeterminant) {
  int mirrors = 0, flat = 0;
  for_cases(3, [&](Pool& pool) {
    const Pose pose = made<Posed<Point3>>(pool).pose;
    const auto a = made<Point3>(pool), b = made<Point3>(pool), c = made<Point3>(pool), d = made<Point3>(pool);
    const auto& [u, v, w] = pose.columns;
    // The classic sign of 0, u, v, w as rows is that of the determinant.
    const Sign determinant = orient3d({u.x, u.y, u.z}, {v.x, v.y, v.z}, {w.x, w.y, w.z}, Point3{0, 0, 0});
    EXPECT_EQ(orient3d(Posed{a, pose}, Posed{b, pose}, Posed{c, pose}, Posed{d, pose}),
              determinant * orient3d(a, b, c, d));
    mirrors += determinant == Sign::negative;
    flat += determinant == Sign::zero;
  });
  EXPECT_GT(mirrors, battery::fitting(100));
  EXPECT_GT(flat, battery::fitting(50));
}

TEST(ImplicitLaws, ACommonSimilarityKeepsCirclesAndSpheres) {
  for_cases(3, [](Pool& pool) {
    const auto a = made<Point3>(pool), b = made<Point3>(pool), c = made<Point3>(pool), d = made<Point3>(pool),
               e = made<Point3>(pool);
    // An integer quaternion's rotation, scaled: (1, 2, 3, 4).
    const Pose pose{{{{-20, 20, 10}, {4, -10, 28}, {22, 20, 4}}}, {b.x, 0.1, -1e3}};
    EXPECT_EQ(insphere(Posed{a, pose}, Posed{b, pose}, Posed{c, pose}, Posed{d, pose}, Posed{e, pose}),
              insphere(a, b, c, d, e));
  });
  for_cases(2, [](Pool& pool) {
    const auto a = made<Point2>(pool), b = made<Point2>(pool), c = made<Point2>(pool), d = made<Point2>(pool);
    const Pose2 pose{{{{3, 4}, {-4, 3}}}, {b.x, 0.1}};
    EXPECT_EQ(incircle(Posed{a, pose}, Posed{b, pose}, Posed{c, pose}, Posed{d, pose}), incircle(a, b, c, d));
    EXPECT_EQ(orient2d(Posed{a, pose}, Posed{b, pose}, Posed{c, pose}), orient2d(a, b, c));
  });
}

TEST(ImplicitLaws, OrderIsThatOfTheExactCoordinates) {
  int equal = 0, tied = 0;
  const auto check_pair = [&](const auto& p, const auto& q) {
    const auto exact = oracle::rational_order(constructed(p), constructed(q));
    constexpr auto compare = [](const auto& x, const auto& y) {
      if constexpr (AnyPoint2<std::decay_t<decltype(x)>>) {
        return compare_xy(x, y);
      } else {
        return compare_xyz(x, y);
      }
    };
    if (!exact) {
      EXPECT_THROW(compare(p, q), DegeneratePoint);
      return;
    }
    equal += exact->sign == Sign::zero;
    tied += exact->sign != Sign::zero && exact->axis > 0;
    EXPECT_EQ(compare(p, q), exact->sign);
    EXPECT_EQ(compare(q, p), -compare(p, q));
    EXPECT_EQ(compare(p, p), Sign::zero);
  };
  for_cases(2, [&](Pool& pool) {
    const auto a = made<Point2>(pool), b = made<Point2>(pool);
    const auto c = made<LineLinePoint2>(pool), d = made<LineLinePoint2>(pool);
    const auto e = made<SegmentPoint2>(pool);
    check_pair(a, b);
    check_pair(a, c);
    check_pair(c, d);
    check_pair(d, e);
    check_pair(e, made<Posed<Point2, Pose2>>(pool));
  });
  for_cases(3, [&](Pool& pool) {
    const auto a = made<Point3>(pool);
    const auto b = made<ThreePlanePoint3>(pool);
    const auto c = made<LinePlanePoint3>(pool);
    check_pair(a, b);
    check_pair(b, c);
    check_pair(c, made<LinePlanePoint3>(pool));
    check_pair(made<SegmentPoint3>(pool), c);
  });
  EXPECT_GT(equal, battery::fitting(500));
  EXPECT_GT(tied, battery::fitting(1'000));
}

}  // namespace
}  // namespace plumb::implicit_cases
