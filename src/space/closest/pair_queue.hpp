// Pairs of nodes that wait to be looked at: that of the least bound first, of equal ones the deeper.
//
// Source: RTCD 6.3.2.
#pragma once

#include <queue>
#include <vector>

#include "plumb/space/bvh/descend_pairs.hpp"

namespace plumb::space {

struct NearPair {
  double bound;
  NodePair pair;
};

struct FartherPair {
  bool operator()(const NearPair& x, const NearPair& y) const {
    return x.bound != y.bound ? x.bound > y.bound : x.pair.a != y.pair.a ? x.pair.a < y.pair.a : x.pair.b < y.pair.b;
  }
};

using PairQueue = std::priority_queue<NearPair, std::vector<NearPair>, FartherPair>;

}  // namespace plumb::space
