// A point inside two k-DOPs: how often the guess finds it where there is one, that it claims none where there is none,
// and its statement: which world answers, and the bounds that are derived and confirmed.
#include "figure/k_dop/inner_point.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>

#include "arith/rational_lp.hpp"
#include "certify/statements/golden_statements.hpp"
#include "certify/statements/mutant_statements.hpp"
#include "certify/statements/promised_share.hpp"
#include "certify/statements/proved_statements.hpp"
#include "figure/k_dop/sets.hpp"
#include "plumb/certify/judged_proofs.hpp"
#include "plumb/degenerate/points.hpp"

namespace plumb::figure {
namespace {

/// Has some point slack in all halfspaces of both?
template <class Vector>
bool has_inner_point(const KDop<Vector>& a, const KDop<Vector>& b) {
  arith::Constraints both = halfspaces(a);
  const arith::Constraints of_b = halfspaces(b);
  both.rows.insert(both.rows.end(), of_b.rows.begin(), of_b.rows.end());
  both.limits.insert(both.limits.end(), of_b.limits.begin(), of_b.limits.end());
  return arith::feasible(both, std::vector<bool>(both.rows.size(), true)).slack > 0;
}

/// Around eight points within a cube of side 0.8, somewhere in a larger one.
KDop3 any_k_dop(Entropy& entropy, int k) {
  const auto number = [&](double most) { return most * static_cast<double>(entropy.bits(53)) * 0x1p-53; };
  const Point3 p{number(1), number(1), number(1)};
  std::vector<Point3> points;
  for (int i = 0; i < 8; ++i) points.push_back({p.x + number(0.8), p.y + number(0.8), p.z + number(0.8)});
  return fit_k_dop(points, k);
}

TEST(InnerPoint, IsFoundInMostThatHaveOne) {
  for (const auto& [k, promised] : std::map<int, int>{{6, 1000}, {8, 990}, {14, 990}, {18, 980}, {26, 940}}) {
    int some = 0, found = 0;
    for (std::uint64_t i = 0; some < 300; ++i) {
      Entropy entropy(61, i);
      const KDop3 a = any_k_dop(entropy, k), b = any_k_dop(entropy, k);
      if (!intervals_overlap(a, b) || !has_inner_point(a, b)) continue;
      ++some, found += CommonSlabs(a, b).have_inner_point() ? 1 : 0;
    }
    std::printf("k = %d: found in %d of %d\n", k, found, some);
    EXPECT_GE(found * 1000, promised * some) << k;
  }
}

// Around points of every family, or with any ends: flat ones, empty ones, ones that touch.
TEST(InnerPoint, IsClaimedOnlyWhereThereIsOne) {
  int found = 0, none = 0;
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < 60; ++i) {
      Entropy entropy(62, i);
      std::array<double, 28> x{};
      fill_points(info.family, Degeneracy::coplanar, 3, std::span(x).first(27), entropy);
      x[27] = x[0];
      const Directions3 directions = k_dop_directions(entropy.coin() ? 14 : 8);
      const auto around = [&](std::size_t first) {
        std::vector<Point3> points;
        for (std::size_t k = first; k < first + 5; ++k) points.push_back({x[3 * k], x[3 * k + 1], x[3 * k + 2]});
        return fit_k_dop(points, directions);
      };
      KDop3 a{directions, {}, {}}, b = a;
      try {
        if (entropy.coin()) a = around(0), b = around(4);
      } catch (const BeyondDoubles&) {  // sums of the largest numbers are none
        a.min.clear(), a.max.clear();
      }
      std::size_t at = 0;
      for (KDop3* one : {&a, &b}) {
        for (std::size_t j = one->min.size(); j < directions.size(); ++j, at += 2) {
          const double first = x[at % 28], second = entropy.below(8) == 0 ? first : x[(at + 1) % 28];
          one->min.push_back(std::fmin(first, second)), one->max.push_back(std::fmax(first, second));
        }
      }
      const bool truth = has_inner_point(a, b), claimed = CommonSlabs(a, b).have_inner_point();
      EXPECT_TRUE(truth || !claimed) << info.name << ", Entropy(62, " << i << ")";
      found += claimed ? 1 : 0, none += truth ? 0 : 1;
    }
  }
  std::printf("claimed of %d; %d have none\n", found, none);
  EXPECT_GE(found, 50);
  EXPECT_GE(none, 100);
}

