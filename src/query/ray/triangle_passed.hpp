// Ray against triangle: on which sides of the edges does a line pass, and where does it meet the plane?
//
// With the corners A, B, C seen from the origin and the direction d, the line passes the edge from P to Q at
// d . (Q x P), positive on its left; the plane is met at t = N / D with N = A . (C x B) and D the sum of the three.
// Over any world of doubles (certify/world.hpp), of one number or of lanes of them; each axis has a scale of the largest
// that a corner is away, and scale 0 has |d_x| Y Z + |d_y| Z X + |d_z| X Y.
// Included once for each target by files that Highway compiles for several.
// Laws: a lane is told nothing of where its sum is not real, which has all leaves in it.
// Source: RTCD 5.3.4; Moller and Trumbore 1997.
// Cost: 30 products for all of it, of which 18 are of the triangle and the origin alone.
#if defined(PLUMB_TRIANGLE_PASSED) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_TRIANGLE_PASSED
#undef PLUMB_TRIANGLE_PASSED
#else
#define PLUMB_TRIANGLE_PASSED
#endif

#include <hwy/highway.h>

#include "plumb/arith/track.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::query::triangle_passed::HWY_NAMESPACE {

template <class X, class Y, class Z>
struct Of3 {
  X x;
  Y y;
  Z z;
};
template <class X, class Y, class Z>
Of3(X, Y, Z) -> Of3<X, Y, Z>;

template <class A, class B>
HWY_INLINE auto cross(const A& a, const B& b) {
  return Of3{minus_product(a.y * b.z, a.z, b.y), minus_product(a.z * b.x, a.x, b.z),
             minus_product(a.x * b.y, a.y, b.x)};
}
template <class A, class B>
HWY_INLINE auto dot(const A& a, const B& b) {
  return plus_product(plus_product(a.x * b.x, a.y, b.y), a.z, b.z);
}

/// A triangle from an origin: all that the direction has no part in.
template <class Corner, class Normal>
struct Seen {
  Corner a;
  Normal of_ab, of_bc, of_ca;

  /// Of the plane: N.
  [[nodiscard]] HWY_INLINE auto height() const { return dot(a, of_bc); }
};
template <class Corner, class Normal>
Seen(Corner, Normal, Normal, Normal) -> Seen<Corner, Normal>;

/// The least and the most of the three sides, and their sum D.
template <class Side, class Sum>
struct Sides {
  Side least, most;
  Sum sum;
};
template <class Side, class Sum>
Sides(Side, Side, Sum) -> Sides<Side, Sum>;

struct TrianglePassed {
  static constexpr Scales scales{.count = 4, .maxima = 0b1110, .crosswise = true};
  static constexpr int highest = 3;

  template <class W, class O, class P>
  static HWY_INLINE auto seen(W& w, const O& origin, const P& p, const P& q, const P& r) {
    const auto a = corner(w, origin, p), b = corner(w, origin, q), c = corner(w, origin, r);
    return Seen{a, cross(b, a), cross(c, b), cross(a, c)};
  }

  /// Of a segment the direction is a difference that was rounded once: so it is taken for one of all.
  template <class W, class D, class S>
  static HWY_INLINE auto sides(W& w, const D& direction, const S& seen) {
    const auto d = Of3{w.template crosswise<1>(direction.x, 0.0), w.template crosswise<2>(direction.y, 0.0),
                       w.template crosswise<3>(direction.z, 0.0)};
    const auto ab = side(w, d, seen.of_ab), bc = side(w, d, seen.of_bc), ca = side(w, d, seen.of_ca);
    return Sides{smaller(smaller(ab, bc), ca), larger(larger(ab, bc), ca), (ab + bc) + ca};
  }

  /// N - D, whose sign beyond the end of a segment is that of D.
  template <class N, class D>
  static HWY_INLINE auto beyond_end(const N& height, const D& sum) {
    return difference_of_unlike(height, sum);
  }

 private:
  template <class W, class O, class P>
  static HWY_INLINE auto corner(W& w, const O& origin, const P& p) {
    return Of3{w.template difference<1>(p.x, origin.x), w.template difference<2>(p.y, origin.y),
               w.template difference<3>(p.z, origin.z)};
  }
  template <class W, class D, class N>
  static HWY_INLINE auto side(const W& w, const D& d, const N& normal) {
    return w.sum_crosswise(d.x, normal.x, d.y, normal.y, d.z, normal.z);
  }
};

}  // namespace plumb::query::triangle_passed::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
