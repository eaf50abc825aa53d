// What is a number exactly, to some hundred bits?  plumb/arith/ball.hpp in lanes, each of a question of its own: it knows
// which sums lose nothing.
//
// Included once for each target by files that Highway compiles for several; there are lanes for AVX2 alone.
// Laws: those of plumb/arith/ball.hpp, lane by lane: the text of sums and products is the same.
// Source: Dekker 1971; RTCD 13.7.
// Cost: 26 operations a sum, 50 a product, of as many numbers.
#if defined(PLUMB_MANY_BALLS) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_MANY_BALLS
#undef PLUMB_MANY_BALLS
#else
#define PLUMB_MANY_BALLS
#endif

#include <hwy/highway.h>

#include "certify/many_twofolds.hpp"
#include "plumb/arith/ball.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::query::touching::many_balls::HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX2

namespace lanes = certify::many_lanes::HWY_NAMESPACE;

struct Balls {
  lanes::Many high, low, radius;

  using Self = Balls;
  using Number = lanes::Many;
  using Truth = lanes::Truth;
  static constexpr double infinity = Ball::infinity;
  static HWY_INLINE Number number(double x) { return lanes::of_all(x); }
  static HWY_INLINE Number size(const Number& x) { return lanes::size(x); }
  static HWY_INLINE Number negated(const Number& x) { return lanes::Twofolds::negated(x); }
  static HWY_INLINE Truth at_most(const Number& a, const Number& b) { return lanes::at_most(a, b); }
  static HWY_INLINE Truth above(const Number& a, const Number& b) { return lanes::above(a, b); }
  static HWY_INLINE Truth is_zero(const Number& x) { return lanes::is_zero(x); }
  static HWY_INLINE Truth both(const Truth& a, const Truth& b) { return a & b; }
  static HWY_INLINE Truth either(const Truth& a, const Truth& b) { return a | b; }
  static HWY_INLINE Number chosen(const Truth& t, const Number& a, const Number& b) { return lanes::chosen(t, a, b); }
  static HWY_INLINE lanes::Twofolds::Rounded two_sum(const Number& a, const Number& b) {
    return lanes::Twofolds::two_sum(a, b);
  }
  static HWY_INLINE lanes::Twofolds::Rounded two_product(const Number& a, const Number& b) {
    return lanes::Twofolds::product(a, b);
  }
#define PLUMB_BALL_INLINE HWY_INLINE
#include "plumb/arith/detail/ball_text.hpp"
#undef PLUMB_BALL_INLINE

  static HWY_INLINE Balls exact(const Number& x) { return {x, number(0), number(0)}; }
  [[nodiscard]] HWY_INLINE Truth is_exact() const { return is_zero(radius); }
};

#endif

}  // namespace plumb::query::touching::many_balls::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
