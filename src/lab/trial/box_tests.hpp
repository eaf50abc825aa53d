// How are boxes commonly tested in floating point?  Interval by interval, and the separating axes of oriented ones.
//
// Laws: none; they are on trial, and decide nothing of ours.  The oriented test takes axes for orthonormal, as all such
// code does.  An epsilon widens every box; of the oriented test it is also the usual remedy for parallel edges.
// Source: RTCD 4.2.1, 4.4.1; Gottschalk 1996.
// Cost: a few, and some two hundred operations.
#pragma once

#include <span>
#include <utility>

#include "lab/trial/vec.hpp"

namespace plumb::lab::trial {

/// Least and largest corner, where two of a box stand first among the numbers in any order.
inline void corners_in_order(std::span<double> numbers) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (numbers[k] > numbers[k + 3]) std::swap(numbers[k], numbers[k + 3]);
  }
}

/// Least and largest corner of either box.
struct BoxAgainstBox {
  template <class T>
  bool operator()(const std::array<T, 12>& q, T epsilon) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (q[k] > q[9 + k] + epsilon || q[6 + k] > q[3 + k] + epsilon) return false;
    }
    return true;
  }
};

/// Center, three axes and half sizes of either box.
struct OrientedAgainstOriented {
  static constexpr bool axes_are_no_lengths = true;

  template <class T>
  bool operator()(const std::array<T, 30>& q, T epsilon) const {
    const Vec<T> d = vec(q, 5) - vec(q, 0);
    const std::array<T, 3> p{q[12], q[13], q[14]}, h{q[27], q[28], q[29]};
    std::array<std::array<T, 3>, 3> r{}, s{};
    std::array<T, 3> t{};
    for (std::size_t i = 0; i < 3; ++i) {
      t[i] = dot(d, vec(q, 1 + i));
      for (std::size_t j = 0; j < 3; ++j) {
        r[i][j] = dot(vec(q, 1 + i), vec(q, 6 + j));
        s[i][j] = magnitude(r[i][j]) + epsilon;
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (magnitude(t[i]) > p[i] + h[0] * s[i][0] + h[1] * s[i][1] + h[2] * s[i][2]) return false;
    }
    for (std::size_t j = 0; j < 3; ++j) {
      const T far = magnitude(T(t[0] * r[0][j] + t[1] * r[1][j] + t[2] * r[2][j]));
      if (far > p[0] * s[0][j] + p[1] * s[1][j] + p[2] * s[2][j] + h[j]) return false;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3;
      for (std::size_t j = 0; j < 3; ++j) {
        const std::size_t j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        const T reach = p[i1] * s[i2][j] + p[i2] * s[i1][j] + h[j1] * s[i][j2] + h[j2] * s[i][j1];
        if (magnitude(T(t[i2] * r[i1][j] - t[i1] * r[i2][j])) > reach) return false;
      }
    }
    return true;
  }
};

}  // namespace plumb::lab::trial
