#include "plumb/certify/lattice_point.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include "arith/shortest_decimal.hpp"
#include "certify/refused_number.hpp"
#include "plumb/certify/decide.hpp"

namespace plumb {
namespace {

// Exponents where 1.5 * 2^(52 + exponent) would be no double are brought down by so much first.
constexpr int highest_center = 971, lowering = 200;

std::string power_of_two(int exponent) { return std::string("2^").append(std::to_string(exponent)); }

std::string described(const Lattice& lattice) {
  return std::string("multiples of ")
      .append(power_of_two(lattice.exponent))
      .append(" below ")
      .append(power_of_two(lattice.exponent + lattice.bits));
}

// 12 bits of exponent and 12 of bits, with their complement above: as many ones whatever the lattice.
std::uint64_t stamp_of(const Lattice& lattice) {
  const auto code =
      static_cast<std::uint32_t>(lattice.exponent + 1074) << 12 | static_cast<std::uint32_t>(lattice.bits);
  return static_cast<std::uint64_t>(~code) << 32 | code;
}

Lattice lattice_of_stamp(std::uint64_t stamp) {
  return {static_cast<int>(stamp >> 12 & 0xfff) - 1074, static_cast<int>(stamp & 0xfff)};
}

bool on_lattice(double x, const Lattice& lattice) {
  if (!std::isfinite(x)) return false;
  const OddForm f = odd_form(x);
  const int width = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(std::abs(f.mantissa))));
  return f.mantissa == 0 || (f.exponent >= lattice.exponent && f.exponent + width <= lattice.exponent + lattice.bits);
}

std::size_t first_off(std::span<const double> coordinates, const Lattice& lattice) {
  std::size_t i = 0;
  while (i + 1 < coordinates.size() && on_lattice(coordinates[i], lattice)) ++i;
  return i;
}

[[noreturn]] void throw_off(const std::string& place, double x, const Lattice& lattice) {
  throw OffLattice(std::string(place)
                       .append(" is ")
                       .append(arith::shortest_decimal(x))
                       .append(", which the plan's lattice does not hold (")
                       .append(described(lattice))
                       .append("); plan with the lattice of all coordinates"));
}

}  // namespace

LatticeIntake::LatticeIntake(const Lattice& lattice) : lattice_(lattice), stamp_(0) {
  const int end = lattice.exponent + lattice.bits;
  if (lattice.bits < 0 || lattice.exponent < -1074 || lattice.exponent > 1023 || end > 1024) {
    throw Error(std::string("a lattice of exponent ")
                    .append(std::to_string(lattice.exponent))
                    .append(" and ")
                    .append(std::to_string(lattice.bits))
                    .append(" bits holds what no double does; take the lattice of the coordinates (lattice_of)"));
  }
  stamp_ = stamp_of(lattice);
  unit_ = std::ldexp(1.0, lattice.exponent);
  const int half = -lattice.exponent / 2;
  whole_ = {std::ldexp(1.0, half), std::ldexp(1.0, -lattice.exponent - half)};
  // A difference or sum has one bit more than a coordinate.
  reach_exponent_ = lattice.bits + 1;
  const bool as_given = lattice.bits > arith::lattice_word::double_bits;
  if (as_given) reach_exponent_ += lattice.exponent;
  for (std::size_t n = 0; n < reach_.size(); ++n) reach_[n] = reach_power(static_cast<int>(n));
  if (as_given) return;
  const int lowered = lattice.exponent > highest_center ? lowering : 0;
  scale_ = std::ldexp(1.0, -lowered);
  unscale_ = std::ldexp(1.0, lowered);
  center_ = std::ldexp(arith::lattice_word::center, lattice.exponent - lowered);
  rebase_ = arith::lattice_word::center_pattern - std::bit_cast<std::uint64_t>(center_);
}

bool LatticeIntake::holds(double x) const { return on_lattice(x, lattice_); }

double LatticeIntake::reach_power(int n) const {
  const std::int64_t k = std::int64_t{n} * reach_exponent_;
  if (k > 1000) return std::numeric_limits<double>::infinity();  // with room for sums of products
  return k < -1000 ? 0 : std::ldexp(1.0, static_cast<int>(k));
}

void LatticeIntake::refuse(std::string_view formula, std::span<const int> arguments,
                           std::span<const double> coordinates) const {
  for (const double x : coordinates) {
    if (!std::isfinite(x)) throw_non_finite(formula, arguments, coordinates);
  }
  const std::size_t i = first_off(coordinates, lattice_);
  throw_off(std::string(formula).append(": ").append(place_of(i, arguments)), coordinates[i], lattice_);
}

void LatticeIntake::refuse_point(std::size_t index, std::span<const double> coordinates) const {
  const std::string name = std::string("point ").append(std::to_string(index));
  const int count = static_cast<int>(coordinates.size());
  refuse(name, {&count, 1}, coordinates);
}

void LatticeIntake::refuse_stamp(std::string_view formula, std::span<const std::uint64_t> stamps) const {
  std::size_t i = 0;
  while (i + 1 < stamps.size() && stamps[i] == stamp_) ++i;
  std::string text(formula);
  text.append(": argument ").append(1, static_cast<char>('a' + i % 26));
  if (stamps[i] == 0) {
    text.append(" was never taken in; make it by kernel.point");
  } else {
    text.append(" was taken in by the kernel of another lattice (")
        .append(described(lattice_of_stamp(stamps[i])))
        .append("), not of this one (")
        .append(described(lattice_))
        .append(")");
  }
  throw OffLattice(text);
}

}  // namespace plumb
