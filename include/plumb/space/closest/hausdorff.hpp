// Hausdorff distance: how far is the farthest point of a mesh from another mesh?  Between two doubles, for certain.
//
//   const HausdorffDistance h = hausdorff_distance(a, b);    // both ways
//   h.least <= the distance <= h.most                        // always
//   hausdorff_distance({a, pose}, b)                         // of a mesh that has been moved
//   hausdorff_from(a, b, {.absolute = 0.01}).most            // of the points of a from b: how far it sticks out
//
// Meshes are the sets of the points of their triangles: corners, edges and insides; triangles without area are the
// segments and points that they are; vertices that no triangle names do not count.
// Laws: (1) hausdorff_from: the largest distance of a point of a from b lies in [least, most]; hausdorff_distance: so
// does the larger of the two.  (2) Where is_within, most - least is at most the largest of `absolute`, `relative` times
// most and `of_size` times the larger mesh's longest extent.  Elsewhere the pieces were used up, or are as small as
// doubles tell; the interval is wider and as true.  (3) The point lies on triangle `from` of a but for the rounding of
// its coordinates; what it stands for is at least as far from b as `least`, and `to` is the triangle of b nearest to
// the point.  Of hausdorff_distance it is one of b, and `to` of a, where of_b.  (4) The answer depends on the meshes
// and the options alone: not on their trees, execution or number of threads.  (5) Of a mesh and itself both numbers are
// 0, and so they are of one tree under one pose.  (6) Under poses these are the distances of the exact images
// (space/bvh/posed_mesh.hpp): vertices are rounded, and the interval is widened by how far that can have moved them, so
// that most - least is as small as is asked for where that is more than this rounding.  The point is one of the rounded
// image; it and the numbers are infinite beyond the largest double.
// A mesh without triangles throws InvalidShape, naming it; tolerances that are negative or NaN likewise; a pose that is
// NaN or infinite NonFinite ("hausdorff_from: a.pose.translation.x is nan, ...").
// Source: RTCD 3.2, 6.3.2; branch and bound over pieces of triangles: Guthe, Borodin and Klein 2005, Tang, Lee and Kim 2009.
// Cost: a nearest triangle for every vertex, on all threads, then one or two for each piece; under poses a copy of each
// tree, fitted to the images.  Pieces are few where the
// farthest points are few; of one surface in two triangulations as many as the triangles of one are cut by the other.
// Bounded by n^2 log n operations for the vertices, on integers as long as the exponents' span; pieces end where they
// are as small as doubles tell.
#pragma once

#include <cstddef>
#include <cstdint>

#include "plumb/space/bvh/mesh_view.hpp"
#include "plumb/space/bvh/progress.hpp"

namespace plumb {

/// How near the answer is to be: of these the largest, which are guesses of what serves.
struct HausdorffOptions {
  double absolute = 0;                // what most - least may be,
  double relative = 0x1p-10;          // or as a share of most,
  double of_size = 0x1p-40;           // or of the meshes' extent, below which there is rounding alone
  std::size_t most_pieces = 1 << 18;  // beyond a's triangles
  Execution execution = Execution::parallel;
  Progress progress = {};
};

struct HausdorffDistance {
  double least, most;
  bool is_within;  // the tolerance
  bool of_b;       // the point is one of b
  Point3 point;
  std::uint32_t from, to;  // the triangle that it lies on, and the nearest of the other mesh; their numbers
  friend bool operator==(const HausdorffDistance&, const HausdorffDistance&) = default;
};

HausdorffDistance hausdorff_from(const BvhView& a, const BvhView& b, const HausdorffOptions& options = {});

HausdorffDistance hausdorff_distance(const BvhView& a, const BvhView& b, const HausdorffOptions& options = {});

}  // namespace plumb
