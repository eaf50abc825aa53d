// How are distances commonly computed in floating point?  The parameter of a point along a segment clamped, and those of
// two lines, coordinates outside of a box squared, the region of a triangle by six dot products.
//
// Laws: none; they are on trial, and decide nothing of ours.  An epsilon makes short segments points and parallel lines
// of nearly parallel ones.
// Source: RTCD 5.1.2, 5.1.3, 5.1.5, 5.1.9.
// Cost: tens of operations and a root.
#pragma once

#include "lab/trial/vec.hpp"

namespace plumb::lab::trial {

/// A point and the ends of a segment.
struct PointSegmentDistance {
  template <class T>
  double operator()(const std::array<T, 9>& q, T epsilon) const {
    const Vec<T> p = vec(q, 0), a = vec(q, 1), ab = vec(q, 2) - a;
    const T whole = dot(ab, ab);
    const Vec<T> d = p - (a + ab * (whole > epsilon ? clamped(T(dot(p - a, ab) / whole)) : T(0)));
    return root_as_double(dot(d, d));
  }
};

/// A point, and the least and largest corner of a box.
struct PointBoxDistance {
  template <class T>
  double operator()(const std::array<T, 9>& q, T epsilon) const {
    T sum(0);
    for (std::size_t k = 0; k < 3; ++k) {
      const T below = q[3 + k] - q[k], above = q[k] - q[6 + k];
      if (below > epsilon) sum = sum + below * below;
      if (above > epsilon) sum = sum + above * above;
    }
    return root_as_double(sum);
  }
};

/// A point and the corners of a triangle.
struct PointTriangleDistance {
  template <class T>
  double operator()(const std::array<T, 12>& q, T epsilon) const {
    const Vec<T> p = vec(q, 0), d = p - nearest(p, vec(q, 1), vec(q, 2), vec(q, 3), epsilon);
    return root_as_double(dot(d, d));
  }

 private:
  template <class T>
  static Vec<T> nearest(const Vec<T>& p, const Vec<T>& a, const Vec<T>& b, const Vec<T>& c, T epsilon) {
    const Vec<T> ab = b - a, ac = c - a, ap = p - a;
    const T d1 = dot(ab, ap), d2 = dot(ac, ap);
    if (d1 <= epsilon && d2 <= epsilon) return a;
    const Vec<T> bp = p - b;
    const T d3 = dot(ab, bp), d4 = dot(ac, bp);
    if (d3 >= -epsilon && d4 <= d3 + epsilon) return b;
    const T vc = d1 * d4 - d3 * d2;
    if (vc <= epsilon && d1 >= 0 && d3 <= 0) return a + ab * T(d1 / (d1 - d3));
    const Vec<T> cp = p - c;
    const T d5 = dot(ab, cp), d6 = dot(ac, cp);
    if (d6 >= -epsilon && d5 <= d6 + epsilon) return c;
    const T vb = d5 * d2 - d1 * d6;
    if (vb <= epsilon && d2 >= 0 && d6 <= 0) return a + ac * T(d2 / (d2 - d6));
    const T va = d3 * d6 - d5 * d4;
    if (va <= epsilon && d4 - d3 >= 0 && d5 - d6 >= 0) return b + (c - b) * T((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    const T scale = 1 / (va + vb + vc);
    return a + ab * T(vb * scale) + ac * T(vc * scale);
  }
};

/// The ends of two segments.
struct SegmentSegmentDistance {
  template <class T>
  double operator()(const std::array<T, 12>& q, T epsilon) const {
    const Vec<T> a = vec(q, 0), c = vec(q, 2), d1 = vec(q, 1) - a, d2 = vec(q, 3) - c, r = a - c;
    const T aa = dot(d1, d1), ee = dot(d2, d2), f = dot(d2, r);
    T s{}, t{};
    if (aa > epsilon && ee > epsilon) {
      const T b = dot(d1, d2), cc = dot(d1, r), denominator = aa * ee - b * b;
      s = denominator > epsilon * aa * ee ? clamped(T((b * f - cc * ee) / denominator)) : T(0);
      t = (b * s + f) / ee;
      if (t < 0) {
        t = 0;
        s = clamped(T(-cc / aa));
      } else if (t > 1) {
        t = 1;
        s = clamped(T((b - cc) / aa));
      }
    } else if (aa > epsilon) {
      s = clamped(T(-dot(d1, r) / aa));
    } else if (ee > epsilon) {
      t = clamped(T(f / ee));
    }
    const Vec<T> w = (a + d1 * s) - (c + d2 * t);
    return root_as_double(dot(w, w));
  }
};

}  // namespace plumb::lab::trial
