// Which double does a decimal name, and how far from it does it lie?
//
// Laws: the value is the nearest double (ties to even), of either sign of zero; a decimal is counted exact only when it
// equals its double as a real number; the largest move is the exact distance rounded to nearest, and never 0 when a
// decimal moved.  A decimal below the smallest subnormal becomes zero and has moved; one beyond the largest double, an
// infinity and a NaN are no number.
// Source: Clinger (PLDI 1990) for what is exact in doubles; the remainder of a rounded quotient is a double.
// Cost: some 30 ns for decimals of up to 15 digits; the exact distance of longer ones is taken only where it could be a
// new largest, linear in their length.  Nothing is searched.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "plumb/predicates/standard.hpp"

namespace plumb {

class DecimalReader {
 public:
  enum class Outcome { number, not_decimal, not_finite, too_large };

  /// Reads the whole of `text`: digits with an optional sign, point and exponent.  `value` is set only for a number.
  Outcome read(std::string_view text, double& value);

  [[nodiscard]] std::uint64_t decimals() const { return decimals_; }   // numbers read so far
  [[nodiscard]] std::uint64_t inexact() const { return inexact_; }     // those that are not exactly doubles
  [[nodiscard]] double largest_move() const { return largest_move_; }  // the farthest that one moved to its double

 private:
  void note_move(double move);

  std::uint64_t decimals_ = 0, inexact_ = 0;
  double largest_move_ = 0;
  std::string record_;  // the long decimal that set the largest move, so that its repetitions cost nothing
};

}  // namespace plumb
