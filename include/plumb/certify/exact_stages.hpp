// What is the sign when the filter is unsure?  The exact stages, each callable by itself.
//
// Laws: a certain answer is the sign of the exact value; wide_integer_sign is certain up to the widest coordinates of
// wide_bits whose values stay below 1024 bits; big_integer_sign is certain always.  All take finite coordinates only.
// A homogeneous formula keeps its sign when all coordinates are multiplied by 2^-exponent of their lattice, so integers
// may stand for the doubles (docs/proof.md, "Integers").
// Source: RTCD 11.4, 11.5.1; cost: integer_sign 10 to 60 ns, wide_integer_sign 30 to 500 ns, big_integer_sign a
// microsecond or more.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>

#include "plumb/arith/interval.hpp"
#include "plumb/arith/lattice.hpp"
#include "plumb/arith/structural_zero.hpp"
#include "plumb/arith/wide_int.hpp"
#include "plumb/certify/formula.hpp"

namespace plumb {

/// Certain only of zeros that equal inputs force.
template <Formula F>
constexpr Unsure<Sign> structural_zero_sign(const Coordinates<F>& p) {
  const StructuralZero r = evaluate<F>([&](std::size_t i) { return StructuralZero::Input{p[i]}; });
  return r.certain ? Unsure{Sign::zero} : Unsure<Sign>{};
}

template <Formula F>
constexpr Unsure<Sign> interval_sign(const Coordinates<F>& p) {
  return evaluate<F>([&](std::size_t i) { return Interval{p[i]}; }).sign();
}

/// The largest |x| as a bit pattern, whose order is that of the magnitudes; NaN and infinity come last.
template <std::size_t N>
constexpr std::uint64_t largest_pattern(const std::array<double, N>& p) {
  std::array<std::uint64_t, N> pattern{};
  for (std::size_t i = 0; i < N; ++i) pattern[i] = std::bit_cast<std::uint64_t>(p[i]) & ~(1ull << 63);
  for (std::size_t n = N; n > 1; n = (n + 1) / 2) {  // a tree: the comparisons do not wait for one another
    for (std::size_t i = 0; i < n / 2; ++i) pattern[i] = std::max(pattern[i], pattern[n - 1 - i]);
  }
  return pattern[0];
}

namespace integer {

// Coordinates of this many bits leave room for the carries of three-term sums in whole limbs.
inline constexpr int short_bits = 29, long_bits = 61;
// Below 2^least_exponent the scale that brings the largest coordinate there would not be a double.
inline constexpr int least_exponent = -962;
inline constexpr std::array wide_bits{125, 189, 253, 317, 509};

/// Does wide_integer_sign decide whatever lies on a lattice of this many bits?
template <Formula F>
constexpr bool wide_enough(int bits) {
  return std::ranges::any_of(wide_bits, [&](int wide) { return bits <= wide && value_bits<F>(wide) < 1024; });
}

}  // namespace integer

/// Certain when all coordinates lie on a lattice of at most 61 bits.  `largest` is largest_pattern(p).
template <Formula F>
constexpr Unsure<Sign> integer_sign(const Coordinates<F>& p, std::uint64_t largest) {
  const std::uint64_t exponent = largest >> 52;
  if (exponent < static_cast<std::uint64_t>(1023 + integer::least_exponent)) return {};
  // The largest coordinate's leading bit goes to bit 60; whatever comes back unchanged was an integer there.
  const auto scale = std::bit_cast<double>((2106 - exponent) << 52),
             unscale = std::bit_cast<double>((exponent - 60) << 52);
  std::array<std::int64_t, arity<F>> m{};
  std::uint64_t ones = 0;
  bool exact = true;
  for (std::size_t i = 0; i < m.size(); ++i) {
    m[i] = static_cast<std::int64_t>(p[i] * scale);
    exact &= static_cast<double>(m[i]) * unscale == p[i];
    ones |= static_cast<std::uint64_t>(m[i]);
  }
  if (!exact) return {};
  const int zeros = std::countr_zero(ones);
  if (integer::long_bits - zeros <= integer::short_bits) {
    return Unsure{evaluate<F>([&](std::size_t i) { return WideInt<integer::short_bits>{m[i] >> zeros}; }).sign()};
  }
  return Unsure{evaluate<F>([&](std::size_t i) { return WideInt<integer::long_bits>{m[i]}; }).sign()};
}

/// Certain when wide_enough; the width is the least of wide_bits that the coordinates' span allows.
template <Formula F>
constexpr Unsure<Sign> wide_integer_sign(const Coordinates<F>& p) {
  std::array<OddForm, arity<F>> form{};
  ExponentSpan span;
  for (std::size_t i = 0; i < p.size(); ++i) {
    form[i] = odd_form(p[i]);
    span.include(form[i]);
  }
  const Lattice lattice = span.lattice();
  Unsure<Sign> answer;
  const auto try_bits = [&]<int Bits>() {
    if constexpr (value_bits<F>(Bits) < 1024) {
      if (answer.certain() || lattice.bits > Bits) return;
      const auto coordinate = [&](std::size_t i) {
        return shifted<Bits>(form[i].mantissa, form[i].mantissa == 0 ? 0 : form[i].exponent - lattice.exponent);
      };
      answer = Unsure{evaluate<F>(coordinate).sign()};
    }
  };
  [&]<std::size_t... I>(std::index_sequence<I...>) { (try_bits.template operator()<integer::wide_bits[I]>(), ...); }
  (std::make_index_sequence<integer::wide_bits.size()>{});
  return answer;
}

/// Any program over any finite coordinates, by GMP (src/certify/big_integer_stage.cpp).
Sign big_integer_sign(Program program, std::span<const double> coordinates);

}  // namespace plumb
