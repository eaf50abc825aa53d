// Closest point on a mesh: which triangle is nearest to a point, and which of its points; which k, and which within reach?
//
//   if (const auto near = closest_on_mesh(bvh, p)) use(near->triangle, near->point, near->distance);
//   closest_on_mesh(bvh, p, 0.25)            // nothing where all of it is farther away
//   nearest_triangles(bvh, p, 5)             // the five nearest
//   triangles_within(bvh, p, 0.25)           // all whose distance is at most that
//   closest_on_mesh(bvh, points, out)        // of many points, with threads
//   closest_on_mesh({bvh, pose}, p)          // of a mesh that has been moved
//
// Laws: (1) the triangle of least distance in real arithmetic, of equally near ones the lowest; point, distance and
// feature are those of closest_points(p, triangle) (query/closest/closest.hpp).  (2) The k nearest ascend by exact
// distance, then by number; fewer where the mesh has fewer.  (3) Those within a distance ascend by number; a distance of
// exactly as much is within, and nothing is within a negative one, of closest_on_mesh likewise.  (4) The answers depend on the mesh alone: not on its
// tree, execution or number of threads.  (5) An empty mesh has no nearest triangle: single questions answer nothing; of
// many points closest_on_mesh throws InvalidShape.  (6) Under a pose the answers are those of the exact images
// (space/bvh/posed_mesh.hpp), of which numbers are rounded once; they are infinite beyond the largest double.
// NaN and infinities throw NonFinite, naming the argument, of many points with its number; spans of unequal length
// UnequalLengths, before anything is written.  progress may stop the batch.
// Source: RTCD 3.2, 4.2.6, 5.1.5, 6.3.2; branch and bound as in Roussopoulos, Kelley and Vincent 1995.
// Cost: a bound for each child of a node that is entered, rounded down; a distance for each triangle whose box may be
// nearer; microseconds for a tie of triangles that have not their nearest feature in common.  Under a pose some 100 ns for
// each node that is looked at, 500 for each triangle whose box may be nearer.  Bounded by n log n
// operations a point, on integers as long as the exponents' span: each triangle at most, and their order by distance.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "plumb/figure/containment/voronoi_region.hpp"
#include "plumb/space/bvh/mesh_view.hpp"
#include "plumb/space/bvh/progress.hpp"

namespace plumb {

struct ClosestOnMesh {
  std::uint32_t triangle;  // its number in the mesh
  Point3 point;
  double distance;
  Feature feature;  // of the triangle
  friend bool operator==(const ClosestOnMesh&, const ClosestOnMesh&) = default;
};

struct NearTriangle {
  std::uint32_t triangle;
  double distance;
  friend bool operator==(const NearTriangle&, const NearTriangle&) = default;
};

struct ClosestOptions {
  Execution execution = Execution::parallel;
  Progress progress = {};
};

std::optional<ClosestOnMesh> closest_on_mesh(const MeshView& mesh, const Point3& p,
                                             double within = std::numeric_limits<double>::infinity());
void closest_on_mesh(const MeshView& mesh, std::span<const Point3> points, std::span<ClosestOnMesh> out,
                     const ClosestOptions& options = {});

std::vector<NearTriangle> nearest_triangles(const MeshView& mesh, const Point3& p, std::size_t k,
                                            std::vector<NearTriangle> rows = {});

std::vector<NearTriangle> triangles_within(const MeshView& mesh, const Point3& p, double distance,
                                           std::vector<NearTriangle> rows = {});

}  // namespace plumb
