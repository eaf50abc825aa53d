// Separating axis test, error bounds: how far off may doubles be that tell how a box lies to many triangles, or a segment
// to many boxes?
//
// A box with the axes of space is seen from its center, twice as large: p' = (p - min) + (p - max), and |x'| <= max -
// min.  Along the cross product of axis k and the edge e of a triangle with normal n the gap is
//   |e x p' + n|_k - (|n_k| + reach of the box),
// for the third corner is 2 n_k farther than the edge.
// Laws: what is computed of such a gap in doubles, its sums in whatever order, is off by no more than its bound: a
// constant that is derived from the formula (certify/formula.hpp), times powers of the largest numbers.  The formulas
// have absolute values resolved, for | |v| - |V| | <= |v - V|.
// Source: docs/proof.md, "Filter B".
// Cost: none; query/overlap/batch.cpp computes them.
#pragma once

#include "plumb/certify/detail/filter_stage.hpp"
#include "plumb/predicates/cross.hpp"

namespace plumb::query::box_gaps {

using predicates::cross, predicates::difference, predicates::dot, predicates::Triple;

/// Points a, b, c, min, max; what is straight is ab.
struct BesideBox {
  static constexpr std::string_view name = "relate";
  static constexpr int points = 5, dimension = 3;
  template <class T>
  static constexpr auto seen(const std::array<T, 15>& p, std::size_t i) {
    return (p[i] - p[9 + i % 3]) + (p[i] - p[12 + i % 3]);
  }
};
/// The same, in another order: the center of one box serves many points.
struct BesideCenter : BesideBox {
  template <class T>
  static constexpr auto seen(const std::array<T, 15>& p, std::size_t i) {
    return (p[i] + p[i]) - (p[9 + i % 3] + p[12 + i % 3]);
  }
};
template <class Beside = BesideBox>
struct EdgeBesideBox : Beside {
  using Beside::seen;
  template <class T>
  constexpr auto operator()(const std::array<T, 15>& p) const {
    const auto y = p[4] - p[1], z = p[5] - p[2];
    const auto across = y * (p[8] - p[5]) - z * (p[7] - p[4]);
    return ((y * seen(p, 2) - z * seen(p, 1)) + across) - (across + (y * (p[14] - p[11]) + z * (p[13] - p[10])));
  }
};
template <class Beside = BesideBox>
struct NormalBesideBox : Beside {
  using Beside::seen;
  template <class T>
  constexpr auto operator()(const std::array<T, 15>& p) const {
    const auto n = cross(difference(p, 0, 1), difference(p, 1, 2));
    return dot(n, Triple{seen(p, 0), seen(p, 1), seen(p, 2)}) - dot(n, difference(p, 3, 4));
  }
};

}  // namespace plumb::query::box_gaps
