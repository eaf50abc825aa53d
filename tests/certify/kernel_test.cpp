// A kernel with a plan tells the sign that decide tells, on every lattice, whichever arithmetic the plan says.
#include "plumb/certify/kernel.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "certify/lattice_cases.hpp"
#include "plumb/arith/big.hpp"

namespace plumb {
namespace {

using namespace lattice_cases;
using namespace predicates;

#ifdef PLUMB_LONG_TESTS
constexpr std::uint64_t cases = 20'000;
#else
constexpr std::uint64_t cases = 200;
#endif

// For each number of bits the ends of the exponents that doubles have, and some between.
std::vector<Lattice> lattices() {
  std::vector<Lattice> all;
  const auto add = [&](int bits, std::uint64_t turn) {
    const std::array exponents{0, -1074, 1024 - bits, -7, 971 - bits, -1022, 972, 400};
    int exponent = exponents[turn % exponents.size()];
    if (exponent < -1074 || exponent + bits > 1024) exponent = -bits;
    all.push_back({exponent, bits});
  };
  for (int bits = 0; bits <= 64; ++bits) {
    for (std::uint64_t turn = 0; turn < 3; ++turn) add(bits, static_cast<std::uint64_t>(bits) + 3 * turn);
  }
  for (const int bits : {70, 100, 300, 1000, 2098}) add(bits, 1);
  return all;
}

template <class F>
class KernelTest : public testing::Test {};
using Formulas = testing::Types<Orient2d, Orient3d, InCircle, InSphere, Mixed, PlaneSide, Paraboloid, Power20, Order>;
TYPED_TEST_SUITE(KernelTest, Formulas);

TYPED_TEST(KernelTest, TellsTheExactSignOnEveryLattice) {
  using F = TypeParam;
  std::array<std::uint64_t, 3> seen{};
  for (const Lattice& lattice : lattices()) {
    const Kernel kernel(plan(lattice));
    for (std::uint64_t i = 0; i < cases; ++i) {
      const Coordinates<F> p = coordinates_on<F>(lattice, i);
      const Sign exact = decide<F>(p);
      ++seen[static_cast<std::size_t>(static_cast<int>(exact) + 1)];
      ASSERT_EQ(sign_of_points<F>(kernel, p), exact) << described<F>(lattice, p);
      ASSERT_EQ(sign_with<F>(kernel, p), exact) << described<F>(lattice, p);
      ASSERT_EQ(sign_as_given<F>(kernel, p), exact) << described<F>(lattice, p);
      if (i % 50 == 0) {
        const Sign rational = evaluate<F>([&](std::size_t k) { return big_rational(p[k]); }).sign();
        ASSERT_EQ(rational, exact) << described<F>(lattice, p);
      }
    }
  }
  for (const std::uint64_t n : seen) EXPECT_GT(100 * n, seen[0] + seen[1] + seen[2]) << "no sign is rare";
}

// Every choice of the largest, the next, and zero for the coordinates of three points of the plane.
TEST(KernelExtremesTest, Orient2dAtTheEndsOfEveryLattice) {
  for (int bits = 1; bits <= 53; ++bits) {
    const Lattice lattice{-3, bits};
    const Kernel kernel(lattice);
    const double most = std::ldexp(std::ldexp(1.0, bits) - 1, -3), next = most - 0.125;
    const std::array choice{most, -most, next, -next, 0.0};
    for (int code = 0; code < 5 * 5 * 5 * 5 * 5 * 5; ++code) {
      Coordinates<Orient2d> p{};
      int rest = code;
      for (double& x : p) {
        x = choice[static_cast<std::size_t>(rest % 5)];
        rest /= 5;
      }
      ASSERT_EQ(sign_of_points<Orient2d>(kernel, p), decide<Orient2d>(p)) << described<Orient2d>(lattice, p);
    }
  }
}

TEST(KernelTest, OffersTheClassicPredicates) {
  const Kernel kernel(plan(Lattice{-1, 12}));
  const std::array plane{Point2{0, 0}, Point2{4, 0}, Point2{0, 4.5}, Point2{1, 1}};
  const auto p = kernel.points(plane);
  EXPECT_EQ(kernel.orient2d(p[0], p[1], p[2]), Sign::positive);
  EXPECT_EQ(kernel.orient2d(plane[0], plane[2], plane[1]), Sign::negative);
  EXPECT_EQ(kernel.incircle(p[0], p[1], p[2], p[3]), Sign::positive);
  EXPECT_EQ(kernel.incircle(plane[0], plane[1], plane[2], plane[2]), Sign::zero);
  const std::array space{Point3{0, 0, 0}, Point3{4, 0, 0}, Point3{0, 4, 0}, Point3{0, 0, -4}, Point3{1, 1, -1}};
  const auto q = kernel.points(space);
  EXPECT_EQ(kernel.orient3d(q[0], q[1], q[2], q[3]), Sign::positive);
  EXPECT_EQ(kernel.orient3d(space[0], space[2], space[1], space[3]), Sign::negative);
  EXPECT_EQ(kernel.insphere(q[0], q[1], q[2], q[3], q[4]), Sign::positive);
  EXPECT_EQ(kernel.insphere(space[0], space[1], space[2], space[3], space[0]), Sign::zero);
  EXPECT_EQ(kernel.sign<PlaneSide>(Vector3{0, 0, 1}, Point3{7, 7, 2}, 1.0, 2.0), Sign::zero);
  EXPECT_EQ(kernel.sign<PlaneSide>(kernel.point(Vector3{0, 0, 1}), kernel.point(Point3{7, 7, 2}), kernel.point(1.0),
                                   kernel.point(1.5)),
            Sign::positive);
}

TEST(KernelTest, EqualLatticesExchangePoints) {
  const Kernel one(Lattice{-4, 20}), other(plan(Lattice{-4, 20}));
  EXPECT_EQ(other.orient2d(one.point(Point2{0, 0}), other.point(Point2{1, 0}), one.point(Point2{0, 1})),
            Sign::positive);
}

}  // namespace
}  // namespace plumb
