#include "plumb/space/octree/loose_octree.hpp"

#include <algorithm>
#include <string>

#include "space/grid/level_join.hpp"
#include "space/octree/box_sides.hpp"
#include "space/octree/cell_keys.hpp"
#include "space/octree/seen_cells.hpp"
#include "space/pairs/boxes_meet.hpp"

namespace plumb {
namespace {

constexpr std::uint32_t none = no_cell;
constexpr std::uint64_t root_code = 1;
constexpr std::size_t least_table = 16;

template <std::size_t D>
unsigned child_digit(std::uint64_t code) {
  return static_cast<unsigned>(code) & ((1u << D) - 1);
}

}  // namespace

template <std::size_t D>
LooseCells<D>::LooseCells(const Box& world) : frame_((space::check_cell_box("LooseOctree", "world", world), world)) {
  table_.assign(least_table, none);
  Cell root{root_code, {}, none, 0, none};
  root.children.fill(none);
  cells_.push_back(root);
  table_[slot_of(root_code)] = 0;
}

template <std::size_t D>
std::uint64_t LooseCells<D>::code_for(const Box& box) const {
  const space::PlaceRange<D> range = space::range_of(frame_, box);
  std::uint32_t most = 0;
  for (std::size_t axis = 0; axis < D; ++axis) most = std::max(most, range.high[axis] - range.low[axis]);
  unsigned shift = most < 2 ? 0 : static_cast<unsigned>(std::bit_width(most)) - 1;
  const auto lies_in_two = [&] {
    for (std::size_t axis = 0; axis < D; ++axis) {
      if ((range.high[axis] >> shift) - (range.low[axis] >> shift) > 1) return false;
    }
    return true;
  };
  while (!lies_in_two()) ++shift;
  const unsigned level = CellFrame<D>::levels - shift;
  return std::uint64_t{1} << D * level | space::interleaved<D>(range.low) >> D * shift;
}

// The table: open addressing, the next slot where one is taken.
template <std::size_t D>
std::size_t LooseCells<D>::slot_of(std::uint64_t code) const {
  const std::size_t mask = table_.size() - 1;
  std::uint64_t mixed = code * 0x9e3779b97f4a7c15u;
  mixed ^= mixed >> 32;
  std::size_t slot = static_cast<std::size_t>(mixed) & mask;
  while (table_[slot] != none && cells_[table_[slot]].code != code) slot = (slot + 1) & mask;
  return slot;
}

template <std::size_t D>
void LooseCells<D>::make_room_in_table() {
  if (2 * (cell_count() + CellFrame<D>::levels) <= table_.size()) return;
  const std::vector<std::uint32_t> old = std::move(table_);
  table_.assign(2 * old.size(), none);
  while (2 * (cell_count() + CellFrame<D>::levels) > table_.size()) table_.resize(2 * table_.size(), none);
  for (const std::uint32_t cell : old) {
    if (cell != none) table_[slot_of(cells_[cell].code)] = cell;
  }
}

template <std::size_t D>
void LooseCells<D>::erase_from_table(std::uint64_t code) {
  std::size_t slot = slot_of(code);
  const std::size_t mask = table_.size() - 1;
  table_[slot] = none;
  // Those behind it may now be found in an earlier slot only.
  for (slot = (slot + 1) & mask; table_[slot] != none; slot = (slot + 1) & mask) {
    const std::uint32_t moved = table_[slot];
    table_[slot] = none;
    table_[slot_of(cells_[moved].code)] = moved;
  }
}

/// Made, with those on the way to it, where it is not there.
template <std::size_t D>
std::uint32_t LooseCells<D>::cell_at(std::uint64_t code) {
  make_room_in_table();
  std::uint32_t below = none, found = none;
  for (std::uint64_t at = code;; at >>= D) {
    const std::size_t slot = slot_of(at);
    const bool is_there = table_[slot] != none;
    std::uint32_t cell = table_[slot];
    if (!is_there) {
      if (free_cells_.empty()) {
        cell = static_cast<std::uint32_t>(cells_.size());
        cells_.emplace_back();
      } else {
        cell = free_cells_.back();
        free_cells_.pop_back();
      }
      cells_[cell] = {at, {}, none, 0, none};
      cells_[cell].children.fill(none);
      table_[slot] = cell;
    }
    if (below == none) {
      found = cell;
    } else {
      cells_[cell].children[child_digit<D>(cells_[below].code)] = below;
      ++cells_[cell].child_count;
      cells_[below].parent = cell;
    }
    if (is_there) return found;
    below = cell;
  }
}

template <std::size_t D>
void LooseCells<D>::give_up_empty(std::uint32_t cell) {
  while (cell != 0 && cells_[cell].first_item == none && cells_[cell].child_count == 0) {
    const Cell& empty = cells_[cell];
    const std::uint32_t parent = empty.parent;
    cells_[parent].children[child_digit<D>(empty.code)] = none;
    --cells_[parent].child_count;
    erase_from_table(empty.code);
    free_cells_.push_back(cell);
    cell = parent;
  }
}

template <std::size_t D>
void LooseCells<D>::link(std::uint32_t handle, std::uint32_t cell) {
  Item& item = items_[handle];
  item.cell = cell, item.before = none, item.behind = cells_[cell].first_item;
  if (item.behind != none) items_[item.behind].before = handle;
  cells_[cell].first_item = handle;
}

template <std::size_t D>
void LooseCells<D>::unlink(std::uint32_t handle) {
  Item& item = items_[handle];
  (item.before == none ? cells_[item.cell].first_item : items_[item.before].behind) = item.behind;
  if (item.behind != none) items_[item.behind].before = item.before;
  item.cell = none;
}

template <std::size_t D>
void LooseCells<D>::require_held(std::string_view function, std::uint32_t handle) const {
  if (contains(handle)) return;
  throw Error("LooseOctree::" + std::string(function) + ": handle " + std::to_string(handle) +
              " holds no box; it was removed, or never given");
}

template <std::size_t D>
std::uint32_t LooseCells<D>::insert(const Box& box) {
  space::check_cell_box("LooseOctree::insert", "box", box);
  const std::uint32_t cell = cell_at(code_for(box));
  std::uint32_t handle = 0;
  if (free_items_.empty()) {
    handle = static_cast<std::uint32_t>(items_.size());
    items_.push_back({box, none, none, none});
  } else {
    handle = free_items_.back();
    free_items_.pop_back();
    items_[handle].box = box;
  }
  link(handle, cell);
  ++size_;
  return handle;
}

template <std::size_t D>
void LooseCells<D>::remove(std::uint32_t handle) {
  require_held("remove", handle);
  const std::uint32_t cell = items_[handle].cell;
  unlink(handle);
  give_up_empty(cell);
  free_items_.push_back(handle);
  --size_;
}

template <std::size_t D>
void LooseCells<D>::move(std::uint32_t handle, const Box& box) {
  require_held("move", handle);
  space::check_cell_box("LooseOctree::move", "box", box);
  const std::uint64_t code = code_for(box);
  const std::uint32_t from = items_[handle].cell;
  if (cells_[from].code != code) {
    const std::uint32_t to = cell_at(code);
    unlink(handle);
    link(handle, to);
    give_up_empty(from);
  }
  items_[handle].box = box;
}

template <std::size_t D>
const typename LooseCells<D>::Box& LooseCells<D>::box(std::uint32_t handle) const {
  require_held("box", handle);
  return items_[handle].box;
}

template <std::size_t D>
std::uint64_t LooseCells<D>::code(std::uint32_t handle) const {
  require_held("code", handle);
  return cells_[items_[handle].cell].code;
}

/// Calls visit(cell) for each cell whose loose cell may hold something of the box.
template <std::size_t D>
template <class Visit>
void LooseCells<D>::visit_cells(const Box& box, const Visit& visit) const {
  constexpr std::size_t children = std::size_t{1} << D;
  const space::PlaceRange<D> range = space::range_of(frame_, box);
  struct Waiting {
    std::uint32_t cell;
    CellSpan<D> span;
  };
  std::array<Waiting, (children - 1) * CellFrame<D>::levels + 1> later;
  std::size_t waiting = 0;
  later[waiting++] = {0, span_of<D>(root_code)};
  while (waiting > 0) {
    const Waiting now = later[--waiting];
    visit(cells_[now.cell]);
    for (std::size_t c = 0; c < children; ++c) {
      const std::uint32_t child = cells_[now.cell].children[c];
      if (child == none) continue;
      CellSpan<D> span = space::child_of(now.span, c), loose = span;
      loose.count *= 2;
      if (range.meets(loose)) later[waiting++] = {child, span};
    }
  }
}

template <std::size_t D>
std::vector<std::uint32_t> LooseCells<D>::in_box(const Box& box, const InBoxOptions& options,
                                                 std::vector<std::uint32_t> rows) const {
  rows.clear();
  figure::require_finite_parts<decltype(box.min), decltype(box.max)>("LooseOctree::in_box", {"box.min", "box.max"},
                                                                     box.min, box.max);
  if (is_empty(box)) return rows;
  visit_cells(box, [&](const Cell& cell) {
    for (std::uint32_t i = cell.first_item; i != none; i = items_[i].behind) {
      if (space::boxes_meet(box, items_[i].box, options.touching)) rows.push_back(i);
    }
  });
  std::sort(rows.begin(), rows.end());
  return rows;
}

template <std::size_t D>
std::vector<BoxPair> LooseCells<D>::overlapping_pairs(const BoxPairOptions& options, std::vector<BoxPair> rows) const {
  std::vector<space::SweptBox<Box>> boxes;
  std::vector<int> shifts;
  std::vector<typename CellFrame<D>::Place> places(items_.size());  // of their lowest corners
  for (std::uint32_t i = 0; i < items_.size(); ++i) {
    if (items_[i].cell == none) continue;
    boxes.push_back({items_[i].box, i});
    shifts.push_back(static_cast<int>(CellFrame<D>::levels - level_of<D>(cells_[items_[i].cell].code)));
    places[i] = frame_.place(items_[i].box.min);
  }
  space::LevelJoin<Box> join(options.execution, boxes, shifts);
  return join.pairs(
      options.touching,
      [&](const space::SweptBox<Box>& b, int shift) {
        space::RowNumber<D> row;
        for (std::size_t axis = 1; axis < D; ++axis) row[axis - 1] = places[b.number][axis] >> shift;
        return row;
      },
      std::move(rows));
}

template class LooseCells<2>;
template class LooseCells<3>;

}  // namespace plumb
