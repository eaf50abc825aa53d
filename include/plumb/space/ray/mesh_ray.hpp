// Ray cast: which triangle of a mesh does a ray hit first, does it hit any, which all in order, and how many?
//
//   const Bvh bvh = build_bvh(mesh);
//   if (const auto hit = first_hit(Ray3{eye, direction}, bvh)) ...     // hit->index, hit->hit.t, .point, .normal
//   first_triangles(rays, bvh, out);                                   // many rays, on all threads
//
// Laws: (1) the answers are those of first_hit and hits (query/ray/ray.hpp, query/ray/hits.hpp) asked of each triangle.
// (2) The first hit is that of the least exact parameter, and of equal ones that of the lowest number in the mesh;
// ordered_hits has them all by that order.  (3) So nothing slips through between triangles: not at vertices, nor along
// edges, nor in the planes of triangles; by HitRule::half_open a closed mesh is crossed an even number of times by a
// ray from outside.  (4) Of many rays each is answered as if alone, on any number of threads.
// No triangles, no hits.  A span of another length than the rays throws UnequalLengths, a ray that is NaN or infinite
// NonFinite; `out` may have been written to by then.  progress may stop a batch.
// Source: RTCD 5.3.6, 6.3.2, 6.6.7.
// Cost: the descent, by the wide form of the tree; many rays by turns, twice as fast where the mesh is larger than the
// caches, and sixteen that go the same way, as a camera's, as one: a third to a half of the time; 0.2 us more for the
// numbers of a Hit, which first_triangle does without.  Bounded by n tests of triangles a ray, on integers as long as
// the exponents' span.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "plumb/certify/batch.hpp"
#include "plumb/query/ray/batch.hpp"
#include "plumb/space/bvh/bvh.hpp"
#include "plumb/space/bvh/compact_tree.hpp"
#include "plumb/space/bvh/progress.hpp"

namespace plumb {

std::optional<NumberedHit> first_hit(const AnyRay& ray, const Bvh& bvh, HitRule rule = HitRule::closed);
/// Its number alone.
std::optional<std::uint32_t> first_triangle(const AnyRay& ray, const Bvh& bvh, HitRule rule = HitRule::closed);
/// Is any triangle hit?
bool hits(const AnyRay& ray, const Bvh& bvh, HitRule rule = HitRule::closed);
std::vector<NumberedHit> ordered_hits(const AnyRay& ray, const Bvh& bvh, HitRule rule = HitRule::closed,
                                      std::vector<NumberedHit> rows = {});
std::size_t count_hits(const AnyRay& ray, const Bvh& bvh, HitRule rule = HitRule::closed);

struct ManyRays {
  HitRule rule = HitRule::closed;
  Execution execution = Execution::parallel;
  Progress progress = {};
};

inline constexpr std::uint32_t no_triangle = 0xffffffff;

void first_hits(std::span<const AnyRay> rays, const Bvh& bvh, std::span<std::optional<NumberedHit>> out,
                const ManyRays& options = {});
void first_triangles(std::span<const AnyRay> rays, const Bvh& bvh, std::span<std::uint32_t> out,
                     const ManyRays& options = {});
void hits(std::span<const AnyRay> rays, const Bvh& bvh, std::span<std::uint8_t> out, const ManyRays& options = {});
void ordered_hits(std::span<const AnyRay> rays, const Bvh& bvh, std::span<std::vector<NumberedHit>> out,
                  const ManyRays& options = {});
void count_hits(std::span<const AnyRay> rays, const Bvh& bvh, std::span<std::size_t> out, const ManyRays& options = {});

/// The same of a compact tree.
std::optional<NumberedHit> first_hit(const AnyRay& ray, const CompactBvh& bvh, HitRule rule = HitRule::closed);
std::optional<std::uint32_t> first_triangle(const AnyRay& ray, const CompactBvh& bvh, HitRule rule = HitRule::closed);
bool hits(const AnyRay& ray, const CompactBvh& bvh, HitRule rule = HitRule::closed);
std::vector<NumberedHit> ordered_hits(const AnyRay& ray, const CompactBvh& bvh, HitRule rule = HitRule::closed,
                                      std::vector<NumberedHit> rows = {});
std::size_t count_hits(const AnyRay& ray, const CompactBvh& bvh, HitRule rule = HitRule::closed);
void first_hits(std::span<const AnyRay> rays, const CompactBvh& bvh, std::span<std::optional<NumberedHit>> out,
                const ManyRays& options = {});
void first_triangles(std::span<const AnyRay> rays, const CompactBvh& bvh, std::span<std::uint32_t> out,
                     const ManyRays& options = {});
void hits(std::span<const AnyRay> rays, const CompactBvh& bvh, std::span<std::uint8_t> out,
          const ManyRays& options = {});
void ordered_hits(std::span<const AnyRay> rays, const CompactBvh& bvh, std::span<std::vector<NumberedHit>> out,
                  const ManyRays& options = {});
void count_hits(std::span<const AnyRay> rays, const CompactBvh& bvh, std::span<std::size_t> out,
                const ManyRays& options = {});

}  // namespace plumb
