// Which world answers in the plane?  The statements of boxes against segments and triangles, over doubles and over exact
// numbers, on every family of inputs.
#include <gtest/gtest.h>

#include <limits>

#include "certify/exact_axes.hpp"
#include "certify/statements/golden_statements.hpp"
#include "certify/statements/mutant_statements.hpp"
#include "certify/statements/promised_share.hpp"
#include "certify/statements/proved_statements.hpp"
#include "certify/written_axes.hpp"
#include "figure/aabb/axes2.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/stack_dyadic.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/query/overlap/overlap.hpp"

namespace plumb::query {
namespace {

namespace axes2 = figure::box_axes2::HWY_NAMESPACE;
namespace lanes = certify::three_lanes::HWY_NAMESPACE;
using Integers = certify::exact_axes::ExactAxes<StackDyadic, WorldKind::integers>;
using Rationals = certify::exact_axes::ExactAxes<BigDyadic, WorldKind::rationals>;

/// Of doubles, integers and rationals, where they are certain.
template <class Statement, class A>
std::array<std::optional<Relation>, 3> ask(const Statement& statement, const A& a, const Aabb2& box) {
  using Floats = lanes::Floats<lanes::Three, Statement::highest, Statement::scales>;
  return {lanes::told_by_worlds<Floats>(NoWorldRecorder{}, statement, a, box),
          lanes::told_by_worlds<Integers>(NoWorldRecorder{}, statement, a, box),
          lanes::told_by_worlds<Rationals>(NoWorldRecorder{}, statement, a, box)};
}

template <class Statement, class A>
void expect_bounds(const char* name, const Statement& statement, const A& a, const Aabb2& box) {
  lanes::Floats<lanes::Three, Statement::highest, Statement::scales, BoundListener> world;
  BoundListener::taken();
  static_cast<void>(statement(world, a, box));
  const std::vector<std::string> bounds = BoundListener::taken();
  expect_golden(name, bounds);
  expect_proved(bounds, certify::written::axes_proofs(name, statement, a, box));
}
TEST(BoxAxes2, DerivedBoundsAreAsRecordedAndProved) {
  const Aabb2 box{{0, 0}, {1, 1}};
  const Point2 p{0.3, 2}, q{0.2, -1}, r{-1, 0.25};
  expect_bounds("segment_box2", axes2::SegmentAndBox2{}, Segment2{p, q}, box);
  expect_bounds("triangle_box2", axes2::TriangleAndBox2{}, Triangle2{p, q, r}, box);
}

// One box in 67 is empty.
TEST(BoxAxes2, EveryWorldGivesTheRelationAndDoublesTheirShare) {
  std::array<int, 3> relations{};
  std::array shares{PromisedShare("segment_box2"), PromisedShare("triangle_box2")};
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < 1000; ++i) {
      Entropy entropy(28, i);
      std::array<double, 10> x{};
      fill_points(info.family, Degeneracy::collinear, 2, x, entropy);
      const Point2 p{x[0], x[1]}, q{x[2], x[3]}, r{x[4], x[5]};
      // Now and then empty, or flat.
      const Aabb2 box = entropy.below(50) == 0 ? Aabb2{{x[6], x[7]}, {x[8], x[9]}}
                                               : Aabb2{{std::min(x[6], x[8]), std::min(x[7], x[9])},
                                                       {std::max(x[6], x[8]), std::max(x[7], x[9])}};
      const Segment2 s{p, q};
      const Triangle2 t{p, q, r};
      const std::array told{ask(axes2::SegmentAndBox2{}, s, box), ask(axes2::TriangleAndBox2{}, t, box)};
      const std::array truth{relate(s, box), relate(t, box)};
      for (std::size_t k = 0; k < 2; ++k) {
        for (const auto& by : told[k])
          ASSERT_EQ(by.value_or(truth[k]), truth[k]) << info.name << k << ", replay: " << i;
        shares[k].add(info.family, told[k][0].has_value());
        ++relations[static_cast<std::size_t>(static_cast<int>(truth[k]) + 1)];
      }
    }
  }
  EXPECT_GE(relations[0], 2000);
  EXPECT_GE(relations[1], 500);
  EXPECT_GE(relations[2], 2000);
}

