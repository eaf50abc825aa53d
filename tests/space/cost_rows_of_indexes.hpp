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
  std::vector<BoxHandle> handles;
  for (const Aabb3& b : c.boxes) handles.push_back(index.insert(b));
  for (std::size_t i = 0; i < handles.size(); ++i) index.move(handles[i], c.boxes[(i + 1) % handles.size()]);
  (void)index.overlapping_pairs();
}

/// A solid without notches.
inline TriangleMesh hull_of(const std::vector<Point3>& points) {
  const Hull3 hull = convex_hull(points);
  TriangleMesh mesh{points, {}};
  for (std::size_t f = 0; f < hull.face_count(); ++f) (void)triangulate_face(points, hull.face(f), mesh.triangles);
  return mesh;
}

inline ExactMesh exact_hull_of(const std::vector<Point3>& points) {
  const TriangleMesh hull = hull_of(points);
  return {{hull.vertices.begin(), hull.vertices.end()}, hull.triangles, std::vector<SourceFace>(hull.triangles.size())};
}

/// Of a strip, which have no vertex in common.
inline std::vector<Bvh::Corners> each_third(const std::vector<Bvh::Corners>& triangles) {
  std::vector<Bvh::Corners> some;
  for (std::size_t i = 0; i < triangles.size(); i += 3) some.push_back(triangles[i]);
  return some;
}

/// The points in lexicographic order, and back along a line below them all: a polygon that does not cross itself.
inline Polygon2 star_of(std::vector<Point2> points) {
  std::sort(points.begin(), points.end(),
            [](const Point2& l, const Point2& r) { return l.x < r.x || (l.x == r.x && l.y < r.y); });
  double low = points[0].y;
  for (const Point2& p : points) low = std::min(low, p.y);
  points.push_back({points.back().x, 2 * low - 1});
  points.push_back({points.front().x, 2 * low - 1});
  return {points};
}

/// Rooms one behind the other along x, with doors as large as their walls.
inline PortalCells rooms_along_x(const Cloud& c) {
  std::vector<double> walls;
  for (const Point3& p : c.a) walls.push_back(p.x);
  std::ranges::sort(walls);
  walls.erase(std::unique(walls.begin(), walls.end()), walls.end());
  std::vector<ConvexPolyhedron3> cells;
  std::vector<Portal> portals;
  for (std::uint32_t i = 0; i + 1 < walls.size(); ++i) {
    std::vector<Point3> corners;
    for (const double x : {walls[i], walls[i + 1]}) {
      for (const Point2 p : {Point2{0, 0}, Point2{1, 0}, Point2{1, 1}, Point2{0, 1}}) corners.push_back({x, p.x, p.y});
    }
    cells.push_back(convex_polyhedron(convex_hull(corners), corners));
    if (i > 0) portals.push_back({{i - 1, i}, {{corners[0], corners[1], corners[2], corners[3]}}});
  }
  return {std::move(cells), std::move(portals)};
}

