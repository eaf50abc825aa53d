// The ordinals of a set of boxes, sorted along an axis from scratch.
//
// Cost: some 20 ns a box.
#pragma once

#include <memory>

#include "space/sort_and_sweep/ordinal_map.hpp"
#include "space/sort_and_sweep/radix_order.hpp"

namespace plumb::space {

/// Of ordinals along the axis of the sweep: as few as two passes of the sort take, where boxes are few.
constexpr int swept_bits(std::size_t n) { return n <= (1u << 20) ? 22 : ordinal_bits; }

/// Ascending by low[0]; of equal ones in the order of the set.  The map's bits of axis 0 are swept_bits(set.size()).
template <class Box>
std::unique_ptr<OrdinalBox[]> sorted_ordinals(Execution execution, const BoxSet<Box>& set, const OrdinalMap& map) {
  constexpr std::size_t block_size = 1 << 15;
  const std::size_t n = set.size();
  auto keys = std::make_unique_for_overwrite<NumberedKey[]>(n),
       other = std::make_unique_for_overwrite<NumberedKey[]>(n);
  for_blocks(execution, n, block_size, [&](std::size_t, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) keys[i] = {map.start(set[i]), static_cast<std::uint32_t>(i)};
  });
  radix_sort(execution, n, swept_bits(n) > 22 ? 3 : 2, keys, other);
  other.reset();
  auto sorted = std::make_unique_for_overwrite<OrdinalBox[]>(n);
  const bool is_two = !set.b.empty();
  for_blocks(execution, n, block_size, [&](std::size_t, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      const std::size_t k = keys[i].number;
      sorted[i] = map(set[k], k, !is_two ? 0 : k < set.a.size() ? of_first_set : of_second_set);
    }
  });
  return sorted;
}

}  // namespace plumb::space
