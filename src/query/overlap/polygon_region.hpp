// Polygon overlay: where do the chains of polygons in one plane lie to one another, exactly?  Even-odd sets in rational
// coordinates.
//
// A region is what its chains wind around an odd number of times; a point on a chain is boundary.
// Laws: exact; any chains will do.  Near an edge, away from ends and crossings, the region is on one side of it, on
// both or on none; where two regions overlap, some piece of an edge has both of them on one of its sides.
// Source: RTCD 5.4.1.
// Cost: GMP; linear for a point, quadratic for two regions.
#pragma once

#include <gmpxx.h>

#include <array>
#include <vector>

#include "plumb/figure/basic/relation.hpp"

namespace plumb::query {

using Exact2 = std::array<mpq_class, 2>;
inline Exact2 operator-(const Exact2& a, const Exact2& b) { return {mpq_class(a[0] - b[0]), mpq_class(a[1] - b[1])}; }
inline mpq_class cross(const Exact2& u, const Exact2& v) { return u[0] * v[1] - u[1] * v[0]; }
inline mpq_class dot(const Exact2& u, const Exact2& v) { return u[0] * v[0] + u[1] * v[1]; }

struct Region {
  std::vector<std::vector<Exact2>> chains;
};

Location locate(const Region& region, const Exact2& p);

/// Of the segment ab, which may be a point, by its relative interior.
Relation relate_segment(const Region& region, const Exact2& a, const Exact2& b);

/// Places t where the line through p along d, which is not zero, meets an edge or ends of an edge along it.
std::vector<mpq_class> crossings(const Region& region, const Exact2& p, const Exact2& d);

Relation relate(const Region& a, const Region& b);

/// Of finitely many points: the corners counterclockwise, without those on edges; one or two where they have no area.
std::vector<Exact2> convex_hull(std::vector<Exact2> points);

}  // namespace plumb::query
