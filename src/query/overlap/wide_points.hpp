// Which integers are the corners of a pair of figures in space, where their lattice takes up to 125 bits?
//
// Laws: those of lattice_points.hpp; the points are on one lattice in all axes.
// Source: arith/lattice_digits.hpp.
// Cost: some 30 ns for the lattice, 15 for a turn that doubles do not tell.
#pragma once

#include "plumb/arith/lattice_digits.hpp"
#include "query/overlap/lattice_points.hpp"

namespace plumb::query {

template <std::size_t N>
class WidePoints {
 public:
  static constexpr std::size_t count = N;
  static constexpr int most_bits = certify::integer::wide_bits.front();
  using Step = WideInt<most_bits + 1>;
  using Numbers = std::array<double, 3 * N>;

  explicit WidePoints(const Numbers& coordinates)
      : coordinates_(coordinates), digits_(coordinates), is_lattice_(digits_.template extend<most_bits>()) {}

  [[nodiscard]] bool is_lattice() const { return is_lattice_; }
  static constexpr int bits(std::size_t) { return most_bits; }
  [[nodiscard]] Step difference(std::size_t from, std::size_t to, std::size_t axis) const {
    return digits_.template difference<most_bits>(3 * to + axis, 3 * from + axis);
  }
  [[nodiscard]] bool is_first(std::size_t i, std::size_t axis) const {
    return coordinates_[3 * i + axis] == coordinates_[axis];
  }
  [[nodiscard]] Sign turn(std::size_t right, std::size_t up, std::size_t i, std::size_t j, std::size_t k) const {
    using predicates::Orient2d;
    const auto at = [&](std::size_t p, std::size_t axis) { return coordinates_[3 * p + axis]; };
    if (const int s = filter<Orient2d>(
            Coordinates<Orient2d>{at(i, right), at(i, up), at(j, right), at(j, up), at(k, right), at(k, up)});
        s != 0)
      return static_cast<Sign>(s);
    return exact_turn(right, up, i, j, k);
  }

 private:
  [[gnu::noinline, gnu::flatten]] Sign exact_turn(std::size_t right, std::size_t up, std::size_t i, std::size_t j,
                                                  std::size_t k) const {
    return (difference(i, j, right) * difference(i, k, up) - difference(i, j, up) * difference(i, k, right)).sign();
  }

  const Numbers& coordinates_;
  LatticeDigits<3 * N, most_bits> digits_;
  bool is_lattice_;
};

}  // namespace plumb::query
