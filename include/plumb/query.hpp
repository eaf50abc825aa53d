// The face of questions about two figures: whether, what in common, how near, what first, and when?
//
// Answers are exact; where a number is given it is the true one, rounded once, a time of contact down; where bounds are
// asked for (gjk_bounds, penetration_bounds, first_contact_span), they hold it.  Which pairs a question takes is a table of
// query/body/, and docs/overlap.md, closest.md, intersection.md, rays.md, motion.md and figures.md print it.
// Apart: kinds of questions, on which other people's functions are tried (query/kinds/kinds.hpp).
// Source: RTCD 2.3.
#pragma once

#include "plumb/predicates/standard.hpp"

// What do they all take?
#include "plumb/certify/accepted.hpp"       // first, so that what a compiler says of a misuse is short
#include "plumb/certify/answered.hpp"       // what is said where there is no answer, of signs
#include "plumb/query/body/answered.hpp"    // of two figures
#include "plumb/query/body/item_batch.hpp"  // TriangleBatch, PointBatch, SegmentBatch
#include "plumb/query/body/posed.hpp"       // a figure as it stands or under a pose
#include "plumb/query/body/restated.hpp"    // slabs and boxes as the figures of the tables that they are

// Of which kind, where that is known at run time alone?
#include "plumb/query/body/any_figure.hpp"            // AnyFigure: a shape of any kind as a value
#include "plumb/query/body/rounded_hull.hpp"          // a figure of your own: the hull of its places, and a radius
#include "plumb/query/variant/own_figure.hpp"         // every question takes one of these
#include "plumb/query/variant/question_line.hpp"      // one as a line of text, with its answer
#include "plumb/query/variant/question_recorder.hpp"  // those that were asked, kept
#include "plumb/query/variant/questions.hpp"          // every question takes one

// Which pairs?
#include "plumb/query/body/closest_pairs.hpp"       // of closest_points and distance
#include "plumb/query/body/contact_pairs.hpp"       // of first_contact
#include "plumb/query/body/contains_pairs.hpp"      // of contains
#include "plumb/query/body/further_pairs.hpp"       // what else takes contains, first_hit and first_contact
#include "plumb/query/body/hit_pairs.hpp"           // of first_hit and hits
#include "plumb/query/body/intersection_pairs.hpp"  // of intersection
#include "plumb/query/body/pairs.hpp"               // of relate and intersects, and the algorithm that answers each
#include "plumb/query/body/question_table.hpp"      // what these tables have in common

// Do they meet?  relate, intersects
#include "plumb/query/overlap/batch.hpp"      // one against many
#include "plumb/query/overlap/ellipsoid.hpp"  // of an ellipsoid
#include "plumb/query/overlap/lattice2.hpp"   // integers of a lattice, in a plan's arithmetic
#include "plumb/query/overlap/overlap.hpp"    // all pairs
#include "plumb/query/overlap/posed.hpp"      // figures under poses, which are not rounded
#include "plumb/query/overlap/restated.hpp"   // slabs, boxes by width or by center

// Does one hold the other?  contains, locate, side_of
#include "plumb/figure/basic/polyhedron.hpp"              // a point in a convex polyhedron
#include "plumb/figure/containment/contains.hpp"          // in any shape
#include "plumb/figure/containment/polygon_location.hpp"  // in a polygon
#include "plumb/query/convex/containment.hpp"             // bounds of every kind
#include "plumb/query/convex/posed_support.hpp"           // how far a figure under a pose reaches
#include "plumb/query/convex/separating_face.hpp"         // does a face part two convex polyhedra?
#include "plumb/query/convex/thick_plane.hpp"             // within so much of a plane, in front or behind

// What have they in common?  intersection
#include "plumb/certify/exact_point.hpp"                // a corner as it is
#include "plumb/query/section/intersection.hpp"         // in space
#include "plumb/query/section/intersection2.hpp"        // in the plane
#include "plumb/query/section/intersection_result.hpp"  // nothing, a point, a segment, a polygon
#include "plumb/query/section/planes.hpp"               // of two planes, or three
#include "plumb/query/section/posed.hpp"                // of figures under poses
#include "plumb/query/section/restated.hpp"             // of slabs, of boxes by width or by center
#include "plumb/query/section/solid.hpp"                // of two solids

// How is it proved?  relate_with_proof, distance_with_proof, verify
#include "plumb/query/certificate/certificate.hpp"  // separating directions, touching planes, simplices around the origin
#include "plumb/query/certificate/certificate_text.hpp"  // as JSON, for other programs
#include "plumb/query/certificate/verify.hpp"            // whether they prove what they claim

