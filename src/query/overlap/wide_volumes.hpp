// Signed volumes: on which side of a plane does a corner lie, on a lattice of up to 125 bits?
//
// Laws: exact, where is_lattice.
// Source: arith/lattice_digits.hpp.
// Cost: some 30 ns for the lattice and 60 for the sides of three corners, which share a normal.
#pragma once

#include "plumb/arith/lattice_digits.hpp"
#include "query/overlap/signs.hpp"

namespace plumb::query {

template <std::size_t N>
class WideVolumes {
 public:
  explicit WideVolumes(const std::array<double, 3 * N>& coordinates) : digits_(coordinates) {
    is_lattice_ = digits_.template extend<bits>();
  }
  [[nodiscard]] bool is_lattice() const { return is_lattice_; }

  [[nodiscard]] Sign volume(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const {
    return predicates::triple(step(l, i), step(l, j), step(l, k)).sign();
  }
  /// Of points j, j + 1, ... over the plane of i, i + 1, i + 2.
  template <std::size_t Count>
  [[nodiscard]] std::array<Sign, Count> over(std::size_t i, std::size_t j) const {
    const auto normal = predicates::cross(step(i, i + 1), step(i, i + 2));
    std::array<Sign, Count> sides{};
    for (std::size_t k = 0; k < Count; ++k) sides[k] = predicates::dot(step(i, j + k), normal).sign();
    return sides;
  }

 private:
  static constexpr int bits = certify::integer::wide_bits.front();
  [[nodiscard]] predicates::Triple<WideInt<bits + 1>> step(std::size_t i, std::size_t j) const {
    const auto along = [&](std::size_t axis) { return digits_.template difference<bits>(3 * j + axis, 3 * i + axis); };
    return {along(0), along(1), along(2)};
  }
  LatticeDigits<3 * N, bits> digits_;
  bool is_lattice_;
};

}  // namespace plumb::query
