// Work on pairs of nodes, cut into parts whose number depends on the trees alone.
#pragma once

#include <vector>

#include "plumb/space/bvh/descend_pairs.hpp"

namespace plumb::space {

/// Pairs of nodes that take the place of the two roots, of those that meet: so many or more, as far as
/// there are.  replace(pair, take) says what a pair is replaced by.
template <class As, class Bs, class Replace, class Meets>
auto pair_parts(const As& as, const Bs& bs, std::size_t wanted, const Replace& replace, const Meets& meets) {
  const PlacePair roots{root_place(as), root_place(bs)};
  using Pair = std::remove_const_t<decltype(roots)>;
  std::vector<Pair> now, next;
  if (!as.empty() && !bs.empty() && meets(as[roots.a], bs[roots.b])) now.push_back(roots);
  for (bool any = true; any && now.size() < wanted; now.swap(next)) {
    any = false;
    next.clear();
    for (const Pair& pair : now) {
      if (as[pair.a].is_leaf() && bs[pair.b].is_leaf()) {
        next.push_back(pair);
        continue;
      }
      any = true;
      replace(pair, [&](const Pair& p) {
        if (meets(as[p.a], bs[p.b])) next.push_back(p);
      });
    }
  }
  return now;
}

}  // namespace plumb::space
