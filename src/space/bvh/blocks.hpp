// Work cut into blocks whose number depends on the work alone, so that what is put together from them does as well.
#pragma once

#include <algorithm>
#include <cstddef>

#include "certify/batch/all_threads.hpp"

namespace plumb::space {

inline std::size_t blocks_of(std::size_t n, std::size_t size) { return (n + size - 1) / size; }

/// Calls work(block, from, to) for each block of `size` of n.
template <class Work>
void for_blocks(Execution execution, std::size_t n, std::size_t size, const Work& work) {
  certify::batch::for_each_part(execution, blocks_of(n, size),
                                [&](std::size_t b) { work(b, b * size, std::min(n, (b + 1) * size)); });
}

}  // namespace plumb::space
