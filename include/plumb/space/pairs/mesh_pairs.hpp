// Which triangles of a mesh meet which of another, or of the same mesh, and do they overlap or only touch?
//
//   for (const TrianglePair& p : intersecting_pairs(a, b)) use(p.a, p.b, p.relation);   // numbers in the meshes
//   intersecting_pairs({a, pose_a}, {b, pose_b})         // of meshes that have been moved
//   intersecting_pairs(mesh)                             // of one with itself, beyond the vertices that neighbors share
//   any_intersecting_pair(a, b)                          // stops at the first that it comes upon
//   intersections(a, b, pairs)                           // what each pair has in common: segments, points, polygons
//
// Laws: (1) the pairs are exactly those whose relate is not disjoint, each with that relation; of a mesh with itself those
// whose relate_in_mesh (neighbors.hpp) is not, each once, a < b.  (2) They ascend by a, then b.  (3) They depend on the
// meshes alone: not on the trees, execution, or number of threads.  (4) any is one of them where there is one, the same
// in every run over the same trees, found on one thread.  (5) Naming the meshes the other way round turns the pairs
// round.  (6) An empty mesh meets nothing.  (7) Under poses the triangles are the exact images (space/bvh/posed_mesh.hpp):
// so two meshes under one pose have the pairs that they have without it, each with its relation, where it is regular,
// and a mesh under such a pose those that it has with itself.  What any finds may be another pair than without a pose.
// progress may stop each of these (plumb/space/bvh/progress.hpp).
// Source: RTCD 3.2, 4.2.6, 5.2.10, 6.3.3; Guigue and Devillers 2003.
// Cost: comparisons of boxes for each pair of wide nodes that may meet, and of triangles with planes for those of
// leaves, eight at once; relate for those that are left; sorting in linear time.  Of one mesh neighbors are told apart
// around each vertex at once, by three signs a triangle, and by relate_in_mesh where that tells nothing.  Under one regular
// pose the same; under others a box for each node, and some 300 ns for each pair of triangles whose boxes meet; some 10 us
// where one is a segment or a point, and 100 for what a pair has in common.  A Bvh beside a CompactBvh is made compact first.  Bounded
// by n^2 tests of pairs, on integers as long as the exponents' span.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "plumb/figure/basic/relation.hpp"
#include "plumb/query/section/intersection_result.hpp"
#include "plumb/space/bvh/mesh_view.hpp"
#include "plumb/space/bvh/progress.hpp"

namespace plumb {

struct TrianglePair {
  std::uint32_t a, b;
  Relation relation;  // touching or overlapping
  friend bool operator==(const TrianglePair&, const TrianglePair&) = default;
};

struct PairOptions {
  bool touching = true;  // false: only the pairs that overlap
  Execution execution = Execution::parallel;
  Progress progress = {};
};

struct PairCount {
  std::size_t touching = 0, overlapping = 0;
  friend bool operator==(const PairCount&, const PairCount&) = default;
};

std::vector<TrianglePair> intersecting_pairs(const MeshView& a, const MeshView& b, const PairOptions& options = {},
                                             std::vector<TrianglePair> rows = {});
/// No pair is kept in memory.
PairCount count_intersecting_pairs(const MeshView& a, const MeshView& b, const PairOptions& options = {});
std::optional<TrianglePair> any_intersecting_pair(const MeshView& a, const MeshView& b,
                                                  const PairOptions& options = {});

/// These are the pairs that one mesh has with itself.
std::vector<TrianglePair> intersecting_pairs(const MeshView& mesh, const PairOptions& options = {},
                                             std::vector<TrianglePair> rows = {});
PairCount count_intersecting_pairs(const MeshView& mesh, const PairOptions& options = {});
std::optional<TrianglePair> any_intersecting_pair(const MeshView& mesh, const PairOptions& options = {});

/// intersection(triangle, triangle) of each pair, in their order; of neighbors with what they share.  A number that
/// names no triangle throws InvalidShape.
std::vector<Intersection3> intersections(const MeshView& a, const MeshView& b, std::span<const TrianglePair> pairs,
                                         const PairOptions& options = {}, std::vector<Intersection3> rows = {});

}  // namespace plumb
