// Which world answers?  The fifteen axes of oriented boxes over doubles and over exact numbers, on every family of
// inputs, and on boxes that turn together.
#include "figure/obb/fifteen_axes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "certify/exact_axes.hpp"
#include "certify/golden_statements.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/figure/obb/obb.hpp"
#include "plumb/query/overlap/box.hpp"

namespace plumb {
namespace {

namespace axes = figure::fifteen_axes::HWY_NAMESPACE;
namespace lanes = certify::three_lanes::HWY_NAMESPACE;
using Rationals = certify::exact_axes::ExactAxes<BigDyadic, WorldKind::rationals>;

struct Answers {
  std::optional<Relation> floats, exact;
};
template <class Statement, class... Boxes>
Answers ask(const Statement& statement, const Boxes&... boxes) {
  using Floats = lanes::Floats<lanes::Three, Statement::highest, Statement::scales>;
  return {lanes::told_by_worlds<Floats>(NoWorldRecorder{}, statement, boxes...),
          lanes::told_by_worlds<Rationals>(NoWorldRecorder{}, statement, boxes...)};
}

Vector3 vector(const double* x) { return {x[0], x[1], x[2]}; }
/// Of 15 numbers; as a rule a parallelepiped that is no box.
Obb3 box_of(const double* x) {
  return {{x[0], x[1], x[2]}, {vector(x + 3), vector(x + 6), vector(x + 9)}, vector(x + 12)};
}
struct Tally {
  int floats = 0, exact = 0;
  std::array<int, 3> of{};

  void add(const Answers& answers, Relation truth, std::string_view name, std::uint64_t i) {
    floats += answers.floats.has_value(), exact += answers.exact.has_value();
    ++of[static_cast<std::size_t>(static_cast<int>(truth) + 1)];
    ASSERT_TRUE(!answers.floats || answers.floats == truth) << name << ", replay: " << i;
    ASSERT_TRUE(!answers.exact || answers.exact == truth) << name << ", replay: " << i;
  }
};

/// How many of 400 the doubles answer, at least: of two boxes, of one and one with the axes of space.  Random vectors are
/// no axes that a box has, and their products of nine factors are beyond the doubles in the families of wide exponents.
constexpr std::array<int, 2> promised(Family family) {
  switch (family) {
    case Family::uniform:
    case Family::float32:
      return {400, 400};
    case Family::grid:
      return {380, 380};
    case Family::near_half:
      return {55, 75};
    case Family::degenerate_short:
      return {325, 375};
    case Family::degenerate_long:
      return {255, 340};
    case Family::off_by_ulps:
      return {295, 370};
    case Family::repeated:
      return {230, 270};
    case Family::wide:
      return {105, 160};
    case Family::extreme:
      return {2, 4};
    case Family::mixture:
      return {100, 150};
  }
  return {};
}

template <class Statement, class... Boxes>
void expect_bounds(const char* name, const Statement& statement, const Boxes&... boxes) {
  lanes::Floats<lanes::Three, Statement::highest, Statement::scales, BoundListener> world;
  BoundListener::taken();
  static_cast<void>(statement(world, boxes...));
  expect_golden(name);
}
TEST(FifteenAxes, DerivedBoundsAreAsRecorded) {
  // Apart along no axis until all are looked at: no center lies in the other box.
  const Obb3 a{{0, 0, 0}, {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}, {1, 1, 1}};
  const Obb3 b{{1.5, 0.25, 0}, {Vector3{0.6, 0.7, 0.1}, Vector3{-0.7, 0.6, 0.2}, Vector3{0.1, 0.3, 0.9}}, {1, 2, 1}};
  expect_bounds("obb_obb", axes::ObbPair{}, a, b);
  expect_bounds("box_obb", axes::BoxAndObb{}, Aabb3{{-1, -1, -1}, {1, 1, 1}}, b);
}

TEST(FifteenAxes, EveryWorldGivesTheRelationAndDoublesTheirShare) {
  for (const FamilyInfo& info : families) {
    Tally pairs, mixed;
    for (std::uint64_t i = 0; i < 400; ++i) {
      Entropy entropy(18, i);
      std::array<double, 30> x{};
      fill_points(info.family, Degeneracy::coplanar, 3, x, entropy);
      const Obb3 a = box_of(x.data()), b = box_of(x.data() + 15);
      const Aabb3 c{{std::min(x[0], x[3]), std::min(x[1], x[4]), std::min(x[2], x[5])},
                    {std::max(x[0], x[3]), std::max(x[1], x[4]), std::max(x[2], x[5])}};
      pairs.add(ask(axes::ObbPair{}, a, b), relate(a, b), info.name, i);
      mixed.add(ask(axes::BoxAndObb{}, c, b), relate(c, b), info.name, i);
      ASSERT_FALSE(testing::Test::HasFatalFailure());
    }
    EXPECT_GE(pairs.floats, promised(info.family)[0]) << info.name;
    EXPECT_GE(mixed.floats, promised(info.family)[1]) << info.name;
    // The rest are flat, or flat and level: the statement knows of none which it is.
    EXPECT_GE(pairs.exact, 270) << info.name;
    EXPECT_GE(mixed.exact, 360) << info.name;
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

}  // namespace
}  // namespace plumb
