// Sort and sweep (sweep and prune) by linked lists: pairs are kept while boxes come, go and move one at a time.
//
//   SweepLists lists;                            // a list along each axis; {.axes = 1} along one
//   const std::uint32_t a = lists.insert(box);
//   lists.move(a, moved);   lists.remove(a);
//   lists.overlapping_pairs()
//
// The starts and ends of all boxes stand in a list along each axis.  Where a start passes an end, the two boxes begin
// or cease to overlap along the axis; pairs are looked at there and nowhere else.
// Laws: (1) pairs() are those of brute_force_pairs of the boxes there are, for any number of axes.  (2) They ascend by
// a, then b.  (3) Of what is equal along an axis starts come before ends where touching counts; where it does not, ends
// come first, but a box that is flat there begins after the ends and ceases before the starts of others.
// A number that names no box throws InvalidShape, bad boxes are refused as elsewhere; then all is as it was.
// Source: RTCD 7.5.1; Baraff 1992.
// Cost: a step for each start or end that a box passes along each of the axes; n steps for a box that is new, and a
// look at each pair for one that goes.  With fewer axes than three, pairs that overlap along these are kept, which are
// more.  Bounded by n^2 steps for n boxes that come or move.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "plumb/space/sort_and_sweep/sort_and_sweep.hpp"

namespace plumb {

struct SweepListsOptions {
  bool touching = true;                 // false: only the pairs that overlap
  int axes = 3;                         // 1, 2 or 3 lists, from first_axis on; x comes after z
  SweepAxis first_axis = SweepAxis::x;  // not greatest_variance, which is known of boxes that are there
};

class SweepLists {
 public:
  explicit SweepLists(const SweepListsOptions& options = {});
  SweepLists(SweepLists&&) noexcept;
  SweepLists& operator=(SweepLists&&) noexcept;
  ~SweepLists();

  /// A number of its own: the least that names none.
  std::uint32_t insert(const Aabb3& box);
  void move(std::uint32_t number, const Aabb3& box);
  void remove(std::uint32_t number);

  [[nodiscard]] bool contains(std::uint32_t number) const;
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] std::vector<BoxPair> overlapping_pairs(std::vector<BoxPair> rows = {}) const;
  /// Starts and ends that were passed since the lists were made.
  [[nodiscard]] std::size_t steps() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace plumb
