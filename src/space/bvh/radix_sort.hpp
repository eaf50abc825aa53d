// Keys in the order of their upper halves, stable, in linear time.
//
// Laws: the order depends on no thread: keys of one digit are placed block by block.
// Source: Knuth, The Art of Computer Programming 3, 5.2.5 (least digit first).
// Cost: three passes; as much memory as the keys.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "space/bvh/blocks.hpp"

namespace plumb::space {

inline void radix_sort_upper(Execution execution, std::vector<std::uint64_t>& keys) {
  constexpr std::size_t block_size = 1 << 16, digits = 1 << 11;
  std::vector<std::uint64_t> other(keys.size());
  std::vector<std::array<std::uint32_t, digits>> counts(blocks_of(keys.size(), block_size));
  for (const unsigned shift : {32u, 43u, 54u}) {
    const auto digit = [shift](std::uint64_t key) { return key >> shift & (digits - 1); };
    for_blocks(execution, keys.size(), block_size, [&](std::size_t b, std::size_t from, std::size_t to) {
      counts[b].fill(0);
      for (std::size_t i = from; i < to; ++i) ++counts[b][digit(keys[i])];
    });
    std::uint32_t before = 0;
    for (std::size_t d = 0; d < digits; ++d) {
      for (auto& count : counts) before += std::exchange(count[d], before);
    }
    for_blocks(execution, keys.size(), block_size, [&](std::size_t b, std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) other[counts[b][digit(keys[i])]++] = keys[i];
    });
    keys.swap(other);
  }
}

}  // namespace plumb::space
