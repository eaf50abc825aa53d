// In which order, and with how much memory, is a formula's tape run over blocks of cases?
//
// Each instruction is done for a block of cases before the next one, so that what it costs to look it up is shared.
// Numbers of the tape live in slots, of which one is free again after its number's last use: a block's slots stay in
// the first level cache.
// A number is plain where its magnitude is that of its value: coordinates, and sums and differences of two of them, as
// arith/filtered.hpp has it.
// Cost: a pass over the tape, once for each call.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/certify/signs_of.hpp"

namespace plumb::batch {

/// Cases a block.
inline constexpr std::size_t block = 64;

/// What a step does: the operation, and which of its operands are plain.
enum class StepKind : std::uint8_t {
  plain_sum,
  plain_difference,
  sum_of_plains,
  sum_of_plain_and_any,
  sum,
  difference_of_plains,
  difference_of_plain_and_any,
  difference_of_any_and_plain,
  difference,
  product_of_plains,
  product_of_plain_and_any,
  product
};

/// Operands: below the arity coordinates, then slots.
struct TapeStep {
  StepKind kind;
  std::uint16_t left, right, to;
};

class TapePlan {
 public:
  TapePlan(const BatchFormula& asked, std::span<const Column> columns);

  [[nodiscard]] std::size_t arity() const { return strides_.size(); }
  [[nodiscard]] std::size_t slots() const { return slots_; }
  [[nodiscard]] std::span<const TapeStep> steps() const { return steps_; }
  [[nodiscard]] std::size_t stride(std::size_t coordinate) const { return strides_[coordinate]; }
  /// How many coordinates from this one on lie beside one another, item after item: 2 or 3; 1 where it stands alone or
  /// is not the first of them.
  [[nodiscard]] std::size_t beside(std::size_t coordinate) const { return beside_[coordinate]; }
  [[nodiscard]] double constant() const { return constant_; }
  [[nodiscard]] std::uint16_t result() const { return steps_.back().to; }
  [[nodiscard]] bool result_is_plain() const {
    return steps_.back().kind == StepKind::plain_sum || steps_.back().kind == StepKind::plain_difference;
  }

 private:
  std::vector<std::size_t> strides_, beside_;
  std::vector<TapeStep> steps_;
  std::size_t slots_ = 0;
  double constant_;
};

}  // namespace plumb::batch
