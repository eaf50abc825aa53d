// What are cylinders and cones, of which all but the surface is one?  An axis, the radius at its end, and which of both.
//
// Law: exact; all numbers are as given.
// Source: RTCD 5.3.7.
// Cost: a copy.
#pragma once

#include "plumb/figure/basic/round.hpp"

namespace plumb::query {

/// A cylinder between the ends of its axis, or a cone from its apex to its base.
struct RoundAxis {
  Point3 from, to;
  double radius;
  bool is_cone;

  /// It has an inside; else it is a ball or a segment.
  [[nodiscard]] bool is_itself() const { return radius > 0 && from != to; }
};
inline RoundAxis axis_of(const Cylinder3& c) { return {c.a, c.b, c.radius, false}; }
inline RoundAxis axis_of(const Cone3& c) { return {c.apex, c.base, c.radius, true}; }

}  // namespace plumb::query
