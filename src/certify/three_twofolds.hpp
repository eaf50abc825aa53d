// A vector of space, each of whose numbers is known to twice the digits of a double: arith/twofold.hpp in three lanes.
//
// Included once for each target by files that Highway compiles for several; there are lanes for AVX2 alone.
// Laws: those of arith/twofold.hpp, lane by lane: the text of sums and products is the same.
// Source: Dekker 1971; RTCD 13.7.
// Cost: 10 operations a sum, 7 a product, of a vector.
#if defined(PLUMB_THREE_TWOFOLDS) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_THREE_TWOFOLDS
#undef PLUMB_THREE_TWOFOLDS
#else
#define PLUMB_THREE_TWOFOLDS
#endif

#include <hwy/highway.h>

#include "arith/twofold.hpp"
#include "certify/three_lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::certify::three_lanes::HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX2

/// The numbers of a vector.
struct Components {
  double x, y, z;
};
HWY_INLINE Components apart(const Three& a) {
  const __m128d low = _mm256_castpd256_pd128(a.v);
  return {_mm_cvtsd_f64(low), _mm_cvtsd_f64(_mm_unpackhi_pd(low, low)), _mm_cvtsd_f64(_mm256_extractf128_pd(a.v, 1))};
}

struct Twofolds {
  Three high, low, magnitude;
  double error, width;

  using Self = Twofolds;
  using Number = Three;
  using One = Twofold<true>;
  struct Truth {
    __m256d v;
    /// In the three lanes of a vector of space.
    HWY_INLINE operator bool() const { return (_mm256_movemask_pd(v) & 7) == 7; }  // NOLINT: as of one number
  };
  static HWY_INLINE Three number(double x) { return of_all(x); }
  static HWY_INLINE Three size(const Three& x) { return three_lanes::HWY_NAMESPACE::size(x); }
  /// Not by its bits: the compiler makes subtractions of sums with it.
  static HWY_INLINE Three negated(const Three& x) { return {-x.v}; }
  static HWY_INLINE Truth equal(const Three& a, const Three& b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_EQ_OQ)}; }
  static HWY_INLINE Three plus_product(const Three& c, const Three& a, const Three& b) {
    return three_lanes::HWY_NAMESPACE::plus_product(c, a, b);
  }
  struct Rounded3 {
    Three value, error;
  };
  /// Two differences as products with one: where numbers are multiplied and added they wait less.
  static HWY_INLINE Rounded3 two_sum(const Three& a, const Three& b) {
    const Three s = a + b, part = s - a, one = of_all(1);
    return {s, Three{_mm256_fmsub_pd(a.v, one.v, (s - part).v)} + Three{_mm256_fmsub_pd(b.v, one.v, part.v)}};
  }
  static HWY_INLINE Rounded3 product(const Three& a, const Three& b) {
    const Three p = a * b;
    return {p, {_mm256_fmsub_pd(a.v, b.v, p.v)}};
  }
