// Ray cast, closest hit, shadow ray: which triangle of a mesh does a ray hit first, does it hit any, which all in order,
// and how many?
//
//   const Bvh bvh = build_bvh(mesh);
//   if (const auto hit = first_hit(bvh, Ray3{eye, direction})) ...     // hit->index, hit->hit.t, .point, .normal
//   if (any_hit({bvh, pose}, Segment3{eye, lamp})) ...                 // of a mesh that has been moved
//   first_hit(bvh, ray, {.least = 0.25, .most = 8, .skip = left})      // nearer, farther and left triangles aside
//   first_triangle(bvh, rays, out);                                    // many rays, on all threads
//   hit_barycentric(bvh, ray, hit->index)                              // u and v of a hit, for who asks
//
// Laws: (1) the answers are those of first_hit and hits (query/ray/ray.hpp, query/ray/hits.hpp) asked of each triangle.
// (2) The first hit is that of the least exact parameter, and of equal ones that of the lowest number in the mesh;
// hits has them all by that order.  (3) So nothing slips through between triangles: not at vertices, nor along
// edges, nor in the planes of triangles; by HitRule::half_open a closed mesh is crossed an even number of times by a
// ray from outside.  (4) Of many rays each is answered as if alone, on any number of threads.  (5) Under a pose the
// answers are those of the exact images (space/bvh/posed_mesh.hpp): a closed mesh stays closed, and nothing slips through
// it.  Numbers of a Hit are rounded once; they are infinite beyond the largest double.  (6) With limits the hits are those
// that hits has without, but for those whose exact parameter is below the least or above the most, and those of the
// triangles to skip: a ray that begins on a triangle leaves it by its number, and by no least distance.  (7) u and v are
// those of query/ray/hit_barycentric.hpp; there are none of a triangle that the ray does not hit.
// No triangles, no hits.  A span of another length than the rays throws UnequalLengths, a ray that is NaN or infinite
// NonFinite, and so does a limit that is NaN; `out` may have been written to by then.  progress may stop a batch.
// Source: RTCD 3.2, 4.2.6, 5.3.6, 6.3.2, 6.6.7.
// Cost: the descent, by the wide form of the tree; many rays by turns, twice as fast where the mesh is larger than the
// caches, and sixteen that go the same way, as a camera's, as one: a third to a half of the time; 0.2 us more for the
// numbers of a Hit, which first_triangle does without.  Under a pose a microsecond more, half of it once for many rays;
// where it flattens the mesh some 100 ns for each node that is looked at, and 300 ns for each triangle.  u and v take a
// descent to find the triangle by its number, and what hit_barycentric takes; of rays that are many for the mesh a pass
// over its triangles, and no descent.  Of limits the most
// leaves out what is farther; each hit is looked up in what is to skip, one after the other.  Bounded by n
// tests of triangles a ray, on integers as long as the exponents' span.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "plumb/certify/batch.hpp"
#include "plumb/query/ray/batch.hpp"
#include "plumb/query/ray/hit_barycentric.hpp"
#include "plumb/space/bvh/mesh_view.hpp"
#include "plumb/space/bvh/progress.hpp"

namespace plumb {

/// Which hits of a ray count?  Those at parameters from the least to the most, both among them, of triangles that are not
/// to be skipped.
struct HitLimits {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  std::span<const std::uint32_t> skip = {};  // by their numbers in the mesh, in any order
};

std::optional<NumberedHit> first_hit(const MeshView& mesh, const AnyRay& ray, HitRule rule = HitRule::closed);
/// Its number alone.
std::optional<std::uint32_t> first_triangle(const MeshView& mesh, const AnyRay& ray, HitRule rule = HitRule::closed);
bool any_hit(const MeshView& mesh, const AnyRay& ray, HitRule rule = HitRule::closed);
/// In the order of the ray.
std::vector<NumberedHit> hits(const MeshView& mesh, const AnyRay& ray, HitRule rule = HitRule::closed,
                              std::vector<NumberedHit> rows = {});
std::size_t count_hits(const MeshView& mesh, const AnyRay& ray, HitRule rule = HitRule::closed);

/// The same of what the limits leave.
std::optional<NumberedHit> first_hit(const MeshView& mesh, const AnyRay& ray, const HitLimits& limits,
                                     HitRule rule = HitRule::closed);
std::optional<std::uint32_t> first_triangle(const MeshView& mesh, const AnyRay& ray, const HitLimits& limits,
                                            HitRule rule = HitRule::closed);
bool any_hit(const MeshView& mesh, const AnyRay& ray, const HitLimits& limits, HitRule rule = HitRule::closed);
std::vector<NumberedHit> hits(const MeshView& mesh, const AnyRay& ray, const HitLimits& limits,
                              HitRule rule = HitRule::closed, std::vector<NumberedHit> rows = {});
std::size_t count_hits(const MeshView& mesh, const AnyRay& ray, const HitLimits& limits,
                       HitRule rule = HitRule::closed);

struct ManyRays {
  HitRule rule = HitRule::closed;
  std::span<const HitLimits> limits = {};  // of each ray, or of none
  Execution execution = Execution::parallel;
  Progress progress = {};
};

inline constexpr std::uint32_t no_triangle = 0xffffffff;

void first_hit(const MeshView& mesh, std::span<const AnyRay> rays, std::span<std::optional<NumberedHit>> out,
               const ManyRays& options = {});
/// no_triangle where none is hit.
void first_triangle(const MeshView& mesh, std::span<const AnyRay> rays, std::span<std::uint32_t> out,
                    const ManyRays& options = {});
/// 1 or 0.
void any_hit(const MeshView& mesh, std::span<const AnyRay> rays, std::span<std::uint8_t> out,
             const ManyRays& options = {});
void hits(const MeshView& mesh, std::span<const AnyRay> rays, std::span<std::vector<NumberedHit>> out,
          const ManyRays& options = {});
void count_hits(const MeshView& mesh, std::span<const AnyRay> rays, std::span<std::size_t> out,
                const ManyRays& options = {});

/// Tells where the ray hits a triangle of the mesh, which is named by its number.
std::optional<HitBarycentric> hit_barycentric(const MeshView& mesh, const AnyRay& ray, std::uint32_t triangle);
std::optional<ExactHitBarycentric> exact_hit_barycentric(const MeshView& mesh, const AnyRay& ray,
                                                         std::uint32_t triangle);
/// Each ray is asked of a triangle of its own, such as first_triangle tells; no_triangle has no answer.
void hit_barycentric(const MeshView& mesh, std::span<const AnyRay> rays, std::span<const std::uint32_t> triangles,
                     std::span<std::optional<HitBarycentric>> out, Execution execution = Execution::parallel);

}  // namespace plumb
