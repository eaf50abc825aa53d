// Where is it?  Points and vectors: plain aggregates of doubles, each standing for exactly the number it holds.
//
// Laws: a coordinate is exact as given; float32 widens exactly; nothing is normalized, rounded or validated here.
// Source: RTCD 3.2, 3.3.
// Cost: none.
#pragma once

#include "plumb/predicates/standard.hpp"

namespace plumb {

struct Point2 {
  double x, y;
  friend bool operator==(const Point2&, const Point2&) = default;
};

struct Point3 {
  double x, y, z;
  friend bool operator==(const Point3&, const Point3&) = default;
};

struct Vector2 {
  double x, y;
  friend bool operator==(const Vector2&, const Vector2&) = default;
};

struct Vector3 {
  double x, y, z;
  friend bool operator==(const Vector3&, const Vector3&) = default;
};

}  // namespace plumb
