// Bounding volumes (AABB, sphere): which of many pairs of boxes, or of balls, meet?  In the lanes of vectors: pair by
// pair, and one against many.
//
// Laws: (1) the answers are those of intersects, one by one, on every instruction set.  (2) The numbers are looked
// through when a batch is made, not when it is asked: NonFinite names the item.  A negative radius throws InvalidShape,
// spans of different lengths UnequalLengths.
// Source: RTCD 4.2.1, 4.3.1, 13.7.
// Cost: boxes below 1 ns a pair with four lanes; balls likewise, and a scalar exact sign for each pair that doubles
// leave in doubt.  The best instruction set that the processor has is taken.  Nothing is searched: each item is
// looked at once.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/round.hpp"

namespace plumb {

/// Four boxes, lane by lane; made once from boxes that may be any.
class FourBoxes {
 public:
  explicit FourBoxes(const std::array<Aabb3, 4>& boxes);

  /// Bit i: do box i of a and box i of b meet?
  friend unsigned intersects(const FourBoxes& a, const FourBoxes& b) {
    Lanes gap = {};  // the largest of (later start - earlier end)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Lanes from = a.min_[axis] > b.min_[axis] ? a.min_[axis] : b.min_[axis];
      const Lanes to = a.max_[axis] < b.max_[axis] ? a.max_[axis] : b.max_[axis];
      const Lanes here = from - to;
      gap = axis == 0 ? here : here > gap ? here : gap;
    }
    const auto apart = gap > 0;
    return ~static_cast<unsigned>((apart[0] & 1) | (apart[1] & 2) | (apart[2] & 4) | (apart[3] & 8)) & 15u;
  }

 private:
  using Lanes = double __attribute__((vector_size(32)));
  std::array<Lanes, 3> min_, max_;
};

/// Boxes, coordinate by coordinate.
class BoxBatch {
 public:
  explicit BoxBatch(std::span<const Aabb3> boxes);
  [[nodiscard]] std::size_t size() const { return of_[0].size(); }
  /// Numbers 0, 1, 2: min.x, min.y, min.z; 3, 4, 5: max.
  [[nodiscard]] const double* numbers(std::size_t k) const { return of_[k].data(); }

 private:
  std::array<std::vector<double>, 6> of_;
};

/// Balls, likewise: numbers 0, 1, 2, 3 are x, y, z of the center, and the radius.
class SphereBatch {
 public:
  explicit SphereBatch(std::span<const Sphere3> spheres);
  [[nodiscard]] std::size_t size() const { return of_[0].size(); }
  [[nodiscard]] const double* numbers(std::size_t k) const { return of_[k].data(); }
  [[nodiscard]] Sphere3 operator[](std::size_t i) const { return {{of_[0][i], of_[1][i], of_[2][i]}, of_[3][i]}; }

 private:
  std::array<std::vector<double>, 4> of_;
};

/// out[i] is 1 where item i of a meets item i of b, else 0.
void intersects(const BoxBatch& a, const BoxBatch& b, std::span<std::uint8_t> out);
void intersects(const SphereBatch& a, const SphereBatch& b, std::span<std::uint8_t> out);
/// out[i] is 1 where the one meets item i of the many, else 0.
void intersects(const Aabb3& one, const BoxBatch& many, std::span<std::uint8_t> out);
void intersects(const Sphere3& one, const SphereBatch& many, std::span<std::uint8_t> out);

}  // namespace plumb
