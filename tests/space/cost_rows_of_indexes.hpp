// What do questions about many figures cost, by an index of them, and about meshes?
#pragma once

#include <array>

#include "space/cost_row.hpp"

namespace plumb::cost {

inline std::size_t told_pairs(const Cloud& c, BroadPhaseMethod method) {
  return overlapping_pairs(c.boxes, {.execution = Execution::serial, .method = method}).size();
}
/// With its boxes put in one after the other, moved and asked.
template <class Index>
void come_and_move(Index&& index, const Cloud& c) {
  std::vector<std::uint32_t> handles;
  for (const Aabb3& b : c.boxes) handles.push_back(index.insert(b));
  for (std::size_t i = 0; i < handles.size(); ++i) index.move(handles[i], c.boxes[(i + 1) % handles.size()]);
  (void)index.pairs();
}

inline const CostRow rows_of_indexes[]{
    {"build_bvh", "space/bvh/build.hpp", quadratic, 5, [](const Cloud& c) { (void)build_bvh(c.mesh); }},
    {"build_compact_bvh", "space/bvh/compact_tree.hpp", linear, 5,
     [](const Cloud& c) { (void)compact(build_bvh(c.mesh)); }},
    {"InsertionTree", "space/bvh/insertion_tree.hpp", quadratic, 5,
     [](const Cloud& c) {
       InsertionTree tree;
       for (std::uint32_t i = 0; i < c.boxes.size(); ++i) tree.insert(i, c.boxes[i]);
       for (std::uint32_t i = 0; i < c.boxes.size(); i += 2) tree.remove(i);
     }},
    {"build_sphere_tree", "space/bvh/sphere_tree.hpp", linear, 500,
     [](const Cloud& c) { (void)build_sphere_tree(c.mesh); }, 36},
    {"refit", "space/bvh/refit.hpp", linear, 5,
     [](const Cloud& c) {
       Bvh bvh = build_bvh(c.mesh);
       refit(bvh, c.b, Execution::serial);
     }},
    {"first_hit of a mesh", "space/ray/mesh_ray.hpp", linear, 100,
     [](const Cloud& c) {
       const Bvh bvh = build_bvh(c.mesh);
       for (const Point3& p : asked_points(c)) (void)first_hit(Ray3{c.b[0], vector(p)}, bvh);
     }},
    {"first_hit of a posed mesh", "space/ray/posed_ray.hpp", linear, 200,
     [](const Cloud& c) {
       const Bvh bvh = build_bvh(c.mesh);
       for (const Point3& p : asked_points(c)) (void)first_hit(Ray3{c.b[0], vector(p)}, PosedMesh{bvh, pose(c.b)});
     }},
    {"winding_number of a mesh", "space/ray/inside.hpp", linear, 20,
     [](const Cloud& c) {
       const Bvh bvh = build_bvh(c.mesh);
       for (const Point3& p : asked_points(c)) (void)winding_number(bvh, p);
     }},
    {"triangles_meeting", "space/range/range_search.hpp", linear, 200,
     [](const Cloud& c) { (void)triangles_meeting(build_bvh(c.mesh), capsule(c.b)); }},
    {"triangles_meeting, posed", "space/range/posed_range.hpp", linear, 500,
     [](const Cloud& c) {
       const Bvh bvh = build_bvh(c.mesh);
       (void)triangles_meeting(PosedMesh{bvh, pose(c.b)}, capsule(c.b));
     }},
    {"closest_on_mesh", "space/closest/closest_on_mesh.hpp", sorting, 500,
     [](const Cloud& c) {
       const Bvh bvh = build_bvh(c.mesh);
       for (const Point3& p : asked_points(c)) (void)closest_on_mesh(bvh, p);
     }},
    {"closest_on_mesh, posed", "space/closest/posed_closest.hpp", sorting, 1000,
     [](const Cloud& c) {
       const Bvh bvh = build_bvh(c.mesh);
       for (const Point3& p : asked_points(c)) (void)closest_on_mesh(PosedMesh{bvh, pose(c.b)}, p);
     }},
    {"closest_triangles", "space/closest/closest_triangles.hpp", quadratic_log, 500,
     [](const Cloud& c) { (void)closest_triangles(build_bvh(c.mesh), build_bvh(c.other)); }},
    {"hausdorff_distance", "space/closest/hausdorff.hpp", quadratic_log, 500,
     [](const Cloud& c) {
       (void)hausdorff_distance(build_bvh(c.mesh), build_bvh(c.other), {.execution = Execution::serial});
     }},
    {"intersecting_pairs", "space/pairs/mesh_pairs.hpp", quadratic, 100,
     [](const Cloud& c) { (void)intersecting_pairs(build_bvh(c.mesh), build_bvh(c.other)); }},
    {"intersecting_pairs, posed", "space/pairs/posed_pairs.hpp", quadratic, 500,
     [](const Cloud& c) {
       const Bvh a = build_bvh(c.mesh), b = build_bvh(c.other);
       (void)intersecting_pairs(PosedMesh{a, pose(c.b)}, PosedMesh{b, identity_pose});
     }},
    {"PairFront", "space/coherence/pair_front.hpp", quadratic, 100,
     [](const Cloud& c) {
       const Bvh a = build_bvh(c.mesh), b = build_bvh(c.other);
       PairFront front;
       for (int i = 0; i < 2; ++i) (void)front.intersecting_pairs(a, b);
     }},
    {"first_contact, translating mesh", "space/moving/translating_mesh.hpp", quadratic_log, 2000,
     [](const Cloud& c) { (void)first_contact(build_bvh(c.mesh), vector(c.a[0]), build_bvh(c.other)); }, 36},
    {"contacts_in_motion", "space/moving/motion_contacts.hpp", quadratic, 7000,
     [](const Cloud& c) { (void)contacts_in_motion(build_moving_mesh(c.a, c.b, c.mesh.triangles)); }, 36},
    // boxes
    {"overlapping_pairs", "space/broad_phase/overlapping_pairs.hpp", quadratic, 20,
     [](const Cloud& c) {
       for (const BroadPhaseMethod method : broad_phase_methods) (void)told_pairs(c, method);
     }},
    {"sort_and_sweep_pairs", "space/sort_and_sweep/sort_and_sweep.hpp", quadratic, 1,
     [](const Cloud& c) { (void)sort_and_sweep_pairs(c.boxes, {.execution = Execution::serial}); }},
    {"SweepArray", "space/sort_and_sweep/sweep_array.hpp", quadratic, 1,
     [](const Cloud& c) { (void)SweepArray().pairs(c.boxes); }},
    {"SweepLists", "space/sort_and_sweep/sweep_lists.hpp", quadratic, 5,
     [](const Cloud& c) {
       SweepLists lists;
       std::vector<std::uint32_t> numbers;
       for (const Aabb3& b : c.boxes) numbers.push_back(lists.insert(b));
       for (std::size_t i = 0; i < numbers.size(); ++i) lists.move(numbers[i], c.boxes[(i + 1) % numbers.size()]);
       (void)lists.pairs();
     }},
    {"HierarchicalGrid", "space/grid/hierarchical_grid.hpp", quadratic, 5,
     [](const Cloud& c) { come_and_move(HierarchicalGrid3(), c); }},
    {"RowColumnGrid", "space/grid/row_column_grid.hpp", quadratic, 20,
     [](const Cloud& c) { come_and_move(RowColumnGrid3({.rows = 64}), c); }},
    {"ImplicitGrid", "space/grid/implicit_grid.hpp", quadratic, 20,
     [](const Cloud& c) { come_and_move(ImplicitGrid3(0.5, {.rows = 64}), c); }},
    {"HashedGrid", "space/grid/list_grid.hpp", quadratic, 20,
     [](const Cloud& c) { come_and_move(HashedGrid3(0.5), c); }},
    {"StaticGrid", "space/grid/static_grid.hpp", quadratic, 20,
     [](const Cloud& c) { (void)StaticGrid3(c.boxes).pairs(); }},
    {"LooseOctree", "space/octree/loose_octree.hpp", quadratic, 5,
     [](const Cloud& c) { come_and_move(LooseOctree(fit_aabb(c.a)), c); }},
    {"build_octree, boxes", "space/octree/box_octree.hpp", quadratic, 5,
     [](const Cloud& c) { (void)overlapping_pairs(build_octree(c.boxes)); }},
    {"build_octree, points", "space/octree/point_octree.hpp", linear, 5,
     [](const Cloud& c) { (void)in_box(build_octree(c.a), c.boxes[0]); }},
    {"hybrid index", "space/kd_tree/hybrid_index.hpp", quadratic, 50,
     [](const Cloud& c) {
       const auto world = build_grid_of_trees(c.boxes, {.in_part = 4, .most_in_list = 2});
       (void)overlapping_pairs(world), (void)nearest(world, c.b[0]);
     }},
    // points and figures
    {"nearest in a kd-tree", "space/kd_tree/nearest_point.hpp", sorting, 10,
     [](const Cloud& c) {
       const KdTree3 tree = build_kd_tree(c.a);
       for (const Point3& p : asked_points(c)) (void)nearest(tree, p);
     }},
    {"build_kd_tree", "space/kd_tree/kd_tree.hpp", sorting, 1, [](const Cloud& c) { (void)build_kd_tree(c.a); }},
    {"within in a kd-tree", "space/kd_tree/point_range.hpp", sorting, 5,
     [](const Cloud& c) {
       const KdTree3 tree = build_kd_tree(c.a);
       for (const Point3& p : asked_points(c)) (void)within(tree, p, std::fabs(p.x));
     }},
    {"build_figure_tree", "space/kd_tree/figure_tree.hpp", sorting, 5,
     [](const Cloud& c) { (void)build_figure_tree(c.triangles); }},
    {"nearest in a figure tree", "space/kd_tree/nearest_figure.hpp", sorting, 200,
     [](const Cloud& c) {
       const auto tree = build_figure_tree(c.triangles);
       for (const Point3& p : asked_points(c)) (void)nearest(tree, p);
     }},
    {"in_box in a figure tree", "space/kd_tree/figure_range.hpp", sorting, 50,
     [](const Cloud& c) {
       const auto tree = build_figure_tree(c.triangles);
       for (std::size_t i = 0; i < 9; ++i) (void)in_box(tree, c.boxes[i]);
     }},
    {"build_split_tree", "space/kd_tree/split_tree.hpp", sorting, 100,
     [](const Cloud& c) { (void)build_split_tree(c.triangles, {.most_in_leaf = 1}); }},
    {"first_hit in a split tree", "space/kd_tree/split_ray.hpp", linear, 200,
     [](const Cloud& c) {
       const auto tree = build_split_tree(c.triangles);
       for (const Point3& p : asked_points(c)) (void)first_hit(tree, Ray3{c.b[0], vector(p)});
     }},
    {"overlapping_pairs in a split tree", "space/kd_tree/split_range.hpp", quadratic, 500,
     [](const Cloud& c) { (void)overlapping_pairs(build_split_tree(c.triangles)); }},
    // surface
    {"find_edges", "surface/topology.hpp", sorting, 1, [](const Cloud& c) { (void)mesh_statistics(c.mesh); }},
    {"triangulate", "surface/triangulate.hpp", quadratic, 20,
     [](const Cloud& c) {
       PolygonMesh mesh{c.a, {}, {0, static_cast<std::uint32_t>(c.a.size())}};
       for (std::uint32_t i = 0; i < c.a.size(); ++i) mesh.corners.push_back(i);
       (void)triangulate(mesh);
     }},
    {"section", "surface/section.hpp", quadratic, 50,
     [](const Cloud& c) {
       (void)section(c.mesh, Plane3{vector(c.b[0]), 0});
     }},
    {"find_shells", "surface/shells.hpp", quadratic, 500, [](const Cloud& c) { (void)find_shells(c.mesh); }},
    {"close_vertices", "surface/defects.hpp", quadratic, 5,
     [](const Cloud& c) { (void)close_vertices(c.mesh, std::fabs(c.a[0].x)); }},
    {"vertices_on_edges", "surface/defects.hpp", quadratic, 50,
     [](const Cloud& c) { (void)vertices_on_edges(find_edges(c.mesh), build_bvh(c.mesh)); }},
};

}  // namespace plumb::cost
