// Separating axis test (SAT): which of the fifteen axes of two boxes may be the one along which they overlap least?  A
// statement over any world of numbers.
//
// Along n = u x v, of two of the six axes, the boxes reach sum s |n . w| over the other four, s the lengths; c is the
// way between their middles, everything times two: they overlap by that less |n . c|, over |n|.  Of boxes under poses everything
// is times both weights as well.
// Laws: an axis that is left out is farther, for certain; of boxes that are apart one is farther that has a narrower gap.
// A sign that is not certain is told as zero; over exact numbers all are certain.
// Source: RTCD 4.4.1; Gottschalk, Lin and Manocha 1996.
// Cost: some 60 operations an axis.
#pragma once

#include <concepts>
#include <optional>
#include <span>

#include "plumb/arith/interval.hpp"
#include "plumb/certify/certainly.hpp"
#include "query/body/box_parts.hpp"
#include "query/separation/corners.hpp"

namespace plumb::query::parting {

using arith::Vec;

/// How far boxes overlap, and as a guess its square with its sign.
template <class T>
struct OfOverlap {
  T overlap;
  double value;
};
/// x |x|, which rises with x.
inline Interval signed_square(const Interval& x) {
  const auto of = [](double e) { return Interval(e) * Interval(magnitude_of(e)); };
  return {of(x.lower).lower, of(x.upper).upper};
}

/// Axes 0 to 2 are those of the first box, 3 to 5 of the second.
template <class Box>
struct NearAxesOf {
  static constexpr Scales scales{.count = 2, .maxima = 3};  // lengths; axes and weights
  static constexpr int highest = std::same_as<Box, PosedBox> ? 6 : 12;

  using Pair = std::array<std::uint32_t, 2>;  // whose cross product the axis is along
  struct Told {
    std::uint32_t picked = 0, near = 0;  // `near`, by bits: what may be as near as the one picked, which is one of them
    Sign overlap = Sign::zero, middle = Sign::zero;  // along the one picked: of the first less that of the second
    std::array<Sign, 6> along{};                     // what the axes lead along it
    std::array<Sign, 2> turn{};                      // of each box's three axes
    friend bool operator==(const Told&, const Told&) = default;
  };

