// Are the signs of products of cross products exact, and is a cross product that vanishes seen to vanish?
#include "plumb/certify/cross_products.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "certify/space_cases.hpp"

namespace plumb::space_cases {
namespace {

using Rational3 = std::array<mpq_class, 3>;

Rational3 rational(const Point3& p) { return {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)}; }

mpq_class dot(const Rational3& u, const Rational3& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

Rational3 cross(const Rational3& u, const Rational3& v) {
  Rational3 w;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    w[i] = u[j] * v[k] - u[k] * v[j];
  }
  return w;
}

Sign sign(const mpq_class& x) { return sign_of_number(sgn(x)); }

TEST(CrossProductsTest, MeansWhatItSays) {
  const Vector3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_EQ(dot_of_crosses(x, y, x, y), Sign::positive);
  EXPECT_EQ(dot_of_crosses(x, y, y, x), Sign::negative);
  EXPECT_EQ(dot_of_crosses(x, y, y, z), Sign::zero);
  EXPECT_EQ(dot_of_crosses({0.1, 0.2, 0.3}, {0.2, 0.4, 0.6}, x, y), Sign::zero);  // doubled exactly: parallel
  EXPECT_EQ(dot_of_triple_cross(x, y, x, y), Sign::positive);                     // x (y x) = x (-z) = y
  EXPECT_EQ(order_along_cross(x, y, {0, 0, 1}, {5, 5, 2}), Sign::positive);
  EXPECT_EQ(order_along_cross(y, x, {0, 0, 1}, {5, 5, 2}), Sign::negative);
  EXPECT_EQ(order_along_cross(x, y, {0, 0, 2}, {5, 5, 2}), Sign::zero);
}

// By Lagrange's identity, and by the triple cross product written out: other polynomials than the library's.
void check(const std::vector<Point3>& p, Shares& crosses, Shares& triples, Shares& along) {
  const Rational3 a = rational(p[0]), b = rational(p[1]), c = rational(p[2]), d = rational(p[3]);
  const Vector3 va = vector(p[0]), vb = vector(p[1]), vc = vector(p[2]), vd = vector(p[3]);
  const mpq_class lagrange = dot(a, c) * dot(b, d) - dot(a, d) * dot(b, c);
  ASSERT_EQ(dot_of_crosses(va, vb, vc, vd), crosses(sign(lagrange))) << shown(p);
  ASSERT_EQ(dot_of_crosses(vc, vd, vb, va), -sign(lagrange)) << shown(p);
  ASSERT_EQ(dot_of_triple_cross(va, vb, vc, vd), triples(sign(dot(cross(a, cross(b, c)), d)))) << shown(p);
  const mpq_class further = dot(cross(a, b), d) - dot(cross(a, b), c);
  ASSERT_EQ(order_along_cross(va, vb, p[2], p[3]), along(sign(further))) << shown(p);
}

TEST(CrossProductsTest, AreExact) {
  Shares crosses, triples, along;
  on_families(4, 800, [&](const std::vector<Point3>& p) { check(p, crosses, triples, along); });
  on_grids(4, 8000, [&](const std::vector<Point3>& p) { check(p, crosses, triples, along); });
  EXPECT_GT(crosses.least(), 0.1);
  EXPECT_GT(triples.least(), 0.1);
  EXPECT_GT(along.least(), 0.1);
}

TEST(CrossProductsTest, SeeParallelFactors) {
  std::uint64_t tried = 0;
  for (std::uint64_t i = 0; i < 2000 * more; ++i) {
    Entropy entropy(61, i);
    auto p = points3(any_family(entropy), Degeneracy::coplanar, 4, entropy);
    // A multiple by a power of two, where that is exact, or by zero.
    const double factor = i % 5 == 0 ? 0 : i % 2 == 0 ? 0.5 : -2;
    p[1] = {p[0].x * factor, p[0].y * factor, p[0].z * factor};
    const auto in_range = [](double x) { return x == 0 || (std::fabs(x) > 0x1p-1000 && std::fabs(x) < 0x1p1000); };
    if (!in_range(p[0].x) || !in_range(p[0].y) || !in_range(p[0].z)) continue;
    ++tried;
    ASSERT_EQ(dot_of_crosses(vector(p[0]), vector(p[1]), vector(p[2]), vector(p[3])), Sign::zero) << shown(p);
    ASSERT_EQ(order_along_cross(vector(p[0]), vector(p[1]), p[2], p[3]), Sign::zero) << shown(p);
  }
  EXPECT_GT(tried, 1000 * more);
}

TEST(CrossProductsTest, RefuseWhatIsNoNumber) {
  const Vector3 x{1, 0, 0}, bad{0, std::numeric_limits<double>::infinity(), 0};
  EXPECT_THROW(dot_of_crosses(x, x, bad, x), NonFinite);
  EXPECT_THROW(dot_of_triple_cross(x, x, x, bad), NonFinite);
  EXPECT_THROW(order_along_cross(x, x, {0, 0, 0}, {0, std::numeric_limits<double>::quiet_NaN(), 0}), NonFinite);
}

}  // namespace
}  // namespace plumb::space_cases
