#include "plumb/space/bvh/build.hpp"

#include <cmath>
#include <string>

#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/space/bvh/bvh.hpp"
#include "space/bvh/builders.hpp"
#include "space/bvh/checked_box.hpp"
#include "space/bvh/slot_boxes.hpp"
#include "space/bvh/split_items.hpp"

namespace plumb {
namespace {

using space::BoxedItem;

constexpr std::size_t box_block = 1 << 14;
constexpr std::size_t most_items = std::size_t{1} << 31;

void check(const std::string& function, const BvhOptions& options, std::size_t items) {
  if (items > most_items) {
    throw InvalidShape(function + ": " + std::to_string(items) + " items are more than 2^31; build several trees");
  }
  space::check_options(function, options);
}

BoxTree build(std::vector<BoxedItem> items, const BoxFrame& frame, const BvhOptions& options) {
  BoxTree tree;
  tree.frame = frame;
  if (items.empty()) return tree;
  space::Built built = space::build(std::move(items), options);
  tree.nodes = std::move(built.nodes);
  tree.items = std::move(built.items);
  return tree;
}

BoxTree split_tree(std::span<const BoxedItem> whole, const BoxFrame& frame, std::span<const Point3> vertices,
                   std::span<const Bvh::Corners> triangles, const BvhOptions& options) {
  BoxTree tree;
  tree.frame = frame;
  if (whole.empty()) return tree;
  space::SplitItems parts =
      space::split_items(whole, frame, vertices, triangles, options.split_share, options.execution);
  check("build_bvh", options, parts.items.size());
  space::Built built = space::build(std::move(parts.items), options);
  space::join_parts(built, parts.triangles);
  tree.nodes = std::move(built.nodes);
  tree.items = std::move(built.items);
  return tree;
}

/// box_of(i) is a FloatBox3.
template <class BoxOf>
std::vector<BoxedItem> boxed(Execution execution, std::size_t n, const BoxOf& box_of) {
  std::vector<BoxedItem> items(n);
  space::for_blocks(execution, n, box_block, [&](std::size_t, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      const FloatBox3 box = box_of(i);
      items[i] = {box.min, static_cast<std::uint32_t>(i), box.max, 0};
    }
  });
  return items;
}

// Each vertex is rounded once, though six triangles have it: rounding is monotone, so theirs are the boxes of what is
// rounded.
std::vector<BoxedItem> boxed(Execution execution, const BoxFrame& frame, std::span<const Point3> vertices,
                             std::span<const Bvh::Corners> triangles) {
  const std::vector<BoxedItem> rounded = boxed(execution, vertices.size(), [&](std::size_t i) {
    return frame.around({vertices[i], vertices[i]});
  });
  return boxed(execution, triangles.size(), [&](std::size_t i) {
    space::Extent box;
    for (const std::uint32_t corner : triangles[i]) box.take(rounded[corner].low(), rounded[corner].high());
    return space::box_of(box);
  });
}

void check_indices(std::span<const Bvh::Corners> triangles, std::size_t vertices) {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Bvh::Corners& c = triangles[t];
    if (std::max({c[0], c[1], c[2]}) < vertices) continue;
    const std::size_t k = c[0] >= vertices ? 0 : c[1] >= vertices ? 1 : 2;
    throw InvalidShape("build_bvh: triangles[" + std::to_string(t) + "][" + std::to_string(k) + "] is " +
                       std::to_string(c[k]) + ", but there are " + std::to_string(vertices) + " vertices");
  }
}

}  // namespace

std::string_view name_of(BvhMethod method) {
  switch (method) {
    case BvhMethod::binned:
      return "binned";
    case BvhMethod::sweep:
      return "sweep";
    case BvhMethod::object_median:
      return "object median";
    case BvhMethod::object_mean:
      return "object mean";
    case BvhMethod::spatial_median:
      return "spatial median";
    case BvhMethod::linear:
      return "linear";
    case BvhMethod::agglomerative:
      return "agglomerative";
    case BvhMethod::nearest_pairs:
      return "nearest pairs";
    case BvhMethod::insertion:
      return "insertion";
  }
  return "unknown";
}

BoxTree build_box_tree(std::span<const Aabb3> boxes, const BvhOptions& options) {
  check("build_box_tree", options, boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!space::is_sound(boxes[i])) space::check_box("build_box_tree", "boxes[" + std::to_string(i) + "]", boxes[i]);
  }
  const BoxFrame frame = space::frame_of(options.execution, boxes);
  return build(boxed(options.execution, boxes.size(), [&](std::size_t i) { return frame.around(boxes[i]); }), frame,
               options);
}

Bvh build_bvh(std::span<const Point3> vertices, std::span<const Bvh::Corners> triangles, const BvhOptions& options) {
  check("build_bvh", options, triangles.size());
  figure::require_finite_points("build_bvh", "vertices", vertices);
  check_indices(triangles, vertices.size());
  Bvh bvh;
  const BoxFrame frame = space::frame_of(options.execution, vertices);
  std::vector<BoxedItem> items = boxed(options.execution, frame, vertices, triangles);
  if (options.split_share > 0) {
    bvh.tree = split_tree(items, frame, vertices, triangles, options);
  } else {
    bvh.tree = build(std::move(items), frame, options);
  }
  const std::span<const std::uint32_t> order = bvh.tree.items.view();
  std::vector<Bvh::Corners> laid_out(order.size());
  space::for_blocks(options.execution, order.size(), box_block, [&](std::size_t, std::size_t from, std::size_t to) {
    for (std::size_t slot = from; slot < to; ++slot) laid_out[slot] = triangles[order[slot]];
  });
  bvh.triangles = std::move(laid_out);
  bvh.vertices = std::vector<Point3>(vertices.begin(), vertices.end());
  widen(bvh, options.execution);
  return bvh;
}

Bvh build_bvh(const TriangleMesh& mesh, const BvhOptions& options) {
  return build_bvh(mesh.vertices, mesh.triangles, options);
}

void widen(Bvh& bvh, Execution execution) { bvh.wide = widen<8>(bvh.tree, 8, execution); }

std::size_t memory_of(const BoxTree& tree) {
  return tree.nodes.size() * sizeof(BoxNode) + tree.items.size() * sizeof(std::uint32_t);
}

std::size_t memory_of(const Bvh& bvh) {
  return memory_of(bvh.tree) + bvh.triangles.size() * sizeof(Bvh::Corners) + bvh.vertices.size() * sizeof(Point3) +
         bvh.wide.nodes.size() * sizeof(WideNode<8>);
}

}  // namespace plumb
