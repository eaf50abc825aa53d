// Which way does a body move, to be parted from another?  A direction said by a few points of their difference, over
// any number type.
//
// Laws: of three points it is the normal of their plane, turned round: they are counterclockwise seen from where the
// difference is not.  Of one or two it leads from the origin to the nearest point of their affine hull.  A flat
// difference has ways at right angles to it.
// Source: RTCD 9.3.8.
// Cost: some 10 to 30 operations.
#pragma once

#include <array>
#include <optional>

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
  /// Along an axis of space, up or down; the point is one of those that it leads out through.
  static Way along_axis(int axis, bool up, const Ends& p) { return {Kind::axis, {p, p, p}, axis, up}; }

  /// Along u x v; the point as before.
  static Way across(const Vector3& u, const Vector3& v, const Ends& p) {
    Way way(Kind::across, {p, p, p});
    way.u_ = u, way.v_ = v;
    return way;
  }

  template <class T>
  [[nodiscard]] Vec<T> along(const Difference& d) const {
    const T zero(0.0), one(1.0);
    const Vec<T> axis{axis_ == 0 ? one : zero, axis_ == 1 ? one : zero, axis_ == 2 ? one : zero};
    if (kind_ == Kind::axis) return is_up_ ? axis : Vec<T>{zero, zero, zero} - axis;
    if (kind_ == Kind::across) return cross(arith::vec<T>(u_), arith::vec<T>(v_));
    if (kind_ == Kind::point) return d.at<T>(of_[0]);
    const Vec<T> u = d.between<T>(of_[0], of_[1]);
    if (kind_ == Kind::line) return cross(u, cross(d.at<T>(of_[0]), u));
    if (kind_ == Kind::beside) return cross(u, cross(u, axis));
    return cross(d.between<T>(of_[0], of_[2]), u);
  }
  /// What is level, where the way leads out through a plane or back from a line; else one corner of each body.
  [[nodiscard]] KnownPlane known(const Difference& d) const {
    if (kind_ == Kind::plane || kind_ == Kind::line) return {d, of_};
    return {d, {of_[0], of_[0], of_[0]}};
  }
  /// Out through a plane before which nothing lies?
  [[nodiscard]] bool is_through_plane() const { return kind_ == Kind::plane; }
  [[nodiscard]] const std::array<Ends, 3>& facet() const { return of_; }
  [[nodiscard]] bool is_along_axis() const { return kind_ == Kind::axis; }
  /// Vectors as given of which it is the cross product, where it is one.
  [[nodiscard]] std::optional<std::array<Vector3, 2>> spanned_by() const {
    if (kind_ == Kind::across) return std::array{u_, v_};
    if (kind_ != Kind::axis) return {};
    const auto axis = [](int k) { return Vector3{k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0}; };
    const int next = (axis_ + 1) % 3, last = (axis_ + 2) % 3;
    return std::array{axis(is_up_ ? next : last), axis(is_up_ ? last : next)};
  }
  /// One of the points.
  [[nodiscard]] const Ends& from() const { return of_[0]; }
  /// Seen along it, is corner j of the other body on the line through corners i and k of this one (0 or 1)?  So it is
  /// where the way leads to the point of these two, or from the one to the edge.
  [[nodiscard]] bool is_before(std::size_t body, std::uint32_t i, std::uint32_t k, std::uint32_t j) const {
    const Ends &p = of_[0], &q = of_[1];
    if (j != p[1 - body]) return false;
    if (kind_ == Kind::point) return i == p[body] || k == p[body];
    if (kind_ != Kind::line || j != q[1 - body]) return false;
    return (i == p[body] && k == q[body]) || (i == q[body] && k == p[body]);
  }

 private:
  enum class Kind : unsigned char { plane, point, line, beside, axis, across };
  Way(Kind kind, const std::array<Ends, 3>& of, int axis = 0, bool is_up = false)
      : kind_(kind), of_(of), axis_(axis), is_up_(is_up) {}

  Kind kind_;
  std::array<Ends, 3> of_;
  int axis_;
  bool is_up_;
  Vector3 u_{}, v_{};
};

/// The order of two directions: by x, then y, then z of the vectors of length 1.
Sign compare_directions(const Difference& d, const Way& v, const Way& w);

}  // namespace plumb::query::parting
