// Which figures does a question hold, whose numbers stand in a row?
//
// Source: none.
// Cost: none.
#pragma once

#include "plumb/arith/point.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb::lab::stability {

inline Point3 point_at(const double* x) { return {x[0], x[1], x[2]}; }
inline Triangle3 triangle_at(const double* x) { return {point_at(x), point_at(x + 3), point_at(x + 6)}; }
inline Ray3 ray_at(const double* x) { return {point_at(x), {x[3], x[4], x[5]}}; }

}  // namespace plumb::lab::stability
