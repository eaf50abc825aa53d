// Who is not certainly inside a ball that moves: nobody is missed, few are named in vain; passes in lanes say what one
// number at a time says; and the statement's bounds are derived and confirmed.
#include "figure/sphere/rest_scan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>

#include "certify/statements/golden_statements.hpp"
#include "certify/statements/mutant_statements.hpp"
#include "certify/statements/promised_share.hpp"
#include "certify/statements/proved_statements.hpp"
#include "figure/sphere/stays_inside.hpp"
#include "plumb/certify/judged_proofs.hpp"
#include "plumb/degenerate/points.hpp"

namespace plumb::figure::sphere {
namespace {

using stays_inside::HWY_NAMESPACE::StaysInside;

double any_number(Entropy& entropy) { return static_cast<double>(entropy.bits(53)) * 0x1p-52 - 1; }

/// On a sphere around (3, 5, 7), but for roundings.
std::vector<Point3> on_a_sphere(Entropy& entropy, std::size_t count) {
  std::vector<Point3> points;
  while (points.size() < count) {
    const double x = any_number(entropy), y = any_number(entropy), z = any_number(entropy);
    const double d = std::sqrt(x * x + y * y + z * z);
    if (d > 0.1) points.push_back({3 + x / d, 5 + y / d, 7 + z / d});
  }
  return points;
}

/// Asks of all blocks; nobody who is left out may be on the ball or outside.
template <class Spanned>
std::size_t named_of(RestScan<Spanned>& scan, std::span<const PointOf<Spanned>> points, const Spanned& ball) {
  std::vector<std::size_t> named;
  scan.aim(fine_ball(ball));
  for (std::size_t first = 0; first < points.size(); first += RestScan<Spanned>::block) {
    scan.not_certainly_inside(first, named);
  }
  std::vector<bool> is_named(points.size());
  for (const std::size_t i : named) is_named[i] = true;
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_TRUE(is_named[i] || side(ball, points[i]) == Sign::positive) << "point " << i;
  }
  return named.size();
}

// Balls through four of the points hold or leave out the others by some ulps.
TEST(RestScan, NamesFewBesideThoseThatAreNotInside) {
  Entropy entropy(71);
  const std::vector<Point3> points = on_a_sphere(entropy, 1003);
  Extent<Point3> extent{};
  ASSERT_TRUE(find_extent(std::span<const Point3>(points), extent));
  RestScan<SpannedSphere3> scan(points, extent);
  std::size_t named = 0, outside = 0;
  for (int i = 0; i < 20; ++i) {
    SpannedSphere3 ball{{}, 4};
    for (Point3& p : ball.points) p = points[entropy.below(points.size())];
    if (sign_of(predicates::Orient3d{}, ball.points[0], ball.points[1], ball.points[2], ball.points[3]) == Sign::zero)
      continue;
    SCOPED_TRACE(testing::Message() << "Entropy(71), ball " << i);
    named += named_of<SpannedSphere3>(scan, points, ball);
    for (const Point3& p : points) outside += side(ball, p) != Sign::positive ? 1 : 0;
  }
  std::printf("%zu named, %zu of them not inside\n", named, outside);
  EXPECT_GE(outside, 5000U);
  EXPECT_LE(named, outside + outside / 100);
}

// Wherever the ball goes, and whatever the points are.
TEST(RestScan, MissesNobody) {
  std::size_t named = 0, all = 0;
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < 20; ++i) {
      SCOPED_TRACE(testing::Message() << info.name << ", Entropy(72, " << i << ")");
      Entropy entropy(72, i);
      std::array<double, 60> x{};
      fill_points(info.family, Degeneracy::cospherical, 3, x, entropy);
      std::vector<Point3> points;
      for (std::size_t k = 0; k < 60; k += 3) points.push_back({x[k], x[k + 1], x[k + 2]});
      std::vector<Point2> flat;
      for (std::size_t k = 0; k < 60; k += 2) flat.push_back({x[k], x[k + 1]});
      Extent<Point3> extent{};
      Extent<Point2> of_flat{};
      ASSERT_TRUE(find_extent(std::span<const Point3>(points), extent));
      ASSERT_TRUE(find_extent(std::span<const Point2>(flat), of_flat));
      RestScan<SpannedSphere3> scan(points, extent);
      RestScan<SpannedCircle2> scan2(flat, of_flat);
      for (std::size_t k = 0; k + 1 < 12; ++k) {
        named += named_of<SpannedSphere3>(scan, points, {{points[k], points[k + 1]}, 2});
        named += named_of<SpannedCircle2>(scan2, flat, {{flat[k], flat[k + 1]}, 2});
        all += points.size() + flat.size();
      }
    }
  }
  std::printf("%zu named of %zu\n", named, all);
  EXPECT_LE(named * 10, all * 9);
}

