// Work on pairs of nodes, cut into parts whose number depends on the trees alone.
#pragma once

#include <vector>

#include "plumb/space/bvh/descend_pairs.hpp"

namespace plumb::space {

/// Pairs of nodes that take the place of the two roots, of those that meet: so many or more, as far as
/// there are.  replace(pair, take) says what a pair is replaced by.
template <class A, class B, class Replace, class Meets>
std::vector<NodePair> pair_parts(std::span<const A> as, std::span<const B> bs, std::size_t wanted,
                                 const Replace& replace, const Meets& meets) {
  std::vector<NodePair> now, next;
  if (!as.empty() && !bs.empty() && meets(as[0], bs[0])) now.push_back({0, 0});
  for (bool any = true; any && now.size() < wanted; now.swap(next)) {
    any = false;
    next.clear();
    for (const NodePair pair : now) {
      if (as[pair.a].is_leaf() && bs[pair.b].is_leaf()) {
        next.push_back(pair);
        continue;
      }
      any = true;
      replace(pair, [&](NodePair p) {
        if (meets(as[p.a], bs[p.b])) next.push_back(p);
      });
    }
  }
  return now;
}

}  // namespace plumb::space
