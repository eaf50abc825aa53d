// Orthogonal projection: where does the perpendicular from p meet a point, a line or a plane?  Over any number type
// with + - *.
//
// Laws: the foot is from + along * part / whole with whole > 0; the square of its distance from p is square() / over().
// Source: RTCD 5.1.1, 5.1.2.
// Cost: a line 6 products, a plane 6; square() of a line 9 more.
#pragma once

#include "arith/vec.hpp"

namespace plumb::query {

using arith::cross, arith::dot, arith::vec, arith::Vec;

/// What p is nearest to: itself where it is in the shape.
enum class Carrier : unsigned char { itself, point, line, plane };

template <class T>
struct Foot {
  Carrier carrier;
  Vec<T> from, along;
  Vec<T> off;  // p - from
  T part, whole;

  [[nodiscard]] T square() const {
    if (carrier == Carrier::itself) return T(0.0);
    if (carrier == Carrier::point) return dot(off, off);
    if (carrier == Carrier::plane) return part * part;
    const Vec<T> c = cross(off, along);
    return dot(c, c);
  }
  [[nodiscard]] T over() const { return carrier == Carrier::line || carrier == Carrier::plane ? whole : T(1.0); }
};

template <class T>
Vec<T> no_vector() {
  return {T(0.0), T(0.0), T(0.0)};
}

template <class T>
Foot<T> foot_of_itself(const Vec<T>& p) {
  return {Carrier::itself, p, no_vector<T>(), no_vector<T>(), T(0.0), T(1.0)};
}
template <class T>
Foot<T> foot_on_point(const Vec<T>& point, const Vec<T>& p) {
  return {Carrier::point, point, no_vector<T>(), p - point, T(0.0), T(1.0)};
}
/// For a direction that is not zero.
template <class T>
Foot<T> foot_on_line(const Vec<T>& point, const Vec<T>& direction, const Vec<T>& p) {
  const Vec<T> off = p - point;
  return {Carrier::line, point, direction, off, dot(off, direction), dot(direction, direction)};
}
/// On the plane where normal . x is by `above` less than for p; the normal is not zero.
template <class T>
Foot<T> foot_on_plane(const Vec<T>& normal, const T& above, const Vec<T>& p) {
  return {Carrier::plane, p, normal, no_vector<T>(), T(0.0) - above, dot(normal, normal)};
}

}  // namespace plumb::query
