// Which edges do rings of points have?  Edge i leaves point i.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace plumb::surface {

inline std::vector<std::array<std::uint32_t, 2>> ring_edges(std::span<const std::uint32_t> first) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  edges.reserve(first.back());
  for (std::size_t r = 0; r + 1 < first.size(); ++r)
    for (std::uint32_t i = first[r]; i < first[r + 1]; ++i)
      edges.push_back({i, i + 1 == first[r + 1] ? first[r] : i + 1});
  return edges;
}

}  // namespace plumb::surface
