// Range search, culling: which triangles of a mesh does a box, a ball, a segment, a frustum or any convex region meet?
//
//   for (const std::uint32_t t : meeting(bvh, Aabb3{{0, 0, 0}, {1, 1, 1}})) ...
//   meeting(bvh, HalfspaceIntersection3{{left, right, top, bottom, near, far}})   // culling by a frustum
//   meeting(bvh, std::span<const Sphere3>(balls))                                 // of many, with threads
//
// Laws: (1) the numbers, ascending, of exactly those triangles for which intersects(triangle, shape) is true: closed
// sets, so touching counts.  (2) The answer depends on the mesh alone: not on its tree, execution or threads.  (3) No
// triangles, or an empty box, no answers.  (4) Under a pose the triangles are the exact images
// (space/bvh/posed_mesh.hpp).
// Numbers that are no shape throw as intersects does ("intersects: sphere.radius is nan, ..."), of an empty mesh too;
// progress may stop a batch.
// Source: RTCD 3.2, 4.2.6, 5.2, 6.3.1.
// Cost: one exact test of box against shape for each child of a node that is entered, of a convex region one for each
// halfspace; intersects for the triangles of leaves, a corner's location first; under a pose some 100 ns more for each
// node, and below a microsecond for a triangle that doubles decide.  Bounded by n tests of triangles, on
// integers as long as the exponents' span.
#pragma once

#include <concepts>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/space/bvh/mesh_view.hpp"
#include "plumb/space/bvh/progress.hpp"

namespace plumb {

template <class Shape>
concept RangeShape = std::same_as<Shape, Aabb3> || std::same_as<Shape, Obb3> || std::same_as<Shape, Sphere3> ||
    std::same_as<Shape, Capsule3> || std::same_as<Shape, Segment3> || std::same_as<Shape, Halfspace3> ||
    std::same_as<Shape, HalfspaceIntersection3>;

struct RangeOptions {
  Execution execution = Execution::parallel;
  Progress progress = {};
};

template <RangeShape Shape>
std::vector<std::uint32_t> meeting(const MeshView& mesh, const Shape& shape, std::vector<std::uint32_t> rows = {});

/// Of each shape.
template <RangeShape Shape>
std::vector<std::vector<std::uint32_t>> meeting(const MeshView& mesh, std::span<const Shape> shapes,
                                                const RangeOptions& options = {},
                                                std::vector<std::vector<std::uint32_t>> rows = {});

}  // namespace plumb
