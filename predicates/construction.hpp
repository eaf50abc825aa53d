// Where is a point that other points construct?  Each construction stated once, as base + offset / weight.
//
// The base is a coordinate as given; offset and weight are polynomials in differences.  So whatever compares two points
// subtracts their bases first, and is as sharp far from the origin as near it.
// Laws: moving all points of a construction by one vector moves the base and nothing else; the weight is zero exactly
// when the construction is degenerate (parallel lines, a line parallel to the plane, planes parallel to one line).
// Kinds are named here, with how many numbers they take; certify/detail/mixed.hpp makes formulas of them.
// Source: RTCD 5.1.9.1, 5.3.1, 5.4.5; Attene 2020, "Indirect predicates for geometric constructions"; base and offset
// kept apart: Guo and Fu 2024.  Degree of weight and offset: 2 and 3 (two lines), 3 and 4 (line and plane), 6 and 7
// (three planes).
#pragma once

#include <array>
#include <concepts>
#include <cstddef>

#include "plumb/predicates/determinant.hpp"
#include "plumb/predicates/weight.hpp"

namespace plumb::predicates {

/// The point base + offset / weight.
template <class Base, class Offset, class Weight, std::size_t N>
struct Located {
  std::array<Base, N> base;
  std::array<Offset, N> offset;
  Weight weight;
};
template <class Base, class Offset, class Weight, std::size_t N>
Located(std::array<Base, N>, std::array<Offset, N>, Weight) -> Located<Base, Offset, Weight, N>;

template <class A, class B>
constexpr auto dot3(const std::array<A, 3>& a, const std::array<B, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class A>
constexpr auto cross3(const std::array<A, 3>& a, const std::array<A, 3>& b) {
  return std::array{det2(a[1], a[2], b[1], b[2]), det2(a[2], a[0], b[2], b[0]), det2(a[0], a[1], b[0], b[1])};
}
/// q - p.
template <class T>
constexpr auto from_to3(const T* p, const T* q) {
  return std::array{q[0] - p[0], q[1] - p[1], q[2] - p[2]};
}
/// The normal of the plane of three points.
template <class T>
constexpr auto normal3(const T* plane) {
  return cross3(from_to3(plane, plane + 3), from_to3(plane, plane + 6));
}

struct ExplicitKind2 {
  static constexpr int dimension = 2, numbers = 2;
  template <class T>
  static constexpr auto at(const T* p) {
    return Located{std::array{p[0], p[1]}, std::array<TagZero, 2>{}, TagOne{}};
  }
};

struct ExplicitKind3 {
  static constexpr int dimension = 3, numbers = 3;
  template <class T>
  static constexpr auto at(const T* p) {
    return Located{std::array{p[0], p[1], p[2]}, std::array<TagZero, 3>{}, TagOne{}};
  }
};

/// a b c d: where the line ab meets the line cd.
struct LineLineKind2 {
  static constexpr int dimension = 2, numbers = 8;
  template <class T>
  static constexpr auto at(const T* p) {
    const auto ux = p[2] - p[0], uy = p[3] - p[1], vx = p[6] - p[4], vy = p[7] - p[5];
    const auto w = det2(ux, uy, vx, vy);
    const auto n = det2(p[4] - p[0], p[5] - p[1], vx, vy);
    return Located{std::array{p[0], p[1]}, std::array{n * ux, n * uy}, w};
  }
};

/// p q a b c: where the line pq meets the plane abc.
struct LinePlaneKind3 {
  static constexpr int dimension = 3, numbers = 15;
  template <class T>
  static constexpr auto at(const T* p) {
    const auto normal = normal3(p + 6);
    const auto u = from_to3(p, p + 3);
    const auto w = dot3(u, normal);
    const auto n = dot3(from_to3(p, p + 6), normal);
    return Located{std::array{p[0], p[1], p[2]}, std::array{n * u[0], n * u[1], n * u[2]}, w};
  }
};

/// Three points for each of three planes: where the planes meet.
struct ThreePlaneKind3 {
  static constexpr int dimension = 3, numbers = 27;
  template <class T>
  static constexpr auto at(const T* p) {
    const auto n1 = normal3(p), n2 = normal3(p + 9), n3 = normal3(p + 18);
    const auto n12 = cross3(n1, n2);
    const auto w = dot3(n12, n3);
    const auto n31 = cross3(n3, n1);
    // Heights of the second and third plane above the base, which lies in the first.
    const auto h2 = dot3(from_to3(p, p + 9), n2), h3 = dot3(from_to3(p, p + 18), n3);
    const auto along = [&](std::size_t i) { return h2 * n31[i] + h3 * n12[i]; };
    return Located{std::array{p[0], p[1], p[2]}, std::array{along(0), along(1), along(2)}, w};
  }
};

/// a b t: the point a + t (b - a).
struct SegmentKind2 {
  static constexpr int dimension = 2, numbers = 5;
  template <class T>
  static constexpr auto at(const T* p) {
    const auto along = [&](std::size_t i) { return p[4] * (p[2 + i] - p[i]); };
    return Located{std::array{p[0], p[1]}, std::array{along(0), along(1)}, TagOne{}};
  }
};

struct SegmentKind3 {
  static constexpr int dimension = 3, numbers = 7;
  template <class T>
  static constexpr auto at(const T* p) {
    const auto along = [&](std::size_t i) { return p[6] * (p[3 + i] - p[i]); };
    return Located{std::array{p[0], p[1], p[2]}, std::array{along(0), along(1), along(2)}, TagOne{}};
  }
};

/// A point, the columns of a matrix and a translation: matrix * point + translation.
struct PosedKind2 {
  static constexpr int dimension = 2, numbers = 8;
  template <class T>
  static constexpr auto at(const T* p) {
    const auto along = [&](std::size_t i) { return p[2 + i] * p[0] + p[4 + i] * p[1]; };
    return Located{std::array{p[6], p[7]}, std::array{along(0), along(1)}, TagOne{}};
  }
};

struct PosedKind3 {
  static constexpr int dimension = 3, numbers = 15;
  template <class T>
  static constexpr auto at(const T* p) {
    const auto along = [&](std::size_t i) { return p[3 + i] * p[0] + p[6 + i] * p[1] + p[9 + i] * p[2]; };
    return Located{std::array{p[12], p[13], p[14]}, std::array{along(0), along(1), along(2)}, TagOne{}};
  }
};

/// Whether a kind has a weight, whose sign counts and which may be zero.
template <class Kind>
inline constexpr bool has_weight = !std::same_as<decltype(Kind::at(static_cast<const int*>(nullptr)).weight), TagOne>;

}  // namespace plumb::predicates
