// Range search in a mesh that has been moved: which of its triangles does a box, a ball, a segment, a frustum or any
// convex region meet?
//
//   triangles_meeting({bvh, pose}, Aabb3{{0, 0, 0}, {1, 1, 1}})
//   triangles_meeting({bvh, pose}, std::span<const Sphere3>(balls))        // of many, with threads
//
// Laws: those of range_search.hpp, of the exact images (plumb/space/bvh/posed_mesh.hpp).
// A pose that is NaN or infinite throws NonFinite ("triangles_meeting: mesh.pose.translation.x is nan, ...").
// Source: RTCD 3.2, 4.2.6, 5.2, 6.3.1.
// Cost: some 100 ns for each node that is looked at and the exact test of its box; below a microsecond for a triangle
// that doubles decide.  Bounded by n tests of triangles, on integers as long as the exponents' span.
#pragma once

#include "plumb/space/bvh/posed_mesh.hpp"
#include "plumb/space/range/range_search.hpp"

namespace plumb {

template <RangeShape Shape>
std::vector<std::uint32_t> triangles_meeting(const PosedMesh& mesh, const Shape& shape,
                                             std::vector<std::uint32_t> rows = {});
template <RangeShape Shape>
std::vector<std::uint32_t> triangles_meeting(const PosedCompactMesh& mesh, const Shape& shape,
                                             std::vector<std::uint32_t> rows = {});

/// Of each shape.
template <RangeShape Shape>
std::vector<std::vector<std::uint32_t>> triangles_meeting(const PosedMesh& mesh, std::span<const Shape> shapes,
                                                          const RangeOptions& options = {},
                                                          std::vector<std::vector<std::uint32_t>> rows = {});
template <RangeShape Shape>
std::vector<std::vector<std::uint32_t>> triangles_meeting(const PosedCompactMesh& mesh, std::span<const Shape> shapes,
                                                          const RangeOptions& options = {},
                                                          std::vector<std::vector<std::uint32_t>> rows = {});

}  // namespace plumb
