// Pairs as they were found, part by part: all of them, ascending by a, then by b.
//
// Source: Knuth, The Art of Computer Programming 3, 5.2.5 (least digit first: here a digit is a number).
// Cost: four passes over the pairs, and two over the numbers; twice the memory of the pairs.
#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "plumb/space/pairs/box_pair.hpp"

namespace plumb::space {

/// Of numbers below `numbers`; the parts are given up.
inline std::vector<BoxPair> pairs_in_order(std::vector<std::vector<BoxPair>>& parts, std::size_t numbers,
                                           std::vector<BoxPair> pairs = {}) {
  pairs.clear();
  std::size_t count = 0;
  for (const auto& part : parts) count += part.size();
  if (count < numbers / 8) {
    pairs.reserve(count);
    for (const auto& part : parts) pairs.insert(pairs.end(), part.begin(), part.end());
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }
  std::vector<std::size_t> begin(numbers);
  const auto begin_by = [&](auto&& number, std::span<const std::vector<BoxPair>> of) {
    std::fill(begin.begin(), begin.end(), std::size_t{0});
    for (const auto& part : of) {
      for (const BoxPair& p : part) ++begin[number(p)];
    }
    std::size_t before = 0;
    for (std::size_t& b : begin) before += std::exchange(b, before);
  };
  std::vector<BoxPair> by_b(count);
  begin_by([](const BoxPair& p) { return p.b; }, parts);
  for (auto& part : parts) {
    for (const BoxPair& p : part) by_b[begin[p.b]++] = p;
    part = {};
  }
  parts.assign(1, std::move(by_b));
  pairs.resize(count);
  begin_by([](const BoxPair& p) { return p.a; }, parts);
  for (const BoxPair& p : parts[0]) pairs[begin[p.a]++] = p;
  return pairs;
}

}  // namespace plumb::space
