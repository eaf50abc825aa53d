// Collision geometry: what collides in place of the mesh that is seen?  Its hull, a k-DOP around it, a copy of fewer
// bits: with what each is known to keep.
//
// Laws: (1) the hull and the k-DOP contain every vertex, exactly; so what misses them misses the mesh.  (2) Each vertex
// of the quantized copy is the lattice point nearest to the one it stands for, of two as near the one farther from
// zero: a multiple of 2^exponent in every coordinate.  (3) largest_displacement is the largest distance that a vertex
// moved, rounded up once; so every point of a face moved by at most that, and the mesh lies within that distance of the
// copy. (4) A vertex that is on the lattice stays; quantizing the copy again changes nothing.
// A mesh without vertices and bits outside of 1 to 52 throw InvalidShape, as does a triangle that names no vertex; NaN
// and infinities throw NonFinite.
// Source: RTCD 2.2.2, 4.1, 4.6.2, 11.5.1.
// Cost: that of the hull; the copy some 10 ns a vertex.  Bounded by n^3 signs of the hull, beside the copy.
#pragma once

#include "plumb/figure/basic/mesh.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/figure/k_dop/k_dop.hpp"

namespace plumb {

/// The hull of the mesh's vertices; a mesh in a plane has one of a polygon (Hull3::dimension says so).
struct HullProxy {
  std::vector<Point3> vertices;
  Hull3 hull;  // of `vertices`, all of which are its corners
};
HullProxy hull_proxy(const TriangleMesh& mesh);

/// Whatever directions: the least k-DOP of them that holds the mesh.
KDop3 k_dop_proxy(const TriangleMesh& mesh, int k = 26);

struct QuantizedProxy {
  TriangleMesh mesh;            // the same triangles; corners that fell together are not merged
  int exponent;                 // the lattice's step is 2^exponent
  double largest_displacement;  // of a vertex, rounded up
  std::uint32_t collapsed;      // triangles with two corners in one place that had none
};

/// On the finest lattice on which each coordinate is an integer of at most so many bits and a sign.
QuantizedProxy quantized_proxy(const TriangleMesh& mesh, int bits = 16);

}  // namespace plumb
