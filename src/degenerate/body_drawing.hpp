// Which integers make a body?  Lengths and places within its extents, drawn one after the other.
//
// Source: none.
// Cost: that of the choices.
#pragma once

#include <utility>

#include "degenerate/body.hpp"

namespace plumb::degenerate {

using Flat = std::array<Int, 2>;

struct Drawing {
  const BodyOrder& order;
  Entropy& entropy;

  static constexpr Int fraction = 8;  // sizes are multiples, so that points between are integers

  [[nodiscard]] Int length(std::size_t axis) const {  // in [1, extent]; 0 where there is none
    const Int most = order.extent[axis];
    return most == 0 ? 0 : 1 + static_cast<Int>(entropy.below(static_cast<std::uint64_t>(most)));
  }
  [[nodiscard]] Int somewhere(std::size_t axis) const {
    if (axis == 1 && order.dimension == 2) return 0;
    return entropy.within(order.extent[axis]);
  }
  /// The second to the left of the first, about the origin.
  [[nodiscard]] std::pair<Flat, Flat> corners(std::size_t second) const {
    const Flat right{length(0), somewhere(second)};
    const Int x = somewhere(0);
    return {right, {(x > 0) == (right[1] > 0) ? -x : x, length(second)}};
  }
};

/// Of points alone, in any order: `count` of them, multiples of `unit`.
std::vector<Int3> vertices_of(const Drawing& draw, std::size_t count, Int unit);

Body chain_body(const Drawing& draw);       // polygon, quadrilateral, holed_polygon
Body halfspaces_body(const Drawing& draw);  // halfspaces
Body k_dop_body(const Drawing& draw);       // k_dop
Body mesh_body(const Drawing& draw);        // mesh
Body ellipsoid_body(const Drawing& draw);   // ellipsoid

}  // namespace plumb::degenerate
