// Which oriented boxes do the tests of boxes share, and does a box contain a point, in rationals?
//
// Law: the rational judge solves the linear system by elimination; it shares no formula with the library.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cmath>

#include "plumb/degenerate.hpp"
#include "plumb/figure/basic/box.hpp"

namespace plumb::obb_cases {

inline Obb3 lifted(const Obb2& b) {
  const auto up = [](const Vector2& v) { return Vector3{v.x, v.y, 0}; };
  return {{b.center.x, b.center.y, 0}, {up(b.axes[0]), up(b.axes[1]), Vector3{0, 0, 0}}, {b.half.x, b.half.y, 0}};
}

using Rational3 = std::array<mpq_class, 3>;
template <class V>
Rational3 rational(const V& v) {
  return {mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)};
}

/// t with p - center = sum of t_i axes_i, by Gauss-Jordan; false where the axes are dependent.
inline bool solved(const Obb3& box, const Rational3& p, Rational3& t) {
  const Rational3 c = rational(box.center);
  std::array<std::array<mpq_class, 4>, 3> m;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t i = 0; i < 3; ++i) m[row][i] = rational(box.axes[i])[row];
    m[row][3] = p[row] - c[row];
  }
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t pivot = k;
    while (pivot < 3 && m[pivot][k] == 0) ++pivot;
    if (pivot == 3) return false;
    std::swap(m[pivot], m[k]);
    for (std::size_t row = 0; row < 3; ++row) {
      if (row == k) continue;
      const mpq_class factor = m[row][k] / m[k][k];
      for (std::size_t i = k; i < 4; ++i) m[row][i] -= factor * m[k][i];
    }
  }
  for (std::size_t k = 0; k < 3; ++k) t[k] = m[k][3] / m[k][k];
  return true;
}

/// Of a box with independent axes.
inline bool holds(const Obb3& box, const Rational3& p) {
  Rational3 t;
  if (!solved(box, p, t)) return false;
  return abs(t[0]) <= abs(mpq_class(box.half.x)) && abs(t[1]) <= abs(mpq_class(box.half.y)) &&
         abs(t[2]) <= abs(mpq_class(box.half.z));
}
inline bool holds(const Obb3& box, const Point3& p) { return holds(box, rational(p)); }

/// Has the box no interior?
inline bool is_flat(const Obb3& box) {
  Rational3 t;
  return box.half.x == 0 || box.half.y == 0 || box.half.z == 0 || !solved(box, rational(box.center), t);
}

/// The corners in rationals.
inline std::array<Rational3, 8> exact_corners(const Obb3& box) {
  std::array<Rational3, 8> all;
  const std::array half{box.half.x, box.half.y, box.half.z};
  for (std::size_t i = 0; i < 8; ++i) {
    all[i] = rational(box.center);
    for (std::size_t k = 0; k < 3; ++k) {
      const mpq_class by = (i >> k & 1) != 0 ? mpq_class(half[k]) : mpq_class(-half[k]);
      const Rational3 axis = rational(box.axes[k]);
      for (std::size_t x = 0; x < 3; ++x) all[i][x] += by * axis[x];
    }
  }
  return all;
}

/// A box of right angles up to rounding.
inline Obb3 turned(Entropy& entropy) {
  std::array<double, 4> q{};
  double square = 0;
  for (double& x : q) {
    x = signed_unit_coordinate(entropy);
    square += x * x;
  }
  const double length = std::sqrt(square > 0 ? square : 1);
  for (double& x : q) x /= length;
  const auto [w, x, y, z] = q;
  const auto half = [&] { return 0.25 + unit_coordinate(entropy); };
  return {{signed_unit_coordinate(entropy), signed_unit_coordinate(entropy), signed_unit_coordinate(entropy)},
          {Vector3{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
           Vector3{2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
           Vector3{2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}},
          {half(), half(), half()}};
}

}  // namespace plumb::obb_cases
