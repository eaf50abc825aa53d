// Are the borders of all levels doubles, and is each number in the cell that its comparisons say, in rationals?
#include "plumb/space/octree/cell_frame.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "figure/basic/thrown.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/arith/rational.hpp"
#include "space/octree/scenes.hpp"

namespace plumb {
namespace {

using Doubles = std::numeric_limits<double>;

/// The border as real arithmetic has it: corner + k unit, beyond the doubles too.
template <std::size_t D>
Rational exact_border(const CellFrame<D>& frame, std::size_t axis, std::uint64_t k) {
  // The corner may be beyond the doubles; the border of the middle never is.
  const std::uint64_t middle = (std::uint64_t{CellFrame<D>::last} + 1) / 2;
  for (const std::uint64_t known : {k, middle, std::uint64_t{0}, std::uint64_t{CellFrame<D>::last}}) {
    const double border = frame.border(axis, known);
    if (border - border == 0) {
      return Rational(border) + (Rational(k) - Rational(known)) * Rational(frame.unit());
    }
  }
  ADD_FAILURE() << "no border of this axis is a double";
  return Rational();
}

template <std::size_t D>
void numbers_are_exact(std::uint64_t run) {
  std::size_t on_border = 0, infinite = 0;
  scenes::on_scenes(run, 40, [&](scenes::Family family, Entropy& e, const std::string& text) {
    const auto boxes = scenes::boxes_of<D>(family, 2, e);
    const CellFrame<D> frame(boxes[0]);
    EXPECT_TRUE(frame.holds(boxes[0].min) && frame.holds(boxes[0].max)) << text;
    for (const auto& p : {boxes[0].min, boxes[0].max, boxes[1].min}) {
      const auto x = coordinates(p);
      const auto place = frame.place(p);
      for (std::size_t axis = 0; axis < D; ++axis) {
        const Rational at(x[axis]), below = exact_border(frame, axis, place[axis]),
                                    above = exact_border(frame, axis, place[axis] + std::uint64_t{1});
        EXPECT_TRUE(at < above || place[axis] == frame.last) << text << " axis " << axis;
        EXPECT_TRUE(below <= at || place[axis] == 0) << text << " axis " << axis;
        on_border += at == below ? 1 : 0;
        // What is told of a border is the border.
        const double told = frame.border(axis, place[axis] + std::uint64_t{1});
        infinite += told - told == 0 ? 0 : 1;
        EXPECT_TRUE(told - told == 0 ? Rational(told) == above : above > Rational(Doubles::max())) << text;
      }
    }
  });
  EXPECT_GT(on_border, 30u);
  EXPECT_GT(infinite, 0u);
}

TEST(CellFrame, NumbersAreThoseOfRealArithmetic) {
  numbers_are_exact<2>(711);
  numbers_are_exact<3>(712);
}

template <std::size_t D>
void root_is_least(std::uint64_t run) {
  std::size_t small = 0;
  scenes::on_scenes(run, 20, [&](scenes::Family family, Entropy& e, const std::string& text) {
    const auto box = scenes::boxes_of<D>(family, 1, e)[0];
    const CellFrame<D> frame(box);
    // Of half the side one along some axis would not hold it, or its borders would be no doubles.
    const double unit = frame.unit() / 2;
    const auto low = coordinates(box.min), high = coordinates(box.max);
    bool fits = frame.unit() > Doubles::denorm_min();
    for (std::size_t axis = 0; axis < D; ++axis) {
      if (!fits) break;
      const Rational u(unit), from = (Rational(low[axis]) / u).floor(), to = (Rational(high[axis]) / u).floor();
      fits = to - from <= Rational(frame.last);
      for (const double x : {low[axis], high[axis]}) {
        if (x != 0 && std::ilogb(x) - 51 > std::ilogb(unit)) fits = false;
      }
    }
    EXPECT_FALSE(fits) << text;
    small += frame.unit() == Doubles::denorm_min() ? 1 : 0;
  });
  const typename CellKinds<D>::Box zero{};
  EXPECT_EQ(CellFrame<D>(zero).unit(), Doubles::denorm_min());
}

TEST(CellFrame, TheRootIsTheLeastThatHolds) {
  root_is_least<2>(713);
  root_is_least<3>(714);
}

TEST(CellFrame, NumbersNeverFall) {
  const double most = Doubles::max(), least = Doubles::denorm_min();
  const std::vector<double> ascending{-most,          -1e300, -1, -least, -0.0,  0.0, least,
                                      Doubles::min(), 0.5,    1,  1e10,   1e300, most};
  for (const double low : ascending) {
    for (const double high : ascending) {
      if (low > high) continue;
      const QuadtreeFrame frame(Aabb2{{low, low}, {high, high}});
      std::uint32_t before = 0;
      for (const double x : ascending) {
        const std::uint32_t now = frame.number(0, x);
        EXPECT_LE(before, now) << low << ' ' << high << ' ' << x;
        before = now;
      }
      EXPECT_EQ(frame.number(0, -0.0), frame.number(0, 0.0));
    }
  }
}

TEST(CellFrame, WhatIsNoBoxIsRefused) {
  const double nan = Doubles::quiet_NaN();
  EXPECT_THAT(text_of<NonFinite>([&] {
                (void)OctreeFrame(Aabb3{{0, nan, 0}, {1, 1, 1}});
              }),
              ::testing::HasSubstr("CellFrame: held.min.y is nan"));
  EXPECT_THAT(text_of<InvalidShape>([&] {
                (void)OctreeFrame(Aabb3{{0, 2, 0}, {1, 1, 1}});
              }),
              ::testing::HasSubstr("held is empty"));
}

}  // namespace
}  // namespace plumb
