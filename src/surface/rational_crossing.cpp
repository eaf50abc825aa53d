#include "surface/rational_crossing.hpp"

#include <algorithm>
#include <array>

namespace plumb::surface {
namespace {

struct Seen {
  Rational u, v;
};
/// Along an axis, as orient2d turns in the plane of the other two.
Seen seen(const RationalPoint3& p, int axis) {
  return axis == 0 ? Seen{p.y, p.z} : axis == 1 ? Seen{p.z, p.x} : Seen{p.x, p.y};
}
RationalPoint3 exact(const Point3& p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }

Sign turn(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& p, int axis) {
  const Seen from = seen(a, axis), to = seen(b, axis), at = seen(p, axis);
  return ((to.u - from.u) * (at.v - from.v) - (to.v - from.v) * (at.u - from.u)).sign();
}

/// The sign of orient3d.
Sign below(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c, const RationalPoint3& p) {
  const auto minus = [&](const RationalPoint3& q) { return RationalPoint3{q.x - a.x, q.y - a.y, q.z - a.z}; };
  const RationalPoint3 u = minus(b), v = minus(c), w = minus(p);
  return -(u.x * (v.y * w.z - v.z * w.y) + u.y * (v.z * w.x - v.x * w.z) + u.z * (v.x * w.y - v.y * w.x)).sign();
}

bool in_range(double a, double b, double c, const Rational& x) {
  return !(x < Rational(std::min({a, b, c}))) && !(Rational(std::max({a, b, c})) < x);
}

/// Of a point in the box of the triangle and in its plane.
bool is_on(const std::array<RationalPoint3, 3>& t, const RationalPoint3& p) {
  const auto& [a, b, c] = t;
  bool flat = true;
  for (const int axis : {0, 1, 2}) {
    const Sign whole = turn(a, b, c, axis);
    if (whole == Sign::zero) continue;
    flat = false;
    for (const Sign s : {turn(a, b, p, axis), turn(b, c, p, axis), turn(c, a, p, axis)})
      if (s == -whole) return false;
  }
  if (!flat) return true;
  // Without area it is the longest of its edges, whose box is the triangle's.
  for (const int axis : {0, 1, 2})
    for (const Sign s : {turn(a, b, p, axis), turn(b, c, p, axis), turn(c, a, p, axis)})
      if (s != Sign::zero) return false;
  return true;
}

/// The side of the edge from a to b on which the moved p lies; zero only where a and b are seen as one point.
Sign moved_side(const Point3& a, const Point3& b, const RationalPoint3& p) {
  if (const Sign s = turn(exact(a), exact(b), p, 0); s != Sign::zero) return s;
  return a.z != b.z ? sign_of_number(a.z - b.z) : sign_of_number(b.y - a.y);
}

}  // namespace

RationalPoint3 middle_of(const Triangle3& t) {
  const auto mean = [](double a, double b, double c) {
    return Rational(0.25) * (Rational(2.0) * Rational(a) + Rational(b) + Rational(c));
  };
  return {mean(t.a.x, t.b.x, t.c.x), mean(t.a.y, t.b.y, t.c.y), mean(t.a.z, t.b.z, t.c.z)};
}

Crossing crossing_of(const Triangle3& triangle, const RationalPoint3& p) {
  const auto& [a, b, c] = triangle;
  if (!in_range(a.y, b.y, c.y, p.y) || !in_range(a.z, b.z, c.z, p.z)) return Crossing::none;
  if (Rational(std::max({a.x, b.x, c.x})) < p.x) return Crossing::none;
  const bool beyond = p.x < Rational(std::min({a.x, b.x, c.x}));
  const std::array<RationalPoint3, 3> t{exact(a), exact(b), exact(c)};
  const Sign side = beyond ? Sign::zero : below(t[0], t[1], t[2], p);
  if (!beyond && side == Sign::zero && is_on(t, p)) return Crossing::on_triangle;
  const Sign way = moved_side(a, b, p);
  if (way == Sign::zero || moved_side(b, c, p) != way || moved_side(c, a, p) != way) return Crossing::none;
  return beyond || side == way ? Crossing::crossed : Crossing::none;
}

}  // namespace plumb::surface
