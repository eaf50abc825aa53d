// Separating axis test: along which axes are a box and what is straight, or a triangle, apart?  Stated once, over any
// world whose numbers have an axis a lane (certify/three_axes.hpp, certify/exact_axes.hpp).
//
// A box with the axes of space is seen from its center, twice as large: p' = (p - min) + (p - max), and |x'| <= max -
// min.  Along the cross product of axis k and the edge e of a triangle with normal n the gap is
//   |e x p' + n|_k - (|n_k| + reach of the box),
// for the third corner is 2 n_k farther than the edge.
// Included once for each target by files that Highway compiles for several.
// Laws: the relation is that of the closed sets, as far as the world tells it.  A box that is flat or a triangle without
// area gets its answer where no gap is zero; an empty box none.
// Source: Akenine-Moller 2001; RTCD 5.2.9, 5.3.3.
// Cost: that of the world.
#if defined(PLUMB_BOX_AXES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_BOX_AXES
#undef PLUMB_BOX_AXES
#else
#define PLUMB_BOX_AXES
#endif

#include "certify/three_axes.hpp"
#include "figure/obb/fifteen_axes.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/figure/basic/round.hpp"
#include "query/overlap/linear3.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::query::box_axes::HWY_NAMESPACE {

using certify::three_lanes::HWY_NAMESPACE::crossed;
namespace fifteen_axes = figure::fifteen_axes::HWY_NAMESPACE;
using fifteen_axes::along, fifteen_axes::cofactors;

/// What a box with the axes of space is to a world.
template <class W>
struct Sides {
  decltype(std::declval<W&>().given(Point3())) min, max;

  HWY_INLINE Sides(W& w, const Aabb3& b) : min(w.given(b.min)), max(w.given(b.max)) {}
};

/// A sum of two products of the next axis and the one after.
template <class A, class AT, class B, class BT>
HWY_INLINE auto turned_product(const A& a, const AT& a_turned, const B& b, const BT& b_turned) {
  return plus_product(a * b_turned, a_turned, b);
}

/// Along the cross products of the way and the axes of a box of these widths, of a point of what is straight; an axis
/// parallel to the way is none to look along.
template <class Gaps, class P, class D, class H>
HWY_INLINE void across_way(Gaps& gaps, const P& point, const D& way, const H& width) {
  const auto way_turned = turned(way);
  gaps.heed(magnitude(crossed(point, turned(point), way, way_turned)) -
                turned_product(width, turned(width), magnitude(way), magnitude(way_turned)),
            way, way_turned);
}

struct SegmentAndBox {
  static constexpr int highest = 2;
  static constexpr Scales scales{.count = 2, .each_axis = 0b11};
  template <class W>
  HWY_INLINE Relation operator()(W& w, const Segment3& s, const Aabb3& b) const {
    const auto [min, max] = Sides<W>(w, b);
    const auto p = w.given(s.a), q = w.given(s.b);
    const auto from_min = w.difference(p, min), from_max = w.difference(p, max);
    const auto way = w.template difference<1>(q, p);
    const auto width = w.difference_within(max, min, from_min, from_max);
    w.require(w.not_negative(width));
    auto gaps = w.gaps();
    gaps.heed(larger(w.order(smaller(p, q), max), w.order(min, larger(p, q))));
    across_way(gaps, from_min + from_max, way, width);
    return gaps.template relation<Relation>(width);
  }
};

template <LinearKind reach>
struct UnboundedAndBox {
  static constexpr int highest = 2;
  static constexpr Scales scales{.count = 2, .each_axis = 0b11};  // the direction may be of any length
  template <class W>
  HWY_INLINE Relation operator()(W& w, const Point3& from, const Vector3& direction, const Aabb3& b) const {
    const auto [min, max] = Sides<W>(w, b);
    const auto p = w.given(from);
    const auto from_min = w.difference(p, min), from_max = w.difference(p, max);
    const auto way = w.template number<1>(direction);
    const auto width = w.difference_within(max, min, from_min, from_max);
    w.require(w.not_negative(width));
    auto gaps = w.gaps();
    if constexpr (reach == LinearKind::ray) {
      gaps.heed(larger(w.unless(w.negative(way), w.order(p, max)), w.unless(w.positive(way), w.order(min, p))));
    } else if (w.is_all(w.zero(way))) {
      w.leave_open();
    }
    across_way(gaps, from_min + from_max, way, width);
    return gaps.template relation<Relation>(width);
  }
};

