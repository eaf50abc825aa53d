// Test-case reduction: what is the simplest case that still fails?  Shrinking of a case's choices, and of a list of
// coordinates.
//
// Laws: (1) the result still fails, if the case given did; (2) it is never less simple than what was given;
// (3) `still_fails` is called at most `most_calls` times, always in the same order: the same case shrinks to the same;
// (4) unless the calls ran out, no single step that the shrinker knows improves the result.
// Choices are simpler when there are fewer of them, then when the first that differs is smaller.  Coordinates are
// simpler when they repeat one another, are zero, have short mantissas and exponents near 0.
// Source: shrinking on choices is Hypothesis' idea (MacIver and Donaldson, "Test-case reduction via test-case
// generation").
// Cost: most_calls calls at the worst, usually a few hundred.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "plumb/predicates/standard.hpp"

namespace plumb {

using FailsOnChoices = std::function<bool(std::span<const std::uint64_t>)>;
using FailsOnCoordinates = std::function<bool(std::span<const double>)>;

/// Shrinks recorded choices; `still_fails` makes its case by Entropy::from_choices.
std::vector<std::uint64_t> shrink_choices(std::vector<std::uint64_t> choices, const FailsOnChoices& still_fails,
                                          std::size_t most_calls = 20'000);

/// Shrinks coordinates; `dimension` of them make a point (1: they have nothing to do with one another).
std::vector<double> shrink_coordinates(std::vector<double> coordinates, int dimension,
                                       const FailsOnCoordinates& still_fails, std::size_t most_calls = 20'000);

/// Whether shrink_coordinates prefers a to b.
bool is_simpler(std::span<const double> a, std::span<const double> b);

/// The candidates that shrink_choices tries, one at a time: for drivers that decide themselves, such as RapidCheck.
class ChoiceShrinks {
 public:
  explicit ChoiceShrinks(std::vector<std::uint64_t> choices);

  /// Moves to the next candidate, or returns false after the last.
  bool next();

  [[nodiscard]] const std::vector<std::uint64_t>& candidate() const { return candidate_; }
  [[nodiscard]] const std::vector<std::uint64_t>& current() const { return current_; }

  /// Makes the candidate the current case; the enumeration goes on from there.
  void accept();

 private:
  enum class Pass : unsigned char { redraw, drop, zero, lower, done };
  bool propose();
  void advance();

  std::vector<std::uint64_t> current_, candidate_;
  Pass pass_ = Pass::redraw;  // first, while there are choices left to shift into place
  std::size_t block_ = 0;     // length of the block to drop or zero; redraw: how many choices to skip
  std::size_t place_ = 0;     // drop and zero: end of the block; redraw and lower: the choice
  std::uint64_t amount_ = 0;  // lower: by how much
  bool started_ = false, accepted_ = false;
};

}  // namespace plumb
