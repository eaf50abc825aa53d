// How are triangles commonly tested in floating point?  Moller and Trumbore's ray, Moller's intervals.
//
// Laws: none; they are on trial, and decide nothing of ours.  An epsilon widens: determinants and distances to planes
// within it count as zero, parameters may leave their range by it.
// Source: Moller and Trumbore 1997, Moller 1997, RTCD 5.3.4, 5.3.6, 5.2.10.
// Cost: tens of operations.
#pragma once

#include <utility>

#include "lab/trial/vec.hpp"

namespace plumb::lab::trial {

/// Origin (or first end), direction (or second end), and the corners of a triangle.
template <bool Segment>
struct RayAgainstTriangle {
  template <class T>
  bool operator()(const std::array<T, 15>& q, T epsilon) const {
    const Vec<T> o = vec(q, 0), a = vec(q, 2), d = Segment ? vec(q, 1) - o : vec(q, 1);
    const Vec<T> e = vec(q, 3) - a, f = vec(q, 4) - a, p = cross(d, f);
    const T det = dot(e, p);
    if (magnitude(det) <= epsilon) return false;
    const T inverse = 1 / det;
    const Vec<T> s = o - a;
    const T u = dot(s, p) * inverse;
    if (u < -epsilon || u > 1 + epsilon) return false;
    const Vec<T> r = cross(s, e);
    const T v = dot(d, r) * inverse;
    if (v < -epsilon || u + v > 1 + epsilon) return false;
    const T t = dot(f, r) * inverse;
    return t >= -epsilon && (!Segment || t <= 1 + epsilon);
  }
};

/// Two triangles by their intervals on the line of their planes; coplanar ones projected along an axis.
struct TriangleAgainstTriangle {
  template <class T>
  bool operator()(const std::array<T, 18>& q, T epsilon) const {
    const std::array a{vec(q, 0), vec(q, 1), vec(q, 2)}, b{vec(q, 3), vec(q, 4), vec(q, 5)};
    const Vec<T> n = cross(a[1] - a[0], a[2] - a[0]), m = cross(b[1] - b[0], b[2] - b[0]);
    const std::array u = heights(n, a[0], b, epsilon), v = heights(m, b[0], a, epsilon);
    if (u[0] * u[1] > 0 && u[0] * u[2] > 0) return false;
    if (v[0] * v[1] > 0 && v[0] * v[2] > 0) return false;
    const Vec<T> d = cross(n, m);
    const T x = magnitude(d.x), y = magnitude(d.y), z = magnitude(d.z);
    const auto at = [&](const Vec<T>& p) { return x >= y && x >= z ? p.x : y >= z ? p.y : p.z; };
    T low_a{}, high_a{}, low_b{}, high_b{};
    if (!interval(at(a[0]), at(a[1]), at(a[2]), v, low_a, high_a) ||
        !interval(at(b[0]), at(b[1]), at(b[2]), u, low_b, high_b))
      return coplanar(n, a, b, epsilon);
    return high_a >= low_b - epsilon && high_b >= low_a - epsilon;
  }

 private:
  template <class T>
  using Corners = std::array<Vec<T>, 3>;

  template <class T>
  static std::array<T, 3> heights(const Vec<T>& n, const Vec<T>& on, const Corners<T>& p, T epsilon) {
    std::array<T, 3> h{dot(n, p[0] - on), dot(n, p[1] - on), dot(n, p[2] - on)};
    for (T& x : h) x = magnitude(x) <= epsilon ? T(0) : x;
    return h;
  }

  /// Where the plane cuts the corners' interval, the corner alone on its side being `one`.
  template <class T>
  static bool interval(const T& p0, const T& p1, const T& p2, const std::array<T, 3>& h, T& low, T& high) {
    const auto cut = [&](const T& one, const T& p, const T& r, const T& at_one, const T& at_p, const T& at_r) {
      low = one + (p - one) * at_one / (at_one - at_p);
      high = one + (r - one) * at_one / (at_one - at_r);
      if (low > high) std::swap(low, high);
      return true;
    };
    if (h[0] * h[1] > 0) return cut(p2, p0, p1, h[2], h[0], h[1]);
    if (h[0] * h[2] > 0) return cut(p1, p0, p2, h[1], h[0], h[2]);
    if (h[1] * h[2] > 0 || h[0] != 0) return cut(p0, p1, p2, h[0], h[1], h[2]);
    if (h[1] != 0) return cut(p1, p0, p2, h[1], h[0], h[2]);
    if (h[2] != 0) return cut(p2, p0, p1, h[2], h[0], h[1]);
    return false;
  }

  template <class T>
  static bool coplanar(const Vec<T>& n, const Corners<T>& a, const Corners<T>& b, T epsilon) {
    const T x = magnitude(n.x), y = magnitude(n.y), z = magnitude(n.z);
    const auto flat = [&](const Vec<T>& p) {
      return x > y && x > z ? std::array{p.y, p.z} : y > z ? std::array{p.z, p.x} : std::array{p.x, p.y};
    };
    const auto turn = [&](const Vec<T>& p, const Vec<T>& r, const Vec<T>& s) {
      const auto f = flat(p), g = flat(r), h = flat(s);
      return T((f[0] - h[0]) * (g[1] - h[1]) - (f[1] - h[1]) * (g[0] - h[0]));
    };
    const auto separates = [&](const Corners<T>& of, const Corners<T>& other) {
      const T way = turn(of[0], of[1], of[2]) < 0 ? T(-1) : T(1);
      for (std::size_t i = 0; i < 3; ++i) {
        const auto beyond = [&](const Vec<T>& p) { return turn(of[i], of[(i + 1) % 3], p) * way < -epsilon; };
        if (beyond(other[0]) && beyond(other[1]) && beyond(other[2])) return true;
      }
      return false;
    };
    return !separates(a, b) && !separates(b, a);
  }
};

}  // namespace plumb::lab::trial
