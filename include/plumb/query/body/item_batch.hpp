// Many points, segments or triangles, coordinate by coordinate, for the lanes of vectors.
//
// Law: the numbers are looked through when a batch is made, not when it is asked: NonFinite names the item.
// Source: RTCD 13.7.
// Cost: a copy.  Nothing is searched.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/mesh.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb {

namespace query {

/// Of items of `corners` points each.
template <class Item, std::size_t corners>
class ItemBatch {
 public:
  explicit ItemBatch(std::span<const Item> items);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] Item operator[](std::size_t i) const {
    if constexpr (corners == 1) {
      return at(i, 0);
    } else if constexpr (corners == 2) {
      return {at(i, 0), at(i, 1)};
    } else {
      return {at(i, 0), at(i, 1), at(i, 2)};
    }
  }
  /// Numbers 0 to 3 corners - 1: a.x, a.y, a.z, b.x, ...  Behind the last item they go on for a few more, so that whole
  /// lanes can be read.
  [[nodiscard]] const double* numbers(std::size_t k) const { return of_[k].data(); }

 private:
  [[nodiscard]] Point3 at(std::size_t i, std::size_t c) const {
    return {of_[3 * c][i], of_[3 * c + 1][i], of_[3 * c + 2][i]};
  }
  std::size_t size_;
  std::array<std::vector<double>, 3 * corners> of_;
};

}  // namespace query

using PointBatch = query::ItemBatch<Point3, 1>;
using SegmentBatch = query::ItemBatch<Segment3, 2>;
using TriangleBatch = query::ItemBatch<Triangle3, 3>;

/// Those of a mesh; one that names no vertex throws InvalidShape.
TriangleBatch triangle_batch(const TriangleMesh& mesh);

}  // namespace plumb
