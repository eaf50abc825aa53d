// Random permutations: constraints in an order that nobody has chosen.
//
// Laws: the same of the same seed, on every machine.
// Source: Knuth, TAOCP 3.4.2.
// Cost: a few ns a constraint.
#pragma once

#include <cstdint>
#include <span>
#include <utility>

#include "arith/splitmix.hpp"
#include "plumb/arith/wide_int.hpp"

namespace plumb::query {

template <class Item>
void shuffle(std::span<Item> all, std::uint64_t seed) {
  for (std::size_t i = all.size(); i > 1; --i) {
    std::swap(all[i - 1], all[static_cast<std::size_t>((static_cast<UInt128>(splitmix64(seed)) * i) >> 64)]);
  }
}

}  // namespace plumb::query
