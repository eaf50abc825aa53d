#include "plumb/space/grid/implicit_grid.hpp"

#include <bit>

#include "space/bvh/parts.hpp"
#include "space/grid/grid_boxes.hpp"

namespace plumb {
namespace {

std::size_t checked_rows(const ImplicitGridOptions& options) {
  if (std::has_single_bit(options.rows) && options.rows <= std::size_t{1} << 30) return options.rows;
  throw InvalidShape("ImplicitGrid: options.rows is " + std::to_string(options.rows) +
                     ", but it must be a power of two up to 2^30");
}

}  // namespace

template <class Box>
ImplicitGrid<Box>::ImplicitGrid(double cell_size, const ImplicitGridOptions& options)
    : options_(options),
      size_(cell_size),
      per_size_(space::per_cell_size("ImplicitGrid", cell_size, "cell_size")),
      rows_(checked_rows(options)) {}

template <class Box>
std::uint32_t ImplicitGrid<Box>::insert(const Box& box) {
  space::require_grid_box("ImplicitGrid::insert", "box", box);
  if (boxes_.next() >= rows_.slots()) {
    const std::size_t slots = std::bit_ceil(std::size_t{boxes_.next()} + 1);
    space::require_memory("ImplicitGrid::insert", space::BitRows<n>::memory_of(options_.rows, slots),
                          options_.most_memory, "choose fewer rows");
    rows_.reserve(slots);
  }
  const std::uint32_t handle = boxes_.add(box);
  rows_.set(handle, space::cells_of(box, per_size_), true);
  return handle;
}

template <class Box>
void ImplicitGrid<Box>::remove(std::uint32_t handle) {
  if (!contains(handle)) throw space::not_in_grid("ImplicitGrid::remove", handle);
  rows_.set(handle, space::cells_of(boxes_[handle], per_size_), false);
  boxes_.release(handle);
}

template <class Box>
void ImplicitGrid<Box>::move(std::uint32_t handle, const Box& box) {
  if (!contains(handle)) throw space::not_in_grid("ImplicitGrid::move", handle);
  space::require_grid_box("ImplicitGrid::move", "box", box);
  const auto from = space::cells_of(boxes_[handle], per_size_), to = space::cells_of(box, per_size_);
  if (from != to) {
    rows_.set(handle, from, false);
    rows_.set(handle, to, true);
  }
  boxes_[handle] = box;
}

template <class Box>
std::vector<BoxPair> ImplicitGrid<Box>::overlapping_pairs(const BoxPairOptions& options,
                                                          std::vector<BoxPair> rows) const {
  rows.clear();
  const std::size_t all = boxes_.numbers(), parts = (all + space::boxes_in_part - 1) / space::boxes_in_part;
  std::vector<std::vector<BoxPair>> found(parts);
  space::for_parts("ImplicitGrid::pairs", options.execution, {}, parts, [&](std::size_t part) {
    std::vector<std::uint64_t> both, one;
    const std::size_t end = part + 1 == parts ? all : (part + 1) * space::boxes_in_part;
    for (std::size_t i = part * space::boxes_in_part; i < end; ++i) {
      const auto a = static_cast<std::uint32_t>(i);
      if (!contains(a)) continue;
      rows_.for_common(space::cells_of(boxes_[a], per_size_), i + 1, all, both, one, [&](std::size_t j) {
        const auto b = static_cast<std::uint32_t>(j);
        if (space::is_pair(boxes_[a], boxes_[b], options.touching)) found[part].push_back({a, b});
      });
    }
  });
  for (const auto& f : found) rows.insert(rows.end(), f.begin(), f.end());
  return rows;
}

template <class Box>
std::vector<std::uint32_t> ImplicitGrid<Box>::in_box(const Box& box, const InBoxOptions& options,
                                                     std::vector<std::uint32_t> rows) const {
  rows.clear();
  if (!space::may_hold("ImplicitGrid::in_box", box)) return rows;
  std::vector<std::uint64_t> both, one;
  rows_.for_common(space::cells_of(box, per_size_), 0, boxes_.numbers(), both, one, [&](std::size_t j) {
    const auto b = static_cast<std::uint32_t>(j);
    if (space::is_pair(box, boxes_[b], options.touching)) rows.push_back(b);
  });
  return rows;
}

template class ImplicitGrid<Aabb2>;
template class ImplicitGrid<Aabb3>;

}  // namespace plumb
