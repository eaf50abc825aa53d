#include "plumb/space/kd_tree/point_range.hpp"

#include <algorithm>
#include <string>

#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error.hpp"
#include "space/bvh/blocks.hpp"
#include "space/kd_tree/point_search.hpp"
#include "space/kd_tree/query_order.hpp"

namespace plumb {
namespace space::kd {

/// Of one block: lists in the order in which they were asked for.
struct ListBlock {
  std::vector<std::uint32_t> numbers;
  std::vector<std::size_t> start;  // of each query's list, by its place in the block
  std::vector<std::size_t> size;
};

namespace {

void require_radius(double radius) {
  if (!(radius - radius == 0))
    throw NonFinite("within: radius is " + std::to_string(radius) + ", not a real number; give a finite double");
  if (radius < 0) throw InvalidShape("within: radius is " + std::to_string(radius) + ", but it must not be negative");
}

/// Ascending: few by insertion, as most lists are.
void sort_from(std::vector<std::uint32_t>& numbers, std::size_t from) {
  constexpr std::size_t few = 24;
  const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(from);
  if (numbers.size() - from > few) {
    std::sort(first, numbers.end());
    return;
  }
  for (std::size_t i = from + 1; i < numbers.size(); ++i) {
    const std::uint32_t x = numbers[i];
    std::size_t k = i;
    for (; k > from && numbers[k - 1] > x; --k) numbers[k] = numbers[k - 1];
    numbers[k] = x;
  }
}

/// add(query, numbers) for each query, in the order of keys where there are any.
template <class Keys, class Add>
ListBlock asked(const Keys& keys, const Add& add) {
  ListBlock block;
  block.start.resize(keys.size()), block.size.resize(keys.size());
  for (const auto key : keys) {
    const auto number = static_cast<std::uint32_t>(key);
    const std::size_t start = block.numbers.size();
    add(number, block.numbers);
    sort_from(block.numbers, start);
    block.start[number] = start, block.size[number] = block.numbers.size() - start;
  }
  return block;
}

PointLists put_together(std::size_t n, std::size_t block_size, const std::vector<ListBlock>& blocks) {
  PointLists lists;
  lists.first.clear();
  lists.first.reserve(n + 1);
  std::size_t total = 0;
  for (const ListBlock& b : blocks) total += b.numbers.size();
  lists.numbers.resize(total);
  std::size_t end = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const ListBlock& b = blocks[i / block_size];
    const std::size_t start = b.start[i % block_size], size = b.size[i % block_size];
    lists.first.push_back(end);
    for (std::size_t k = 0; k < size; ++k) lists.numbers[end + k] = b.numbers[start + k];
    end += size;
  }
  lists.first.push_back(end);
  return lists;
}

constexpr std::size_t block_size = 1 << 12;

}  // namespace
}  // namespace space::kd

template <class Point>
std::vector<std::uint32_t> within(const KdTree<Point>& tree, const std::type_identity_t<Point>& p, double radius) {
  space::kd::require_radius(radius);
  require_finite_parts<Point>("within", {"p"}, p);
  std::vector<std::uint32_t> numbers;
  if (tree.count != 0) space::kd::add_within(tree, p, radius, numbers);
  space::kd::sort_from(numbers, 0);
  return numbers;
}

template <class Point>
std::vector<std::uint32_t> in_box(const KdTree<Point>& tree, const space::BoxOf<Point>& box) {
  require_finite_parts<Point, Point>("in_box", {"box.min", "box.max"}, box.min, box.max);
  std::vector<std::uint32_t> numbers;
  if (tree.count != 0) space::kd::add_in_box(tree, box, numbers);
  space::kd::sort_from(numbers, 0);
  return numbers;
}

template <class Point>
PointLists within(const KdTree<Point>& tree, std::span<const std::type_identity_t<Point>> queries, double radius,
                  Execution execution) {
  using namespace space::kd;
  require_radius(radius);
  require_finite_points("within", "queries", queries);
  std::vector<ListBlock> blocks(space::blocks_of(queries.size(), block_size));
  space::for_blocks(execution, queries.size(), block_size, [&](std::size_t b, std::size_t from, std::size_t to) {
    in_query_order(tree, queries.subspan(from, to - from), Execution::serial,
                   [&](std::size_t, std::span<const std::uint64_t> keys) {
                     blocks[b] = asked(keys, [&](std::uint32_t i, std::vector<std::uint32_t>& numbers) {
                       if (tree.count != 0) add_within(tree, queries[from + i], radius, numbers);
                     });
                   });
  });
  return put_together(queries.size(), block_size, blocks);
}

template <class Point>
PointLists in_box(const KdTree<Point>& tree, std::span<const space::BoxOf<Point>> boxes, Execution execution) {
  using namespace space::kd;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const std::string box = "boxes[" + std::to_string(i) + "]", min = box + ".min", max = box + ".max";
    require_finite_parts<Point, Point>("in_box", {min, max}, boxes[i].min, boxes[i].max);
  }
  std::vector<ListBlock> blocks(space::blocks_of(boxes.size(), block_size));
  space::for_blocks(execution, boxes.size(), block_size, [&](std::size_t b, std::size_t from, std::size_t to) {
    std::vector<std::uint32_t> keys(to - from);
    for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = static_cast<std::uint32_t>(i);
    blocks[b] = asked(keys, [&](std::uint32_t i, std::vector<std::uint32_t>& numbers) {
      if (tree.count != 0) add_in_box<Point>(tree, boxes[from + i], numbers);
    });
  });
  return put_together(boxes.size(), block_size, blocks);
}

#define PLUMB_INSTANTIATE(P)                                                            \
  template std::vector<std::uint32_t> within(const KdTree<P>&, const P&, double);       \
  template std::vector<std::uint32_t> in_box(const KdTree<P>&, const space::BoxOf<P>&); \
  template PointLists within(const KdTree<P>&, std::span<const P>, double, Execution);  \
  template PointLists in_box(const KdTree<P>&, std::span<const space::BoxOf<P>>, Execution);
PLUMB_INSTANTIATE(Point2)
PLUMB_INSTANTIATE(Point3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
