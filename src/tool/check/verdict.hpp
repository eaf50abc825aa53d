// What is wrong with this mesh, what does that mean for floating-point code, and what is to be done?
//
// Three sentences below that on its surface (surface.hpp), each from what check_mesh has found by then: the first from
// the mesh alone, the second from the answers of the inexact methods, the third from both.
// Laws: says nothing that the tables do not show; a share of a sample is said to be one; a ratio of times is told where
// it was measured on enough decisions alone.
// Source: RTCD 11.2, 12.1 to 12.4.
// Cost: none.
#pragma once

#include <string>

#include "tool/check/mesh.hpp"

namespace plumb::tool {

/// "67 repeated vertices; 12 triangles of zero area; ...".
std::string mesh_verdict(const MeshCheck& check);

/// "float32 takes 1.2% of the signs wrong (orient3d, insphere), double none; ...".
std::string float_verdict(const MeshCheck& check);

/// "weld the repeated vertices; ...; take signs exactly, ...".
std::string advice(const MeshCheck& check);

}  // namespace plumb::tool
