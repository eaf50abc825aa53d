// Point in polyhedron, winding number: is the point in the solid that a closed mesh bounds, and how often does the
// surface wind around it?  Asked of the mesh's tree.
//
//   const Bvh bvh = build_bvh(mesh);
//   if (locate(bvh, p) == Location::inside) ...
//
// Laws: those of plumb/query/ray/parity.hpp, whose answers these are: exact, without unlucky rays.  Of many points each
// is answered as if alone, on any number of threads.  No triangles, nothing inside.  Under a pose the answers are those of
// the exact image (space/bvh/posed_mesh.hpp).
// A point that is NaN or infinite throws NonFinite, a span of another length than the points UnequalLengths.
// Source: RTCD 5.4.3.
// Cost: a descent by comparisons alone, and an exact sign for each triangle that the line along x through the point
// passes.  Bounded by n signs a point, on integers as long as the exponents' span.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "plumb/certify/batch.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/space/bvh/mesh_view.hpp"

namespace plumb {

Location locate(const MeshView& mesh, const Point3& p);
bool contains(const MeshView& mesh, const Point3& p);

/// Nothing for a point on the surface.
std::optional<std::int64_t> winding_number(const MeshView& mesh, const Point3& p);

void locate(const MeshView& mesh, std::span<const Point3> points, std::span<Location> out,
            Execution execution = Execution::parallel);
void winding_number(const MeshView& mesh, std::span<const Point3> points, std::span<std::optional<std::int64_t>> out,
                    Execution execution = Execution::parallel);

}  // namespace plumb
