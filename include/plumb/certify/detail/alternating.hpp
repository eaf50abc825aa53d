// What may be done with the arguments of a formula that every swap of two of them turns into its opposite?
//
// Laws: with two equal arguments its value is zero; swapping the last argument with another flips its sign.  That a
// formula is one is said here; tests/certify/alternating_test.cpp proves it, as an identity of polynomials.
// Source: docs/proof.md, "Alternating formulas".
// Cost: a comparison for each pair of arguments.
#pragma once

#include <array>
#include <cstddef>

#include "plumb/arith/sign.hpp"
#include "plumb/certify/formula.hpp"
#include "plumb/predicates/manifest.hpp"

namespace plumb {

/// Does every swap of two arguments flip the sign?
template <Formula F>
inline constexpr bool is_alternating = false;
template <>
inline constexpr bool is_alternating<predicates::Orient2d> = true;
template <>
inline constexpr bool is_alternating<predicates::Orient3d> = true;
template <>
inline constexpr bool is_alternating<predicates::InCircle> = true;
template <>
inline constexpr bool is_alternating<predicates::InSphere> = true;

namespace certify {

/// Are two arguments before the last one equal?  (One that is equal to the last leaves only differences that are zero.)
template <Formula F>
constexpr bool repeats_argument(const Coordinates<F>& p) {
  constexpr auto size = static_cast<std::size_t>(F::dimension), last = arity<F> - size;
  bool repeats = false;
  for (std::size_t i = 0; i < last; i += size) {
    for (std::size_t k = 0; k < i; k += size) {
      bool equal = true;
      for (std::size_t axis = 0; axis < size; ++axis) equal = equal && p[i + axis] == p[k + axis];
      repeats = repeats || equal;
    }
  }
  return repeats;
}

/// The coordinates with the argument last whose largest coordinate is the least, and what that does to the sign.
/// Differences from it are hardly rounded; as seen from one that is far away, all others look like one.
template <Formula F>
struct LeastLast {
  Coordinates<F> at;
  Sign parity = Sign::positive;

  explicit LeastLast(const Coordinates<F>& p) : at(p) {
    constexpr auto size = static_cast<std::size_t>(F::dimension), last = arity<F> - size;
    std::size_t least = last;
    double of_least = largest(p, last);
    for (std::size_t i = 0; i < last; i += size) {
      const double of_this = largest(p, i);
      least = of_this < of_least ? i : least;
      of_least = of_this < of_least ? of_this : of_least;
    }
    if (least == last) return;
    for (std::size_t axis = 0; axis < size; ++axis) {
      const double kept = at[last + axis];
      at[last + axis] = at[least + axis];
      at[least + axis] = kept;
    }
    parity = Sign::negative;
  }

 private:
  static double largest(const Coordinates<F>& p, std::size_t first) {
    double most = 0;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(F::dimension); ++axis) {
      const double size = p[first + axis] < 0 ? -p[first + axis] : p[first + axis];
      most = size > most ? size : most;
    }
    return most;
  }
};

}  // namespace certify
}  // namespace plumb
