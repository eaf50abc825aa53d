// Does a coordinate lie on the lattice of a plan, and how is it kept there?  Points checked once, when they are taken
// in.
//
// Laws: a LatticePoint is made by LatticeIntake alone and stands for exactly the coordinates given (-0.0 for 0); its
// stamp tells its lattice, so that points of unequal lattices are never taken for each other.  What is off the lattice
// throws OffLattice, NaN and infinity throw NonFinite, both naming the coordinate.
// Source: RTCD 11.5.1, docs/plans.md.
// Cost: 6 operations a coordinate up to 51 bits, a few ns beyond.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "plumb/arith/error.hpp"
#include "plumb/arith/filtered.hpp"
#include "plumb/arith/lattice.hpp"
#include "plumb/arith/lattice_word.hpp"

namespace plumb {

/// A coordinate is no multiple of the lattice's power of two, or too large, or was taken in by another lattice.
struct OffLattice : Error {
  using Error::Error;
};

/// N coordinates on a lattice; nothing of any lattice where it is made by default.
template <std::size_t N>
class LatticePoint {
 public:
  LatticePoint() = default;
  friend bool operator==(const LatticePoint&, const LatticePoint&) = default;

  /// The coordinate as its lattice keeps it: arith::lattice_word::of up to 51 bits, the double's pattern beyond.
  [[nodiscard]] constexpr const std::array<std::uint64_t, N>& words() const { return word_; }
  [[nodiscard]] constexpr std::uint64_t stamp() const { return stamp_; }

 private:
  friend class LatticeIntake;
  std::array<std::uint64_t, N> word_{};
  std::uint64_t stamp_ = 0;
};

class LatticeIntake {
 public:
  /// Throws Error for an exponent below -1074 or coordinates beyond the largest double.
  explicit LatticeIntake(const Lattice& lattice);

  [[nodiscard]] const Lattice& lattice() const { return lattice_; }

  /// Half of its bits are ones, and no other lattice has the same: the AND of stamps is this stamp when all are.
  [[nodiscard]] std::uint64_t stamp() const { return stamp_; }

  /// false: off the lattice, or not finite.
  template <std::size_t N>
  [[nodiscard]] bool take(const std::array<double, N>& coordinates, LatticePoint<N>& point) const {
    point.stamp_ = stamp_;
    if (lattice_.bits <= arith::lattice_word::double_bits) return take_doubles(coordinates, point.word_);
    bool on = true;
    for (std::size_t i = 0; i < N; ++i) {
      on &= holds(coordinates[i]);
      point.word_[i] = std::bit_cast<std::uint64_t>(coordinates[i]);
    }
    return on;
  }

  /// The double that a word of this lattice stands for.
  [[nodiscard]] double given(std::uint64_t word) const {
    if (lattice_.bits > arith::lattice_word::double_bits) return std::bit_cast<double>(word);
    return static_cast<double>(arith::lattice_word::integer(word)) * unit_;
  }

  /// No difference, sum or coordinate is beyond this in magnitude, in what words stand for as doubles; to the power N,
  /// which is infinite where a sum of such products might be, and 0 where it may underflow.
  template <int N>
  [[nodiscard]] double reach_to() const {
    if constexpr (N < reach_powers) return reach_[N];
    return reach_power(N);
  }

  /// The integer of a coordinate given, of lattices up to 62 bits.
  [[nodiscard]] std::int64_t integer(double x) const { return static_cast<std::int64_t>(x * whole_[0] * whole_[1]); }

  /// Throws what is wrong with coordinates that `take` refused, of these arguments of a formula.
  [[noreturn]] void refuse(std::string_view formula, std::span<const int> arguments,
                           std::span<const double> coordinates) const;
  /// The same for point number `index`.
  [[noreturn]] void refuse_point(std::size_t index, std::span<const double> coordinates) const;
  /// Throws for the first of these stamps that is another lattice's.
  [[noreturn]] void refuse_stamp(std::string_view formula, std::span<const std::uint64_t> stamps) const;

 private:
  template <std::size_t N>
  bool take_doubles(const std::array<double, N>& coordinates, std::array<std::uint64_t, N>& words) const {
    const std::uint64_t largest = (1ull << lattice_.bits) - 1;
    std::uint64_t off = 0;  // integers throughout, which compilers vectorize
    for (std::size_t i = 0; i < N; ++i) {
      const double x = coordinates[i], moved = x * scale_ + center_;  // rounds to a multiple of the lattice
      off |= std::bit_cast<std::uint64_t>((moved - center_) * unscale_ - x);
      words[i] = std::bit_cast<std::uint64_t>(moved) + rebase_;
      const std::uint64_t m = words[i] - arith::lattice_word::center_pattern;
      off |= (largest + m) >> (lattice_.bits + 1) | (largest - m) >> (lattice_.bits + 1);
    }
    return off == 0;
  }
  static constexpr int reach_powers = 6;  // are kept

  [[nodiscard]] bool holds(double x) const;
  [[nodiscard]] double reach_power(int n) const;

  Lattice lattice_;
  std::uint64_t stamp_, rebase_ = 0;
  int reach_exponent_ = 0;
  std::array<double, reach_powers> reach_{};
  double scale_ = 1, unscale_ = 1, center_ = 0, unit_ = 0;
  std::array<double, 2> whole_{};  // their product makes coordinates integers, and may itself be no double
};

}  // namespace plumb
