// Do exact points compare, hash, sort and turn as the points do that they stand for, asked first, again, and by many?
#include "plumb/certify/exact_point.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <thread>
#include <unordered_set>

#include "certify/implicit/cases.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/query/section/intersection.hpp"

namespace plumb {
namespace {

using implicit_cases::check_all, implicit_cases::construction_of, implicit_cases::Pool, oracle::Question;

template <class Point>
using Exact = std::conditional_t<KindOf<Point>::dimension == 2, ExactPoint2, ExactPoint3>;

/// As its construction, and as a rational point.
template <class Point>
std::array<Exact<Point>, 2> both_ways(const Point& p) {
  const Exact<Point> made(p);
  return {made, Exact<Point>(rational_point(Exact<Point>(p)))};
}

/// The same of fresh points and of asked ones, of copies of these, of rational points and mixes.
template <class Ask, class... Points>
auto every_way(Ask ask, const Points&... points) {
  const std::tuple fresh{both_ways(points)...};
  const auto with = [&](unsigned rational) {
    unsigned bit = 1;
    return std::apply(
        [&](const auto&... p) { return ask(p[(rational & std::exchange(bit, bit << 1)) != 0 ? 1 : 0]...); }, fresh);
  };
  const auto first = with(0);
  EXPECT_EQ(with(0), first);
  const auto copied = fresh;
  EXPECT_EQ(std::apply([&](const auto&... p) { return ask(p[0]...); }, copied), first);
  for (unsigned rational = 1; rational < 1u << sizeof...(Points); ++rational)
    EXPECT_EQ(with(rational), first) << rational;
  return first;
}

constexpr auto turn2 = [](const auto&... p) {
  return every_way([](const auto&... q) { return orient2d(q...); }, p...);
};
constexpr auto turn3 = [](const auto&... p) {
  return every_way([](const auto&... q) { return orient3d(q...); }, p...);
};

TEST(ExactPoint, TurnsAsRationalsSayInThePlane) {
  using L = LineLinePoint2;
  using S = SegmentPoint2;
  check_all<L, L, L>(Question::orient, turn2, 500);
  check_all<L, Point2, S>(Question::orient, turn2, 500);
  check_all<Point2, S, L>(Question::orient, turn2, 500);
  check_all<S, S, S>(Question::orient, turn2, 500);
}

TEST(ExactPoint, TurnsAsRationalsSayInSpace) {
  using L = LinePlanePoint3;
  using S = SegmentPoint3;
  check_all<L, L, L, L>(Question::orient, turn3, 250);
  check_all<L, Point3, ThreePlanePoint3, S>(Question::orient, turn3, 250);
  check_all<Point3, Point3, S, L>(Question::orient, turn3, 250);
}

/// Order, equality and hash of random points of these kinds, some of which are equal.
template <class P, class Q>
void hold_order() {
  SCOPED_TRACE(__PRETTY_FUNCTION__);
  std::array<int, 4> axes{};
  const auto hold = [&](implicit_cases::Numbers numbers, std::uint64_t cases) {
    for (std::uint64_t index = 0; index < cases && !testing::Test::HasFailure(); ++index) {
      Entropy entropy(40, index);
      Pool pool(numbers, KindOf<P>::dimension, entropy);
      P p;
      Q q;
      pool.make(p), pool.make(q);
      const auto exact = oracle::rational_order(implicit_cases::constructed(p), implicit_cases::constructed(q));
      const auto compare = [](const auto& a, const auto& b) {
        EXPECT_EQ(a == b, (a <=> b) == 0);
        EXPECT_EQ(a<b, (b <=> a)> 0);
        return static_cast<int>(certify::order(a, b));
      };
      if (!exact) {
        EXPECT_THROW(compare(Exact<P>(p), Exact<P>(q)), DegeneratePoint) << index;
        continue;
      }
      EXPECT_EQ(every_way(compare, p, q), static_cast<int>(exact->sign)) << numbers.name() << index;
      ++axes[static_cast<std::size_t>(exact->sign == Sign::zero ? 3 : exact->axis)];
      if (exact->sign != Sign::zero) continue;
      const std::hash<Exact<P>> hash;
      for (const auto& a : both_ways(p)) {
        for (const auto& b : both_ways(q)) EXPECT_EQ(hash(a), hash(b)) << index;
      }
    }
  };
  hold({}, 6000);
  for (const int cases : {axes[0], axes[1], axes[3]}) EXPECT_GE(cases, 12);
  for (const FamilyInfo& info : families) hold({false, info.family}, 150);
}

TEST(ExactPoint, OrderEqualityAndHashGoByThePoint) {
  hold_order<LineLinePoint2, LineLinePoint2>();
  hold_order<LineLinePoint2, Point2>();
  hold_order<SegmentPoint2, LineLinePoint2>();
  hold_order<Point2, Point2>();
  hold_order<LinePlanePoint3, LinePlanePoint3>();
  hold_order<LinePlanePoint3, ThreePlanePoint3>();
  hold_order<SegmentPoint3, Point3>();
}

TEST(ExactPoint, WhatRoundsToOneDoubleIsToldApart) {
  // 1 + 2^-60, whose nearest double is 1; 1 + 2^-53, halfway to the next.
  const ExactPoint2 one{Point2{1, 0}}, above{SegmentPoint2{{1, 0}, {2, 0}, 0x1p-60}},
      halfway{SegmentPoint2{{1, 0}, {2, 0}, 0x1p-53}}, below{SegmentPoint2{{1, 0}, {2, 0}, -0x1p-1074}};
  const std::array ascending{below, one, above, halfway};
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    EXPECT_EQ(approximate(ascending[i]), (Point2{1, 0}));
    EXPECT_EQ(hash_value(ascending[i]), hash_value(one));
    for (std::size_t j = 0; j < ascending.size(); ++j) EXPECT_EQ(ascending[i] <=> ascending[j], i <=> j) << i << j;
  }
  EXPECT_EQ(orient2d(ExactPoint2(Point2{0, 0}), one, ExactPoint2(SegmentPoint2{{1, 0}, {1, 1}, 0x1p-1074})),
            Sign::positive);
  EXPECT_EQ(orient2d(ExactPoint2(Point2{0, 0}), above, halfway), Sign::zero);
  // Zeros of either sign are one point.
  EXPECT_EQ(ExactPoint2(Point2{-0.0, 0}), ExactPoint2(Point2{0, -0.0}));
  EXPECT_EQ(hash_value(ExactPoint2(Point2{-0.0, 0})), hash_value(ExactPoint2(Point2{0, -0.0})));
}

TEST(ExactPoint, BeyondDoublesIsAPlaceToo) {
  const double most = std::numeric_limits<double>::max();
  const auto beyond = [&](double t) { return ExactPoint2(SegmentPoint2{{0, 0}, {most, most}, t}); };
  EXPECT_LT(beyond(2), beyond(3));
  EXPECT_LT(ExactPoint2(Point2{most, most}), beyond(2));
  EXPECT_LT(beyond(-3), beyond(-2));
  EXPECT_EQ(beyond(3), ExactPoint2(rational_point(beyond(3))));
  EXPECT_EQ(hash_value(beyond(2)), hash_value(beyond(3)));
  EXPECT_EQ(orient2d(beyond(2), beyond(3), ExactPoint2(Point2{0, 0})), Sign::zero);
  EXPECT_EQ(orient2d(beyond(-2), beyond(3), ExactPoint2(Point2{0, 1})), Sign::positive);
  EXPECT_THROW(approximate(beyond(2)), BeyondDoubles);
}

TEST(ExactPoint, SaysWhichArgumentIsNoPoint) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const ExactPoint2 sound{Point2{1, 2}}, none{LineLinePoint2{{0, 0}, {1, 1}, {0, 1}, {1, 2}}};
  const ExactPoint2 odd{Point2{1, nan}}, far{LineLinePoint2{{0, 0}, {1, 1}, {infinite, 1}, {1, 2}}};
  for (int times = 0; times < 2; ++times) {
    EXPECT_THAT(text_of<DegeneratePoint>([&] { return sound < none; }),
                testing::HasSubstr("compare_xy: argument b has no point: its lines ab and cd are parallel"));
    EXPECT_THROW(static_cast<void>(none == none), DegeneratePoint);
    EXPECT_THROW(orient2d(sound, none, sound), DegeneratePoint);
    EXPECT_THROW(hash_value(none), DegeneratePoint);
    EXPECT_THROW(approximate(none), DegeneratePoint);
    EXPECT_THAT(text_of<NonFinite>([&] { return odd == sound; }), testing::HasSubstr("compare_xy: a.y is nan"));
    EXPECT_THAT(text_of<NonFinite>([&] { orient2d(sound, sound, far); }), testing::HasSubstr("orient2d: c.c.x is inf"));
    EXPECT_THROW(static_cast<void>(ExactPoint2(Point2{infinite, 0}) == ExactPoint2(Point2{infinite, 0})), NonFinite);
    EXPECT_THROW(static_cast<void>(odd < ExactPoint2(Point2{0, 0})), NonFinite);
    EXPECT_THROW(hash_value(odd), NonFinite);
    EXPECT_THROW(rational_point(odd), NonFinite);
  }
}

