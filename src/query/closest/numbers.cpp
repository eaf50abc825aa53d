#include "query/closest/numbers.hpp"

#include <optional>

#include "arith/exact_number.hpp"
#include "arith/rounded_radical.hpp"

namespace plumb::query {
namespace {

bool on_carrier(Carrier c) { return c == Carrier::line || c == Carrier::plane; }

struct Quick {
  Vec<Ball> at;
  Ball distance;  // of p from there
};

Quick quick_numbers(const Foot<Ball>& f, bool distance) {
  Quick q{f.from, Ball{0.0}};
  if (f.carrier == Carrier::itself) return q;
  if (f.carrier == Carrier::point) {
    if (distance) q.distance = root(dot(f.off, f.off));
    return q;
  }
  const Ball t = quotient(f.part, f.whole);
  const Vec<Ball> way = f.along * t;
  q.at = f.from + way;
  if (!distance) return q;
  if (f.carrier == Carrier::plane) {
    q.distance = magnitude(t) * root(f.whole);
  } else {
    const Vec<Ball> rest = f.off - way;
    q.distance = root(dot(rest, rest));
    if (!q.distance.nearest()) q.distance = root(quotient(f.square(), f.over()));  // near to the line digits cancel
  }
  return q;
}

/// Numerators over one denominator, which is positive.
struct FootIntegers {
  Vec<BigDyadic> at;
  BigDyadic weight;
  BigDyadic square, over;
};

FootIntegers exact_numbers(const Foot<BigDyadic>& f) {
  if (!on_carrier(f.carrier)) return {f.from, BigDyadic(1.0), f.square(), BigDyadic(1.0)};
  return {f.from * f.whole + f.along * f.part, f.whole, f.square(), f.over()};
}

constexpr Rounding to_nearest = Rounding::nearest;

std::optional<Point3> nearest_doubles(const Vec<Ball>& v) {
  const std::optional<double> x = v.x.nearest(), y = v.y.nearest(), z = v.z.nearest();
  if (!x || !y || !z) return {};
  return Point3{*x, *y, *z};
}

Point3 point_by_integers(const FootIntegers& e, const Point3& p, double radius) {
  if (radius == 0) {
    const auto rounded = [&](const BigDyadic& x) { return plumb::rounded_quotient(to_nearest, x, e.weight); };
    return {rounded(e.at.x), rounded(e.at.y), rounded(e.at.z)};
  }
  // With the way v to p from the foot c: c + v r / sqrt(s / o) = (c s + v r sqrt(s o)) / s.
  const Vec<BigDyadic> way = vec<BigDyadic>(p) * e.weight - e.at;
  const BigDyadic whole = e.weight * e.square, under = e.square * e.over, r(radius);
  const auto rounded = [&](const BigDyadic& at, const BigDyadic& v) {
    return rounded_radical(to_nearest, at * e.square, v * r, under, whole);
  };
  return {rounded(e.at.x, way.x), rounded(e.at.y, way.y), rounded(e.at.z, way.z)};
}

double distance_by_integers(const FootIntegers& e, double radius) {
  if (radius == 0) return plumb::rounded_root(to_nearest, e.square, e.over);
  return rounded_radical(to_nearest, BigDyadic(-radius) * e.over, BigDyadic(1.0), e.square * e.over, e.over);
}

}  // namespace

NearestNumbers numbers(Wanted wanted, const Foot<Ball>& foot, const Point3& p, double radius,
                       const ExactFoot& exactly) {
  if (foot.carrier == Carrier::itself) return {{p.x + 0.0, p.y + 0.0, p.z + 0.0}, 0};  // never -0
  const bool point = wanted != Wanted::distance, distance = wanted != Wanted::point;
  Quick q = quick_numbers(foot, distance || radius != 0);
  if (radius != 0) {
    if (point) q.at = q.at + (vec<Ball>(p) - q.at) * quotient(Ball{radius}, q.distance);
    q.distance = q.distance - Ball{radius};
  }
  const std::optional<Point3> at = point ? nearest_doubles(q.at) : Point3{};
  const std::optional<double> d = distance ? q.distance.nearest() : 0;
  if (at && d) [[likely]]
    return {*at, *d};
  const FootIntegers e = exact_numbers(exactly());
  return {at ? *at : point_by_integers(e, p, radius), d ? *d : distance_by_integers(e, radius)};
}

Rational rational_square(const Foot<BigDyadic>& foot) {
  return exact_number(foot.square()) / exact_number(foot.over());
}

double rounded_part(const Foot<Ball>& foot, const ExactFoot& exactly) {
  if (const std::optional<double> quick = quotient(foot.part, foot.whole).nearest()) [[likely]]
    return *quick;
  const Foot<BigDyadic> f = exactly();
  return plumb::rounded_quotient(to_nearest, f.part, f.whole);
}

}  // namespace plumb::query
