// What do all answers to `where is the point` begin and end with?  Numbers looked at by name, signs made locations.
//
// Cost: one subtraction for each number.
#pragma once

#include <array>
#include <cstdio>
#include <string>
#include <string_view>

#include "plumb/arith/error.hpp"
#include "plumb/certify/sign_of.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "plumb/figure/containment/contains.hpp"

namespace plumb::figure::containment {

template <class... Parts>
bool are_real(const Parts&... parts) {
  double none = 0;  // becomes NaN, and stays it
  std::apply([&none](auto... x) { ((none += x - x), ...); }, std::tuple_cat(coordinates(parts)...));
  return none == 0;
}

/// Of what is positive outside of a shape with an interior, zero on its boundary.
constexpr Location location(Sign s) { return static_cast<Location>(-static_cast<int>(s)); }

/// Of membership in a set without interior.
constexpr Location boundary_if(bool member) { return member ? Location::boundary : Location::outside; }

/// What lies in two sets: outside of one is outside, inside is inside of both.
constexpr Location both(Location a, Location b) { return a < b ? a : b; }

/// Is p on the line?  Lines of zero direction are their point.
bool on_line(const Point2& point, const Vector2& direction, const Point2& p);
bool on_line(const Point3& point, const Vector3& direction, const Point3& p);

/// Does the triangle, which may be a segment or a point, contain p?
bool in_triangle(const Point3& a, const Point3& b, const Point3& c, const Point3& p);

constexpr bool is_zero(const Vector2& v) { return v.x == 0 && v.y == 0; }
constexpr bool is_zero(const Vector3& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

}  // namespace plumb::figure::containment
