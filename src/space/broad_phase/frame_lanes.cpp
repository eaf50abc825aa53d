#include "space/broad_phase/frame_lanes.hpp"

#include "certify/batch/instruction_sets.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "space/broad_phase/frame_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "space/sort_and_sweep/span_lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::space::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using namespace span_lanes::HWY_NAMESPACE;

void sweep_entries(const SweptEntries& entries, const EntryPairTaker& taker) {
  const Ordinals tag;
  constexpr std::size_t lanes = hn::MaxLanes(Ordinals()), at_once = SweptEntries::at_once;
  const SweptEntries::Block* const blocks = entries.blocks().data();
  const std::size_t size = entries.size(), beyond = entries.blocks().size() * at_once;
  const VecOfOrdinals zero = hn::Zero(tag);
  const auto set = [&](const std::int32_t* x) HWY_ATTR { return hn::Set(tag, *x); };
  const auto load = [&](const std::int32_t* x) HWY_ATTR { return hn::Load(tag, x); };
  for (std::size_t i = 0; i + 1 < size; ++i) {
    const std::int32_t* const a = &blocks[i / at_once].of[0][i % at_once];
    const SpanLanes now = lanes_of_span(a, at_once, set), before = lanes_of_span(a + 6 * at_once, at_once, set);
    const VecOfOrdinals marks = set(a + 13 * at_once);
    const std::int32_t end = a[15 * at_once];
    for (std::size_t j = (i + 1) / lanes * lanes; j < beyond; j += lanes) {
      const std::int32_t* const b = &blocks[j / at_once].of[0][j % at_once];
      const VecOfOrdinals is = overlap_of(now, lanes_of_span(b, at_once, load));
      const VecOfOrdinals was = overlap_of(before, lanes_of_span(b + 6 * at_once, at_once, load));
      const MaskOfOrdinals differ = hn::Or(hn::Lt(hn::Xor(is, was), zero), hn::Or(hn::Eq(is, zero), hn::Eq(was, zero)));
      const MaskOfOrdinals told = hn::And(differ, hn::Eq(hn::And(marks, load(b + 13 * at_once)), zero));
      if (!hn::AllFalse(tag, told)) [[unlikely]] {
        unsigned bits = bits_of_ordinals(told);
        if (j <= i) bits &= ~0U << (i + 1 - j);  // those that come before have been told of this one
        for (; bits != 0; bits &= bits - 1) {
          const std::int32_t other = b[12 * at_once + static_cast<unsigned>(__builtin_ctz(bits))];
          taker.take(taker.to, static_cast<std::uint32_t>(a[12 * at_once]), static_cast<std::uint32_t>(other));
        }
      }
      if (b[14 * at_once + lanes - 1] > end) break;  // as all behind it
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

PLUMB_EXPORT(sweep_entries);

}  // namespace

void SweptEntries::assign(std::span<const FrameEntry> entries, std::uint32_t frame,
                          std::span<const std::uint64_t> keys) {
  size_ = keys.size();
  if (blocks_.size() * at_once < size_) blocks_.resize((size_ + at_once - 1) / at_once);
  const std::size_t room = blocks().size() * at_once;
  for (std::size_t i = 0; i < size_; ++i) {
    std::int32_t* const to = &blocks_[i / at_once].of[0][i % at_once];
    const auto number = static_cast<std::uint32_t>(keys[i] >> 2);
    const FrameEntry& e = entries[number];
    const OrdinalSpan& was = e.was(frame);
    for (std::size_t k = 0; k < 3; ++k) {
      to[k * at_once] = e.now.low[k], to[(3 + k) * at_once] = e.now.high[k];
      to[(6 + k) * at_once] = was.low[k], to[(9 + k) * at_once] = was.high[k];
    }
    to[12 * at_once] = static_cast<std::int32_t>(number);
    to[13 * at_once] = static_cast<std::int32_t>(keys[i] & 3);
    to[14 * at_once] = static_cast<std::int32_t>(keys[i] >> 34);
    to[15 * at_once] = std::max(e.now.high[0], was.high[0]);
  }
  for (std::size_t i = size_; i < room; ++i) {
    std::int32_t* const to = &blocks_[i / at_once].of[0][i % at_once];
    for (std::size_t k = 0; k < 3; ++k) {
      to[k * at_once] = to[(6 + k) * at_once] = past_ordinals;
      to[(3 + k) * at_once] = to[(9 + k) * at_once] = -1;
    }
    to[12 * at_once] = to[13 * at_once] = 0;
    to[14 * at_once] = to[15 * at_once] = beyond_ordinals;
  }
}

void sweep_frames(const SweptEntries& entries, const EntryPairTaker& to) { PLUMB_DISPATCH(sweep_entries)(entries, to); }

}  // namespace plumb::space
#endif
