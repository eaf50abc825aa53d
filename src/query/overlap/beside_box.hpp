// Separating axis test in lanes: along which axes is a triangle apart from a box with the axes of space, or a segment?
//
// The box is seen from its center, twice as large: p' = 2 p - (min + max), and |x'| <= max - min.  Along the cross
// product of axis k and the edge e of a triangle with normal n the gap is
//   |e x p' + n|_k - (|n_k| + reach of the box),
// for the third corner is 2 n_k farther than the edge.
// Over any world of doubles (certify/world.hpp), of one number or of lanes of them; each axis has a scale.
// Included once for each target by files that Highway compiles for several.
// Laws: the gap is positive where the axis separates them, and negative where along it they overlap.
// Source: RTCD 5.2.9, 5.3.3.
// Cost: that of the plain operations, and a magnitude and a sum for each number given.
#if defined(PLUMB_BESIDE_BOX) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_BESIDE_BOX
#undef PLUMB_BESIDE_BOX
#else
#define PLUMB_BESIDE_BOX
#endif

#include <hwy/highway.h>

#include "plumb/arith/track.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::query::beside_box::HWY_NAMESPACE {

/// Numbers of the three axes, each of its own scale.
template <class X, class Y, class Z>
struct PerAxis {
  X x;
  Y y;
  Z z;
};
template <class X, class Y, class Z>
PerAxis(X, Y, Z) -> PerAxis<X, Y, Z>;

template <class A, class B>
HWY_INLINE auto cross(const A& a, const B& b) {
  return PerAxis{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class A, class B>
HWY_INLINE auto dot(const A& a, const B& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
template <class A, class B>
HWY_INLINE auto sum(const A& a, const B& b) {
  return PerAxis{a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class A, class B>
HWY_INLINE auto difference(const A& a, const B& b) {
  return PerAxis{a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class A>
HWY_INLINE auto sizes(const A& a) {
  return PerAxis{magnitude(a.x), magnitude(a.y), magnitude(a.z)};
}
template <class A, class B, class C>
HWY_INLINE auto largest_of(const A& a, const B& b, const C& c) {
  return PerAxis{larger(larger(a.x, b.x), c.x), larger(larger(a.y, b.y), c.y), larger(larger(a.z, b.z), c.z)};
}
/// How far a box of these extents reaches along the cross products of the axes and e.
template <class E, class H>
HWY_INLINE auto reach(const E& e, const H& half) {
  const auto s = sizes(e);
  return PerAxis{s.y * half.z + s.z * half.y, s.z * half.x + s.x * half.z, s.x * half.y + s.y * half.x};
}
template <class E, class P, class H, class N, class S>
HWY_INLINE auto gaps_of_edge(const E& e, const P& p, const H& half, const N& n, const S& size_of_n) {
  return difference(sizes(sum(cross(e, p), n)), sum(size_of_n, reach(e, half)));
}

/// A point of which each coordinate is what the world makes numbers of.
template <class V>
struct Place {
  V x, y, z;
};
template <class W, class A, class B>
HWY_INLINE auto difference_of(W& w, const A& to, const B& from) {
  return PerAxis{w.template difference<0>(w.given(to.x), w.given(from.x)),
                 w.template difference<1>(w.given(to.y), w.given(from.y)),
                 w.template difference<2>(w.given(to.z), w.given(from.z))};
}
template <class W, class A, class B>
HWY_INLINE auto sum_of(W& w, const A& a, const B& b) {
  return PerAxis{w.template sum<0>(w.given(a.x), w.given(b.x)), w.template sum<1>(w.given(a.y), w.given(b.y)),
                 w.template sum<2>(w.given(a.z), w.given(b.z))};
}
inline constexpr Scales each_axis{.count = 3};

struct TriangleBesideBox {
  static constexpr Scales scales = each_axis;
  static constexpr int highest = 3;

  /// Calls judge with each gap; those of the box's own axes are told by what is given.
  template <class W, class P, class Q, class Judge>
  HWY_INLINE void operator()(W& w, const P& a, const P& b, const P& c, const Q& min, const Q& max, Judge& judge) const {
    const auto center = sum_of(w, min, max),
               half = difference_of(w, max, min);  // first: all triangles have them in common
    const auto ab = difference_of(w, b, a), bc = difference_of(w, c, b), ca = difference_of(w, a, c);
    const auto at_a = difference(sum_of(w, a, a), center), at_b = difference(sum_of(w, b, b), center),
               at_c = difference(sum_of(w, c, c), center);
    const auto n = cross(ab, bc);
    const auto size_of_n = sizes(n);
    const auto gaps = largest_of(gaps_of_edge(ab, at_a, half, n, size_of_n), gaps_of_edge(bc, at_b, half, n, size_of_n),
                                 gaps_of_edge(ca, at_c, half, n, size_of_n));
    judge(w, gaps.x);
    judge(w, gaps.y);
    judge(w, gaps.z);
    judge(w, magnitude(dot(n, at_a)) - dot(size_of_n, half));
  }
};

struct SegmentBesideBox {
  static constexpr Scales scales = each_axis;
  static constexpr int highest = 2;

  /// `across`: along the cross products of which axes and the segment is there something to judge?
  template <class W, class P, class Q, class Judge>
  HWY_INLINE void operator()(W& w, const P& a, const P& b, const Q& min, const Q& max, const bool (&across)[3],
                             Judge& judge) const {
    const auto d = difference_of(w, b, a), center = sum_of(w, a, b);  // first: all boxes have them in common
    const auto half = difference_of(w, max, min);
    const auto p = difference(center, sum_of(w, min, max));
    const auto gaps = difference(sizes(cross(d, p)), reach(d, half));
    if (across[0]) judge(w, gaps.x);
    if (across[1]) judge(w, gaps.y);
    if (across[2]) judge(w, gaps.z);
  }
};

}  // namespace plumb::query::beside_box::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
