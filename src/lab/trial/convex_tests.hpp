// GJK in floating point: how is the distance of convex sets commonly computed, and whether they meet?  By simplices in the
// set of differences.
//
// Laws: none; they are on trial, and decide nothing of ours.  The search stops when a step no longer gains more than an
// epsilon, or after as many steps as no honest search takes: `stuck` says that it did.
// Source: Gilbert, Johnson and Keerthi 1988, RTCD 9.5.
// Cost: some hundred operations a step.
#pragma once

#include <algorithm>
#include <array>

#include "lab/trial/vec.hpp"

namespace plumb::lab::trial {

/// Two sets of n points each: the points of one, then those of the other.
template <std::size_t n>
class ConvexSearch {
 public:
  template <class T>
  struct Found {
    bool meet, stuck;  // stuck: no step gained, or too many were taken
    T square;          // of the distance, where they do not meet
  };

  template <class T>
  Found<T> operator()(const std::array<T, 6 * n>& q, T epsilon) const {
    Simplex<T> simplex{{vec(q, 0) - vec(q, n)}, 1};
    Vec<T> nearest = simplex.corners[0];
    T square = dot(nearest, nearest);
    for (int step = 0; step < 64; ++step) {
      if (square <= epsilon) return {true, false, square};
      const Vec<T> w = farthest(q, 0, nearest * T(-1)) - farthest(q, n, nearest);
      if (square - dot(nearest, w) <= epsilon * square) return {false, false, square};
      const auto same = [&](const Vec<T>& v) { return v.x == w.x && v.y == w.y && v.z == w.z; };
      if (std::any_of(simplex.corners.begin(), simplex.corners.begin() + simplex.count, same))
        return {false, false, square};
      simplex.corners[static_cast<std::size_t>(simplex.count++)] = w;
      const Vec<T> next = reduce(simplex);
      if (simplex.count == 4) return {true, false, square};  // around the origin
      const T nearer = dot(next, next);
      if (!(nearer < square)) break;
      nearest = next, square = nearer;
    }
    return {false, true, square};
  }

 private:
  template <class T>
  struct Simplex {
    std::array<Vec<T>, 4> corners;
    int count;
  };

  template <class T>
  static Vec<T> farthest(const std::array<T, 6 * n>& q, std::size_t first, const Vec<T>& direction) {
    Vec<T> best = vec(q, first);
    for (std::size_t i = 1; i < n; ++i) {
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
      const Vec<T> normal = cross(u, v);
      const T whole = dot(normal, normal), of_b = dot(cross(v, a), normal), of_c = dot(cross(a, u), normal);
      if (!(whole > 0) || of_b < 0 || of_c < 0 || of_b + of_c > whole) return false;
      at = normal * T(dot(a, normal) / whole);
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

struct ConvexDistance {
  template <class T, std::size_t N>
  double operator()(const std::array<T, N>& q, T epsilon) const {
    const auto found = ConvexSearch<N / 6>{}(q, epsilon);
    return found.meet ? 0 : root_as_double(found.square);
  }
};

struct ConvexMeeting {
  template <class T, std::size_t N>
  bool operator()(const std::array<T, N>& q, T epsilon) const {
    return ConvexSearch<N / 6>{}(q, epsilon).meet;
  }
};

}  // namespace plumb::lab::trial
