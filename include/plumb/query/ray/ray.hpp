// Ray cast: where does a ray, a segment or a line first hit a shape?  The parameter, the point, the feature and its
// normal.
//
//   first_hit(Ray3{origin, direction}, triangle)      nothing, or { t, point, feature, normal }
//   first_hit_parameter(ray, sphere)                  the parameter as an exact number that compares
//
// t counts multiples of the direction from the origin; for a segment from a to b, t = 0 is a and t = 1 is b.  A ray
// begins at t = 0, a line has all t.
// Laws: (1) whether there is a hit is exact, and so is the feature: of those that hold the point the one of the lowest
// dimension, then of the lowest number.  (2) t, and each coordinate of point and normal, is the exact number rounded
// once to the nearest double, never -0; infinite where it is beyond all doubles.  (3) Shapes are closed sets: what
// begins inside a solid hits it at t = 0, feature interior; what begins on its boundary hits it there.  A ray along an
// edge or in the plane of a triangle hits where it first touches.  (4) The t of a line is the least one at which it is
// in the shape, which may be negative; where there is no least one (a halfspace, a plane that holds the line), it is
// the one nearest to zero.  (5) A zero direction makes the point that it is, at t = 0.  (6) Degenerate shapes are the
// sets that they are; a Quadrilateral3 or Polygon3 is what figure/basic/polygon.hpp says, convex or not.
// Features are those of figure/containment/voronoi_region.hpp; a rectangle's are numbered as a box's (an edge 2 times
// its axis, plus 1 at the upper end of the other); a sphere, plane or halfspace is face 0, three points on one line
// are edge 0, equal ones vertex 0; a cylinder's side is face 0, its ends about a and b are faces 1 and 2, their
// circles edges 0 and 1; a capsule likewise, without edges; a cone's side is face 0, its base face 1, the circle
// between them edge 0, its apex vertex 0; a lozenge's flat sides are face 0, where its edges are seen to turn
// counterclockwise, and face 1, its rounds about edge i and corner i of the parallelogram, numbered as a rectangle's,
// faces 2 + i and 6 + i (of parallel edges it is a capsule, and has the faces of one); an ellipsoid is face 0; slab i
// of a k-DOP has the faces 2 i at its min and 2 i + 1 at its max, and neither edges nor vertices.  A quadrilateral's
// vertices are a to d, its edges ab, bc, cd, da; a polygon's count through its chains, an edge by the vertex that it
// leaves.
// The normal is not normalized, and points out of a solid: of the faces that hold the point that of the first one that
// faces the ray, else of the first; zero where the feature is the interior.  Of a box it is a unit vector, of a plane,
// halfspace or k-DOP the vector given, of balls, capsules and the rounds of lozenges the way from the center or axis
// to the point, of a cone's side the same less r^2 / |axis|^2 of the way along the axis from the apex, of an ellipsoid
// (A A^T)^-1 (point - center) for the matrix A of its half axes (the cross product of the first two of them that are
// not parallel, where it is flat), of flat faces a cross product: (b - a) x (c - a) of a triangle, whichever side is
// hit; of a quadrilateral or polygon of the first three of its corners that are not on one line; of two axes, which of
// an oriented box are as long as given.  A shape without area has the normal zero, a solid without inside that of its
// first face that is hit.
// An empty shape is never hit.
// A negative radius, a quadrilateral or polygon that is not planar, a polyhedron without faces throw InvalidShape; NaN
// and infinity throw NonFinite, by name.
// Source: RTCD 5.3, 5.3.1 to 5.3.8.
// Cost: some 0.2 us for a hit, half of it for rounding, less for a miss; microseconds where pairs of doubles leave a
// doubt.  A yes or no alone: query/ray/hits.hpp.  Bounded by n signs for n corners, on integers as long as the
// exponents' span.
#pragma once

#include <concepts>
#include <optional>

#include "plumb/arith/error.hpp"
#include "plumb/certify/ray_parameter.hpp"
#include "plumb/figure/containment/voronoi_region.hpp"
#include "plumb/query/body/hit_pairs.hpp"

namespace plumb {

struct Hit {
  double t;
  Point3 point;
  Feature feature;
  Vector3 normal;
  friend bool operator==(const Hit&, const Hit&) = default;
};

/// A ray, a segment or a line; made of one without a word.
struct AnyRay {
  enum class Kind : unsigned char { ray, segment, line };

  Kind kind;
  Point3 origin;
  Vector3 direction;  // unused by segments, of which the difference of the ends is not rounded
  Point3 end;         // of a segment

  AnyRay(const Ray3& r) : kind(Kind::ray), origin(r.origin), direction(r.direction), end(r.origin) {}  // NOLINT
  AnyRay(const Segment3& s) : kind(Kind::segment), origin(s.a), direction{0, 0, 0}, end(s.b) {}        // NOLINT
  AnyRay(const Line3& l) : kind(Kind::line), origin(l.point), direction(l.direction), end(l.point) {}  // NOLINT
};

/// Which triangles are hit at an edge that they have in common?
/// closed: all of them, as sets, so that nothing slips through.
/// half_open: those that a ray nearby hits, the same one for all triangles (query/ray/hits.hpp): exactly one of two
/// that the ray passes between, none or both of two that it passes by, and none that is parallel to the ray.
enum class HitRule : unsigned char { closed, half_open };

namespace query {

template <class Ray>
concept StraightRay = Figure<Ray> &&
    is_one_of(figure_kind<Ray>, {FigureKind::line, FigureKind::ray, FigureKind::segment});
template <class Ray>
concept StraightRay3 = StraightRay<Ray> && figure_dimension<Ray>
== 3;

/// What a ray is asked about as it stands: by query/body/hit_pairs.hpp, and ellipsoids.
template <class Shape, int Dimension>
concept SeenByRays = Figure<Shape> && figure_dimension<Shape>
== Dimension&& hit_pairs.answers(FigureKind::ray, figure_kind<Shape>, Dimension);
template <class Shape>
concept SeenInSpace = SeenByRays<Shape, 3> || std::same_as<Shape, Ellipsoid3>;

/// Compiled for each of them (src/query/ray/answers.hpp).
template <class Shape>
struct RayAnswers {
  static std::optional<Hit> first_hit(const AnyRay& ray, const Shape& shape);
  static std::optional<RayParameter> first_hit_parameter(const AnyRay& ray, const Shape& shape);
  static bool hits(const AnyRay& ray, const Shape& shape);
};

}  // namespace query

template <query::SeenInSpace Shape>
std::optional<Hit> first_hit(const AnyRay& ray, const Shape& shape) {
  return query::RayAnswers<Shape>::first_hit(ray, shape);
}
std::optional<Hit> first_hit(const AnyRay& ray, const Triangle3& triangle, HitRule rule = HitRule::closed);

/// The exact t of first_hit.
template <query::SeenInSpace Shape>
std::optional<RayParameter> first_hit_parameter(const AnyRay& ray, const Shape& shape) {
  return query::RayAnswers<Shape>::first_hit_parameter(ray, shape);
}
std::optional<RayParameter> first_hit_parameter(const AnyRay& ray, const Triangle3& triangle,
                                                HitRule rule = HitRule::closed);

}  // namespace plumb
