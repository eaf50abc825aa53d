// Signs at exact points: over intervals first, over integers for certain.
#include "plumb/query/exact_point.hpp"

#include <cmath>
#include <string>

#include "plumb/arith/error.hpp"
#include "plumb/predicates.hpp"
#include "query/exact_coordinates.hpp"

namespace plumb {
namespace {

using meeting::coordinates_in, meeting::Weighted;

template <class T>
T minor2(const T& a, const T& b, const T& c, const T& d) {
  return a * d - b * c;
}
template <class T, std::size_t N>
T minor3(const Weighted<T, N>& p, const Weighted<T, N>& q, const Weighted<T, N>& r, std::size_t i, std::size_t j) {
  return p.weight * minor2(q.at[i], q.at[j], r.at[i], r.at[j]) - q.weight * minor2(p.at[i], p.at[j], r.at[i], r.at[j]) +
         r.weight * minor2(p.at[i], p.at[j], q.at[i], q.at[j]);
}

/// The sign that `value` gives over each kind of number, times those of the weights.
template <class Value, class... Points>
Sign sign_at(const char* question, const Value& value, const Points&... points) {
  const auto in = [&]<class T>(T) {
    const auto coordinates = std::array{coordinates_in<T>(points)...};
    Sign s = Sign::positive;
    bool certain = true;
    const auto take = [&](const T& x) {
      if constexpr (std::is_same_v<T, Interval>) {
        certain = certain && x.sign().certain();
        if (certain) s = s * x.sign().value();
      } else {
        s = s * x.sign();
      }
    };
    for (const auto& p : coordinates) {
      take(p.weight);
      if (certain && s == Sign::zero)
        throw DegeneratePoint(std::string(question).append(": a construction of an exact point has no point"));
    }
    take(std::apply(value, coordinates));
    return certain ? Unsure<Sign>(s) : Unsure<Sign>();
  };
  if (const Unsure<Sign> s = in(Interval(0.0)); s.certain()) return s.value();
  return in(BigDyadic()).value();
}

template <std::size_t N, class Point>
Sign compare(const char* question, const Point& a, const Point& b) {
  for (std::size_t axis = 0; axis < N; ++axis) {
    const auto order = [axis](const auto& p, const auto& q) { return p.at[axis] * q.weight - q.at[axis] * p.weight; };
    if (const Sign s = sign_at(question, order, a, b); s != Sign::zero) return s;
  }
  return Sign::zero;
}

double nearest(const Rational& x, char axis) {
  const double r = x.rounded(Rounding::nearest);
  if (std::isinf(r))
    throw BeyondDoubles(std::string("approximate: a.").append(1, axis).append(" is beyond the largest double"));
  return r;
}
Point2 nearest(const RationalPoint2& p) { return {nearest(p.x, 'x'), nearest(p.y, 'y')}; }
Point3 nearest(const RationalPoint3& p) { return {nearest(p.x, 'x'), nearest(p.y, 'y'), nearest(p.z, 'z')}; }

template <class Result, class Point>
Result nearest_of(const Point& a) {
  return std::visit(
      [](const auto& p) -> Result {
        using P = std::remove_cvref_t<decltype(p)>;
        if constexpr (std::is_same_v<P, RationalPoint2> || std::is_same_v<P, RationalPoint3>) {
          return nearest(p);
        } else {
          return approximate(p);
        }
      },
      a.as);
}

template <class Point>
auto rational_of(const Point& a) {
  const auto p = coordinates_in<BigDyadic>(a);
  if (p.weight.sign() == Sign::zero) throw DegeneratePoint("rational_point: the construction of a has no point");
  return meeting::rational(p);
}

}  // namespace

Point2 approximate(const ExactPoint2& a) { return nearest_of<Point2>(a); }
Point3 approximate(const ExactPoint3& a) { return nearest_of<Point3>(a); }

RationalPoint2 rational_point(const ExactPoint2& a) { return rational_of(a); }
RationalPoint3 rational_point(const ExactPoint3& a) { return rational_of(a); }

Sign compare_xy(const ExactPoint2& a, const ExactPoint2& b) { return compare<2>("compare_xy", a, b); }
Sign compare_xyz(const ExactPoint3& a, const ExactPoint3& b) { return compare<3>("compare_xyz", a, b); }

Sign orient2d(const ExactPoint2& a, const ExactPoint2& b, const ExactPoint2& c) {
  return sign_at(
      "orient2d", [](const auto& p, const auto& q, const auto& r) { return minor3(p, q, r, 0, 1); }, a, b, c);
}

Sign orient3d(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c, const ExactPoint3& d) {
  // The determinant of the rows x y z w by its last two columns.
  const auto value = [](const auto& p, const auto& q, const auto& r, const auto& s) {
    const auto xy = [](const auto& u, const auto& v) { return minor2(u.at[0], u.at[1], v.at[0], v.at[1]); };
    const auto zw = [](const auto& u, const auto& v) { return minor2(u.at[2], u.weight, v.at[2], v.weight); };
    return xy(p, q) * zw(r, s) - xy(p, r) * zw(q, s) + xy(p, s) * zw(q, r) + xy(q, r) * zw(p, s) - xy(q, s) * zw(p, r) +
           xy(r, s) * zw(p, q);
  };
  return sign_at("orient3d", value, a, b, c, d);
}

bool collinear(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
    const auto value = [i, j](const auto& p, const auto& q, const auto& r) { return minor3(p, q, r, i, j); };
    if (sign_at("collinear", value, a, b, c) != Sign::zero) return false;
  }
  return true;
}

}  // namespace plumb
