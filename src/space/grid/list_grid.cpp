#include "plumb/space/grid/list_grid.hpp"

#include <algorithm>
#include <limits>

#include "space/grid/cell_hash.hpp"
#include "space/grid/grid_boxes.hpp"

namespace plumb {
namespace {

/// Where nothing is remembered.
struct LowestCell {};
void fit(LowestCell&, std::size_t) {}
template <class Seen>
void fit(Seen& seen, std::size_t size) {
  if (seen.size() < size) {
    seen.reset(size);
  } else {
    seen.begin();
  }
}

/// Of the functions, as users name the grid.
template <CellTable>
struct Names {
  static constexpr std::string_view make = "HashedGrid", insert = "HashedGrid::insert", remove = "HashedGrid::remove",
                                    move = "HashedGrid::move", in_box = "HashedGrid::in_box";
};
template <>
struct Names<CellTable::array> {
  static constexpr std::string_view make = "LinkedGrid", insert = "LinkedGrid::insert", remove = "LinkedGrid::remove",
                                    move = "LinkedGrid::move", in_box = "LinkedGrid::in_box";
};

}  // namespace

template <class Box, CellTable table>
ListGrid<Box, table>::ListGrid(const Box* world, double cell_size, const GridOptions& options)
    : options_(options), size_(cell_size) {
  const std::string_view function = Names<table>::make;
  per_size_ = space::per_cell_size(function, cell_size, "cell_size");
  if (world == nullptr) {
    heads_.assign(space::least_places, none);
    return;
  }
  space::require_grid_box(function, "world", *world);
  all_ = space::cells_of(*world, per_size_);
  space::require_memory(function, space::cell_count(all_) * sizeof(std::uint32_t), options.most_memory);
  heads_.assign(static_cast<std::size_t>(space::cell_count(all_)), none);
}

/// Of an array of cells the last ones go on without end: the number of a cell still grows with the coordinate.
template <class Box, CellTable table>
auto ListGrid<Box, table>::span_of(const Box& box) const -> Span {
  Span span = space::cells_of(box, per_size_);
  if constexpr (table == CellTable::array) {
    for (std::size_t k = 0; k < n; ++k) {
      span.first[k] = std::clamp(span.first[k], all_.first[k], all_.last[k]);
      span.last[k] = std::clamp(span.last[k], all_.first[k], all_.last[k]);
    }
  }
  return span;
}

template <class Box, CellTable table>
std::size_t ListGrid<Box, table>::place_of(const space::CellNumber<n>& cell) const {
  if constexpr (table == CellTable::hashed) return space::hash_of(cell) & (heads_.size() - 1);
  std::size_t place = 0;
  for (std::size_t k = n; k-- > 0;) {
    place = place * static_cast<std::size_t>(all_.last[k] - all_.first[k] + 1) +
            static_cast<std::size_t>(cell[k] - all_.first[k]);
  }
  return place;
}

template <class Box, CellTable table>
void ListGrid<Box, table>::require_room(std::string_view function, const Span& span) const {
  const double more = space::cell_count(span), nodes = static_cast<double>(used_) + more;
  const double places = table == CellTable::hashed ? 2 * nodes : static_cast<double>(heads_.size());
  space::require_memory(function, nodes * sizeof(Node) + places * sizeof(std::uint32_t), options_.most_memory);
}

/// Room for so many nodes more; and no more nodes than places in a table.
template <class Box, CellTable table>
void ListGrid<Box, table>::grow(std::size_t nodes) {
  if (used_ + nodes > nodes_.capacity()) nodes_.reserve(std::max(used_ + nodes, 2 * nodes_.capacity()));
  if (table == CellTable::array || used_ + nodes <= heads_.size()) return;
  std::size_t places = heads_.size();
  while (places < used_ + nodes) places *= 2;
  std::vector<std::uint32_t> old(places, none);
  old.swap(heads_);
  for (std::uint32_t head : old) {
    while (head != none) {
      const std::uint32_t next = nodes_[head].next;
      std::uint32_t& now = heads_[place_of(nodes_[head].cell)];
      nodes_[head].next = now;
      now = head;
      head = next;
    }
  }
}

template <class Box, CellTable table>
void ListGrid<Box, table>::link(std::uint32_t handle) {
  space::for_cells(spans_[handle], [&](const auto& cell) {
    std::uint32_t node = free_;
    if (node == none) {
      node = static_cast<std::uint32_t>(nodes_.size());
      nodes_.push_back({});
    } else {
      free_ = nodes_[node].next;
    }
    std::uint32_t& head = heads_[place_of(cell)];
    nodes_[node] = {cell, handle, head};
    head = node;
    ++used_;
  });
}

template <class Box, CellTable table>
void ListGrid<Box, table>::unlink(std::uint32_t handle) {
  space::for_cells(spans_[handle], [&](const auto& cell) {
    std::uint32_t* at = &heads_[place_of(cell)];
    while (nodes_[*at].box != handle || nodes_[*at].cell != cell) at = &nodes_[*at].next;
    const std::uint32_t node = *at;
    *at = nodes_[node].next;
    nodes_[node].next = free_;
    free_ = node;
    --used_;
  });
}

template <class Box, CellTable table>
std::uint32_t ListGrid<Box, table>::insert(const Box& box) {
  space::require_grid_box(Names<table>::insert, "box", box);
  const Span span = span_of(box);
  require_room(Names<table>::insert, span);
  grow(static_cast<std::size_t>(space::cell_count(span)));
  if (boxes_.next() == spans_.size()) spans_.push_back(span);
  const std::uint32_t handle = boxes_.add(box);
  spans_[handle] = span;
  link(handle);
  return handle;
}

template <class Box, CellTable table>
void ListGrid<Box, table>::remove(std::uint32_t handle) {
  if (!contains(handle)) throw space::not_in_grid(Names<table>::remove, handle);
  unlink(handle);
  boxes_.release(handle);
}

template <class Box, CellTable table>
void ListGrid<Box, table>::move(std::uint32_t handle, const Box& box) {
  if (!contains(handle)) throw space::not_in_grid(Names<table>::move, handle);
  space::require_grid_box(Names<table>::move, "box", box);
  const Span span = span_of(box);
  if (span != spans_[handle]) {
    require_room(Names<table>::move, span);
    grow(static_cast<std::size_t>(space::cell_count(span)));
    unlink(handle);
    spans_[handle] = span;
    link(handle);
  }
  boxes_[handle] = box;
}

template <class Box, CellTable table>
std::vector<BoxPair> ListGrid<Box, table>::overlapping_pairs(const BoxPairOptions& options,
                                                             std::vector<BoxPair> rows) const {
  rows.clear();
  for (const std::uint32_t head : heads_) {
    for (std::uint32_t i = head; i != none; i = nodes_[i].next) {
      const Node& a = nodes_[i];
      for (std::uint32_t j = a.next; j != none; j = nodes_[j].next) {
        const Node& b = nodes_[j];
        if (table == CellTable::hashed && a.cell != b.cell) continue;
        if (!space::is_pair(boxes_[a.box], boxes_[b.box], options.touching)) continue;
        if (!space::is_lowest_cell(a.cell, spans_[a.box].first, spans_[b.box].first)) continue;
        rows.push_back({std::min(a.box, b.box), std::max(a.box, b.box)});
      }
    }
  }
  return rows;
}

template <class Box, CellTable table>
template <class Seen>
std::vector<std::uint32_t> ListGrid<Box, table>::found(const Box& box, bool touching, Seen& seen,
                                                       std::vector<std::uint32_t> rows) const {
  rows.clear();
  if (!space::may_hold(Names<table>::in_box, box)) return rows;
  fit(seen, boxes_.numbers());
  const Span span = span_of(box);
  const auto look = [&](const Node& node, const space::CellNumber<n>& cell) {
    if constexpr (std::is_same_v<Seen, LowestCell>) {
      if (!space::is_pair(box, boxes_[node.box], touching)) return;
      if (!space::is_lowest_cell(cell, span.first, spans_[node.box].first)) return;
    } else {
      if (!seen.visit(node.box) || !space::is_pair(box, boxes_[node.box], touching)) return;
    }
    rows.push_back(node.box);
  };
  if (space::cell_count(span) > static_cast<double>(used_)) {  // fewer nodes than cells: each node, where it lies
    for (const std::uint32_t head : heads_) {
      for (std::uint32_t i = head; i != none; i = nodes_[i].next) {
        if (space::holds_cell(span, nodes_[i].cell)) look(nodes_[i], nodes_[i].cell);
      }
    }
  } else {
    space::for_cells(span, [&](const auto& cell) {
      for (std::uint32_t i = heads_[place_of(cell)]; i != none; i = nodes_[i].next) {
        if (table == CellTable::array || nodes_[i].cell == cell) look(nodes_[i], cell);
      }
    });
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

template <class Box, CellTable table>
std::vector<std::uint32_t> ListGrid<Box, table>::in_box(const Box& box, const InBoxOptions& options,
                                                        std::vector<std::uint32_t> rows) const {
  LowestCell nothing;
  return found(box, options.touching, nothing, std::move(rows));
}
template <class Box, CellTable table>
std::vector<std::uint32_t> ListGrid<Box, table>::in_box(const Box& box, VisitStamps& seen, const InBoxOptions& options,
                                                        std::vector<std::uint32_t> rows) const {
  return found(box, options.touching, seen, std::move(rows));
}
template <class Box, CellTable table>
std::vector<std::uint32_t> ListGrid<Box, table>::in_box(const Box& box, VisitBits& seen, const InBoxOptions& options,
                                                        std::vector<std::uint32_t> rows) const {
  return found(box, options.touching, seen, std::move(rows));
}

template <class Box, CellTable table>
std::size_t ListGrid<Box, table>::memory() const {
  return boxes_.memory() + spans_.capacity() * sizeof(Span) + heads_.size() * sizeof(std::uint32_t) +
         nodes_.capacity() * sizeof(Node);
}

template class ListGrid<Aabb2, CellTable::array>;
template class ListGrid<Aabb2, CellTable::hashed>;
template class ListGrid<Aabb3, CellTable::array>;
template class ListGrid<Aabb3, CellTable::hashed>;

}  // namespace plumb
