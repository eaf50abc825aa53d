#include "plumb/space/grid/static_grid.hpp"

#include <algorithm>
#include <cmath>

#include "space/bvh/parts.hpp"
#include "space/grid/fitting_cell_size.hpp"

namespace plumb {
namespace {

/// From so many boxes in a cell on they are sorted along x.
constexpr std::size_t worth_sorting = 40;
/// The cells are shared out among so many parts, whatever the threads.
constexpr std::size_t most_parts = 64;
constexpr std::size_t least_entries_in_part = 4096;

}  // namespace

template <class Box>
StaticGrid<Box>::StaticGrid(std::span<const Box> boxes, const GridOptions& options) {
  const std::string function = "StaticGrid";
  space::require_grid_boxes(function, boxes);
  if (options.cell_size) (void)space::per_cell_size(function, *options.cell_size);
  boxes_.assign(boxes.begin(), boxes.end());
  size_ = options.cell_size ? *options.cell_size : choose_cell_size(boxes).size;
  if (boxes.empty()) return;
  const auto count = static_cast<double>(boxes.size());
  if (!options.cell_size) size_ = space::fitting_cell_size(function, boxes, size_, false);
  per_size_ = space::per_cell_size(function, size_);
  all_ = space::cells_of(space::box_around(boxes), per_size_);  // numbers of cells grow with coordinates
  spans_.resize(boxes.size());
  double entries = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    spans_[i] = space::cells_of(boxes[i], per_size_);
    entries += space::cell_count(spans_[i]);
  }
  const double bytes = count * (sizeof(Box) + sizeof(Span)) + 4 * (space::cell_count(all_) + entries);
  space::require_memory(function, bytes, options.most_memory);
  if (entries > 4e9) throw Error(function + ": more than 32 bits number reach into cells; choose larger cells");
  fill();
}

template <class Box>
std::size_t StaticGrid<Box>::slice_of(const space::CellNumber<n>& cell) const {
  return space::index_in(all_, cell);
}

template <class Box>
void StaticGrid<Box>::fill() {
  starts_.assign(static_cast<std::size_t>(space::cell_count(all_)) + 1, 0);
  for (const Span& s : spans_) {
    space::for_cells(s, [&](const auto& cell) { ++starts_[slice_of(cell) + 1]; });
  }
  for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  numbers_.resize(starts_.back());
  for (std::size_t i = spans_.size(); i-- > 0;) {  // from the back: the end of a slice becomes its start
    space::for_cells(
        spans_[i], [&](const auto& cell) { numbers_[--starts_[slice_of(cell) + 1]] = static_cast<std::uint32_t>(i); });
  }
  const auto entries = static_cast<std::uint32_t>(numbers_.size());
  std::copy(starts_.begin() + 1, starts_.end(), starts_.begin());
  starts_.back() = entries;
}

template <class Box>
void StaticGrid<Box>::pairs_in(std::size_t cell, bool touching, std::vector<Member>& members,
                               std::vector<BoxPair>& out) const {
  const std::span<const std::uint32_t> slice = items_in(cell);
  if (slice.size() < 2) return;
  space::CellNumber<n> number{};
  std::size_t rest = cell;
  for (std::size_t k = 0; k < n; ++k) {
    const auto width = static_cast<std::size_t>(all_.last[k] - all_.first[k] + 1);
    number[k] = all_.first[k] + static_cast<std::int32_t>(rest % width);
    rest /= width;
  }
  members.clear();
  for (const std::uint32_t i : slice) members.push_back({boxes_[i], spans_[i].first, i});
  const bool sorted = slice.size() >= worth_sorting;
  if (sorted) {
    std::sort(members.begin(), members.end(), [](const Member& a, const Member& b) {
      return a.box.min.x != b.box.min.x ? a.box.min.x < b.box.min.x : a.number < b.number;
    });
  }
  const Member* const end = members.data() + members.size();
  for (const Member* a = members.data(); a != end; ++a) {
    for (const Member* b = a + 1; b != end; ++b) {
      if (sorted && b->box.min.x > a->box.max.x) break;
      if (!space::is_pair(a->box, b->box, touching)) continue;
      if (!space::is_lowest_cell(number, a->first, b->first)) continue;
      out.push_back({std::min(a->number, b->number), std::max(a->number, b->number)});
    }
  }
}

