#include "plumb/space/grid/hierarchical_grid.hpp"

#include <algorithm>

#include "plumb/space/grid/detail/size_level.hpp"
#include "space/grid/cell_hash.hpp"
#include "space/grid/grid_boxes.hpp"
#include "space/grid/pairs_of_levels.hpp"

namespace plumb {
namespace {

/// What a box, which reaches into these cells, may find there: it is told by its first cell, and reaches no farther
/// than the next.
template <std::size_t n>
space::CellSpan<n> with_those_before(space::CellSpan<n> span) {
  for (std::int32_t& x : span.first) --x;
  return span;
}

}  // namespace

template <class Box>
HierarchicalGrid<Box>::HierarchicalGrid(const HierarchicalGridOptions& options) : options_(options) {
  if (options.least_level > space::most_level) {
    throw InvalidShape("HierarchicalGrid: options.least_level is " + std::to_string(options.least_level) +
                       ", but it must not be above 1023");
  }
  heads_.assign(space::least_places, none);
}

template <class Box>
std::size_t HierarchicalGrid<Box>::place_of(int level, const space::CellNumber<n>& cell) const {
  return (space::hash_of(cell) + static_cast<std::uint64_t>(level + 1100) * 0x9FB21C651E98DF25u) & (heads_.size() - 1);
}

template <class Box>
void HierarchicalGrid<Box>::link(std::uint32_t handle) {
  Entry& entry = entries_[handle];
  std::uint32_t& head = heads_[place_of(entry.level, entry.span.first)];
  entry.next = head, entry.previous = none;
  if (head != none) entries_[head].previous = handle;
  head = handle;
}

template <class Box>
void HierarchicalGrid<Box>::unlink(std::uint32_t handle) {
  const Entry& entry = entries_[handle];
  if (entry.next != none) entries_[entry.next].previous = entry.previous;
  if (entry.previous != none) {
    entries_[entry.previous].next = entry.next;
  } else {
    heads_[place_of(entry.level, entry.span.first)] = entry.next;
  }
}

/// Twice as many places as there are boxes, or nearly so.
template <class Box>
void HierarchicalGrid<Box>::grow() {
  if (boxes_.size() < heads_.size() / 2) return;
  heads_.assign(heads_.size() * 4, none);
  for (std::uint32_t i = 0; i < entries_.size(); ++i) {
    if (contains(i)) link(i);
  }
}

template <class Box>
void HierarchicalGrid<Box>::count(int level, bool more) {
  const auto at = std::lower_bound(levels_.begin(), levels_.end(), level,
                                   [](const Level& l, int wanted) { return l.level < wanted; });
  if (at == levels_.end() || at->level != level) {
    levels_.insert(at, {level, 1});
  } else if (more) {
    ++at->boxes;
  } else if (--at->boxes == 0) {
    levels_.erase(at);
  }
}

template <class Box>
std::uint32_t HierarchicalGrid<Box>::insert(const Box& box) {
  space::require_grid_box("HierarchicalGrid::insert", "box", box);
  const auto [level, span] = space::place_in_levels(box, options_.least_level);
  grow();
  if (boxes_.next() == entries_.size()) entries_.push_back({});
  const std::uint32_t handle = boxes_.add(box);
  entries_[handle] = {span, level, none, none};
  link(handle);
  count(level, true);
  return handle;
}

template <class Box>
void HierarchicalGrid<Box>::remove(std::uint32_t handle) {
  if (!contains(handle)) throw space::not_in_grid("HierarchicalGrid::remove", handle);
  unlink(handle);
  count(entries_[handle].level, false);
  boxes_.release(handle);
}

template <class Box>
void HierarchicalGrid<Box>::move(std::uint32_t handle, const Box& box) {
  if (!contains(handle)) throw space::not_in_grid("HierarchicalGrid::move", handle);
  space::require_grid_box("HierarchicalGrid::move", "box", box);
  const auto [level, span] = space::place_in_levels(box, options_.least_level);
  Entry& entry = entries_[handle];
  if (level != entry.level || span.first != entry.span.first) {
    unlink(handle);
    count(entry.level, false);
    entry.level = level, entry.span = span;
    link(handle);
    count(level, true);
  }
  entry.span = span;
  boxes_[handle] = box;
}

template <class Box>
template <class Visit>
void HierarchicalGrid<Box>::for_list(int level, const space::CellNumber<n>& cell, const Visit& visit) const {
  for (std::uint32_t i = heads_[place_of(level, cell)]; i != none; i = entries_[i].next) {
    if (entries_[i].level == level && entries_[i].span.first == cell) visit(i);
  }
}

template <class Box>
std::vector<BoxPair> HierarchicalGrid<Box>::overlapping_pairs(const BoxPairOptions& options,
                                                              std::vector<BoxPair> rows) const {
  std::vector<space::SweptBox<Box>> boxes;
  std::vector<int> levels;
  for (std::uint32_t i = 0; i < entries_.size(); ++i) {
    if (contains(i)) boxes.push_back({boxes_[i], i}), levels.push_back(entries_[i].level);
  }
  return space::pairs_of_levels(options, boxes, levels, std::move(rows));
}

template <class Box>
std::vector<std::uint32_t> HierarchicalGrid<Box>::in_box(const Box& box, const InBoxOptions& options,
                                                         std::vector<std::uint32_t> rows) const {
  rows.clear();
  if (!space::may_hold("HierarchicalGrid::in_box", box)) return rows;
  const auto test = [&](std::uint32_t b) {
    if (space::is_pair(box, boxes_[b], options.touching)) rows.push_back(b);
  };
  double cells = 0;
  for (const Level& l : levels_) {
    cells += space::cell_count(with_those_before(space::cells_of(box, space::per_level_size(l.level))));
  }
  if (cells > static_cast<double>(entries_.size())) {  // more cells than boxes
    for (std::uint32_t b = 0; b < entries_.size(); ++b) {
      if (contains(b)) test(b);
    }
    return rows;
  }
  for (const Level& l : levels_) {
    space::for_cells(with_those_before(space::cells_of(box, space::per_level_size(l.level))),
                     [&](const auto& cell) { for_list(l.level, cell, test); });
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

template <class Box>
std::size_t HierarchicalGrid<Box>::memory() const {
  return boxes_.memory() + entries_.capacity() * sizeof(Entry) + heads_.size() * sizeof(std::uint32_t) +
         levels_.capacity() * sizeof(Level);
}

template class HierarchicalGrid<Aabb2>;
template class HierarchicalGrid<Aabb3>;

}  // namespace plumb
