// What is the volume of an oriented box, over any number type?
//
// Law: of the sign of the axes' determinant times that of the half extents.
// Source: RTCD 4.4.
// Cost: 16 products.
#pragma once

#include "arith/vec.hpp"
#include "plumb/figure/basic/box.hpp"

namespace plumb::figure {

template <class N>
N signed_volume_of(const Obb3& box) {
  return N(8.0) * (N(box.half.x) * N(box.half.y) * N(box.half.z)) *
         arith::dot(arith::vec<N>(box.axes[0]), arith::cross(arith::vec<N>(box.axes[1]), arith::vec<N>(box.axes[2])));
}

}  // namespace plumb::figure
