// Software caching (cached linearization): which triangles does a thing meet that stays near one place for some frames?
// Those around it are kept in one row.
//
//   KeptRange near(bvh);                                      // one for each thing that moves in the mesh
//   for (;;) for (const std::uint32_t t : near.meeting(ball)) ...
//
// A query in a new place asks the tree, and sets a region around the shape's box, larger by `margin` of its longest
// side.  The second one whose box is in the region copies the triangles around it, with their boxes, one after the
// other; it and those that follow look through these alone.  So what leaps pays for no row.
// Laws: (1) the answers are those of meeting(mesh, shape), exactly, whatever was asked before.  (2) The mesh
// outlives it and stays as it is; where it has been refitted, forget() is called.
// Each query changes it: two threads need two.
// Errors are those of meeting, and InvalidShape for a margin that is negative or not finite.
// Source: RTCD 13.5, 13.5.1.
// Cost: a comparison of boxes for each triangle of the row, and a test of those whose boxes meet; 128 bytes each.
// Bounded by n tests of triangles, on integers as long as the exponents' span.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/space/range/range_search.hpp"

namespace plumb {

template <class Shape>
concept KeptRangeShape = std::same_as<Shape, Aabb3> || std::same_as<Shape, Obb3> || std::same_as<Shape, Sphere3> ||
    std::same_as<Shape, Capsule3> || std::same_as<Shape, Segment3>;

class KeptRange {
 public:
  explicit KeptRange(const Bvh& mesh, double margin = 0.5);

  /// The numbers, ascending.
  template <KeptRangeShape Shape>
  std::vector<std::uint32_t> meeting(const Shape& shape, std::vector<std::uint32_t> rows = {});

  void forget() { region_ = none; }
  /// Was the last query answered by the row; and of how many triangles is that?
  [[nodiscard]] bool by_row() const { return by_row_; }
  [[nodiscard]] std::size_t row_size() const { return row_.size(); }

 private:
  struct Kept {
    Aabb3 box;
    Triangle3 triangle;
    std::uint32_t number;
  };
  static constexpr Aabb3 none{{1, 1, 1}, {-1, -1, -1}};

  void fill();

  const Bvh* mesh_;
  double margin_;
  Aabb3 region_ = none;
  bool is_filled_ = false, by_row_ = false;
  std::vector<Kept> row_;  // of the region, by their numbers
};

}  // namespace plumb