TEST(BoxAxes2, WhatIsFlatEqualOrEmptyHasItsRelation) {
  const Aabb2 box{{0, 0}, {2, 1}};
  EXPECT_EQ(relate(Segment2{{1, 0.5}, {1, 0.5}}, box), Relation::overlapping);
  EXPECT_EQ(relate(Segment2{{1, 1}, {1, 1}}, box), Relation::touching);
  EXPECT_EQ(relate(Segment2{{0, 1}, {2, 1}}, box), Relation::touching);
  EXPECT_EQ(relate(Segment2{{-1, 1}, {0, 2}}, box), Relation::disjoint);
  EXPECT_EQ(relate(Segment2{{-1, 0}, {1, 2}}, box), Relation::touching);  // at a corner
  EXPECT_EQ(relate(Triangle2{{1, 0.5}, {1, 0.5}, {1, 0.5}}, box), Relation::overlapping);
  EXPECT_EQ(relate(Triangle2{{-1, 0.5}, {1, 0.5}, {3, 0.5}}, box), Relation::overlapping);
  EXPECT_EQ(relate(Triangle2{{-1, 1}, {1, 1}, {3, 1}}, box), Relation::touching);
  EXPECT_EQ(relate(Triangle2{{-1, 0}, {1, 2}, {-5, 5}}, box), Relation::touching);
  EXPECT_EQ(relate(Triangle2{{-9, -9}, {9, -9}, {0, 9}}, box), Relation::overlapping);
  EXPECT_EQ(relate(Triangle2{{-9, -9}, {9, -9}, {0, 9}}, Aabb2{{1, 0}, {0, 1}}), Relation::disjoint);
  EXPECT_EQ(relate(Segment2{{-9, 0}, {9, 0}}, Aabb2{{1, 0}, {0, 1}}), Relation::disjoint);
}

TEST(BoxAxes2, WhatIsNoNumberThrows) {
  const double none = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double x : {none, infinity, -infinity}) {
    EXPECT_THROW(static_cast<void>(relate(Segment2{{x, 0}, {1, 1}}, Aabb2{{0, 0}, {1, 1}})), NonFinite);
    EXPECT_THROW(static_cast<void>(relate(Segment2{{0, 0}, {1, x}}, Aabb2{{0, 0}, {1, 1}})), NonFinite);
    EXPECT_THROW(static_cast<void>(relate(Segment2{{0, 0}, {1, 1}}, Aabb2{{0, 0}, {x, 1}})), NonFinite);
    EXPECT_THROW(static_cast<void>(relate(Triangle2{{0, 0}, {1, 1}, {x, 5}}, Aabb2{{0, 0}, {1, 1}})), NonFinite);
    EXPECT_THROW(static_cast<void>(relate(Triangle2{{0, x}, {1, 1}, {5, 5}}, Aabb2{{0, 0}, {1, 1}})), NonFinite);
    EXPECT_THROW(static_cast<void>(relate(Triangle2{{0, 0}, {1, 1}, {5, 5}}, Aabb2{{0, x}, {1, 1}})), NonFinite);
  }
}

template <class Statement>
std::string unnoticed_of(const Statement& statement, const auto& drawn) {
  return mutants::unnoticed(
      [&](mutants::Draw& d) {
        const Point2 p{d.number(), d.number()};
        return std::pair{drawn(d), Aabb2{p, {p.x + d.positive(), p.y + d.positive()}}};
      },
      [&](const auto& input) { return mutants::told<mutants::Axes>(statement, input.first, input.second); },
      [](const auto& input) { return relate(input.first, input.second); });
}
TEST(BoxAxes2, MutantsAreNoticed) {
  const auto point = [](mutants::Draw& d) { return Point2{d.number(), d.number()}; };
  const auto segment = [&](mutants::Draw& d) { return Segment2{point(d), point(d)}; };
  const auto triangle = [&](mutants::Draw& d) { return Triangle2{point(d), point(d), point(d)}; };
  mutants::expect_noticed("segment_box2", unnoticed_of(axes2::SegmentAndBox2{}, segment));
  mutants::expect_noticed("triangle_box2", unnoticed_of(axes2::TriangleAndBox2{}, triangle));
}

}  // namespace
}  // namespace plumb::query
