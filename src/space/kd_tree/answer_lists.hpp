// Lists of numbers that a batch is answered with, block by block, and what is asked of a batch.
//
// Law: each list ascends; the blocks are put together in the order of the queries.
// Cost: an insertion sort of few, a copy of all.
#pragma once

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/space/kd_tree/point_range.hpp"

namespace plumb::space::kd {

/// Of one block: lists in the order in which they were asked for.
struct ListBlock {
  std::vector<std::uint32_t> numbers;
  std::vector<std::size_t> start;  // of each query's list, by its place in the block
  std::vector<std::size_t> size;
};

inline void require_radius(double radius) {
  if (!(radius - radius == 0))
    throw NonFinite("within: radius is " + std::to_string(radius) + ", not a real number; give a finite double");
  if (radius < 0) throw InvalidShape("within: radius is negative; give zero or more");
}
template <class Box>
void require_finite_boxes(std::span<const Box> boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    using Point = std::remove_cvref_t<decltype(boxes[i].min)>;
    const std::string box = "boxes[" + std::to_string(i) + "]", min = box + ".min", max = box + ".max";
    require_finite_parts<Point, Point>("in_box", {min, max}, boxes[i].min, boxes[i].max);
  }
}

/// `noun` is what there are: a point, a figure.
inline void require_as_many(std::size_t k, std::size_t count, std::string_view noun) {
  if (k <= count && count != 0) return;
  throw InvalidShape("nearest: " + std::to_string(k) + " of " + std::to_string(count) + " " + std::string(noun) +
                     (count == 1 ? "" : "s") + " are asked for; there must be as many, and one at least");
}
inline void require_length(std::size_t expected, std::size_t n) {
  if (n == expected) return;
  throw UnequalLengths("nearest: out has " + std::to_string(n) + " items, but " + std::to_string(expected) +
                       " are asked for");
}

/// Ascending: few by insertion, as most lists are.
inline void sort_numbers(std::span<std::uint32_t> numbers) {
  constexpr std::size_t few = 24;
  if (numbers.size() > few) {
    std::sort(numbers.begin(), numbers.end());
    return;
  }
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    const std::uint32_t x = numbers[i];
    std::size_t k = i;
    for (; k > 0 && numbers[k - 1] > x; --k) numbers[k] = numbers[k - 1];
    numbers[k] = x;
  }
}
inline void sort_from(std::vector<std::uint32_t>& numbers, std::size_t from) {
  sort_numbers(std::span(numbers).subspan(from));
}

/// add(query, numbers) for each query in turn: it appends a list that ascends.
template <class Add>
ListBlock asked_in_turn(std::size_t n, const Add& add) {
  ListBlock block;
  for (std::size_t i = 0; i < n; ++i) {
    block.start.push_back(block.numbers.size());
    add(static_cast<std::uint32_t>(i), block.numbers);
    block.size.push_back(block.numbers.size() - block.start.back());
  }
  return block;
}

/// What is behind the copy may be overwritten: lists are copied in their order.
inline void copy_list(const std::vector<std::uint32_t>& from, std::size_t start, std::size_t size,
                      std::vector<std::uint32_t>& to, std::size_t end) {
  constexpr std::size_t few = 16;  // at once, so that no branch depends on the size of most lists
  for (std::size_t k = 0; k < size; k += few) {
    const bool is_room = start + k + few <= from.size() && end + k + few <= to.size();
    if (is_room) [[likely]] {
      std::memcpy(to.data() + end + k, from.data() + start + k, few * sizeof(std::uint32_t));
    } else {
      for (std::size_t i = k; i < size && i < k + few; ++i) to[end + i] = from[start + i];
    }
  }
}

inline PointLists put_together(std::size_t n, std::size_t block_size, const std::vector<ListBlock>& blocks,
                               PointLists lists = {}) {
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
    copy_list(b.numbers, start, size, lists.numbers, end);
    end += size;
  }
  lists.first.push_back(end);
  return lists;
}

}  // namespace plumb::space::kd
