// What is asked of a search of pairs: all in order, how many, or any?
//
// A search has run(execution, begin, take, wanted): begin(n), then take(part, pair, slots) for each pair, from several
// threads, with parts below n, as many as are wanted or about that; else as many as serve threads.  The answers do not
// depend on them.
#pragma once

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

#include "plumb/space/bvh/descend.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"
#include "space/bvh/slot_triangles.hpp"
#include "space/pairs/leaf_pairs.hpp"

namespace plumb::space {

/// By a, then b, each once: a triangle may be in several slots.  In linear time where there are many.  The parts are
/// given up.
inline std::vector<TrianglePair> in_order(std::vector<std::vector<TrianglePair>> parts, std::size_t triangles_a,
                                          std::vector<TrianglePair> sorted = {}) {
  sorted.clear();
  const auto before = [](const TrianglePair& p, const TrianglePair& q) { return p.a != q.a ? p.a < q.a : p.b < q.b; };
  std::size_t n = 0;
  for (const auto& part : parts) n += part.size();
  const auto drop_repeated = [&] {
    const auto is_same = [](const TrianglePair& p, const TrianglePair& q) { return p.a == q.a && p.b == q.b; };
    sorted.erase(std::unique(sorted.begin(), sorted.end(), is_same), sorted.end());
  };
  if (n < triangles_a / 8) {
    for (const auto& part : parts) sorted.insert(sorted.end(), part.begin(), part.end());
    std::sort(sorted.begin(), sorted.end(), before);
    drop_repeated();
    return sorted;
  }
  std::vector<std::size_t> place(triangles_a + 1);
  for (const auto& part : parts) {
    for (const TrianglePair& p : part) ++place[p.a + 1];
  }
  std::partial_sum(place.begin(), place.end(), place.begin());
  sorted.resize(n);
  for (auto& part : parts) {
    for (const TrianglePair& p : part) sorted[place[p.a]++] = p;
    std::vector<TrianglePair>().swap(part);
  }
  for (auto from = sorted.begin(); from != sorted.end();) {
    const auto to = std::find_if(from, sorted.end(), [&](const TrianglePair& p) { return p.a != from->a; });
    std::sort(from, to, before);
    from = to;
  }
  drop_repeated();
  return sorted;
}

/// Of a mesh with at most so many triangles.
template <class Search>
std::vector<TrianglePair> all_pairs(Search search, std::size_t triangles_a, Execution execution,
                                    std::vector<TrianglePair> rows = {}) {
  std::vector<std::vector<TrianglePair>> found;
  search.run(
      execution, [&](std::size_t parts) { found.resize(parts); },
      [&](std::size_t part, const TrianglePair& pair, SlotPair) {
        found[part].push_back(pair);
        return Descent::go_on;
      });
  return in_order(std::move(found), triangles_a, std::move(rows));
}

/// With `are_split` the search may come to one pair several times.
template <class Search>
PairCount counted_pairs(Search search, bool are_split, Execution execution) {
  if (are_split) {
    PairCount count;
    for (const TrianglePair& pair : all_pairs(std::move(search), std::numeric_limits<std::size_t>::max(), execution)) {
      ++(pair.relation == Relation::touching ? count.touching : count.overlapping);
    }
    return count;
  }
  std::vector<PairCount> found;
  search.run(
      execution, [&](std::size_t parts) { found.resize(parts); },
      [&](std::size_t part, const TrianglePair& pair, SlotPair) {
        ++(pair.relation == Relation::touching ? found[part].touching : found[part].overlapping);
        return Descent::go_on;
      });
  PairCount all;
  for (const PairCount& part : found) all.touching += part.touching, all.overlapping += part.overlapping;
  return all;
}

/// So many parts, before which progress may stop it; of more pairs of nodes most would be found for nothing.
inline constexpr std::size_t parts_of_any = 16;

/// The first that the search comes to on one thread, and where that is.
template <class Search>
std::optional<TrianglePair> any_pair(Search search, SlotPair* at = nullptr) {
  std::optional<TrianglePair> found;
  search.run(
      Execution::serial, [](std::size_t) {},
      [&](std::size_t, const TrianglePair& pair, SlotPair slots) {
        found = pair;
        if (at) *at = slots;
        return Descent::stop;
      },
      parts_of_any);
  return found;
}

}  // namespace plumb::space
