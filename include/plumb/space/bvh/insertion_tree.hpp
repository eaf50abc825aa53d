// Which tree for items that come and go?  One that takes each where it costs least, and lets go of any.
//
//   InsertionTree tree;
//   tree.insert(7, box);  tree.remove(7);
//   BoxTree laid_out = tree.laid_out();      // to be asked
//
// Laws: (1) laid_out() keeps the laws of box_tree.hpp for what was inserted and not removed, `items` being the numbers
//       given.  (2) Every box contains those below it at any time.
// A number that is there already, or is not there, throws InvalidShape; boxes are refused as by build_box_tree.
// Source: RTCD 6.2.3; Goldsmith and Salmon 1987.
// Cost: the depth of the tree for an insertion or a removal: log n as a rule, n at worst.  Memory by the largest
// number.  Bounded by n^2 operations for n insertions.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "plumb/space/bvh/build.hpp"

namespace plumb {

class InsertionTree {
 public:
  /// Boxes much beyond a frame's numbers are taken as well, for a worse tree.
  explicit InsertionTree(const BoxFrame& frame = {}) : frame_(frame) {}

  void insert(std::uint32_t item, const Aabb3& box);
  void remove(std::uint32_t item);

  [[nodiscard]] bool contains(std::uint32_t item) const { return item < place_of_.size() && place_of_[item] != none; }
  [[nodiscard]] std::size_t size() const { return root_ == none ? 0 : places_[root_].items; }

  /// Of the options most_in_leaf and item_cost count.
  [[nodiscard]] BoxTree laid_out(const BvhOptions& options = {}) const;

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  struct Place {
    FloatBox3 box;
    std::uint32_t parent;
    std::array<std::uint32_t, 2> children;  // none and the item's number for an item
    std::uint32_t items = 1;                // below it
    [[nodiscard]] bool is_item() const { return children[0] == none; }
  };

  [[nodiscard]] std::uint32_t best_sibling(const FloatBox3& box) const;
  std::uint32_t new_place(const Place& place);
  void replace_child(std::uint32_t parent, std::uint32_t child, std::uint32_t by);
  void fit_from(std::uint32_t place);

  BoxFrame frame_;
  std::vector<Place> places_;
  std::vector<std::uint32_t> free_;
  std::uint32_t root_ = none;
  std::vector<std::uint32_t> place_of_;  // of each item, or none
};

}  // namespace plumb
