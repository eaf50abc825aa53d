// The gaps of boxes, an axis a lane; query/overlap/box_gaps.hpp has them as formulas.
#include "query/overlap/box_quick.hpp"

#include "certify/fused_lanes.hpp"
#include "query/overlap/box_gaps.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/overlap/box_quick.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "certify/three_lanes.hpp"
#include "query/overlap/box_axes.hpp"

#ifndef PLUMB_OVERLAP_BOX_QUICK_ONCE
#define PLUMB_OVERLAP_BOX_QUICK_ONCE
namespace plumb::query::box_gaps {

// No product of three numbers from the smallest to the greatest leaves the range of doubles, nor does its product with
// the constant of an error.
constexpr double smallest = 0x1p-300, greatest = 0x1p300;
// More than all that products of two numbers lose by underflow.
constexpr double guard = 0x1p-1000;

}  // namespace plumb::query::box_gaps
#endif

HWY_BEFORE_NAMESPACE();
namespace plumb::query::box_quick::HWY_NAMESPACE {
namespace {

using namespace certify::three_lanes::HWY_NAMESPACE;
using namespace box_gaps;

HWY_INLINE Three turned_product(const Three& a, const Three& a_turned, const Three& b, const Three& b_turned) {
  return plus_product(a * b_turned, a_turned, b);
}

/// What the axes say for certain: apart along one of them, below zero along all, lane by lane.
struct AxisLanes {
  Truth apart, inside;
};

template <class Statement, class... Input>
HWY_INLINE std::optional<Relation> by_doubles(const Input&... input) {
  return told_by_worlds<Floats<Three, Statement::highest, Statement::scales>>(NoWorldRecorder{}, Statement{}, input...);
}
[[maybe_unused]] std::optional<Relation> relation(const Segment3& s, const Aabb3& b) {
  return by_doubles<box_axes::HWY_NAMESPACE::SegmentAndBox>(s, b);
}
[[maybe_unused]] std::optional<Relation> relation(const Ray3& r, const Aabb3& b) {
  return by_doubles<box_axes::HWY_NAMESPACE::UnboundedAndBox<LinearKind::ray>>(r.origin, r.direction, b);
}
[[maybe_unused]] std::optional<Relation> relation(const Line3& l, const Aabb3& b) {
  return by_doubles<box_axes::HWY_NAMESPACE::UnboundedAndBox<LinearKind::line>>(l.point, l.direction, b);
}
[[maybe_unused]] std::optional<Relation> relation(const Triangle3& t, const Aabb3& b) {
  return by_doubles<box_axes::HWY_NAMESPACE::TriangleAndBox>(t, b);
}

/// Of a triangle, seen from the center twice as large as its edges are, along the cross products with all edges.
HWY_INLINE AxisLanes across(const std::array<Three, 3>& corner, const std::array<Three, 3>& edge, const Three& half,
                            const Three& normal, const Three& bound, bool skip_parallel) {
  const Three half_turned = turned(half), size_n = size(normal), zero = of_all(0), minus_bound = zero - bound;
  AxisLanes told{above(zero, zero), above(of_all(1), zero)};
  for (std::size_t i = 0; i < 3; ++i) {
    const Three edge_turned = turned(edge[i]), size_edge = size(edge[i]), size_turned = size(edge_turned);
    const Three reach = turned_product(half, half_turned, size_edge, size_turned);
    // e x p in the order of n.
    const Three gap = size(crossed(edge[i], edge_turned, corner[i], turned(corner[i])) + normal) - (size_n + reach);
    told.apart = told.apart | above(gap, bound);
    const Truth below = above(minus_bound, gap);
    told.inside = told.inside & (skip_parallel ? below | is_zero(size_edge + size_turned) : below);
  }
  return told;
}
/// Along the normal, which is given in the order of cross products.
HWY_INLINE double normal_gap(const Three& normal, const Three& corner, const Three& half) {
  const Three n = turned(normal);
  return magnitude_of(total(n * corner)) - total(size(n) * half);
}

/// An oriented box, doubled, in the frame of its axes.
struct Oriented {
  Three center, half;
  Columns normals;
  Three of_normals, reach;  // no coordinate of a normal is more, nor is a half extent more than the product of both

  explicit HWY_INLINE Oriented(const Obb3& b) : center(loaded(b.center)) {
    const Columns axes = transposed(loaded(b.axes[0]), loaded(b.axes[1]), loaded(b.axes[2]));
    normals = cofactors(axes);
    const Three given = size(loaded(b.half)), twice = given + given;
    half = twice * size(along(normals, axes.x, axes.y, axes.z));
    const Three of_axes = (size(axes.x) + size(axes.y)) + (size(axes.z) + of_all(smallest));
    of_normals = turned(of_axes) * turned_back(of_axes), reach = twice * of_axes;
  }
  [[nodiscard]] HWY_INLINE Three seen(const Three& v) const {
    return along(normals, spread<0>(v), spread<1>(v), spread<2>(v));
  }
};
/// What is seen of vectors whose coordinates' sizes add up to this is no more than `points`, and that with the half
/// extents no more than `all`.  NaN where one of the numbers is.  Of normals no larger than the greatest the volume is
/// no more than its power of 3/2, so that no half extent overflows before it is multiplied.
struct Sizes {
  Three points, all;

