// Slab test, crosswise: on which side of a line do the corners of a box lie, as seen along each axis?
//
// Seen along axis w, a line from o along d has the point p on its left where d_j (p_k - o_k) - d_k (p_j - o_j) is
// positive.  Of the rectangle's corners there is one where that is most and one where it is least, by the signs of d as
// given.
// Over any world of doubles (certify/world.hpp), of one number or of lanes of them; Truth is what the world judges.
// Included once for each target by files that Highway compiles for several.
// Source: RTCD 5.3.3.
// Cost: 12 products.
#if defined(PLUMB_BOX_PASSED) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_BOX_PASSED
#undef PLUMB_BOX_PASSED
#else
#define PLUMB_BOX_PASSED
#endif

#include <hwy/highway.h>

#include <array>

#include "plumb/arith/track.hpp"
#include "query/ray/box_lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::query::box_passed::HWY_NAMESPACE {

struct BoxPassed {
  static constexpr Scales scales{.count = 2};
  static constexpr int highest = 2;

  /// `apart`: the line passes the box by; `meets`: along none of these axes.  Both where the world is sure of it.
  template <class W, class V, class Truth>
  HWY_INLINE void operator()(W& w, const BoxBatchRay& ray, const V (&min)[3], const V (&max)[3], Truth& apart,
                             Truth& meets) const {
    const auto from_origin = [&](const V& x, std::size_t k) HWY_ATTR { return w.difference(x, ray.origin[k]); };
    const std::array low{from_origin(min[0], 0), from_origin(min[1], 1), from_origin(min[2], 2)};
    const std::array high{from_origin(max[0], 0), from_origin(max[1], 1), from_origin(max[2], 2)};
    // Of a segment the direction is a difference that was rounded once: so it is taken for one of all.
    const auto along = [&](std::size_t k) HWY_ATTR { return w.template difference<1>(ray.direction[k], 0.0); };
    const std::array d{along(0), along(1), along(2)};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t j = (axis + 1) % 3, k = (axis + 2) % 3;
      const double u = ray.direction[j], v = ray.direction[k];
      if (u == 0 && v == 0) continue;
      const auto most = d[j] * (u >= 0 ? high[k] : low[k]) - d[k] * (v >= 0 ? low[j] : high[j]);
      const auto least = d[j] * (u >= 0 ? low[k] : high[k]) - d[k] * (v >= 0 ? high[j] : low[j]);
      const Truth below = w.negative(most), above = w.positive(least), reaches = w.positive(most),
                  begins = w.negative(least);
      apart = apart | below | above;
      meets = meets & reaches & begins;
    }
  }
};

}  // namespace plumb::query::box_passed::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
