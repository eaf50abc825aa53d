// Floating-point filter: does plain floating point prove the sign?  The two derived filters.
//
// Laws: a certain answer is the sign of the exact value, for any doubles at all (NaN, infinity, overflow and underflow
// end as unsure); zero is never certain here.  No branch on the sign forms the answer: signs cannot be
// predicted.
// Source: RTCD 11.2, docs/proof.md.
// Cost: 1.5 to 2 times the plain formula.
#pragma once

#include <bit>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

#include "plumb/arith/filtered.hpp"
#include "plumb/arith/largest.hpp"
#include "plumb/certify/formula.hpp"

namespace plumb {

/// -1, 0 or 1, where 0 is 'unsure': the form in which the hot path uses a filter.
template <class Value>
constexpr int beyond(Value value, Value threshold) {
  return static_cast<int>(value > threshold) - static_cast<int>(value < -threshold);
}

/// Filter A: against the sum of the absolute products.
template <Formula F, class Input = double>
constexpr int magnitude_filter(const std::array<Input, arity<F>>& p) {
  const Filtered r = evaluate<F>([&](std::size_t i) { return Filtered::Input{p[i]}; });
  return beyond(r.value, filter_constant<F>() * r.magnitude);
}

template <Formula F>
using Largest = std::array<double, static_cast<std::size_t>(F::dimension)>;

template <Formula F, class Make>
constexpr Largest<F> per_axis(Make make) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) { return Largest<F>{make(I)...}; }
  (std::make_index_sequence<static_cast<std::size_t>(F::dimension)>{});
}

/// Where the largest differences start: the least power of two whose power in the formula's degree is no less than the
/// guard of filter A.
template <Formula F>
inline constexpr double largest_floor = [] {
  double x = 1, power = 1;
  while (power >= underflow_guard) {
    x /= 2;
    power = 1;
    for (int i = 0; i < degree<F>(); ++i) power *= x;
  }
  return 2 * x;
}();

template <Formula F>
constexpr std::size_t axis_of_input(std::size_t i) {
  return i % static_cast<std::size_t>(F::dimension);
}

/// x, of which the optimizer forgets how it came about.  GCC otherwise finds that the square of a maximum is the square
/// of one of its arguments, which it has already, and branches on an unpredictable comparison to save one product.
constexpr double opaque(double x) {
  if (!std::is_constant_evaluated()) {
#if defined(__SSE2__)
    __asm__("" : "+x"(x));
#elif defined(__aarch64__)
    __asm__("" : "+w"(x));
#endif
  }
  return x;
}

/// The largest difference (or sum, or coordinate by itself) that the formula forms in each axis; of doubles, or of
/// numbers that differ in doubles.
template <Formula F, class Input = double>
constexpr Largest<F> largest_differences(const std::array<Input, arity<F>>& p) {
  Largest<F> largest = per_axis<F>([](std::size_t) { return largest_floor<F>; });
  const auto raise = [&](std::size_t axis, double x) {
    const double m = magnitude_of(x);
    largest[axis] = m > largest[axis] ? m : largest[axis];  // a NaN is not kept: it ends in the value
  };
  const auto look_at = [&]<std::size_t I>() {
    constexpr certify::tape::Instruction i = certify::tape::of<F>.instructions[I];
    constexpr bool left = i.left < arity<F>, right = i.right < arity<F>;
    if constexpr (left && right && i.operation != '*') {
      raise(axis_of_input<F>(i.left), i.operation == '-' ? p[i.left] - p[i.right] : p[i.left] + p[i.right]);
    } else {
      if constexpr (left) raise(axis_of_input<F>(i.left), p[i.left]);
      if constexpr (right) raise(axis_of_input<F>(i.right), p[i.right]);
    }
  };
  // A list, not a fold: Clang nests folds and stops at 256.
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    [[maybe_unused]] const bool in_turn[]{(look_at.template operator()<I>(), true)...};
  }
  (std::make_index_sequence<certify::tape::of<F>.size>{});
  return per_axis<F>([&](std::size_t axis) { return opaque(largest[axis]); });
}

