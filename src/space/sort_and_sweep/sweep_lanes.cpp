#include "space/sort_and_sweep/sweep_lanes.hpp"

#include "certify/batch/instruction_sets.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "space/sort_and_sweep/sweep_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace plumb::space::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Ordinals = hn::CappedTag<std::int32_t, 16>;
using VecOfOrdinals = hn::Vec<Ordinals>;
using MaskOfOrdinals = hn::Mask<Ordinals>;

HWY_INLINE unsigned bits_of_ordinals(MaskOfOrdinals mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(Ordinals(), mask, bits);
  return static_cast<unsigned>(bits[0] | bits[1] << 8);
}

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
  const std::int32_t *const low0 = boxes.low(0), *const low1 = boxes.low(1), *const low2 = boxes.low(2);
  const std::int32_t *const high0 = boxes.high(0), *const high1 = boxes.high(1), *const high2 = boxes.high(2);
  const std::int32_t *const numbers = boxes.number(), *const marks = boxes.marks();
  for (std::size_t i = from; i < to; ++i) {
    const std::int32_t end = high0[i];
    const VecOfOrdinals a_low0 = hn::Set(tag, low0[i]), a_low1 = hn::Set(tag, low1[i]), a_low2 = hn::Set(tag, low2[i]);
    const VecOfOrdinals a_high0 = hn::Set(tag, end), a_high1 = hn::Set(tag, high1[i]), a_high2 = hn::Set(tag, high2[i]);
    const VecOfOrdinals a_marks = hn::Set(tag, marks[i]);
    for (std::size_t j = i + 1;; j += lanes) {
      const VecOfOrdinals b_low0 = hn::LoadU(tag, low0 + j);
      const VecOfOrdinals b_low1 = hn::LoadU(tag, low1 + j), b_high1 = hn::LoadU(tag, high1 + j);
      const VecOfOrdinals b_low2 = hn::LoadU(tag, low2 + j), b_high2 = hn::LoadU(tag, high2 + j);
      const MaskOfOrdinals apart1 = hn::Or(hn::Gt(a_low1, b_high1), hn::Gt(b_low1, a_high1));
      const MaskOfOrdinals apart2 = hn::Or(hn::Gt(a_low2, b_high2), hn::Gt(b_low2, a_high2));
      const MaskOfOrdinals marked = hn::Ne(hn::And(a_marks, hn::LoadU(tag, marks + j)), hn::Zero(tag));
      const MaskOfOrdinals apart = hn::Or(hn::Or(apart1, apart2), hn::Or(marked, hn::Gt(b_low0, a_high0)));
      const MaskOfOrdinals equal1 = hn::Or(hn::Eq(a_low1, b_high1), hn::Eq(b_low1, a_high1));
      const MaskOfOrdinals equal2 = hn::Or(hn::Eq(a_low2, b_high2), hn::Eq(b_low2, a_high2));
      const MaskOfOrdinals equal0 = hn::Or(hn::Eq(b_low0, a_high0), hn::Eq(a_low0, hn::LoadU(tag, high0 + j)));
      const MaskOfOrdinals doubt = hn::AndNot(apart, hn::Or(hn::Or(equal1, equal2), equal0));
      if constexpr (lanes < 8) {
        const unsigned met = ~bits_of_ordinals(apart) & all;
        if (met != 0) add_singly(met, bits_of_ordinals(doubt), numbers[i], numbers + j, decide, pairs);
      } else if (!hn::AllFalse(tag, doubt)) [[unlikely]] {
        add_singly(~bits_of_ordinals(apart) & all, bits_of_ordinals(doubt), numbers[i], numbers + j, decide, pairs);
      } else {  // without a branch on whether there is any
        const VecOfOrdinals own = hn::Set(tag, numbers[i]);
        const VecOfOrdinals others = hn::CompressNot(hn::LoadU(tag, numbers + j), apart);
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

HWY_EXPORT(sweep_boxes);

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
