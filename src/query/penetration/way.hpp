// Which way does a body move, to be parted from another?  A direction said by a few points of their difference, over
// any number type.
//
// Laws: of three points it is the normal of their plane, turned round: they are counterclockwise seen from where the
// difference is not.  Of one or two it leads from the origin to the nearest point of their affine hull.  A flat
// difference has ways at right angles to it.
// Source: RTCD 9.3.8.
// Cost: some 10 to 30 operations.
#pragma once

#include "query/penetration/difference.hpp"

namespace plumb::query::parting {

class Way {
 public:
  /// Out through the plane of a facet.
  static Way through(const std::array<Ends, 3>& facet) { return {Kind::plane, facet}; }
  /// To the nearest point of two, of the line through them.
  static Way to_point(const Ends& p) { return {Kind::point, {p, p, p}}; }
  static Way to_line(const Ends& p, const Ends& q) { return {Kind::line, {p, q, q}}; }
  /// At right angles to the line through two, as far against an axis as can be.
  static Way beside_line(const Ends& p, const Ends& q, int axis) { return {Kind::beside, {p, q, q}, axis}; }
  static Way against_axis(int axis) { return {Kind::axis, {}, axis}; }

  template <class T>
  [[nodiscard]] Vec<T> along(const Difference& d) const {
    const T zero(0.0), one(1.0);
    const Vec<T> axis{axis_ == 0 ? one : zero, axis_ == 1 ? one : zero, axis_ == 2 ? one : zero};
    if (kind_ == Kind::axis) return Vec<T>{zero, zero, zero} - axis;
    const Vec<T> p = d.at<T>(of_[0]);
    if (kind_ == Kind::point) return p;
    const Vec<T> u = d.at<T>(of_[1]) - p;
    if (kind_ == Kind::line) return cross(u, cross(p, u));
    if (kind_ == Kind::beside) return cross(u, cross(u, axis));
    return cross(d.at<T>(of_[2]) - p, u);
  }
  /// What is level, where the way leads out through a plane; else one corner of each body.
  [[nodiscard]] KnownPlane known(const Difference& d) const {
    if (kind_ == Kind::plane) return {d, of_};
    return {d, {of_[0], of_[0], of_[0]}};
  }
  /// One of the points.
  [[nodiscard]] const Ends& from() const { return of_[0]; }

 private:
  enum class Kind : unsigned char { plane, point, line, beside, axis };
  Way(Kind kind, const std::array<Ends, 3>& of, int axis = 0) : kind_(kind), of_(of), axis_(axis) {}

  Kind kind_;
  std::array<Ends, 3> of_;
  int axis_;
};

/// The order of two directions: by x, then y, then z of the vectors of length 1.
Sign compare_directions(const Difference& d, const Way& v, const Way& w);

}  // namespace plumb::query::parting
