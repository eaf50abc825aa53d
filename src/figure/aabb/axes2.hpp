// Separating axis test in the plane: are a segment or a triangle and a box with the axes of the plane apart?  Stated once,
// over any world whose numbers have an edge of the triangle a lane (certify/three_axes.hpp, certify/exact_axes.hpp).
//
// The box is seen from its center, twice as large: p' = (p - min) + (p - max), and |x'| <= max - min.  Across the edge e of
// a triangle with twice the area n the gap is
//   |e x p' + n| - (|n| + |e.x| h.y + |e.y| h.x),
// for the third corner is 2 n farther than the edge.
// Included once for each target by files that Highway compiles for several.
// Laws: the relation is that of the closed sets, as far as the world tells it.  A box that is flat, a segment of equal ends
// and a triangle without area get their answer where no gap is zero; an empty box none.
// Source: RTCD 5.2.1, 5.2.9, 5.3.3.
// Cost: that of the world.
#if defined(PLUMB_BOX_AXES2) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_BOX_AXES2
#undef PLUMB_BOX_AXES2
#else
#define PLUMB_BOX_AXES2
#endif

#include "certify/three_axes.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/figure/basic/simplex.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::figure::box_axes2::HWY_NAMESPACE {

/// A point as given: x, and y twice.
template <class W>
HWY_INLINE auto of_plane(W& w, const Point2& p) {
  return w.given(p.x, p.y, p.y);
}

/// What a box is to corners, of each of which a lane has a coordinate: their differences from its lower end, where they are
/// from its center, twice, and its width.
template <class From, class Place, class Width>
struct Beside {
  From from_min;
  Place place;
  Width width;
};
template <class From, class Place, class Width>
Beside(From, Place, Width) -> Beside<From, Place, Width>;

template <std::size_t scale, int lane, class W, class P, class B>
HWY_INLINE auto beside(W& w, const P& corners, const B& min, const B& max) {
  const auto low = spread<lane>(min), high = spread<lane>(max);
  const auto from_min = w.template difference<scale>(corners, low);
  const auto from_max = w.template difference<scale>(corners, high);
  const auto width = w.template difference_within<scale>(high, low, from_min, from_max);
  w.require(w.not_negative(width));
  return Beside{from_min, from_min + from_max, width};
}

/// How far a box of these widths reaches across these edges.
template <class X, class Y, class H, class V>
HWY_INLINE auto reach(const X& edge_x, const Y& edge_y, const H& width_x, const V& width_y) {
  return plus_product(magnitude(edge_x) * width_y, magnitude(edge_y), width_x);
}

struct SegmentAndBox2 {
  static constexpr int highest = 2;
  static constexpr Scales scales{.count = 2};
  template <class W>
  HWY_INLINE Relation operator()(W& w, const Segment2& s, const Aabb2& b) const {
    const auto p = of_plane(w, s.a), q = of_plane(w, s.b), min = of_plane(w, b.min), max = of_plane(w, b.max);
    auto gaps = w.gaps();
    gaps.heed(larger(w.order(smaller(p, q), max), w.order(min, larger(p, q))));
    const auto from_x = spread<0>(p), from_y = spread<1>(p);
    const auto x = beside<0, 0>(w, from_x, min, max);
    const auto y = beside<1, 1>(w, from_y, min, max);
    const auto way_x = w.template difference<0>(spread<0>(q), from_x);
    const auto way_y = w.template difference<1>(spread<1>(q), from_y);
    gaps.heed(magnitude(minus_product(way_x * y.place, way_y, x.place)) - reach(way_x, way_y, x.width, y.width), way_x,
              way_y);
    return gaps.template relation<Relation>(x.width, y.width);
  }
};

struct TriangleAndBox2 {
  static constexpr int highest = 2;
  static constexpr Scales scales{.count = 2};
  template <class W>
  HWY_INLINE Relation operator()(W& w, const Triangle2& t, const Aabb2& b) const {
    const auto p = of_plane(w, t.a), q = of_plane(w, t.b), r = of_plane(w, t.c);
    const auto min = of_plane(w, b.min), max = of_plane(w, b.max);
    auto gaps = w.gaps();
    gaps.heed(larger(w.order(smaller(smaller(p, q), r), max), w.order(min, larger(larger(p, q), r))));
    const auto corners = transposed(p, q, r);
    const auto x = beside<0, 0>(w, corners.x, min, max);
    const auto y = beside<1, 1>(w, corners.y, min, max);
    const auto edge_x = w.template difference_within<0>(turned(corners.x), corners.x, turned(x.from_min), x.from_min);
    const auto edge_y = w.template difference_within<1>(turned(corners.y), corners.y, turned(y.from_min), y.from_min);
    const auto area = minus_product(edge_x * turned(edge_y), turned(edge_x), edge_y);
    const auto at = minus_product(edge_x * y.place, edge_y, x.place) + area;
    gaps.heed(magnitude(at) - (magnitude(area) + reach(edge_x, edge_y, x.width, y.width)), edge_x, edge_y);
    return gaps.template relation<Relation>(x.width, y.width);
  }
};

}  // namespace plumb::figure::box_axes2::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
