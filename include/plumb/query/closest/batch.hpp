// Nearest neighbor: which of many points, segments or triangles is nearest to p, and how far is it?
//
// Laws: (1) the item of least distance in real arithmetic, of equally near ones the lowest; `distance` is that of
// query/closest/closest.hpp.  (2) The same answer on every instruction set.  An empty batch throws InvalidShape, NaN and
// infinity throw NonFinite, naming the item.
// Source: RTCD 5.1.2, 5.1.5.
// Cost: a pass over doubles in lanes, with bounds; exact comparisons only among items that the bounds cannot tell
// apart.  Bounded by n exact distances for n items, on integers as long as the exponents' span.
#pragma once

#include <cstddef>

#include "plumb/query/body/item_batch.hpp"

namespace plumb {

struct NearestOfMany {
  std::size_t index;
  double distance;
  friend bool operator==(const NearestOfMany&, const NearestOfMany&) = default;
};

NearestOfMany nearest(const PointBatch& many, const Point3& p);
NearestOfMany nearest(const SegmentBatch& many, const Point3& p);
NearestOfMany nearest(const TriangleBatch& many, const Point3& p);

}  // namespace plumb
