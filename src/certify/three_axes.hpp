// A vector of space whose numbers' errors are derived: the world of doubles over certify/three_lanes.hpp, an axis a lane.
//
// Included once for each target by files that Highway compiles for several.
// Laws: those of plumb/certify/detail/floats_text.hpp.  Numbers of different axes are added up, or one is spread over
// all, where the axes have one scale or equal parts in it.
// Source: RTCD 13.7; docs/proof.md, "Tracked errors".
// Cost: none.
#if defined(PLUMB_THREE_AXES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_THREE_AXES
#undef PLUMB_THREE_AXES
#else
#define PLUMB_THREE_AXES
#endif

#include <hwy/highway.h>

#include <array>
#include <optional>

#include "certify/three_lanes.hpp"
#include "plumb/arith/track.hpp"
#include "plumb/certify/world.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::certify::three_lanes::HWY_NAMESPACE {

#define PLUMB_PAIRS_TEXT
#include "plumb/certify/detail/pairs_text.hpp"
HWY_INLINE Three total_in_all(const Three& a) { return of_all(total(a)); }
HWY_INLINE Pair<Three> turned(const Pair<Three>& a) { return {turned(a.high), turned(a.low)}; }
HWY_INLINE Pair<Three> turned_back(const Pair<Three>& a) { return {turned_back(a.high), turned_back(a.low)}; }
HWY_INLINE Pair<Three> total_in_all(const Pair<Three>& a) { return (a + turned(a)) + turned_back(a); }
template <int lane>
HWY_INLINE Pair<Three> spread(const Pair<Three>& a) {
  return {spread<lane>(a.high), spread<lane>(a.low)};
}
struct PairColumns {
  Pair<Three> x, y, z;
};
HWY_INLINE PairColumns transposed(const Pair<Three>& a, const Pair<Three>& b, const Pair<Three>& c) {
  const Columns high = transposed(a.high, b.high, c.high), low = transposed(a.low, b.low, c.low);
  return {{high.x, low.x}, {high.y, low.y}, {high.z, low.z}};
}

#define PLUMB_FLOATS_TEXT
#include "plumb/certify/detail/floats_text.hpp"

HWY_INLINE Given<Three> turned(const Given<Three>& a) { return {turned(a.value)}; }
template <int lane>
HWY_INLINE Given<Three> spread(const Given<Three>& a) {
  return {spread<lane>(a.value)};
}

/// Lane k has what lane k + 1 had, or k + 2.
template <class V, Track A>
HWY_INLINE auto turned(const Tracked<V, A>& a) {
  return Tracked<V, derive::turned(A)>{turned(a.value)};
}
template <class V, Track A>
HWY_INLINE auto turned_back(const Tracked<V, A>& a) {
  return Tracked<V, derive::turned(derive::turned(A))>{turned_back(a.value)};
}
/// The sum of all lanes, in each.
template <class V, Track A>
HWY_INLINE auto total(const Tracked<V, A>& a) {
  return Tracked<V, derive::total(A)>{total_in_all(a.value)};
}
template <int lane, class V, Track A>
HWY_INLINE auto spread(const Tracked<V, A>& a) {
  return Tracked<V, derive::alike_in_all(A)>{spread<lane>(a.value)};
}
/// The cross product in the order (z, x, y), of vectors that are given with themselves turned.
template <class A, class AT, class B, class BT>
HWY_INLINE auto crossed(const A& a, const AT& a_turned, const B& b, const BT& b_turned) {
  return minus_product(a * b_turned, a_turned, b);
}

/// To which of three vectors, given by their columns, is v parallel, or zero, for certain?  In the order (z, x, y).  Asked of
/// leaves of scales s and t over pairs: of doubles nothing is known of it.
template <std::size_t s, std::size_t t, class W, class C, class V>
HWY_INLINE auto parallel(const W& w, const C& columns, const V& v) {
  if constexpr (requires { requires W::of_pairs; }) {
    static_assert(V::track.low == 0 && V::track.error == 0);
    const Three x = spread<0>(v.value.high), y = spread<1>(v.value.high), z = spread<2>(v.value.high);
    const auto equal = [](const Three& a, const Three& b, const Three& c, const Three& d) HWY_ATTR {
      const Three p = a * b, q = c * d;
      return is_zero(p - q) & is_zero(product_error(a, b, p) - product_error(c, d, q));
    };
    const Three ax = turned_back(columns.x.value.high), ay = turned_back(columns.y.value.high),
                az = turned_back(columns.z.value.high);
    constexpr double safe_unit = 0x1p-1000;  // a power of two: of its multiples products lose nothing to underflow
    const Truth in_range = above(w.template unit<s>() * w.template unit<t>(), of_all(safe_unit));
    return in_range & equal(ay, z, az, y) & equal(az, x, ax, z) & equal(ax, y, ay, x);
  } else {
    return std::false_type();
  }
}

template <class T>
struct ColumnsOf {
  T x, y, z;
};
HWY_INLINE ColumnsOf<Given<Three>> transposed(const Given<Three>& a, const Given<Three>& b, const Given<Three>& c) {
  const Columns all = transposed(a.value, b.value, c.value);
  return {{all.x}, {all.y}, {all.z}};
}
template <class V, Track A>
HWY_INLINE auto transposed(const Tracked<V, A>& a, const Tracked<V, A>& b, const Tracked<V, A>& c) {
  using T = Tracked<V, derive::alike_in_all(A)>;
  const auto all = transposed(a.value, b.value, c.value);
  return ColumnsOf<T>{{all.x}, {all.y}, {all.z}};
}

}  // namespace plumb::certify::three_lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
