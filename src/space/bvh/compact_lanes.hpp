// What does a compact node hold?  All of its children in lanes.
//
// Law: those of CompactNode::box, link and count; the planes of children that are missing say nothing.
// Cost: five operations for each plane of a vector of children.
// Included once for each instruction set (foreach_target.h); hence no #pragma once.
#if defined(PLUMB_COMPACT_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_COMPACT_LANES
#undef PLUMB_COMPACT_LANES
#else
#define PLUMB_COMPACT_LANES
#endif

#include <hwy/highway.h>

#include "plumb/space/bvh/compact_tree.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::space::HWY_NAMESPACE {

HWY_INLINE void widen_node(const CompactNode& from, WideNode<8>& to) {
  namespace hn = hwy::HWY_NAMESPACE;
  const hn::CappedTag<float, 8> tag;
  const hn::RebindToSigned<decltype(tag)> words;
  const auto bytes = [&](const std::uint8_t* at) {
    return hn::PromoteTo(words, hn::LoadU(hn::Rebind<std::uint8_t, decltype(tag)>(), at));
  };
  const auto word = [&](std::uint32_t x) { return hn::Set(words, static_cast<std::int32_t>(x)); };
  const std::array<std::uint8_t, 8> before = from.slots_before();
  for (std::size_t i = 0; i < 8; i += hn::MaxLanes(tag)) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto origin = hn::Set(tag, from.origin[k]), size = hn::Set(tag, static_cast<float>(from.step_size(k)));
      for (const std::size_t plane : {k, 3 + k}) {  // exact, as box is
        const auto steps = hn::ConvertTo(tag, bytes(from.planes[plane].data() + i));
        hn::StoreU(hn::Add(origin, hn::Mul(size, steps)), tag, to.planes[plane].data() + i);
      }
    }
    const auto child = hn::Iota(words, static_cast<std::int32_t>(i)), counts = bytes(from.count.data() + i);
    const auto slots = hn::Add(word(from.first_slot), bytes(before.data() + i));
    const auto leaf = hn::IfThenZeroElse(hn::Eq(counts, hn::Zero(words)), slots);
    const auto link = hn::IfThenElse(hn::Lt(child, word(from.inner)), hn::Add(word(from.first_node), child), leaf);
    const hn::RebindToUnsigned<decltype(tag)> numbers;
    hn::StoreU(hn::BitCast(numbers, link), numbers, to.link.data() + i);
    hn::StoreU(hn::BitCast(numbers, counts), numbers, to.count.data() + i);
  }
}

}  // namespace plumb::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
