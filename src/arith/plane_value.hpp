// What is the sign of normal . p - offset, exactly, without large integers?
//
// Laws: exact where an answer is given; none where a product is too small or too large for its error to be a double.
// Method: three products and their errors are added up into parts that do not overlap, of which the largest that is not
// zero has the sign.
// Source: Shewchuk 1997 (expansions).
// Cost: some 50 ns.
#pragma once

#include <array>
#include <optional>

#include "plumb/arith/error_free.hpp"
#include "plumb/arith/point.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb {

inline std::optional<Sign> sign_of_plane_value(const Vector3& normal, double offset, const Point3& p) {
  constexpr double least = 0x1p-900, most = 0x1p900;
  std::array<double, 7> parts{-offset};  // ascending, none overlaps another
  std::size_t count = 1;
  double range = offset < 0 ? -offset : offset;
  const auto add = [&](double x) {
    for (std::size_t i = 0; i < count; ++i) {
      const Rounded sum = two_sum(x, parts[i]);
      parts[i] = sum.error;
      x = sum.value;
    }
    parts[count++] = x;
  };
  bool safe = true;
  const auto add_product = [&](double a, double b) {
    if (a == 0 || b == 0) return;
    const Rounded r = two_product(a, b);
    const double size = r.value < 0 ? -r.value : r.value, factor = a < 0 ? -a : a, other = b < 0 ? -b : b;
    safe = safe && size > least && size < most && factor < most && other < most;
    range = range > size ? range : size;
    add(r.error);
    add(r.value);
  };
  add_product(normal.x, p.x);
  add_product(normal.y, p.y);
  add_product(normal.z, p.z);
  if (!safe || !(range < most)) return {};
  for (std::size_t i = count; i-- > 0;) {
    if (parts[i] != 0) return parts[i] > 0 ? Sign::positive : Sign::negative;
  }
  return Sign::zero;
}

}  // namespace plumb
