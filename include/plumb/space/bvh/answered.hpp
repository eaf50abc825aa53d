// What is said to a question of space/ that has no answer for these arguments?  One sentence each.
//
// Laws: those of arith/no_answer.hpp.
// Cost: compile time only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "plumb/figure/basic/answered.hpp"

namespace plumb {

struct Bvh;
struct BoxPair;
struct ClosestOnMesh;
struct ClosestTriangles;
struct HausdorffDistance;
struct NearestPoint;
struct NearTriangle;
struct NumberedHit;
struct PairCount;
struct TrianglePair;

// Which tree?
PLUMB_NO_ANSWER(Bvh,
                "plumb: build_bvh takes a TriangleMesh, or a span of vertices and one of triangles, three numbers "
                "each, and then BvhOptions; of boxes build_box_tree")
build_bvh(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(bool,
                "plumb: build_kd_tree takes a span or vector of Point2 or Point3, and then KdTreeOptions: "
                "build_kd_tree(std::vector<Point3>{{0, 0, 0}, {1, 1, 1}}); of figures build_figure_tree")
build_kd_tree(PLUMB_ANYTHING) PLUMB_DELETED;
PLUMB_NO_ANSWER(bool, "plumb: build_kd_tree is not told of which points: build_kd_tree(std::vector<Point3>{{0, 0, 0}})")
build_kd_tree(PLUMB_POINTS_IN_BRACES) PLUMB_DELETED;

PLUMB_NO_ANSWER(bool,
                "plumb: build_figure_tree takes a span or vector of one kind of box, segment or triangle, and then "
                "KdTreeOptions; of points build_kd_tree, of balls a build_box_tree of their boxes")
build_figure_tree(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(bool,
                "plumb: build_split_tree takes a span or vector of one kind of box, segment or triangle, and then "
                "SplitTreeOptions")
build_split_tree(PLUMB_ANYTHING) PLUMB_DELETED;

// Which pairs?
PLUMB_NO_ANSWER(
    std::vector<TrianglePair>,
    "plumb: intersecting_pairs takes the trees of two meshes, each a Bvh or CompactBvh, in braces with a pose "
    "where it has been moved, or two VolumeMesh, or one tree: intersecting_pairs(build_bvh(a), build_bvh(b))")
intersecting_pairs(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(
    std::optional<TrianglePair>,
    "plumb: any_intersecting_pair takes the trees of two meshes, each a Bvh or CompactBvh, in braces with a "
    "pose where it has been moved, or two VolumeMesh, or one tree: "
    "any_intersecting_pair(build_bvh(a), build_bvh(b))")
any_intersecting_pair(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(
    PairCount,
    "plumb: count_intersecting_pairs takes the trees of two meshes, each a Bvh or CompactBvh, in braces with "
    "a pose where it has been moved, or one tree: count_intersecting_pairs(build_bvh(a), build_bvh(b))")
count_intersecting_pairs(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(
    std::vector<BoxPair>,
    "plumb: overlapping_pairs takes spans or vectors of one kind of box, Aabb2, Aabb3, FloatBox2 or FloatBox3, or an "
    "index of boxes, and then a BoxPairSink and options; of meshes ask intersecting_pairs(build_bvh(a), build_bvh(b))")
overlapping_pairs(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(
    std::vector<BoxPair>,
    "plumb: sort_and_sweep_pairs takes spans or vectors of one kind of box, Aabb2, Aabb3, FloatBox2 or FloatBox3")
sort_and_sweep_pairs(PLUMB_ANYTHING) PLUMB_DELETED;

// How near is a mesh?
PLUMB_NO_ANSWER(std::optional<ClosestOnMesh>,
                "plumb: closest_on_mesh takes the tree of a mesh, a Bvh, CompactBvh, PosedMesh or PosedCompactMesh, "
                "and then a Point3, or spans of points and of answers: closest_on_mesh(build_bvh(mesh), p)")
closest_on_mesh(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(std::optional<ClosestTriangles>,
                "plumb: closest_triangles takes the trees of two meshes, both a Bvh or both a PosedMesh: "
                "closest_triangles(build_bvh(a), build_bvh(b))")
closest_triangles(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(std::vector<NearTriangle>,
                "plumb: nearest_triangles takes the tree of a mesh, a Bvh, CompactBvh, PosedMesh or PosedCompactMesh, "
                "a Point3 and how many: nearest_triangles(build_bvh(mesh), p, k)")
nearest_triangles(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(std::vector<NearTriangle>,
                "plumb: triangles_within takes the tree of a mesh, a Bvh, CompactBvh, PosedMesh or PosedCompactMesh, a "
                "Point3 and a distance: triangles_within(build_bvh(mesh), p, distance)")
triangles_within(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(
    std::vector<std::uint32_t>,
    "plumb: meeting takes the tree of a mesh, and then a figure of space or a span of one kind of them, the "
    "list of space/range/range_search.hpp: meeting(build_bvh(mesh), box)")
meeting(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(HausdorffDistance,
                "plumb: hausdorff_distance takes the trees of two meshes, both a Bvh or both a PosedMesh: "
                "hausdorff_distance(build_bvh(a), build_bvh(b))")
hausdorff_distance(PLUMB_ANYTHING) PLUMB_DELETED;

// What does a ray hit?
PLUMB_NO_ANSWER(
    std::optional<std::uint32_t>,
    "plumb: first_triangle takes the tree of a mesh, a Bvh or CompactBvh, in braces with a pose where it has "
    "been moved, and then a Ray3, Segment3 or Line3, or spans of AnyRay and of answers: "
    "first_triangle(build_bvh(mesh), ray)")
first_triangle(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(bool,
                "plumb: any_hit takes an index, and then a Ray3, Segment3 or Line3, or spans of AnyRay and of answers: "
                "any_hit(build_bvh(mesh), ray); of one figure hits(ray, figure)")
any_hit(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(std::size_t,
                "plumb: count_hits takes the tree of a mesh, a Bvh or CompactBvh, in braces with a pose where it has "
                "been moved, and then a Ray3, Segment3 or Line3, or spans of AnyRay and of answers: "
                "count_hits(build_bvh(mesh), ray)")
count_hits(PLUMB_ANYTHING) PLUMB_DELETED;

// Which are near, and which nearest?
PLUMB_NO_ANSWER(
    std::vector<std::uint32_t>,
    "plumb: in_box takes an index of points or figures and then an Aabb2 or Aabb3: in_box(build_kd_tree(points), box)")
in_box(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(std::vector<std::uint32_t>,
                "plumb: within takes an index of points or figures, a point and then a radius: "
                "within(build_kd_tree(points), p, 2.0)")
within(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(NearestPoint,
                "plumb: nearest takes an index, of points (build_kd_tree), of figures (build_figure_tree) or a batch, "
                "and then a point of its space: nearest(build_kd_tree(points), p)")
nearest(PLUMB_ANYTHING) PLUMB_DELETED;

}  // namespace plumb
