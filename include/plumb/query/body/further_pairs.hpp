// What else takes contains, first_hit and first_contact?  What no table of pairs has a row for: meshes and trees, boxes and
// slabs as they are stated, figures of the user's own, and templates, which take the pairs of the tables.
//
// Laws: (1) a row for each two types, as the header spells them, by which functions of the question are declared: of
// first_hit also hits and first_hit_parameter, of first_contact also first_contact_time and intersects of what moves.
// (2) tests/house/question_places_test.cpp holds the list and the tables against all public headers: who adds a function
// adds its row here, or its letter there.
// Source: RTCD 2.3.
// Cost: none, all of it is constexpr.
#pragma once

#include <array>
#include <string_view>

#include "plumb/predicates/standard.hpp"

namespace plumb::query {

struct FurtherPair {
  std::string_view question, first, second;
  std::string_view header;  // under include/plumb
};

inline constexpr auto further_pairs = std::to_array<FurtherPair>({
    {"contains", "AabbCenter3", "AabbCenter3", "figure/aabb/relation.hpp"},
    {"contains", "AabbWidths3", "AabbWidths3", "figure/aabb/relation.hpp"},
    {"contains", "Shape", "Point2", "figure/containment/contains.hpp"},
    {"contains", "Shape", "Point3", "figure/containment/contains.hpp"},
    {"contains", "Shape", "double (p)[2]", "figure/containment/contains.hpp"},
    {"contains", "Shape", "double (p)[3]", "figure/containment/contains.hpp"},
    {"contains", "Csg2", "Point2", "figure/containment/csg.hpp"},
    {"contains", "Csg3", "Point3", "figure/containment/csg.hpp"},
    {"contains", "ImplicitShape2<Polynomial, N>", "Point2", "figure/containment/implicit_function.hpp"},
    {"contains", "ImplicitShape3<Polynomial, N>", "Point3", "figure/containment/implicit_function.hpp"},
    {"contains", "MinkowskiSum2", "Point2", "figure/minkowski/minkowski.hpp"},
    {"contains", "MinkowskiSum3", "Point3", "figure/minkowski/minkowski.hpp"},
    {"contains", "Outer", "Inner", "query/convex/containment.hpp"},
    {"contains", "Outer", "Inner", "query/overlap/posed.hpp"},
    {"contains", "Shape", "Point", "query/overlap/posed.hpp"},
    {"contains", "Shape", "Point2", "query/overlap/posed.hpp"},
    {"contains", "Shape", "Point3", "query/overlap/posed.hpp"},
    {"contains", "Outer", "Inner", "query/overlap/restated.hpp"},
    {"contains", "PolytopeHierarchy", "Point3", "query/polytope_hierarchy/polytope_hierarchy.hpp"},
    {"contains", "TriangleMesh", "Point3", "query/ray/parity.hpp"},
    {"contains", "Fat<Shape>", "Point", "query/separation/fat.hpp"},
    {"contains", "Shape", "Point2", "query/variant/questions.hpp"},
    {"contains", "Shape", "Point3", "query/variant/questions.hpp"},
    {"contains", "Shape", "double (p)[2]", "query/variant/questions.hpp"},
    {"contains", "Shape", "double (p)[3]", "query/variant/questions.hpp"},
    {"contains", "Outer", "Inner", "query/variant/own_figure.hpp"},
    {"contains", "Outer", "Inner", "query/variant/questions.hpp"},
    {"contains", "MeshView", "Point3", "space/ray/inside.hpp"},
    {"first_contact", "A", "Translating<B>", "query/time_of_impact/motion.hpp"},
    {"first_contact", "Translating<A>", "B", "query/time_of_impact/motion.hpp"},
    {"first_contact", "Translating<A>", "Translating<B>", "query/time_of_impact/posed.hpp"},
    {"first_contact", "Moving<A>", "Moving<B>", "query/time_of_impact/posed_corners.hpp"},
    {"first_contact", "Translating<A>", "Translating<B>", "query/time_of_impact/restated.hpp"},
    {"first_contact", "Translating<A>", "Translating<B>", "query/time_of_impact/translating_contact.hpp"},
    {"first_contact", "Translating<A>", "Translating<B>", "query/variant/own_figure.hpp"},
    {"first_contact", "Translating<A>", "Translating<B>", "query/variant/questions.hpp"},
    {"first_contact", "Moving<A>", "Moving<B>", "query/variant/questions.hpp"},
    {"first_contact", "MovingMeshView", "MotionContactOptions", "space/moving/motion_contacts.hpp"},
    {"first_contact", "BvhView", "Vector3", "space/moving/translating_mesh.hpp"},
    {"first_hit", "AnyRay", "PolytopeHierarchy", "query/polytope_hierarchy/polytope_hierarchy.hpp"},
    {"first_hit", "AnyRay", "BoxBatch", "query/ray/batch.hpp"},
    {"first_hit", "AnyRay", "TriangleBatch", "query/ray/batch.hpp"},
    {"first_hit", "AnyRay", "TriangleMesh", "query/ray/batch.hpp"},
    {"first_hit", "Ray3", "Csg3", "query/ray/csg.hpp"},
    {"first_hit", "Segment3", "Csg3", "query/ray/csg.hpp"},
    {"first_hit", "AnyRay", "Shape", "query/ray/hits.hpp"},
    {"first_hit", "AnyRay2", "Shape", "query/ray/hits.hpp"},
    {"first_hit", "Ray", "Aabb3", "query/ray/hits.hpp"},
    {"first_hit", "Ray", "Sphere3", "query/ray/hits.hpp"},
    {"first_hit", "Ray", "Triangle3", "query/ray/hits.hpp"},
    {"first_hit", "Ray", "Posed<Triangle3>", "query/ray/posed.hpp"},
    {"first_hit", "Ray", "Shape", "query/ray/posed.hpp"},
    {"first_hit", "AnyRay", "Shape", "query/ray/ray.hpp"},
    {"first_hit", "AnyRay2", "Shape", "query/ray/ray2.hpp"},
    {"first_hit", "Ray", "AabbCenter3", "query/ray/restated.hpp"},
    {"first_hit", "Ray", "Shape", "query/ray/restated.hpp"},
    {"first_hit", "Ray", "Slab2", "query/ray/restated.hpp"},
    {"first_hit", "Ray", "Slab3", "query/ray/restated.hpp"},
    {"first_hit", "Ray", "Shape", "query/variant/own_figure.hpp"},
    {"first_hit", "Ray", "Shape", "query/variant/questions.hpp"},
    {"first_hit", "BspTree", "AnyRay", "space/bsp/bsp_ray.hpp"},
    {"first_hit", "Bvh", "AnyRay", "space/coherence/last_answer.hpp"},
    {"first_hit", "SplitTree<Figure>", "SplitTree<Figure>::Ray", "space/kd_tree/split_ray.hpp"},
    {"first_hit", "SplitTree<Figure>", "SplitTree<Figure>::Segment", "space/kd_tree/split_ray.hpp"},
    {"first_hit", "MeshView", "AnyRay", "space/ray/mesh_ray.hpp"},
    {"first_hit", "MeshView", "std::span<AnyRay>", "space/ray/mesh_ray.hpp"},
    {"first_hit", "BoxTree", "AnyRay", "space/ray/shape_ray.hpp"},
    {"first_hit", "VolumeMesh<Volume>", "AnyRay", "space/ray/volume_ray.hpp"},
    {"first_hit", "Index", "Ray", "space/sort_and_sweep/index_verbs.hpp"},
});

}  // namespace plumb::query
