// What is said to a question of query/ that has no answer for these figures?  One sentence each.
//
// Laws: those of arith/no_answer.hpp.
// Cost: compile time only.
#pragma once

#include <optional>

#include "plumb/figure/basic/answered.hpp"

namespace plumb {

class Rational;
class Root;
enum class Sign : signed char;
struct Closest;
struct Contact;
struct ContactManifold;
struct ExactContact;
struct ExactDistance;
struct GjkAnswer;
struct GjkBounds;
struct Hit;
struct Intersection3;
struct LinearAnswer3;
struct Penetration;
struct PenetrationAlong;
struct RayParameter;
struct TimeSpan;

// What have they in common?
PLUMB_NO_ANSWER(Intersection3,
                "plumb: intersection takes lines, rays, segments, planes, triangles, boxes and convex polyhedra of one "
                "space, the pairs of docs/intersection.md; relate takes more; of trees of meshes ask intersections(a, "
                "b, intersecting_pairs(a, b))")
intersection(PLUMB_ANYTHING) PLUMB_DELETED;

template <class A, class B>
concept Intersectable = requires(const A& a, const B& b) {
  intersection(a, b);
};

// What does a ray hit?
PLUMB_NO_ANSWER(
    std::optional<Hit>,
    "plumb: first_hit takes a line, ray or segment and then a figure of its space, the pairs of docs/rays.md, a "
    "TriangleMesh or a TriangleBatch; of many rays at a mesh ask first_hit(build_bvh(mesh), ray)")
first_hit(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(std::optional<RayParameter>,
                "plumb: first_hit_parameter takes a line, ray or segment and then a figure of its space, the pairs of "
                "docs/rays.md; of a mesh ask first_hit(build_bvh(mesh), ray)")
first_hit_parameter(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(bool,
                "plumb: hits takes a line, ray or segment and then a figure of its space, the pairs of docs/rays.md; "
                "of a mesh ask first_hit(build_bvh(mesh), ray)")
hits(PLUMB_ANYTHING) PLUMB_DELETED;

template <class Straight, class Shape>
concept Hittable = requires(const Straight& straight, const Shape& shape) {
  first_hit(straight, shape);
};

// How near?
PLUMB_NO_ANSWER(Closest,
                "plumb: closest_points takes two figures of one space, neither of which is a cylinder or a cone, the "
                "pairs of docs/closest.md (include <plumb/query.hpp>); of a mesh ask closest_on_mesh(build_bvh(mesh), "
                "p) or closest_triangles(build_bvh(a), build_bvh(b))")
closest_points(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(Point3,
                "plumb: closest_point takes a figure and then a point of its space, closest_point(figure, p); "
                "closest_points takes two figures; of a mesh ask closest_on_mesh(build_bvh(mesh), p)")
closest_point(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(double,
                "plumb: distance takes two figures of one space, neither of which is a cylinder or a cone, the pairs "
                "of docs/closest.md (include <plumb/query.hpp>); of a mesh ask closest_on_mesh(build_bvh(mesh), p) or "
                "closest_triangles(build_bvh(a), build_bvh(b))")
distance(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(ExactDistance,
                "plumb: exact_distance takes two figures of one space, neither of which is a cylinder or a cone, the "
                "pairs of docs/closest.md (include <plumb/query.hpp>)")
exact_distance(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(Rational,
                "plumb: squared_distance_exact takes two figures of one space, neither of which is round, the pairs of "
                "docs/closest.md (include <plumb/query.hpp>); exact_distance takes more")
squared_distance_exact(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(double, "plumb: closest_parameter takes a line, ray or segment and then a point of its space")
closest_parameter(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(Sign,
                "plumb: compare_distance takes two figures and then a number or two more figures, each pair one that "
                "distance takes: compare_distance(a, b, 3.0), compare_distance(a, b, c, d)")
compare_distance(PLUMB_ANYTHING) PLUMB_DELETED;

template <class A, class B>
concept Measurable = requires(const A& a, const B& b) {
  distance(a, b);
  closest_points(a, b);
};

// When do they meet?
PLUMB_NO_ANSWER(std::optional<Contact>,
                "plumb: first_contact takes Translating figures of one space, one of which may stand still, or Moving "
                "points, segments and triangles: docs/motion.md lists the pairs")
first_contact(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(std::optional<Root>,
                "plumb: first_contact_time takes Translating figures of one space, one of which may stand still, or "
                "Moving points, segments and triangles: docs/motion.md lists the pairs")
first_contact_time(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(std::optional<TimeSpan>,
                "plumb: first_contact_span takes two Translating figures of space that distance takes, or two Moving "
                "points, segments, triangles or tetrahedra")
first_contact_span(PLUMB_ANYTHING) PLUMB_DELETED;

template <class A, class B>
concept Collidable = requires(const A& a, const B& b) {
  first_contact(a, b);
};

// How do convex bodies touch, and how deep are they in one another?
PLUMB_NO_ANSWER(
    std::optional<ContactManifold>,
    "plumb: contact takes two convex bodies of space, as they stand or under a pose, and then ContactManifoldOptions: "
    "points, "
    "segments, triangles, convex polygons, boxes, rectangles, tetrahedra, ConvexPolyhedron3 and VertexHull3, balls, "
    "capsules, lozenges")
contact(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(
    std::optional<ExactContact>,
    "plumb: exact_contact takes two convex bodies of space, as they stand or under a pose, and then a margin: points, "
    "segments, triangles, convex polygons, boxes, rectangles, tetrahedra, ConvexPolyhedron3 and VertexHull3, balls, "
    "capsules, lozenges")
exact_contact(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(
    std::optional<Penetration>,
    "plumb: penetration takes two convex bodies of space, as they stand or under a pose: points, segments, triangles, "
    "convex polygons, boxes, rectangles, tetrahedra, ConvexPolyhedron3 and VertexHull3, balls, capsules, lozenges")
penetration(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(std::optional<Penetration>,
                "plumb: exact_penetration takes two convex bodies of space, as they stand or under a pose: points, "
                "segments, triangles, convex polygons, boxes, rectangles, tetrahedra, ConvexPolyhedron3 and "
                "VertexHull3, balls, capsules, lozenges")
exact_penetration(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(std::optional<PenetrationAlong>,
                "plumb: penetration_along takes two convex bodies of space and then a Vector3 or a span of them: "
                "penetration_along(a, b, up)")
penetration_along(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(
    GjkBounds,
    "plumb: gjk_bounds takes two figures that support_point takes, or two support mappings, and then options")
gjk_bounds(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(GjkAnswer,
                "plumb: gjk takes two convex bodies of space, as they stand or under a pose: points, segments, "
                "triangles, convex polygons, boxes, rectangles, tetrahedra, ConvexPolyhedron3 and VertexHull3, balls, "
                "capsules, lozenges; of what is known by its farthest points alone ask gjk_bounds")
gjk(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(bool,
                "plumb: gjk_intersects takes two convex bodies of space, as they stand or under a pose: points, "
                "segments, triangles, convex polygons, boxes, rectangles, tetrahedra, ConvexPolyhedron3 and "
                "VertexHull3, balls, capsules, lozenges; of what is known by its farthest points alone ask gjk_bounds")
gjk_intersects(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(double,
                "plumb: gjk_distance takes two convex bodies of space, as they stand or under a pose: points, "
                "segments, triangles, convex polygons, boxes, rectangles, tetrahedra, ConvexPolyhedron3 and "
                "VertexHull3, balls, capsules, lozenges; of what is known by its farthest points alone ask gjk_bounds")
gjk_distance(PLUMB_ANYTHING) PLUMB_DELETED;

// What do linear constraints allow?
PLUMB_NO_ANSWER(LinearAnswer3,
                "plumb: maximize takes a Vector2 or Vector3 and then a span or vector of halfspaces of its space, "
                "maximize(direction, halfspaces), or a vector of Rational and a LinearSystem")
maximize(PLUMB_ANYTHING) PLUMB_DELETED;

}  // namespace plumb
