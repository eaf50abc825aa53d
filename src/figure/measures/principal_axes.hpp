// Along which directions do points or surfaces spread most and least?
//
// Laws: orthonormal up to rounding, longest first; all finite for all input of magnitude one.  Deterministic.
// Source: RTCD 4.3.3, 4.4.3; Eigen's SelfAdjointEigenSolver.
// Cost: linear.
#pragma once

#include <span>
#include <vector>

#include "figure/basic/frame.hpp"
#include "plumb/figure/basic/mesh.hpp"

namespace plumb::figure::frame {

std::array<Vector3, 3> principal_axes(std::span<const Vector3> points);

/// Every triangle weighs as much as its area.
std::array<Vector3, 3> principal_axes_of_surface(std::span<const Vector3> vertices,
                                                 std::span<const TriangleMesh::Triangle> triangles);

}  // namespace plumb::figure::frame
