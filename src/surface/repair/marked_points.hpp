// Which of the points that are still marked are within a length of this one, and is any of them beyond it?
//
// A k-d tree whose nodes count the points that are marked, and know a box of all that ever were: what is done with is
// passed over, and what is true of a whole box is asked of none of its points.
// Laws: those at exactly the length are within, decided exactly.  What is found is in no order.
// Source: RTCD 7.3.7.
// Cost: 2 n log n to build; a mark is a step for each level; a question the boxes at the border, and what is found.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/certify/compare_distance.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/space/kd_tree/kd_tree.hpp"
#include "surface/topology/box_around.hpp"

namespace plumb::surface {

class MarkedPoints {
 public:
  /// None is marked.  The points are not copied.
  MarkedPoints(std::span<const Point3> points, Execution execution);

  void mark(std::uint32_t point);
  void unmark(std::uint32_t point);
  [[nodiscard]] bool is_marked(std::uint32_t point) const { return marked_[slot_[point]] != 0; }

  void add_within(const Point3& p, double length, std::vector<std::uint32_t>& found) const {
    add_within(0, p, length, box_around(p, p, length), found);
  }
  [[nodiscard]] bool any_beyond(const Point3& p, double length) const { return any_beyond(0, p, length); }

 private:
  struct Node {
    Aabb3 box;
    std::uint32_t count;
  };
  void add_within(std::size_t node, const Point3& p, double length, const Aabb3& around,
                  std::vector<std::uint32_t>& found) const;
  [[nodiscard]] bool any_beyond(std::size_t node, const Point3& p, double length) const;
  template <class Visit>
  void each_above(std::uint32_t point, const Visit& visit);

  std::span<const Point3> points_;
  KdTree3 tree_;
  std::vector<Node> nodes_;           // leaves behind them, in their order
  std::vector<std::uint32_t> slot_;   // of a point in tree_.numbers
  std::vector<std::uint32_t> leaf_;   // of a slot
  std::vector<std::uint8_t> marked_;  // by slots
};

}  // namespace plumb::surface
