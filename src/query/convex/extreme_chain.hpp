// Convex hull in the plane: which of ascending points are extreme?
//
// Laws: counterclockwise from the first, where turns_left(i, j, k) says whether points i, j, k turn so, as exactly as it
// is told.
// Source: Andrew 1979.
// Cost: two turns a point.
#pragma once

#include <cstddef>
#include <vector>

namespace plumb::query {

template <class TurnsLeft>
std::vector<std::size_t> extreme_chain(std::size_t count, const TurnsLeft& turns_left) {
  std::vector<std::size_t> chain;
  const auto add = [&](std::size_t i, std::size_t keep) {
    while (chain.size() > keep && !turns_left(chain[chain.size() - 2], chain.back(), i)) chain.pop_back();
    chain.push_back(i);
  };
  for (std::size_t i = 0; i < count; ++i) add(i, 1);
  const std::size_t lower = chain.size();
  for (std::size_t i = count - 1; i-- > 0;) add(i, lower);
  chain.pop_back();
  return chain;
}

}  // namespace plumb::query
