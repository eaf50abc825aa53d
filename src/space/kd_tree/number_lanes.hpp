// Lists of numbers written in lanes: those that a mask chooses, and a short list in order.
//
// Included once for each instruction set (foreach_target.h); hence no #pragma once.
// Law: a list ascends once it is sorted; what is before it stays.
// Source: ranks by comparing all with all, as sorting networks do, which no branch decides.
// Cost: a store for each vector of numbers; to sort n of at most 16, n comparisons of vectors.
#if defined(PLUMB_NUMBER_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_NUMBER_LANES
#undef PLUMB_NUMBER_LANES
#else
#define PLUMB_NUMBER_LANES
#endif

#include <hwy/highway.h>

#include <limits>
#include <span>
#include <vector>

#include "space/kd_tree/answer_lists.hpp"
#include "space/kd_tree/point_lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::space::kd::HWY_NAMESPACE {
namespace {

/// Appends to a vector, which is kept longer than what it holds, so that whole lanes are stored.
class NumberList {
 public:
  static constexpr std::size_t few = 16;

  HWY_INLINE explicit NumberList(std::vector<std::uint32_t>& numbers)
      : numbers_(numbers), before_(numbers.size()), end_(numbers.size()) {}
  [[nodiscard]] HWY_INLINE std::size_t end() const { return end_; }
  HWY_INLINE void cut(std::size_t end) { end_ = end; }
  /// The vector holds what was added, and no more.
  HWY_INLINE void close() { numbers_.resize(end_); }

  HWY_INLINE void add(std::span<const std::uint32_t> all) {
    make_room(all.size());
    for (const std::uint32_t number : all) numbers_[end_++] = number;
  }
  /// Those of all from `first` on whose bits are set, of as many as there are lanes.
  HWY_INLINE void add(std::span<const std::uint32_t> all, std::size_t first, unsigned bits) {
    make_room(count_of_lanes);
    if constexpr (count_of_lanes >= 4) {
      if (first + count_of_lanes <= all.size()) [[likely]] {
        const hn::CappedTag<std::uint32_t, count_of_lanes> lanes_of_numbers;
        const std::uint8_t mask[8] = {static_cast<std::uint8_t>(bits)};
        end_ += hn::CompressBitsStore(hn::LoadU(lanes_of_numbers, all.data() + first), mask, lanes_of_numbers,
                                      numbers_.data() + end_);
        return;
      }
    }
    for (; bits != 0; bits &= bits - 1) numbers_[end_++] = all[first + static_cast<std::size_t>(__builtin_ctz(bits))];
  }

  /// Those from `start` up to `to`.
  HWY_INLINE void sort(std::size_t start, std::size_t to) {
    const std::size_t n = to - start;
    if (n > few) {
      sort_numbers(std::span(numbers_).subspan(start, n));
      return;
    }
    make_room(few);
    const hn::CappedTag<std::uint32_t, few> many;
    constexpr std::size_t step = hn::MaxLanes(many);
    std::uint32_t* const list = numbers_.data() + start;
    HWY_ALIGN std::uint32_t old[few];
    HWY_ALIGN std::uint32_t rank[few];
    for (std::size_t i = 0; i < n; i += step) {
      const auto x = hn::LoadU(many, list + i);
      auto less = hn::Zero(many);
      for (std::size_t k = 0; k < n; ++k)
        less = hn::Add(less, hn::IfThenElseZero(hn::Gt(x, hn::Set(many, list[k])), hn::Set(many, 1)));
      hn::Store(x, many, old + i);
      hn::Store(less, many, rank + i);
    }
    for (std::size_t i = 0; i < n; ++i) list[rank[i]] = old[i];
  }

 private:
  HWY_INLINE void make_room(std::size_t more) {
    if (end_ + more > numbers_.size()) [[unlikely]]
      numbers_.resize(end_ + std::max(more + few, end_ - before_));  // what is before is of others
  }

  std::vector<std::uint32_t>& numbers_;
  std::size_t before_, end_;
};

}  // namespace
}  // namespace plumb::space::kd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
