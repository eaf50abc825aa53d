// Nodes whose boxes, as doubles outside of them, the shape meets exactly; then triangles by their corners or by intersects.
#include "plumb/space/range/range_search.hpp"

#include <algorithm>

#include "plumb/space/bvh/descend.hpp"
#include "plumb/space/bvh/descend_compact.hpp"
#include "space/bvh/parts.hpp"
#include "space/bvh/slot_triangles.hpp"
#include "space/range/range_tests.hpp"

namespace plumb {
namespace space {
namespace {

template <class Mesh, class Shape>
std::vector<std::uint32_t> found(const Mesh& mesh, const Shape& shape, std::vector<std::uint32_t> items) {
  items.clear();
  (void)intersects(Aabb3{{0, 0, 0}, {0, 0, 0}}, shape);  // throws where the numbers are no shape
  const SlotTriangles triangles(mesh);
  descend(mesh.tree, node_may_meet(mesh.tree.frame, shape), [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t slot = first; slot < first + count; ++slot) {
      const Triangle3 t = triangles.triangle(slot);
      if (!may_meet(box_around(t.a, t.b, t.c), shape)) continue;
      if (meets_triangle(t, shape)) items.push_back(triangles.number(slot));
    }
  });
  std::ranges::sort(items);
  items.erase(std::unique(items.begin(), items.end()), items.end());  // an item may be in several slots
  return items;
}

template <class Mesh, class Shape>
std::vector<std::vector<std::uint32_t>> found_of_each(const Mesh& mesh, std::span<const Shape> shapes,
                                                      const RangeOptions& options,
                                                      std::vector<std::vector<std::uint32_t>> all) {
  all.resize(shapes.size());
  constexpr std::size_t part_size = 8;
  const std::size_t parts = blocks_of(shapes.size(), part_size);
  for_parts("triangles_meeting", options.execution, options.progress, parts, [&](std::size_t part) {
    const std::size_t to = std::min(shapes.size(), (part + 1) * part_size);
    for (std::size_t i = part * part_size; i < to; ++i) all[i] = found(mesh, shapes[i], std::move(all[i]));
  });
  return all;
}

}  // namespace
}  // namespace space

template <RangeShape Shape>
std::vector<std::uint32_t> triangles_meeting(const Bvh& mesh, const Shape& shape, std::vector<std::uint32_t> rows) {
  return space::found(mesh, shape, std::move(rows));
}
template <RangeShape Shape>
std::vector<std::uint32_t> triangles_meeting(const CompactBvh& mesh, const Shape& shape,
                                             std::vector<std::uint32_t> rows) {
  return space::found(mesh, shape, std::move(rows));
}

template <RangeShape Shape>
std::vector<std::vector<std::uint32_t>> triangles_meeting(const Bvh& mesh, std::span<const Shape> shapes,
                                                          const RangeOptions& options,
                                                          std::vector<std::vector<std::uint32_t>> rows) {
  return space::found_of_each(mesh, shapes, options, std::move(rows));
}
template <RangeShape Shape>
std::vector<std::vector<std::uint32_t>> triangles_meeting(const CompactBvh& mesh, std::span<const Shape> shapes,
                                                          const RangeOptions& options,
                                                          std::vector<std::vector<std::uint32_t>> rows) {
  return space::found_of_each(mesh, shapes, options, std::move(rows));
}

#define PLUMB_RANGE_MESH(Mesh, Shape)                                                                           \
  template std::vector<std::uint32_t> triangles_meeting(const Mesh&, const Shape&, std::vector<std::uint32_t>); \
  template std::vector<std::vector<std::uint32_t>> triangles_meeting(                                           \
      const Mesh&, std::span<const Shape>, const RangeOptions&, std::vector<std::vector<std::uint32_t>>);
#define PLUMB_RANGE_SHAPE(Shape) PLUMB_RANGE_MESH(Bvh, Shape) PLUMB_RANGE_MESH(CompactBvh, Shape)
PLUMB_RANGE_SHAPE(Aabb3)
PLUMB_RANGE_SHAPE(Obb3)
PLUMB_RANGE_SHAPE(Sphere3)
PLUMB_RANGE_SHAPE(Capsule3)
PLUMB_RANGE_SHAPE(Segment3)
PLUMB_RANGE_SHAPE(Halfspace3)
PLUMB_RANGE_SHAPE(HalfspaceIntersection3)
#undef PLUMB_RANGE_SHAPE
#undef PLUMB_RANGE_MESH

}  // namespace plumb
