// Nodes whose posed boxes the shape meets; then triangles by their exact images.
#include "plumb/space/range/posed_range.hpp"

#include <algorithm>

#include "plumb/query/overlap/overlap.hpp"
#include "plumb/space/bvh/descend.hpp"
#include "plumb/space/bvh/descend_compact.hpp"
#include "query/overlap/posed_triangles.hpp"
#include "space/bvh/parts.hpp"
#include "space/bvh/posed_box.hpp"

namespace plumb {
namespace space {
namespace {

/// Of a region only its halfspaces one by one.
template <class Shape>
bool may_meet_posed(const Aabb3& box, const Shape& shape) {
  if (!is_bounded(box)) return true;
  if constexpr (std::same_as<Shape, HalfspaceIntersection3>) {
    return std::ranges::all_of(shape.halfspaces, [&](const Halfspace3& h) { return intersects(h, box); });
  } else {
    return intersects(box, shape);
  }
}

template <class Mesh, class Shape>
std::vector<std::uint32_t> posed_found(const PosedMeshOf<Mesh>& mesh, const Shape& shape,
                                       std::vector<std::uint32_t> items) {
  items.clear();
  (void)intersects(Aabb3{{0, 0, 0}, {0, 0, 0}}, shape);  // throws where the numbers are no shape
  descend(
      mesh.bvh.tree, [&](const BoxNode& node) { return may_meet_posed(around(mesh, node), shape); },
      [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
          const PosedTriangle triangle = mesh.triangle(slot);
          if (may_meet_posed(around(triangle), shape) && query::intersects(triangle, shape))
            items.push_back(mesh.bvh.number(slot));
        }
      });
  std::ranges::sort(items);
  items.erase(std::unique(items.begin(), items.end()), items.end());  // an item may be in several slots
  return items;
}

template <class Mesh, class Shape>
std::vector<std::vector<std::uint32_t>> posed_found_of_each(const PosedMeshOf<Mesh>& mesh,
                                                            std::span<const Shape> shapes, const RangeOptions& options,
                                                            std::vector<std::vector<std::uint32_t>> all) {
  require_pose("triangles_meeting", "mesh", mesh.pose);
  all.resize(shapes.size());
  constexpr std::size_t part_size = 4;
  const std::size_t parts = blocks_of(shapes.size(), part_size);
  for_parts("triangles_meeting", options.execution, options.progress, parts, [&](std::size_t part) {
    const std::size_t to = std::min(shapes.size(), (part + 1) * part_size);
    for (std::size_t i = part * part_size; i < to; ++i) all[i] = posed_found(mesh, shapes[i], std::move(all[i]));
  });
  return all;
}

}  // namespace
}  // namespace space

template <RangeShape Shape>
std::vector<std::uint32_t> triangles_meeting(const PosedMesh& mesh, const Shape& shape,
                                             std::vector<std::uint32_t> rows) {
  space::require_pose("triangles_meeting", "mesh", mesh.pose);
  return space::posed_found(mesh, shape, std::move(rows));
}
template <RangeShape Shape>
std::vector<std::uint32_t> triangles_meeting(const PosedCompactMesh& mesh, const Shape& shape,
                                             std::vector<std::uint32_t> rows) {
  space::require_pose("triangles_meeting", "mesh", mesh.pose);
  return space::posed_found(mesh, shape, std::move(rows));
}

template <RangeShape Shape>
std::vector<std::vector<std::uint32_t>> triangles_meeting(const PosedMesh& mesh, std::span<const Shape> shapes,
                                                          const RangeOptions& options,
                                                          std::vector<std::vector<std::uint32_t>> rows) {
  return space::posed_found_of_each(mesh, shapes, options, std::move(rows));
}
template <RangeShape Shape>
std::vector<std::vector<std::uint32_t>> triangles_meeting(const PosedCompactMesh& mesh, std::span<const Shape> shapes,
                                                          const RangeOptions& options,
                                                          std::vector<std::vector<std::uint32_t>> rows) {
  return space::posed_found_of_each(mesh, shapes, options, std::move(rows));
}

#define PLUMB_POSED_RANGE_MESH(Mesh, Shape)                                                                     \
  template std::vector<std::uint32_t> triangles_meeting(const Mesh&, const Shape&, std::vector<std::uint32_t>); \
  template std::vector<std::vector<std::uint32_t>> triangles_meeting(                                           \
      const Mesh&, std::span<const Shape>, const RangeOptions&, std::vector<std::vector<std::uint32_t>>);
#define PLUMB_POSED_RANGE_SHAPE(Shape) \
  PLUMB_POSED_RANGE_MESH(PosedMesh, Shape) PLUMB_POSED_RANGE_MESH(PosedCompactMesh, Shape)
PLUMB_POSED_RANGE_SHAPE(Aabb3)
PLUMB_POSED_RANGE_SHAPE(Obb3)
PLUMB_POSED_RANGE_SHAPE(Sphere3)
PLUMB_POSED_RANGE_SHAPE(Capsule3)
PLUMB_POSED_RANGE_SHAPE(Segment3)
PLUMB_POSED_RANGE_SHAPE(Halfspace3)
PLUMB_POSED_RANGE_SHAPE(HalfspaceIntersection3)
#undef PLUMB_POSED_RANGE_SHAPE
#undef PLUMB_POSED_RANGE_MESH

}  // namespace plumb
