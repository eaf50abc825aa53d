#include "plumb/space/grid/row_column_grid.hpp"

#include <algorithm>
#include <bit>

#include "plumb/space/grid/detail/size_level.hpp"
#include "space/grid/grid_boxes.hpp"
#include "space/grid/pairs_of_levels.hpp"

namespace plumb {

template <class Box>
RowColumnGrid<Box>::RowColumnGrid(const RowColumnGridOptions& options) : options_(options) {
  if (!std::has_single_bit(options.rows) || options.rows > std::size_t{1} << 30) {
    throw InvalidShape("RowColumnGrid: options.rows is " + std::to_string(options.rows) +
                       ", but it must be a power of two up to 2^30");
  }
  if (options.least_level > space::most_level) {
    throw InvalidShape("RowColumnGrid: options.least_level is " + std::to_string(options.least_level) +
                       ", but it must not be above 1023");
  }
}

/// The level, with a slot for one box more.
template <class Box>
auto RowColumnGrid<Box>::level_with_room(const char* function, int level) -> Level& {
  auto at = std::lower_bound(levels_.begin(), levels_.end(), level,
                             [](const Level& l, int wanted) { return l.level < wanted; });
  const bool is_new = at == levels_.end() || at->level != level;
  if (!is_new && (!at->free.empty() || at->handles.size() < at->rows.slots())) return *at;
  const std::size_t slots = is_new ? 64 : 2 * at->rows.slots();
  double bytes = space::BitRows<n>::memory_of(options_.rows, slots);
  for (const Level& l : levels_) bytes += static_cast<double>(l.rows.memory());
  space::require_memory(function, bytes, options_.most_memory, "choose fewer rows");
  if (is_new) at = levels_.insert(at, Level{level, space::BitRows<n>(options_.rows), {}, {}});
  at->rows.reserve(slots);
  return *at;
}

template <class Box>
void RowColumnGrid<Box>::put(std::uint32_t handle, Level& level, const space::CellSpan<n>& span) {
  auto slot = static_cast<std::uint32_t>(level.handles.size());
  if (level.free.empty()) {
    level.handles.push_back(handle);
  } else {
    slot = level.free.back();
    level.free.pop_back();
    level.handles[slot] = handle;
  }
  level.rows.set(slot, span, true);
  places_[handle] = {level.level, slot};
}

template <class Box>
void RowColumnGrid<Box>::take(std::uint32_t handle) {
  const Place place = places_[handle];
  Level& level = *std::lower_bound(levels_.begin(), levels_.end(), place.level,
                                   [](const Level& l, int wanted) { return l.level < wanted; });
  level.rows.set(place.slot, space::cells_of(boxes_[handle], space::per_level_size(place.level)), false);
  level.free.push_back(place.slot);
}

template <class Box>
std::uint32_t RowColumnGrid<Box>::insert(const Box& box) {
  space::require_grid_box("RowColumnGrid::insert", "box", box);
  const auto [level, span] = space::place_in_levels(box, options_.least_level);
  Level& at = level_with_room("RowColumnGrid::insert", level);
  if (boxes_.next() == places_.size()) places_.push_back({});
  const std::uint32_t handle = boxes_.add(box);
  put(handle, at, span);
  return handle;
}

template <class Box>
void RowColumnGrid<Box>::remove(std::uint32_t handle) {
  if (!contains(handle)) throw space::not_in_grid("RowColumnGrid::remove", handle);
  take(handle);
  boxes_.release(handle);
}

template <class Box>
void RowColumnGrid<Box>::move(std::uint32_t handle, const Box& box) {
  if (!contains(handle)) throw space::not_in_grid("RowColumnGrid::move", handle);
  space::require_grid_box("RowColumnGrid::move", "box", box);
  const auto [level, span] = space::place_in_levels(box, options_.least_level);
  if (level != places_[handle].level || span != space::cells_of(boxes_[handle], space::per_level_size(level))) {
    level_with_room("RowColumnGrid::move", level);  // may throw, and move the levels
    take(handle);
    put(handle, level_with_room("RowColumnGrid::move", level), span);
  }
  boxes_[handle] = box;
}

template <class Box>
template <class Visit>
void RowColumnGrid<Box>::for_overlapping(const Box& box, bool touching, Scratch& scratch, const Visit& visit) const {
  for (const Level& l : levels_) {
    const auto span = space::cells_of(box, space::per_level_size(l.level));
    l.rows.for_common(span, 0, l.handles.size(), scratch.both, scratch.one, [&](std::size_t slot) {
      const std::uint32_t b = l.handles[slot];
      if (space::is_pair(box, boxes_[b], touching)) visit(b);
    });
  }
}

template <class Box>
std::vector<BoxPair> RowColumnGrid<Box>::overlapping_pairs(const BoxPairOptions& options,
                                                           std::vector<BoxPair> rows) const {
  std::vector<space::SweptBox<Box>> boxes;
  std::vector<int> levels;
  for (std::uint32_t i = 0; i < places_.size(); ++i) {
    if (contains(i)) boxes.push_back({boxes_[i], i}), levels.push_back(places_[i].level);
  }
  return space::pairs_of_levels(options, boxes, levels, std::move(rows));
}

template <class Box>
std::vector<std::uint32_t> RowColumnGrid<Box>::in_box(const Box& box, const InBoxOptions& options,
                                                      std::vector<std::uint32_t> rows) const {
  rows.clear();
  if (!space::may_hold("RowColumnGrid::in_box", box)) return rows;
  Scratch scratch;
  for_overlapping(box, options.touching, scratch, [&](std::uint32_t b) { rows.push_back(b); });
  std::sort(rows.begin(), rows.end());
  return rows;
}

template <class Box>
std::size_t RowColumnGrid<Box>::levels() const {
  return static_cast<std::size_t>(
      std::count_if(levels_.begin(), levels_.end(), [](const Level& l) { return l.free.size() < l.handles.size(); }));
}

template <class Box>
std::size_t RowColumnGrid<Box>::memory() const {
  std::size_t bytes = boxes_.memory() + places_.capacity() * sizeof(Place);
  for (const Level& l : levels_) {
    bytes += l.rows.memory() + (l.handles.capacity() + l.free.capacity()) * sizeof(std::uint32_t);
  }
  return bytes;
}

template class RowColumnGrid<Aabb2>;
template class RowColumnGrid<Aabb3>;

}  // namespace plumb
