// How near can what lies in two boxes be?  Squares of distances, rounded down; and the square of a distance that is known,
// rounded up.
//
// Laws: (1) square_below is at most the square of the distance of any two points of the boxes.  (2) square_above is at
// least the square of every distance that rounds to d, square_above_exact at least that of d itself.  (3) So what is
// left out because square_below exceeds square_above is farther.
// Rounding keeps order, so what rounds to x is not below the double before x, nor above the one after it: each operation
// is followed by that step, whether it rounded or not; also where it overflows or underflows.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include "plumb/arith/interval.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/space/bvh/box_tree.hpp"

namespace plumb::space {

/// The double before, of what is positive; 0 of all else.
inline double step_below(double x) {
  const double y = x > 0 ? x : 0;
  return std::bit_cast<double>(std::bit_cast<std::int64_t>(y) - static_cast<std::int64_t>(y > 0));
}
/// The double after, of what is not negative; infinity stays.
inline double step_above(double x) {
  return std::bit_cast<double>(std::bit_cast<std::int64_t>(x) +
                               static_cast<std::int64_t>(x < std::numeric_limits<double>::infinity()));
}

/// Of an axis: [low, high] and [from, to].
inline double gap_square_below(double low, double high, double from, double to) {
  const double gap = step_below(std::max(from - high, low - to));
  return step_below(gap * gap);
}
inline double sum_below(double x, double y, double z) { return step_below(step_below(x + y) + z); }

/// Of floats in one frame.
template <class BoxA, class BoxB>
double square_below(const BoxA& a, const BoxB& b) {
  const auto axis = [&](std::size_t k) {
    return gap_square_below(static_cast<double>(a.min[k]), static_cast<double>(a.max[k]), static_cast<double>(b.min[k]),
                            static_cast<double>(b.max[k]));
  };
  return sum_below(axis(0), axis(1), axis(2));
}
inline double square_below(const Aabb3& a, const Aabb3& b) {
  return sum_below(gap_square_below(a.min.x, a.max.x, b.min.x, b.max.x),
                   gap_square_below(a.min.y, a.max.y, b.min.y, b.max.y),
                   gap_square_below(a.min.z, a.max.z, b.min.z, b.max.z));
}

/// The same, exact where doubles hold what comes between; slower.
inline double exact_square_below(const Aabb3& a, const Aabb3& b) {
  const auto axis = [](double low, double high, double from, double to) {
    const Interval gap = from > high ? Interval(from) - Interval(high)
                         : low > to  ? Interval(low) - Interval(to)
                                     : Interval(0);
    return gap * gap;
  };
  return (axis(a.min.x, a.max.x, b.min.x, b.max.x) + axis(a.min.y, a.max.y, b.min.y, b.max.y) +
          axis(a.min.z, a.max.z, b.min.z, b.max.z))
      .lower;
}

/// In doubles as they are, and in the numbers of a frame.
inline double square_above_exact(double d) { return step_above(d * d); }
inline double square_above(double d) { return square_above_exact(step_above(d)); }
inline double square_above_exact(const BoxFrame& frame, double d) {
  return d < std::numeric_limits<double>::infinity() ? square_above_exact(static_cast<double>(frame.above(d))) : d;
}
inline double square_above(const BoxFrame& frame, double d) { return square_above_exact(frame, step_above(d)); }

/// What may be nearer than a distance that is known: nodes by the numbers of the frame, figures by doubles.
struct SquareLimits {
  double of_nodes = std::numeric_limits<double>::infinity(), of_figures = of_nodes;
};
inline SquareLimits limits_above(const BoxFrame& frame, double d) { return {square_above(frame, d), square_above(d)}; }
inline SquareLimits limits_above_exact(const BoxFrame& frame, double d) {
  return {square_above_exact(frame, d), square_above_exact(d)};
}

}  // namespace plumb::space
