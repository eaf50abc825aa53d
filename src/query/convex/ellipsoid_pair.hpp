// Do two ellipsoids meet?  Images of the unit ball under maps that have inverses, decided by roots that are counted.
//
// With quadrics negative inside, x^T A x and x^T B x, the polynomial det(t A + B) of degree four has two different
// positive roots exactly where the ellipsoids are apart, and one, twice, where they touch from outside.
// Laws: exact; symmetric; that of the interiors, else of the closed sets.
// Source: Wang, Wang and Kim, "An algebraic condition for the separation of two ellipsoids", 2001; RTCD 5.2.
// Cost: GMP; some 30 us.  Bounded by a fixed number of operations on integers of some hundred times the exponents' span.
#pragma once

#include "plumb/figure/basic/relation.hpp"
#include "query/convex/exact_map.hpp"

namespace plumb::query {

Relation relate_ellipsoids(const ExactMap& a, const ExactMap& b);

}  // namespace plumb::query
