// Is a point inside a ball, told by what was known of it when the ball's center was elsewhere?
//
// With rest = s - |p - b|^2 of a base b, the ball of center b + d and of square S has
//   S - |p - b - d|^2 = rest + (S - s - |d|^2) + 2 (p - b) . d,
// of which the middle is one number for all points, and the last is small where the ball has hardly moved.
// Over any world of doubles (certify/world.hpp), of one number or of lanes of them.
// Included once for each target by files that Highway compiles for several.
// Laws: true only where rest + lead + (p - base) . by is positive.
// Cost: that of the plain operations, and a magnitude and a sum for each number given.
#if defined(PLUMB_STAYS_INSIDE) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_STAYS_INSIDE
#undef PLUMB_STAYS_INSIDE
#else
#define PLUMB_STAYS_INSIDE
#endif

#include <hwy/highway.h>

#include <array>

#include "plumb/arith/track.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::figure::sphere::stays_inside::HWY_NAMESPACE {

struct StaysInside {
  static constexpr Scales scales{.count = 2, .weights = 1u << 1};
  static constexpr int highest = 2;

  template <class W, class Number, std::size_t axes>
  HWY_INLINE auto operator()(W& w, const std::array<Number, axes>& p, const Number& rest,
                             const std::array<Number, axes>& base, const std::array<Number, axes>& by,
                             const Number& lead) const {
    const auto x = w.template difference<1>(p[0], base[0]) * w.template weight<1>(w.given(by[0]));
    const auto y = w.template difference<1>(p[1], base[1]) * w.template weight<1>(w.given(by[1]));
    const auto known = w.number(rest) + w.number(lead);
    if constexpr (axes == 2) {
      return w.positive(known + (x + y));
    } else {
      const auto z = w.template difference<1>(p[2], base[2]) * w.template weight<1>(w.given(by[2]));
      return w.positive(known + ((x + y) + z));
    }
  }
};

}  // namespace plumb::figure::sphere::stays_inside::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