/// Crossings of lines through points of a small lattice: many are equal, few are doubles.
std::vector<ExactPoint2> crossings() {
  std::vector<ExactPoint2> points;
  for (std::uint64_t index = 0; points.size() < 600; ++index) {
    Entropy entropy(41, index);
    const auto at = [&] {
      return Point2{static_cast<double>(entropy.within(2)), static_cast<double>(entropy.within(2))};
    };
    const Segment2 s{at(), at()}, t{at(), at()};
    const Intersection2 common = intersection(s, t);
    if (common.kind == IntersectionKind::point) points.push_back(common.vertices[0]);
  }
  return points;
}

TEST(ExactPoint, GoesIntoSortAndMapsAndSets) {
  std::vector<ExactPoint2> points = crossings();
  using Rationals = std::pair<Rational, Rational>;
  std::map<Rationals, int> exact;
  for (const ExactPoint2& p : points) {
    const RationalPoint2 r = rational_point(p);
    ++exact[{r.x, r.y}];
  }
  std::map<ExactPoint2, int> ordered;
  for (const ExactPoint2& p : points) ++ordered[p];
  const std::unordered_set<ExactPoint2> hashed(points.begin(), points.end());
  EXPECT_EQ(ordered.size(), exact.size());
  EXPECT_EQ(hashed.size(), exact.size());
  EXPECT_LT(exact.size(), points.size() / 2);
  std::sort(points.begin(), points.end());
  auto p = points.begin();
  for (const auto& [place, count] : exact) {
    for (int i = 0; i < count; ++i, ++p) {
      const RationalPoint2 r = rational_point(*p);
      EXPECT_TRUE((Rationals{r.x, r.y} == place));
    }
  }
}

