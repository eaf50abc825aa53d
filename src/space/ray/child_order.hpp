// Which of eight children does a ray come to, in which order?  Sorted in lanes, without a branch to guess.
//
// Law: the farthest first; of equal keys, to 20 bits, the one of the highest number.
// Source: Batcher 1968 for the network.
// Cost: six exchanges of a vector with itself.
// Included once for each instruction set (foreach_target.h); hence no #pragma once.
#if defined(PLUMB_CHILD_ORDER) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_CHILD_ORDER
#undef PLUMB_CHILD_ORDER
#else
#define PLUMB_CHILD_ORDER
#endif

#include <hwy/highway.h>

#include "plumb/space/bvh/wide_tree.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::space::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
#if HWY_MAX_BYTES >= 32
using EightFloats = hn::CappedTag<float, 8>;
using EightWords = hn::CappedTag<std::int32_t, 8>;
using Words = hn::Vec<EightWords>;

/// Of lanes that are `step` apart the greater into the lower one: by 2 within four.
HWY_INLINE Words greater_of_neighbors_first(Words v) {
  const EightWords tag;
  const Words other = hn::Reverse2(tag, v);
  return hn::OddEven(hn::Min(v, other), hn::Max(v, other));
}
HWY_INLINE Words greater_pair_first(Words v, Words other) {
  const hn::Repartition<std::int64_t, EightWords> pairs;
  return hn::BitCast(EightWords(),
                     hn::OddEven(hn::BitCast(pairs, hn::Min(v, other)), hn::BitCast(pairs, hn::Max(v, other))));
}

/// The greatest first.
HWY_INLINE Words sorted(Words v) {
  const EightWords tag;
  v = greater_of_neighbors_first(v);
  v = greater_of_neighbors_first(greater_pair_first(v, hn::Reverse4(tag, v)));
  const Words other = hn::Reverse8(tag, v);
  v = hn::ConcatUpperLower(tag, hn::Min(v, other), hn::Max(v, other));
  return greater_of_neighbors_first(greater_pair_first(v, hn::Shuffle1032(v)));
}

/// Puts those children there are whose key is not below 0, with room for eight; how many are there?
template <class Place>
HWY_INLINE std::size_t put_sorted(const WideNode<8>& node, hn::Vec<EightFloats> keys, const Place& place) {
  const EightWords tag;
  const EightFloats floats;
  const hn::RebindToUnsigned<EightWords> unsigneds;
  const auto links = hn::Load(unsigneds, node.link.data()), counts = hn::Load(unsigneds, node.count.data());
  // Floats from 0 on are ordered as their bits are; the last three bits give way to the child's number.
  const Words last = hn::Set(tag, 7);
  const Words numbered = hn::Or(hn::AndNot(last, hn::BitCast(tag, keys)), hn::Iota(tag, 0));
  const auto missing = hn::Eq(hn::Or(links, counts), hn::Zero(unsigneds));
  const Words order = sorted(hn::IfThenElse(hn::RebindMask(tag, missing), hn::Set(tag, -1), numbered));
  const auto from = hn::IndicesFromVec(tag, hn::And(order, last));
  hn::StoreU(hn::BitCast(floats, hn::TableLookupLanes(hn::BitCast(tag, keys), from)), floats, place.key);
  hn::StoreU(hn::BitCast(unsigneds, hn::TableLookupLanes(hn::BitCast(tag, links), from)), unsigneds, place.link);
  hn::StoreU(hn::BitCast(unsigneds, hn::TableLookupLanes(hn::BitCast(tag, counts), from)), unsigneds, place.count);
  if constexpr (Place::has_boxes) {
    for (std::size_t k = 0; k < 6; ++k) {
      const auto planes = hn::BitCast(tag, hn::Load(floats, node.planes[k].data()));
      hn::StoreU(hn::BitCast(floats, hn::TableLookupLanes(planes, from)), floats, place.planes[k]);
    }
  }
  return hn::CountTrue(tag, hn::Gt(order, hn::Set(tag, -1)));
}
#else
/// The same one after the other, by whole keys.
template <class Place>
std::size_t put_one_by_one(const WideNode<8>& node, const float* keys, const Place& place) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    if (keys[i] < 0 || !node.has(i)) continue;
    std::size_t at = found++;
    for (; at > 0 && place.key[at - 1] <= keys[i]; --at) place.move_up(at - 1);
    place.put(at, keys[i], node, i);
  }
  return found;
}
#endif

}  // namespace plumb::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
