// By how much do boxes overlap, in ordinals (ordinal_box.hpp)?  In the lanes of vectors, coordinate by coordinate.
//
// Included once for each target by files that Highway compiles for several.
// Laws: no difference overflows, for ordinals lie between -1 and beyond_ordinals, and starts are not below 0.
// Cost: 6 subtractions and 5 minima.
#if defined(PLUMB_SPAN_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_SPAN_LANES
#undef PLUMB_SPAN_LANES
#else
#define PLUMB_SPAN_LANES
#endif

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace plumb::space::span_lanes::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Ordinals = hn::CappedTag<std::int32_t, 16>;
using VecOfOrdinals = hn::Vec<Ordinals>;
using MaskOfOrdinals = hn::Mask<Ordinals>;

HWY_INLINE unsigned bits_of_ordinals(MaskOfOrdinals mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(Ordinals(), mask, bits);
  return static_cast<unsigned>(bits[0] | bits[1] << 8);
}

struct SpanLanes {
  VecOfOrdinals low0, low1, low2, high0, high1, high2;
};

/// The numbers of each coordinate lie so far behind those of the one before it.
template <class Get>
HWY_INLINE SpanLanes lanes_of_span(const std::int32_t* from, std::size_t stride, const Get& get) {
  return {get(from),
          get(from + stride),
          get(from + 2 * stride),
          get(from + 3 * stride),
          get(from + 4 * stride),
          get(from + 5 * stride)};
}

/// The least by which ends pass starts: below 0 apart, above 0 overlapping, at 0 nobody knows.
HWY_INLINE VecOfOrdinals overlap_of(const SpanLanes& a, const SpanLanes& b) {
  const VecOfOrdinals on0 = hn::Min(hn::Sub(a.high0, b.low0), hn::Sub(b.high0, a.low0));
  const VecOfOrdinals on1 = hn::Min(hn::Sub(a.high1, b.low1), hn::Sub(b.high1, a.low1));
  const VecOfOrdinals on2 = hn::Min(hn::Sub(a.high2, b.low2), hn::Sub(b.high2, a.low2));
  return hn::Min(hn::Min(on0, on1), on2);
}

}  // namespace plumb::space::span_lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
