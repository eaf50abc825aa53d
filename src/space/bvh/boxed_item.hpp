// What do builders sort?  Items with their boxes, in the numbers of the tree's frame, two rows of four lanes each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "plumb/space/bvh/box_tree.hpp"

namespace plumb::space {

// The lanes that every processor of the kind has: the same tree everywhere, and nothing to choose at run time.
using Lanes = float __attribute__((vector_size(16)));
using IntLanes = std::int32_t __attribute__((vector_size(16)));

struct alignas(16) BoxedItem {
  std::array<float, 3> min;
  std::uint32_t item;
  std::array<float, 3> max;
  std::uint32_t unused;

  [[nodiscard]] Lanes low() const { return row(0); }
  [[nodiscard]] Lanes high() const { return row(sizeof(Lanes)); }
  [[nodiscard]] float twice_middle(std::size_t axis) const { return min[axis] + max[axis]; }

 private:
  [[nodiscard]] Lanes row(std::size_t at) const {
    Lanes lanes;
    std::memcpy(&lanes, reinterpret_cast<const std::byte*>(this) + at, sizeof lanes);
    return lanes;
  }
};

/// Middles that spread less along an axis are not told apart along it: a guess, which shapes trees and decides nothing;
/// so large that a number of cells over it is a float.
inline constexpr float flat_spread = 1e-30F;

/// Twice the middle; the last lane is 0, whatever lies there.
inline Lanes twice_middle(Lanes low, Lanes high) {
  return reinterpret_cast<Lanes>(reinterpret_cast<IntLanes>(low + high) & IntLanes{-1, -1, -1, 0});
}

/// The least box or interval of what was taken in; empty at first.
struct Extent {
  static constexpr float infinity = std::numeric_limits<float>::infinity();
  Lanes low = {infinity, infinity, infinity, infinity};
  Lanes high = {-infinity, -infinity, -infinity, -infinity};

  void take(Lanes from, Lanes to) {
    low = from < low ? from : low;
    high = to > high ? to : high;
  }
  void take(const Extent& other) { take(other.low, other.high); }
};

/// Half the surface: a guess in floats, for the heuristic alone.
inline float half_area(const Extent& e) {
  const Lanes d = e.high - e.low;
  return d[0] * (d[1] + d[2]) + d[1] * d[2];
}

inline float half_area(const BoxNode& n) {
  const float x = n.max[0] - n.min[0], y = n.max[1] - n.min[1], z = n.max[2] - n.min[2];
  return x * (y + z) + y * z;
}

inline FloatBox3 box_of(const Extent& e) { return {{e.low[0], e.low[1], e.low[2]}, {e.high[0], e.high[1], e.high[2]}}; }

inline BoxNode node_of(const Extent& e, std::uint32_t link, std::uint32_t count) {
  const FloatBox3 box = box_of(e);
  return {box.min, link, box.max, count};
}

}  // namespace plumb::space
