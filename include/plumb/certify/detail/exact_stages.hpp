// What is the sign when the filter is unsure?  The exact stages, each callable by itself.
//
// Laws: a certain answer is the sign of the exact value; wide_integer_sign is certain up to the widest coordinates of
// wide_bits whose values stay below 1024 bits, leveled where axes have levels of their own; big_integer_sign is certain
// always.  All take finite coordinates only.
// A homogeneous formula keeps its sign when all coordinates are multiplied by 2^-exponent of their lattice, so integers
// may stand for the doubles (docs/proof.md, "Integers").
// Source: RTCD 11.4, 11.5.1.
// Cost: integer_sign 10 to 60 ns, wide_integer_sign 30 to 500 ns, big_integer_sign a microsecond or more.
#pragma once

#include <array>
#include <span>
#include <utility>

#include "plumb/arith/interval.hpp"
#include "plumb/arith/lattice.hpp"
#include "plumb/arith/lattice_digits.hpp"
#include "plumb/arith/lattice_integers.hpp"
#include "plumb/arith/structural_zero.hpp"
#include "plumb/arith/wide_int.hpp"
#include "plumb/certify/detail/levels.hpp"
#include "plumb/certify/formula.hpp"
#include "plumb/predicates/manifest.hpp"

namespace plumb {

/// Does it pay to compile long doubles, the wide integers and the interval for this formula?  For those that are asked
/// most, by measurement (docs/measurements.md, "Stages"); the last stage serves the others without code of their own.
template <Formula F>
inline constexpr bool has_wide_stages = false;
template <>
inline constexpr bool has_wide_stages<predicates::Orient2d> = true;
template <>
inline constexpr bool has_wide_stages<predicates::Orient3d> = true;
template <>
inline constexpr bool has_wide_stages<predicates::InCircle> = true;
template <>
inline constexpr bool has_wide_stages<predicates::InSphere> = true;

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

namespace certify::integer {

// Coordinates of this many bits leave room for the carries of three-term sums in whole limbs.
inline constexpr int short_bits = 29, long_bits = 61;
inline constexpr std::array wide_bits{125, 188, 253, 317, 509};

/// Which coordinates are looked at: with wide stages those that are not `low` (levels.hpp), which are raised first.
template <Formula F>
using Integers = LatticeIntegers<arity<F>, has_wide_stages<F> ? Levels<F>::least_exponent : 9>;

/// Does integer_sign decide whatever lies on this lattice, raised or not?
constexpr bool short_enough(const Lattice& lattice) {
  return lattice.bits <= long_bits && lattice.exponent + lattice.bits <= 1021;
}

/// The most bits of coordinates whose values stay below 1024 bits.
template <Formula F>
inline constexpr int widest = [] {
  int most = 0;
  for (const int bits : wide_bits) most = value_bits<F>(bits) < 1024 ? bits : most;
  return most;
}();

/// Does wide_integer_sign?
template <Formula F>
constexpr bool wide_enough(const Lattice& lattice) {
  return lattice.bits <= widest<F>;
}

/// A coordinate of which only differences to others are asked.
template <int Bits, class Integers>
struct Input {
  const Integers& all;
  std::size_t index;
  int zeros;

  friend WideInt<Bits + 1> operator-(const Input& a, const Input& b) {
    return WideInt<Bits + 1>{a.all.difference(a.index, b.index) >> a.zeros};
  }
};

template <Formula F>
inline constexpr bool enters_by_differences = [] {
  for (const certify::tape::Instruction& i : certify::tape::of<F>.instructions) {
    const int inputs = (i.left < arity<F> ? 1 : 0) + (i.right < arity<F> ? 1 : 0);
    if (inputs == 1 || (inputs == 2 && i.operation != '-')) return false;
  }
  return true;
}();

/// `Use` tells the places apart that ask it: a compiler expands code where it is used from one place alone.
template <Formula F, int Bits, int Use = 0>
[[gnu::always_inline]] inline Unsure<Sign> sign_of(const Integers<F>& all, int zeros) {
  if constexpr (enters_by_differences<F>) {
    return Unsure{evaluate<F>([&](std::size_t i) { return Input<Bits, Integers<F>>{all, i, zeros}; }).sign()};
  } else {
    return Unsure{evaluate<F>([&](std::size_t i) { return WideInt<Bits>{all.integer(i) >> zeros}; }).sign()};
  }
}

/// A coordinate of which only differences to others are asked, in many digits.
template <int Bits, class Digits>
struct WideInput {
  const Digits& all;
  std::size_t index;

