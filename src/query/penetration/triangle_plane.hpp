// Expanding polytope: does the plane of a triangle of a Minkowski difference pass the origin on the outer side, farther
// than a given length?  A statement over any world of numbers.
//
// The normal n is the cross product of two edges, the plane's height n . p, so that its distance is height / |n|: farther
// than a length where the height is above zero and its square is above length^2 n . n.
// Laws: those of certify/world.hpp.  The scale is the largest of all leaves, in which a NaN is not seen; but the height
// of a triangle is NaN where one of its leaves is, and then it is not above zero.
// Source: van den Bergen 2001.
// Cost: 35 operations for the plane, 5 for the judgement.
#pragma once

#include <array>
#include <utility>

#include "plumb/arith/point.hpp"
#include "plumb/certify/certainly.hpp"

namespace plumb::query::parting {

/// Over numbers that are differences of two coordinates.
template <class N>
struct TrianglePlane {
  using Corner = std::array<N, 3>;
  template <class X, class Y>
  using Product = decltype(std::declval<X>() * std::declval<Y>());
  template <class X>
  using Sum = decltype(std::declval<X>() + std::declval<X>());
  template <class X>
  using Dot = decltype(std::declval<X>() + std::declval<X>() + std::declval<X>());
  using Normal = Sum<Product<Sum<N>, Sum<N>>>;

  std::array<Normal, 3> normal;
  Dot<Product<Normal, N>> height;
  Dot<Product<Normal, Normal>> square;  // of the normal's length

  TrianglePlane() {}  // NOLINT: nothing is computed of nothing
  TrianglePlane(const Corner& p, const Corner& q, const Corner& r)
      : normal(across(p, q, r)),
        height(along(p)),
        square(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]) {}

  /// Above zero where the plane is farther than the length, on either side.
  [[nodiscard]] auto farther_than(const N& length) const { return height * height - length * length * square; }
  /// How far a way leads along the normal.
  [[nodiscard]] auto along(const Corner& way) const {
    return normal[0] * way[0] + normal[1] * way[1] + normal[2] * way[2];
  }

 private:
  static std::array<Normal, 3> across(const Corner& p, const Corner& q, const Corner& r) {
    const auto ux = q[0] - p[0], uy = q[1] - p[1], uz = q[2] - p[2];
    const auto vx = r[0] - p[0], vy = r[1] - p[1], vz = r[2] - p[2];
    return {uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx};
  }
};

/// From one point to another.
template <class W>
auto way_in(W& w, const Point3& from, const Point3& to) {
  using N = decltype(w.difference(0.0, 0.0));
  return std::array<N, 3>{w.difference(to.x, from.x), w.difference(to.y, from.y), w.difference(to.z, from.z)};
}

/// Corner i of the triangle is a[i] - b[i].
struct TrianglePairs {
  std::array<Point3, 3> a, b;

  template <class W>
  [[nodiscard]] auto plane(W& w) const {
    using N = decltype(w.difference(0.0, 0.0));
    return TrianglePlane<N>(way_in(w, b[0], a[0]), way_in(w, b[1], a[1]), way_in(w, b[2], a[2]));
  }
};

/// Does the plane pass the origin on the outer side, farther than a length that is not negative?
struct PassesBeyond {
  static constexpr int highest = 6;
  static constexpr Scales scales{.count = 1, .maxima = 1};

  template <class W>
  bool operator()(W& w, const TrianglePairs& of, double length) const {
    const auto plane = of.plane(w);
    return w.sign(plane.height) == Sign::positive &&
           w.sign(plane.farther_than(w.difference(length, 0.0))) == Sign::positive;
  }
};

/// How does a way from one point of a body to another lead along the normal of the plane?
struct LeadsAlong {
  static constexpr int highest = PassesBeyond::highest;
  static constexpr Scales scales = PassesBeyond::scales;

  template <class W>
  Sign operator()(W& w, const TrianglePairs& of, const Point3& from, const Point3& to) const {
    const auto plane = of.plane(w);
    return w.sign(plane.along(way_in(w, from, to)));
  }
};

}  // namespace plumb::query::parting
