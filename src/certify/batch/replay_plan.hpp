// In which order is a formula replayed over vectors of cases?  What is known of its tape when it is compiled.
//
// Law: the inputs of a formula that runs in batches are used in differences of one axis alone, so that coordinates may
// be subtracted before x, y and z are told apart.  The four classic formulas are such.
// Source: the tape (certify/detail/tape.hpp).
// Cost: none at run time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "plumb/certify/detail/filter_stage.hpp"

namespace plumb::certify::batch {

/// Point `left` minus point `right`: the instruction that does it, for each axis.
template <std::size_t Dimension>
struct Difference {
  std::size_t left, right;
  std::array<std::size_t, Dimension> instruction;
};

template <Formula F>
struct ReplayPlan {
  static constexpr std::size_t dimension = static_cast<std::size_t>(F::dimension);
  static constexpr std::size_t points = static_cast<std::size_t>(F::points);
  static constexpr std::size_t size = certify::tape::of<F>.size;

  static constexpr certify::tape::Instruction instruction(std::size_t i) {
    return certify::tape::of<F>.instructions[i];
  }
  static constexpr bool is_input(std::size_t number) { return number < arity<F>; }
  /// Is instruction i a difference of two coordinates?
  static constexpr bool is_difference(std::size_t i) {
    return is_input(instruction(i).left) && is_input(instruction(i).right);
  }
  static constexpr std::size_t axis(std::size_t i) { return instruction(i).left % dimension; }

  static constexpr bool by_differences = [] {
    for (std::size_t i = 0; i < size; ++i) {
      const certify::tape::Instruction in = instruction(i);
      if (is_input(in.left) != is_input(in.right)) return false;
      if (is_difference(i) && (in.operation != '-' || in.left % dimension != in.right % dimension)) return false;
    }
    return true;
  }();
  static_assert(by_differences, "a formula that runs in batches uses its inputs in differences of one axis alone");

  static constexpr std::size_t count = [] {
    std::size_t n = 0;
    for (std::size_t i = 0; i < size; ++i) n += is_difference(i);
    return n / dimension;
  }();

  static constexpr auto differences = [] {
    std::array<Difference<dimension>, count> all{};
    std::size_t n = 0;
    for (std::size_t i = 0; i < size; ++i) {
      if (!is_difference(i) || axis(i) != 0) continue;
      Difference<dimension>& one = all[n++];
      one.left = instruction(i).left / dimension;
      one.right = instruction(i).right / dimension;
      for (std::size_t a = 0; a < dimension; ++a) {
        for (std::size_t j = 0; j < size; ++j) {
          if (instruction(j).left == one.left * dimension + a && instruction(j).right == one.right * dimension + a)
            one.instruction[a] = j;
        }
      }
    }
    return all;
  }();

  /// The first instruction whose magnitude over the largest differences equals that of instruction i, for all of the
  /// same expression: sums and differences are alike there, and so are the points.
  static constexpr auto like = [] {
    std::array<std::size_t, size> first{};
    for (std::size_t i = 0; i < size; ++i) {
      first[i] = i;
      for (std::size_t j = 0; j < i && first[i] == i; ++j) {
        if (is_difference(i) != is_difference(j)) continue;
        if (is_difference(i)) {
          if (axis(i) == axis(j)) first[i] = j;
          continue;
        }
        const certify::tape::Instruction a = instruction(i), b = instruction(j);
        const std::size_t al = first[a.left - arity<F>], ar = first[a.right - arity<F>];
        const std::size_t bl = first[b.left - arity<F>], br = first[b.right - arity<F>];
        const bool same_operands = (al == bl && ar == br) || (al == br && ar == bl);
        if ((a.operation == '*') == (b.operation == '*') && same_operands) first[i] = j;
      }
    }
    return first;
  }();
};

}  // namespace plumb::certify::batch
