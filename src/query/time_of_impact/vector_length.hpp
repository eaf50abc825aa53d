// Length of a vector: no less than it, of numbers that know how far off they are.
//
// Law: length_above(v) is at least as long as each vector that v may be; infinite where nothing is known.
// Source: RTCD 3.3.3, 11.2.
// Cost: a dot product and a root.
#pragma once

#include "arith/approximate.hpp"
#include "arith/running_error.hpp"
#include "plumb/arith/interval.hpp"
#include "query/body/vectors.hpp"

namespace plumb::query {

/// Rounded once, as if downward.
inline double rounded_up(double x) { return Interval::up(x, 1); }

inline double upper_of(const Running& x) { return x.upper(); }
inline double upper_of(const Approximate& x) { return rounded_up(x.magnitude + x.reach()); }

template <class T>
double length_above(const Vec3<T>& v) {
  return rounded_up(__builtin_sqrt(upper_of(dot(v, v))));
}

}  // namespace plumb::query