template <Formula F>
inline constexpr auto axis_degrees = [] {
  using Degrees = AxisDegrees<static_cast<std::size_t>(F::dimension)>;
  return Degrees(evaluate<F>([](std::size_t i) { return typename Degrees::Input{axis_of_input<F>(i)}; }));
}();

template <Formula F>
constexpr double magnitude_over(const Largest<F>& largest) {
  return LargestMagnitude(
             evaluate<F>([&](std::size_t i) { return LargestMagnitude::Input{largest[axis_of_input<F>(i)]}; }))
      .magnitude;
}

template <int N>
constexpr double power(double x) {
  if constexpr (N == 0) {
    return 1;
  } else {
    return x * power<N - 1>(x);
  }
}

/// The threshold of filter B for differences up to these bounds, one for each axis, none below largest_floor; for a
/// value that is finite.
template <Formula F>
constexpr double largest_threshold(const Largest<F>& largest) {
  if constexpr (axis_degrees<F>.equal_terms) {
    // The terms differ in nothing but their roundings, which are paid for twice over: one for each operation, and those
    // of this product.
    constexpr double terms = magnitude_over<F>(per_axis<F>([](std::size_t) { return 1.0; }));
    constexpr double slack = 1 + static_cast<double>(certify::tape::of<F>.size + degree<F>() + 4) * 0x1p-52;
    const double product = [&]<std::size_t... I>(std::index_sequence<I...>) {
      return (power<axis_degrees<F>.degree[I]>(largest[I]) * ...);
    }
    (std::make_index_sequence<std::tuple_size_v<Largest<F>>>{});
    return filter_constant<F>() * terms * slack * product;
  } else {
    return filter_constant<F>() * magnitude_over<F>(largest);
  }
}

/// Filter B: against the magnitude that the largest differences allow.
template <Formula F, class Input = double>
constexpr int largest_filter(const std::array<Input, arity<F>>& p) {
  const double value = value_of<F>(p);
  // value - value is NaN, and so nothing is beyond, where an intermediate product overflowed though no threshold did.
  return beyond(value, largest_threshold<F>(largest_differences<F>(p)) + (value - value));
}

/// Which filter the chain uses: the cheaper one by measurement (docs/measurements.md, "Stages").
template <Formula F>
inline constexpr bool filter_is_magnitude = [] {
  if constexpr (TakesPoints<F> && is_homogeneous<F>) {
    return degree<F>() < 3;
  } else {
    return true;  // the largest differences are those of axes and one degree
  }
}();

/// What the magnitude of the value must exceed for its sign to be certain, by that filter; `value` is the formula's at p,
/// which the caller has computed.  Where it overflowed or is NaN no threshold can be trusted: this one is then NaN or
/// infinite, which no magnitude exceeds.
template <Formula F, class Input = double>
constexpr double filter_threshold(const std::array<Input, arity<F>>& p, [[maybe_unused]] double value) {
  if constexpr (filter_is_magnitude<F>) {
    const Filtered r = evaluate<F>([&](std::size_t i) { return Filtered::Input{p[i]}; });
    return filter_constant<F>() * r.magnitude;
  } else {
    return largest_threshold<F>(largest_differences<F>(p)) + (value - value);  // as in largest_filter
  }
}

/// 1 or -1 of what is beyond a threshold: its sign bit, which takes one comparison less than the two of `beyond`.
constexpr int sign_bit_of(double x) { return static_cast<int>(std::bit_cast<std::int64_t>(x) >> 63 | 1); }

template <Formula F, class Input = double>
constexpr int filter(const std::array<Input, arity<F>>& p) {
  const double value = value_of<F>(p);
  return magnitude_of(value) > filter_threshold<F>(p, value) ? sign_bit_of(value) : 0;
}

}  // namespace plumb
