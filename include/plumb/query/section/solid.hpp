// Intersection, clipping: which points do two solids have in common?  Nothing, a point, a segment, a polygon or a
// convex polyhedron, with exact corners.
//
//   const SolidIntersection3 common = intersection(box, tetrahedron);
//   if (common.kind == IntersectionKind::solid) volume(common);   // the exact volume, rounded once
//   for (std::size_t f = 0; f < common.faces(); ++f) plane_of(common, f);
//
// Halfspaces, tetrahedra, boxes, oriented boxes, k-DOPs, intersections of halfspaces and convex polyhedra, each with
// each.  What these have in common with lines, planes and polygons: query/section/intersection.hpp.
// Laws: (1) the set of points that both closed sets have in common, in real arithmetic: solids that touch have a point,
// a segment or a polygon in common.  (2) Vertices are extreme points, and no two of them are equal; of a segment or a
// solid they ascend lexicographically, of a polygon they turn as query/section/intersection_result.hpp says.  (3) Faces
// are whole: no two lie in one plane; each turns counterclockwise seen from outside, strictly, from its least vertex,
// and they ascend by their corners.  So equal sets are told alike, whichever figure is named first.  (4) A figure
// without volume is the polygon, segment or point that it is.  (5) Corners are held as points as given or as
// LinePlanePoint3, where an edge crosses a face; as rational points where a halfspace, k-DOP or oriented box has a part
// in them.  (6) What goes on forever is told by its vertices and the directions in which it goes on; it has no list of
// faces, and one that holds a line is told by some of its points.
// NaN and infinity throw NonFinite, by name.
// Source: RTCD 5.3.8, 5.4; Preparata and Shamos, Computational Geometry, 1985.
// Cost: edges times bounds of both; some 10 us for two boxes or tetrahedra in general position, 200 us for oriented
// boxes, where exact integers decide; of k-DOPs and intersections of halfspaces a millisecond and more, in rationals.
// A volume some 300 us.  Bounded by n^2 operations for n corners of both, on integers as long as the exponents' span.
#pragma once

#include <cstdint>
#include <span>

#include "plumb/query/section/intersection2.hpp"

namespace plumb {

/// All x with normal . x <= offset; the normal's parts are integers without a common factor.
struct RationalHalfspace3 {
  RationalPoint3 normal;
  Rational offset;
  friend bool operator==(const RationalHalfspace3&, const RationalHalfspace3&) = default;
};

struct SolidIntersection3 {
  IntersectionKind kind = IntersectionKind::nothing;
  std::vector<ExactPoint3> vertices;
  std::vector<std::uint32_t> corners;      // of the faces of a bounded solid
  std::vector<std::uint32_t> first;        // those of face f: corners[first[f]] up to [first[f + 1]]
  std::vector<RationalPoint3> directions;  // where it goes on forever: integers without a common factor

  [[nodiscard]] bool empty() const { return kind == IntersectionKind::nothing; }
  [[nodiscard]] bool is_bounded() const { return directions.empty(); }
  [[nodiscard]] std::size_t faces() const { return first.empty() ? 0 : first.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> corners_of(std::size_t face) const {
    return std::span(corners).subspan(first[face], first[face + 1] - first[face]);
  }
};

/// In which plane does a face lie?  The halfspace that holds the solid.
RationalHalfspace3 plane_of(const SolidIntersection3& solid, std::size_t face);

/// The nearest doubles of the vertices; throws BeyondDoubles where there are none.
std::vector<Point3> approximate(const SolidIntersection3& a);

/// Exactly: zero of what is flat.  What goes on forever throws InvalidShape.
Rational exact_volume(const SolidIntersection3& a);
/// The same, rounded once.
double volume(const SolidIntersection3& a);

/// Are the sets the same?  Of sets that hold a line, are they told alike?
bool operator==(const SolidIntersection3& a, const SolidIntersection3& b);

namespace query {
template <class Shape>
concept SolidFigure = Figure<Shape> && figure_dimension<Shape>
== 3 && is_solid_kind(figure_kind<Shape>);

SolidIntersection3 common_solid(const FigureView& a, const FigureView& b);
}  // namespace query

/// Two solids, in the order of FigureKind; the other order is made of it.
template <query::SolidFigure A, query::SolidFigure B>
requires(figure_kind<A> <= figure_kind<B>) SolidIntersection3 intersection(const A& a, const B& b) {
  return query::common_solid(query::view_of(a), query::view_of(b));
}

}  // namespace plumb