template <class Point>
void expect_passes_as_one_by_one(std::span<const Point> points, const Point& center, double power) {
  double most = 0;
  auto min = coordinates(points[0]), max = min;
  bool real = true;
  for (const Point& p : points) {
    most = std::fmax(most, square_of_distance(center, p, power).value);
    const auto x = coordinates(p);
    for (std::size_t a = 0; a < x.size(); ++a) {
      min[a] = std::fmin(min[a], x[a]), max[a] = std::fmax(max[a], x[a]);
      real = real && std::isfinite(x[a]);
    }
  }
  Extent<Point> extent{};
  EXPECT_EQ(find_extent(points, extent), real);
  EXPECT_EQ(farthest_square(center, points, power), most);
  if (!real) return;
  EXPECT_EQ(coordinates(extent.min), min);
  EXPECT_EQ(coordinates(extent.max), max);
}

TEST(BlockReach, LanesSayWhatOneByOneSays) {
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < 40; ++i) {
      SCOPED_TRACE(testing::Message() << info.name << ", Entropy(73, " << i << ")");
      Entropy entropy(73, i);
      std::array<double, 66> x{};
      fill_points(info.family, Degeneracy::coplanar, 3, x, entropy);
      if (i % 8 == 7) x[3 + entropy.below(60)] = std::numeric_limits<double>::infinity();
      if (i % 8 == 3) x[3 + entropy.below(60)] = std::numeric_limits<double>::quiet_NaN();
      std::vector<Point3> points;
      std::vector<Point2> flat;
      for (std::size_t k = 0, of_points = 1 + entropy.below(20); k < of_points; ++k) {
        points.push_back({x[3 * k], x[3 * k + 1], x[3 * k + 2]});
        flat.push_back({x[2 * k], x[2 * k + 1]});
      }
      const double power = entropy.coin() ? 1 : 0x1p-40;
      expect_passes_as_one_by_one<Point3>(points, {x[63], x[64], x[65]}, power);
      expect_passes_as_one_by_one<Point2>(flat, {x[63], x[64]}, power);
    }
  }
}

template <std::size_t axes>
using Numbers = std::array<double, axes>;

/// Of small multiples of a quarter.
template <std::size_t axes>
std::string unnoticed() {
  struct Drawn {
    Numbers<axes> p, base, by;
    double rest, lead;
  };
  return mutants::unnoticed(
      [](mutants::Draw& draw) {
        Drawn x{};
        for (std::size_t a = 0; a < axes; ++a)
          x.p[a] = draw.number(), x.base[a] = draw.number(), x.by[a] = draw.quarter();
        x.rest = draw.number(), x.lead = draw.number();
        return x;
      },
      [](const Drawn& x) {
        mutants::World world;
        return std::optional(StaysInside()(world, x.p, x.rest, x.base, x.by, x.lead));
      },
      [](const Drawn& x) {
        double sum = x.rest + x.lead;
        for (std::size_t a = 0; a < axes; ++a) sum += (x.p[a] - x.base[a]) * x.by[a];
        return sum > 0;
      });
}

TEST(StaysInside, MutantsAreNoticed) {
  mutants::expect_noticed("stays_inside", unnoticed<3>());
  mutants::expect_noticed("stays_inside_2d", unnoticed<2>());
}

/// Of points that are inside: how many are told to be?
template <std::size_t axes>
void count_told(PromisedShare& share) {
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < battery::fitting<std::uint64_t>(600); ++i) {
      Entropy entropy(74, i);
      std::array<double, 12> x{};
      fill_points(info.family, Degeneracy::cospherical, 3, x, entropy);
      Numbers<axes> p{}, base{}, by{};
      for (std::size_t a = 0; a < axes; ++a) p[a] = x[a], base[a] = x[3 + a], by[a] = x[6 + a];
      RationalWorld exact;
      FloatWorld<StaysInside> w;
      Rational sum = exact.number(x[9]) + exact.number(x[10]);
      for (std::size_t a = 0; a < axes; ++a) sum = sum + exact.difference(p[a], base[a]) * exact.number(by[a]);
      const bool told = StaysInside()(w, p, x[9], base, by, x[10]) && w.certain();
      const bool is_so = sum.sign() == Sign::positive;
      EXPECT_TRUE(is_so || !told) << info.name << ", Entropy(74, " << i << ")";
      if (is_so) share.add(info.family, told);
    }
  }
}
TEST(StaysInside, IsToldInPromisedShare) {
  PromisedShare in_space("stays_inside"), in_the_plane("stays_inside_2d");
  count_told<3>(in_space);
  count_told<2>(in_the_plane);
}

template <std::size_t axes>
void expect_bounds(const char* name, const Numbers<axes>& p, const Numbers<axes>& base, const Numbers<axes>& by) {
  const std::vector<std::string> bounds = judged_bounds(StaysInside{}, p, 0.25, base, by, 0.5);
  expect_golden(name, bounds);
  expect_proved(bounds, judged_proofs(name, StaysInside{}, p, 0.25, base, by, 0.5));
}

TEST(StaysInside, DerivedBoundsAreAsRecordedAndProved) {
  expect_bounds<3>("stays_inside", {3, 4, 5}, {1, 2, 3}, {1, -1, 1});
  expect_bounds<2>("stays_inside_2d", {3, 4}, {1, 2}, {1, -1});
}

}  // namespace
}  // namespace plumb::figure::sphere
