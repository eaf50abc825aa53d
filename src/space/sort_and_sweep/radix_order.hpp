// Numbers in the order of keys of 22 or 33 bits.
//
// Laws: those of space/bvh/radix_sort.hpp.
// Source: RTCD 7.5.2.
// Cost: two or three passes.
#pragma once

#include <memory>

#include "space/bvh/radix_sort.hpp"

namespace plumb::space {

struct NumberedKey {
  std::uint32_t key, number;
};

inline void radix_sort(Execution execution, std::size_t n, int passes, std::unique_ptr<NumberedKey[]>& keys,
                       std::unique_ptr<NumberedKey[]>& other) {
  radix_sort(execution, n, passes, keys, other, [](const NumberedKey& k) { return k.key; });
}

}  // namespace plumb::space
