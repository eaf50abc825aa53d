// Which of many points, segments or triangles is nearest to p, and how far is it?
//
// Laws: (1) the item of least distance in real arithmetic, of equally near ones the lowest; `distance` is that of
// query/closest.hpp.  (2) The same answer on every instruction set.  An empty batch throws InvalidShape, NaN and
// infinity throw NonFinite, naming the item. Source: RTCD 5.1.2, 5.1.5.  Cost: a pass over doubles in lanes, with
// bounds; exact comparisons only among items that the bounds cannot tell apart.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "plumb/figure/linear.hpp"
#include "plumb/figure/simplex.hpp"

namespace plumb {

struct NearestOfMany {
  std::size_t index;
  double distance;
  friend bool operator==(const NearestOfMany&, const NearestOfMany&) = default;
};

namespace query {

/// The coordinates of items of `corners` points each, an array for each coordinate.
template <class Item, std::size_t corners>
class ItemBatch {
 public:
  explicit ItemBatch(std::span<const Item> items);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] Item operator[](std::size_t i) const;
  /// Behind the last item it goes on for a few more, so that whole lanes can be read.
  [[nodiscard]] const double* numbers(std::size_t k) const { return of_[k].data(); }

 private:
  std::size_t size_;
  std::array<std::vector<double>, 3 * corners> of_;
};

}  // namespace query

using PointBatch3 = query::ItemBatch<Point3, 1>;
using SegmentBatch3 = query::ItemBatch<Segment3, 2>;
using TriangleBatch3 = query::ItemBatch<Triangle3, 3>;

NearestOfMany nearest(const PointBatch3& many, const Point3& p);
NearestOfMany nearest(const SegmentBatch3& many, const Point3& p);
NearestOfMany nearest(const TriangleBatch3& many, const Point3& p);

}  // namespace plumb
