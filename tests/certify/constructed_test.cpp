// approximate() against MPFR, which rounds the rational point once; homogeneous() against the constructed rationals.
#include "plumb/certify/constructed.hpp"

#include <bit>
#include <cmath>

#include "certify/implicit/cases.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/big.hpp"

namespace plumb::implicit_cases {
namespace {

template <class Point>
std::vector<double> rounded(const Point& p) {
  const auto numbers = coordinates(approximate(p));
  return {numbers.begin(), numbers.end()};
}

struct Seen {
  int points = 0, degenerate = 0, beyond = 0, subnormal = 0, rounded = 0;
};

template <class Point>
void check_point(const Point& p, Seen& seen) {
  const oracle::Constructed told = constructed(p);
  ++seen.points;
  for (int axis = 0; axis < KindOf<Point>::dimension; ++axis) {
    const auto nearest = oracle::nearest_coordinate(told, axis);
    if (!nearest) {
      ++seen.degenerate;
      ASSERT_THROW(approximate(p), DegeneratePoint);
      return;
    }
    if (nearest->overflows) {
      ++seen.beyond;
      ASSERT_THROW(approximate(p), BeyondDoubles);
      return;
    }
  }
  const std::vector<double> said = rounded(p);
  for (int axis = 0; axis < KindOf<Point>::dimension; ++axis) {
    const double x = oracle::nearest_coordinate(told, axis)->value;
    const auto place = static_cast<std::size_t>(axis);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(said[place]), std::bit_cast<std::uint64_t>(x + 0.0))
        << std::hexfloat << said[place] << " for " << x;
    seen.subnormal += x != 0 && std::fabs(x) < 0x1p-1022;
    seen.rounded += x != std::round(x);
  }
}

template <class Point>
Seen check_kind() {
  Seen seen;
  const auto run = [&](Numbers numbers, std::uint64_t count) {
    for (std::uint64_t index = 0; index < count; ++index) {
      SCOPED_TRACE(testing::Message() << numbers.name() << " case " << index);
      Entropy entropy(7, index);
      Pool pool(numbers, KindOf<Point>::dimension, entropy);
      Point p;
      pool.make(p);
      check_point(p, seen);
      if (testing::Test::HasFatalFailure()) return;
    }
  };
  run({}, battery::fitting<std::uint64_t>(2'000));
  for (const FamilyInfo& info : families) run({false, info.family}, battery::fitting<std::uint64_t>(500));
  return seen;
}

TEST(ApproximateTest, IsTheExactPointRoundedOnce) {
  int beyond = 0;
  for (const Seen& seen :
       {check_kind<LineLinePoint2>(), check_kind<LinePlanePoint3>(), check_kind<ThreePlanePoint3>()}) {
    EXPECT_GT(seen.degenerate * 10, seen.points);
    beyond += seen.beyond;
    EXPECT_GT(seen.rounded * 2, seen.points);
  }
  if (battery::reaches_rare) {
    EXPECT_GT(beyond, 0);
  }
  for (const Seen& seen : {check_kind<SegmentPoint2>(), check_kind<SegmentPoint3>(), check_kind<Posed<Point2, Pose2>>(),
                           check_kind<Posed<Point3>>()}) {
    EXPECT_EQ(seen.degenerate, 0);
    EXPECT_GT(seen.beyond, 0);
    EXPECT_GT(seen.subnormal, 0);
    EXPECT_GT(seen.rounded * 2, seen.points);
  }
}

TEST(ApproximateTest, RoundsTiesToEven) {
  const double odd = 1 + 0x1p-52, even = 1 + 0x1p-51;
  EXPECT_EQ(approximate(SegmentPoint2{{1, odd}, {odd, even}, 0.5}), (Point2{1, even}));
  EXPECT_EQ(approximate(SegmentPoint2{{0, 0}, {0x1p-1074, 0x1.8p-1073}, 0.5}), (Point2{0, 0x1p-1073}));
  // A tie that a crossing hits exactly, and the least beyond it.
  const LineLinePoint2 tie{{0, 0}, {6, 6}, {2, 2 * odd}, {2 * odd, 2}};  // 1 + odd, halfway between two doubles
  EXPECT_EQ(approximate(tie), (Point2{2, 2}));
}

TEST(ApproximateTest, BeyondTheLargestDoubleThrowsByName) {
  const double largest = std::numeric_limits<double>::max();
  const auto moved = [&](double by) { return Posed{Point2{1, largest}, Pose2{{{{1, 0}, {0, 1}}}, {0, by}}}; };
  EXPECT_EQ(approximate(moved(0x1p969)), (Point2{1, largest}));
  EXPECT_EQ(approximate(moved(moved_by_ulps(0x1p970, -1))), (Point2{1, largest}));
  EXPECT_EQ(approximate(moved(-largest)), (Point2{1, 0}));
  try {
    approximate(moved(0x1p970));  // a tie, to even: to what would be the next power of two
    FAIL() << "rounded to infinity";
  } catch (const BeyondDoubles& e) {
    EXPECT_STREQ(e.what(), "approximate: a.y is beyond the largest double");
  }
  EXPECT_THROW(approximate(SegmentPoint2{{0, 0}, {-largest, 0}, 1 + 0x1p-52}), BeyondDoubles);
}

TEST(ApproximateTest, PointsAsGivenStayAsTheyAre) {
  EXPECT_EQ(approximate(Point2{0x1p-1074, 1e308}), (Point2{0x1p-1074, 1e308}));
  EXPECT_EQ(approximate(Point3{1, -2, 3}), (Point3{1, -2, 3}));
  EXPECT_THROW(approximate(Point3{1, -2, std::numeric_limits<double>::infinity()}), NonFinite);
  EXPECT_THROW(approximate(SegmentPoint2{{0, 0}, {1, 1}, std::numeric_limits<double>::quiet_NaN()}), NonFinite);
}

TEST(ApproximateTest, PairsOfDoublesDecideNearlyAlways) {
  int sure = 0, all = 0;
  for (std::uint64_t index = 0; index < battery::fitting<std::uint64_t>(20'000); ++index) {
    Entropy entropy(8, index);
    std::vector<Ball> numbers;
    for (int i = 0; i < predicates::ThreePlaneKind3::numbers; ++i)
      numbers.emplace_back(signed_unit_coordinate(entropy));
    const auto p = predicates::ThreePlaneKind3::at(numbers.data());
    sure += (p.base[0] + quotient(p.offset[0], p.weight)).nearest().has_value();
    ++all;
  }
  EXPECT_GT(sure * 1000, all * 999);
}

TEST(HomogeneousTest, IsThePointTimesItsWeight) {
  const auto exact = [](double x) { return big_rational(x); };
  int weighted = 0;
  for (std::uint64_t index = 0; index < 1'000; ++index) {
    Entropy entropy(9, index);
    Pool pool({}, 3, entropy);
    LinePlanePoint3 p;
    pool.make(p);
    const auto h = homogeneous(p, exact);
    if (h.weight.sign() == Sign::zero) continue;
    ++weighted;
    const oracle::Constructed told = constructed(p);
    for (int axis = 0; axis < 3; ++axis) {
      const mpq_class x = h.coordinate[static_cast<std::size_t>(axis)].value / h.weight.value;
      mpq_class off = x - mpq_class(oracle::nearest_coordinate(told, axis)->value);
      ASSERT_TRUE(abs(off) <= abs(x) / mpq_class(0x1p53)) << index;
    }
  }
  EXPECT_GT(weighted, 500);
  const auto posed = homogeneous(Posed{Point2{1, 2}, Pose2{{{{0, 1}, {-1, 0}}}, {10, 20}}}, exact);
  EXPECT_TRUE(posed.weight.value == 1);
  EXPECT_TRUE(posed.coordinate[0].value == 8);
  EXPECT_TRUE(posed.coordinate[1].value == 21);
}

}  // namespace
}  // namespace plumb::implicit_cases
