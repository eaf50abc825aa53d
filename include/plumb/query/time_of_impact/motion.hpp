// Swept test: what moves, how, and when does it meet?  Figures in motion during time [0, 1].
//
// Laws: a moving figure is what its shapes say at every time; nothing is rounded on the way.  One that does not move is
// one whose motion is zero.
// Source: RTCD 2.4.3, 5.5.
// Cost: none.
#pragma once

#include "plumb/arith/point.hpp"
#include "plumb/figure/containment/voronoi_region.hpp"

namespace plumb {

/// Moves by `by` during time [0, 1].
template <class Shape>
struct Translating {
  Shape shape;
  Vector3 by;
  friend bool operator==(const Translating&, const Translating&) = default;
};
template <class Shape>
Translating(Shape, Vector3) -> Translating<Shape>;

/// Every vertex moves linearly during time [0, 1].
template <class Shape>
struct Moving {
  Shape from, to;
  friend bool operator==(const Moving&, const Moving&) = default;
};

/// The first time at which two figures meet, rounded down: never late, and within 1 ulp; and the features that meet
/// then, those of the lowest dimension first, then those of the lowest number (figure/containment/voronoi_region.hpp).
struct Contact {
  double time;
  Feature feature_a, feature_b;
  friend bool operator==(const Contact&, const Contact&) = default;
};

/// The same answer with the figures named the other way round.
constexpr Contact swapped(const Contact& c) { return {c.time, c.feature_b, c.feature_a}; }

}  // namespace plumb
