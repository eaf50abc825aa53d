// Figures that are degenerate, or one unit from it, on lattices of every width and scale, one for each axis.
//
// Points of a plane (in the plane: of a line) through three (two) random ones, by small multiples of their differences;
// then one coordinate of one point may be moved by a unit.
#pragma once

#include <cmath>

#include "query/overlap/relation_counts.hpp"

namespace plumb {

template <std::size_t Count, std::size_t Dimension>
std::array<double, Count * Dimension> flat_lattice(std::uint64_t start, std::uint64_t index) {
  Entropy entropy(start, index);
  std::array<double, Count * Dimension> all{};
  std::array<std::array<std::int64_t, 2>, Count> multiples{};
  for (auto& m : multiples) m = {entropy.within(2), Dimension == 3 ? entropy.within(2) : 0};
  const std::size_t moved = entropy.coin() ? static_cast<std::size_t>(entropy.below(all.size())) : all.size();
  for (std::size_t axis = 0; axis < Dimension; ++axis) {
    // 50 bits of mantissa and three for the multiples; the lattice is wider where the base is odd and far.
    const int bits = 1 + static_cast<int>(entropy.below(50)), far = static_cast<int>(entropy.below(12));
    const int exponent = static_cast<int>(entropy.coin() ? entropy.within(300) : entropy.within(3));
    const auto most = (std::int64_t{1} << bits) - 1;
    const std::int64_t base = entropy.within(most), u = entropy.within(most), v = entropy.within(most);
    for (std::size_t i = 0; i < Count; ++i) {
      const std::int64_t x = base + multiples[i][0] * u + multiples[i][1] * v + (Dimension * i + axis == moved ? 1 : 0);
      all[Dimension * i + axis] = std::ldexp(static_cast<double>(x), exponent + (entropy.below(8) == 0 ? far : 0));
    }
  }
  return all;
}

/// relate of two figures made of such points against the oracle.
template <class A, class B, std::size_t Dimension>
void expect_as_oracle_on_lattices(std::uint64_t start, std::uint64_t cases) {
  constexpr std::size_t numbers = (sizeof(A) + sizeof(B)) / sizeof(double);
  struct Both {
    A a;
    B b;
  };
  Counts counts;
  for (std::uint64_t index = 0; index < cases * shape_cases::more; ++index) {
    const auto [a, b] = std::bit_cast<Both>(flat_lattice<numbers / Dimension, Dimension>(start, index));
    const Relation expected = oracle::rational_relation(a, b);
    counts.add(expected);
    ASSERT_EQ(relate(a, b), expected) << "start " << start << " index " << index;
  }
  std::printf("disjoint %d, touching %d, overlapping %d\n", counts.of[0], counts.of[1], counts.of[2]);
  expect_all_answers(counts, cases * shape_cases::more);
}

}  // namespace plumb
