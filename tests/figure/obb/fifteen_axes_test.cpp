// Which world answers?  The fifteen axes of oriented boxes over doubles and over exact numbers, on every family of
// inputs, and on boxes that turn together.
#include "figure/obb/fifteen_axes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "certify/exact_axes.hpp"
#include "certify/statements/golden_statements.hpp"
#include "certify/statements/mutant_statements.hpp"
#include "certify/statements/promised_share.hpp"
#include "certify/statements/proved_statements.hpp"
#include "certify/written_axes.hpp"
#include "counted_allocations.hpp"
#include "figure/minkowski/zonotope.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/stack_dyadic.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/figure/obb/obb.hpp"
#include "plumb/query/overlap/overlap.hpp"

namespace plumb {
namespace {

namespace axes = figure::fifteen_axes::HWY_NAMESPACE;
namespace lanes = certify::three_lanes::HWY_NAMESPACE;
using Integers = certify::exact_axes::ExactAxes<StackDyadic, WorldKind::integers>;
using Rationals = certify::exact_axes::ExactAxes<BigDyadic, WorldKind::rationals>;

struct Answers {
  std::optional<Relation> floats, lattice, pairs, integers, exact;
};
template <class Statement, Precision precision>
using World = lanes::Floats<lanes::Three, Statement::highest, Statement::scales, NoBoundListener, precision>;
template <class Statement, class... Boxes>
Answers ask(const Statement& statement, const Boxes&... boxes) {
  return {lanes::told_by_worlds<World<Statement, Precision::doubles>>(NoWorldRecorder{}, statement, boxes...),
          lanes::told_by_worlds<World<Statement, Precision::lattice>>(NoWorldRecorder{}, statement, boxes...),
          lanes::told_by_worlds<World<Statement, Precision::pairs>>(NoWorldRecorder{}, statement, boxes...),
          lanes::told_by_worlds<Integers>(NoWorldRecorder{}, statement, boxes...),
          lanes::told_by_worlds<Rationals>(NoWorldRecorder{}, statement, boxes...)};
}

BigVector big(const Vector3& v, double times = 1) {
  return {BigDyadic(v.x) * BigDyadic(times), BigDyadic(v.y) * BigDyadic(times), BigDyadic(v.z) * BigDyadic(times)};
}
/// By the boxes' difference, a zonotope of six generators: another statement of it, over integers.
Relation located(const Obb3& a, const Obb3& b) {
  const auto between = [](double from, double to) { return BigDyadic(to) - BigDyadic(from); };
  return locate_origin(
      BigVector{between(a.center.x, b.center.x), between(a.center.y, b.center.y), between(a.center.z, b.center.z)},
      std::array{big(a.axes[0], a.half.x), big(a.axes[1], a.half.y), big(a.axes[2], a.half.z), big(b.axes[0], b.half.x),
                 big(b.axes[1], b.half.y), big(b.axes[2], b.half.z)});
}

Vector3 vector(const double* x) { return {x[0], x[1], x[2]}; }
/// Of 15 numbers; as a rule a parallelepiped that is no box.
Obb3 box_of(const double* x) {
  return {{x[0], x[1], x[2]}, {vector(x + 3), vector(x + 6), vector(x + 9)}, vector(x + 12)};
}
struct Tally {
  int floats = 0, lattice = 0, pairs = 0, integers = 0, exact = 0;
  std::array<int, 3> of{};

