// Morton keys: a number by which cells of all levels lie in the order of a walk through the tree.
//
// The code of a cell, a 1 behind it, and zeros until it is as long as that of the deepest level: so a cell's key lies
// between those of what is in its lower half and those of what is in its upper half.
// Laws: (1) key_of(place, level) ascends with the codes of cells of one level.  (2) The keys of all cells in child c of
// a cell are in [first_key(c), first_key(c + 1)); its own is first_key of the child in the middle.
// Source: Morton 1966; RTCD 7.3.4, 7.3.5.
// Cost: some 15 operations an axis.
#pragma once

#include "plumb/space/octree/cell_frame.hpp"

namespace plumb::space {

/// Bits of which each third, or second, is one of x's.
template <std::size_t D>
constexpr std::uint64_t spread(std::uint64_t x) {
  if constexpr (D == 2) {
    x = (x | x << 16) & 0x0000ffff0000ffff;
    x = (x | x << 8) & 0x00ff00ff00ff00ff;
    x = (x | x << 4) & 0x0f0f0f0f0f0f0f0f;
    x = (x | x << 2) & 0x3333333333333333;
    return (x | x << 1) & 0x5555555555555555;
  } else {
    x = (x | x << 32) & 0x001f00000000ffff;
    x = (x | x << 16) & 0x001f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
  }
}

/// Of the least cell at this place: D bits a level.
template <std::size_t D>
constexpr std::uint64_t interleaved(const typename CellFrame<D>::Place& place) {
  std::uint64_t code = 0;
  for (std::size_t axis = 0; axis < D; ++axis) code |= spread<D>(place[axis]) << axis;
  return code;
}

/// Of the cell of this level that holds the place.
template <std::size_t D>
constexpr std::uint64_t key_of(const typename CellFrame<D>::Place& place, unsigned level) {
  const unsigned below = static_cast<unsigned>(D) * (CellFrame<D>::levels - level);
  return ((interleaved<D>(place) >> below) << 1 | 1) << below;
}

/// Of a cell with this code, and a 1 before it, of this level.
template <std::size_t D>
constexpr std::uint64_t first_key(std::uint64_t code, unsigned level) {
  const unsigned below = static_cast<unsigned>(D) * (CellFrame<D>::levels - level);
  return (code ^ std::uint64_t{1} << D * level) << 1 << below;
}

}  // namespace plumb::space
