// Which operations does a formula do, in which order?  A number that writes them down when compiled.
//
// The last stage and the proofs run over types that headers must not drag in (GMP); they read a formula from its tape.
// Law: replaying the tape in order performs exactly the formula's operations.  Source: Wengert 1964; cost: none at run
// time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>

namespace plumb::tape {

/// Result number arity + i of instruction i; operands name inputs (below arity) or earlier results.
struct Instruction {
  char operation;  // '+', '-' or '*'
  std::uint16_t left, right;
};

/// A formula as data: its value is that of the last instruction.
struct Program {
  std::size_t arity;
  std::span<const Instruction> instructions;
};

template <std::size_t Capacity>
struct Tape {
  std::array<Instruction, Capacity> instructions{};
  std::size_t size = 0;
  std::size_t arity = 0;

  constexpr std::uint16_t write(char operation, std::uint16_t left, std::uint16_t right) {
    if (size == Capacity) throw std::length_error("formula too long for its tape");
    instructions[size] = {operation, left, right};
    return static_cast<std::uint16_t>(arity + size++);
  }
};

template <std::size_t Capacity>
struct Recorded {
  Tape<Capacity>* tape;
  std::uint16_t index;

  friend constexpr Recorded operator+(Recorded a, Recorded b) { return {a.tape, a.tape->write('+', a.index, b.index)}; }
  friend constexpr Recorded operator-(Recorded a, Recorded b) { return {a.tape, a.tape->write('-', a.index, b.index)}; }
  friend constexpr Recorded operator*(Recorded a, Recorded b) { return {a.tape, a.tape->write('*', a.index, b.index)}; }
};

}  // namespace plumb::tape
