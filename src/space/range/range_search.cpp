// Nodes whose boxes, as doubles outside of them, the shape meets exactly; then triangles by their corners or by intersects.
#include "plumb/space/range/range_search.hpp"

#include <algorithm>

#include "plumb/space/bvh/descend.hpp"
#include "space/bvh/parts.hpp"
#include "space/bvh/slot_boxes.hpp"
#include "space/range/range_tests.hpp"

namespace plumb {
namespace space {
namespace {

template <class Shape>
std::vector<std::uint32_t> found(const Bvh& mesh, const Shape& shape) {
  (void)intersects(Aabb3{{0, 0, 0}, {0, 0, 0}}, shape);  // throws where the numbers are no shape
  std::vector<std::uint32_t> items;
  const BoxFrame& frame = mesh.tree.frame;
  const std::span<const Point3> vertices = mesh.vertices.view();
  descend(
      mesh.tree, [&](const BoxNode& node) { return may_meet(frame.outside(node.box()), shape); },
      [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
          if (!may_meet(box_around(mesh.triangles[slot], vertices), shape)) continue;
          if (meets_triangle(mesh.triangle(slot), shape)) items.push_back(mesh.tree.items[slot]);
        }
      });
  std::ranges::sort(items);
  return items;
}

}  // namespace
}  // namespace space

template <RangeShape Shape>
std::vector<std::uint32_t> triangles_meeting(const Bvh& mesh, const Shape& shape) {
  return space::found(mesh, shape);
}

template <RangeShape Shape>
std::vector<std::vector<std::uint32_t>> triangles_meeting(const Bvh& mesh, std::span<const Shape> shapes,
                                                          const RangeOptions& options) {
  std::vector<std::vector<std::uint32_t>> all(shapes.size());
  constexpr std::size_t part_size = 8;
  const std::size_t parts = space::blocks_of(shapes.size(), part_size);
  space::for_parts("triangles_meeting", options.execution, options.progress, parts, [&](std::size_t part) {
    const std::size_t to = std::min(shapes.size(), (part + 1) * part_size);
    for (std::size_t i = part * part_size; i < to; ++i) all[i] = space::found(mesh, shapes[i]);
  });
  return all;
}

#define PLUMB_RANGE_SHAPE(Shape)                                                                         \
  template std::vector<std::uint32_t> triangles_meeting(const Bvh&, const Shape&);                       \
  template std::vector<std::vector<std::uint32_t>> triangles_meeting(const Bvh&, std::span<const Shape>, \
                                                                     const RangeOptions&);
PLUMB_RANGE_SHAPE(Aabb3)
PLUMB_RANGE_SHAPE(Obb3)
PLUMB_RANGE_SHAPE(Sphere3)
PLUMB_RANGE_SHAPE(Capsule3)
PLUMB_RANGE_SHAPE(Segment3)
PLUMB_RANGE_SHAPE(Halfspace3)
PLUMB_RANGE_SHAPE(HalfspaceIntersection3)
#undef PLUMB_RANGE_SHAPE

}  // namespace plumb