  void add(const Answers& answers, Relation truth, std::string_view name, std::uint64_t i) {
    floats += answers.floats.has_value(), exact += answers.exact.has_value();
    lattice += answers.lattice.has_value(), pairs += answers.pairs.has_value();
    integers += answers.integers.has_value();
    ++of[static_cast<std::size_t>(static_cast<int>(truth) + 1)];
    for (const auto& told : {answers.floats, answers.lattice, answers.pairs, answers.integers, answers.exact})
      ASSERT_TRUE(!told || told == truth) << name << ", replay: " << i;
  }
};

template <class Statement, class... Boxes>
void expect_bounds(const char* name, const Statement& statement, const Boxes&... boxes) {
  lanes::Floats<lanes::Three, Statement::highest, Statement::scales, BoundListener> world;
  BoundListener::taken();
  static_cast<void>(statement(world, boxes...));
  const std::vector<std::string> bounds = BoundListener::taken();
  expect_golden(name, bounds);
  expect_proved(bounds, certify::written::axes_proofs(name, statement, boxes...));
  lanes::Floats<lanes::Three, Statement::highest, Statement::scales, BoundListener, Precision::pairs> of_pairs;
  static_cast<void>(statement(of_pairs, boxes...));
  expect_golden(name + std::string("_pairs"));
}
TEST(FifteenAxes, DerivedBoundsAreAsRecordedAndProved) {
  // Apart along no axis until all are looked at: no center lies in the other box.
  const Obb3 a{{0, 0, 0}, {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}, {1, 1, 1}};
  const Obb3 b{{1.5, 0.25, 0}, {Vector3{0.6, 0.7, 0.1}, Vector3{-0.7, 0.6, 0.2}, Vector3{0.1, 0.3, 0.9}}, {1, 2, 1}};
  expect_bounds("obb_obb", axes::ObbPair{}, a, b);
  expect_bounds("box_obb", axes::BoxAndObb{}, Aabb3{{-1, -1, -1}, {1, 1, 1}}, b);
}

// Random vectors are no axes that a box has, and their products of nine factors are beyond the doubles in the families
// of wide exponents.
TEST(FifteenAxes, EveryWorldGivesTheRelationAndDoublesTheirShare) {
  PromisedShare of_both("obb_obb"), of_both_in_pairs("obb_obb_pairs");
  PromisedShare of_one("box_obb"), of_one_in_pairs("box_obb_pairs");
  for (const FamilyInfo& info : families) {
    Tally pairs, mixed;
    for (std::uint64_t i = 0; i < 400; ++i) {
      Entropy entropy(18, i);
      std::array<double, 30> x{};
      fill_points(info.family, Degeneracy::coplanar, 3, x, entropy);
      const Obb3 a = box_of(x.data()), b = box_of(x.data() + 15);
      const Aabb3 c{{std::min(x[0], x[3]), std::min(x[1], x[4]), std::min(x[2], x[5])},
                    {std::max(x[0], x[3]), std::max(x[1], x[4]), std::max(x[2], x[5])}};
      pairs.add(ask(axes::ObbPair{}, a, b), located(a, b), info.name, i);
      mixed.add(ask(axes::BoxAndObb{}, c, b), relate(c, b), info.name, i);
      ASSERT_FALSE(testing::Test::HasFatalFailure());
    }
    of_both.add(info.family, pairs.floats, 400), of_both_in_pairs.add(info.family, pairs.pairs, 400);
    of_one.add(info.family, mixed.floats, 400), of_one_in_pairs.add(info.family, mixed.pairs, 400);
    const bool is_short = info.family != Family::extreme && info.family != Family::mixture &&
                          info.family != Family::repeated && info.family != Family::wide;
    if (is_short) {
      EXPECT_GE(pairs.integers, pairs.exact - 4) << info.name;
      EXPECT_GE(mixed.integers, mixed.exact - 4) << info.name;
    }
    // The rest have a first box whose axes lie in a plane.
    EXPECT_GE(pairs.exact, 270) << info.name;
    EXPECT_EQ(mixed.exact, 400) << info.name;
  }
}

TEST(FifteenAxes, TurnedBoxesAreAnsweredByDoublesUnlessTheirEdgesAreParallel) {
  std::array<Tally, 2> tallies;  // turned each by itself, and together
  for (std::uint64_t i = 0; i < 400; ++i) {
    Entropy e(19, i);
    const auto number = [&] { return static_cast<double>(e.within(1 << 20)) * 0x1p-20; };
    const auto turn = [&](double w) {
      const double x = number(), y = number(), z = number(), k = 2 / (w * w + x * x + y * y + z * z);
      return std::array{Vector3{1 - k * (y * y + z * z), k * (x * y + z * w), k * (x * z - y * w)},
                        Vector3{k * (x * y - z * w), 1 - k * (x * x + z * z), k * (y * z + x * w)},
                        Vector3{k * (x * z + y * w), k * (y * z - x * w), 1 - k * (x * x + y * y)}};
    };
    const auto half = [&] { return Vector3{0.3 + number() / 8, 0.4 + number() / 8, 0.3 + number() / 4}; };
    const auto first = turn(0.5), second = turn(0.5);
    const Obb3 a{{2 * number(), number(), number()}, first, half()};
    for (const bool together : {false, true}) {
      const Obb3 b{{2 * number(), number(), number()}, together ? first : second, half()};
      tallies[together].add(ask(axes::ObbPair{}, a, b), relate(a, b), together ? "together" : "by itself", i);
      ASSERT_FALSE(testing::Test::HasFatalFailure());
    }
  }
  EXPECT_EQ(tallies[0].floats, 400);
  EXPECT_GE(tallies[1].floats, 360);
  for (const Tally& t : tallies) EXPECT_GT(std::min(t.of[0], t.of[2]), 30);
}

/// The hard classes of the charts: stacked, aligned, nearly parallel; with boxes that are flat, segments and points.
Obb3 aligned(Entropy& e) {
  Obb3 box{};
  const std::size_t turn = e.below(3);
  const auto at = [&] { return static_cast<double>(e.within(4)); };
  const auto half = [&] { return static_cast<double>(e.below(4)); };
  for (std::size_t k = 0; k < 3; ++k) (&box.axes[k].x)[(k + turn) % 3] = e.coin() ? 1 : -1;
  box.center = {at(), at(), at()}, box.half = {half(), half(), half()};
  return box;
}
TEST(FifteenAxes, StackedAlignedAndNearlyParallelBoxesAreAnsweredWithoutAllocation) {
  std::array<Tally, 5> tallies;
  constexpr std::array names{"stacked", "aligned", "nearly parallel", "skew integers", "a plane of axes"};
  for (std::uint64_t i = 0; i < 600; ++i) {
    for (std::size_t kind = 0; kind < tallies.size(); ++kind) {
      Entropy e(23 + kind, i);
      const auto number = [&] { return static_cast<double>(e.within(std::int64_t{1} << 52)) * 0x1p-52; };
      Obb3 a = aligned(e), b = aligned(e);
      if (kind == 0) {
        const double w = number(), x = number(), y = number(), z = number(), k = 2 / (w * w + x * x + y * y + z * z);
        a.axes = b.axes = {Vector3{1 - k * (y * y + z * z), k * (x * y + z * w), k * (x * z - y * w)},
                           Vector3{k * (x * y - z * w), 1 - k * (x * x + z * z), k * (y * z + x * w)},
                           Vector3{k * (x * z + y * w), k * (y * z - x * w), 1 - k * (x * x + y * y)}};
        a.half = {0.1 + number() / 16, 0.3 + number() / 4, 0.5}, b.half = {0.5 + number() / 4, 0.3, 0.2};
        const std::size_t axis = e.below(3);
        const double reach = (&a.half.x)[axis] + (&b.half.x)[axis];
        const Vector3 u = a.axes[axis];
        a.center = {number(), number(), number()};
        b.center = {a.center.x + u.x * reach, a.center.y + u.y * reach, a.center.z + u.z * reach};
      } else if (kind == 2) {
        (&b.axes[e.below(3)].x)[e.below(3)] += static_cast<double>(e.within(8)) * 0x1p-53;
      } else if (kind > 2) {
        const auto small = [&] { return static_cast<double>(e.within(2)); };
        for (Obb3* box : {&a, &b}) {
          for (Vector3& v : box->axes) v = {small(), small(), small()};
        }
        if (kind == 4) a.axes[2] = a.axes[e.below(2)];
      }
      tallies[kind].add(ask(axes::ObbPair{}, a, b), located(a, b), names[kind], i);
      const int before = allocations;
      const Relation relation = relate(a, b);
      if (kind < 3) {
        ASSERT_EQ(allocations, before) << names[kind] << ", replay: " << i;
      }
      ASSERT_EQ(relation, located(a, b)) << names[kind] << ", replay: " << i;
      ASSERT_FALSE(testing::Test::HasFatalFailure());
    }
  }
  EXPECT_GT(allocations, 1000);  // of the other statements
  const auto& [stacked, whole, nearly, skew, plane] = tallies;
  EXPECT_EQ(stacked.pairs, 600);
  EXPECT_LT(stacked.floats, 60);
  EXPECT_EQ(whole.lattice, 600);
  EXPECT_GE(nearly.pairs, 540);
  EXPECT_GE(skew.lattice, 530);  // the rest have axes in a plane
  for (const Tally& t : tallies) {
    EXPECT_GE(t.pairs, t.floats);
    EXPECT_EQ(t.integers, t.exact);
    EXPECT_GT(std::min(t.of[0], t.of[2]), 30);
  }
  EXPECT_EQ(nearly.exact, 600);
  EXPECT_EQ(plane.exact, plane.lattice);
}

TEST(FifteenAxes, MutantsAreNoticed) {
  const auto unnoticed = [](const auto& statement, const auto& first, int from) {
    return mutants::unnoticed(
        [&](mutants::Draw& d) {
          return std::pair{first(d), d.turned_box()};
        },
        [&](const auto& input) { return mutants::told<mutants::Axes>(statement, input.first, input.second); },
        [](const auto& input) { return relate(input.first, input.second); }, from);
  };
  // The first look is left out, whose reach may be too far.  Not noticed is a way along an axis without its magnitude, of which exact numbers ask only whether it is zero.
  const auto turned = [](mutants::Draw& d) { return d.turned_box(); };
  mutants::expect_noticed("obb_obb", unnoticed(axes::ObbPair{}, turned, 21), "69 ");
  const auto box = [](mutants::Draw& d) { return d.box(); };
  mutants::expect_noticed("box_obb", unnoticed(axes::BoxAndObb{}, box, 0), "17 ");
}

}  // namespace
}  // namespace plumb
