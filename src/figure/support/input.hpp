// What do support mappings refuse, and how do their numbers look at a direction?
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "figure/basic/finite_parts.hpp"
#include "figure/basic/signed_sums.hpp"
#include "plumb/figure/basic/sound.hpp"

namespace plumb::figure::support {

constexpr bool is_zero(const Vector3& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

constexpr Point3 raised(const Point2& p) { return {p.x, p.y, 0}; }
constexpr Vector3 raised(const Vector2& v) { return {v.x, v.y, 0}; }

/// The same direction, of a size at which products neither overflow nor vanish, where doubles hold that: a scaling,
/// exact.
inline Vector3 handy(const Vector3& d) {
  constexpr double least = 0x1p-200, greatest = 0x1p200;  // guesses of what is handy as it is
  const double most = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
  if (most == 0 || (most > least && most < greatest)) return d;
  const int by = std::ilogb(most);
  const auto scaled = [&](double x, int e) { return std::scalbn(x, e); };
  const Vector3 s{scaled(d.x, -by), scaled(d.y, -by), scaled(d.z, -by)};
  return Vector3{scaled(s.x, by), scaled(s.y, by), scaled(s.z, by)} == d ? s : d;
}

inline Point3 within_doubles(const Point3& p) {
  for (const auto& [x, part] : {std::pair{p.x, "point.x"}, {p.y, "point.y"}, {p.z, "point.z"}})
    figure::within_doubles(x, "support_point", part);
  return p;
}

}  // namespace plumb::figure::support
