// Items with keys, in the order of the keys, those of one key by number.
//
// Laws: the order depends on no thread: keys of one digit are placed block by block.
// Source: Knuth, The Art of Computer Programming 3, 5.2.5.
// Cost: two or three passes over all, and a sort of those that 22 or 33 bits do not tell apart; as much memory as the
// items.
#pragma once

#include <cstdint>
#include <span>

#include "plumb/certify/batch.hpp"

namespace plumb::space {

struct KeyedItem {
  std::uint64_t key;
  std::uint32_t item;
};

/// The items ascend when they are given.
void sort_by_key(Execution execution, std::span<KeyedItem> items);

}  // namespace plumb::space
