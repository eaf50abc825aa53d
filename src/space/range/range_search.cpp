// Nodes whose boxes, as doubles outside of them, the shape meets exactly; then triangles by their corners or by intersects,
// under a pose by their exact images.
#include "plumb/space/range/range_search.hpp"

#include <algorithm>

#include "plumb/space/bvh/descend.hpp"
#include "plumb/space/bvh/descend_compact.hpp"
#include "space/bvh/mesh_source.hpp"
#include "space/bvh/parts.hpp"
#include "space/bvh/slot_triangles.hpp"
#include "space/range/range_tests.hpp"

namespace plumb {
namespace space {
namespace {

template <class Source, class Shape>
auto entered_by(const Source& source, const Shape& shape) {
  if constexpr (is_posed_source<Source>) {
    return [&source, &shape](const BoxNode& node) {
      const Aabb3 box = around(source, node);
      return !is_bounded(box) || may_meet(box, shape);
    };
  } else {
    return node_may_meet(source.tree.frame, shape);
  }
}

template <class Source, class Shape>
std::vector<std::uint32_t> found(const Source& source, const Shape& shape, std::vector<std::uint32_t> items) {
  items.clear();
  (void)intersects(Aabb3{{0, 0, 0}, {0, 0, 0}}, shape);  // throws where the numbers are no shape
  const SlotTriangles triangles(mesh_of(source));
  descend(mesh_of(source).tree, entered_by(source, shape), [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t slot = first; slot < first + count; ++slot) {
      const auto t = triangles.of(source, slot);
      const Aabb3 box = box_of(t);
      if (is_bounded(box) && !may_meet(box, shape)) continue;
      if (meets_triangle(t, shape)) items.push_back(triangles.number(slot));
    }
  });
  std::ranges::sort(items);
  items.erase(std::unique(items.begin(), items.end()), items.end());  // an item may be in several slots
  return items;
}

template <class Source, class Shape>
std::vector<std::vector<std::uint32_t>> found_of_each(const Source& source, std::span<const Shape> shapes,
                                                      const RangeOptions& options,
                                                      std::vector<std::vector<std::uint32_t>> all) {
  all.resize(shapes.size());
  constexpr std::size_t part_size = 8;
  const std::size_t parts = blocks_of(shapes.size(), part_size);
  for_parts("meeting", options.execution, options.progress, parts, [&](std::size_t part) {
    const std::size_t to = std::min(shapes.size(), (part + 1) * part_size);
    for (std::size_t i = part * part_size; i < to; ++i) all[i] = found(source, shapes[i], std::move(all[i]));
  });
  return all;
}

}  // namespace
}  // namespace space

template <RangeShape Shape>
std::vector<std::uint32_t> meeting(const MeshView& mesh, const Shape& shape, std::vector<std::uint32_t> rows) {
  return space::with_source("meeting", "mesh", mesh,
                            [&](const auto& source) { return space::found(source, shape, std::move(rows)); });
}

template <RangeShape Shape>
std::vector<std::vector<std::uint32_t>> meeting(const MeshView& mesh, std::span<const Shape> shapes,
                                                const RangeOptions& options,
                                                std::vector<std::vector<std::uint32_t>> rows) {
  return space::with_source("meeting", "mesh", mesh, [&](const auto& source) {
    return space::found_of_each(source, shapes, options, std::move(rows));
  });
}

#define PLUMB_RANGE_SHAPE(Shape)                                                                          \
  template std::vector<std::uint32_t> meeting(const MeshView&, const Shape&, std::vector<std::uint32_t>); \
  template std::vector<std::vector<std::uint32_t>> meeting(                                               \
      const MeshView&, std::span<const Shape>, const RangeOptions&, std::vector<std::vector<std::uint32_t>>);
PLUMB_RANGE_SHAPE(Aabb3)
PLUMB_RANGE_SHAPE(Obb3)
PLUMB_RANGE_SHAPE(Sphere3)
PLUMB_RANGE_SHAPE(Capsule3)
PLUMB_RANGE_SHAPE(Segment3)
PLUMB_RANGE_SHAPE(Halfspace3)
PLUMB_RANGE_SHAPE(HalfspaceIntersection3)
#undef PLUMB_RANGE_SHAPE

}  // namespace plumb
