// How far does a ball reach from a center?
#pragma once

#include <string_view>

#include "plumb/figure/basic/round.hpp"

namespace plumb::figure::sphere {

/// Throws NonFinite and InvalidShape: "merge: a.radius is -1, ...".
void require_ball(std::string_view function, std::string_view name, const Circle2& ball);
void require_ball(std::string_view function, std::string_view name, const Sphere3& ball);

/// The least double that is not below the distance of the ball's center and its radius together; infinite beyond all.
double reach(const Point2& from, const Circle2& ball);
double reach(const Point3& from, const Sphere3& ball);

/// Does the outer ball hold the inner one?  Both are balls.
bool holds(const Circle2& outer, const Circle2& inner);
bool holds(const Sphere3& outer, const Sphere3& inner);

/// The order of balls in which equal sets of them are visited alike: by center, then by radius.
template <class Ball>
bool comes_first(const Ball& a, const Ball& b) {
  const auto x = coordinates(a.center), y = coordinates(b.center);
  return x < y || (x == y && a.radius < b.radius);
}

}  // namespace plumb::figure::sphere
