// Do four points that move linearly meet, as it is commonly asked in floating point?  The cubic of coplanarity solved,
// and conservative advancement.
//
// A question is four points at time 0 and the same at time 1: a vertex and a triangle, or two edges.
// Laws: none; they are on trial, and decide nothing of ours.  The cubic is solved by Newton's method between its
// turning points.  An epsilon is how far figures that meet may be apart, in space and in parameters, and how small the
// cubic may be at a turning point that counts as a root; without one a root is one where the sign changes.  Points that
// are in one plane the whole time are passed over, as all such code does.
// Source: RTCD 5.5; Provot 1997; Bridson, Fedkiw and Anderson 2002 (epsilons); Mirtich 1996 (conservative advancement).
// Cost: some hundred operations, and as many for each step of an advancement.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "lab/trial/distance_tests.hpp"
#include "tool/trial/contestant.hpp"

namespace plumb::lab::trial {

inline constexpr std::size_t motion_numbers = 24;

/// The first number whose half is lost beside 1; of numbers that keep pairs, 2^-104.
template <class T>
T unit_of() {
  static const T unit = [] {
    T u = 1;
    for (int i = 0; i < 112 && T(T(1) + u / 2) > 1; ++i) u = u / 2;
    return u;
  }();
  return unit;
}

template <bool VertexFace>
struct CubicContact {
  template <class T>
  bool operator()(const std::array<T, motion_numbers>& q, T epsilon) const {
    const std::array p{vec(q, 0), vec(q, 1), vec(q, 2), vec(q, 3)};
    const std::array v{vec(q, 4) - p[0], vec(q, 5) - p[1], vec(q, 6) - p[2], vec(q, 7) - p[3]};
    const Vec<T> x1 = p[1] - p[0], x2 = p[2] - p[0], x3 = p[3] - p[0];
    const Vec<T> v1 = v[1] - v[0], v2 = v[2] - v[0], v3 = v[3] - v[0];
    const Cubic<T> cubic{
        {dot(x1, cross(x2, x3)), T(dot(v1, cross(x2, x3)) + dot(x1, cross(v2, x3)) + dot(x1, cross(x2, v3))),
         T(dot(x1, cross(v2, v3)) + dot(v1, cross(x2, v3)) + dot(v1, cross(v2, x3))), dot(v1, cross(v2, v3))}};
    return cubic.any_root(epsilon, [&](const T& t) {
      const std::array at{p[0] + v[0] * t, p[1] + v[1] * t, p[2] + v[2] * t, p[3] + v[3] * t};
      return VertexFace ? touches(at, epsilon) : crosses(at, epsilon);
    });
  }

 private:
  template <class T>
  struct Cubic {
    std::array<T, 4> c;

    [[nodiscard]] T value(const T& t) const { return c[0] + t * (c[1] + t * (c[2] + t * c[3])); }

    /// Is there one in [0, 1] that `take` accepts?
    template <class Take>
    [[nodiscard]] bool any_root(const T& epsilon, Take take) const {
      std::array<T, 4> ends{T(0), T(0), T(0), T(1)};
      std::size_t last = 0;
      const T radicand = c[2] * c[2] - 3 * c[3] * c[1];
      if (radicand > 0) {
        const T root = square_root(radicand), q = c[2] < 0 ? T(root - c[2]) : T(-(root + c[2]));
        T first = q / (3 * c[3]), second = c[1] / q;
        if (first > second) std::swap(first, second);
        for (const T& t : {first, second}) {
          if (t > 0 && t < 1) ends[++last] = t;
        }
      }
      ends[++last] = T(1);
      for (std::size_t i = 0; i < last; ++i) {
        const T v = value(ends[i]), w = value(ends[i + 1]);
        const bool meets_zero = (v <= 0 && w >= 0) || (v >= 0 && w <= 0);
        if (meets_zero && take(between(ends[i], ends[i + 1], v < 0))) return true;
        if (i > 0 && magnitude(v) <= epsilon && take(ends[i])) return true;
      }
      return false;
    }

    [[nodiscard]] T between(T from, T to, bool rises) const {
      T t = (from + to) / 2;
      for (int i = 0; i < 64; ++i) {
        const T v = value(t), slope = c[1] + t * (2 * c[2] + t * 3 * c[3]);
        ((v < 0) == rises ? from : to) = t;
        T next = t - v / slope;
        if (!(next > from && next < to)) next = (from + to) / 2;
        if (magnitude(T(next - t)) <= 2 * unit_of<T>()) return next;
        t = next;
      }
      return t;
    }
  };

  /// Is the height over a plane of this normal within the epsilon?  Without one that is known from the root.
  template <class T>
  static bool near(const T& height, const T& square, const T& epsilon) {
    return !(epsilon > 0) || magnitude(height) <= epsilon * square_root(square);
  }

  template <class T>
  static bool touches(const std::array<Vec<T>, 4>& p, const T& epsilon) {
    const Vec<T> n = cross(p[2] - p[1], p[3] - p[1]);
    const T square = dot(n, n);
    if (!(square > 0)) return false;
    const T u = dot(cross(p[2] - p[0], p[3] - p[0]), n), v = dot(cross(p[3] - p[0], p[1] - p[0]), n);
    const T least = -epsilon * square;
    return u >= least && v >= least && square - u - v >= least && near(dot(p[0] - p[1], n), square, epsilon);
  }

  template <class T>
  static bool crosses(const std::array<Vec<T>, 4>& p, const T& epsilon) {
    const Vec<T> e = p[1] - p[0], f = p[3] - p[2], w = p[2] - p[0], n = cross(e, f);
    const T square = dot(n, n);
    if (!(square > 0)) return false;
    const T u = dot(cross(w, f), n), v = dot(cross(w, e), n), least = -epsilon * square;
    return u >= least && square - u >= least && v >= least && square - v >= least && near(dot(w, n), square, epsilon);
  }
};

/// Time goes on by what the distance and the largest speed allow, until the distance is within the epsilon; unsure
/// where that does not happen soon.
template <bool VertexFace>
struct ConservativeAdvancement {
  static constexpr int most_steps = 256;

  template <class T>
  double operator()(const std::array<T, motion_numbers>& q, T epsilon) const {
    std::array<Vec<T>, 4> p{}, v{};
    std::array<T, 4> speed{};
    for (std::size_t i = 0; i < 4; ++i) {
      p[i] = vec(q, i);
      v[i] = vec(q, 4 + i) - p[i];
      speed[i] = square_root(dot(v[i], v[i]));
    }
    constexpr std::size_t first = VertexFace ? 1 : 2;  // of the second figure
    const T closing =
        *std::max_element(&speed[0], &speed[first]) + *std::max_element(&speed[first], speed.data() + speed.size());
    T t = 0;
    for (int i = 0; i < most_steps; ++i) {
      std::array<T, 12> at{};
      for (std::size_t k = 0; k < 4; ++k) {
        const Vec<T> x = p[k] + v[k] * t;
        at[3 * k] = x.x;
        at[3 * k + 1] = x.y;
        at[3 * k + 2] = x.z;
      }
      const T apart = VertexFace ? PointTriangleDistance{}(at, T(0)) : SegmentSegmentDistance{}(at, T(0));
      if (!(apart > epsilon)) return apart == apart ? 1 : unsure;
      t += apart / closing;
      if (t > 1) return 0;
    }
    return unsure;
  }
};

}  // namespace plumb::lab::trial
