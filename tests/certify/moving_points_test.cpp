// Are the Bernstein coefficients those of the moving points' orientation, and their signs exact?
#include "plumb/certify/moving_points.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "certify/space_cases.hpp"

namespace plumb::space_cases {
namespace {

using predicates::CoplanarityMiddle, predicates::Orient3d;

using Coefficients = std::array<mpq_class, 4>;  // b0, 3 b1, 3 b2, b3

template <Formula F>
mpq_class value(const Coordinates<F>& p) {
  return evaluate<F>([&](std::size_t i) { return big_rational(p[i]); }).value;
}

Coefficients coefficients(const std::vector<Point3>& p) {
  return {value<Orient3d>(gathered<Orient3d>(p[0], p[1], p[2], p[3])),
          value<CoplanarityMiddle>(gathered<CoplanarityMiddle>(p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7])),
          value<CoplanarityMiddle>(gathered<CoplanarityMiddle>(p[4], p[5], p[6], p[7], p[0], p[1], p[2], p[3])),
          value<Orient3d>(gathered<Orient3d>(p[4], p[5], p[6], p[7]))};
}

// orient3d at time t of the points moved, in rationals.
mpq_class moved(const std::vector<Point3>& p, const mpq_class& t) {
  std::array<BigRational, 12> at;
  for (std::size_t i = 0; i < 12; ++i) {
    const mpq_class from(numbers(p[i / 3])[i % 3]), to(numbers(p[4 + i / 3])[i % 3]);
    at[i] = {mpq_class(from * (1 - t) + to * t)};
  }
  return Orient3d{}(at).value;
}

mpq_class cubic(const Coefficients& b, const mpq_class& t) {
  const mpq_class s = 1 - t;
  return b[0] * s * s * s + b[1] * s * s * t + b[2] * s * t * t + b[3] * t * t * t;
}

std::array<Sign, 4> signs_of(const std::vector<Point3>& p) {
  const std::span<const Point3> all(p);
  return coplanarity_signs(all.first<4>(), all.subspan<4, 4>());
}

TEST(MovingPointsTest, MeansWhatItSays) {
  // A point falls through a triangle at rest: from above (orient3d negative) to below.
  const std::array<Point3, 4> before{Point3{0, 0, 0}, Point3{4, 0, 0}, Point3{0, 4, 0}, Point3{1, 1, 2}};
  std::array<Point3, 4> after = before;
  after[3] = {1, 1, -4};
  using Signs = std::array<Sign, 4>;
  constexpr Sign plus = Sign::positive, zero = Sign::zero, minus = Sign::negative;
  EXPECT_EQ(coplanarity_signs(before, after), (Signs{minus, zero, plus, plus}));  // linear from -2 to 4
  EXPECT_EQ(coplanarity_signs(after, before), (Signs{plus, plus, zero, minus}));
  EXPECT_EQ(coplanarity_signs(before, before), (Signs{minus, minus, minus, minus}));
  EXPECT_EQ(sign_variations(Signs{minus, zero, plus, plus}), 1);
  EXPECT_EQ(sign_variations(Signs{minus, plus, zero, minus}), 2);
  EXPECT_EQ(sign_variations(Signs{plus, minus, plus, minus}), 3);
  EXPECT_EQ(sign_variations(Signs{zero, zero, plus, zero}), 0);
  EXPECT_EQ(sign_variations(Signs{}), 0);
}

TEST(MovingPointsTest, CoefficientsAreThoseOfTheCubic) {
  on_families(8, 40, [&](const std::vector<Point3>& p) {
    const Coefficients b = coefficients(p);
    for (const mpq_class& t : {mpq_class(0), mpq_class(1), mpq_class(1, 2), mpq_class(1, 3), mpq_class(-5, 7)}) {
      ASSERT_TRUE(cubic(b, t) == moved(p, t)) << shown(p);  // five values: a cubic is known by four
    }
  });
}

TEST(MovingPointsTest, SignsAreExact) {
  std::array<Shares, 4> shares;
  const auto check = [&](const std::vector<Point3>& p) {
    const Coefficients b = coefficients(p);
    const auto signs = signs_of(p);
    for (std::size_t i = 0; i < 4; ++i) {
      ASSERT_EQ(signs[i], shares[i](sign_of_number(sgn(b[i])))) << i << shown(p);
    }
    // Laws 1 and 2.
    const auto swapped = signs_of({p[1], p[0], p[2], p[3], p[5], p[4], p[6], p[7]});
    const auto reversed = signs_of({p[4], p[5], p[6], p[7], p[0], p[1], p[2], p[3]});
    for (std::size_t i = 0; i < 4; ++i) {
      ASSERT_EQ(swapped[i], -signs[i]) << shown(p);
      ASSERT_EQ(reversed[i], signs[3 - i]) << shown(p);
    }
  };
  on_families(8, 600, check);
  on_grids(8, 6000, check);
  for (const Shares& s : shares) EXPECT_GT(s.least(), 0.05);
}

// Law 3, by the cubic's signs at many times: a change of sign between two of them is a root.
TEST(MovingPointsTest, VariationsBoundTheRoots) {
  std::array<int, 4> with_variations{};
  int full = 0;
  on_grids(8, 3000, [&](const std::vector<Point3>& p) {
    const Coefficients b = coefficients(p);
    const auto signs = signs_of(p);
    const int variations = sign_variations(signs);
    ++with_variations[static_cast<std::size_t>(variations)];
    std::vector<Sign> seen;
    for (int i = 0; i <= 32; ++i) seen.push_back(sign_of_number(sgn(cubic(b, mpq_class(i, 32)))));
    const int changes = sign_variations(seen);
    ASSERT_LE(changes, variations) << shown(p);
    if (signs[0] != Sign::zero && signs[3] != Sign::zero) {
      ASSERT_EQ((variations - changes) % 2, 0) << shown(p);
    }
    if (variations == changes && variations > 0) ++full;
  });
  for (const int n : with_variations) EXPECT_GT(n, battery::fitting(50));
  EXPECT_GT(full, battery::fitting(500));
}

TEST(MovingPointsTest, RefusesWhatIsNoNumber) {
  std::array<Point3, 4> p{Point3{0, 0, 0}, Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1}}, q = p;
  q[2].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(coplanarity_signs(p, q), NonFinite);
  EXPECT_THROW(coplanarity_signs(q, p), NonFinite);
}

}  // namespace
}  // namespace plumb::space_cases
