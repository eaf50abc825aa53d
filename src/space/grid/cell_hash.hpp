// At which place of a table of 2^k does a cell lie?
#pragma once

#include "plumb/space/grid/detail/cell_span.hpp"

namespace plumb::space {

inline constexpr std::size_t least_places = 64;

template <std::size_t n>
std::uint64_t hash_of(const CellNumber<n>& cell) {
  constexpr std::uint64_t odd[3] = {0x9E3779B97F4A7C15u, 0xC2B2AE3D27D4EB4Fu, 0x165667B19E3779F9u};
  std::uint64_t hash = 0;
  for (std::size_t k = 0; k < n; ++k) hash += static_cast<std::uint32_t>(cell[k]) * odd[k];
  return hash ^ hash >> 32;  // the upper bits depend on all
}

}  // namespace plumb::space
