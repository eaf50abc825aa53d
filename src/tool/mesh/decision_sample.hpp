// Which decisions of a kind are asked, where there are too many to ask all?
//
// As many equal stretches of the decisions' order are cut as are to be asked, and one of each is drawn: the sample
// spreads over the whole mesh, and a pattern in the mesh's order does not fall in step with it.
// Laws: (1) depends on the two counts alone; (2) ascending, no decision twice; (3) all, where no more are there.
// Source: Cochran, Sampling Techniques, 5 (stratified sampling).
// Cost: about 20 ns a number.
#pragma once

#include <algorithm>
#include <cstdint>

#include "plumb/degenerate/entropy.hpp"

namespace plumb::tool {

class DecisionSample {
 public:
  /// `most` decisions of `all`, or all where there are fewer.
  DecisionSample(std::uint64_t all, std::uint64_t most) : all_(all), size_(std::min(all, most)) {}

  [[nodiscard]] std::uint64_t size() const { return size_; }

  /// The decision that is asked at place i < size().
  [[nodiscard]] std::uint64_t number(std::uint64_t i) const {
    if (size_ == all_) return i;
    const std::uint64_t begin = begin_of(i);
    return begin + Entropy(2026, i).below(begin_of(i + 1) - begin);
  }

 private:
  // Stretches that differ by one at most; no product here exceeds all_ + size_^2.
  [[nodiscard]] std::uint64_t begin_of(std::uint64_t i) const {
    return i * (all_ / size_) + i * (all_ % size_) / size_;
  }

  std::uint64_t all_, size_;
};

}  // namespace plumb::tool
