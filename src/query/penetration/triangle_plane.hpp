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

#include "plumb/certify/certainly.hpp"

namespace plumb::query::parting {

/// Over numbers that are differences of two coordinates.
template <class N>
struct TrianglePlane {
  using Corner = std::array<N, 3>;
  using Product = decltype((N() - N()) * (N() - N()) - (N() - N()) * (N() - N()));

  std::array<Product, 3> normal;
  decltype(Product() * N() + Product() * N() + Product() * N()) height;
  decltype(Product() * Product() + Product() * Product() + Product() * Product()) square;  // of the normal's length

  TrianglePlane() {}  // NOLINT: nothing is computed of nothing
  TrianglePlane(const Corner& p, const Corner& q, const Corner& r)
      : normal(across(p, q, r)),
        height(normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2]),
        square(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]) {}

  /// Above zero where the plane is farther than the length, on either side.
  [[nodiscard]] auto farther_than(const N& length) const { return height * height - length * length * square; }
  /// How much further a point lies than another one, along the normal.
  [[nodiscard]] auto along(const N& x, const N& y, const N& z) const {
    return normal[0] * x + normal[1] * y + normal[2] * z;
  }

 private:
  static std::array<Product, 3> across(const Corner& p, const Corner& q, const Corner& r) {
    const auto ux = q[0] - p[0], uy = q[1] - p[1], uz = q[2] - p[2];
    const auto vx = r[0] - p[0], vy = r[1] - p[1], vz = r[2] - p[2];
    return {uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx};
  }
};

/// Corner i of the triangle is a[i] - b[i].
struct TrianglePairs {
  std::array<Point3, 3> a, b;
};

struct PassesBeyond {
  static constexpr int highest = 6;
  static constexpr Scales scales{.count = 1, .maxima = 1};

  template <class W>
  bool operator()(W& w, const TrianglePairs& of, double length) const {
    using N = decltype(w.difference(0.0, 0.0));
    const auto corner = [&](std::size_t i) {
      const Point3 &a = of.a[i], &b = of.b[i];
      return std::array<N, 3>{w.difference(a.x, b.x), w.difference(a.y, b.y), w.difference(a.z, b.z)};
    };
    const TrianglePlane<N> plane(corner(0), corner(1), corner(2));
    return w.sign(plane.height) == Sign::positive &&
           w.sign(plane.farther_than(w.difference(length, 0.0))) == Sign::positive;
  }
};

}  // namespace plumb::query::parting