  friend WideInt<Bits + 1> operator-(const WideInput& a, const WideInput& b) {
    return a.all.template difference<Bits>(a.index, b.index);
  }
};

template <Formula F, int Bits, class Digits>
Sign sign_of_digits(const Digits& all) {
  if constexpr (enters_by_differences<F>) {
    return evaluate<F>([&](std::size_t i) { return WideInput<Bits, Digits>{all, i}; }).sign();
  } else {
    return evaluate<F>([&](std::size_t i) { return all.template integer<Bits>(i); }).sign();
  }
}

/// With everything inlined, and with what the compiler chooses.
template <Formula F, int Bits, class Digits>
[[gnu::noinline, gnu::flatten]] Sign flat_sign(const Digits& all) {
  return sign_of_digits<F, Bits>(all);
}
template <Formula F, int Bits, class Digits>
[[gnu::noinline]] Sign wide_sign(const Digits& all) {
  // By measurement: calls cost a third of the time, but beyond this many bits too much is spilled otherwise.
  if constexpr (value_bits<F>(Bits) < 800) return flat_sign<F, Bits>(all);
  return sign_of_digits<F, Bits>(all);
}

}  // namespace certify::integer

/// Certain when all coordinates lie on a lattice of at most 61 bits within the range of LatticeIntegers.
template <Formula F>
[[gnu::always_inline]] inline Unsure<Sign> integer_sign(const Coordinates<F>& p) {
  if constexpr (arity<F> >= 2) {
    const certify::integer::Integers<F> all(p);
    if (all.bits() == 0) return {};
    if (all.bits() - all.zeros() <= certify::integer::short_bits)
      return certify::integer::sign_of<F, certify::integer::short_bits>(all, all.zeros());
    return certify::integer::sign_of<F, certify::integer::long_bits>(all, 0);
  } else {
    return {};
  }
}

namespace certify::integer {

/// The width is the least of wide_bits that the coordinates' span allows.
template <Formula F>
Unsure<Sign> sign_on_lattice(const Coordinates<F>& p) {
  LatticeDigits<arity<F>, widest<F>> all(p);
  Unsure<Sign> answer;
  const auto try_bits = [&]<int Bits>() {
    if constexpr (Bits <= widest<F>) {
      if (!all.template extend<Bits>()) return false;
      answer = Unsure{wide_sign<F, Bits>(all)};
      return true;
    }
    return false;
  };
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    static_cast<void>((try_bits.template operator()<wide_bits[I]>() || ...));
  }
  (std::make_index_sequence<wide_bits.size()>{});
  return answer;
}

/// On the lattices that the axes have each by itself, brought to one size.
template <Formula F>
[[gnu::noinline]] Unsure<Sign> sign_on_levels(const Coordinates<F>& p, const Levels<F>& levels) {
  const Coordinates<F> leveled = levels.at(p);
  if constexpr (Levels<F>::count > 1) {
    if (levels.span() < long_bits) {
      if (const Integers<F> all(leveled); all.bits() != 0) return sign_of<F, long_bits, 1>(all, 0);
    }
  }
  return sign_on_lattice<F>(leveled);
}

}  // namespace certify::integer

namespace certify {

/// Is the lattice of all coordinates asked first?  Not where those of the axes by themselves take fewer bits by a step
/// of wide_bits, nor where the exponents span more than this.  (Of few bits, a choice that is not foreseen costs more
/// than it saves.)
template <Formula F>
bool begins_with_one_lattice(const Levels<F>& levels, int most) {
  constexpr int step = 64;
  return levels.span_of_all() <= std::min(most, std::max(levels.span() + step, 2 * step));
}

}  // namespace certify

/// Certain when wide_enough, or when the coordinates leveled are.
template <Formula F>
Unsure<Sign> wide_integer_sign(const Coordinates<F>& p, const certify::Levels<F>& levels) {
  if (certify::begins_with_one_lattice<F>(levels, certify::integer::widest<F>)) {
    if (const auto s = certify::integer::sign_on_lattice<F>(p); s.certain()) return s;
  }
  if (levels.span() <= certify::integer::widest<F>) return certify::integer::sign_on_levels<F>(p, levels);
  return {};
}
template <Formula F>
Unsure<Sign> wide_integer_sign(const Coordinates<F>& p) {
  return wide_integer_sign<F>(p, certify::Levels<F>(p));
}

/// Any program over any finite coordinates, by GMP (src/certify/big_integer_stage.cpp).
Sign big_integer_sign(certify::tape::Program program, std::span<const double> coordinates);

}  // namespace plumb
