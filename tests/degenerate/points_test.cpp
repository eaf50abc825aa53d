// Laws 1, 3 and 4 of degenerate/points.hpp, and how well each family meets its aim: shares of exact zeros, of points
// that moved, of different points.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "degenerate/rational_signs.hpp"
#include "plumb/degenerate.hpp"

namespace {

using plumb::Degeneracy, plumb::Entropy, plumb::Family;

constexpr int cases = 1000;

// Exact sign of the predicate that a degeneracy is aimed at, over the points 0, 1, 2, ...
int sign_of(Degeneracy degeneracy, std::size_t dimension, std::span<const double> c) {
  const std::array<std::size_t, 5> all = {0, 1, 2, 3, 4};
  const bool flat = plumb::is_flat(degeneracy);
  return flat ? plumb_test::sign_of_flat(c, dimension, std::span(all).first(dimension + 1))
              : plumb_test::sign_of_round(c, dimension, std::span(all).first(dimension + 2));
}

struct Shares {
  double zero = 0, all_different = 0, subnormal = 0, negative_zero = 0, huge = 0, tiny = 0;
};

Shares shares(Family family, Degeneracy degeneracy, std::size_t dimension) {
  Shares made;
  const std::size_t count = dimension + (plumb::is_flat(degeneracy) ? 1 : 2);
  std::vector<double> c(count * dimension);
  for (std::uint64_t i = 0; i < cases; ++i) {
    Entropy entropy(41, i);
    plumb::fill_points(family, degeneracy, static_cast<int>(dimension), c, entropy);
    const auto any = [&](auto&& test) { return std::any_of(c.begin(), c.end(), test) ? 1.0 / cases : 0.0; };
    EXPECT_EQ(any([](double x) { return !std::isfinite(x); }), 0);
    made.subnormal += any([](double x) { return std::fpclassify(x) == FP_SUBNORMAL; });
    made.negative_zero += any([](double x) { return x == 0 && std::signbit(x); });
    made.huge += any([](double x) { return std::fabs(x) > 0x1p900; });
    made.tiny += any([](double x) { return x != 0 && std::fabs(x) < 0x1p-900; });
    made.zero += (sign_of(degeneracy, dimension, c) == 0) / double{cases};
    bool different = true;
    plumb_test::for_each_subset(count, 2, [&](std::span<const std::size_t> s) {
      different &= !std::equal(&c[s[0] * dimension], &c[s[0] * dimension] + dimension, &c[s[1] * dimension]);
    });
    made.all_different += different / double{cases};
  }
  return made;
}

struct Aim {
  double least_zero, most_zero, least_different;
};

class Points : public testing::TestWithParam<std::tuple<Degeneracy, std::size_t>> {};

TEST_P(Points, MeetTheAimOfTheirFamily) {
  const auto [degeneracy, dimension] = GetParam();
  const std::map<Family, Aim> aims = {
      {Family::grid, {0.005, 0.3, 0.7}},        {Family::uniform, {0, 0, 1}},
      {Family::float32, {0, 0.01, 0.99}},       {Family::near_half, {0.02, 0.6, 0.6}},
      {Family::degenerate_short, {1, 1, 0.6}},  {Family::degenerate_long, {1, 1, 0.9}},
      {Family::off_by_ulps, {0.01, 0.5, 0.75}}, {Family::repeated, {0.9, 1, 0}},
      {Family::wide, {0.45, 0.55, 0.9}},        {Family::extreme, {0.45, 0.8, 0.75}},
      {Family::mixture, {0.1, 0.6, 0.6}},
  };
  ASSERT_EQ(aims.size(), plumb::families.size());
  for (const auto& [family, aim] : aims) {
    SCOPED_TRACE(name_of(family));
    const Shares s = shares(family, degeneracy, dimension);
    EXPECT_GE(s.zero, aim.least_zero - 1e-12);
    EXPECT_LE(s.zero, aim.most_zero + 1e-12);
    EXPECT_GE(s.all_different, aim.least_different - 1e-12);
    if (family == Family::extreme) {
      EXPECT_GT(s.subnormal, 0.1);
      EXPECT_GT(s.huge, 0.2);
      EXPECT_GT(s.tiny, 0.3);
    }
    if (family == Family::repeated) {
      EXPECT_LE(s.all_different, 1e-12) << "two points at least are equal";
      EXPECT_GT(s.negative_zero, 0.03);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Points,
                         testing::Values(std::tuple{Degeneracy::collinear, 2}, std::tuple{Degeneracy::cocircular, 2},
                                         std::tuple{Degeneracy::coplanar, 3}, std::tuple{Degeneracy::cospherical, 3}),
                         [](const auto& each) {
                           return std::string(name_of(std::get<0>(each.param))) +
                                  std::to_string(std::get<1>(each.param));
                         });

// Off by ulps means: beside an exactly degenerate set, a few coordinates moved and none by much.
TEST(OffByUlps, MovesUpToThreeCoordinatesByUpToFourUlps) {
  int moved_cases = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    std::vector<std::uint64_t> choices;
    Entropy entropy(42, i);
    entropy.record_into(&choices);
    const auto moved = plumb::coordinates3<4>(Family::off_by_ulps, Degeneracy::coplanar, entropy);
    // The first choice tells short from long; the set before the moves follows it.
    Entropy replay = Entropy::from_choices(std::span(choices).subspan(1));
    const Family exact = choices[0] != 0 ? Family::degenerate_long : Family::degenerate_short;
    const auto before = plumb::coordinates3<4>(exact, Degeneracy::coplanar, replay);
    int coordinates = 0;
    for (std::size_t k = 0; k < moved.size(); ++k) {
      const std::int64_t steps = std::abs(plumb::place_of(moved[k]) - plumb::place_of(before[k]));
      coordinates += steps != 0;
      EXPECT_LE(steps, 12);
    }
    EXPECT_LE(coordinates, 3);
    moved_cases += coordinates > 0;
  }
  EXPECT_GT(moved_cases, cases * 9 / 10);
}

TEST(PointVectors, HoldTheSameNumbersAsTheFlatForm) {
  for (const auto& info : plumb::families) {
    Entropy a(43), b(43), c(44), d(44);
    const auto flat2 = plumb::coordinates2<4>(info.family, Degeneracy::cocircular, a);
    const auto flat3 = plumb::coordinates3<5>(info.family, Degeneracy::cospherical, c);
    const auto points2 = plumb::points2(info.family, Degeneracy::cocircular, 4, b);
    const auto points3 = plumb::points3(info.family, Degeneracy::cospherical, 5, d);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(points2[i], (plumb::Point2{flat2[2 * i], flat2[2 * i + 1]}));
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_EQ(points3[i], (plumb::Point3{flat3[3 * i], flat3[3 * i + 1], flat3[3 * i + 2]}));
    }
  }
}

TEST(AnySize, FromNoPointToMany) {
  for (const auto& info : plumb::families) {
    for (const Degeneracy degeneracy : plumb::degeneracies) {
      for (const std::size_t count : {0u, 1u, 2u, 3u, 17u, 300u}) {
        Entropy entropy(45, count), none = Entropy::from_bytes({});
        for (const plumb::Point3& p : plumb::points3(info.family, degeneracy, count, entropy)) {
          ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
        }
        ASSERT_EQ(plumb::points2(info.family, degeneracy, count, none).size(), count);
      }
    }
  }
}

TEST(Catalog, ItsFirstLinesRun) {
  plumb::Entropy entropy(1, 42);
  std::array<double, 15> c =
      plumb::coordinates3<5>(plumb::Family::off_by_ulps, plumb::Degeneracy::cospherical, entropy);
  EXPECT_TRUE(std::all_of(c.begin(), c.end(), [](double x) { return std::isfinite(x); }));
}

TEST(Families, NamesAreUniqueAndFound) {
  for (std::size_t i = 0; i < plumb::families.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(plumb::families[i].family), i);
    EXPECT_EQ(plumb::family_named(plumb::families[i].name), plumb::families[i].family);
  }
  EXPECT_EQ(plumb::family_named("no such family"), std::nullopt);
}

}  // namespace