template <class Box>
std::vector<BoxPair> StaticGrid<Box>::overlapping_pairs(const BoxPairOptions& options,
                                                        std::vector<BoxPair> rows) const {
  const std::size_t parts = std::clamp<std::size_t>(numbers_.size() / least_entries_in_part, 1, most_parts);
  std::vector<std::vector<BoxPair>> found(parts);
  const auto first_cell = [&](std::size_t part) {
    const auto entry = static_cast<std::uint32_t>(numbers_.size() * part / parts);
    return part == parts
               ? cells()
               : static_cast<std::size_t>(std::lower_bound(starts_.begin(), starts_.end(), entry) - starts_.begin());
  };
  space::for_parts("StaticGrid::pairs", options.execution, {}, parts, [&](std::size_t part) {
    std::vector<Member> members;
    for (std::size_t c = first_cell(part), end = first_cell(part + 1); c < end; ++c) {
      pairs_in(c, options.touching, members, found[part]);
    }
  });
  rows.clear();
  std::size_t size = 0;
  for (const auto& f : found) size += f.size();
  rows.reserve(size);
  for (const auto& f : found) rows.insert(rows.end(), f.begin(), f.end());
  return rows;
}

/// To the cells that there are; is one left?
template <class Box>
bool StaticGrid<Box>::clip(Span& span) const {
  bool is = true;
  for (std::size_t k = 0; k < n; ++k) {
    span.first[k] = std::max(span.first[k], all_.first[k]), span.last[k] = std::min(span.last[k], all_.last[k]);
    is &= span.first[k] <= span.last[k];
  }
  return is;
}

template <class Box>
std::vector<std::size_t> StaticGrid<Box>::cells_meeting(const Box& box) const {
  space::require_grid_box("StaticGrid::cells_meeting", "box", box);
  std::vector<std::size_t> cells;
  Span span = space::cells_of(box, per_size_);
  if (boxes_.empty() || !clip(span)) return cells;
  space::for_cells(span, [&](const auto& cell) { cells.push_back(slice_of(cell)); });
  return cells;
}

template <class Box>
std::size_t StaticGrid<Box>::cell_of_pair(const Box& a, const Box& b) const {
  space::CellNumber<n> cell = space::cells_of(a, per_size_).first;
  const space::CellNumber<n> other = space::cells_of(b, per_size_).first;
  for (std::size_t k = 0; k < n; ++k) cell[k] = std::max(cell[k], other[k]);
  return slice_of(cell);
}

template <class Box>
std::vector<std::uint32_t> StaticGrid<Box>::in_box(const Box& box, const InBoxOptions& options,
                                                   std::vector<std::uint32_t> rows) const {
  rows.clear();
  if (!space::may_hold("StaticGrid::in_box", box)) return rows;
  if (boxes_.empty()) return rows;
  Span span = space::cells_of(box, per_size_);
  const space::CellNumber<n> first = span.first;
  if (!clip(span)) return rows;
  space::for_cells(span, [&](const auto& cell) {
    const std::size_t slice = slice_of(cell);
    for (std::size_t i = starts_[slice]; i < starts_[slice + 1]; ++i) {
      const std::uint32_t number = numbers_[i];
      if (space::is_pair(box, boxes_[number], options.touching) &&
          space::is_lowest_cell(cell, first, spans_[number].first)) {
        rows.push_back(number);
      }
    }
  });
  std::sort(rows.begin(), rows.end());
  return rows;
}

template <class Box>
std::size_t StaticGrid<Box>::memory() const {
  return boxes_.size() * (sizeof(Box) + sizeof(Span)) + (starts_.size() + numbers_.size()) * sizeof(std::uint32_t);
}

template class StaticGrid<Aabb2>;
template class StaticGrid<Aabb3>;

}  // namespace plumb
