// Ray cast against a mesh that has been moved; and is a point inside of it?  Its vertices are not rounded.
//
//   if (const auto hit = first_hit(Ray3{eye, direction}, {bvh, pose})) ...
//   if (locate({bvh, pose}, p) == Location::inside) ...
//
// Laws: those of mesh_ray.hpp and inside.hpp, of the exact images of the triangles (plumb/space/bvh/posed_mesh.hpp):
// the first hit is that of the least exact parameter, of equal ones that of the lowest number.  So a closed mesh stays
// closed under every pose, and nothing slips through it.  Numbers of a Hit are rounded once; they are infinite beyond
// the largest double.
// A pose that is NaN or infinite throws NonFinite ("first_hit: mesh.pose.translation.x is nan, ..."), and so does a
// ray or a point; spans of unequal length throw UnequalLengths.
// Source: RTCD 3.2, 4.2.6, 5.3.6, 5.4.3.
// Cost: a microsecond more than at a mesh that stands, half of it once for many rays; where the pose flattens the mesh
// some 100 ns for each node that is looked at, and 300 ns for each triangle of the leaves that are reached.  Bounded by
// n tests of triangles a ray, on integers as long as the exponents' span.
#pragma once

#include "plumb/space/bvh/posed_mesh.hpp"
#include "plumb/space/ray/inside.hpp"
#include "plumb/space/ray/mesh_ray.hpp"

namespace plumb {

std::optional<NumberedHit> first_hit(const AnyRay& ray, const PosedMesh& mesh, HitRule rule = HitRule::closed);
std::optional<std::uint32_t> first_triangle(const AnyRay& ray, const PosedMesh& mesh, HitRule rule = HitRule::closed);
bool hits(const AnyRay& ray, const PosedMesh& mesh, HitRule rule = HitRule::closed);
std::vector<NumberedHit> ordered_hits(const AnyRay& ray, const PosedMesh& mesh, HitRule rule = HitRule::closed,
                                      std::vector<NumberedHit> rows = {});
std::size_t count_hits(const AnyRay& ray, const PosedMesh& mesh, HitRule rule = HitRule::closed);

void first_hits(std::span<const AnyRay> rays, const PosedMesh& mesh, std::span<std::optional<NumberedHit>> out,
                const ManyRays& options = {});
void first_triangles(std::span<const AnyRay> rays, const PosedMesh& mesh, std::span<std::uint32_t> out,
                     const ManyRays& options = {});
void hits(std::span<const AnyRay> rays, const PosedMesh& mesh, std::span<std::uint8_t> out,
          const ManyRays& options = {});
void ordered_hits(std::span<const AnyRay> rays, const PosedMesh& mesh, std::span<std::vector<NumberedHit>> out,
                  const ManyRays& options = {});
void count_hits(std::span<const AnyRay> rays, const PosedMesh& mesh, std::span<std::size_t> out,
                const ManyRays& options = {});

Location locate(const PosedMesh& mesh, const Point3& p);
bool contains(const PosedMesh& mesh, const Point3& p);
/// Nothing for a point on the surface.
std::optional<std::int64_t> winding_number(const PosedMesh& mesh, const Point3& p);

void locate(const PosedMesh& mesh, std::span<const Point3> points, std::span<Location> out,
            Execution execution = Execution::parallel);
void winding_number(const PosedMesh& mesh, std::span<const Point3> points, std::span<std::optional<std::int64_t>> out,
                    Execution execution = Execution::parallel);

/// The same of a compact tree.
std::optional<NumberedHit> first_hit(const AnyRay& ray, const PosedCompactMesh& mesh, HitRule rule = HitRule::closed);
std::optional<std::uint32_t> first_triangle(const AnyRay& ray, const PosedCompactMesh& mesh,
                                            HitRule rule = HitRule::closed);
bool hits(const AnyRay& ray, const PosedCompactMesh& mesh, HitRule rule = HitRule::closed);
std::vector<NumberedHit> ordered_hits(const AnyRay& ray, const PosedCompactMesh& mesh, HitRule rule = HitRule::closed,
                                      std::vector<NumberedHit> rows = {});
std::size_t count_hits(const AnyRay& ray, const PosedCompactMesh& mesh, HitRule rule = HitRule::closed);
void first_hits(std::span<const AnyRay> rays, const PosedCompactMesh& mesh, std::span<std::optional<NumberedHit>> out,
                const ManyRays& options = {});
void first_triangles(std::span<const AnyRay> rays, const PosedCompactMesh& mesh, std::span<std::uint32_t> out,
                     const ManyRays& options = {});
void hits(std::span<const AnyRay> rays, const PosedCompactMesh& mesh, std::span<std::uint8_t> out,
          const ManyRays& options = {});
void ordered_hits(std::span<const AnyRay> rays, const PosedCompactMesh& mesh, std::span<std::vector<NumberedHit>> out,
                  const ManyRays& options = {});
void count_hits(std::span<const AnyRay> rays, const PosedCompactMesh& mesh, std::span<std::size_t> out,
                const ManyRays& options = {});
Location locate(const PosedCompactMesh& mesh, const Point3& p);
bool contains(const PosedCompactMesh& mesh, const Point3& p);
std::optional<std::int64_t> winding_number(const PosedCompactMesh& mesh, const Point3& p);
void locate(const PosedCompactMesh& mesh, std::span<const Point3> points, std::span<Location> out,
            Execution execution = Execution::parallel);
void winding_number(const PosedCompactMesh& mesh, std::span<const Point3> points,
                    std::span<std::optional<std::int64_t>> out, Execution execution = Execution::parallel);

}  // namespace plumb
