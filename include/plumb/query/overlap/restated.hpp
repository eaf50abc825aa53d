// Slab tests, boxes by width or by center: do they meet another figure, and does one hold the other?
//
//   relate(Slab3{normal, 1, 2}, cylinder)            disjoint, touching or overlapping
//   contains(AabbCenter3{...}, AabbWidths3{...})     no end is rounded
//
// Boxes stand in every pair in which Aabb3 does, slabs in every pair in which halfspaces do, and with one another.
// Laws: (1) those of query/overlap/overlap.hpp and query/convex/containment.hpp, of the sets that the numbers say.  (2) A slab
// of min = max is its plane, which what lies in it overlaps; one of min > max is empty.
// NaN and infinity throw NonFinite, by name ("relate: slab.min is nan").
// Method: a connected figure meets a slab exactly where it meets both of its halfspaces.
// Source: RTCD 4.2.1, 4.6.1, 5.2, 5.2.3.
// Cost: that of two halfspaces, or of an Aabb3; where an end is no double that of an Obb3, or some 2 us of a posed box.
// Nothing is searched but what relate of that figure searches (query/overlap/posed.hpp).
#pragma once

#include "plumb/query/body/restated.hpp"
#include "plumb/query/convex/containment.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/overlap/posed.hpp"

namespace plumb {

namespace query {

template <class A, class B>
concept SlabPair = AnySlab<A> && Figure<SaidType<B>> && !AnySlab<B> && requires {
  requires figure_dimension<SaidType<A>>
  == figure_dimension<SaidType<B>>;
};
template <class A, class B>
concept RelatesRestated = RestatedPair<A, B> &&
    (SlabPair<A, B> || SlabPair<B, A> || requires(const SaidType<A>& a, const SaidType<B>& b) {
      { relate(a, b) } -> std::same_as<Relation>;
    });

/// What two halfspaces tell; others are asked of the region between both.
template <class Shape>
constexpr bool is_connected_inside() {
  if constexpr (Figure<Shape>) {
    return !is_one_of(figure_kind<Shape>, {FigureKind::quadrilateral, FigureKind::polygon, FigureKind::holed_polygon});
  } else {
    return true;
  }
}

template <class Slab, class Shape>
Relation relate_slab(std::string_view function, const Slab& slab, const Shape& s) {
  require_slab(function, slab);
  const Relation below = relate(upper_side(slab), s);
  if (slab.min > slab.max || below == Relation::disjoint) return Relation::disjoint;
  if constexpr (is_connected_inside<Shape>()) {
    if (slab.min < slab.max) {
      const Relation above = relate(lower_side(slab), s);
      return above < below ? above : below;
    }
  }
  if constexpr (std::is_same_v<Shape, Cylinder3> || std::is_same_v<Shape, Cone3>) {
    return relate(Plane3{slab.normal, slab.min}, s);
  } else {
    return restated(function, slab, [&](const auto& region) { return relate(region, s); });
  }
}

template <class A, class B>
Relation relate_restated(std::string_view function, const A& a, const B& b) {
  if constexpr (AnySlab<A> && !AnySlab<B>) {
    return restated(function, b, [&](const auto& s) { return relate_slab(function, a, s); });
  } else if constexpr (AnySlab<B> && !AnySlab<A>) {
    return relate_restated(function, b, a);
  } else {
    return restated(function, a, b, [](const auto& p, const auto& q) { return relate(p, q); });
  }
}

template <class Outer, class Inner>
concept HoldsRestated = RestatedPair<Outer, Inner> && !std::same_as<Inner, Point2> && !std::same_as<Inner, Point3> &&
                        requires(const SaidType<Outer>& outer, const SaidType<Inner>& inner) {
  { contains(outer, inner) } -> std::same_as<bool>;
};

}  // namespace query

template <class A, class B>
requires query::RelatesRestated<A, B> Relation relate(const A& a, const B& b) {
  return query::relate_restated("relate", a, b);
}

template <class A, class B>
requires query::RelatesRestated<A, B>
bool intersects(const A& a, const B& b) { return query::relate_restated("intersects", a, b) != Relation::disjoint; }

/// Every point of the inner one?
template <class Outer, class Inner>
requires query::HoldsRestated<Outer, Inner>
bool contains(const Outer& outer, const Inner& inner) {
  return query::restated("contains", outer, inner, [](const auto& p, const auto& q) { return contains(p, q); });
}

}  // namespace plumb
