// The threshold of a box serves all points of the box; what is outside cannot be asked for.
#include "plumb/certify/bounded_points.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "certify/lattice_cases.hpp"

namespace plumb {
namespace {

using namespace lattice_cases;
using namespace predicates;

template <class F>
class BoundedPointsTest : public testing::Test {};
template <class F>
using PointOf = std::conditional_t<F::dimension == 2, Point2, Point3>;
// A difference across axes and a sum beside differences of one axis.
struct AcrossAxes {
  static constexpr std::string_view name = "across_axes";
  static constexpr int points = 2, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 4>& p) const {
    return (p[0] - p[1]) * (p[2] + p[3]) - (p[0] - p[2]) * (p[1] - p[3]);
  }
};
using Formulas = testing::Types<Orient2d, Orient3d, InCircle, InSphere, Mixed, AcrossAxes>;
TYPED_TEST_SUITE(BoundedPointsTest, Formulas);

template <Formula F, class Point>
std::vector<Point> scene_of(Family family, Degeneracy degeneracy, std::uint64_t i) {
  Entropy e(7, i);
  std::vector<double> x(static_cast<std::size_t>(F::dimension) * 12);
  fill_points(family, degeneracy, F::dimension, x, e);
  std::vector<Point> points;
  for (std::size_t k = 0; k < x.size(); k += static_cast<std::size_t>(F::dimension)) {
    if constexpr (F::dimension == 2) {
      points.push_back({x[k], x[k + 1]});
    } else {
      points.push_back({x[k], x[k + 1], x[k + 2]});
    }
  }
  return points;
}

TYPED_TEST(BoundedPointsTest, TellsTheExactSignOfEveryFamily) {
  using F = TypeParam;
  using Point = PointOf<F>;
  std::uint64_t sure = 0, all = 0;
  for (const FamilyInfo& family : families) {
    for (std::uint64_t i = 0; i < 300; ++i) {
      const auto degeneracy = F::dimension == 2 && i % 4 == 1 ? Degeneracy::collinear : degeneracies[i % 4];
      const auto points = scene_of<F, Point>(family.family, degeneracy, i);
      const BoundedPoints<Point> scene(points);
      const auto predicate = scene.template predicate<F>();
      Entropy e(8, i);
      for (int ask = 0; ask < 4; ++ask) {
        std::array<std::size_t, static_cast<std::size_t>(F::points)> n{};
        for (std::size_t& x : n) x = e.below(points.size());
        Coordinates<F> p{};
        for (std::size_t k = 0; k < n.size(); ++k) {
          const auto x = coordinates(points[n[k]]);
          std::copy(x.begin(), x.end(), p.begin() + static_cast<std::ptrdiff_t>(k * x.size()));
        }
        const Sign sign = std::apply(predicate, n);
        ASSERT_EQ(sign, decide<F>(p)) << to_string(CaseLine{std::string(F::name), {p.begin(), p.end()}, {}});
        if (const int s = bounded_filter<F>(p, predicate.threshold()); s != 0) {
          ++sure;
          ASSERT_EQ(static_cast<Sign>(s), sign);
        }
        ++all;
      }
    }
  }
  EXPECT_GT(sure, all / 20);  // four families are degenerate, and most points of others repeat
}

TYPED_TEST(BoundedPointsTest, ThresholdIsThatOfFilterBOverTheBox) {
  using F = TypeParam;
  using Point = PointOf<F>;
  for (std::uint64_t i = 0; i < 500; ++i) {
    const auto points = scene_of<F, Point>(families[i % families.size()].family, Degeneracy::collinear, i);
    const BoundedPoints<Point> scene(points);
    const auto within = largest_within<F>(scene.bounds());
    Entropy e(9, i);
    Coordinates<F> p{};
    for (std::size_t k = 0; k < p.size(); k += static_cast<std::size_t>(F::dimension)) {
      const auto x = coordinates(points[e.below(points.size())]);
      std::copy(x.begin(), x.end(), p.begin() + static_cast<std::ptrdiff_t>(k));
    }
    const auto largest = largest_differences<F>(p);
    for (std::size_t k = 0; k < within.size(); ++k) ASSERT_GE(within[k], largest[k]) << i;
  }
}

TEST(BoundedPointsTest, RefusesByName) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Point2> points{{0, 0}, {1, 0}, {0, 1}};
  const BoundedPoints<Point2> scene(points);
  const auto orient = scene.predicate<Orient2d>();
  EXPECT_EQ(orient(0, 1, 2), Sign::positive);
  EXPECT_EQ(orient(0, 2, 1), Sign::negative);
  EXPECT_EQ(orient(0, 2, 2), Sign::zero);
  try {
    static_cast<void>(orient(0, 1, 3));
    FAIL() << "took a point that is not there";
  } catch (const NoSuchPoint& e) {
    EXPECT_STREQ(e.what(), "orient2d: argument c is point 3 of 3, which are counted from 0");
  }
  EXPECT_THROW(static_cast<void>(orient(-1, 1, 2)), NoSuchPoint);
  const std::vector<Point3> bad{{0, 0, 0}, {1, nan, 0}};
  try {
    const BoundedPoints<Point3> refused(bad);
    FAIL() << "took a NaN";
  } catch (const NonFinite& e) {
    EXPECT_STREQ(e.what(), "point 1: a.y is nan, not a real number; give a finite double");
  }
  const BoundedPoints<Point2> none(std::span<const Point2>{});
  EXPECT_THROW(static_cast<void>(none.predicate<Orient2d>()(0, 0, 0)), NoSuchPoint);
}

}  // namespace
}  // namespace plumb
