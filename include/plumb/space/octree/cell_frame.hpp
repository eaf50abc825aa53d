// Octree, quadtree: where are the borders of the cells?  A cube whose halves, quarters and so on end at doubles.
//
// The root is a cube of side 2^n.  Its corner is a multiple of the least cell's side, and that side is not less than
// two units in the last place of the largest coordinate: so every border of every level is a multiple of a power of two
// that a double holds, and 'in which cell is x' is a comparison of doubles.  A border beyond the largest double is
// infinite: those cells end nowhere, and where both borders are, there is no cell.
// Laws: (1) a cell is half-open: x is in it where border <= x < next border.  number(axis, x) is the number of the
// least cell that x is in, for every finite x; of what is outside the root that of the nearest cell.  So it never falls
// as x grows.  (2) Of such cubes it is the one of the least side that holds what it was made for.  (3) The deepest
// level is that of cells of the side `unit`: 2^21 of them along an axis of space, 2^31 in the plane.  Coordinates that
// differ by less than that, less than 2^-21 of the root's side or two units in the last place of the largest, may share
// a cell of the deepest level; no other limit is set to their magnitudes.
// NaN and infinity throw NonFinite.
// Source: RTCD 7.3.3, 7.3.4.
// Cost: a product, a rounding and two comparisons for each number.  Nothing is searched.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"

namespace plumb {

/// Figures of the dimension, and its levels.
template <std::size_t D>
struct CellKinds;
template <>
struct CellKinds<2> {
  using Point = Point2;
  using Box = Aabb2;
  using Ray = Ray2;
  using Segment = Segment2;
  static constexpr unsigned levels = 31;
};
template <>
struct CellKinds<3> {
  using Point = Point3;
  using Box = Aabb3;
  using Ray = Ray3;
  using Segment = Segment3;
  static constexpr unsigned levels = 21;
};

template <std::size_t D>
class CellFrame {
 public:
  using Point = typename CellKinds<D>::Point;
  using Box = typename CellKinds<D>::Box;
  /// The numbers of a least cell along the axes, from 0 to last.
  using Place = std::array<std::uint32_t, D>;
  static constexpr unsigned levels = CellKinds<D>::levels;
  static constexpr std::uint32_t last = static_cast<std::uint32_t>((std::uint64_t{1} << levels) - 1);

  CellFrame() : CellFrame(Box{}) {}
  /// For what is in the box, which is not empty.
  explicit CellFrame(const Box& held);

  /// Where cell k begins, and cell k - 1 ends.
  [[nodiscard]] double border(std::size_t axis, std::uint64_t k) const {
    return (first_[axis] + static_cast<double>(k)) * unit_;
  }
  [[nodiscard]] std::uint32_t number(std::size_t axis, double x) const {
    // A guess, which comparisons prove.
    const double guess = x * scale_ * more_scale_ - first_[axis];
    std::uint32_t k = guess >= last ? last : guess > 0 ? static_cast<std::uint32_t>(guess) : 0;
    while (k > 0 && border(axis, k) > x) --k;
    while (k < last && border(axis, k + std::uint64_t{1}) <= x) ++k;
    return k;
  }
  [[nodiscard]] Place place(const Point& p) const {
    if constexpr (D == 2) {
      return {number(0, p.x), number(1, p.y)};
    } else {
      return {number(0, p.x), number(1, p.y), number(2, p.z)};
    }
  }
  /// Is it in the root?
  [[nodiscard]] bool holds(const Point& p) const {
    if constexpr (D == 2) {
      return is_within(0, p.x) && is_within(1, p.y);
    } else {
      return is_within(0, p.x) && is_within(1, p.y) && is_within(2, p.z);
    }
  }
  /// The side of the cells of the deepest level, 2^exponent.
  [[nodiscard]] double unit() const { return unit_; }

  friend bool operator==(const CellFrame&, const CellFrame&) = default;

 private:
  [[nodiscard]] bool is_within(std::size_t axis, double x) const {
    return border(axis, 0) <= x && x < border(axis, std::uint64_t{last} + 1);
  }

  double unit_, scale_, more_scale_;  // 2^n, and of two powers of two the product 2^-n, which may be no double
  std::array<double, D> first_;       // the root's corner, in units
};

using OctreeFrame = CellFrame<3>;
using QuadtreeFrame = CellFrame<2>;

}  // namespace plumb
