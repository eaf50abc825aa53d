// How is libccd asked?  Convex sets by their corners, with the settings of its documentation.
//
// Laws: none; it is on trial.
// Source: libccd 2.1's ccd.h and README.
// Cost: libccd's.
#pragma once

#include <ccd/ccd.h>

#include <array>
#include <cstddef>

namespace plumb::bench::libccd {

/// The hull of points; their mean is the center.
template <class Points>
struct Convex {
  Points points;  // of ccd_vec3_t

  static void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* out) {
    const Points& points = static_cast<const Convex*>(object)->points;
    const ccd_vec3_t* best = &points[0];
    ccd_real_t most = ccdVec3Dot(direction, best);
    for (const ccd_vec3_t& p : points) {
      const ccd_real_t far = ccdVec3Dot(direction, &p);
      if (far > most) {
        most = far;
        best = &p;
      }
    }
    ccdVec3Copy(out, best);
  }
  static void center(const void* object, ccd_vec3_t* out) {
    const Points& points = static_cast<const Convex*>(object)->points;
    ccdVec3Set(out, 0, 0, 0);
    for (const ccd_vec3_t& p : points) ccdVec3Add(out, &p);
    ccdVec3Scale(out, 1 / static_cast<ccd_real_t>(points.size()));
  }
};

template <std::size_t n>
using Corners = Convex<std::array<ccd_vec3_t, n>>;

template <std::size_t n>
Corners<n> corners(const double* x) {
  Corners<n> c;
  for (std::size_t i = 0; i < n; ++i) ccdVec3Set(&c.points[i], x[3 * i], x[3 * i + 1], x[3 * i + 2]);
  return c;
}

/// From center, axes and half sizes.
inline Corners<8> box(const double* x) {
  Corners<8> c;
  for (unsigned corner = 0; corner < 8; ++corner) {
    ccd_vec3_t& at = c.points[corner];
    ccdVec3Set(&at, x[0], x[1], x[2]);
    for (unsigned axis = 0; axis < 3; ++axis) {
      const double half = (corner >> axis & 1U) != 0 ? x[12 + axis] : -x[12 + axis];
      for (unsigned k = 0; k < 3; ++k) at.v[k] += half * x[3 + 3 * axis + k];
    }
  }
  return c;
}

using Function = int(const void*, const void*, const ccd_t*);

template <class A, class B>
bool meet(Function* function, const A& a, const B& b) {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = A::support;
  ccd.support2 = B::support;
  ccd.center1 = A::center;
  ccd.center2 = B::center;
  ccd.max_iterations = 100;
  return function(&a, &b, &ccd) != 0;
}

}  // namespace plumb::bench::libccd
