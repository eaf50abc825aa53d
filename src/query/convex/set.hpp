// Boundary representation: what is a convex figure made of, when it is to be intersected?  Vertices, edges, and what
// bounds it, in doubles.
//
// A set is what lies within all of its bounds.  Its vertices and edges are those of its boundary; a line or ray is an
// edge with an end at infinity.  Every number is one that the figure was given by, so that signs at vertices are exact
// predicates of points as given, and what is constructed can be named by points as given.
// Laws: a set whose dimension is at most 1 has one edge (a point's has no length); `look` is the axis along which a
// flat set of dimension 2 is seen as a plane, the first of z, x, y that will do (coplanar_orientation).
// Cost: a few allocations.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "certify/exact_coordinates.hpp"
#include "figure/basic/plane_of_points.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/convex_polyhedron.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/figure/basic/polygon.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/query/body/pairs.hpp"
#include "query/convex/flat_set.hpp"

namespace plumb::query::meeting {

using certify::meeting::coordinates_in, certify::meeting::interval_of, certify::meeting::of_rationals,
    certify::meeting::parts, certify::meeting::rational, certify::meeting::rational_quotient, certify::meeting::Vec,
    certify::meeting::Weighted, certify::meeting::weighted;

template <std::size_t N>
using Point = std::conditional_t<N == 2, Point2, Point3>;
template <std::size_t N>
using Vector = std::conditional_t<N == 2, Vector2, Vector3>;

/// x, y, z as 0, 1, 2.
inline double part(const Point2& p, std::size_t axis) { return axis == 0 ? p.x : p.y; }
inline double part(const Vector2& p, std::size_t axis) { return axis == 0 ? p.x : p.y; }
inline double part(const Point3& p, std::size_t axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }
inline double part(const Vector3& p, std::size_t axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }
inline double& part(Point2& p, std::size_t axis) { return axis == 0 ? p.x : p.y; }
inline double& part(Point3& p, std::size_t axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

/// Seen along an axis: which axes go right and up.  In the plane there is one look.
struct Seen {
  std::size_t right = 0, up = 1;
};
inline constexpr std::array<Seen, 3> looks{{{1, 2}, {0, 2}, {0, 1}}};  // along x, y, z
template <std::size_t N>
Point2 seen(const Point<N>& p, Seen s) {
  return {part(p, s.right), part(p, s.up)};
}

/// gradient . x - offset, of numbers that no double holds.
template <std::size_t N>
struct Given {
  Vec<BigDyadic, N> gradient;
  BigDyadic offset;
};

/// What lies on one side of a line or plane (side * value(x) <= 0), or on it (side 0).
template <std::size_t N>
struct Bound {
  enum class Kind : unsigned char {
    axis,    // value: x[axis] - offset
    line,    // the line ab as seen along `axis`: orient2d(a, b, x)
    toward,  // the line through a in this direction, as seen along `axis`: its cross product with x - a
    face,    // orient3d(a, b, c, x)
    normal,  // direction . x - offset
    given,   // that of `given`
  };
  Kind kind;
  int side;
  std::size_t axis = 0;
  double offset = 0;
  Point<N> a{}, b{}, c{};
  Vector<N> direction{};
  std::shared_ptr<const Given<N>> given{};
  int vertex = -1;  // of a set on a line: its vertex on this bound

  [[nodiscard]] Seen look() const { return N == 2 ? Seen{} : looks[axis]; }
  [[nodiscard]] bool is_named() const { return kind == Kind::axis || kind == Kind::line || kind == Kind::face; }
};

inline constexpr int infinity = -1;

template <std::size_t N>
struct Edge {
  int from, to;      // vertices, or infinity
  Point<N> point{};  // of an edge with an end at infinity: a point, and the direction from `from` to `to`
  Vector<N> direction{};
  bool named = true;  // by its vertices, or by `point` and `second`, which is instead of the direction then
  Point<N> second{};

  [[nodiscard]] bool is_bounded() const { return from != infinity && to != infinity; }
};

template <std::size_t N>
struct ConvexSet {
  int dimension = -1;  // of nothing
  std::vector<Point<N>> vertices;
  std::vector<Vec<BigDyadic, N>> exact_vertices;  // instead of them where no doubles hold them
  std::vector<Edge<N>> edges;
  std::vector<Bound<N>> bounds;  // those with side 0 first
  int look = -1;
  int first_side = -1;  // the bound of edge 0, followed by those of the other edges; for polygons

  [[nodiscard]] bool is_bounded() const { return !edges.empty() && edges[0].is_bounded(); }
  [[nodiscard]] bool is_exact() const { return !exact_vertices.empty(); }
};

template <std::size_t N>
ConvexSet<N> point_set(const Point<N>& p);
template <std::size_t N>
ConvexSet<N> segment_set(const Point<N>& a, const Point<N>& b);
/// The line through two points.
template <std::size_t N>
ConvexSet<N> line_set(const Point<N>& a, const Point<N>& b);

/// The sign of the bound's value at a point as given, exactly.
Sign value_sign(const Bound<2>& bound, const Point2& p);
Sign value_sign(const Bound<3>& bound, const Point3& p);

/// A figure whose type was forgotten, of the plane or of space; nothing of one that has no vertices and edges known in doubles
/// or in dyadic numbers: k-DOPs, halfspaces.
std::optional<ConvexSet<2>> convex_set2(const FigureView& v);
std::optional<ConvexSet<3>> convex_set3(const FigureView& v);
/// In rationals: k-DOPs and intersections of halfspaces as well.  Empty with one halfspace that holds nothing.
std::vector<ExactHalfspace> halfspaces_of(const FigureView& v);
std::vector<ExactHalfspace> halfspaces_of(const ConvexSet<3>& set);

ConvexSet<2> convex_set(const Line2& line);
ConvexSet<2> convex_set(const Ray2& ray);
ConvexSet<2> convex_set(const Segment2& segment);
ConvexSet<2> convex_set(const Triangle2& triangle);
ConvexSet<2> convex_set(const Aabb2& box);
/// Throws InvalidShape where the polygon is not convex.
ConvexSet<2> convex_set(const Polygon2& polygon);
ConvexSet<2> convex_set(const Obb2& box);

ConvexSet<3> convex_set(const Line3& line);
ConvexSet<3> convex_set(const Ray3& ray);
ConvexSet<3> convex_set(const Segment3& segment);
ConvexSet<3> convex_set(const Plane3& plane);
ConvexSet<3> convex_set(const ThreePointPlane3& plane);
ConvexSet<3> convex_set(const Halfspace3& halfspace);
ConvexSet<3> convex_set(const Triangle3& triangle);
ConvexSet<3> convex_set(const Aabb3& box);
ConvexSet<3> convex_set(const Tetrahedron3& tetrahedron);
ConvexSet<3> convex_set(const ConvexPolyhedron3& polyhedron);
ConvexSet<3> convex_set(const Obb3& box);
ConvexSet<3> convex_set(const Rectangle3& rectangle);
/// Throws InvalidShape where the polygon is not planar or not convex.
ConvexSet<3> convex_set(const Polygon3& polygon);

}  // namespace plumb::query::meeting
