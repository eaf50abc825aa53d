// How far are bodies apart along their normal, and where are the corners of their contact?  Each number rounded once, by
// pairs of doubles.
//
// Laws: what is told is exact, then rounded; what pairs of doubles leave open is nothing.  Pairs that carry a magnitude are
// asked first, of boxes four corners at once, then balls, which know zero.  A distance that is nearly none is computed in integers, for its digits are
// those that cancel.
// Source: query/contact/told_numbers.hpp.
// Cost: of boxes some 700 operations for four corners, else 300 a corner, where balls are asked 1,500.
#pragma once

#include "query/contact/box_corners.hpp"

namespace plumb::query::touching {

/// What is computed of a pair by pairs of doubles before any corner is.
struct ToldByPairs {
  ToldNumbers<parting::FusedPair> numbers;
  parting::FusedPair height;

  explicit ToldByPairs(const Pair& p) : numbers(p), height(numbers.height()) {}
};

class QuickNumbers {
 public:
  explicit QuickNumbers(const Pair& p) : pair_(p) {}
  [[nodiscard]] std::optional<Whole> whole() const;
  /// One for each that was found.
  [[nodiscard]] QuickCorners corners(const Matched& m, const Whole& whole) const;

 private:
  [[nodiscard]] QuickCorners remaining_corners(const Matched& m, const Whole& whole, const QuickCorners& so_far) const;

  const Pair& pair_;
  mutable std::optional<ToldByPairs> by_pairs_;  // when it is first asked for
};

}  // namespace plumb::query::touching
