// How is the distance of convex sets commonly computed in floating point?  By simplices in the set of differences.
//
// Laws: none; they are on trial, and decide nothing of ours.  The search stops when a step no longer gains more than an
// epsilon, or after as many steps as no honest search takes.
// Source: Gilbert, Johnson and Keerthi 1988, RTCD 9.5.
// Cost: some hundred operations a step.
#pragma once

#include <algorithm>
#include <array>

#include "tool/trial/vec.hpp"

namespace plumb::tool::trial {

inline constexpr std::size_t set_points = 4;

/// The points of one set, then those of the other.
struct ConvexDistance {
  template <class T>
  double operator()(const std::array<T, 6 * set_points>& q, T epsilon) const {
    Simplex<T> simplex{{vec(q, 0) - vec(q, set_points)}, 1};
    Vec<T> nearest = simplex.corners[0];
    for (int step = 0; step < 64; ++step) {
      const T square = dot(nearest, nearest);
      if (square <= epsilon) return 0;
      const Vec<T> w = farthest(q, 0, nearest * T(-1)) - farthest(q, set_points, nearest);
      if (square - dot(nearest, w) <= epsilon * square) break;
      const auto same = [&](const Vec<T>& v) { return v.x == w.x && v.y == w.y && v.z == w.z; };
      if (std::any_of(simplex.corners.begin(), simplex.corners.begin() + simplex.count, same)) break;
      simplex.corners[static_cast<std::size_t>(simplex.count++)] = w;
      const Vec<T> next = reduce(simplex);
      if (simplex.count == 4) return 0;  // around the origin
      if (!(dot(next, next) < square)) break;
      nearest = next;
    }
    return root_as_double(dot(nearest, nearest));
  }

 private:
  template <class T>
  struct Simplex {
    std::array<Vec<T>, 4> corners;
    int count;
  };

  template <class T>
  static Vec<T> farthest(const std::array<T, 6 * set_points>& q, std::size_t first, const Vec<T>& direction) {
    Vec<T> best = vec(q, first);
    for (std::size_t i = 1; i < set_points; ++i) {
      const Vec<T> p = vec(q, first + i);
      if (dot(p, direction) > dot(best, direction)) best = p;
    }
    return best;
  }

  /// The point nearest to the origin, and the simplex without the corners that it does not need: of all parts whose
  /// plane's nearest point lies inside, the one that is nearest.
  template <class T>
  static Vec<T> reduce(Simplex<T>& simplex) {
    Simplex<T> best{};
    Vec<T> nearest{};
    for (unsigned part = 1; part < (1U << simplex.count); ++part) {
      Simplex<T> s{};
      for (int i = 0; i < simplex.count; ++i) {
        if ((part >> i & 1U) != 0)
          s.corners[static_cast<std::size_t>(s.count++)] = simplex.corners[static_cast<std::size_t>(i)];
      }
      Vec<T> at{};
      if (!inside(s, at)) continue;
      if (best.count != 0 && !(dot(at, at) < dot(nearest, nearest))) continue;
      best = s;
      nearest = at;
    }
    simplex = best;
    return nearest;
  }

  /// Is the point of the corners' plane that is nearest to the origin among them?  By Cramer's rule.
  template <class T>
  static bool inside(const Simplex<T>& s, Vec<T>& at) {
    const auto& [a, b, c, d] = s.corners;
    if (s.count == 1) {
      at = a;
      return true;
    }
    const Vec<T> u = b - a;
    if (s.count == 2) {
      const T whole = dot(u, u), part = -dot(a, u);
      if (!(whole > 0) || part < 0 || part > whole) return false;
      at = a + u * T(part / whole);
      return true;
    }
    const Vec<T> v = c - a;
    if (s.count == 3) {
      const Vec<T> n = cross(u, v);
      const T whole = dot(n, n), of_b = dot(cross(v, a), n), of_c = dot(cross(a, u), n);
      if (!(whole > 0) || of_b < 0 || of_c < 0 || of_b + of_c > whole) return false;
      at = n * T(dot(a, n) / whole);
      return true;
    }
    const Vec<T> w = d - a;
    const T whole = dot(u, cross(v, w)), of_b = -dot(a, cross(v, w)), of_c = -dot(u, cross(a, w)),
            of_d = -dot(u, cross(v, a)), of_a = whole - of_b - of_c - of_d;
    at = {T(0), T(0), T(0)};
    if (whole > 0) return of_a >= 0 && of_b >= 0 && of_c >= 0 && of_d >= 0;
    return whole < 0 && of_a <= 0 && of_b <= 0 && of_c <= 0 && of_d <= 0;
  }
};

}  // namespace plumb::tool::trial
