// Where does a triangle name a vertex?
#pragma once

#include <cstdint>

#include "plumb/figure/basic/mesh.hpp"

namespace plumb::surface {

/// The first of the triangle's places that names the vertex, which it does.
inline std::uint32_t place_of(const TriangleMesh::Triangle& t, std::uint32_t vertex) {
  return t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
}

inline bool names_a_vertex_twice(const TriangleMesh::Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

}  // namespace plumb::surface
