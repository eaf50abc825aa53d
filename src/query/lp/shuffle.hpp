// Random permutations: constraints in an order that nobody has chosen.
//
// Laws: the same of the same seed, on every machine.
// Source: Knuth, TAOCP 3.4.2; Steele, Lea and Flood 2014 (splitmix64).
// Cost: a few ns a constraint.
#pragma once

#include <cstdint>
#include <span>
#include <utility>

#include "plumb/arith/wide_int.hpp"

namespace plumb::query {

template <class Item>
void shuffle(std::span<Item> all, std::uint64_t seed) {
  for (std::size_t i = all.size(); i > 1; --i) {
    seed += 0x9e3779b97f4a7c15;
    std::uint64_t z = seed;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    std::swap(all[i - 1], all[static_cast<std::size_t>((static_cast<UInt128>(z ^ (z >> 31)) * i) >> 64)]);
  }
}

}  // namespace plumb::query
