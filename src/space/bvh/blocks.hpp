// Work cut into blocks whose number depends on the work alone, so that what is put together from them does as well.
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

#include "plumb/certify/batch.hpp"

namespace plumb::space {

inline std::size_t blocks_of(std::size_t n, std::size_t size) { return (n + size - 1) / size; }

/// Calls work(block, from, to) for each block of `size` of n.
template <class Work>
void for_blocks(Execution execution, std::size_t n, std::size_t size, const Work& work) {
  const std::size_t blocks = blocks_of(n, size);
  const auto one = [&](std::size_t b) { work(b, b * size, std::min(n, (b + 1) * size)); };
  if (execution == Execution::parallel && blocks > 1) {
    tbb::parallel_for(std::size_t{0}, blocks, one);
  } else {
    for (std::size_t b = 0; b < blocks; ++b) one(b);
  }
}

}  // namespace plumb::space
