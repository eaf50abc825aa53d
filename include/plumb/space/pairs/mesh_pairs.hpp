// Which triangles of a mesh meet which of another, or of the same mesh, and do they overlap or only touch?
//
//   for (const TrianglePair& p : intersecting_pairs(a, b)) use(p.a, p.b, p.relation);   // numbers in the meshes
//   self_intersecting_pairs(mesh)                        // neighbors judged beyond the vertices that they share
//   any_intersecting_pair(a, b)                          // stops at the first that it comes upon
//   intersections(a, b, pairs)                           // what each pair has in common: segments, points, polygons
//
// Laws: (1) the pairs are exactly those whose relate is not disjoint, each with that relation; of a mesh with itself those
// whose relate_in_mesh (neighbors.hpp) is not, each once, a < b.  (2) They ascend by a, then b.  (3) They depend on the
// meshes alone: not on the trees, execution, or number of threads.  (4) any is one of them where there is one, the same
// in every run over the same trees, found on one thread.  (5) Naming the meshes the other way round turns the pairs
// round.  (6) An empty mesh meets nothing.
// progress may stop each of these (plumb/space/bvh/progress.hpp).
// Source: RTCD 6.3.3, 5.2.10; Guigue and Devillers 2003.
// Cost: comparisons of boxes for each pair of wide nodes that may meet, and of triangles with planes for those of
// leaves, eight at once; relate for those that are left; sorting in linear time.  Bounded by n^2 tests of pairs, on
// integers as long as the exponents' span.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "plumb/figure/basic/relation.hpp"
#include "plumb/query/section/intersection_result.hpp"
#include "plumb/space/bvh/bvh.hpp"
#include "plumb/space/bvh/compact_tree.hpp"
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

std::vector<TrianglePair> intersecting_pairs(const Bvh& a, const Bvh& b, const PairOptions& options = {},
                                             std::vector<TrianglePair> rows = {});
std::vector<TrianglePair> self_intersecting_pairs(const Bvh& mesh, const PairOptions& options = {},
                                                  std::vector<TrianglePair> rows = {});

/// No pair is kept in memory.
PairCount count_intersecting_pairs(const Bvh& a, const Bvh& b, const PairOptions& options = {});
PairCount count_self_intersecting_pairs(const Bvh& mesh, const PairOptions& options = {});

std::optional<TrianglePair> any_intersecting_pair(const Bvh& a, const Bvh& b, const PairOptions& options = {});
std::optional<TrianglePair> any_self_intersecting_pair(const Bvh& mesh, const PairOptions& options = {});

/// intersection(triangle, triangle) of each pair, in their order; of neighbors with what they share.  A number that
/// names no triangle throws InvalidShape.
std::vector<Intersection3> intersections(const Bvh& a, const Bvh& b, std::span<const TrianglePair> pairs,
                                         const PairOptions& options = {}, std::vector<Intersection3> rows = {});

/// The same of compact trees.
std::vector<TrianglePair> intersecting_pairs(const CompactBvh& a, const CompactBvh& b, const PairOptions& options = {},
                                             std::vector<TrianglePair> rows = {});
std::vector<TrianglePair> self_intersecting_pairs(const CompactBvh& mesh, const PairOptions& options = {},
                                                  std::vector<TrianglePair> rows = {});
PairCount count_intersecting_pairs(const CompactBvh& a, const CompactBvh& b, const PairOptions& options = {});
PairCount count_self_intersecting_pairs(const CompactBvh& mesh, const PairOptions& options = {});
std::optional<TrianglePair> any_intersecting_pair(const CompactBvh& a, const CompactBvh& b,
                                                  const PairOptions& options = {});
std::optional<TrianglePair> any_self_intersecting_pair(const CompactBvh& mesh, const PairOptions& options = {});
std::vector<Intersection3> intersections(const CompactBvh& a, const CompactBvh& b, std::span<const TrianglePair> pairs,
                                         const PairOptions& options = {}, std::vector<Intersection3> rows = {});

}  // namespace plumb
