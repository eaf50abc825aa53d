// Are signs with square roots of polynomials exact?  Sums of distances, as users state them.
#include <gtest/gtest.h>

#include <cmath>

#include "certify/space_cases.hpp"
#include "oracle/radicals.hpp"
#include "plumb/certify/radical.hpp"
#include "plumb/predicates/cross.hpp"

namespace plumb::space_cases {
namespace {

// Points a, b, c and a number: is a inside the ellipsoid of the foci b and c whose axis has this length?
struct Ellipsoid {
  static constexpr std::string_view name = "ellipsoid";
  static constexpr std::array arguments{3, 3, 3, 1};
};

/// The squared distance of points 0 and Other.
template <std::size_t Other>
struct SquaredDistance : Ellipsoid {
  static constexpr std::string_view name = "squared_distance";
  template <class T>
  constexpr auto operator()(const std::array<T, 10>& p) const {
    const auto d = predicates::difference(p, 0, Other);
    return predicates::dot(d, d);
  }
};

/// (b - a) . (c - a), of the degree of the squared distances; and a product with the last number.
struct Angle : Ellipsoid {
  template <class T>
  constexpr auto operator()(const std::array<T, 10>& p) const {
    return predicates::dot(predicates::difference(p, 0, 1), predicates::difference(p, 0, 2));
  }
};
struct Number : Ellipsoid {
  template <class T>
  constexpr auto operator()(const std::array<T, 10>& p) const {
    return p[9] - p[0];
  }
};

using Length = Given<9, Angle>;
using One = predicates::One;

mpq_class value_of(const auto& formula, const std::array<double, 10>& p) {
  std::array<BigRational, 10> in;
  for (std::size_t i = 0; i < 10; ++i) in[i] = big_rational(p[i]);
  return formula(in).value;
}

template <class F>
mpq_class value(const std::array<double, 10>& p) {
  if constexpr (std::same_as<F, One>) {
    return 1;
  } else {
    return value_of(F{}, p);
  }
}

template <class A, class B, class C, class D, class E>
Sign truth(const std::array<double, 10>& p) {
  return oracle::digits_sign({value<A>(p), value<B>(p), value<C>(p), value<D>(p), value<E>(p)});
}

template <class A, class B, class C>
Sign truth(const std::array<double, 10>& p) {
  return oracle::digits_sign({value<A>(p), value<B>(p), value<C>(p), 0, 0});
}

static_assert(is_homogeneous<certify::radical::Norm<Length, One, SquaredDistance<1>>>);  // degree 1 beside sqrt(2)
static_assert(is_homogeneous<certify::radical::PairNorm<Number, One, SquaredDistance<1>, One, SquaredDistance<2>>>);
static_assert(is_homogeneous<certify::radical::Norm<Angle, Number, SquaredDistance<1>>>);  // 2 beside 1 + sqrt(2)
static_assert(!is_homogeneous<certify::radical::Norm<Angle, One, SquaredDistance<1>>>);    // 2 beside sqrt(2)
static_assert(!is_homogeneous<certify::radical::PairPart<Length, One, SquaredDistance<1>, Number, SquaredDistance<1>>>);

struct Tally {
  Shares distance, ellipsoid, mixed, unlike;
};

void check(const std::vector<Point3>& points, double length, Tally& tally) {
  std::array<double, 10> p{};
  for (std::size_t i = 0; i < 9; ++i) p[i] = numbers(points[i / 3])[i % 3];
  p[9] = length;
  using First = SquaredDistance<1>;
  using Second = SquaredDistance<2>;
  const auto told = [&] { return shown(points) + " " + hexadecimal(length); };
  ASSERT_EQ((sign_of_radical<Length, One, First>(p)), tally.distance((truth<Length, One, First>(p)))) << told();
  ASSERT_EQ((sign_of_radicals<Length, One, First, One, Second>(p)),
            tally.ellipsoid((truth<Length, One, First, One, Second>(p))))
      << told();
  ASSERT_EQ((sign_of_radicals<Angle, Number, First, Length, Second>(p)),
            tally.mixed((truth<Angle, Number, First, Length, Second>(p))))
      << told();
  ASSERT_EQ((sign_of_radicals<Angle, One, First, Number, Second>(p)),
            tally.unlike((truth<Angle, One, First, Number, Second>(p))))
      << told();
}

TEST(RadicalFormulasTest, AreExactOnGrids) {
  Tally tally;
  on_grids(4, 4000, [&](std::vector<Point3> p) {
    double length = -3 * std::fabs(p[3].x) - 2 * std::fabs(p[3].y);
    if (p[3].z > 0) {  // on a line, where distances are integers
      for (Point3& q : p) q = {q.x, p[0].y, p[0].z};
      length = -std::fabs(p[1].x - p[0].x) - std::fabs(p[2].x - p[0].x);
    }
    check(p, length, tally);
  });
  EXPECT_GT(tally.distance.least(), 0.02);
  EXPECT_GT(tally.ellipsoid.least(), 0.02);
  EXPECT_GT(tally.mixed.least(), 0.02);
  EXPECT_GT(tally.unlike.least(), 0.02);
}

TEST(RadicalFormulasTest, AreExactOnFamilies) {
  Tally tally;
  on_families(4, 60, [&](const std::vector<Point3>& p) { check(p, p[3].x, tally); });
  EXPECT_GT(tally.ellipsoid.of(Sign::negative), 0.05);
  EXPECT_GT(tally.mixed.of(Sign::negative), 0.1);
}

// Boxes with integer diagonals: points on the ellipsoid, and ulps off it.
TEST(RadicalFormulasTest, KnowPointsOnAnEllipsoid) {
  const auto side = [](double x, double length) {
    return sign_of_radicals<Length, One, SquaredDistance<1>, One, SquaredDistance<2>>(
        {x, 0, 0, 0, 3, 4, 0, 5, 12, -length});
  };
  EXPECT_EQ(side(0, 18), Sign::zero);  // 5 + 13
  EXPECT_EQ(side(0, std::nextafter(18, 19)), Sign::negative);
  EXPECT_EQ(side(0, std::nextafter(18, 17)), Sign::positive);
  EXPECT_EQ(side(0x1p-500, 18), Sign::positive);
  EXPECT_EQ(side(0x1p-1074, 18), Sign::positive);
}

TEST(RadicalFormulasTest, RefuseWhatHasNoRoot) {
  const auto sign = [](std::array<double, 10> p) { return sign_of_radical<Length, One, Angle>(p); };
  EXPECT_EQ(sign({0, 0, 0, 3, 0, 0, 3, 0, 0, -3}), Sign::zero);
  try {
    sign({0, 0, 0, 3, 0, 0, -3, 0, 0, -3});
    FAIL() << "took the root of a negative number";
  } catch (const NegativeRadicand& e) {
    EXPECT_STREQ(e.what(),
                 "the radicand ellipsoid is negative and has no real root; give one that is zero or positive");
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(sign({0, 0, 0, 3, 0, nan, 3, 0, 0, -3}), NonFinite);
  EXPECT_THROW(sign({0, 0, 0, 3, 0, 0, 3, 0, 0, nan}), NonFinite);
}

}  // namespace
}  // namespace plumb::space_cases
