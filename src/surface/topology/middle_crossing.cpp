#include "surface/topology/middle_crossing.hpp"

#include <algorithm>
#include <array>

#include "figure/basic/signed_sums.hpp"

namespace plumb::surface {
namespace {

using arith::exact_sum::sign;
using figure::signed_sums::cross;
using figure::signed_sums::dot;
using figure::signed_sums::vector;
using figure::signed_sums::VectorOf;

/// Four times the middle of a triangle, over any kind of number, and what signs say of it.
class Middle {
 public:
  explicit Middle(const Triangle3& of) : of_(of) {}

  /// Of a coordinate, less that of the middle.
  template <class Coordinate>
  [[nodiscard]] Sign beyond(double limit, const Coordinate& x) const {
    return sign([&](const auto& number) {
      return number(4.0) * number(limit) - (number(2.0) * number(x(of_.a)) + number(x(of_.b)) + number(x(of_.c)));
    });
  }
  /// As orient2d(a, b, middle) turns, seen along an axis.
  [[nodiscard]] Sign turn(const Point3& a, const Point3& b, int axis) const {
    return sign([&](const auto& number) {
      const auto from = vector(number, a), to = vector(number, b) - from, p = from_point(number, a);
      return axis == 0 ? to.y * p.z - to.z * p.y : axis == 1 ? to.z * p.x - to.x * p.z : to.x * p.y - to.y * p.x;
    });
  }
  /// orient3d(a, b, c, middle).
  [[nodiscard]] Sign below(const Triangle3& t) const {
    return -sign([&](const auto& number) {
      const auto a = vector(number, t.a);
      return dot(from_point(number, t.a), cross(vector(number, t.b) - a, vector(number, t.c) - a));
    });
  }

 private:
  template <class Maker>
  [[nodiscard]] VectorOf<Maker> from_point(const Maker& number, const Point3& a) const {
    return number(2.0) * vector(number, of_.a) + vector(number, of_.b) + vector(number, of_.c) -
           number(4.0) * vector(number, a);
  }
  const Triangle3& of_;
};

Sign turn(const Triangle3& t, int axis) {
  return sign([&](const auto& number) {
    const auto a = vector(number, t.a), u = vector(number, t.b) - a, v = vector(number, t.c) - a;
    return axis == 0 ? u.y * v.z - u.z * v.y : axis == 1 ? u.z * v.x - u.x * v.z : u.x * v.y - u.y * v.x;
  });
}

/// Of a middle in the box of the triangle and in its plane.
bool is_on(const Triangle3& t, const Middle& p) {
  bool flat = true;
  for (const int axis : {0, 1, 2}) {
    const Sign whole = turn(t, axis);
    if (whole == Sign::zero) continue;
    flat = false;
    for (const Sign s : {p.turn(t.a, t.b, axis), p.turn(t.b, t.c, axis), p.turn(t.c, t.a, axis)})
      if (s == -whole) return false;
  }
  if (!flat) return true;
  // Without area it is the longest of its edges, whose box is the triangle's.
  for (const int axis : {0, 1, 2})
    for (const Sign s : {p.turn(t.a, t.b, axis), p.turn(t.b, t.c, axis), p.turn(t.c, t.a, axis)})
      if (s != Sign::zero) return false;
  return true;
}

/// The side of the edge from a to b on which the moved middle lies; zero only where a and b are seen as one point.
Sign moved_side(const Point3& a, const Point3& b, const Middle& p) {
  if (const Sign s = p.turn(a, b, 0); s != Sign::zero) return s;
  return a.z != b.z ? sign_of_number(a.z - b.z) : sign_of_number(b.y - a.y);
}

}  // namespace

MiddleCrossing crossing_from_middle(const Triangle3& of, const Triangle3& t) {
  const Middle p(of);
  const auto x = [](const Point3& q) { return q.x; };
  const auto is_beside = [&](const auto& coordinate) {
    const auto [least, most] = std::minmax({coordinate(t.a), coordinate(t.b), coordinate(t.c)});
    return p.beyond(least, coordinate) == Sign::positive || p.beyond(most, coordinate) == Sign::negative;
  };
  if (is_beside([](const Point3& q) { return q.y; }) || is_beside([](const Point3& q) { return q.z; }))
    return MiddleCrossing::none;
  if (p.beyond(std::max({t.a.x, t.b.x, t.c.x}), x) == Sign::negative) return MiddleCrossing::none;
  const bool beyond = p.beyond(std::min({t.a.x, t.b.x, t.c.x}), x) == Sign::positive;
  const Sign below = beyond ? Sign::zero : p.below(t);
  if (!beyond && below == Sign::zero && is_on(t, p)) return MiddleCrossing::on_triangle;
  const Sign way = moved_side(t.a, t.b, p);
  if (way == Sign::zero || moved_side(t.b, t.c, p) != way || moved_side(t.c, t.a, p) != way)
    return MiddleCrossing::none;
  return beyond || below == way ? MiddleCrossing::crossed : MiddleCrossing::none;
}

}  // namespace plumb::surface
