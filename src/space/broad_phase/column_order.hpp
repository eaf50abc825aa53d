// In which order are the boxes of a column swept?  By their starts, and of equal ones by their places in the column.
//
// Source: Knuth, The Art of Computer Programming 3, 5.2.5 (distribution into about as many buckets as there are keys).
// Cost: some 8 ns a box where starts are spread; n log n where many are alike.
#pragma once

#include <algorithm>
#include <bit>
#include <span>
#include <utility>
#include <vector>

#include "space/bvh/radix_sort.hpp"
#include "space/sort_and_sweep/ordinal_box.hpp"

namespace plumb::space {

class ColumnOrder {
 public:
  /// Of these boxes, the places: the lower halves of the keys that are told.  Valid until the next call.
  std::span<const std::uint64_t> operator()(std::span<const OrdinalBox> boxes) {
    keys_.resize(boxes.size());
    std::int32_t least = beyond_ordinals, greatest = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const std::int32_t start = boxes[i].low[0];
      least = std::min(least, start), greatest = std::max(greatest, start);
      keys_[i] = static_cast<std::uint64_t>(start) << 32 | i;
    }
    sort_keys(static_cast<std::uint32_t>(least), static_cast<std::uint32_t>(greatest));
    return keys_;
  }

  /// Whole keys, whose upper halves are spread.
  void sort_nearly_sorted(std::vector<std::uint64_t>& keys) {
    std::size_t left = 2 * keys.size() + 64;  // steps, before keys are taken for unsorted
    for (std::size_t i = 1; i < keys.size(); ++i) {
      const std::uint64_t key = keys[i];
      std::size_t at = i;
      for (; at > 0 && keys[at - 1] > key; --at) keys[at] = keys[at - 1];
      keys[at] = key;
      if (i - at > left) return sort_unsorted(keys);
      left -= i - at;
    }
  }

 private:
  void sort_unsorted(std::vector<std::uint64_t>& keys) {
    std::uint32_t least = 0xffffffff, greatest = 0;
    for (const std::uint64_t key : keys) {
      const auto upper = static_cast<std::uint32_t>(key >> 32);
      least = std::min(least, upper), greatest = std::max(greatest, upper);
    }
    keys_.swap(keys);
    sort_keys(least, greatest);
    keys_.swap(keys);
    for (std::size_t from = 0, to = 0; from < keys.size(); from = to) {  // many are sorted by their upper halves alone
      while (to < keys.size() && keys[to] >> 32 == keys[from] >> 32) ++to;
      std::sort(keys.data() + from, keys.data() + to);
    }
  }

  void sort_keys(std::uint32_t least, std::uint32_t greatest) {
    constexpr std::size_t few = 24, many = std::size_t{1} << 13;
    const std::size_t n = keys_.size();
    if (n > many) {
      radix_sort_upper(Execution::serial, keys_);
    } else if (n > few) {
      distribute(least, greatest - least);
    }
    if (n <= many) insert_each();
  }

  void distribute(std::uint32_t least, std::uint32_t range) {
    constexpr std::uint32_t crowded = 16;
    const auto n = static_cast<std::uint32_t>(keys_.size()), buckets = std::bit_ceil(n);
    const int shift = std::max(0, static_cast<int>(std::bit_width(range)) - std::countr_zero(buckets));
    const auto bucket_of = [&](std::uint64_t key) { return (static_cast<std::uint32_t>(key >> 32) - least) >> shift; };
    ends_.assign(buckets, 0);
    for (const std::uint64_t key : keys_) ++ends_[bucket_of(key)];
    std::uint32_t before = 0, most = 0;
    for (std::uint32_t& end : ends_) {
      most = std::max(most, end);
      before += std::exchange(end, before);
    }
    placed_.resize(n);
    for (const std::uint64_t key : keys_) placed_[ends_[bucket_of(key)]++] = key;
    keys_.swap(placed_);
    if (most <= crowded) return;
    std::uint32_t from = 0;
    for (const std::uint32_t end : ends_) {
      if (end - from > crowded) std::sort(keys_.begin() + from, keys_.begin() + end);
      from = end;
    }
  }

  /// Most are in their places, or near them.
  void insert_each() {
    for (std::size_t i = 1; i < keys_.size(); ++i) {
      const std::uint64_t key = keys_[i];
      std::size_t at = i;
      for (; at > 0 && keys_[at - 1] > key; --at) keys_[at] = keys_[at - 1];
      keys_[at] = key;
    }
  }

  std::vector<std::uint64_t> keys_, placed_;
  std::vector<std::uint32_t> ends_;  // of buckets
};

}  // namespace plumb::space
