// The best cut of all along each axis, by the surface-area heuristic: lists of the items sorted once along each axis,
// and kept sorted from cut to cut.
//
// Source: MacDonald and Booth 1990; Wald and Havran 2006 for the lists.
// Cost: linear in a range for a cut.
#pragma once

#include <span>

#include "space/bvh/grown_tree.hpp"

namespace plumb::space {

/// What the cutters of all threads work on.
struct SweepLists {
  std::span<const BoxedItem> items;
  std::array<std::vector<std::uint32_t>, 3> sorted;  // along each axis, by middles; equal ones by number
  std::vector<std::uint32_t> other;
  std::vector<float> behind;         // half area of the items from a place on
  std::vector<unsigned char> first;  // of each item: does it go first?
  BvhOptions options;

  SweepLists(std::span<const BoxedItem> all, const BvhOptions& o);
};

class SweepCutter {
 public:
  explicit SweepCutter(SweepLists& lists) : lists_(lists) {}

  bool cut(const SlotRange& range, std::array<SlotRange, 2>& parts) const;

 private:
  SweepLists& lists_;
};

}  // namespace plumb::space
