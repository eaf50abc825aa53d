// What is off the lattice is refused by name, whatever is wrong with it; nothing wrong ever gets an answer.
#include "plumb/certify/lattice_point.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "certify/lattice_cases.hpp"

namespace plumb {
namespace {

using namespace lattice_cases;
using namespace predicates;

constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

template <class Thrown, class Act>
std::string thrown_by(Act act) {
  try {
    act();
  } catch (const Thrown& e) {
    return e.what();
  } catch (const std::exception& e) {
    return std::string("another exception: ") + e.what();
  }
  return "nothing";
}

// A sound lattice for each way of keeping words, at the ends of the exponents too.
const std::vector<Lattice>& lattices() {
  static const std::vector<Lattice> all{{0, 1},      {-4, 20},      {-1074, 30}, {-1074, 51}, {973, 51},
                                        {1000, 24},  {-30, 52},     {-1074, 62}, {962, 62},   {-40, 63},
                                        {-1074, 70}, {-1074, 2098}, {7, 0}};
  return all;
}

// x is on the lattice by its digits: an odd integer times a power of two.
bool holds(const Lattice& l, double x) {
  if (!std::isfinite(x)) return false;
  if (x == 0) return true;
  const OddForm f = odd_form(x);
  return f.exponent >= l.exponent && std::ilogb(x) < l.exponent + l.bits;
}

TEST(LatticePointTest, HoldsWhatTheLatticeHoldsAndNothingElse) {
  std::uint64_t held = 0, refused = 0;
  for (const Lattice& l : lattices()) {
    const Kernel kernel(l);
    const LatticeIntake intake(l);
    for (std::uint64_t i = 0; i < battery::fitting<std::uint64_t>(20'000); ++i) {
      Entropy e(11, i);
      double x = any_coordinate(e, l);
      switch (e.below(6)) {
        case 0:
          x = extreme_coordinate(e);
          break;
        case 1:
          x = std::nextafter(x, e.coin() ? inf : -inf);
          break;
        case 2:
          x = std::ldexp(e.coin() ? 1.0 : -1.0, std::min(l.exponent + l.bits - static_cast<int>(e.below(2)), 1023));
          break;
        case 3:
          x *= 0.5;
          break;
        default:
          break;
      }
      LatticePoint<1> p;
      const bool on = intake.take(std::array{x}, p);
      ASSERT_EQ(on, holds(l, x)) << std::hexfloat << x << " on 2^" << l.exponent << ", " << std::dec << l.bits;
      if (on) {
        ASSERT_EQ(intake.given(p.words()[0]), x) << std::hexfloat << x;
        ++held;
      } else {
        ASSERT_NE(thrown_by<Error>([&] { return kernel.point(x); }), "nothing");
        ++refused;
      }
    }
  }
  EXPECT_GT(held, battery::fitting(50'000u));
  EXPECT_GT(refused, battery::fitting(50'000u));
}

TEST(LatticePointTest, NamesTheArgument) {
  const Kernel kernel(plan(Lattice{-4, 20}));
  const Point2 a{0, 0}, b{1, 0.0625};
  EXPECT_EQ(
      thrown_by<OffLattice>([&] {
        return kernel.orient2d(a, b, Point2{3, 0.1});
      }),
      "orient2d: c.y is 0.1, which the plan's lattice does not hold (multiples of 2^-4 below 2^16); plan with the "
      "lattice of all coordinates");
  EXPECT_THAT(thrown_by<OffLattice>([&] {
                return kernel.orient2d(a, Point2{-65536, 0}, b);
              }),
              testing::StartsWith("orient2d: b.x is -65536, "));
  EXPECT_EQ(thrown_by<NonFinite>([&] {
              return kernel.orient2d(a, Point2{0.1, nan}, b);
            }),
            "orient2d: b.y is nan, not a real number; give a finite double");
  EXPECT_EQ(thrown_by<NonFinite>([&] { return kernel.sign<PlaneSide>(Vector3{}, Point3{}, 1.0, -inf); }),
            "plane_side: d is -inf, not a real number; give a finite double");
  EXPECT_THAT(thrown_by<OffLattice>([&] { return kernel.sign<PlaneSide>(Vector3{}, Point3{}, 0.01, 1.0); }),
              testing::StartsWith("plane_side: c is 0.01, "));
}

TEST(LatticePointTest, NamesThePointOfASpan) {
  const Kernel kernel(plan(Lattice{0, 10}));
  std::vector<Point3> points(20, Point3{1, 2, 3});
  points[17].z = 0.5;
  EXPECT_THAT(thrown_by<OffLattice>([&] { return kernel.points(points); }),
              testing::StartsWith("point 17: a.z is 0.5, which"));
  points[5].y = inf;
  EXPECT_EQ(thrown_by<NonFinite>([&] { return kernel.points(points); }),
            "point 5: a.y is inf, not a real number; give a finite double");
  EXPECT_TRUE(kernel.points(std::span<const Point2>{}).empty());
}

TEST(LatticePointTest, PointsOfAnotherLatticeAreNotTaken) {
  for (const Lattice& l : lattices()) {
    for (const Lattice& m : lattices()) {
      const Kernel kernel(l), other(m);
      const auto mine = kernel.point(Point2{0, 0}), theirs = other.point(Point2{0, 0});
      if (l == m) {
        EXPECT_EQ(kernel.orient2d(mine, theirs, mine), Sign::zero);
        continue;
      }
      EXPECT_THAT(thrown_by<OffLattice>([&] { return kernel.orient2d(mine, theirs, mine); }),
                  testing::StartsWith("orient2d: argument b was taken in by the kernel of another lattice (multiples"));
      EXPECT_THROW(static_cast<void>(kernel.orient2d(theirs, theirs, theirs)), OffLattice);
      EXPECT_THROW(static_cast<void>(kernel.sign<Paraboloid>(other.point(Point3{}))), OffLattice);
    }
    const Kernel kernel(l);
    const auto mine = kernel.point(Point3{0, 0, 0});
    EXPECT_EQ(thrown_by<OffLattice>([&] { return kernel.orient3d(mine, mine, mine, LatticePoint<3>{}); }),
              "orient3d: argument d was never taken in; make it by kernel.point");
  }
}

TEST(LatticePointTest, NegativeZeroIsZero) {
  const Kernel kernel(Lattice{-1074, 40});
  EXPECT_EQ(kernel.point(-0.0), kernel.point(0.0));
  EXPECT_EQ(kernel.sign<Order>(-0.0, 0.0), Sign::zero);
}

}  // namespace
}  // namespace plumb
