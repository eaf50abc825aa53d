// Which operations does a formula do, in which order?  A number that writes them down when compiled.
//
// The last stage and the proofs run over types that headers must not drag in (GMP); they read a formula from its tape.
// The tape knows + - * alone.  What else a formula may say is put into these: a whole number times x is a chain of
// doublings (x + x) and sums, -x is taken off instead of added.  What no polynomial does is noted, so that the compiler
// can say in one sentence what is wrong (certify/formula.hpp).
// Laws: replaying the tape in order performs exactly the formula's operations; n x takes as many doublings as n has
// binary digits but one, and as many sums as it has ones but one, the doublings rounding nothing.
// Source: Wengert 1964.
// Cost: none at run time.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "plumb/predicates/standard.hpp"

namespace plumb::certify::tape {

/// Result number arity + i of instruction i; operands name inputs (below arity) or earlier results.
struct Instruction {
  char operation;  // '+', '-' or '*'
  std::uint16_t left, right;

  /// x + x, which no double but an infinite one needs to round.
  [[nodiscard]] constexpr bool doubles() const { return operation == '+' && left == right; }
};

/// A formula as data: its value is that of the last instruction.
struct Program {
  std::size_t arity;
  std::span<const Instruction> instructions;
};

/// What a formula did that no polynomial does.
enum class Misuse : std::uint8_t {
  none,
  other_input,   // it does not take its coordinates as one array
  other_result,  // what it returns is no number of its own
  coordinate_returned,
  broken_constant,
  added_constant,
  division,
  comparison
};

/// Throws std::length_error; where a formula is recorded by the compiler, it is refused by this name.
[[noreturn]] void throw_formula_too_long();

/// The largest whole number that a formula multiplies by.
inline constexpr std::uint32_t largest_constant = 0x7fffffff;

template <std::size_t Capacity>
struct Tape {
  std::array<Instruction, Capacity> instructions{};
  std::size_t size = 0;
  std::size_t arity = 0;
  Misuse misuse = Misuse::none;  // the first
  bool as_written = true;        // the formula can be run over any numbers as it stands: it has + - * alone

  constexpr std::uint16_t write(char operation, std::uint16_t left, std::uint16_t right) {
    if (size == Capacity) throw_formula_too_long();
    instructions[size] = {operation, left, right};
    return static_cast<std::uint16_t>(arity + size++);
  }
  constexpr void note(Misuse what) {
    if (misuse == Misuse::none) misuse = what;
  }
};

template <class T>
concept Constant = std::is_arithmetic_v<T>;

template <std::size_t Capacity>
struct Recorded {
  Tape<Capacity>* tape;
  std::uint16_t index;
  bool negative = false;  // stands for the number's opposite

  friend constexpr Recorded operator+(Recorded a, Recorded b) {
    if (a.negative == b.negative) return {a.tape, a.tape->write('+', a.index, b.index), a.negative};
    if (a.negative) return {a.tape, a.tape->write('-', b.index, a.index)};
    return {a.tape, a.tape->write('-', a.index, b.index)};
  }
  friend constexpr Recorded operator-(Recorded a, Recorded b) { return a + Recorded{b.tape, b.index, !b.negative}; }
  friend constexpr Recorded operator*(Recorded a, Recorded b) {
    return {a.tape, a.tape->write('*', a.index, b.index), a.negative != b.negative};
  }

  friend constexpr Recorded operator-(Recorded a) {
    a.tape->as_written = false;
    return {a.tape, a.index, !a.negative};
  }
  template <Constant C>
  friend constexpr Recorded operator*(C c, Recorded x) {
    return x.times(c);
  }
  template <Constant C>
  friend constexpr Recorded operator*(Recorded x, C c) {
    return x.times(c);
  }

  // What no polynomial does.
  template <Constant C>
  friend constexpr Recorded operator+(C, Recorded x) {
    return x.noted(Misuse::added_constant);
  }
  template <Constant C>
  friend constexpr Recorded operator+(Recorded x, C) {
    return x.noted(Misuse::added_constant);
  }
  template <Constant C>
  friend constexpr Recorded operator-(C, Recorded x) {
    return x.noted(Misuse::added_constant);
  }
  template <Constant C>
  friend constexpr Recorded operator-(Recorded x, C) {
    return x.noted(Misuse::added_constant);
  }
  friend constexpr Recorded operator/(Recorded x, Recorded) { return x.noted(Misuse::division); }
  template <Constant C>
  friend constexpr Recorded operator/(C, Recorded x) {
    return x.noted(Misuse::division);
  }
  template <Constant C>
  friend constexpr Recorded operator/(Recorded x, C) {
    return x.noted(Misuse::division);
  }
  template <class Other>
  friend constexpr bool operator<(Recorded x, const Other&) {
    return x.compared();
  }
  template <class Other>
  friend constexpr bool operator>(Recorded x, const Other&) {
    return x.compared();
  }
  template <class Other>
  friend constexpr bool operator<=(Recorded x, const Other&) {
    return x.compared();
  }
  template <class Other>
  friend constexpr bool operator>=(Recorded x, const Other&) {
    return x.compared();
  }
  template <class Other>
  friend constexpr bool operator==(Recorded x, const Other&) {
    return x.compared();
  }

  /// The number itself where it stands for its opposite: the difference the other way round, or x - 2 x.
  [[nodiscard]] constexpr std::uint16_t result() const {
    if (!negative) return index;
    if (index >= tape->arity) {
      const Instruction last = tape->instructions[index - tape->arity];
      if (last.operation == '-') return tape->write('-', last.right, last.left);
    }
    return tape->write('-', index, tape->write('+', index, index));
  }

 private:
  constexpr Recorded noted(Misuse what) const {
    tape->note(what);
    return *this;
  }
  constexpr bool compared() const {
    tape->note(Misuse::comparison);
    return false;
  }

  // From the highest binary digit of c down: doubled for each, and x added for each one.
  template <Constant C>
  constexpr Recorded times(C c) const {
    tape->as_written = false;
    const auto given = static_cast<long double>(c), size = given < 0 ? -given : given;
    if (!(size >= 1 && size <= largest_constant)) return noted(Misuse::broken_constant);
    const auto n = static_cast<std::uint32_t>(size);
    if (static_cast<long double>(n) != size) return noted(Misuse::broken_constant);
    Recorded product = *this;
    for (std::uint32_t digit = std::bit_floor(n) / 2; digit != 0; digit /= 2) {
      product = product + product;
      if ((n & digit) != 0) product = product + *this;
    }
    return {tape, product.index, negative != (given < 0)};
  }
};

}  // namespace plumb::certify::tape
