// Where does a ray hit a triangle, under a convention?  With or without the ray's origin and the triangle's edges.
//
// Laws: those of degenerate/convention.hpp.  The parameter is that of the closed figures: where the figures without
// their boundaries meet at all, the closed ones have no earlier point in common than the others come near.
// Source: RTCD 5.3.6; Rockafellar, Convex Analysis, theorem 6.5 (the closure of an intersection of relative interiors).
// Cost: that of first_hit, and where it hits that of relate.
#pragma once

#include "plumb/degenerate/kind.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb::degenerate {

Answer first_hit_under(const Ray3& ray, const Triangle3& triangle, const Convention& convention);

}  // namespace plumb::degenerate
