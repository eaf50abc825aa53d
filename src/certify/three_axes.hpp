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

#define PLUMB_FLOATS_TEXT
#include "plumb/certify/detail/floats_text.hpp"

/// Lane k has what lane k + 1 had, or k + 2.
template <Track A>
HWY_INLINE auto turned(const Tracked<Three, A>& a) {
  return Tracked<Three, derive::turned(A)>{turned(a.value)};
}
template <Track A>
HWY_INLINE auto turned_back(const Tracked<Three, A>& a) {
  return Tracked<Three, derive::turned(derive::turned(A))>{turned_back(a.value)};
}
/// The sum of all lanes, in each.
template <Track A>
HWY_INLINE auto total(const Tracked<Three, A>& a) {
  return Tracked<Three, derive::total(A)>{of_all(total(a.value))};
}
template <int lane, Track A>
HWY_INLINE auto spread(const Tracked<Three, A>& a) {
  return Tracked<Three, derive::alike_in_all(A)>{spread<lane>(a.value)};
}
/// The cross product in the order (z, x, y), of vectors that are given with themselves turned.
template <class A, class AT, class B, class BT>
HWY_INLINE auto crossed(const A& a, const AT& a_turned, const B& b, const BT& b_turned) {
  return minus_product(a * b_turned, a_turned, b);
}

template <class T>
struct ColumnsOf {
  T x, y, z;
};
HWY_INLINE ColumnsOf<Given<Three>> transposed(const Given<Three>& a, const Given<Three>& b, const Given<Three>& c) {
  const Columns all = transposed(a.value, b.value, c.value);
  return {{all.x}, {all.y}, {all.z}};
}
template <Track A>
HWY_INLINE auto transposed(const Tracked<Three, A>& a, const Tracked<Three, A>& b, const Tracked<Three, A>& c) {
  using T = Tracked<Three, derive::alike_in_all(A)>;
  const Columns all = transposed(a.value, b.value, c.value);
  return ColumnsOf<T>{{all.x}, {all.y}, {all.z}};
}

}  // namespace plumb::certify::three_lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
