// With which triangles is a loop of edges filled, on its own corners?
//
// Which corner is the smallest is a guess in doubles; whether a filling fits the surface is decided elsewhere, exactly.
// Laws: (1) n - 2 triangles, none of them without area; each edge of the loop is in one, run along as the loop is. (2)
// No diagonal is one that `is_taken` names.  (3) The same loop, from its first point on (point_order.hpp), has the same
// filling, however its vertices are numbered.
// Source: RTCD 12.5.1.
// Cost: in one plane that of triangulate_face; little area n log n.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"

namespace plumb::surface {

using Filling = std::vector<TriangleMesh::Triangle>;
using TakenDiagonal = std::function<bool(std::uint32_t, std::uint32_t)>;

/// The exact triangulation of a loop in one plane; nothing where it is in none, or is no simple polygon.
std::optional<Filling> planar_filling(std::span<const Point3> points, std::span<const std::uint32_t> loop,
                                      const TakenDiagonal& is_taken);

/// By cutting off the smallest corner, again and again; nothing where that comes to no end.
std::optional<Filling> little_area_filling(std::span<const Point3> points, std::span<const std::uint32_t> loop,
                                           const TakenDiagonal& is_taken);

}  // namespace plumb::surface
