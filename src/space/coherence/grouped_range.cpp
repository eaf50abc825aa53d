// Groups of shapes by Morton order; one descent each.
#include "plumb/space/coherence/grouped_range.hpp"

#include <algorithm>
#include <cstddef>

#include "plumb/space/bvh/build.hpp"
#include "plumb/space/bvh/descend.hpp"
#include "space/bvh/parts.hpp"
#include "space/bvh/posed_box.hpp"
#include "space/bvh/slot_boxes.hpp"
#include "space/range/range_tests.hpp"

namespace plumb {
namespace space {
namespace {

const Aabb3& box_of_shape(const Aabb3& box) { return box; }
Aabb3 box_of_shape(const Segment3& s) { return box_around(s.a, s.b, s.b); }
bool is_empty_box(const Aabb3& b) { return b.min.x > b.max.x || b.min.y > b.max.y || b.min.z > b.max.z; }

/// Members of `order`, from here on, and the box around them.
struct ShapeGroup {
  std::size_t from, to;
  Aabb3 box;
};

struct ShapeGroups {
  std::vector<std::uint32_t> order;  // numbers of shapes that are not empty
  std::vector<ShapeGroup> groups;
};

/// As many as one box does not make much more to look at than each its own; guesses.
constexpr std::size_t most_in_group = 32;
constexpr double most_group_growth = 2;

/// Without the frame: a size to compare.
double half_area(const Aabb3& b) {
  const double x = b.max.x - b.min.x, y = b.max.y - b.min.y, z = b.max.z - b.min.z;
  return x * y + y * z + z * x;
}
double longest_side(const Aabb3& b) { return std::max({b.max.x - b.min.x, b.max.y - b.min.y, b.max.z - b.min.z}); }

template <class Shape>
ShapeGroups grouped(std::span<const Shape> shapes, Execution execution) {
  std::vector<Aabb3> boxes;
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < shapes.size(); ++i) {
    (void)intersects(Aabb3{{0, 0, 0}, {0, 0, 0}}, shapes[i]);  // throws where the numbers are no shape
    if (is_empty_box(box_of_shape(shapes[i]))) continue;
    boxes.push_back(box_of_shape(shapes[i]));
    numbers.push_back(i);
  }
  ShapeGroups all;
  const BoxTree near = build_box_tree(boxes, {.method = BvhMethod::linear, .execution = execution});
  double areas = 0, sides = 0;
  for (const std::uint32_t item : near.items.view()) {
    const Aabb3& box = boxes[item];
    const std::size_t at = all.order.size();
    all.order.push_back(numbers[item]);
    areas += half_area(box);
    sides += longest_side(box);
    if (!all.groups.empty()) {
      ShapeGroup& last = all.groups.back();
      const Aabb3 both = merged(last.box, box);
      if (at - last.from < most_in_group && half_area(both) <= most_group_growth * areas &&
          longest_side(both) <= most_group_growth * sides) {
        last.to = at + 1;
        last.box = both;
        continue;
      }
    }
    all.groups.push_back({at, at + 1, box});
    areas = half_area(box);
    sides = longest_side(box);
  }
  return all;
}

/// visit(slot, box of its triangle) of all triangles of the leaves that the box meets, whose boxes it meets.
template <class Visit>
void visit_group(const Bvh& mesh, const Aabb3& box, const Visit& visit) {
  const std::span<const Point3> vertices = mesh.vertices.view();
  descend(mesh.tree, node_may_meet(mesh.tree.frame, box), [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t slot = first; slot < first + count; ++slot) {
      const Aabb3 around_triangle = box_around(mesh.triangles[slot], vertices);
      if (boxes_meet(around_triangle, box)) visit(slot, around_triangle);
    }
  });
}

template <class Shape>
bool meets_slot(const Bvh& mesh, std::uint32_t slot, const Aabb3& around_triangle, const Shape& shape) {
  return boxes_meet(around_triangle, box_of_shape(shape)) && may_meet(around_triangle, shape) &&
         meets_triangle(mesh.triangle(slot), shape);
}

template <class Shape>
std::vector<std::vector<std::uint32_t>> found_of_each(const Bvh& mesh, std::span<const Shape> shapes,
                                                      const RangeOptions& options,
                                                      std::vector<std::vector<std::uint32_t>> found) {
  const ShapeGroups all = grouped(shapes, options.execution);
  found.resize(shapes.size());
  for (auto& list : found) list.clear();
  for_parts("meeting", options.execution, options.progress, all.groups.size(), [&](std::size_t part) {
    const ShapeGroup& group = all.groups[part];
    const std::span<const std::uint32_t> members(all.order.data() + group.from, group.to - group.from);
    visit_group(mesh, group.box, [&](std::uint32_t slot, const Aabb3& box) {
      for (const std::uint32_t i : members) {
        if (meets_slot(mesh, slot, box, shapes[i])) found[i].push_back(mesh.tree.items[slot]);
      }
    });
    for (const std::uint32_t i : members) {
      std::ranges::sort(found[i]);
      found[i].erase(std::unique(found[i].begin(), found[i].end()), found[i].end());  // in several slots
    }
  });
  return found;
}

template <class Shape>
std::vector<std::uint32_t> found_of_any(const Bvh& mesh, std::span<const Shape> shapes, VisitStamps& seen,
                                        std::vector<std::uint32_t> found) {
  found.clear();
  if (seen.size() != mesh.triangles.size()) seen.reset(mesh.triangles.size());
  seen.begin();
  const ShapeGroups all = grouped(shapes, Execution::serial);
  for (const ShapeGroup& group : all.groups) {
    visit_group(mesh, group.box, [&](std::uint32_t slot, const Aabb3& box) {
      const std::uint32_t item = mesh.tree.items[slot];
      if (seen.visited(item)) return;
      for (std::size_t k = group.from; k < group.to; ++k) {
        if (!meets_slot(mesh, slot, box, shapes[all.order[k]])) continue;
        seen.visit(item);
        found.push_back(item);
        break;
      }
    });
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace
}  // namespace space

template <GroupedShape Shape>
std::vector<std::vector<std::uint32_t>> grouped_meeting(const Bvh& mesh, std::span<const Shape> shapes,
                                                        const RangeOptions& options,
                                                        std::vector<std::vector<std::uint32_t>> rows) {
  return space::found_of_each(mesh, shapes, options, std::move(rows));
}
template <GroupedShape Shape>
std::vector<std::uint32_t> meeting_any(const Bvh& mesh, std::span<const Shape> shapes, VisitStamps& seen,
                                       std::vector<std::uint32_t> rows) {
  return space::found_of_any(mesh, shapes, seen, std::move(rows));
}

#define PLUMB_GROUPED_SHAPE(Shape)                                                                       \
  template std::vector<std::vector<std::uint32_t>> grouped_meeting(                                      \
      const Bvh&, std::span<const Shape>, const RangeOptions&, std::vector<std::vector<std::uint32_t>>); \
  template std::vector<std::uint32_t> meeting_any(const Bvh&, std::span<const Shape>, VisitStamps&,      \
                                                  std::vector<std::uint32_t>);
PLUMB_GROUPED_SHAPE(Aabb3)
PLUMB_GROUPED_SHAPE(Segment3)
#undef PLUMB_GROUPED_SHAPE

}  // namespace plumb
