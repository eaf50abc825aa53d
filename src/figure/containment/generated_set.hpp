// Which flat do center and axes span, and in which coordinates do its points differ?  For boxes and ellipsoids whose
// axes are dependent: in those coordinates they are sets with an interior.
//
// Laws: dropping the other coordinates maps the flat one to one, and the set in it to the set of the dropped axes.
// Cost: a sign of degree 3, up to nine of degree 2.
#pragma once

#include <array>
#include <optional>
#include <utility>

#include "plumb/arith/point.hpp"

namespace plumb::figure::containment {

using Axes2 = std::array<Vector2, 3>;
using Axes3 = std::array<Vector3, 3>;
using Numbers = std::array<double, 3>;

constexpr Numbers numbers(const Point3& p) { return {p.x, p.y, p.z}; }
constexpr Numbers numbers(const Vector3& v) { return {v.x, v.y, v.z}; }

/// Two of the axes, if any, that are not parallel.
std::optional<std::pair<Vector2, Vector2>> independent(const Axes2& axes);
std::optional<std::pair<Vector3, Vector3>> independent(const Axes3& axes);

/// One of the axes that is not zero.
std::optional<Vector2> any_of(const Axes2& axes);
std::optional<Vector3> any_of(const Axes3& axes);

/// Is p in the plane through the center?
bool in_plane(const Point3& center, const std::pair<Vector3, Vector3>& span, const Point3& p);

/// The first of two cyclically consecutive coordinates in which the points of the plane differ: 0 for x and y.
std::size_t telling_coordinates(const std::pair<Vector3, Vector3>& span);

/// A coordinate that is not zero.
std::size_t telling_coordinate(const Numbers& v);

template <class Pair>
Pair kept(const Numbers& x, std::size_t first) {
  return {x[first], x[(first + 1) % 3]};
}

}  // namespace plumb::figure::containment
