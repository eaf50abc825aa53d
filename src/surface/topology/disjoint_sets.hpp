// Disjoint sets, union-find: which of n things have been found to belong together?
//
// Law: the representative of a set is its smallest member, in whatever order sets were united.
// Source: Tarjan 1975, with halving of paths.
// Cost: all but constant a step.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace plumb::surface {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : above_(n) { std::iota(above_.begin(), above_.end(), 0U); }

  std::uint32_t find(std::uint32_t i) {
    while (above_[i] != i) i = above_[i] = above_[above_[i]];
    return i;
  }
  void unite(std::uint32_t i, std::uint32_t k) {
    i = find(i), k = find(k);
    above_[std::max(i, k)] = std::min(i, k);
  }

 private:
  std::vector<std::uint32_t> above_;
};

}  // namespace plumb::surface