  /// Among these, up to fifteen, `pick(overlaps, lengths)` guesses the least, by the overlaps' squares with their sign and
  /// the squares of the normals' lengths, optional numbers all; it may be any.
  template <class W, class Pick>
  Told operator()(W& w, const Box& a, const Box& b, std::span<const Pair> pairs, const Pick& pick) const {
    const auto axis = [&](std::size_t k) {
      const Vector3& v = (k < 3 ? a : b).axes[k % 3];
      return vec_of(w.template number<1>(v.x), w.template number<1>(v.y), w.template number<1>(v.z));
    };
    const std::array g{axis(0), axis(1), axis(2), axis(3), axis(4), axis(5)};
    const auto length = [&](std::size_t k) {
      return k < 3 ? length_beside(w, a.length[k], b) : length_beside(w, b.length[k - 3], a);
    };
    const std::array s{length(0), length(1), length(2), length(3), length(4), length(5)};
    const auto c = middle_difference(w, a, b);
    const auto overlap_along = [&](const Pair& of, const auto& n, const auto& m) {
      const std::array<std::uint8_t, 4>& other = axes_beside[6 * of[0] + of[1]];
      const auto reach = [&](std::size_t k) { return magnitude(tracked_dot(n, g[other[k]])) * s[other[k]]; };
      return ((reach(0) + reach(1)) + (reach(2) + reach(3))) - magnitude(m);
    };
    const auto normal = [&](const Pair& of) { return tracked_cross(g[of[0]], g[of[1]]); };
    // Squares of numbers under poses would be too large: these are compared by what they lie between.
    constexpr bool by_ends = std::same_as<Box, PosedBox> && requires {
      { w.lower(c.x) } -> std::same_as<double>;
    };
    const auto square_along = [&](const Pair& of) {
      const auto n = normal(of);
      const auto overlap = overlap_along(of, n, tracked_dot(n, c));
      if constexpr (by_ends) {
        return OfOverlap<std::remove_cvref_t<decltype(overlap)>>{overlap, overlap.value * magnitude_of(overlap.value)};
      } else {
        return overlap * magnitude(overlap);
      }
    };
    const auto length_of = [&](const Pair& of) {
      const auto n = normal(of);
      return tracked_dot(n, n);
    };
    std::array<std::optional<decltype(square_along(pairs[0]))>, 15> square;
    std::array<std::optional<decltype(length_of(pairs[0]))>, 15> length_square;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      square[i].emplace(square_along(pairs[i])), length_square[i].emplace(length_of(pairs[i]));
    }
    const auto sign = [&](const auto& x) {  // which leaves nothing open where it is not certain
      if constexpr (requires { w.positive(x); }) {
        return static_cast<Sign>(static_cast<int>(w.positive(x)) - static_cast<int>(w.negative(x)));
      } else {
        return w.sign(x);
      }
    };
    Told told;
    told.picked = pick(std::span(square).first(pairs.size()), std::span(length_square).first(pairs.size()));
    const auto& least = *square[told.picked];
    const auto& of_least = *length_square[told.picked];
    if constexpr (by_ends) {
      const auto ends = [&](const auto& x) { return Interval(w.lower(x), w.upper(x)); };
      const Interval square_of_least = signed_square(ends(least.overlap)), length_of_least = ends(of_least);
      for (std::uint32_t i = 0; i < pairs.size(); ++i) {
        const Interval more =
            signed_square(ends(square[i]->overlap)) * length_of_least - square_of_least * ends(*length_square[i]);
        const bool is_farther = i != told.picked && more.sign() == Unsure{Sign::positive};
        told.near |= is_farther ? 0U : 1U << i;
      }
    } else {
      for (std::uint32_t i = 0; i < pairs.size(); ++i) {
        const bool is_farther =
            i != told.picked && sign(*square[i] * of_least - least * *length_square[i]) == Sign::positive;
        told.near |= is_farther ? 0U : 1U << i;
      }
    }
    const auto n = normal(pairs[told.picked]);
    const auto m = tracked_dot(n, c);
    told.middle = sign(m), told.overlap = sign(overlap_along(pairs[told.picked], n, m));
    for (std::uint32_t k = 0; k < 6; ++k) {
      if (k != pairs[told.picked][0] && k != pairs[told.picked][1]) told.along[k] = sign(tracked_dot(n, g[k]));
    }
    // Squares are off by as much as the scales' are, however small they are themselves: where that leaves several, the
    // overlaps are compared by what they lie between; but not along what may be the same axis.
    if constexpr (!by_ends && requires {
                    { w.lower(of_least) } -> std::same_as<double>;
                  }) {
      const auto between = [&](const auto& x) { return Interval(w.lower(x), w.upper(x)); };
      const auto is_above = [](const Interval& x) { return x.sign() == Unsure{Sign::positive}; };
      std::optional<Interval> least_square;
      for (std::uint32_t i = 0; i < pairs.size() && told.overlap == Sign::positive; ++i) {
        const bool may_be_same = told.along[pairs[i][0]] == Sign::zero && told.along[pairs[i][1]] == Sign::zero;
        if (may_be_same || (told.near >> i & 1) == 0) continue;
        if (!least_square) {
          const Interval overlap = between(overlap_along(pairs[told.picked], n, m));
          if (!is_above(overlap)) break;
          least_square = overlap * overlap;
        }
        const auto of_i = normal(pairs[i]);
        const Interval other = between(overlap_along(pairs[i], of_i, tracked_dot(of_i, c)));
        const Interval more = other * other * between(of_least) - *least_square * between(*length_square[i]);
        if (is_above(other) && is_above(more)) told.near ^= 1U << i;
      }
    }
    for (std::size_t body = 0; body < 2; ++body) {
      const auto &u = g[3 * body], &v = g[3 * body + 1], &x = g[3 * body + 2];
      told.turn[body] = sign(tracked_dot(tracked_cross(u, v), x));
    }
    return told;
  }
};
using NearAxes = NearAxesOf<GivenBox>;

}  // namespace plumb::query::parting