/// Of a triangle, seen from the center twice as large as its edges are: along the cross products of its edges and the
/// axes of a box of these widths, then along its normal.  `is_flat` says whether it has no normal.
template <class W, class Gaps, class C, class E, class H>
HWY_INLINE void across_triangle(W& w, Gaps& gaps, const C& corner, const E& edge, const H& width, const auto& is_flat) {
  const auto first_turned = turned(edge[0]);
  const auto second_turned = turned(edge[1]);
  const auto normal = crossed(edge[0], first_turned, edge[1], second_turned);  // in the order (z, x, y)
  const auto size_n = magnitude(normal);
  const auto width_turned = turned(width);
  const auto along_edge = [&](std::size_t i, const auto& edge_turned) HWY_ATTR {
    const auto reach = turned_product(width, width_turned, magnitude(edge[i]), magnitude(edge_turned));
    const auto at = crossed(edge[i], edge_turned, corner[i], turned(corner[i])) + normal;
    gaps.heed(magnitude(at) - (size_n + reach), edge[i], edge_turned);
  };
  along_edge(0, first_turned), along_edge(1, second_turned), along_edge(2, turned(edge[2]));
  const auto n = turned(normal);
  const auto gap = magnitude(total(n * corner[0])) - total(magnitude(n) * width);
  gaps.heed_above(gap);
  if (!w.is_all(w.negative(gap)) && !is_flat()) gaps.heed(gap, n, turned(n), turned_back(n));
}

struct TriangleAndBox {
  static constexpr int highest = 3;
  static constexpr Scales scales{.each_axis = 1};
  template <class W>
  HWY_INLINE Relation operator()(W& w, const Triangle3& t, const Aabb3& b) const {
    const auto [min, max] = Sides<W>(w, b);
    const auto p = w.given(t.a), q = w.given(t.b), r = w.given(t.c);
    auto gaps = w.gaps();
    gaps.heed(larger(w.order(smaller(smaller(p, q), r), max), w.order(min, larger(larger(p, q), r))));
    const auto p_min = w.difference(p, min), q_min = w.difference(q, min), r_min = w.difference(r, min);
    const auto p_max = w.difference(p, max), q_max = w.difference(q, max), r_max = w.difference(r, max);
    const std::array corner{p_min + p_max, q_min + q_max, r_min + r_max};
    const auto width = w.difference_within(max, min, p_min, p_max);
    w.require(w.not_negative(width));
    if (gaps.is_apart()) return Relation::disjoint;
    const std::array edge{w.difference_within(q, p, q_min, p_min), w.difference_within(r, q, r_min, q_min),
                          w.difference_within(p, r, p_min, r_min)};
    across_triangle(w, gaps, corner, edge, width, [&]() HWY_ATTR {
      // One with equal corners is a segment; across an axis the normal is that axis.
      const auto flat = w.zero(edge[0]) & w.zero(edge[1]) & w.zero(edge[2]);
      return w.is_any(flat) || t.a == t.b || t.b == t.c || t.c == t.a;
    });
    return gaps.template relation<Relation>(width);
  }
};

/// An oriented box is mapped to a box with the axes of a frame by the matrix of its cofactors, whose rows are its face
/// normals n_i: |n_i . 2 (p - c)| <= 2 half_i volume.  Its axes are of scale 1, a lane an axis of the box, and its half
/// extents weights over it.
template <class W>
HWY_INLINE auto columns_of(W& w, const Obb3& b) {
  const auto given = transposed(w.given(b.axes[0]), w.given(b.axes[1]), w.given(b.axes[2]));
  using Number = decltype(w.template number<1>(given.x));
  return fifteen_axes::CofactorsOf<Number>{w.template number<1>(given.x), w.template number<1>(given.y),
                                           w.template number<1>(given.z)};
}
/// Twice the half extents in the frame.
template <class W, class C, class N>
HWY_INLINE auto doubled_half(W& w, const Obb3& b, const C& columns, const N& normals) {
  return twice(magnitude(w.template weight<1>(w.given(b.half)))) *
         magnitude(along(normals, columns.x, columns.y, columns.z));
}
template <class N, class V>
HWY_INLINE auto seen_along(const N& normals, const V& v) {
  return along(normals, spread<0>(v), spread<1>(v), spread<2>(v));
}

