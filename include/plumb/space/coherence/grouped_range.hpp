// Query grouping: which triangles do many boxes or segments meet that lie near each other?  They descend together.
//
//   grouped_meeting(bvh, std::span<const Aabb3>(boxes))      // of each box, as meeting
//   VisitStamps seen;                                                  // one for each mesh that goes on being asked
//   meeting_any(bvh, std::span<const Aabb3>(boxes), seen)    // of all together, each triangle once
//
// Shapes that are near each other make groups, of which the box around all descends; only triangles of the leaves where
// it ends are asked about each.
// Laws: (1) the answers are those of meeting (plumb/space/range/range_search.hpp), exactly; those of any are
// their union, ascending.  (2) They do not depend on the groups, execution or threads.  (3) Any stamps will do: they
// are made to fit the mesh.
// Errors are those of meeting.
// Source: RTCD 6.6.7, 7.7.
// Cost: the shapes are sorted by Morton codes; a comparison of boxes for each child of a node that a group enters, and
// for each shape of it and triangle that its box meets.  Of any a triangle that has been found is not asked again.
// Bounded by n tests of triangles for each shape, on integers as long as the exponents' span.
#pragma once

#include <concepts>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/space/coherence/visit_stamps.hpp"
#include "plumb/space/range/range_search.hpp"

namespace plumb {

template <class Shape>
concept GroupedShape = std::same_as<Shape, Aabb3> || std::same_as<Shape, Segment3>;

/// Of each shape.
template <GroupedShape Shape>
std::vector<std::vector<std::uint32_t>> grouped_meeting(const Bvh& mesh, std::span<const Shape> shapes,
                                                        const RangeOptions& options = {},
                                                        std::vector<std::vector<std::uint32_t>> rows = {});

/// Of all shapes; on one thread.
template <GroupedShape Shape>
std::vector<std::uint32_t> meeting_any(const Bvh& mesh, std::span<const Shape> shapes, VisitStamps& seen,
                                       std::vector<std::uint32_t> rows = {});

}  // namespace plumb
