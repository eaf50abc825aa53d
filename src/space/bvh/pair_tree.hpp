// A tree made from the items up: pairs of pairs.  How does it become nodes in depth-first order?
//
// Laws: small pairs become leaves where the surface-area heuristic says so; what would be deeper than trees may be is
// made anew in halves.
// Cost: linear, but for what is too deep.
#pragma once

#include <array>
#include <span>

#include "space/bvh/builders.hpp"

namespace plumb::space {

/// Of n items: clusters 0, ..., n - 1 are the items, n + i is pairs[i], whose parts come before it; the last is the root.
struct PairTree {
  std::span<const BoxedItem> items;
  std::vector<std::array<std::uint32_t, 2>> pairs;

  [[nodiscard]] std::uint32_t root() const { return static_cast<std::uint32_t>(items.size() + pairs.size() - 1); }
};

Built lay_out(const PairTree& tree, const BvhOptions& options);

}  // namespace plumb::space