TEST(ExactPoint, ThreadsMayAskOnePointAtATime) {
  // Ever new points, which all threads ask first: every answer is that of one thread.
  const std::vector<ExactPoint2> points = crossings();
  std::vector<int> alone;
  const auto ask = [](const std::vector<ExactPoint2>& p) {
    std::vector<int> answers;
    for (std::size_t i = 0; i + 2 < p.size(); ++i) {
      answers.push_back(static_cast<int>(orient2d(p[i], p[i + 1], p[i + 2])));
      answers.push_back(static_cast<int>(compare_xy(p[i], p[p.size() - 1 - i])));
      answers.push_back(ExactPoint2(p[i]) == p[i + 1] ? 1 : 0);
    }
    return answers;
  };
  const std::vector<int> expected = ask(crossings());
  std::array<std::vector<int>, 4> answers;
  std::vector<std::thread> threads;
  threads.reserve(answers.size());
  for (auto& mine : answers) threads.emplace_back([&mine, &points, &ask] { mine = ask(points); });
  for (std::thread& t : threads) t.join();
  for (const auto& mine : answers) EXPECT_EQ(mine, expected);
}

TEST(ExactPoint, CopiesAndMovesStandForThePoint) {
  ExactPoint3 p{LinePlanePoint3{{0, 0, -1}, {1, 2, 5}, {0, 0, 0}, {3, 0, 1}, {0, 3, 1}}};
  const ExactPoint3 same{rational_point(p)};  // p keeps integers now
  ExactPoint3 copy = p, moved = std::move(p);
  EXPECT_EQ(copy, same);
  EXPECT_EQ(moved, same);
  copy = ExactPoint3(Point3{1, 2, 3});
  EXPECT_EQ(copy, ExactPoint3(Point3{1, 2, 3}));
  EXPECT_NE(copy, moved);
  EXPECT_EQ(approximate(copy), (Point3{1, 2, 3}));
  copy = moved;
  EXPECT_EQ(copy, same);
  ExactPoint3& itself = copy;
  copy = itself;
  EXPECT_EQ(copy, same);
}

}  // namespace
}  // namespace plumb
