#include "space/sort_and_sweep/sweep_lanes.hpp"

#include "certify/batch/instruction_sets.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "space/sort_and_sweep/sweep_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "space/sort_and_sweep/span_lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::space::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using namespace span_lanes::HWY_NAMESPACE;

/// One pair after the other, those in doubt being asked.
HWY_NOINLINE void add_singly(unsigned met, unsigned doubtful, std::int32_t own, const std::int32_t* numbers,
                             const DecidePair& decide, PairBlock& pairs) {
  BoxPair* const to = pairs.room();
  std::size_t added = 0;
  for (; met != 0; met &= met - 1) {
    const auto k = static_cast<unsigned>(__builtin_ctz(met));
    const std::int32_t other = numbers[k];
    if ((doubtful >> k & 1) != 0 && !decide(own, other)) continue;
    to[added++] = {static_cast<std::uint32_t>(own < other ? own : other),
                   static_cast<std::uint32_t>(own < other ? other : own)};
  }
  pairs.added(added);
}

void sweep_boxes(const SweptBoxes& boxes, std::size_t from, std::size_t to, const DecidePair& decide,
                 PairBlock& pairs) {
  const Ordinals tag;
  constexpr std::size_t lanes = hn::MaxLanes(Ordinals());
  constexpr unsigned all = lanes == 32 ? ~0u : (1u << lanes) - 1;
  const std::int32_t *const low0 = boxes.low(0), *const high0 = boxes.high(0);
  const std::int32_t *const numbers = boxes.number(), *const marks = boxes.marks();
  const std::size_t stride = boxes.stride();
  const VecOfOrdinals zero = hn::Zero(tag);
  const auto set = [&](const std::int32_t* x) HWY_ATTR { return hn::Set(tag, *x); };
  const auto load = [&](const std::int32_t* x) HWY_ATTR { return hn::LoadU(tag, x); };
  for (std::size_t i = from; i < to; ++i) {
    const std::int32_t end = high0[i];
    const SpanLanes a = lanes_of_span(low0 + i, stride, set);
    const VecOfOrdinals a_marks = set(marks + i);
    for (std::size_t j = i + 1;; j += lanes) {
      const VecOfOrdinals overlap = overlap_of(a, lanes_of_span(low0 + j, stride, load));
      const MaskOfOrdinals marked = hn::Ne(hn::And(a_marks, load(marks + j)), zero);
      const MaskOfOrdinals apart = hn::Or(hn::Lt(overlap, zero), marked);
      const MaskOfOrdinals doubt = hn::AndNot(marked, hn::Eq(overlap, zero));
      if constexpr (lanes < 8) {
        const unsigned met = ~bits_of_ordinals(apart) & all;
        if (met != 0) add_singly(met, bits_of_ordinals(doubt), numbers[i], numbers + j, decide, pairs);
      } else if (!hn::AllFalse(tag, doubt)) [[unlikely]] {
        add_singly(~bits_of_ordinals(apart) & all, bits_of_ordinals(doubt), numbers[i], numbers + j, decide, pairs);
      } else {  // without a branch on whether there is any
        const VecOfOrdinals own = hn::Set(tag, numbers[i]);
        const VecOfOrdinals others = hn::CompressNot(load(numbers + j), apart);
        hn::StoreInterleaved2(hn::Min(own, others), hn::Max(own, others), tag,
                              reinterpret_cast<std::int32_t*>(pairs.room()));
        pairs.added(lanes - hn::CountTrue(tag, apart));
      }
      if (low0[j + lanes - 1] > end) break;  // as all behind it
    }
  }
}

}  // namespace
}  // namespace plumb::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "certify/batch/chosen_target.hpp"

namespace plumb::space {
namespace {

PLUMB_EXPORT(sweep_boxes);

}  // namespace

template <class PlaceOf>
void SweptBoxes::fill(std::span<const OrdinalBox> boxes, const PlaceOf& place_of) {
  size_ = boxes.size();
  if (stride_ < size_ + lanes_behind) {
    stride_ = size_ + size_ / 2 + lanes_behind;
    numbers_ = std::make_unique_for_overwrite<std::int32_t[]>(8 * stride_);
  }
  std::int32_t* const to = numbers_.get();
  for (std::size_t i = 0; i < size_; ++i) {
    const OrdinalBox& b = boxes[place_of(i)];
    for (std::size_t k = 0; k < 3; ++k) {
      to[k * stride_ + i] = b.low[k];
      to[(3 + k) * stride_ + i] = b.high[k];
    }
    to[6 * stride_ + i] = b.number;
    to[7 * stride_ + i] = b.marks;
  }
  for (std::size_t k = 0; k < 8; ++k) {
    for (std::size_t i = size_; i < size_ + lanes_behind; ++i) to[k * stride_ + i] = beyond_ordinals;
  }
}

void SweptBoxes::assign(std::span<const OrdinalBox> boxes) {
  fill(boxes, [](std::size_t i) { return i; });
}
void SweptBoxes::assign(std::span<const OrdinalBox> boxes, std::span<const std::uint64_t> order) {
  fill(boxes, [&](std::size_t i) { return static_cast<std::uint32_t>(order[i]); });
}

void sweep(const SweptBoxes& boxes, std::size_t from, std::size_t to, const DecidePair& decide, PairBlock& pairs) {
  PLUMB_DISPATCH(sweep_boxes)(boxes, from, to, decide, pairs);
}

}  // namespace plumb::space
#endif
