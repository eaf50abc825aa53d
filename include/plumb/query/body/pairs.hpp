// Narrow phase, dispatch: which algorithm answers how two figures lie to one another?  One table for all pairs, as
// data.
//
// Laws: (1) a pair is named in the order of FigureKind; the other order is answered by it.  (2) relate and intersects
// (query/overlap/overlap.hpp) take exactly the pairs whose method is not `absent`: they are templates over this table, and
// docs/overlap.md shows it.
// Source: RTCD 5.2.
// Cost: none, all of it is constexpr.
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <string_view>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/convex_polyhedron.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/figure/basic/polygon.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/figure/k_dop/k_dop.hpp"

namespace plumb {

/// In canonical order.
enum class FigureKind : unsigned char {
  point,
  line,
  ray,
  segment,
  plane,
  three_point_plane,
  halfspace,
  triangle,
  quadrilateral,
  polygon,
  holed_polygon,
  rectangle,
  tetrahedron,
  ball,  // Circle2, Sphere3
  aabb,
  obb,
  capsule,
  lozenge,
  cylinder,
  cone,
  k_dop,
  halfspace_intersection,
  convex_polyhedron,
  spherical_cap
};
inline constexpr std::size_t figure_kinds = 24;

inline constexpr std::array<std::string_view, figure_kinds> figure_names{
    "point",     "line",     "ray",   "segment",    "plane",      "three-point plane",
    "halfspace", "triangle", "quad",  "polygon",    "holed",      "rectangle",
    "tetra",     "ball",     "aabb",  "obb",        "capsule",    "lozenge",
    "cylinder",  "cone",     "k-dop", "halfspaces", "polyhedron", "cap"};
constexpr std::string_view name_of(FigureKind kind) { return figure_names[static_cast<std::size_t>(kind)]; }

/// How a pair is answered.
enum class PairMethod : unsigned char {
  absent,
  location,  // of a point: signs of figure/containment/contains.hpp, figure/basic/polyhedron.hpp
  signs,     // few signs of their own
  extent,    // of a figure along a plane's normal
  axes,      // separating axes of what generates the figures
  search,    // a separating plane or common point guessed in doubles and proved
  program,   // a linear program in rationals, after guesses that are proved
  pieces,    // pieces of a polygon's chains, and what is beside them
  distance,  // of a core, against a radius
  bounds  // of one kind of bounding volume: figure/aabb/relation.hpp, obb.hpp, sphere.hpp, swept_sphere.hpp, k_dop.hpp
};
inline constexpr std::array<std::string_view, 10> method_names{"-",      "location", "signs",  "extent",   "axes",
                                                               "search", "program",  "pieces", "distance", "bounds"};
constexpr std::string_view name_of(PairMethod method) { return method_names[static_cast<std::size_t>(method)]; }

namespace query {

template <class Shape>
struct KindOf {};
template <FigureKind K, int D>
struct KindIs {
  static constexpr FigureKind kind = K;
  static constexpr int dimension = D;
};
#define PLUMB_KIND(shape, kind, dimension) \
  template <>                              \
  struct KindOf<shape> : KindIs<FigureKind::kind, dimension> {};
PLUMB_KIND(Point2, point, 2)
PLUMB_KIND(Point3, point, 3)
PLUMB_KIND(Line2, line, 2)
PLUMB_KIND(Line3, line, 3)
PLUMB_KIND(Ray2, ray, 2)
PLUMB_KIND(Ray3, ray, 3)
PLUMB_KIND(Segment2, segment, 2)
PLUMB_KIND(Segment3, segment, 3)
PLUMB_KIND(Plane3, plane, 3)
PLUMB_KIND(ThreePointPlane3, three_point_plane, 3)
PLUMB_KIND(Halfspace2, halfspace, 2)
PLUMB_KIND(Halfspace3, halfspace, 3)
PLUMB_KIND(Triangle2, triangle, 2)
PLUMB_KIND(Triangle3, triangle, 3)
PLUMB_KIND(Quadrilateral2, quadrilateral, 2)
PLUMB_KIND(Quadrilateral3, quadrilateral, 3)
PLUMB_KIND(Polygon2, polygon, 2)
PLUMB_KIND(Polygon3, polygon, 3)
PLUMB_KIND(HoledPolygon2, holed_polygon, 2)
PLUMB_KIND(HoledPolygon3, holed_polygon, 3)
PLUMB_KIND(Rectangle3, rectangle, 3)
PLUMB_KIND(Tetrahedron3, tetrahedron, 3)
PLUMB_KIND(Circle2, ball, 2)
PLUMB_KIND(Sphere3, ball, 3)
PLUMB_KIND(Aabb2, aabb, 2)
PLUMB_KIND(Aabb3, aabb, 3)
PLUMB_KIND(Obb2, obb, 2)
PLUMB_KIND(Obb3, obb, 3)
PLUMB_KIND(Capsule2, capsule, 2)
PLUMB_KIND(Capsule3, capsule, 3)
PLUMB_KIND(Lozenge3, lozenge, 3)
PLUMB_KIND(Cylinder3, cylinder, 3)
PLUMB_KIND(Cone3, cone, 3)
PLUMB_KIND(KDop2, k_dop, 2)
PLUMB_KIND(KDop3, k_dop, 3)
PLUMB_KIND(HalfspaceIntersection2, halfspace_intersection, 2)
PLUMB_KIND(HalfspaceIntersection3, halfspace_intersection, 3)
PLUMB_KIND(ConvexPolyhedron3, convex_polyhedron, 3)
PLUMB_KIND(SphericalCap3, spherical_cap, 3)
#undef PLUMB_KIND

template <class Value>
constexpr bool is_one_of(Value value, std::initializer_list<Value> values) {
  for (const Value v : values) {
    if (v == value) return true;
  }
  return false;
}

// clang-format off
// One letter a pair: row and column are FigureKind, the lower half is the other order.  A row may end early: what is
// not there is '-'.
constexpr PairMethod method_of_letter(char c) {
  constexpr std::string_view letters = "-lsxagpcdb";
  return static_cast<PairMethod>(letters.find(c));
}
using PairRows = std::array<std::string_view, figure_kinds>;

inline constexpr PairRows rows_of_space{
    //                         plrsPTHtqghRebAOczynKICS (a column a letter)
    /* point              */ "llllssslllllldllddddllld",
    /* line               */ " sssxaxscccaadssddddppgd",
    /* ray                */ "  ssxaxscccaadssddddppgd",
    /* segment            */ "   ssssscccasdssddddppgd",
    /* plane              */ "    xxxscccxsdssddddppxd",
    /* three-point plane  */ "     axscccasdssddddppgd",
    /* halfspace          */ "      xscccxsdssddddppxd",
    /* triangle           */ "       scccasdssddddppgd",
    /* quad               */ "        cccccdccddddccc",
    /* polygon            */ "         ccccdccddddccc",
    /* holed              */ "          cccdccddddccc",
    /* rectangle          */ "           aadaaddddppgd",
    /* tetra              */ "            sdaaddddppgd",
    /* ball               */ "             bdddddddddd",
    /* aabb               */ "              bsddddppgd",
    /* obb                */ "               bddddppgd",
    /* capsule            */ "                bd--ddd",
    /* lozenge            */ "                 b--ddd",
    /* cylinder           */ "                  --ddd",
    /* cone               */ "                   -ddd",
    /* k-dop              */ "                    bppd",
    /* halfspaces         */ "                     ppd",
    /* polyhedron         */ "                      gd",
    /* cap                */ ""};

inline constexpr PairRows rows_of_plane{
    //                         plrsPTHtqghRebAOczynKIC (a column a letter)
    /* point              */ "llll--lllll--dlld---ll-",
    /* line               */ " sss--xsccc--dsad---pp-",
    /* ray                */ "  ss--xsccc--dsad---pp-",
    /* segment            */ "   s--xsccc--dsad---pp-",
    /* plane              */ "    -------------------",
    /* three-point plane  */ "     ------------------",
    /* halfspace          */ "      xxccc--dxxd---pp-",
    /* triangle           */ "       sccc--dsad---pp-",
    /* quad               */ "        ccc--dccd---cc-",
    /* polygon            */ "         cc--dccd---cc-",
    /* holed              */ "          c--dccd---cc-",
    /* rectangle          */ "           ------------",
    /* tetra              */ "            -----------",
    /* ball               */ "             bddd---dd-",
    /* aabb               */ "              bad---pp-",
    /* obb                */ "               bd---pp-",
    /* capsule            */ "                b---dd-",
    /* lozenge            */ "                 ------",
    /* cylinder           */ "                  -----",
    /* cone               */ "                   ----",
    /* k-dop              */ "                    bp-",
    /* halfspaces         */ "                     p-",
    /* polyhedron         */ "                      -",
    /* cap                */ ""};

// clang-format on

}  // namespace query

/// How a pair of figures of the plane (2) or of space (3) is answered.
constexpr PairMethod pair_method(FigureKind a, FigureKind b, int dimension) {
  const auto& rows = dimension == 2 ? query::rows_of_plane : query::rows_of_space;
  const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
  const std::string_view row = rows[i < j ? i : j];
  const std::size_t column = i < j ? j : i;
  return column < row.size() ? query::method_of_letter(row[column]) : PairMethod::absent;
}

/// A figure that the table knows, by its type.
template <class Shape>
concept Figure = requires {
  query::KindOf<Shape>::kind;
};
template <Figure Shape>
inline constexpr FigureKind figure_kind = query::KindOf<Shape>::kind;
template <Figure Shape>
inline constexpr int figure_dimension = query::KindOf<Shape>::dimension;

namespace query {

/// A figure whose type the compiler need not know.
struct FigureView {
  FigureKind kind;
  int dimension;
  const void* shape;
};
template <Figure Shape>
constexpr FigureView view_of(const Shape& shape) {
  return {figure_kind<Shape>, figure_dimension<Shape>, &shape};
}

/// Of a figure with straight edges and flat faces.
using FlatView = FigureView;

/// Has it straight edges and flat faces?  Else it is round somewhere.
constexpr bool is_flat_kind(FigureKind kind) {
  return !is_one_of(kind, {FigureKind::ball, FigureKind::capsule, FigureKind::lozenge, FigureKind::cylinder,
                           FigureKind::cone, FigureKind::spherical_cap});
}
template <class Shape>
concept FlatFigure = Figure<Shape> && is_flat_kind(figure_kind<Shape>);

}  // namespace query

/// How these two types are answered; absent as well where they are of the plane and of space.
template <Figure A, Figure B>
inline constexpr PairMethod method_of = figure_dimension<A> == figure_dimension<B>
                                            ? pair_method(figure_kind<A>, figure_kind<B>, figure_dimension<A>)
                                            : PairMethod::absent;

/// Of which pairs are declared in canonical order, so that the other order is made of it.
template <class A, class B>
concept OtherWayRound = Figure<A> && Figure<B> &&(figure_kind<A> > figure_kind<B>);

/// Two figures of one space that relate and intersects take, in either order.
template <class A, class B>
concept RelatedPair = Figure<A> && Figure<B> &&(method_of<A, B> != PairMethod::absent);

}  // namespace plumb
