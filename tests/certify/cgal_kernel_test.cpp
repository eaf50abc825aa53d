// Does our kernel take CGAL's decisions as CGAL does?  Each predicate against rationals, and whole algorithms against
// Epick: equal output, vertex for vertex, on every family of hard inputs.
#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "certify/case_line.hpp"
#include "oracle/cgal_algorithms.hpp"
#include "plumb/degenerate/exact.hpp"
#include "plumb/degenerate/points.hpp"

namespace plumb {
namespace {

using oracle::Algorithm, oracle::Answer, oracle::KernelChoice;

#ifdef PLUMB_LONG_TESTS
constexpr std::uint64_t factor = 100;
#else
constexpr std::uint64_t factor = 1;
#endif

std::string printed(std::span<const double> coordinates) {
  std::string words;
  for (const double x : coordinates) words += hexadecimal(x) + ' ';
  return words;
}

struct Aim {
  Family family;
  Degeneracy degeneracy;
};

std::vector<Aim> aims() {
  std::vector<Aim> all;
  for (const FamilyInfo& f : families) {
    for (const Degeneracy d : degeneracies) all.push_back({f.family, d});
  }
  return all;
}

class CgalKernel : public testing::TestWithParam<Aim> {};

TEST_P(CgalKernel, PredicatesAnswerAsRationalsDo) {
  std::set<Answer, decltype([](const Answer& a, const Answer& b) {
             return std::tie(a.predicate, a.sign) < std::tie(b.predicate, b.sign);
           })>
      seen;
  for (std::uint64_t i = 0; i < 40 * factor; ++i) {
    Entropy entropy(31, i);
    const auto five = coordinates3<5>(GetParam().family, GetParam().degeneracy, entropy);
    const std::vector<Answer> exact = oracle::exact_answers(five);
    seen.insert(exact.begin(), exact.end());
    const std::vector<Answer> ours = oracle::answers_of(KernelChoice::ours, five);
    ASSERT_EQ(ours.size(), exact.size()) << printed(five);
    for (std::size_t k = 0; k < exact.size(); ++k) {
      ASSERT_EQ(ours[k].predicate, exact[k].predicate) << printed(five);
      ASSERT_EQ(ours[k].sign, exact[k].sign) << exact[k].predicate << ' ' << printed(five);
    }
  }
  if (GetParam().family != Family::degenerate_short) return;  // the others need not hold what follows
  const std::string circle = "coplanar_side_of_bounded_circle_3";
  if (GetParam().degeneracy == Degeneracy::cocircular) {
    EXPECT_TRUE(seen.contains({circle, 0}));
  }
  if (GetParam().degeneracy != Degeneracy::coplanar) return;
  for (const int sign : {-1, 1}) {
    EXPECT_TRUE(seen.contains({circle, sign})) << sign;
    EXPECT_TRUE(seen.contains({"coplanar_orientation_3", sign})) << sign;
  }
}

void expect_equal(Algorithm algorithm, std::span<const double> coordinates) {
  const auto ours = oracle::made_by(algorithm, KernelChoice::ours, coordinates);
  EXPECT_EQ(ours, oracle::made_by(algorithm, KernelChoice::epick, coordinates)) << printed(coordinates);
}

TEST_P(CgalKernel, AlgorithmsMakeTheSameAsOnEpick) {
  for (std::uint64_t i = 0; i < 4 * factor; ++i) {
    Entropy entropy(32, i);
    const std::size_t count = 4 + 20 * entropy.below(8);
    std::vector<double> plane(2 * count), space(3 * count);
    fill_points(GetParam().family, GetParam().degeneracy, 2, plane, entropy);
    fill_points(GetParam().family, GetParam().degeneracy, 3, space, entropy);
    expect_equal(Algorithm::delaunay_2, plane);
    expect_equal(Algorithm::delaunay_3, space);
    expect_equal(Algorithm::convex_hull_3, space);
    if (HasFailure()) FAIL() << "case " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Families, CgalKernel, testing::ValuesIn(aims()), [](const auto& at) {
  return std::string(name_of(at.param.family)) + "_" + std::string(name_of(at.param.degeneracy));
});

/// The lattice points of a box, n to an edge: nothing but squares and cubes.
std::vector<double> lattice(int dimension, int n) {
  std::vector<double> c;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < (dimension == 3 ? n : 1); ++k) {
        c.push_back(i);
        c.push_back(j);
        if (dimension == 3) c.push_back(k);
      }
    }
  }
  return c;
}

TEST(CgalKernelOnSets, LatticesAreMadeTheSame) {
  expect_equal(Algorithm::delaunay_2, lattice(2, 24));
  expect_equal(Algorithm::delaunay_3, lattice(3, 9));
  expect_equal(Algorithm::convex_hull_3, lattice(3, 9));
}

TEST(CgalKernelOnSets, RandomPointsOfA20BitGridAreMadeTheSame) {
  std::vector<double> c;
  Entropy entropy(33);
  for (int i = 0; i < 6000; ++i) c.push_back(static_cast<double>(entropy.bits(20)));
  for (const Algorithm a : {Algorithm::delaunay_2, Algorithm::delaunay_3, Algorithm::convex_hull_3}) expect_equal(a, c);
}

TEST(CgalKernelOnSets, ManyPointsOfOneSphereAreMadeTheSame) {
  for (std::uint64_t i = 0; i < 3; ++i) {
    Entropy entropy(34, i);
    std::vector<double> c(3 * 300);
    fill_exact(Degeneracy::cospherical, 3, 20, c, entropy);
    expect_equal(Algorithm::delaunay_3, c);
    expect_equal(Algorithm::convex_hull_3, c);
  }
}

TEST(CgalKernelOnSets, RepeatedPointsAreMadeTheSame) {
  std::vector<double> c = lattice(3, 4);
  const std::vector<double> once = c;
  for (int i = 0; i < 4; ++i) c.insert(c.end(), once.begin(), once.end());
  expect_equal(Algorithm::delaunay_2, c);
  expect_equal(Algorithm::delaunay_3, c);
  expect_equal(Algorithm::convex_hull_3, c);
}

}  // namespace
}  // namespace plumb
