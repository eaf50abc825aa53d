// The face of indexes over many figures: which of them can matter to a question?
//
// What is left out is left out by comparisons of boxes or other volumes that contain what they stand for, exactly; so a
// question asked of a tree has the answer of the same question asked of each figure.  `rows` that are given back lend
// their memory.
// Source: RTCD 6.
#pragma once

#include "plumb/predicates/standard.hpp"

// What is said where there is no answer?
#include "plumb/space/bvh/answered.hpp"  // first, so that it is short

// What is a tree of boxes?
#include "plumb/space/bvh/box_frame.hpp"       // floats that hold doubles of any size
#include "plumb/space/bvh/box_tree.hpp"        // nodes in depth-first order
#include "plumb/space/bvh/kept_array.hpp"      // in memory of its own or in a mapped file
#include "plumb/space/bvh/packed_numbers.hpp"  // in as few bytes as they need

// Which tree?  build_box_tree, build_bvh
#include "plumb/space/bvh/build.hpp"           // of boxes; builders and their options
#include "plumb/space/bvh/bvh.hpp"             // of a mesh
#include "plumb/space/bvh/compact_file.hpp"    // that in a file
#include "plumb/space/bvh/compact_tree.hpp"    // of a mesh, in half of the memory
#include "plumb/space/bvh/insertion_tree.hpp"  // of what comes and goes
#include "plumb/space/bvh/mesh_view.hpp"       // of a mesh, kept and standing in any way
#include "plumb/space/bvh/posed_mesh.hpp"      // of a mesh that has been moved
#include "plumb/space/bvh/refit.hpp"           // for what moves
#include "plumb/space/bvh/sphere_tree.hpp"     // of spheres, ever finer, that cover a surface
#include "plumb/space/bvh/tree_cost.hpp"       // what it costs to ask
#include "plumb/space/bvh/tree_file.hpp"       // in a file
#include "plumb/space/bvh/volume_mesh.hpp"     // with the mesh that they stand for
#include "plumb/space/bvh/volume_rules.hpp"    // what a volume must answer for that
#include "plumb/space/bvh/volume_tree.hpp"     // of spheres, oriented boxes, k-DOPs, or your own volumes
#include "plumb/space/bvh/walked_cells.hpp"    // of cells along a ray: those it touches, or is in
#include "plumb/space/bvh/wide_tree.hpp"       // with eight children a node

// How is it asked?  descend and its kin
#include "plumb/space/bvh/descend.hpp"                // one tree
#include "plumb/space/bvh/descend_compact.hpp"        // one that is compact
#include "plumb/space/bvh/descend_compact_pairs.hpp"  // two of which one is compact
#include "plumb/space/bvh/descend_pairs.hpp"          // two, or one with itself
#include "plumb/space/bvh/progress.hpp"               // how far it is, and whether to go on

// How near is a mesh, and where?  closest_on_mesh, nearest_triangles, triangles_within, closest_triangles; how far does
// it reach from another?  hausdorff_distance
#include "plumb/space/closest/closest_on_mesh.hpp"    // a point
#include "plumb/space/closest/closest_triangles.hpp"  // another mesh
#include "plumb/space/closest/hausdorff.hpp"          // how far two surfaces deviate

// When does what moves meet first?  first_contact; what meets at all?  contacts_in_motion
#include "plumb/space/moving/motion_contacts.hpp"   // a mesh whose vertices move, itself
#include "plumb/space/moving/moving_mesh.hpp"       // such a mesh
#include "plumb/space/moving/translating_mesh.hpp"  // a mesh along a line, another

// Which boxes overlap?  overlapping_pairs, choose_index
#include "plumb/space/broad_phase/choose_index.hpp"       // which method for these?
#include "plumb/space/broad_phase/moving_boxes.hpp"       // while they come, go and move
#include "plumb/space/broad_phase/overlapping_pairs.hpp"  // by the fastest method, or by any
#include "plumb/space/pairs/box_pair.hpp"                 // what is told of each pair, by any method
#include "plumb/space/pairs/brute_force_pairs.hpp"        // by asking each pair
#include "plumb/space/pairs/float_boxes.hpp"              // of float32
#include "plumb/space/pairs/pair_sink.hpp"                // where pairs go
#include "plumb/space/sort_and_sweep/index_verbs.hpp"     // the same words for all of them
#include "plumb/space/sort_and_sweep/sort_and_sweep.hpp"  // along one axis, from scratch
#include "plumb/space/sort_and_sweep/sweep_array.hpp"     // with an order that is kept
#include "plumb/space/textbook/box_store.hpp"             // by grids, loose octrees and sorted lists
#include "plumb/space/textbook/hybrid_index.hpp"          // by grids of trees, trees of grids

