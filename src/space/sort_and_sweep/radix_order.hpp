// Radix sort: numbers in the order of keys of 22 or 33 bits, stable, in linear time.
//
// Laws: the order depends on no thread: keys of one digit are placed block by block.
// Source: RTCD 7.5.2; Knuth, The Art of Computer Programming 3, 5.2.5 (least digit first).
// Cost: two or three passes.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "space/bvh/blocks.hpp"

namespace plumb::space {

struct NumberedKey {
  std::uint32_t key, number;
};

/// Of n keys below 2^(11 passes); the other array is for work.
inline void radix_sort(Execution execution, std::size_t n, int passes, std::unique_ptr<NumberedKey[]>& keys,
                       std::unique_ptr<NumberedKey[]>& other) {
  constexpr std::size_t block_size = 1 << 16, digits = 1 << 11;
  std::vector<std::array<std::uint32_t, digits>> counts(blocks_of(n, block_size));
  for (int pass = 0; pass < passes; ++pass) {
    const auto digit = [shift = 11 * pass](const NumberedKey& k) { return k.key >> shift & (digits - 1); };
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

}  // namespace plumb::space
