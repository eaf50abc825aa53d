// What are functions of meshes asked?  Rays and points in every special position to the triangles of a mesh.
//
// A point lies on a corner, an edge, a face, straight beside one along an axis, at coordinates of corners, between two
// such, or anywhere; a ray goes to one of them, from such a place, along an edge, in a plane of triangles; a quarter of
// both is off by ulps.  Meshes are those of query/kinds/solids.hpp, exact, whatever their size and place.
// Laws: those of degenerate/kind.hpp; at most 256 points and 256 triangles.
// Source: RTCD 5.3.6, 5.4.3, 11.3.3.
// Cost: some microseconds a case.
#pragma once

#include "query/kinds/kind_generators.hpp"

namespace plumb::degenerate {

std::vector<Generator> ray_mesh_generators();
std::vector<Generator> polyhedron_generators();

/// A ray toward a second point, and 1 to 6 triangles of 3 to 8 points.
void arrange_ray_and_soup(Numbers& numbers, Entropy& entropy, const Fill& fill);
/// A point, and a tetrahedron, a double one, or an octahedron.
void arrange_point_and_solid(Numbers& numbers, Entropy& entropy, const Fill& fill);

}  // namespace plumb::degenerate
