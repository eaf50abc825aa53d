// May what is in a box meet a shape; and does a triangle?
//
// Laws: (1) may_meet is true where anything in the box meets the shape.  (2) meets_triangle is intersects(t, shape), of a
// posed triangle that of its exact image.
// Source: RTCD 5.2.
// Cost: one exact test; of a convex region one for each halfspace.
#pragma once

#include <algorithm>
#include <concepts>

#include "plumb/figure/containment/contains.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/space/range/range_search.hpp"
#include "query/overlap/posed_triangles.hpp"
#include "space/bvh/slot_boxes.hpp"

namespace plumb::space {

/// May anything in the box meet the shape?  Of a region only its halfspaces one by one.
template <class Shape>
bool may_meet(const Aabb3& box, const Shape& shape) {
  if constexpr (std::same_as<Shape, HalfspaceIntersection3>) {
    return std::ranges::all_of(shape.halfspaces, [&](const Halfspace3& h) { return intersects(h, box); });
  } else if constexpr (std::same_as<Shape, Aabb3>) {
    return boxes_meet(box, shape);  // in registers: what has just been put together is not looked for in memory
  } else {
    return intersects(box, shape);
  }
}

/// The same of a tree's nodes.
template <class Shape>
auto node_may_meet(const BoxFrame& frame, const Shape& shape) {
  if constexpr (std::same_as<Shape, Aabb3>) {
    const auto [min, max] = frame.around(shape);
    return [asked = BoxNode{min, 0, max, 0}](const BoxNode& node) { return nodes_meet(node, asked); };
  } else {
    return [&frame, &shape](const BoxNode& node) { return may_meet(frame.outside(node.box()), shape); };
  }
}

template <class Shape>
bool meets_triangle(const Triangle3& t, const Shape& shape) {
  if constexpr (!std::same_as<Shape, Segment3>) {
    if (contains(shape, t.a)) return true;
  }
  if constexpr (std::same_as<Shape, HalfspaceIntersection3>) {
    if (!std::ranges::all_of(shape.halfspaces, [&](const Halfspace3& h) { return intersects(h, t); })) return false;
  }
  return intersects(t, shape);
}

template <class Shape>
bool meets_triangle(const PosedTriangle& t, const Shape& shape) {
  return query::intersects(t, shape);
}

}  // namespace plumb::space
