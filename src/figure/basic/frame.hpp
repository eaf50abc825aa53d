// Which right angles lie near to these directions?  Frames in doubles, for boxes that are then made to enclose.
//
// Laws: the frame is right-handed and orthonormal up to rounding, whatever the directions: zero, dependent, of any
// magnitude; the first direction that is not zero keeps its way, and axes of space make up for those that lack.
// Cost: some 50 ns.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "plumb/arith/point.hpp"

namespace plumb::figure::frame {

inline double dot(const Vector3& u, const Vector3& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
inline Vector3 cross(const Vector3& u, const Vector3& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}
inline Vector3 times(const Vector3& v, double s) { return {v.x * s, v.y * s, v.z * s}; }
inline Vector3 plus(const Vector3& u, const Vector3& v) { return {u.x + v.x, u.y + v.y, u.z + v.z}; }
inline Vector3 minus(const Vector3& u, const Vector3& v) { return {u.x - v.x, u.y - v.y, u.z - v.z}; }
inline double largest(const Vector3& v) { return std::fmax(std::fmax(std::fabs(v.x), std::fabs(v.y)), std::fabs(v.z)); }

/// The power of two by which a number of magnitude x is scaled to [1/2, 1); 0 for zero.
inline int exponent(double x) {
  int e = 0;
  (void)std::frexp(x, &e);
  return e;
}
inline Vector3 scaled(const Vector3& v, int e) { return {std::ldexp(v.x, e), std::ldexp(v.y, e), std::ldexp(v.z, e)}; }
/// Of length one; zero stays zero.
inline Vector3 unit(const Vector3& v) {
  const double most = largest(v);
  if (!(most > 0)) return {0, 0, 0};
  const Vector3 w = scaled(v, -exponent(most));
  return times(w, 1 / std::sqrt(dot(w, w)));
}

/// What is left of v beside a unit vector, and whether that is more than roundings, as guesses go.
inline bool beside(const Vector3& u, Vector3& v) {
  constexpr double mere_roundings = 0x1p-40;  // a guess: the part of v that two projections may leave of a parallel one
  const Vector3 w = minus(v, times(u, dot(u, v)));
  const Vector3 rest = minus(w, times(u, dot(u, w)));
  const bool enough = largest(rest) > largest(v) * mere_roundings;
  v = unit(rest);
  return enough;
}

/// How far outward to move at first what roundings may have left short, of lengths about 1 in units of 2^exponent; the
/// guess grows until all is proved to be held.
inline double first_margin(int exponent) {
  constexpr double some_ulps = 0x1p-51;  // a guess, as is the other: some of the least doubles
  constexpr int least = -1070;
  return std::max(some_ulps, std::ldexp(1.0, least - exponent));
}

/// The axis of space that is farthest from v.
inline Vector3 axis_beside(const Vector3& v) {
  const double x = std::fabs(v.x), y = std::fabs(v.y), z = std::fabs(v.z);
  return x <= y && x <= z ? Vector3{1, 0, 0} : y <= z ? Vector3{0, 1, 0} : Vector3{0, 0, 1};
}

inline std::array<Vector3, 3> orthonormal(const std::array<Vector3, 3>& directions) {
  std::array<Vector3, 2> kept{};
  int count = 0;
  for (const Vector3& d : directions) {
    Vector3 v = unit(d);
    if (count == 2 || !(largest(v) > 0)) continue;
    if (count == 0 || beside(kept[0], v)) kept[static_cast<std::size_t>(count++)] = v;
  }
  if (count == 0) return {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
  if (count == 1) {
    kept[1] = axis_beside(kept[0]);
    (void)beside(kept[0], kept[1]);
  }
  return {kept[0], kept[1], cross(kept[0], kept[1])};
}

}  // namespace plumb::figure::frame
