// Which things, by their numbers, belong to each of n groups?  One list of all, group by group.
//
// Law: ascending in each group.
// Cost: linear, by counting.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace plumb::figure {

class ListsByNumber {
 public:
  /// group_of has a number of `groups` or more for what belongs to none.
  ListsByNumber(std::span<const std::uint32_t> group_of, std::size_t groups) : first_(groups + 1) {
    for (const std::uint32_t g : group_of)
      if (g < groups) ++first_[g + 1];
    for (std::size_t g = 0; g < groups; ++g) first_[g + 1] += first_[g];
    numbers_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t i = 0; i < group_of.size(); ++i)
      if (group_of[i] < groups) numbers_[next[group_of[i]]++] = i;
  }
  std::span<const std::uint32_t> operator[](std::size_t group) const {
    return std::span(numbers_).subspan(first_[group], first_[group + 1] - first_[group]);
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> numbers_;
};

}  // namespace plumb::figure
