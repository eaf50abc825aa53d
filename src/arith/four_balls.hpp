// Four numbers at once, each known to some hundred bits: plumb/arith/ball.hpp in lanes of fused multiply-adds.
//
// Included once for each target by files that Highway compiles for several; there are four lanes for AVX2 alone.
// Laws: those of plumb/arith/ball.hpp, lane by lane: the text of sums and products is the same.
// Source: Dekker 1971; RTCD 13.7.
// Cost: 20 operations a sum, 30 a product, of four numbers.
#if defined(PLUMB_FOUR_BALLS) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_FOUR_BALLS
#undef PLUMB_FOUR_BALLS
#else
#define PLUMB_FOUR_BALLS
#endif

#include <hwy/highway.h>

#include "plumb/arith/ball.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::arith::HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX2

struct Four {
  __m256d v;
  friend HWY_INLINE Four operator+(const Four& a, const Four& b) { return {_mm256_add_pd(a.v, b.v)}; }
  friend HWY_INLINE Four operator-(const Four& a, const Four& b) { return {_mm256_sub_pd(a.v, b.v)}; }
  friend HWY_INLINE Four operator*(const Four& a, const Four& b) { return {_mm256_mul_pd(a.v, b.v)}; }
};

struct FourBalls {
  Four high, low, radius;

  static HWY_INLINE FourBalls all(const Ball& x) { return {number(x.high), number(x.low), number(x.radius)}; }

  struct Truths {
    __m256d v;
    /// Bit i: lane i.
    [[nodiscard]] HWY_INLINE unsigned bits() const { return static_cast<unsigned>(_mm256_movemask_pd(v)); }
  };
  using Self = FourBalls;
  using Number = Four;
  using Truth = Truths;
  static constexpr double infinity = Ball::infinity;
  static HWY_INLINE Four number(double x) { return {_mm256_set1_pd(x)}; }
  static HWY_INLINE Four size(const Four& x) { return {_mm256_andnot_pd(_mm256_set1_pd(-0.0), x.v)}; }
  static HWY_INLINE Four negated(const Four& x) { return {_mm256_xor_pd(_mm256_set1_pd(-0.0), x.v)}; }
  static HWY_INLINE Truths at_most(const Four& a, const Four& b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_LE_OQ)}; }
  static HWY_INLINE Truths above(const Four& a, const Four& b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_GT_OQ)}; }
  static HWY_INLINE Truths is_zero(const Four& x) { return {_mm256_cmp_pd(x.v, _mm256_setzero_pd(), _CMP_EQ_OQ)}; }
  static HWY_INLINE Truths both(const Truths& a, const Truths& b) { return {_mm256_and_pd(a.v, b.v)}; }
  static HWY_INLINE Truths either(const Truths& a, const Truths& b) { return {_mm256_or_pd(a.v, b.v)}; }
  static HWY_INLINE Four chosen(const Truths& first, const Four& a, const Four& b) {
    return {_mm256_blendv_pd(b.v, a.v, first.v)};
  }
  struct FourRounded {
    Four value, error;
  };
  static HWY_INLINE FourRounded two_sum(const Four& a, const Four& b) {
    const Four s = a + b, b_part = s - a;
    return {s, (a - (s - b_part)) + (b - b_part)};
  }
  static HWY_INLINE FourRounded two_product(const Four& a, const Four& b) {
    const Four p = a * b;
    return {p, {_mm256_fmsub_pd(a.v, b.v, p.v)}};
  }
#define PLUMB_BALL_INLINE HWY_INLINE
#include "plumb/arith/detail/ball_text.hpp"
#undef PLUMB_BALL_INLINE

  /// Which lanes are certainly positive?  As Ball::sign().
  [[nodiscard]] HWY_INLINE unsigned positive() const {
    return either(above(high * number(0.5), radius), both(is_zero(radius), above(high, number(0)))).bits();
  }
};

#endif

}  // namespace plumb::arith::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