// Which cells of a cube are things in, and a ray?  build_octree, build_quadtree, locate, cells_along
#include "plumb/space/octree/box_octree.hpp"    // boxes: in the smallest cell that holds them, or in all leaves
#include "plumb/space/octree/cell_frame.hpp"    // borders that are doubles
#include "plumb/space/octree/cell_tree.hpp"     // cells and their codes
#include "plumb/space/octree/cell_walk.hpp"     // what a ray goes through
#include "plumb/space/octree/point_octree.hpp"  // points

// Which rooms are there, what is seen through their doors?  PortalCells, seen_from, potentially_visible, passage
#include "plumb/space/cells/passage.hpp"       // what moves through them
#include "plumb/space/cells/portal_cells.hpp"  // convex cells, and portals in their faces
#include "plumb/space/cells/visibility.hpp"    // what is seen from a place, or from anywhere in a cell

// What do planes make of space, and of polygons?  build_bsp; what is in the solid, and where does a ray, or what
// moves, meet it?  locate, first_hit, first_touch
#include "plumb/space/bsp/bsp_motion.hpp"  // what moves and the face that it first touches
#include "plumb/space/bsp/bsp_order.hpp"   // from front to back
#include "plumb/space/bsp/bsp_point.hpp"   // a point, in which leaves
#include "plumb/space/bsp/bsp_ray.hpp"     // a ray and the face that it meets first
#include "plumb/space/bsp/bsp_tree.hpp"    // nodes, leaves and pieces of polygons
#include "plumb/space/bsp/build_bsp.hpp"   // of polygons or a closed mesh

// Which triangles meet?  intersecting_pairs, intersecting_pairs
#include "plumb/space/pairs/mesh_pairs.hpp"     // of two meshes, or one with itself
#include "plumb/space/pairs/neighbors.hpp"      // two triangles of one mesh, beyond what they share
#include "plumb/space/pairs/sphere_levels.hpp"  // do they at all, and how far are they?  As well as spheres can say
#include "plumb/space/pairs/volume_pairs.hpp"   // by spheres, oriented boxes or k-DOPs

// What of a mesh is in a box, a ball, a frustum?  meeting
#include "plumb/space/range/range_search.hpp"  // by a tree
#include "plumb/space/range/volume_range.hpp"  // by a tree of other volumes, and in any figure

// Which points are nearest, which in a ball or a box?  build_kd_tree, nearest, within, in_box; which boxes, segments or
// triangles?  build_figure_tree; which meet, and which does a ray hit first?  build_split_tree
#include "plumb/space/kd_tree/cells_along.hpp"     // the cells that a ray visits
#include "plumb/space/kd_tree/figure_range.hpp"    // figures, in ascending order
#include "plumb/space/kd_tree/figure_tree.hpp"     // a box tree of figures
#include "plumb/space/kd_tree/kd_tree.hpp"         // a compact k-d tree of points
#include "plumb/space/kd_tree/nearest_figure.hpp"  // figures, exactly, with ties
#include "plumb/space/kd_tree/nearest_point.hpp"   // exactly, with ties
#include "plumb/space/kd_tree/point_range.hpp"     // in ascending order
#include "plumb/space/kd_tree/split_range.hpp"     // figures in a box, and pairs
#include "plumb/space/kd_tree/split_ray.hpp"       // the first figure that a ray hits
#include "plumb/space/kd_tree/split_tree.hpp"      // a k-d tree of figures

// What is kept from frame to frame?  PairFront, LastPair, LastTriangle; what is asked
// together?  grouped_meeting
#include "plumb/space/coherence/grouped_range.hpp"  // shapes that lie near each other
#include "plumb/space/coherence/kept_range.hpp"     // the triangles around what moves little
#include "plumb/space/coherence/last_answer.hpp"    // the triangles that answered last
#include "plumb/space/coherence/pair_front.hpp"     // where the descent of two trees ended
#include "plumb/space/coherence/visit_bits.hpp"     // what a query has seen, in bits
#include "plumb/space/coherence/visit_stamps.hpp"   // the same, in bytes

// Where does a ray hit?
#include "plumb/space/ray/inside.hpp"        // is a point in a closed mesh?  locate, winding_number
#include "plumb/space/ray/mesh_ray.hpp"      // a mesh: first_hit, any_hit, hits, count_hits
#include "plumb/space/ray/open_winding.hpp"  // how often does a mesh with holes wind around a point?
#include "plumb/space/ray/ray_slabs.hpp"     // the slab test, for descents of one's own
#include "plumb/space/ray/shape_ray.hpp"     // shapes of any kind
#include "plumb/space/ray/volume_ray.hpp"    // a mesh, by spheres, oriented boxes or k-DOPs

// In which cell of a grid is it?
#include "plumb/space/grid/cell_grid.hpp"  // a point
#include "plumb/space/grid/grid_walk.hpp"  // a ray or segment, cell by cell

// Which boxes overlap, by grids?
#include "plumb/space/grid/cell_size.hpp"    // how large their cells are to be
#include "plumb/space/grid/static_grid.hpp"  // boxes that stay
