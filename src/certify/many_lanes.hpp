// As many numbers at once as the machine has lanes, each of a question of its own: the world of doubles over vectors.
//
// Included once for each target by files that Highway compiles for several.
// Laws: those of plumb/certify/detail/floats_text.hpp, lane by lane; every lane has scales of its own.  A lane's signs
// may be believed where it is in_range().
// Source: RTCD 13.7; docs/proof.md, "Tracked errors".
// Cost: none.
#if defined(PLUMB_MANY_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_MANY_LANES
#undef PLUMB_MANY_LANES
#else
#define PLUMB_MANY_LANES
#endif

#include <hwy/highway.h>

#include <array>
#include <optional>

#include "plumb/arith/interval.hpp"
#include "plumb/arith/track.hpp"
#include "plumb/certify/certainly.hpp"
#include "plumb/certify/world.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::certify::many_lanes::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<double, 8>;

struct Many {
  hn::Vec<Lanes> v;
};
struct Truth {
  hn::Mask<Lanes> v;
};

HWY_INLINE Many of_all(double x) { return {hn::Set(Lanes(), x)}; }
HWY_INLINE Many of_all(const Many& a) { return a; }
HWY_INLINE Many loaded(double x) { return of_all(x); }
HWY_INLINE Many loaded(const Many& a) { return a; }
HWY_INLINE Many operator+(const Many& a, const Many& b) { return {hn::Add(a.v, b.v)}; }
HWY_INLINE Many operator-(const Many& a, const Many& b) { return {hn::Sub(a.v, b.v)}; }
HWY_INLINE Many operator*(const Many& a, const Many& b) { return {hn::Mul(a.v, b.v)}; }
HWY_INLINE Many plus_product(const Many& sum, const Many& a, const Many& b) { return {hn::MulAdd(a.v, b.v, sum.v)}; }
HWY_INLINE Many minus_product(const Many& sum, const Many& a, const Many& b) {
  return {hn::NegMulAdd(a.v, b.v, sum.v)};
}
HWY_INLINE Many size(const Many& a) { return {hn::Abs(a.v)}; }
HWY_INLINE Many larger(const Many& a, const Many& b) { return {hn::Max(a.v, b.v)}; }
HWY_INLINE Many smaller(const Many& a, const Many& b) { return {hn::Min(a.v, b.v)}; }
HWY_INLINE Many total(const Many& a) { return a; }
HWY_INLINE Many largest(const Many& a) { return a; }
HWY_INLINE Truth above(const Many& a, const Many& b) { return {hn::Gt(a.v, b.v)}; }
HWY_INLINE Truth at_most(const Many& a, const Many& b) { return {hn::Le(a.v, b.v)}; }
HWY_INLINE Truth is_zero(const Many& a) { return {hn::Eq(a.v, hn::Zero(Lanes()))}; }
HWY_INLINE Truth operator&(const Truth& a, const Truth& b) { return {hn::And(a.v, b.v)}; }
HWY_INLINE Truth operator|(const Truth& a, const Truth& b) { return {hn::Or(a.v, b.v)}; }
HWY_INLINE Truth both(const Truth& a, const Truth& b) { return a & b; }
HWY_INLINE Many chosen(const Truth& t, const Many& yes, const Many& no) { return {hn::IfThenElse(t.v, yes.v, no.v)}; }
HWY_INLINE bool any(const Truth& t) { return !hn::AllFalse(Lanes(), t.v); }
HWY_INLINE bool all(const Truth& t) { return hn::AllTrue(Lanes(), t.v); }
/// No more, and no less, than what was rounded to x, as Interval::step says.
HWY_INLINE Many step(const Many& x) {
  // Not fused: to a product and a subnormal sum in one go processors take a hundred times as long.
  return size(x) * of_all(Interval::part_of_step) + of_all(Interval::least_step);
}
HWY_INLINE Many below(const Many& x) { return x - step(x); }
HWY_INLINE Many beyond(const Many& x) { return x + step(x); }
/// Lane by lane, a bit each.
HWY_INLINE unsigned bits_of(const Truth& t) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(Lanes(), t.v, bits);
  return bits[0];
}

#define PLUMB_PAIRS_TEXT
#include "plumb/certify/detail/pairs_text.hpp"
#define PLUMB_FLOATS_TEXT
#include "plumb/certify/detail/floats_text.hpp"

}  // namespace plumb::certify::many_lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
