// Radix sort: keys in the order of some of their bits, stable, in linear time.
//
// Laws: the order depends on no thread: keys of one digit are placed block by block.
// Source: Knuth, The Art of Computer Programming 3, 5.2.5 (least digit first).
// Cost: a pass for each 11 bits; as much memory as the keys.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "space/bvh/parts.hpp"

namespace plumb::space {

/// Of n keys by the numbers below 2^(11 passes) that bits(key) tells; the other array is for work.
template <class Keys, class Bits>
void radix_sort(Execution execution, std::size_t n, int passes, Keys& keys, Keys& other, const Bits& bits) {
  constexpr std::size_t block_size = 1 << 16, digits = 1 << 11;
  std::vector<std::array<std::uint32_t, digits>> counts(blocks_of(n, block_size));
  for (int pass = 0; pass < passes; ++pass) {
    const auto digit = [&bits, shift = 11 * pass](const auto& key) { return bits(key) >> shift & (digits - 1); };
    for_blocks(execution, n, block_size, [&](std::size_t b, std::size_t from, std::size_t to) {
      counts[b].fill(0);
      for (std::size_t i = from; i < to; ++i) ++counts[b][digit(keys[i])];
    });
    std::uint32_t before = 0;
    for (std::size_t d = 0; d < digits; ++d) {
      for (auto& count : counts) before += std::exchange(count[d], before);
    }
    for_blocks(execution, n, block_size, [&](std::size_t b, std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) other[counts[b][digit(keys[i])]++] = keys[i];
    });
    keys.swap(other);
  }
}

inline void radix_sort_upper(Execution execution, std::vector<std::uint64_t>& keys) {
  std::vector<std::uint64_t> other(keys.size());
  radix_sort(execution, keys.size(), 3, keys, other, [](std::uint64_t key) { return key >> 32; });
}

}  // namespace plumb::space
