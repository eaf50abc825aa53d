#include "space/broad_phase/pair_order.hpp"

#include <algorithm>
#include <bit>

#include "space/bvh/radix_sort.hpp"

namespace plumb::space {

void sort_pairs(std::vector<BoxPair>& pairs, std::vector<BoxPair>& other) {
  constexpr std::size_t few = 256, short_run = 16;
  if (pairs.size() <= few) return std::sort(pairs.begin(), pairs.end());
  std::uint32_t bits = 0;
  for (const BoxPair& p : pairs) bits |= p.a;
  other.resize(pairs.size());
  radix_sort(Execution::serial, pairs.size(), (std::bit_width(bits) + 10) / 11, pairs, other,
             [](const BoxPair& p) { return p.a; });
  for (std::size_t i = 0; i < pairs.size();) {
    const std::size_t from = i;
    for (++i; i < pairs.size() && pairs[i].a == pairs[from].a;) ++i;
    if (i - from > short_run) {
      std::sort(pairs.data() + from, pairs.data() + i);
      continue;
    }
    for (std::size_t k = from + 1; k < i; ++k) {
      const BoxPair p = pairs[k];
      std::size_t at = k;
      for (; at > from && pairs[at - 1].b > p.b; --at) pairs[at] = pairs[at - 1];
      pairs[at] = p;
    }
  }
}

void strike_off_common(std::vector<BoxPair>& lost, std::vector<BoxPair>& added) {
  std::size_t i = 0, j = 0, only_lost = 0, only_added = 0;
  while (i < lost.size() && j < added.size()) {
    const auto order = lost[i] <=> added[j];
    if (order < 0) {
      lost[only_lost++] = lost[i++];
    } else if (order > 0) {
      added[only_added++] = added[j++];
    } else {
      ++i, ++j;
    }
  }
  while (i < lost.size()) lost[only_lost++] = lost[i++];
  while (j < added.size()) added[only_added++] = added[j++];
  lost.resize(only_lost), added.resize(only_added);
}

}  // namespace plumb::space