// How near, and where?  closest_points, distance, compare_distance
#include "plumb/arith/exact_distance.hpp"          // a distance as it is
#include "plumb/query/closest/batch.hpp"           // the nearest of many
#include "plumb/query/closest/closest.hpp"         // a point and any shape
#include "plumb/query/closest/pairs.hpp"           // lines, rays, segments, triangles
#include "plumb/query/closest/result.hpp"          // points, features, distance
#include "plumb/query/closest/which_pair.hpp"      // any of several pairs, or the first
#include "plumb/query/convex/location.hpp"         // a point and a convex polygon, in logarithmic time
#include "plumb/query/overlap/posed_distance.hpp"  // of figures under poses, the number
#include "plumb/query/separation/convex_body.hpp"  // what convexity is asked of: hulls of corners, and a radius
#include "plumb/query/separation/fat.hpp"          // all within a radius of a figure: do two of these meet?
#include "plumb/query/separation/posed.hpp"        // of figures under poses, with points and features
#include "plumb/query/separation/restated.hpp"     // of slabs, of boxes by width or by center
#include "plumb/query/separation/separation.hpp"   // any two figures

// The same of convex bodies by GJK: with a history, and with caches from frame to frame
#include "plumb/query/gjk/batch.hpp"            // many pairs, by threads
#include "plumb/query/gjk/figure_support.hpp"   // gjk_bounds of cylinders, cones, ellipsoids and caps
#include "plumb/query/gjk/gjk.hpp"              // gjk, gjk_intersects, gjk_distance
#include "plumb/query/gjk/support_mapping.hpp"  // of bodies known by their support mapping
#include "plumb/query/gjk/swept.hpp"            // of bodies that move straight

// What meets linear constraints, and what of it lies farthest, or nearest?  maximize, nearest_feasible, verify
#include "plumb/query/lp/elimination.hpp"       // solutions and projections, by Fourier and Motzkin
#include "plumb/query/lp/greatest_margin.hpp"   // the thickest slab between two sets of points
#include "plumb/query/lp/linear_program.hpp"    // in the plane and in space: Seidel's algorithm
#include "plumb/query/lp/linear_proof.hpp"      // what an answer rests on
#include "plumb/query/lp/nearest_feasible.hpp"  // the nearest point of an intersection of halfspaces
#include "plumb/query/lp/simplex.hpp"           // of any number of variables
#include "plumb/query/lp/verify.hpp"            // is a proof one?

// How deep are two in one another, and which way is out?  penetration, penetration_along, penetration_within
#include "plumb/query/penetration/along.hpp"               // by directions given, or within a cone
#include "plumb/query/penetration/penetration.hpp"         // by the least translation
#include "plumb/query/penetration/penetration_bounds.hpp"  // between bounds, by farthest points alone

// Where do they touch, as physics engines take it?  Normal, signed distance, corners with ids that persist
#include "plumb/query/contact/contact.hpp"  // contact, exact_contact; with a cache from frame to frame

// By which method, of convex bodies?
#include "plumb/query/polytope_hierarchy/polytope_hierarchy.hpp"  // extreme vertex and distance in logarithmic time
#include "plumb/query/vclip/separating_axis.hpp"    // a direction that parts polyhedra, by faces and edges
#include "plumb/query/vclip/separating_vector.hpp"  // the same by support vertices, from that of before
#include "plumb/query/vclip/vclip.hpp"              // nearest features of polyhedra, from those of before

// What does a ray hit first?  first_hit, hits, all_hits
#include "plumb/certify/ray_parameter.hpp"      // a parameter as it is
#include "plumb/query/ray/batch.hpp"            // of many triangles or boxes
#include "plumb/query/ray/csg.hpp"              // of trees of solids
#include "plumb/query/ray/hit_barycentric.hpp"  // where in a triangle: u and v
#include "plumb/query/ray/hits.hpp"             // yes or no
#include "plumb/query/ray/parity.hpp"           // is a point in a mesh?
#include "plumb/query/ray/posed.hpp"            // figures and rays under poses
#include "plumb/query/ray/ray.hpp"              // in space
#include "plumb/query/ray/ray2.hpp"             // in the plane
#include "plumb/query/ray/restated.hpp"         // slabs, boxes by width or by center

// When do they meet on their way?  first_contact
#include "plumb/arith/root.hpp"                                // a time as it is
#include "plumb/query/time_of_impact/continuous_contact.hpp"   // vertices that move linearly
#include "plumb/query/time_of_impact/interval_halving.hpp"     // any motion of bounded speed
#include "plumb/query/time_of_impact/motion.hpp"               // Moving, Translating
#include "plumb/query/time_of_impact/moving_distance.hpp"      // what has a distance
#include "plumb/query/time_of_impact/posed.hpp"                // polygons, polytopes, the plane, poses, along lines
#include "plumb/query/time_of_impact/posed_corners.hpp"        // vertices that move from pose to pose
#include "plumb/query/time_of_impact/restated.hpp"             // boxes by width or by center
#include "plumb/query/time_of_impact/translating_contact.hpp"  // convex figures along lines
