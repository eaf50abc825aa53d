// Which feature of a box lies where these of its faces meet?
//
// Law: an axis that is at both ends is at the lower one.
// Source: the numbers of figure/containment/voronoi_region.hpp.
#pragma once

#include <cstdint>
#include <span>

#include "plumb/figure/containment/voronoi_region.hpp"

namespace plumb::query {

/// Of faces, ascending, at least one.
inline Feature box_feature(std::span<const std::uint32_t> faces) {
  std::uint32_t fixed = 0, upper = 0, axes = 0, free = 0;  // bits
  for (const std::uint32_t face : faces) {
    const std::uint32_t bit = 1u << face / 2;
    if ((fixed & bit) != 0) continue;
    fixed |= bit;
    upper |= (face & 1u) != 0 ? bit : 0;
    ++axes;
  }
  if (axes == 3) return {FeatureKind::vertex, upper};
  if (axes == 1) return {FeatureKind::face, faces[0]};
  while ((fixed >> free & 1u) != 0) ++free;
  const std::uint32_t v = free == 0 ? 1 : 0, w = 3 - free - v;
  return {FeatureKind::edge, 4 * free + (upper >> v & 1u) + 2 * (upper >> w & 1u)};
}

}  // namespace plumb::query