#define PLUMB_TWOFOLD_INLINE HWY_INLINE
#include "arith/twofold_text.hpp"
#undef PLUMB_TWOFOLD_INLINE

  static HWY_INLINE Twofolds exact(const Three& x) { return {x, of_all(0), three_lanes::HWY_NAMESPACE::size(x), 0, 0}; }
  static HWY_INLINE Twofolds all(const One& x) {
    return {of_all(x.high), of_all(x.low), of_all(x.magnitude), x.error, x.width};
  }
  /// What pays for underflow, but not where this is zero.
  static HWY_INLINE Three guard_of_some(const Three& x) {
    return {_mm256_and_pd(number(guard).v, _mm256_cmp_pd(x.v, _mm256_setzero_pd(), _CMP_NEQ_UQ))};
  }
  /// a b, where nothing times anything is nothing.
  static HWY_INLINE Twofolds whole_product(const Twofolds& a, const Twofolds& b) {
    Twofolds p = a * b;
    p.magnitude = plus_product(guard_of_some(smaller(a.magnitude, b.magnitude)), a.magnitude, b.magnitude);
    return p;
  }
  /// Likewise of every lane and one number.
  friend HWY_INLINE Twofolds scaled(const Twofolds& a, const One& by) {
    const Twofolds b = all(by);
    Twofolds p = a * b;
    p.magnitude = plus_product(guard_of_some(a.magnitude), a.magnitude, b.magnitude);
    return p;
  }
  [[nodiscard]] HWY_INLINE Twofolds turned() const {
    return {three_lanes::HWY_NAMESPACE::turned(high), three_lanes::HWY_NAMESPACE::turned(low),
            three_lanes::HWY_NAMESPACE::turned(magnitude), error, width};
  }
  [[nodiscard]] HWY_INLINE Twofolds turned_back() const {
    return {three_lanes::HWY_NAMESPACE::turned_back(high), three_lanes::HWY_NAMESPACE::turned_back(low),
            three_lanes::HWY_NAMESPACE::turned_back(magnitude), error, width};
  }
};

/// The sums of the lanes of three vectors of space, in the first three lanes.
HWY_INLINE Twofolds sums(const Twofolds& a, const Twofolds& b, const Twofolds& c) {
  const Columns high = transposed(a.high, b.high, c.high), low = transposed(a.low, b.low, c.low),
                size = transposed(a.magnitude, b.magnitude, c.magnitude);
  const double e = Twofolds::larger(Twofolds::larger(a.error, b.error), c.error),
               w = Twofolds::larger(Twofolds::larger(a.width, b.width), c.width);
  return (Twofolds{high.x, low.x, size.x, e, w} + Twofolds{high.y, low.y, size.y, e, w}) +
         Twofolds{high.z, low.z, size.z, e, w};
}
/// The cross product in the order (z, x, y).
HWY_INLINE Twofolds crossed(const Twofolds& a, const Twofolds& b) {
  return Twofolds::whole_product(a, b.turned()) - Twofolds::whole_product(a.turned(), b);
}

struct Dots {
  Twofolds::One x, y, z;
};
HWY_INLINE Dots apart(const Twofolds& a) {
  const Components high = apart(a.high), low = apart(a.low), size = apart(a.magnitude);
  return {{high.x, low.x, size.x, a.error, a.width},
          {high.y, low.y, size.y, a.error, a.width},
          {high.z, low.z, size.z, a.error, a.width}};
}

HWY_INLINE Twofolds::One total(const Twofolds& a) {
  const Dots all = apart(a);
  return (all.x + all.y) + all.z;
}

// Of exact vectors.  A sum of squares is its own magnitude, but for roundings; and |a b| <= a^2 + b^2.
HWY_INLINE Twofolds::One square(const Twofolds& v) {
  const Twofolds::One s = total(v * v);
  return s.below(s.high + 4 * Twofolds::guard);
}
// In lanes the squares come first: sizes are made of them, and quotients; the third lane has to be fetched.
/// v.v, v.w and w.w.
HWY_INLINE Dots squares(const Twofolds& v, const Twofolds& w) {
  const Dots s = apart(sums(v * v, w * w, v * w));
  constexpr double guards = 4 * Twofolds::guard;
  const double of_v = s.x.high + guards, of_w = s.y.high + guards;
  return {s.x.below(of_v), s.z.below(of_v + of_w), s.y.below(of_w)};
}
/// Likewise v.d and v.e, and v.v, where those of d and e are known.
HWY_INLINE Dots along(const Twofolds& v, const Twofolds& d, const Twofolds& e, const Dots& of_d_and_e) {
  const Dots s = apart(sums(v * v, v * d, v * e));
  const double of_v = s.x.high + 4 * Twofolds::guard;
  return {s.y.below(of_v + of_d_and_e.x.magnitude), s.z.below(of_v + of_d_and_e.z.magnitude), s.x.below(of_v)};
}

#endif

}  // namespace plumb::certify::three_lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