/// Least of a node on each axis, as a bound that tells nothing of it.
inline constexpr auto least_x = [](const BoxNode& node) { return node.min[0]; };
inline constexpr auto pass_over = [](const auto&...) {};
inline constexpr auto all_meet = [](const auto&, const auto&) { return true; };

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
       for (const Point3& p : asked_points(c)) (void)first_hit(bvh, Ray3{c.b[0], vector(p)});
     }},
    {"first_hit of a posed mesh", "space/ray/mesh_ray.hpp", linear, 200,
     [](const Cloud& c) {
       const Bvh bvh = build_bvh(c.mesh);
       for (const Point3& p : asked_points(c)) (void)first_hit(PosedMesh{bvh, pose(c.b)}, Ray3{c.b[0], vector(p)});
     }},
    {"winding_number of a mesh", "space/ray/inside.hpp", linear, 20,
     [](const Cloud& c) {
       const Bvh bvh = build_bvh(c.mesh);
       for (const Point3& p : asked_points(c)) (void)winding_number(bvh, p);
     }},
    {"generalized_winding_number of a mesh", "space/ray/open_winding.hpp", sorting, 600,
     [](const Cloud& c) {
       const Bvh bvh = build_bvh(c.mesh);
       const std::vector<BorderEdge> border = border_of(bvh);
       for (const Point3& p : asked_points(c)) (void)generalized_winding_number(bvh, border, p);
     }},
    {"meeting", "space/range/range_search.hpp", linear, 100,
     [](const Cloud& c) { (void)meeting(build_bvh(c.mesh), capsule(c.b)); }, 72, 1},
    {"meeting, posed", "space/range/range_search.hpp", linear, 100,
     [](const Cloud& c) {
       const Bvh bvh = build_bvh(c.mesh);
       (void)meeting(PosedMesh{bvh, pose(c.b)}, capsule(c.b));
     },
     72, 1},
    {"closest_on_mesh", "space/closest/closest_on_mesh.hpp", sorting, 100,
     [](const Cloud& c) {
       const Bvh bvh = build_bvh(c.mesh);
       for (const Point3& p : asked_points(c)) (void)closest_on_mesh(bvh, p);
     },
     72, 1},
    {"closest_on_mesh, posed", "space/closest/closest_on_mesh.hpp", sorting, 300,
     [](const Cloud& c) {
       const Bvh bvh = build_bvh(c.mesh);
       for (const Point3& p : asked_points(c)) (void)closest_on_mesh(PosedMesh{bvh, pose(c.b)}, p);
     },
     72, 1},
    {"closest_triangles", "space/closest/closest_triangles.hpp", quadratic_log, 125,
     [](const Cloud& c) {
       const Bvh a = build_bvh(c.mesh), b = build_bvh(c.other);
       const double d = distance(a, b);
       (void)within(a, b, d / 2), (void)closest_triangles(a, b, {.first = true, .within = d});
     },
     72, 1},
    {"hausdorff_distance", "space/closest/hausdorff.hpp", quadratic_log, 200,
     [](const Cloud& c) {
       (void)hausdorff_distance(build_bvh(c.mesh), build_bvh(c.other), {.execution = Execution::serial});
     },
     72, 1},
    {"intersecting_pairs", "space/pairs/mesh_pairs.hpp", quadratic, 100,
     [](const Cloud& c) { (void)intersecting_pairs(build_bvh(c.mesh), build_bvh(c.other)); }},
    {"intersecting_pairs, posed", "space/pairs/mesh_pairs.hpp", quadratic, 500,
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
    {"first_contact, translating mesh", "space/moving/translating_mesh.hpp", quadratic_log, 500,
     [](const Cloud& c) { (void)first_contact(build_bvh(c.mesh), vector(c.a[0]), build_bvh(c.other)); }, 36, 1, 12},
    {"contacts_in_motion", "space/moving/motion_contacts.hpp", quadratic, 1000,
     [](const Cloud& c) { (void)contacts_in_motion(build_moving_mesh(c.a, c.b, each_third(c.mesh.triangles))); }, 36, 1,
     12},
    {"first_contact, posed mesh", "space/moving/translating_mesh.hpp", quadratic_log, 500,
     [](const Cloud& c) {
       const Bvh a = build_bvh(c.mesh), b = build_bvh(c.other);
       (void)first_contact(PosedMesh{a, pose(c.b)}, vector(c.a[0]), PosedMesh{b, identity_pose});
     },
     18, 1, 12},
    {"contacts_in_motion, posed", "space/moving/motion_contacts.hpp", quadratic, 1000,
     [](const Cloud& c) {
       const MovingMesh mesh = build_moving_mesh(c.a, c.b, each_third(c.mesh.triangles));
       (void)contacts_in_motion(MovingMeshView{mesh, identity_pose, pose(c.b)});
     },
     9, 1, 12},
    {"build_moving_mesh", "space/moving/moving_mesh.hpp", quadratic, 5,
     [](const Cloud& c) { (void)build_moving_mesh(c.a, c.b, c.mesh.triangles); }},
    {"hausdorff_distance, posed", "space/closest/hausdorff.hpp", quadratic_log, 500,
     [](const Cloud& c) {
       const Bvh a = build_bvh(c.mesh), b = build_bvh(c.other);
       (void)hausdorff_distance(PosedMesh{a, pose(c.b)}, PosedMesh{b, identity_pose}, {.execution = Execution::serial});
     },
     18, 1},
    {"grouped_meeting", "space/coherence/grouped_range.hpp", linear, 20,
     [](const Cloud& c) { (void)grouped_meeting(build_bvh(c.mesh), std::span(c.boxes).first(9)); }},
    {"KeptRange", "space/coherence/kept_range.hpp", linear, 20,
     [](const Cloud& c) {
       const Bvh bvh = build_bvh(c.mesh);
       KeptRange kept(bvh);
       for (int i = 0; i < 3; ++i) (void)kept.meeting(c.boxes[0]);
     }},
    {"LastPair", "space/coherence/last_answer.hpp", quadratic_log, 100,
     [](const Cloud& c) {
       const Bvh a = build_bvh(c.mesh), b = build_bvh(c.other);
       LastPair last;
       for (int i = 0; i < 2; ++i) (void)any_intersecting_pair(a, b, last);
     }},
    // trees by themselves
    {"descend", "space/bvh/descend.hpp", sorting, 1,
     [](const Cloud& c) {
       const BoxTree tree = build_box_tree(c.boxes);
       float limit = HUGE_VALF;
       (void)descend_nearest_first(tree, limit, least_x, pass_over);
     }},
    {"descend, compact", "space/bvh/descend_compact.hpp", sorting, 5,
     [](const Cloud& c) {
       const CompactBvh compacted = compact(build_bvh(c.mesh));
       float limit = HUGE_VALF;
       (void)descend_nearer_first(compacted.tree, limit, least_x, pass_over);
     }},
    {"descend_pairs", "space/bvh/descend_pairs.hpp", quadratic, 1,
     [](const Cloud& c) {
       const BoxTree tree = build_box_tree(c.boxes);
       (void)descend_pairs(tree, tree, descend_larger{}, all_meet, pass_over);
     }},
    {"descend_pairs, compact", "space/bvh/descend_compact_pairs.hpp", quadratic, 5,
     [](const Cloud& c) {
       const CompactBvh compacted = compact(build_bvh(c.mesh));
       (void)descend_pairs(compacted.tree, compacted.tree, descend_larger{}, all_meet, pass_over);
     }},
    {"build_volume_tree", "space/bvh/volume_tree.hpp", linear, 50,
     [](const Cloud& c) { (void)build_volume_tree<Sphere3>(build_bvh(c.mesh)); }},
    {"intersecting_pairs by volumes", "space/pairs/volume_pairs.hpp", quadratic, 100,
     [](const Cloud& c) {
       const Bvh a = build_bvh(c.mesh), b = build_bvh(c.other);
       const auto balls_a = build_volume_tree<Sphere3>(a), balls_b = build_volume_tree<Sphere3>(b);
       (void)intersecting_pairs(VolumeMesh{a, balls_a}, VolumeMesh{b, balls_b});
     }},
    {"meeting by volumes", "space/range/volume_range.hpp", linear, 50,
     [](const Cloud& c) {
       const Bvh bvh = build_bvh(c.mesh);
       (void)meeting(bvh, build_volume_tree<Sphere3>(bvh), Segment3{c.b[0], c.b[1]});
     }},
    {"first_hit by volumes", "space/ray/volume_ray.hpp", linear, 50,
     [](const Cloud& c) {
       const Bvh bvh = build_bvh(c.mesh);
       const auto volumes = build_volume_tree<Sphere3>(bvh);
       (void)first_hit(VolumeMesh{bvh, volumes}, Ray3{c.b[0], vector(c.b[1])});
     }},
    {"distance_bounds", "space/pairs/sphere_levels.hpp", quadratic_log, 200,
     [](const Cloud& c) {
       const SphereTreeOptions options{.levels = 3};
       (void)distance_bounds(build_sphere_tree(c.mesh, options), build_sphere_tree(c.other, options));
     },
     36, 1},
    // cells
    {"PortalCells", "space/cells/portal_cells.hpp", linear, 50, [](const Cloud& c) { (void)rooms_along_x(c); }, 36, 1},
    {"passage", "space/cells/passage.hpp", quadratic, 100,
     [](const Cloud& c) {
       const PortalCells rooms = rooms_along_x(c);
       const auto end = [&](std::size_t k) { return Point3{rooms.cells()[k].mesh.vertices[0].x, 0.5, 0.25}; };
       (void)passage(rooms, 0, {end(0), end(rooms.cells().size() - 1)});
     },
     36, 1},
    {"seen_from", "space/cells/visibility.hpp", quadratic, 200,
     [](const Cloud& c) {
       const PortalCells rooms = rooms_along_x(c);
       (void)seen_from(rooms, 0, {rooms.cells()[0].mesh.vertices[0].x, 0.5, 0.25});
     },
     36, 1},
    // bsp
    {"build_bsp", "space/bsp/build_bsp.hpp", quartic, 200, [](const Cloud& c) { (void)build_bsp(hull_of(c.a)); }, 36,
     1},
    {"build_bsp of a strip", "space/bsp/build_bsp.hpp", quartic, 10,
     [](const Cloud& c) { (void)build_bsp(c.mesh, {.kind = BspKind::node_storing}); }, 36, 1},
    {"locate in a BspTree", "space/bsp/bsp_point.hpp", quadratic, 200,
     [](const Cloud& c) {
       const BspTree tree = build_bsp(hull_of(c.a));
       for (const Point3& p : c.b) (void)locate(tree, p);
     },
     36, 1},
    {"first_hit of a BspTree", "space/bsp/bsp_ray.hpp", quadratic, 500,
     [](const Cloud& c) {
       const BspTree tree = build_bsp(hull_of(c.a));
       for (std::size_t i = 0; i < c.b.size(); ++i) (void)first_hit(tree, Segment3{c.b[i], c.a[i]});
     },
     36, 1},
    {"first_touch of a BspTree", "space/bsp/bsp_motion.hpp", quadratic, 2500,
     [](const Cloud& c) {
       const BspTree tree = build_bsp(hull_of(c.a));
       for (std::size_t i = 0; i < c.b.size(); ++i) {
         const Point3 &p = c.b[i], &q = c.a[i];
         (void)first_touch(tree, Translating{Sphere3{p, 0.125}, Vector3{q.x - p.x, q.y - p.y, q.z - p.z}});
       }
     },
     36, 1},
    // boxes
    {"overlapping_pairs", "space/broad_phase/overlapping_pairs.hpp", quadratic, 20,
     [](const Cloud& c) {
       for (const BroadPhaseMethod method : broad_phase_methods) (void)told_pairs(c, method);
     }},
    {"sort_and_sweep_pairs", "space/sort_and_sweep/sort_and_sweep.hpp", quadratic, 1,
     [](const Cloud& c) { (void)sort_and_sweep_pairs(c.boxes, {.execution = Execution::serial}); }},
    {"SweepArray", "space/sort_and_sweep/sweep_array.hpp", quadratic, 1,
     [](const Cloud& c) { (void)SweepArray().overlapping_pairs(c.boxes); }},
    {"SweepLists", "space/textbook/box_store.hpp", quadratic, 5,
     [](const Cloud& c) { come_and_move(SweepLists(), c); }},
    {"HierarchicalGrid", "space/textbook/box_store.hpp", quadratic, 5,
     [](const Cloud& c) { come_and_move(HierarchicalGrid3(), c); }},
    {"RowColumnGrid", "space/textbook/box_store.hpp", quadratic, 20,
     [](const Cloud& c) { come_and_move(RowColumnGrid3({.rows = 64}), c); }},
    {"ImplicitGrid", "space/textbook/box_store.hpp", quadratic, 20,
     [](const Cloud& c) { come_and_move(ImplicitGrid3({.cell_size = 0.5, .rows = 64}), c); }},
    {"HashedGrid", "space/textbook/box_store.hpp", quadratic, 20,
     [](const Cloud& c) { come_and_move(HashedGrid3({.cell_size = 0.5}), c); }},
    {"StaticGrid", "space/grid/static_grid.hpp", quadratic, 20,
     [](const Cloud& c) { (void)StaticGrid3(c.boxes).overlapping_pairs(); }},
    {"LooseOctree", "space/textbook/box_store.hpp", quadratic, 5,
     [](const Cloud& c) { come_and_move(LooseOctree({.world = fit_aabb(c.a)}), c); }},
    {"build_octree, boxes", "space/octree/box_octree.hpp", quadratic, 5,
     [](const Cloud& c) { (void)overlapping_pairs(build_octree(c.boxes)); }},
    {"build_octree, points", "space/octree/point_octree.hpp", linear, 5,
     [](const Cloud& c) { (void)in_box(build_octree(c.a), c.boxes[0]); }},
    {"hybrid index", "space/textbook/hybrid_index.hpp", quadratic, 50,
     [](const Cloud& c) {
       const auto world = build_grid_of_trees(c.boxes, {.in_part = 4, .most_in_list = 2});
       (void)overlapping_pairs(world);
     }},
    {"brute_force_pairs", "space/pairs/brute_force_pairs.hpp", quadratic, 1,
     [](const Cloud& c) { (void)brute_force_pairs(c.boxes); }},
    {"choose_index", "space/broad_phase/choose_index.hpp", sorting, 50,
     [](const Cloud& c) { (void)choose_index(c.boxes); }},
    {"MovingBoxes", "space/broad_phase/moving_boxes.hpp", quadratic, 5,
     [](const Cloud& c) {
       MovingBoxes world;
       const std::vector<BoxHandle> handles = world.insert(c.boxes);
       (void)world.changes();
       for (std::size_t i = 0; i < handles.size(); ++i) world.move(handles[i], c.boxes[(i + 1) % handles.size()]);
       (void)world.changes(), (void)world.overlapping_pairs();
     }},
    {"GridWalk", "space/grid/grid_walk.hpp", fixed, 5,
     [](const Cloud& c) {
       const CellGrid3 grid{c.a[0], {std::fabs(c.a[1].x), std::fabs(c.a[1].y), std::fabs(c.a[1].z)}};
       GridWalk<3> walk(grid, Ray3{c.b[0], vector(c.b[1])},
                        {.cells = WalkedCells::half_open, .range = {{-4, -4, -4}, {4, 4, 4}}});
       while (walk.next()) {
       }
     }},
    {"cells_along in an octree", "space/octree/cell_walk.hpp", sorting, 5,
     [](const Cloud& c) {
       const auto tree = build_octree(c.a);
       for (const Point3& p : asked_points(c))
         (void)cells_along(tree.cells, Ray3{c.b[0], vector(p)}, WalkedCells::closed);
     }},
    // points and figures
    {"cells_along in a kd-tree", "space/kd_tree/cells_along.hpp", linear, 5,
     [](const Cloud& c) {
       const KdTree3 tree = build_kd_tree(c.a);
       for (const Point3& p : asked_points(c)) (void)cells_along(tree, Ray3{c.b[0], vector(p)});
     }},
    {"first_hit of items", "space/ray/shape_ray.hpp", sorting, 20,
     [](const Cloud& c) {
       const BoxTree tree = build_box_tree(c.boxes);
       for (const Point3& p : asked_points(c)) {
         const Ray3 ray{c.b[0], vector(p)};
         (void)first_hit(tree, ray, [&](std::uint32_t i) { return first_hit_parameter(ray, c.boxes[i]); });
       }
     }},
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
    {"nearest in a figure tree", "space/kd_tree/nearest_figure.hpp", sorting, 100,
     [](const Cloud& c) {
       const auto tree = build_figure_tree(c.triangles);
       for (const Point3& p : asked_points(c)) (void)nearest(tree, p);
     },
     72, 1},
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
    {"find_edges", "surface/topology/topology.hpp", sorting, 1, [](const Cloud& c) { (void)mesh_statistics(c.mesh); }},
    {"read_mesh", "surface/file/read_mesh.hpp", sorting, 20,
     [](const Cloud& c) {
       const std::string text = format_mesh(to_polygons(c.mesh), MeshFormat::stl);
       (void)parse_mesh(text, MeshFormat::stl, "mesh");
     }},
    {"read_assembly", "surface/file/read_assembly.hpp", sorting, 20,
     [](const Cloud& c) {
       const std::string text = format_mesh(to_polygons(c.mesh), MeshFormat::obj);
       (void)parse_assembly(text, "parts.obj");
     }},
    {"format_mesh", "surface/file/write_mesh.hpp", linear, 20,
     [](const Cloud& c) { (void)format_mesh(to_polygons(c.mesh), MeshFormat::obj); }},
    {"triangulate", "surface/planar/triangulate.hpp", quadratic, 20,
     [](const Cloud& c) {
       PolygonMesh mesh{c.a, {}, {0, static_cast<std::uint32_t>(c.a.size())}};
       for (std::uint32_t i = 0; i < c.a.size(); ++i) mesh.corners.push_back(i);
       (void)triangulate(mesh);
     }},
    {"delaunay", "surface/planar/delaunay.hpp", quadratic, 20,
     [](const Cloud& c) {
       const std::vector<PlanarSegment> edge{{0, 1}};
       (void)delaunay(c.flat, edge);
     }},
    {"triangulate a polygon", "surface/planar/triangulate_polygon.hpp", quadratic, 20,
     [](const Cloud& c) { (void)triangulate(star_of(c.flat)); }},
    {"convex_pieces", "surface/planar/convex_pieces.hpp", quadratic, 20,
     [](const Cloud& c) { (void)convex_pieces(star_of(c.flat)); }},
    {"fewest_convex_pieces", "surface/planar/convex_pieces.hpp", cubic, 40,
     [](const Cloud& c) { (void)fewest_convex_pieces(star_of(c.flat)); }},
    {"arrange_segments", "surface/planar/arrange_segments.hpp", quartic, 200,
     [](const Cloud& c) {
       std::vector<Segment2> segments;
       for (std::size_t i = 0; i + 1 < c.flat.size(); i += 2) segments.push_back({c.flat[i], c.flat[i + 1]});
       (void)arrange_segments(segments);
     }},
    {"section", "surface/section/section.hpp", quadratic, 50,
     [](const Cloud& c) {
       (void)section(c.mesh, Plane3{vector(c.b[0]), 0});
     }},
    {"find_shells", "surface/topology/shells.hpp", quadratic, 500, [](const Cloud& c) { (void)find_shells(c.mesh); }},
    {"find_faults", "surface/topology/faults.hpp", quadratic, 500, [](const Cloud& c) { (void)find_faults(c.mesh); }},
    {"surface_kinds", "surface/topology/components.hpp", sorting, 2,
     [](const Cloud& c) { (void)surface_kinds(c.mesh, find_edges(c.mesh)); }},
    {"find_weld", "surface/repair/weld.hpp", quadratic_log, 20,
     [](const Cloud& c) { (void)find_weld(c.mesh, {.tolerance = std::fabs(c.a[0].x)}); }},
    {"first_equal", "figure/basic/equal_points.hpp", sorting, 1, [](const Cloud& c) { (void)first_equal(c.a); }},
    {"least_width", "figure/measures/width.hpp", cubic, 500, [](const Cloud& c) { (void)least_width(c.a); }},
    {"bent_faces", "surface/planar/planarity.hpp", cubic, 500,
     [](const Cloud& c) {
       PolygonMesh mesh{c.a, {}, {0, static_cast<std::uint32_t>(c.a.size())}};
       for (std::uint32_t i = 0; i < c.a.size(); ++i) mesh.corners.push_back(i);
       (void)bent_faces(mesh);
     }},
    {"merge_coplanar", "surface/repair/merge_coplanar.hpp", quadratic, 50,
     [](const Cloud& c) { (void)merge_coplanar(c.mesh); }},
    {"convex_parts", "surface/parts/convex_parts.hpp", quadratic, 2000,
     [](const Cloud& c) { (void)convex_parts(hull_of(c.a)); }},
    {"covering_parts", "surface/parts/covering_parts.hpp", quadratic, 5000,
     [](const Cloud& c) { (void)covering_parts(hull_of(c.a), {.concavity = 0}); }},
    {"arrange", "surface/solid/arrangement.hpp", quartic, 750,
     [](const Cloud& c) {
       (void)arrange(std::vector{hull_of(c.a), hull_of(c.b)});
     },
     72, 1},
    {"find_clash", "world/clash.hpp", quartic, 2000,
     [](const Cloud& c) { (void)find_clash(ClashPart(hull_of(c.a)), ClashPart(hull_of(c.b))); }, 72, 1, 12},
    {"find_clashes", "world/clashes.hpp", quadratic, 100,
     [](const Cloud& c) {
       std::vector<TriangleMesh> parts;
       for (const Aabb3& box : c.boxes) {
         TriangleMesh mesh{{box.min, {box.max.x, box.min.y, box.min.z}, box.max}, {{0, 1, 2}}};
         parts.push_back(std::move(mesh));
       }
       (void)find_clashes(parts);
     }},
    {"unite", "surface/solid/boolean.hpp", quartic, 750,
     [](const Cloud& c) { (void)unite(hull_of(c.a), hull_of(c.b)); }, 72, 1},
    {"intersection_curves", "surface/solid/intersection_curves.hpp", quartic, 750,
     [](const Cloud& c) { (void)intersection_curves(hull_of(c.a), hull_of(c.b)); }, 72, 1},
    {"evaluate", "surface/solid/evaluate.hpp", quartic, 750,
     [](const Cloud& c) { (void)evaluate(csg(hull_of(c.a)) - csg(hull_of(c.b))); }, 72, 1},
    {"merge_pieces", "surface/solid/merge_pieces.hpp", quadratic, 200,
     [](const Cloud& c) { (void)merge_pieces(exact_hull_of(c.a)); }},
    {"split", "surface/solid/split.hpp", quadratic, 200,
     [](const Cloud& c) {
       (void)split(exact_hull_of(c.a), Plane3{{1, 1, 1}, c.a[0].x});
     }},
    {"round", "surface/solid/round.hpp", quartic, 100, [](const Cloud& c) { (void)round(resolve(hull_of(c.a))); }},
    {"repair", "surface/repair/repair.hpp", quartic, 500, [](const Cloud& c) { (void)repair(c.mesh); }, 72, 1, 12},
    {"close_vertices", "surface/topology/defects.hpp", quadratic, 5,
     [](const Cloud& c) { (void)close_vertices(c.mesh, std::fabs(c.a[0].x)); }},
    {"vertices_on_edges", "surface/topology/defects.hpp", quadratic, 50,
     [](const Cloud& c) { (void)vertices_on_edges(find_edges(c.mesh), build_bvh(c.mesh)); }},
    {"vertices_near_edges", "surface/topology/defects.hpp", quadratic, 20,
     [](const Cloud& c) {
       (void)vertices_near_edges(find_edges(c.mesh), build_bvh(c.mesh), std::fabs(c.a[0].x), Execution::serial);
     }},
};

}  // namespace plumb::cost
