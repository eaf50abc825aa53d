// As many numbers at once as the machine has lanes, each known to twice the digits of a double: arith/twofold.hpp in
// lanes, each of a question of its own.
//
// Included once for each target by files that Highway compiles for several; there are lanes for AVX2 alone.
// Laws: those of arith/twofold.hpp, lane by lane: the text of sums and products is the same.
// Source: Dekker 1971; RTCD 13.7.
// Cost: 10 operations a sum, 7 a product, of as many numbers.
#if defined(PLUMB_MANY_TWOFOLDS) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_MANY_TWOFOLDS
#undef PLUMB_MANY_TWOFOLDS
#else
#define PLUMB_MANY_TWOFOLDS
#endif

#include <hwy/highway.h>

#include "arith/twofold.hpp"
#include "certify/many_lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::certify::many_lanes::HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX2

struct Twofolds {
  Many high, low, magnitude;
  double error, width;

  using Self = Twofolds;
  using Number = Many;
  static HWY_INLINE Many number(double x) { return of_all(x); }
  static HWY_INLINE Many size(const Many& x) { return many_lanes::HWY_NAMESPACE::size(x); }
  static HWY_INLINE Many negated(const Many& x) { return {hn::Neg(x.v)}; }
  static HWY_INLINE Truth equal(const Many& a, const Many& b) { return {hn::Eq(a.v, b.v)}; }
  static HWY_INLINE Many plus_product(const Many& c, const Many& a, const Many& b) {
    return many_lanes::HWY_NAMESPACE::plus_product(c, a, b);
  }
  struct Rounded {
    Many value, error;
  };
  static HWY_INLINE Rounded two_sum(const Many& a, const Many& b) {
    const Many s = a + b, part = s - a;
    return {s, (a - (s - part)) + (b - part)};
  }
  static HWY_INLINE Rounded product(const Many& a, const Many& b) {
    const Many p = a * b;
    return {p, {hn::MulSub(a.v, b.v, p.v)}};
  }
#define PLUMB_TWOFOLD_INLINE HWY_INLINE
#include "arith/twofold_text.hpp"
#undef PLUMB_TWOFOLD_INLINE

  static HWY_INLINE Twofolds exact(const Many& x) { return {x, of_all(0), size(x), 0, 0}; }
};

#endif

}  // namespace plumb::certify::many_lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
