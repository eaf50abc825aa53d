// Grids of linked lists: a box is in the list of each cell that it reaches into, in an array of cells or in a table, in
// which cells that share a place are told apart by their numbers.
//
// Source: RTCD 7.1.2, 7.1.3.
#pragma once

#include <algorithm>

#include "space/textbook/scheme.hpp"

namespace plumb::space {

template <class Box, bool is_hashed>
class ListCells {
 public:
  static constexpr std::size_t n = axes_of<Box>;
  using Place = CellSpan<n>;
  using Stored = StoredBoxes<Box, Place>;

  ListCells(const AskedFunction& asked, const BoxStoreOptions<Box>& options) : most_memory_(options.most_memory) {
    per_size_ = per_cell_size(asked.text(), options.cell_size, "cell_size");
    if (is_hashed) {
      heads_.assign(least_places, no_handle);
      return;
    }
    require_grid_box(asked.text(), "world", options.world);
    all_ = cells_of(options.world, per_size_);
    asked.require_memory(cell_count(all_) * sizeof(std::uint32_t), most_memory_);
    heads_.assign(static_cast<std::size_t>(cell_count(all_)), no_handle);
  }

  /// The last cells of an array go on without end: the number of a cell still grows with the coordinate.
  [[nodiscard]] Place place_of(const Box& box) const {
    Place span = cells_of(box, per_size_);
    if constexpr (!is_hashed) {
      for (std::size_t k = 0; k < n; ++k) {
        span.first[k] = std::clamp(span.first[k], all_.first[k], all_.last[k]);
        span.last[k] = std::clamp(span.last[k], all_.first[k], all_.last[k]);
      }
    }
    return span;
  }

  /// No more nodes than places in a table.
  void make_room(const AskedFunction& asked, std::uint32_t, const Place& span) {
    const double more = cell_count(span), all = static_cast<double>(used_) + more;
    asked.require_memory(all * sizeof(Node) + (is_hashed ? 2 * all : static_cast<double>(heads_.size())) * 4,
                         most_memory_);
    const auto nodes = used_ + static_cast<std::size_t>(more);
    if (nodes > nodes_.capacity()) nodes_.reserve(std::max(nodes, 2 * nodes_.capacity()));
    if (is_hashed && nodes > heads_.size()) grow(nodes);
  }

  void put(std::uint32_t handle, const Place& span) {
    for_cells(span, [&](const auto& cell) {
      std::uint32_t node = free_;
      if (node == no_handle) {
        node = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back({});
      } else {
        free_ = nodes_[node].next;
      }
      std::uint32_t& head = heads_[slot_of(cell)];
      nodes_[node] = {cell, handle, head};
      head = node;
      ++used_;
    });
  }
  void take(std::uint32_t handle, const Place& span) {
    for_cells(span, [&](const auto& cell) {
      std::uint32_t* at = &heads_[slot_of(cell)];
      while (nodes_[*at].box != handle || nodes_[*at].cell != cell) at = &nodes_[*at].next;
      const std::uint32_t node = *at;
      *at = nodes_[node].next;
      nodes_[node].next = free_;
      free_ = node;
      --used_;
    });
  }

  template <class Visit>
  void visit_near(const Box& box, bool once, const Stored& stored, const Visit& visit) const {
    const Place span = place_of(box);
    const auto look = [&](const Node& node, const CellNumber<n>& cell) {
      if (!once || is_lowest_cell(cell, span.first, stored.places[node.box].first)) visit(node.box);
    };
    if (cell_count(span) > static_cast<double>(used_)) {  // fewer nodes than cells: each node, where it lies
      for_nodes([&](const Node& node) {
        if (holds_cell(span, node.cell)) look(node, node.cell);
      });
      return;
    }
    for_cells(span, [&](const auto& cell) {
      for (std::uint32_t i = heads_[slot_of(cell)]; i != no_handle; i = nodes_[i].next) {
        if (!is_hashed || nodes_[i].cell == cell) look(nodes_[i], cell);
      }
    });
  }

  std::vector<BoxPair> pairs(const BoxPairOptions& options, const Stored& stored) const {
    std::vector<BoxPair> rows;
    for_nodes([&](const Node& a) {
      for (std::uint32_t j = a.next; j != no_handle; j = nodes_[j].next) {
        const Node& b = nodes_[j];
        if (is_hashed && a.cell != b.cell) continue;
        if (!is_pair(stored.boxes[a.box], stored.boxes[b.box], options.touching)) continue;
        if (!is_lowest_cell(a.cell, stored.places[a.box].first, stored.places[b.box].first)) continue;
        rows.push_back({std::min(a.box, b.box), std::max(a.box, b.box)});
      }
    });
    return rows;
  }

  static std::size_t parts() { return 1; }
  [[nodiscard]] std::size_t memory() const {
    return heads_.size() * sizeof(std::uint32_t) + nodes_.capacity() * sizeof(Node);
  }

 private:
  struct Node {
    CellNumber<n> cell;
    std::uint32_t box, next;
  };

  [[nodiscard]] std::size_t slot_of(const CellNumber<n>& cell) const {
    if constexpr (is_hashed) {
      return hash_of(cell) & (heads_.size() - 1);
    } else {
      return index_in(all_, cell);
    }
  }
  void grow(std::size_t nodes) {
    std::size_t places = heads_.size();
    while (places < nodes) places *= 2;
    std::vector<std::uint32_t> old(places, no_handle);
    old.swap(heads_);
    for (std::uint32_t head : old) {
      while (head != no_handle) {
        const std::uint32_t next = nodes_[head].next;
        std::uint32_t& now = heads_[slot_of(nodes_[head].cell)];
        nodes_[head].next = now;
        now = head;
        head = next;
      }
    }
  }
  template <class Visit>
  void for_nodes(const Visit& visit) const {
    for (const std::uint32_t head : heads_) {
      for (std::uint32_t i = head; i != no_handle; i = nodes_[i].next) visit(nodes_[i]);
    }
  }

  std::size_t most_memory_;
  double per_size_;
  Place all_{};                       // of an array of cells
  std::vector<std::uint32_t> heads_;  // the first node of each list
  std::vector<Node> nodes_;
  std::uint32_t free_ = no_handle;  // the first of the nodes that are not in use
  std::size_t used_ = 0;            // nodes
};

}  // namespace plumb::space
