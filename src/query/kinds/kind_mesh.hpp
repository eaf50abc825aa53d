// What do a ray and a point have to do with the triangles of a case?  The exact answers about meshes.
//
// Laws: those of query/ray/ray.hpp, triangle by triangle, and those of query/ray/parity.hpp.
// Source: RTCD 5.3.6, 5.4.3.
// Cost: that of each triangle.
#pragma once

#include "plumb/degenerate/kind.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb::degenerate {

Answer exact_mesh_hit(std::span<const double> numbers, const Convention& convention);
Location locate_in_mesh(std::span<const double> numbers);

}  // namespace plumb::degenerate
