// The face of figures: what shapes are there, what is known of one, and what bounds many?
//
// Figures are plain structs of doubles and stand for exactly the sets that their numbers say; degenerate ones are figures
// (docs/figures.md).  Questions about two of them are in plumb/query.hpp.
// Apart: Eigen's vectors (figure/basic/eigen.hpp).
// Source: docs/sections.md, chapters 2 to 4.
#pragma once

#include "plumb/predicates/standard.hpp"

// What do answers say, and what is computed beside them?
#include "plumb/certify/accepted.hpp"             // first, so that what a compiler says of a misuse is short
#include "plumb/certify/answered.hpp"             // what is said where there is no answer, of signs
#include "plumb/figure/basic/answered.hpp"        // of figures
#include "plumb/figure/basic/equal_points.hpp"    // which points are one and the same
#include "plumb/figure/basic/pose_view.hpp"       // any pose as one argument
#include "plumb/figure/basic/relation.hpp"        // Location, Relation
#include "plumb/figure/basic/rigid_poses.hpp"     // rigid poses one after the other, their inverses, their matrices
#include "plumb/figure/basic/rotation.hpp"        // turns that are exact: by an angle, nearest to a matrix
#include "plumb/figure/basic/rounded_points.hpp"  // differences of points and the like, rounded once
#include "plumb/figure/basic/rounded_poses.hpp"   // poses one after the other, their inverses, likewise
#include "plumb/figure/basic/small_system.hpp"    // two to four linear equations
#include "plumb/figure/basic/sound.hpp"           // is this a figure at all?  And which part is none

// Which shapes are there?
#include "plumb/figure/basic/body.hpp"               // what each of them is made of, said once
#include "plumb/figure/basic/box.hpp"                // Aabb2, Aabb3, Obb2, Obb3, Rectangle3
#include "plumb/figure/basic/convex_polyhedron.hpp"  // ConvexPolyhedron3: faces, and who is beyond which edge
#include "plumb/figure/basic/linear.hpp"             // lines, rays, segments
#include "plumb/figure/basic/mesh.hpp"               // TriangleMesh, PolygonMesh
#include "plumb/figure/basic/plane.hpp"              // planes, halfspaces, slabs and what these have in common
#include "plumb/figure/basic/polygon.hpp"            // polygons, with holes or without
#include "plumb/figure/basic/round.hpp"              // balls, capsules, lozenges, cylinders, cones, ellipsoids
#include "plumb/figure/basic/simplex.hpp"            // triangles, tetrahedra
#include "plumb/figure/generated/generated.hpp"      // hard ones, from the rows of numbers of degenerate/

// Where does a point lie?
#include "plumb/figure/basic/barycentric.hpp"              // its weights at the corners
#include "plumb/figure/basic/polyhedron.hpp"               // to a convex polyhedron, and whether a mesh is one
#include "plumb/figure/containment/contains.hpp"           // locate, contains: to any shape
#include "plumb/figure/containment/csg.hpp"                // to unions, intersections and differences
#include "plumb/figure/containment/implicit_function.hpp"  // to f <= 0
#include "plumb/figure/containment/polygon_location.hpp"   // to polygons, with winding numbers
#include "plumb/figure/containment/voronoi_region.hpp"     // nearest to which vertex, edge or face

// What is known of one shape?
#include "plumb/figure/basic/convexity.hpp"      // is it convex?
#include "plumb/figure/hull/hull2.hpp"           // the convex hull of points in the plane
#include "plumb/figure/hull/hull3.hpp"           // and in space
#include "plumb/figure/hull/verify_hull.hpp"     // is this the hull?
#include "plumb/figure/measures/measures.hpp"    // area, volume, surface, centroid
#include "plumb/figure/measures/width.hpp"       // the nearest parallel planes that hold all points
#include "plumb/figure/minkowski/minkowski.hpp"  // Minkowski sums and differences
#include "plumb/figure/support/support.hpp"      // farthest along a direction

// Which bounding volume?
#include "plumb/figure/aabb/aabb.hpp"                  // boxes along the axes: fitted, merged, moved
#include "plumb/figure/aabb/box_batch.hpp"             // many pairs of boxes or balls at once
#include "plumb/figure/aabb/box_forms.hpp"             // by least and greatest, by widths, by center
#include "plumb/figure/aabb/climbing_aabb.hpp"         // of a convex polyhedron that turns
#include "plumb/figure/aabb/posed_aabb.hpp"            // of a shape under any pose
#include "plumb/figure/aabb/relation.hpp"              // do two meet?
#include "plumb/figure/bound/choose_bound.hpp"         // the cheapest that culls enough
#include "plumb/figure/bound/proxy.hpp"                // what collides in place of what is seen
#include "plumb/figure/k_dop/k_dop.hpp"                // discrete orientation polytopes
#include "plumb/figure/obb/fits.hpp"                   // oriented boxes that fit well
#include "plumb/figure/obb/minimum_obb.hpp"            // and best
#include "plumb/figure/obb/obb.hpp"                    // do two meet?
#include "plumb/figure/sphere/fits.hpp"                // spheres that fit well
#include "plumb/figure/sphere/minimum_sphere.hpp"      // and best
#include "plumb/figure/sphere/spanned_sphere.hpp"      // through one to four points, exactly
#include "plumb/figure/sphere/sphere.hpp"              // do two meet?  which one holds both?
#include "plumb/figure/swept_sphere/swept_sphere.hpp"  // capsules and lozenges