/// Of a segment the way is to its other end; of a ray and a line it has a scale of its own.
template <LinearKind reach>
struct StraightAndObb {
  static constexpr bool is_segment = reach == LinearKind::segment;
  static constexpr int highest = 6;
  static constexpr Scales scales{.count = is_segment ? 2 : 3, .each_axis = 0b10, .weights = 0b10};
  template <class W>
  HWY_INLINE Relation operator()(W& w, const Point3& p, const auto& way_or_end, const Obb3& b) const {
    const auto columns = columns_of(w, b);
    const auto normals = cofactors(columns);
    const auto half = doubled_half(w, b, columns, normals);
    const auto from = w.difference(w.given(p), w.given(b.center));
    const auto way = [&]() HWY_ATTR {
      if constexpr (is_segment) {
        return w.difference(w.given(way_or_end), w.given(p));
      } else {
        return w.template number<2>(way_or_end);
      }
    }();
    // Of a segment the middle, else the origin; twice.
    const auto point = seen_along(normals, [&]() HWY_ATTR {
      if constexpr (is_segment) {
        return twice(from) + way;
      } else {
        return twice(from);
      }
    }());
    const auto d = seen_along(normals, way);
    const auto d_turned = turned(d);
    auto gaps = w.gaps();
    const auto gap = magnitude(crossed(point, turned(point), d, d_turned)) -
                     turned_product(half, turned(half), magnitude(d), magnitude(d_turned));
    gaps.heed(gap, d, d_turned);
    if constexpr (is_segment) gaps.heed((magnitude(point) - half) - magnitude(d));
    if constexpr (reach == LinearKind::ray) gaps.heed_ahead(d, point - half, negated(point) - half);
    if constexpr (!is_segment) gaps.need(w.positive(total(magnitude(way))));
    gaps.need(w.positive(half));
    return gaps.template relation<Relation>(half);
  }
};

struct TriangleAndObb {
  static constexpr int highest = 9;
  static constexpr Scales scales{.count = 2, .each_axis = 0b10, .weights = 0b10};
  template <class W>
  HWY_INLINE Relation operator()(W& w, const Triangle3& t, const Obb3& b) const {
    const auto columns = columns_of(w, b);
    const auto normals = cofactors(columns);
    const auto half = doubled_half(w, b, columns, normals);
    const auto center = w.given(b.center);
    const auto x = seen_along(normals, w.difference(w.given(t.a), center)),
               y = seen_along(normals, w.difference(w.given(t.b), center)),
               z = seen_along(normals, w.difference(w.given(t.c), center));
    const std::array corner{twice(x), twice(y), twice(z)};
    const std::array edge{y - x, z - y, x - z};
    auto gaps = w.gaps();
    const auto low = smaller(smaller(corner[0], corner[1]), corner[2]);
    const auto high = larger(larger(corner[0], corner[1]), corner[2]);
    gaps.heed(larger(low, negated(high)) - half);
    if (gaps.is_apart()) return Relation::disjoint;
    across_triangle(w, gaps, corner, edge, half, []() HWY_ATTR { return false; });
    gaps.need(w.positive(half));
    return gaps.template relation<Relation>(half);
  }
};

/// A point minus the point of a parallelepiped at these parts of its axes, as vectors of space.
template <class D, class U, class P>
HWY_INLINE auto seen_from(const D& d, const U& u, const U& v, const U& w, const P& part) {
  return minus_product(minus_product(minus_product(d, u, spread<0>(part)), v, spread<1>(part)), w, spread<2>(part));
}

/// By two guesses, which need not be good: parts of its axes at which the box has a point near the ball's center, and a
/// direction along which the box ends before the ball begins.
struct BallAndObb {
  static constexpr int highest = 4;
  static constexpr Scales scales{.count = 3, .weights = 0b10};  // the axes and the direction may be of any length
  template <class W>
  HWY_INLINE Relation operator()(W& w, const Sphere3& ball, const Obb3& b, const auto& part,
                                 const auto& direction) const {
    const auto d = w.difference(w.given(ball.center), w.given(b.center));
    const auto x = w.template number<1>(w.given(b.axes[0])), y = w.template number<1>(w.given(b.axes[1])),
               z = w.template number<1>(w.given(b.axes[2]));
    const auto half = w.template weight<1>(w.given(b.half));
    const auto radius = spread<0>(w.number(w.given(ball.radius, 0.0, 0.0)));
    const auto limit = radius * radius;
    const auto off = seen_from(d, x, y, z, w.template weight<1>(w.given(part)));
    const auto n = w.template number<2>(w.given(direction));
    const auto low = total(minus_product(n * d, magnitude(seen_along(transposed(x, y, z), n)), magnitude(half)));
    // Both at once: nobody foresees which.
    const bool meets = w.is_all(w.positive(limit - total(off * off))),
               is_apart = w.is_all(w.positive(low) & w.positive(low * low - limit * total(n * n)));
    const auto told = static_cast<Relation>(static_cast<int>(meets) - static_cast<int>(is_apart));
    if (told == Relation::touching) w.leave_open();
    return told;
  }
};

}  // namespace plumb::query::box_axes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