TEST(InnerPoint, DirectionsOfYourOwn) {
  const Directions2 skew({{3, 1}, {1, 3}, {1, -1}});
  EXPECT_TRUE(CommonSlabs(KDop2{skew, {0, 0, -1}, {9, 9, 1}}, KDop2{skew, {8, 0, -1}, {12, 9, 1}}).have_inner_point());
  const KDop2 touches{skew, {4, 4, -9}, {4, 5, 9}};
  EXPECT_FALSE(CommonSlabs(touches, touches).have_inner_point());
  // Numbers whose products are beyond all doubles are left to others.
  const Directions2 huge({{0x1p1000, 0}, {0, 0x1p1000}});
  const KDop2 far{huge, {0x1p1000, 0x1p1000}, {0x1p1001, 0x1p1001}};
  EXPECT_FALSE(CommonSlabs(far, far).have_inner_point());
  EXPECT_EQ(relate(far, far), Relation::overlapping);
  // One slab alone.
  const Directions3 one({{1, 2, 3}});
  EXPECT_TRUE(CommonSlabs(KDop3{one, {0}, {2}}, KDop3{one, {1}, {3}}).have_inner_point());
}

std::optional<bool> told(auto world, const auto& d, double min, double max, const auto& p) {
  const bool inside = InsideSlab{}(world, d, min, max, p);
  return world.certain() ? std::optional(inside) : std::nullopt;
}

/// Every third point is on the side or off it by ulps.
template <std::size_t n>
void expect_told_by_every_world(const char* name, PromisedShare& share) {
  for (const FamilyInfo& info : families) {
    int by_integers = 0, inside = 0;
    for (std::uint64_t i = 0; i < 300; ++i) {
      Entropy entropy(63, i);
      std::array<double, 9> x{};
      fill_points(info.family, Degeneracy::coplanar, 3, x, entropy);
      std::array<double, n> d{}, p{};
      double along = 0;
      for (std::size_t k = 0; k < n; ++k) d[k] = x[k], p[k] = x[3 + k], along += d[k] * p[k];
      const double end = entropy.below(3) == 0 && std::isfinite(along) ? along : x[6];
      const double min = std::fmin(end, x[7]), max = std::fmax(end, x[7]);
      const bool truth = *told(RationalWorld(), d, min, max, p);
      const auto floats = told(FloatWorld<InsideSlab>(), d, min, max, p),
                 integers = told(IntegerWorld(), d, min, max, p);
      EXPECT_EQ(floats.value_or(truth), truth) << info.name << ", Entropy(63, " << i << ")";
      EXPECT_EQ(integers.value_or(truth), truth) << info.name << ", Entropy(63, " << i << ")";
      share.add(info.family, floats.has_value());
      by_integers += integers ? 1 : 0, inside += truth ? 1 : 0;
    }
    std::printf("%s, %s: of 300 integers tell %d; %d inside\n", name, info.name.data(), by_integers, inside);
  }
}
TEST(InnerPoint, EveryWorldSaysTheSameOfASlab) {
  PromisedShare in_space("inside_slab"), in_the_plane("inside_slab_2d");
  expect_told_by_every_world<3>("in space", in_space);
  expect_told_by_every_world<2>("in the plane", in_the_plane);
}

template <class... Input>
void expect_bounds(const char* name, const Input&... input) {
  const std::vector<std::string> bounds = judged_bounds(InsideSlab{}, input...);
  expect_golden(name, bounds);
  expect_proved(bounds, judged_proofs(name, InsideSlab{}, input...));
}
TEST(InnerPoint, DerivedBoundsAreAsRecordedAndProved) {
  expect_bounds("inside_slab", std::array{1.0, 1.0, -1.0}, 0.0, 3.0, std::array{1.0, 2.0, 2.0});
  expect_bounds("inside_slab_2d", std::array{1.0, -1.0}, 0.0, 3.0, std::array{2.0, 1.0});
}

template <std::size_t n>
std::string unnoticed() {
  struct Drawn {
    std::array<double, n> d, p;
    double min, max;
  };
  return mutants::unnoticed(
      [](mutants::Draw& draw) {
        Drawn x{};
        for (double& one : x.d) one = draw.number();
        for (double& one : x.p) one = draw.number();
        x.min = draw.number(), x.max = x.min + draw.positive();
        return x;
      },
      [](const Drawn& x) { return told(mutants::World(), x.d, x.min, x.max, x.p); },
      [](const Drawn& x) {
        double along = 0;  // of small integers
        for (std::size_t k = 0; k < n; ++k) along += x.d[k] * x.p[k];
        return x.min < along && along < x.max;
      });
}
TEST(InnerPoint, MutantsAreNoticed) {
  mutants::expect_noticed("inside_slab", unnoticed<3>());
  mutants::expect_noticed("inside_slab_2d", unnoticed<2>());
}

}  // namespace
}  // namespace plumb::figure
