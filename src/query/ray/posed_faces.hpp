// Hit normals: which faces and edges of a figure hold a point of its image under a pose, and which way do they face?
//
// Laws: (1) exact.  (2) The normal is what the cofactors of the pose's matrix make of that of query/ray/ray.hpp: of a flat
// face the cross product of the posed edges, out of a solid also where the pose mirrors.  Of the faces that hold the point
// it is that of the first one that faces the ray, else of the first; of a tetrahedron or box without an inside the first
// one's as it is, of another solid that a singular matrix flattens the first that is not zero, whichever face.  In the
// plane it is that of query/ray/ray2.hpp, of the posed edges.
// Cost: GMP; some 100 ns a number.
#pragma once

#include "query/convex/features.hpp"

namespace plumb::query {

/// What the cofactors of a matrix that is not singular make of a normal out of a solid.
Exact3 outward(const ExactMap& map, const Exact3& normal);

/// As query/ray/ray.hpp and ray2.hpp number them.
Feature hit_feature(const FigureView& figure, const ExactMap& map, const Exact3& point);

/// Of a figure with straight edges and flat faces, at a point of its image that is not inside; `along` is the ray's way.
Exact3 normal_at(const FigureView& figure, const ExactMap& map, const Exact3& point, const Exact3& along);

}  // namespace plumb::query
