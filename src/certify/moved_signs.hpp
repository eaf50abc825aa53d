// The perturbed sign by ordinary signs: moving a coordinate by an infinitesimal or by any amount tells the same, as
// long as the formula is linear in it, or all else is zero (docs/proof.md, "Perturbation").
//
// Laws: a certain answer is the perturbed sign.  A formula has a power above the second in no coordinate that is moved,
// or the answer is unsure.
// Cost: two or three signs usually, each of which the filter decides as a rule; 64 at the most.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "plumb/certify/perturbed.hpp"

namespace plumb::certify::perturbation {

class MovedSigns {
 public:
  /// `p` is written to, and restored; the exact sign there is zero.  `order`: the coordinate with the largest
  /// infinitesimal first.
  MovedSigns(const Subject& subject, std::span<double> p, std::span<const std::uint16_t> order);

  Unsure<Sign> sign();
  /// After an unsure sign: with the first so many infinitesimals alone the expansion is zero.
  [[nodiscard]] std::size_t known_zero() const { return known_zero_; }

 private:
  enum class Outcome : signed char { negative = -1, zero = 0, positive = 1, unknown };
  static constexpr int most_signs = 64;
  static constexpr std::size_t deepest = 8;

  [[nodiscard]] double step() const;
  void find_equal_arguments();
  [[nodiscard]] bool equal_arguments_stay() const;
  Outcome with(std::size_t number, std::uint64_t allowed);
  Outcome simple_term();
  Outcome by_expansion();

  const Subject& subject_;
  std::span<double> p_;
  std::span<const std::uint16_t> order_;
  double reach_ = 0;  // the largest |coordinate|, or 1
  double step_ = 0;   // step(), once it is needed
  std::size_t known_zero_ = 0;
  int signs_ = 0;

  std::array<std::uint16_t, deepest> moved_{};  // coordinates, the smallest infinitesimal first
  std::size_t depth_ = 0;
  std::array<std::uint64_t, 3> equal_pair_{};  // coordinates of two equal arguments, where swapping them flips the sign
  std::size_t equal_pairs_ = 0;
};

}  // namespace plumb::certify::perturbation
