// How far apart are two boxes along a cross product of their edges, less what both reach along it?
//
// A box is its center plus all combinations of its axes with factors up to its half extents.  For L = u x v, with u and
// v two axes of one box, or one of each, four axes w of both boxes are left whose products with L need not vanish:
//   |(cb - ca) . L| - e0 |w0 . L| - e1 |w1 . L| - e2 |w2 . L| - e3 |w3 . L|
// is positive exactly when L separates the boxes.  The polynomial is this for absolute values that are resolved: with
// centers swapped and axes reversed so that no product with L is negative.
// Laws: zero when L is the zero vector (parallel or zero axes); positive multiples of u and v change no sign.
// Source: RTCD 4.4.1, table 4.1; 4.4.2; 5.2.1.1.  Degree 3 in the distance, 4 in the reach.
#pragma once

#include <array>
#include <string_view>

#include "plumb/predicates/cross.hpp"

namespace plumb::predicates {

/// (ca, cb, u, v, w0, w1, w2, w3, e0, e1, e2, e3).
struct BoxGap {
  static constexpr std::string_view name = "box_gap";
  static constexpr std::array arguments{3, 3, 3, 3, 3, 3, 3, 3, 1, 1, 1, 1};
  static constexpr bool homogeneous = false;

  /// With `size` for the absolute value of the products with L.
  template <class T, class Size>
  static constexpr auto gap(const std::array<T, 28>& p, Size size) {
    const auto axis = cross(argument(p, 2), argument(p, 3));
    const auto reach = [&](std::size_t i) { return p[24 + i] * size(dot(argument(p, 4 + i), axis)); };
    return size(dot(difference(p, 0, 1), axis)) - ((reach(0) + reach(1)) + (reach(2) + reach(3)));
  }

  template <class T>
  constexpr auto operator()(const std::array<T, 28>& p) const {
    return gap(p, [](const auto& product) { return product; });
  }
};

}  // namespace plumb::predicates
