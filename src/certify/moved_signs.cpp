#include "certify/moved_signs.hpp"

#include <algorithm>
#include <cmath>

#include "certify/expansion.hpp"

namespace plumb::certify::perturbation {

MovedSigns::MovedSigns(const Subject& subject, std::span<double> p, std::span<const std::uint16_t> order)
    : subject_(subject), p_(p), order_(order) {
  for (const double x : p) reach_ = std::max(reach_, std::fabs(x));
  if (reach_ == 0) reach_ = 1;
  if (subject.alternating && !subject.degree.empty()) find_equal_arguments();
}

// How far to move a coordinate both ways: a part of the largest difference between arguments along an axis.
double MovedSigns::step() const {
  double extent = 0;
  const auto axes = static_cast<std::size_t>(*std::ranges::max_element(subject_.arguments));
  for (std::size_t axis = 0; axis < axes; ++axis) {
    double least = HUGE_VAL, most = -HUGE_VAL;
    std::size_t first = 0;
    for (const int n : subject_.arguments) {
      if (axis < static_cast<std::size_t>(n)) {
        least = std::min(least, p_[first + axis]);
        most = std::max(most, p_[first + axis]);
      }
      first += static_cast<std::size_t>(n);
    }
    extent = std::max(extent, most - least);
  }
  return extent > 0 ? extent / 8 : reach_;
}

// As long as two equal arguments stay where they are, an alternating formula is zero.
void MovedSigns::find_equal_arguments() {
  const auto axes = static_cast<std::size_t>(subject_.arguments.front());
  const std::uint64_t all = (std::uint64_t{1} << axes) - 1;
  for (std::size_t a = p_.size() - axes; a > 0 && equal_pairs_ < equal_pair_.size();) {
    a -= axes;
    const auto one = p_.subspan(a, axes);
    for (std::size_t b = a + axes; b < p_.size(); b += axes) {
      if (!std::ranges::equal(one, p_.subspan(b, axes))) continue;
      equal_pair_[equal_pairs_++] = all << a | all << b;
      break;
    }
  }
}

bool MovedSigns::equal_arguments_stay() const {
  std::uint64_t moved = 0;
  for (std::size_t k = 0; k < depth_; ++k) moved |= std::uint64_t{1} << moved_[k];
  for (std::size_t k = 0; k < equal_pairs_; ++k) {
    if ((moved & equal_pair_[k]) == 0) return true;
  }
  return false;
}

Unsure<Sign> MovedSigns::sign() {
  if (subject_.degree.empty()) return {};
  for (known_zero_ = 0; known_zero_ < order_.size(); ++known_zero_) {
    if (subject_.degree[order_[known_zero_]] == 0) continue;
    const Outcome s = with(known_zero_, ~std::uint64_t{0});
    if (s == Outcome::unknown) return {};
    if (s != Outcome::zero) return Unsure{static_cast<Sign>(s)};
  }
  return {};
}

// Moves the coordinate with this number in the order beside those that are moved already; then with it every set of
// larger infinitesimals that a term may hold together, the larger products first.
MovedSigns::Outcome MovedSigns::with(std::size_t number, std::uint64_t allowed) {
  const std::uint16_t i = order_[number];
  if (depth_ == deepest) return Outcome::unknown;
  moved_[depth_++] = i;
  Outcome outcome = simple_term();
  allowed &= subject_.beside[i];
  for (std::size_t k = 0; k < number && outcome == Outcome::zero; ++k) {
    if ((allowed >> order_[k] & 1) != 0) outcome = with(k, allowed);
  }
  --depth_;
  return outcome;
}

// The sign of the term that holds the infinitesimals of moved_ once each; every term of a part of them is known to be
// zero.  Zero says that all terms of these infinitesimals are.
MovedSigns::Outcome MovedSigns::simple_term() {
  if (equal_arguments_stay()) return Outcome::zero;
  std::array<double, deepest> x{};
  std::size_t squares = 0;  // how many coordinates must move both ways; they come first in `moved`
  std::array<std::uint16_t, deepest> moved = moved_;
  for (std::size_t k = 0; k < depth_; ++k) {
    const std::uint8_t degree = subject_.degree[moved[k]];
    if (degree > 2) return Outcome::unknown;
    if (degree == 2) std::swap(moved[squares++], moved[k]);
  }
  if (signs_ + (1 << squares) > most_signs) return Outcome::unknown;
  if (squares != 0 && step_ == 0) step_ = step();
  Sign linear = Sign::positive;
  for (std::size_t k = 0; k < depth_; ++k) {
    x[k] = p_[moved[k]];
    if (k < squares && !(x[k] + step_ > x[k] && x[k] - step_ < x[k] && std::isfinite(std::fabs(x[k]) + step_))) {
      return Outcome::unknown;
    }
    if (k >= squares) {  // toward zero and beyond: never too far
      p_[moved[k]] = x[k] - std::copysign(reach_, x[k]);
      if (!std::signbit(x[k])) linear = -linear;
    }
  }
  bool positive = false, negative = false;
  for (unsigned corner = 0; corner < 1u << squares && !(positive && negative); ++corner) {
    Sign direction = linear;
    for (std::size_t k = 0; k < squares; ++k) {
      const bool down = (corner >> k & 1) != 0;
      p_[moved[k]] = down ? x[k] - step_ : x[k] + step_;
      if (down) direction = -direction;
    }
    const Sign s = subject_.decide(p_) * direction;
    positive |= s == Sign::positive;
    negative |= s == Sign::negative;
    ++signs_;
  }
  for (std::size_t k = 0; k < depth_; ++k) p_[moved[k]] = x[k];
  if (positive && negative) return by_expansion();
  return positive ? Outcome::positive : negative ? Outcome::negative : Outcome::zero;
}

// The moves were too far to tell the term from those of higher powers.
MovedSigns::Outcome MovedSigns::by_expansion() {
  std::array<std::uint16_t, deepest> largest_first{};
  std::reverse_copy(moved_.begin(), moved_.begin() + static_cast<std::ptrdiff_t>(depth_), largest_first.begin());
  const LargestTerm t =
      largest_term(subject_.program, subject_.homogeneous, p_, std::span(largest_first).first(depth_));
  // A power of the only infinitesimal is next where no larger one may stand beside it.
  bool next = true;
  for (std::size_t k = 0; k < known_zero_; ++k) next &= (subject_.beside[moved_[0]] >> order_[k] & 1) == 0;
  return t.simple || next ? static_cast<Outcome>(t.sign) : Outcome::unknown;
}

}  // namespace plumb::certify::perturbation
