// Signed volumes: on which side of a plane does a corner lie, how do three turn as seen along an axis, and do all lie
// on one line, on a lattice of up to 125 bits?
//
// Laws: exact, where is_lattice.
// Source: arith/lattice_digits.hpp.
// Cost: some 30 ns for the lattice, 60 for the sides of three corners, which share a normal, as much for a line, and 15
// for a turn.
#pragma once

#include <optional>

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
  /// As seen along an axis.
  [[nodiscard]] Sign area(std::size_t axis, std::size_t i, std::size_t j, std::size_t k) const {
    const std::size_t right = (axis + 1) % 3, up = (axis + 2) % 3;
    return (along(right, i, j) * along(up, i, k) - along(up, i, j) * along(right, i, k)).sign();
  }
  /// An axis in which the line runs on which all points lie, one at least off the first; nothing where there is none.
  [[nodiscard]] std::optional<std::size_t> running_axis() const {
    const auto is_zero = [](const auto& v) {
      return v.x.sign() == Sign::zero && v.y.sign() == Sign::zero && v.z.sign() == Sign::zero;
    };
    std::size_t far = 1;
    while (far + 1 < N && is_zero(step(0, far))) ++far;
    const predicates::Triple<Step> along = step(0, far);
    for (std::size_t i = far + 1; i < N; ++i) {
      if (!is_zero(predicates::cross(along, step(0, i)))) return {};
    }
    return along.x.sign() != Sign::zero ? 0 : along.y.sign() != Sign::zero ? 1 : 2;
  }

 private:
  static constexpr int bits = certify::integer::wide_bits.front();
  using Step = WideInt<bits + 1>;
  [[nodiscard]] Step along(std::size_t axis, std::size_t i, std::size_t j) const {
    return digits_.template difference<bits>(3 * j + axis, 3 * i + axis);
  }
  [[nodiscard]] predicates::Triple<Step> step(std::size_t i, std::size_t j) const {
    return {along(0, i, j), along(1, i, j), along(2, i, j)};
  }
  LatticeDigits<3 * N, bits> digits_;
  bool is_lattice_;
};

}  // namespace plumb::query
