// Pairs of triangles in their order: by a, then b.
//
// Cost: linear where there are many.
#pragma once

#include <algorithm>
#include <numeric>

#include "plumb/space/pairs/mesh_pairs.hpp"

namespace plumb::space {

inline void sort_pairs(std::vector<TrianglePair>& pairs, std::size_t triangles_a) {
  const auto before = [](const TrianglePair& p, const TrianglePair& q) { return p.a != q.a ? p.a < q.a : p.b < q.b; };
  if (pairs.size() < triangles_a / 8) return std::sort(pairs.begin(), pairs.end(), before);
  std::vector<std::size_t> place(triangles_a + 1);
  for (const TrianglePair& p : pairs) ++place[p.a + 1];
  std::partial_sum(place.begin(), place.end(), place.begin());
  std::vector<TrianglePair> sorted(pairs.size());
  for (const TrianglePair& p : pairs) sorted[place[p.a]++] = p;
  for (auto from = sorted.begin(); from != sorted.end();) {
    const auto to = std::find_if(from, sorted.end(), [&](const TrianglePair& p) { return p.a != from->a; });
    std::sort(from, to, before);
    from = to;
  }
  pairs.swap(sorted);
}

}  // namespace plumb::space
