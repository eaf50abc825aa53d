// Point to segment, point to triangle: between which numbers is the square of the distance?  Weak duality: a point that is
// guessed bounds it from above, and the plane through that point, square to the way there, from below.
//
// With r the way from p to any point of the figure, the square is no more than r.r.  With q the way to any point of the
// figure, q.q is no less than 2 q.r - r.r, whatever r is, for |q - r|^2 is not negative; and that is least at a corner.
// Both are equal where r is the way to the nearest point.
// Over any world of doubles (certify/world.hpp), of one number or of lanes of them; what is guessed are portions.
// Included once for each target by files that Highway compiles for several.
// Source: RTCD 5.1.2, 5.1.5; 9.5.2 for the bound from below.
// Cost: 3 products for r on an edge, 6 on a face, and 3 for each corner.
#if defined(PLUMB_DISTANCE_BOUNDS) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_DISTANCE_BOUNDS
#undef PLUMB_DISTANCE_BOUNDS
#else
#define PLUMB_DISTANCE_BOUNDS
#endif

#include <hwy/highway.h>

#include "plumb/arith/track.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::query::distance_bounds::HWY_NAMESPACE {

template <class N>
struct Way {
  N x, y, z;
};
template <class N>
Way(N, N, N) -> Way<N>;

/// The square of the distance is no less than one, and no more than the other.
template <class L, class U>
struct Between {
  L lower;
  U upper;
};
template <class L, class U>
Between(L, U) -> Between<L, U>;

struct DistanceBounds {
  static constexpr Scales scales{};
  static constexpr int highest = 2;

  /// From p to a corner.
  template <class W, class P, class Q>
  static HWY_INLINE auto way(W& w, const P& p, const Q& corner) {
    return Way{w.difference(corner.x, p.x), w.difference(corner.y, p.y), w.difference(corner.z, p.z)};
  }
  /// From the corner a to the corner b, to which there are ways from p.
  template <class W, class P, class N>
  static HWY_INLINE auto edge(W& w, const P& a, const P& b, const Way<N>& to_a, const Way<N>& to_b) {
    return Way{w.difference_within(w.given(b.x), w.given(a.x), to_a.x, to_b.x),
               w.difference_within(w.given(b.y), w.given(a.y), to_a.y, to_b.y),
               w.difference_within(w.given(b.z), w.given(a.z), to_a.z, to_b.z)};
  }
  /// From p to q + t d, for a portion t.
  template <class Q, class D, class T>
  static HWY_INLINE auto along(const Way<Q>& q, const Way<D>& d, const T& t) {
    return Way{plus_product(q.x, d.x, t), plus_product(q.y, d.y, t), plus_product(q.z, d.z, t)};
  }
  template <class A, class B>
  static HWY_INLINE auto dot(const Way<A>& a, const Way<B>& b) {
    return plus_product(plus_product(a.x * b.x, a.y, b.y), a.z, b.z);
  }
  /// Of a point itself.
  template <class Q>
  static HWY_INLINE auto between(const Way<Q>& q) {
    const auto square = dot(q, q);
    return Between{square, square};
  }
  /// By the way r to a point of the figure, its square, and the ways to the figure's corners.
  template <class R, class S, class Q, class... More>
  static HWY_INLINE auto between(const Way<R>& r, const S& square, const Way<Q>& corner, const Way<More>&... more) {
    auto least = dot(corner, r);
    ((least = smaller(least, dot(more, r))), ...);
    return Between{twice(least) - square, square};
  }
};

}  // namespace plumb::query::distance_bounds::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
