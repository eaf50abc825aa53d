// Closest point on a mesh that has been moved; which of its triangles are nearest, which within reach; and how near two
// moved meshes are to one another.
//
//   if (const auto near = closest_on_mesh({bvh, pose}, p)) use(near->triangle, near->point, near->distance);
//   if (const auto near = closest_triangles({a, pose_a}, {b, pose_b})) use(near->a, near->b, near->closest.distance);
//
// Laws: those of closest_on_mesh.hpp and closest_triangles.hpp, of the exact images (plumb/space/bvh/posed_mesh.hpp),
// of which numbers are rounded once; they are infinite beyond the largest double.
// A pose that is NaN or infinite throws NonFinite ("closest_on_mesh: mesh.pose.translation.x is nan, ...").
// Source: RTCD 3.2, 4.2.6, 5.1.5, 5.1.10, 6.3.2.
// Cost: some 100 ns for each node that is looked at, 500 for each triangle whose box may be nearer; two meshes as
// closest_triangles.hpp says, and microseconds for each pair of triangles of which doubles say too little.  Bounded by
// n log n operations a point, on integers as long as the exponents' span.
#pragma once

#include "plumb/space/bvh/posed_mesh.hpp"
#include "plumb/space/closest/closest_on_mesh.hpp"
#include "plumb/space/closest/closest_triangles.hpp"

namespace plumb {

std::optional<ClosestOnMesh> closest_on_mesh(const PosedMesh& mesh, const Point3& p,
                                             double within = std::numeric_limits<double>::infinity());
void closest_on_mesh(const PosedMesh& mesh, std::span<const Point3> points, std::span<ClosestOnMesh> out,
                     const ClosestOptions& options = {});

std::vector<NearTriangle> nearest_triangles(const PosedMesh& mesh, const Point3& p, std::size_t k,
                                            std::vector<NearTriangle> rows = {});

std::vector<NearTriangle> triangles_within(const PosedMesh& mesh, const Point3& p, double distance,
                                           std::vector<NearTriangle> rows = {});

/// The same of a compact tree.
std::optional<ClosestOnMesh> closest_on_mesh(const PosedCompactMesh& mesh, const Point3& p,
                                             double within = std::numeric_limits<double>::infinity());
void closest_on_mesh(const PosedCompactMesh& mesh, std::span<const Point3> points, std::span<ClosestOnMesh> out,
                     const ClosestOptions& options = {});
std::vector<NearTriangle> nearest_triangles(const PosedCompactMesh& mesh, const Point3& p, std::size_t k,
                                            std::vector<NearTriangle> rows = {});
std::vector<NearTriangle> triangles_within(const PosedCompactMesh& mesh, const Point3& p, double distance,
                                           std::vector<NearTriangle> rows = {});

std::optional<ClosestTriangles> closest_triangles(const PosedMesh& a, const PosedMesh& b,
                                                  const ClosestPairOptions& options = {});
double distance(const PosedMesh& a, const PosedMesh& b);
bool within(const PosedMesh& a, const PosedMesh& b, double distance);

}  // namespace plumb
