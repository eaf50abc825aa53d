// What are the bytes of a mesh's file?  One function a format; write_mesh.cpp has checked the mesh before.
#pragma once

#include <string>
#include <string_view>

#include "plumb/figure/basic/mesh.hpp"
#include "plumb/surface/file/mesh_file.hpp"

namespace plumb::surface {

std::string print_obj(const PolygonMesh& mesh);
std::string print_off(const PolygonMesh& mesh);
std::string print_ascii_stl(const TriangleMesh& mesh);
std::string print_binary_stl(const TriangleMesh& mesh, std::string_view name);
std::string print_ply(const PolygonMesh& mesh, MeshEncoding encoding);

}  // namespace plumb::surface
