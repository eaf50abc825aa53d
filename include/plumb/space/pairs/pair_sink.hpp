// Broad phase: where do the pairs of boxes go?  To a vector, to a function of yours, or into memory that is there.
//
//   std::vector<BoxPair> pairs;
//   overlapping_pairs(boxes, BoxPairSink(pairs));                        // appended
//   auto use = [&](std::span<const BoxPair> block) { ... };
//   overlapping_pairs(boxes, BoxPairSink(use));                          // block by block; none is kept
//   PairsInSpan into(memory);
//   overlapping_pairs(boxes, BoxPairSink(into));
//   into.all_fit()                                                      // else into.count() says how many there are
//
// Laws: the pairs and their order are the same in each; blocks come one after the other, never two at a time.
// Source: RTCD 2.4.1.
// Cost: a call for some hundred pairs.  Nothing is searched.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "plumb/space/pairs/box_pair.hpp"

namespace plumb {

/// Keeps as many pairs as there is memory for, the first ones, and counts all.
class PairsInSpan {
 public:
  explicit PairsInSpan(std::span<BoxPair> memory) : memory_(memory) {}

  void operator()(std::span<const BoxPair> block) {
    for (std::size_t i = 0; i < block.size() && count_ + i < memory_.size(); ++i) memory_[count_ + i] = block[i];
    count_ += block.size();
  }

  /// Of all pairs there are, whether they fit or not.
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] bool all_fit() const { return count_ <= memory_.size(); }
  /// Those that were kept.
  [[nodiscard]] std::span<BoxPair> overlapping_pairs() const {
    return memory_.first(all_fit() ? count_ : memory_.size());
  }

 private:
  std::span<BoxPair> memory_;
  std::size_t count_ = 0;
};

/// What it refers to must outlive it.
class BoxPairSink {
 public:
  explicit BoxPairSink(std::vector<BoxPair>& pairs)
      : to_(&pairs), take_([](void* to, std::span<const BoxPair> block) {
          auto& kept = *static_cast<std::vector<BoxPair>*>(to);
          kept.insert(kept.end(), block.begin(), block.end());
        }) {}

  /// Of a function, or of what is called like one: call(std::span<const BoxPair>).
  template <class Call>
  requires requires(Call& call, std::span<const BoxPair> block) { call(block); }
  explicit BoxPairSink(Call& call)
      : to_(&call), take_([](void* to, std::span<const BoxPair> block) { (*static_cast<Call*>(to))(block); }) {}

  void operator()(std::span<const BoxPair> block) const { take_(to_, block); }

 private:
  void* to_;
  void (*take_)(void* to, std::span<const BoxPair> block);
};

}  // namespace plumb
