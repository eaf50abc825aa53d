// Which figures are there, and what is each pair of the table held against?
//
// Laws: every pair that relate takes has an oracle (pair_table_test.cpp asks), and the tests that are named here go
// through the table, so that a new pair is held against its oracle or fails.
#pragma once

#include <string>

#include "plumb/query/overlap/overlap.hpp"

namespace plumb::pair_cases {

template <class... Shapes>
struct Types {};

template <class A, class B>
std::string pair_name() {
  return std::string(name_of(figure_kind<A>)) + " and " + std::string(name_of(figure_kind<B>));
}

/// In canonical order.
using Plane = Types<Point2, Line2, Ray2, Segment2, Halfspace2, Triangle2, Quadrilateral2, Polygon2, HoledPolygon2,
                    Circle2, Aabb2, Obb2, Capsule2, KDop2, HalfspaceIntersection2>;
using Space = Types<Point3, Line3, Ray3, Segment3, Plane3, ThreePointPlane3, Halfspace3, Triangle3, Quadrilateral3,
                    Polygon3, HoledPolygon3, Rectangle3, Tetrahedron3, Sphere3, Aabb3, Obb3, Capsule3, Lozenge3,
                    Cylinder3, Cone3, KDop3, HalfspaceIntersection3, ConvexPolyhedron3, SphericalCap3>;

enum class PairOracle : unsigned char {
  none,
  cells,    // linear programs between convex cells: pair_oracle.hpp, by overlap_pairs_test and overlap_pairs2_test
  core,     // the distance of a core, against the radius: round_oracle.hpp, by overlap_round_test
  parts,    // of a cap: flat convex sets within a ball, by overlap_cap_test
  surface,  // a quadratic along a line, or what a disk reaches: axis_oracle.hpp, by overlap_round_shapes_test
  seen      // what of a set is between the ends of an axis, seen along it, or a ball's section: overlap_axis_solid_test
};

constexpr bool has_core(FigureKind k) {
  return query::is_one_of(k, {FigureKind::ball, FigureKind::capsule, FigureKind::lozenge});
}
constexpr bool has_axis(FigureKind k) { return query::is_one_of(k, {FigureKind::cylinder, FigureKind::cone}); }
constexpr bool is_swept(FigureKind k) { return query::is_one_of(k, {FigureKind::capsule, FigureKind::lozenge}); }
constexpr bool is_straight_or_plane(FigureKind k) {
  return query::is_one_of(k, {FigureKind::point, FigureKind::line, FigureKind::ray, FigureKind::segment,
                              FigureKind::plane, FigureKind::three_point_plane, FigureKind::halfspace});
}
constexpr PairOracle oracle_of(FigureKind a, FigureKind b) {
  if (b == FigureKind::spherical_cap || a == FigureKind::spherical_cap) return PairOracle::parts;
  const bool axis_a = has_axis(a), axis_b = has_axis(b);
  if (axis_a || axis_b) {
    const FigureKind other = axis_a ? b : a;
    if (is_straight_or_plane(other)) return PairOracle::surface;
    return axis_a == axis_b || is_swept(other) ? PairOracle::none : PairOracle::seen;
  }
  return has_core(a) || has_core(b) ? PairOracle::core : PairOracle::cells;
}

/// Calls f with two null pointers, whose types are a pair of the table, for every pair in canonical order.
template <class F, class A, class... Bs>
void on_pairs(Types<A, Bs...>, F f) {
  const auto ask = [&f]<class B>(const B*) {
    if constexpr (RelatedPair<A, B>) f(static_cast<const A*>(nullptr), static_cast<const B*>(nullptr));
  };
  ask(static_cast<const A*>(nullptr));
  (ask(static_cast<const Bs*>(nullptr)), ...);
  if constexpr (sizeof...(Bs) > 0) on_pairs(Types<Bs...>{}, f);
}

/// Those that one oracle answers.
template <PairOracle Oracle, class All, class F>
void on_pairs_of(All all, F f) {
  on_pairs(all, [&f]<class A, class B>(const A* a, const B* b) {
    if constexpr (oracle_of(figure_kind<A>, figure_kind<B>) == Oracle) f(a, b);
  });
}

}  // namespace plumb::pair_cases
