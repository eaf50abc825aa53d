// Any polynomial, of arguments of any kind: is its sign that of rational arithmetic, and are its shape and degree
// derived?
#include "plumb/certify/sign_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "plumb/arith/big.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/degenerate.hpp"

namespace plumb {
namespace {

// z against x^2 + y^2, with and without the focal length that makes the terms of one degree.
constexpr auto focal_paraboloid = [](auto x, auto y, auto z, auto f) { return f * z - x * x - y * y; };
constexpr auto unit_paraboloid = [](auto x, auto y, auto z) { return z - x * x - y * y; };

static_assert(is_homogeneous<FormulaOf<decltype(focal_paraboloid), Point3, double>::Type>);
static_assert(!is_homogeneous<FormulaOf<decltype(unit_paraboloid), Point2, double>::Type>);
static_assert(arguments<FormulaOf<decltype(focal_paraboloid), Point3, double>::Type> == std::array{3, 1});
static_assert(!is_homogeneous<FormulaOf<decltype(unit_paraboloid), Point3>::Type>);
static_assert(std::is_same_v<FormulaOf<predicates::Orient2d, Point2, Point2, Point2>::Type, predicates::Orient2d>);

TEST(SignOfTest, TellsTheSideOfAParaboloid) {
  EXPECT_EQ(sign_of(focal_paraboloid, Point3{3, 4, 25}, 1.0), Sign::zero);
  EXPECT_EQ(sign_of(focal_paraboloid, 3.0, 4.0, Vector2{0x1.9000000000001p4, 1}), Sign::positive);
  EXPECT_EQ(sign_of(focal_paraboloid, std::array{3.0, 4.0, 0x1.8ffffffffffffp4, 1.0}), Sign::negative);
  EXPECT_EQ(sign_of(unit_paraboloid, Point2{0x1p-540, 0}, 0x1p-1074), Sign::positive);
  EXPECT_EQ(sign_of(unit_paraboloid, Point2{0x1p-537, 0}, 0x1p-1074), Sign::zero);
  EXPECT_EQ(sign_of(unit_paraboloid, Point2{0x1p-537, 0x1p-1074}, 0x1p-1074), Sign::negative);
  EXPECT_EQ(sign_of(unit_paraboloid, Vector2{1e308, 1e308}, 1e308), Sign::negative);
}

TEST(SignOfTest, TakesTheFormulasOfTheManifest) {
  const Point3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  EXPECT_EQ(sign_of(predicates::Orient3d{}, a, b, c, Point3{0, 0, -1}), Sign::positive);
  EXPECT_EQ(sign_of(predicates::Orient2d{}, Point2{0, 0}, 1.0, 1.0, Vector2{3, 3}), Sign::zero);
}

TEST(SignOfTest, AgreesWithRationalsOnEveryFamily) {
  std::array<int, 3> signs{};
  for (const FamilyInfo& family : families) {
    for (std::uint64_t i = 0; i < 3'000; ++i) {
      Entropy entropy(5, i);
      const std::vector<Point3> p = points3(family.family, Degeneracy::coplanar, 1, entropy);
      const double x = p.front().x, y = p.front().y, z = p.front().z;
      // Half of the cases lie on the paraboloid, or next to it.
      const double lifted = x * x + y * y;
      const double height = i % 2 == 0 || !std::isfinite(lifted) ? z : lifted;
      const auto exact = [&](auto f) { return f(big_rational(x), big_rational(y), big_rational(height)).sign(); };
      const Sign sign = sign_of(unit_paraboloid, x, y, height);
      ASSERT_EQ(sign, exact(unit_paraboloid)) << family.name << ' ' << i << std::hexfloat << ' ' << x << ' ' << y;
      ASSERT_EQ(sign_of(focal_paraboloid, x, y, height, 1.0), sign) << family.name << ' ' << i;
      ++signs[static_cast<std::size_t>(static_cast<int>(sign) + 1)];
    }
  }
  for (const int n : signs) EXPECT_GT(n, 1'000);
}

std::string refused(auto ask) {
  try {
    ask();
  } catch (const NonFinite& error) {
    return error.what();
  }
  return "nothing";
}

TEST(SignOfTest, NamesTheArgumentThatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refused([&] {
              sign_of(unit_paraboloid, Point2{1, nan}, 2.0);
            }),
            "sign_of: a.y is nan, not a real number; give a finite double");
  EXPECT_EQ(refused([&] {
              sign_of(unit_paraboloid, Point2{1, 2}, -inf);
            }),
            "sign_of: b is -inf, not a real number; give a finite double");
  EXPECT_EQ(refused([&] {
              sign_of(focal_paraboloid, std::array{1.0, 2.0, 3.0, inf});
            }),
            "sign_of: coordinate 3 is inf, not a real number; give a finite double");
}

}  // namespace
}  // namespace plumb