  HWY_INLINE Sizes(const Oriented& box, const Three& sizes)
      : points(plus_product(of_all(smallest), box.of_normals, of_all(total(sizes)))),
        all(plus_product(points, box.of_normals, box.reach)) {}
  /// In the order of cross products.
  [[nodiscard]] HWY_INLINE Three planes() const { return turned_product(all, turned(all), points, turned(points)); }
};

template <LinearKind reach>
HWY_INLINE std::optional<Relation> straight_obb(const Three& p, const Three& way, const Obb3& b) {
  const Oriented box(b);
  const Three from = p - box.center, size_way = size(way);
  const Sizes sizes(box, size(from) + size_way);
  if (!all(above(of_all(greatest), sizes.all + box.of_normals))) return {};
  // Of a segment the middle, else the origin; twice.
  const Three point = box.seen(reach == LinearKind::segment ? (from + from) + way : from + from), d = box.seen(way);
  const Three zero = of_all(0), off = of_all(straight_face_error) * sizes.all;
  const Three off_edges = plus_product(of_all(guard), of_all(straight_edge_error), sizes.planes());
  const Three d_turned = turned(d), size_d = size(d), size_turned = size(d_turned);
  const Three gap = size(crossed(point, turned(point), d, d_turned)) -
                    turned_product(box.half, turned(box.half), size_d, size_turned);
  Truth apart = above(gap, off_edges), inside = above(zero - off_edges, gap);
  const Three beside = size(point) - box.half;
  if (reach == LinearKind::segment) {
    const Three face_gap = beside - size_d;
    apart = apart | above(face_gap, off), inside = inside & above(zero - off, face_gap);
  } else if (reach == LinearKind::ray) {
    const Three ahead = chosen(above(d, zero), point, zero - point) - box.half;
    const Truth certain = above(size_d, off);
    apart = apart | (above(ahead, off) & certain);
    inside = inside & ((above(zero - off, ahead) & certain) | above(zero - off, beside));
  }
  const int is_apart = any(apart), is_inside = all(inside);
  if ((is_apart | is_inside) != 0) [[likely]]
    return static_cast<Relation>(is_inside - is_apart);
  return {};
}
[[maybe_unused]] std::optional<Relation> relation(const Segment3& s, const Obb3& b) {
  const Three p = loaded(s.a);
  return straight_obb<LinearKind::segment>(p, loaded(s.b) - p, b);
}
[[maybe_unused]] std::optional<Relation> relation(const Ray3& r, const Obb3& b) {
  return straight_obb<LinearKind::ray>(loaded(r.origin), loaded(r.direction), b);
}
[[maybe_unused]] std::optional<Relation> relation(const Line3& l, const Obb3& b) {
  return straight_obb<LinearKind::line>(loaded(l.point), loaded(l.direction), b);
}

[[maybe_unused]] std::optional<Relation> relation(const Triangle3& t, const Obb3& b) {
  const Oriented box(b);
  const Three p = loaded(t.a) - box.center, q = loaded(t.b) - box.center, r = loaded(t.c) - box.center;
  const Sizes sizes(box, larger(larger(size(p), size(q)), size(r)));
  const Three x = box.seen(p), y = box.seen(q), z = box.seen(r);
  // A NaN is in the sum.
  if (!all(above(of_all(greatest), (sizes.all + box.of_normals) + size(x + (y + z))))) return {};
  const std::array corner{x + x, y + y, z + z}, edge{y - x, z - y, x - z};
  const Three low = smaller(smaller(corner[0], corner[1]), corner[2]), zero = of_all(0);
  const Three high = larger(larger(corner[0], corner[1]), corner[2]);
  const Three face_gap = larger(low, zero - high) - box.half, off = of_all(corner_error) * sizes.all;
  if (any(above(face_gap, off))) return Relation::disjoint;

  const Three normal = crossed(edge[0], turned(edge[0]), edge[1], turned(edge[1]));
  const AxisLanes told = across(corner, edge, box.half, normal, of_all(edge_error) * sizes.planes(), false);
  const double gap = normal_gap(normal, corner[0], box.half);
  const double off_plane = normal_error * total(sizes.points * turned(sizes.points) * turned_back(sizes.all));
  if (any(told.apart) || gap > off_plane) return Relation::disjoint;
  if (all(told.inside & above(zero - off, face_gap)) && gap < -off_plane) return Relation::overlapping;
  return {};
}

}  // namespace
}  // namespace plumb::query::box_quick::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace plumb::query {

#define PLUMB_QUICK_RELATION(A, B) \
  std::optional<Relation> quick_relation(const A& a, const B& b) { return PLUMB_BY_LANES(box_quick, relation(a, b)); }
PLUMB_QUICK_RELATION(Segment3, Aabb3)
PLUMB_QUICK_RELATION(Ray3, Aabb3)
PLUMB_QUICK_RELATION(Line3, Aabb3)
PLUMB_QUICK_RELATION(Triangle3, Aabb3)
PLUMB_QUICK_RELATION(Segment3, Obb3)
PLUMB_QUICK_RELATION(Ray3, Obb3)
PLUMB_QUICK_RELATION(Line3, Obb3)
PLUMB_QUICK_RELATION(Triangle3, Obb3)
#undef PLUMB_QUICK_RELATION

}  // namespace plumb::query
#endif
