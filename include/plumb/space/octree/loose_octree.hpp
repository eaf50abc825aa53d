// Loose octree, loose quadtree: which boxes are in a region, and which two overlap, where boxes come, go and move?
//
//   LooseOctree tree(Aabb3{{0, 0, 0}, {100, 100, 100}});    // the world; what lies outside is found as well
//   const std::uint32_t handle = tree.insert(box);
//   tree.move(handle, elsewhere);
//   tree.in_box(region);  tree.overlapping_pairs();         // by their handles
//   tree.remove(handle);
//
// A loose cell begins where the cell does and has twice its side.  A box is in the smallest cell whose loose one holds
// it, among those that have its lowest corner: of the level where it lies in no more than two cells along each axis.
// So no box is kept in a large cell because it lies across a border.
// Laws: (1) in_box tells, ascending, exactly the handles of the boxes that intersect the closed box, or without
// touching overlap it; pairs those of box_pair.hpp by handles: a ascends, then b, whatever was inserted, moved and removed
// before.  (2) There are cells only where a box is, and on the way from the root to these.  (3) A handle is that of its
// box until it is removed, and given again then.  (4) What throws leaves the tree as it was.
// NaN and infinity throw NonFinite, empty boxes InvalidShape; a handle that holds no box Error, which names it.
// Source: RTCD 7.3.6; Ulrich, "Loose octrees", Game Programming Gems, 2000.
// Cost: insertion, removal and moving are constant: a code and a look into a table of cells, and where a cell is made
// or given up a step for each level at most.  Moving within a cell is a comparison of codes.  All pairs: a sort by x
// and for each level that has a box one of all that are no higher, then some ns for each box near along x in rows of
// cells.  Bounded by n^2 comparisons for pairs, n for in_box.
#pragma once

#include <string_view>

#include "plumb/space/octree/cell_tree.hpp"
#include "plumb/space/pairs/box_pair.hpp"

namespace plumb {

template <std::size_t D>
class LooseCells {
 public:
  using Box = typename CellKinds<D>::Box;

  explicit LooseCells(const Box& world);

  std::uint32_t insert(const Box& box);
  void remove(std::uint32_t handle);
  void move(std::uint32_t handle, const Box& box);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t cell_count() const { return cells_.size() - free_cells_.size(); }
  [[nodiscard]] bool contains(std::uint32_t handle) const {
    return handle < items_.size() && items_[handle].cell != no_cell;
  }
  [[nodiscard]] const Box& box(std::uint32_t handle) const;
  /// Of the cell that it is in.
  [[nodiscard]] std::uint64_t code(std::uint32_t handle) const;
  [[nodiscard]] const CellFrame<D>& frame() const { return frame_; }

  [[nodiscard]] std::vector<std::uint32_t> in_box(const Box& box, const InBoxOptions& options = {},
                                                  std::vector<std::uint32_t> rows = {}) const;
  [[nodiscard]] std::vector<BoxPair> overlapping_pairs(const BoxPairOptions& options = {},
                                                       std::vector<BoxPair> rows = {}) const;

 private:
  struct Cell {
    std::uint64_t code;
    std::array<std::uint32_t, std::size_t{1} << D> children;
    std::uint32_t parent, child_count, first_item;
  };
  struct Item {
    Box box;
    std::uint32_t cell, before, behind;  // in the list of the cell's items
  };

  void require_held(std::string_view function, std::uint32_t handle) const;
  [[nodiscard]] std::uint64_t code_for(const Box& box) const;
  std::uint32_t cell_at(std::uint64_t code);
  void give_up_empty(std::uint32_t cell);
  void link(std::uint32_t handle, std::uint32_t cell);
  void unlink(std::uint32_t handle);
  [[nodiscard]] std::size_t slot_of(std::uint64_t code) const;
  void make_room_in_table();
  void erase_from_table(std::uint64_t code);
  template <class Visit>
  void visit_cells(const Box& box, const Visit& visit) const;

  CellFrame<D> frame_;
  std::vector<Cell> cells_;
  std::vector<Item> items_;
  std::vector<std::uint32_t> free_cells_, free_items_;
  std::vector<std::uint32_t> table_;  // cells by their codes; no_cell where there is none
  std::size_t size_ = 0;
};

using LooseOctree = LooseCells<3>;
using LooseQuadtree = LooseCells<2>;

}  // namespace plumb
