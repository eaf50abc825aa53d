// Of which small integers are a ray and a triangle?  Coordinates on one lattice are whole when they are taken times a power
// of two, and so is a direction by one of its own.
//
// Laws: the products are exact, so that what is decided of them is decided of what was given; the parameters of a ray with
// a direction are others.
// Source: RTCD 11.5.1.
// Cost: three operations a number.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <optional>

#include "query/ray/shot.hpp"

namespace plumb::query {

struct WholeShot {
  AnyRay ray;
  Triangle3 triangle;
};

/// The power of two that makes them whole, and of as few bits as can be; nothing where those are more than products of
/// three have room for in two words.
inline std::optional<double> whole_factor(std::initializer_list<Vector3> all) {
  constexpr int word = 50, most_bits = 39;
  double largest = 0;
  for (const Vector3& v : all) largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (largest == 0) return 1.0;
  const int exponent = std::ilogb(largest);
  if (std::abs(exponent) > 900) return {};
  const double factor = std::ldexp(1.0, word - 1 - exponent);
  std::uint64_t bits = 0;
  for (const Vector3& v : all) {
    for (const double x : {v.x, v.y, v.z}) {
      const double y = x * factor;
      const auto whole = static_cast<std::int64_t>(y);
      if (static_cast<double>(whole) != y || (y == 0) != (x == 0)) return {};
      bits |= static_cast<std::uint64_t>(whole);
    }
  }
  const int zeros = std::countr_zero(bits);
  if (word - zeros > most_bits) return {};
  return std::ldexp(factor, -zeros);
}

inline std::optional<WholeShot> whole_shot(const AnyRay& ray, const Triangle3& triangle) {
  const auto vector = [](const Point3& p) { return Vector3{p.x, p.y, p.z}; };
  const auto& [a, b, c] = triangle;
  const auto by = whole_factor({vector(a), vector(b), vector(c), vector(ray.origin), vector(ray.end)});
  if (!by) return {};
  const auto direction_by = whole_factor({ray.direction});
  if (!direction_by) return {};
  const auto at = [&](const Point3& p) { return Point3{p.x * *by, p.y * *by, p.z * *by}; };
  WholeShot shot{ray, {at(a), at(b), at(c)}};
  shot.ray.origin = at(ray.origin), shot.ray.end = at(ray.end);
  const double d = *direction_by;
  shot.ray.direction = {ray.direction.x * d, ray.direction.y * d, ray.direction.z * d};
  return shot;
}

}  // namespace plumb::query
