// What is said to a question about figures that has no answer here?  One sentence each.
//
// Laws: those of arith/no_answer.hpp.  Generic code asks by the concepts, or as they do:
//   if constexpr (Relatable<A, B>) ...
// Cost: compile time only.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/arith/no_answer.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb {

struct Aabb3;
struct Hull3;
struct MinimumSphere;
struct Obb3;
struct Point3;
struct Support3;

// Where are two figures?
PLUMB_NO_ANSWER(Relation,
                "plumb: relate takes two figures of one space, the pairs of docs/overlap.md (include "
                "<plumb/query.hpp>); of meshes ask intersecting_pairs(build_bvh(a), build_bvh(b)), of a mesh and a "
                "figure meeting(build_bvh(mesh), figure)")
relate(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(bool,
                "plumb: intersects takes two figures of one space, the pairs of docs/overlap.md (include "
                "<plumb/query.hpp>); of meshes ask any_intersecting_pair(build_bvh(a), build_bvh(b)), of a mesh and a "
                "figure meeting(build_bvh(mesh), figure)")
intersects(PLUMB_ANYTHING) PLUMB_DELETED;

template <class A, class B>
concept Relatable = requires(const A& a, const B& b) {
  relate(a, b);
  intersects(a, b);
};

PLUMB_NO_ANSWER(bool,
                "plumb: contains takes a figure and then a point of its space, or two bounds, the pairs of "
                "docs/figures.md (include <plumb/query.hpp>); of a closed mesh ask locate(build_bvh(mesh), p)")
contains(PLUMB_ANYTHING) PLUMB_DELETED;

template <class Outer, class Inner>
concept Containing = requires(const Outer& outer, const Inner& inner) {
  contains(outer, inner);
};

PLUMB_NO_ANSWER(Location,
                "plumb: locate takes a figure and then a point of its space, locate(figure, p) (include "
                "<plumb/figure.hpp>); of a closed mesh ask locate(build_bvh(mesh), p)")
locate(PLUMB_ANYTHING) PLUMB_DELETED;

// What is known of one figure?
PLUMB_NO_ANSWER(Aabb3,
                "plumb: fit_aabb takes a bounded figure, or a span of points and, where they move, a Pose or a "
                "RigidPose (include <plumb/figure.hpp>)")
fit_aabb(PLUMB_ANYTHING) PLUMB_DELETED;
PLUMB_NO_ANSWER(Aabb3, "plumb: fit_aabb is not told of which points: fit_aabb(std::vector<Point3>{{0, 0, 0}})")
fit_aabb(PLUMB_POINTS_IN_BRACES) PLUMB_DELETED;

PLUMB_NO_ANSWER(Support3,
                "plumb: support_point takes a convex bounded figure or a span of points, and then a Vector2 or Vector3 "
                "of its space: support_point(figure, direction) (include <plumb/figure.hpp>)")
support_point(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(double, "plumb: volume takes a solid, or a mesh that is closed (include <plumb/figure.hpp>)")
volume(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(double, "plumb: surface_area takes a solid, or a mesh (include <plumb/figure.hpp>)")
surface_area(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(double, "plumb: area takes a bounded flat figure (include <plumb/figure.hpp>)")
area(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(Point3,
                "plumb: centroid takes a span of points, a triangle, tetrahedron or polygon, or a closed mesh (include "
                "<plumb/figure.hpp>)")
centroid(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(double,
                "plumb: signed_area takes a Triangle2, Quadrilateral2, Polygon2 or HoledPolygon2; area takes flat "
                "figures of space as well")
signed_area(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(bool, "plumb: is_empty takes a box or a k-DOP; no other figure can be")
is_empty(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(Point3,
                "plumb: barycentric takes a segment, triangle or tetrahedron and then a point of its space: "
                "barycentric(triangle, p)")
barycentric(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(bool,
                "plumb: voronoi_region takes a segment, triangle, tetrahedron, box of space or convex polyhedron and "
                "then a point of its space: voronoi_region(triangle, p)")
voronoi_region(PLUMB_ANYTHING) PLUMB_DELETED;

// What is known of many, and of what they bound?
PLUMB_NO_ANSWER(Hull3, "plumb: convex_hull takes a span or vector of Point2 or Point3, and then options")
convex_hull(PLUMB_ANYTHING) PLUMB_DELETED;
PLUMB_NO_ANSWER(Hull3, "plumb: convex_hull is not told of which points: convex_hull(std::vector<Point3>{{0, 0, 0}})")
convex_hull(PLUMB_POINTS_IN_BRACES) PLUMB_DELETED;

PLUMB_NO_ANSWER(bool,
                "plumb: convex_polyhedron takes a PolygonMesh or TriangleMesh, or a Hull3 and its points: "
                "convex_polyhedron(convex_hull(points), points)")
convex_polyhedron(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(Obb3, "plumb: fit_obb takes axes and then a span of points; minimum_obb(points) finds the axes")
fit_obb(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(
    bool, "plumb: fit_k_dop takes a span of points and then directions, or how many of them: fit_k_dop(points, 14)")
fit_k_dop(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(bool, "plumb: minkowski_sum takes two convex polygons, two convex polyhedra or two spans of points")
minkowski_sum(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(bool,
                "plumb: minkowski_difference takes two convex polygons, two convex polyhedra or two spans of points")
minkowski_difference(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(std::vector<std::uint32_t>,
                "plumb: extreme_points takes a span of points and then a vector of their space")
extreme_points(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(
    Obb3, "plumb: minimum_obb takes a span or vector of Point2 or Point3, in space also their Hull3, and then options")
minimum_obb(PLUMB_ANYTHING) PLUMB_DELETED;
PLUMB_NO_ANSWER(Obb3, "plumb: minimum_obb is not told of which points: minimum_obb(std::vector<Point3>{{0, 0, 0}})")
minimum_obb(PLUMB_POINTS_IN_BRACES) PLUMB_DELETED;

PLUMB_NO_ANSWER(MinimumSphere,
                "plumb: minimum_sphere takes a span or vector of Point3 or Sphere3; of the plane ask minimum_circle")
minimum_sphere(PLUMB_ANYTHING) PLUMB_DELETED;
PLUMB_NO_ANSWER(MinimumSphere,
                "plumb: minimum_sphere is not told of which points: minimum_sphere(std::vector<Point3>{{0, 0, 0}})")
minimum_sphere(PLUMB_POINTS_IN_BRACES) PLUMB_DELETED;

PLUMB_NO_ANSWER(MinimumSphere,
                "plumb: minimum_circle takes a span or vector of Point2 or Circle2; of space ask minimum_sphere")
minimum_circle(PLUMB_ANYTHING) PLUMB_DELETED;
PLUMB_NO_ANSWER(MinimumSphere,
                "plumb: minimum_circle is not told of which points: minimum_circle(std::vector<Point2>{{0, 0}})")
minimum_circle(PLUMB_POINTS_IN_BRACES) PLUMB_DELETED;

PLUMB_NO_ANSWER(Aabb3,
                "plumb: merge takes two bounds of one kind, boxes, balls, capsules, lozenges, cylinders or k-DOPs, or "
                "a ball and a point; of points fit_aabb(points)")
merge(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(Aabb3,
                "plumb: transform takes a bound, a box, ball, capsule, lozenge, cylinder or k-DOP, and then a pose of "
                "its space; any figure stands under one as Posed{figure, pose}")
transform(PLUMB_ANYTHING) PLUMB_DELETED;

}  // namespace plumb
